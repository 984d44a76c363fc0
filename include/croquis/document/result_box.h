// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <type_traits>
#include <typeinfo>
#include <utility>

namespace croquis {

/// What an operation found, as a value of the operation's own type: what programs read where people read its report.
/// Shared and immutable: passing one on copies a pointer.
class ResultBox {
 public:
  /// Of nothing.
  ResultBox() = default;

  /// @tparam Result plain values; byte_size(const Result&) beside it gives what they take, without what they share
  ///         with the operation's inputs
  template <class Result>
  requires(!std::is_same_v<Result, ResultBox>) ResultBox(Result result)
      : bytes_(byte_size(result)),
        content_(std::make_shared<const Result>(std::move(result))),
        type_(&typeid(Result)) {}

  /// The result when it is of that type, else null.
  template <class Result>
  const Result* get() const {
    return type_ != nullptr && *type_ == typeid(Result) ? static_cast<const Result*>(content_.get()) : nullptr;
  }

  /// What byte caps count.
  std::size_t bytes() const { return bytes_; }

 private:
  std::size_t bytes_ = 0;
  std::shared_ptr<const void> content_;
  const std::type_info* type_ = nullptr;
};

}  // namespace croquis

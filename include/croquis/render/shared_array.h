// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace croquis::render {

/// An array that never changes and that copies share: items of equal connectivity hold one, not two.
template <typename Value>
class SharedArray {
 public:
  SharedArray() = default;
  SharedArray(std::vector<Value> values)  // NOLINT(google-explicit-constructor): so that it is filled like a vector
      : values_(std::make_shared<const std::vector<Value>>(std::move(values))) {}

  std::size_t size() const { return values_ ? values_->size() : 0; }
  bool empty() const { return size() == 0; }
  const Value* data() const { return values_ ? values_->data() : nullptr; }
  const Value* begin() const { return data(); }
  const Value* end() const { return data() + size(); }
  const Value& operator[](std::size_t i) const { return (*values_)[i]; }

  /// The array itself, which lives as long as it is needed; null for one never filled.
  const std::shared_ptr<const std::vector<Value>>& shared() const { return values_; }

  friend bool operator==(const SharedArray& a, const SharedArray& b) {
    return a.values_ == b.values_ || (a.size() == b.size() && (a.empty() || *a.values_ == *b.values_));
  }

 private:
  std::shared_ptr<const std::vector<Value>> values_;
};

}  // namespace croquis::render

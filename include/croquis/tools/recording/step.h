// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <concepts>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "croquis/tools/recording/field_writer.h"
#include "croquis/tools/recording/fields.h"

namespace croquis::recorded {

struct StepKind;

/// A small struct that says what was done; its kind says how it stands in a line.
template <typename T>
concept StepValue = requires {
  { T::step_kind() } -> std::same_as<const StepKind&>;
};

/// One recorded step of any kind. Copies share the struct, which never changes.
class Step {
 public:
  template <StepValue T>
  Step(T value)  // NOLINT(google-explicit-constructor): a step is what its struct says
      : kind_(&T::step_kind()), value_(std::make_shared<const T>(std::move(value))) {}

  const StepKind& kind() const { return *kind_; }

  /// The struct, or null when this step is of another kind.
  template <StepValue T>
  const T* as() const {
    return kind_ == &T::step_kind() ? static_cast<const T*>(value_.get()) : nullptr;
  }

 private:
  const StepKind* kind_;
  std::shared_ptr<const void> value_;
};

/// How steps of one struct are read and written.
struct StepKind {
  std::vector<std::string> verbs;  ///< of "do"
  std::string mark;                ///< a field by which kinds that share a verb are told apart; empty: every other line
  std::function<Step(Fields&)> read;                     ///< @throws Mistake
  std::function<void(const Step&, FieldWriter&)> write;  ///< writes the verb too when there are several
};

/// The kind of a struct with these functions, for its step_kind().
template <typename T>
StepKind make_step_kind(std::vector<std::string> verbs, T (*read)(Fields&), void (*write)(const T&, FieldWriter&),
                        std::string mark = {}) {
  return {std::move(verbs), std::move(mark), read,
          [write](const Step& step, FieldWriter& writer) { write(*step.as<T>(), writer); }};
}

}  // namespace croquis::recorded

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "croquis/tools/recording/fields.h"

namespace croquis::recorded {

/// A small struct that says what was done, and how it stands in a line:
///
///     static constexpr std::array verbs{"move"};  // of "do"; with several, `describe` has the field as well
///     void describe(Fields& fields);              // lists the fields
///     static constexpr const char* mark = "from";  // a field by which kinds that share a verb differ, if any
template <typename T>
concept StepValue = requires(T step, Fields& fields) {
  T::verbs;
  step.describe(fields);
};

struct StepKind;

/// The kind of all steps of one struct.
template <StepValue T>
const StepKind& step_kind();

/// One recorded step of any kind. Copies share the struct, which never changes.
class Step {
 public:
  template <StepValue T>
  Step(T value)  // NOLINT(google-explicit-constructor): a step is what its struct says
      : kind_(&step_kind<T>()), value_(std::make_shared<const T>(std::move(value))) {}

  const StepKind& kind() const { return *kind_; }

  /// The struct, or null when this step is of another kind.
  template <StepValue T>
  const T* as() const {
    return kind_ == &step_kind<T>() ? static_cast<const T*>(value_.get()) : nullptr;
  }

 private:
  const StepKind* kind_;
  std::shared_ptr<const void> value_;
};

/// How steps of one struct are read and written.
struct StepKind {
  std::vector<std::string> verbs;
  std::string mark;                                 ///< empty: every other line with such a verb
  std::function<Step(Fields&)> read;                ///< @throws Mistake
  std::function<void(const Step&, Fields&)> write;  ///< without the verb where there is one
};

template <StepValue T>
const StepKind& step_kind() {
  static const StepKind kind = [] {
    StepKind made{{T::verbs.begin(), T::verbs.end()}, {}, {}, {}};
    if constexpr (requires { T::mark; }) made.mark = T::mark;
    made.read = [](Fields& fields) {
      T step;
      step.describe(fields);
      return Step(std::move(step));
    };
    made.write = [](const Step& step, Fields& fields) { T(*step.as<T>()).describe(fields); };
    return made;
  }();
  return kind;
}

}  // namespace croquis::recorded

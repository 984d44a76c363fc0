// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "croquis/base/parameter.h"
#include "croquis/geometry/vector.h"

namespace croquis::recorded {

class Vocabulary;

/// Instead of a place in a view: a place of the model, seen in the view named.
using ModelPlace = std::optional<Vec3>;

/// What is wrong with a line, as a sentence without its end; becomes a finding with the line's number.
struct Mistake {
  std::string sentence;
};

/// The fields of one recorded line, read by name and type. A field that nobody asked for is a mistake.
///
/// Every function that takes a name throws Mistake when the field is missing or isn't what is asked for. Numbers are
/// finite.
class Fields {
 public:
  /// @param line       one JSON object
  /// @param vocabulary that the line is read with; outlives this
  /// @throws Mistake
  Fields(std::string_view line, const Vocabulary& vocabulary);
  ~Fields();
  Fields(const Fields&) = delete;
  Fields& operator=(const Fields&) = delete;

  const Vocabulary& vocabulary() const { return vocabulary_; }
  std::string verb() { return text("do"); }

  bool has(const std::string& name);
  std::string text(const std::string& name);
  std::string text(const std::string& name, const std::string& otherwise);  ///< without the field: `otherwise`
  std::string one_of(const std::string& name, const std::vector<std::string>& choices);
  bool flag(const std::string& name);
  double number(const std::string& name);
  double number_or_infinite(const std::string& name);  ///< 0 or more, or "inf"
  std::int64_t count(const std::string& name);         ///< 0 or more
  Index index(const std::string& name);                ///< below no_index
  std::vector<Index> indices(const std::string& name);
  std::vector<std::string> names(const std::string& name);                 ///< at least one
  std::vector<std::vector<double>> number_lists(const std::string& name);  ///< at least one
  ParameterValue value(const std::string& name);

  Vec2 pair(const std::string& name);
  Vec3 triple(const std::string& name);
  ModelPlace model_place(const std::string& name);  ///< none without the field
  /// A place of the sketch (two numbers) or of the model (three).
  void place(const std::string& name, Vec2& sketch, ModelPlace& model);
  /// Of "shift", "ctrl", "alt", "super"; empty without the field "modifiers".
  std::vector<std::string> modifiers();

  /// @throws Mistake naming the first field that was never asked for
  void refuse_unknown() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
  const Vocabulary& vocabulary_;
};

}  // namespace croquis::recorded

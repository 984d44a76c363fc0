// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
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

/// What a text may be, or the names of an enumeration's values in their order.
using Words = std::vector<std::string>;

/// The form of a number of 0 or more that may be infinite: "inf".
struct OrInfinite {};

/// What is wrong with a line, as a sentence without its end; becomes a finding with the line's number.
struct Mistake {
  std::string sentence;
};

/// What has been read or written of a line.
struct FieldState;

bool reads(const FieldState& state);

// Reads a value from its field, or writes it there. @throws Mistake, as Fields says
void exchange(FieldState& state, const std::string& name, std::string& value);
void exchange(FieldState& state, const std::string& name, std::string& value, const Words& words);
void exchange(FieldState& state, const std::string& name, bool& value);
void exchange(FieldState& state, const std::string& name, double& value);
void exchange(FieldState& state, const std::string& name, double& value, const OrInfinite&);
void exchange(FieldState& state, const std::string& name, std::int64_t& value);  ///< 0 or more
void exchange(FieldState& state, const std::string& name, std::size_t& value);
void exchange(FieldState& state, const std::string& name, int& value);
void exchange(FieldState& state, const std::string& name, Index& value);                             ///< below no_index
void exchange(FieldState& state, const std::string& name, std::vector<Index>& value);                ///< of these
void exchange(FieldState& state, const std::string& name, std::vector<std::string>& value);          ///< at least one
void exchange(FieldState& state, const std::string& name, std::vector<std::vector<double>>& value);  ///< at least one
void exchange(FieldState& state, const std::string& name, std::vector<Vec2>& value);                 ///< at least one
void exchange(FieldState& state, const std::string& name, std::vector<Vec3>& value);                 ///< at least one
void exchange(FieldState& state, const std::string& name, Vec2& value);
void exchange(FieldState& state, const std::string& name, Vec3& value);
void exchange(FieldState& state, const std::string& name, ParameterValue& value);

/// A value of an enumeration, or a number that counts from 0.
template <typename T>
void exchange(FieldState& state, const std::string& name, T& value, const Words& words) {
  std::string word = reads(state) ? std::string() : words[static_cast<std::size_t>(value)];
  exchange(state, name, word, words);
  value = static_cast<T>(std::ranges::find(words, word) - words.begin());
}

/// The fields of one recorded line, by name and type. A step lists its members once, in the order of the line: when a
/// line is read, they get its values, and when one is written, it gets theirs. Numbers read back exactly.
///
/// While a line is read, everything that takes a name throws Mistake when the field isn't what is asked for, and a
/// field that nobody asked for is a mistake. Numbers are finite. Nothing is thrown when a line is written.
class Fields {
 public:
  /// Reads a line.
  /// @param line       one JSON object
  /// @param vocabulary that the line is read with; outlives this
  /// @throws Mistake
  Fields(std::string_view line, const Vocabulary& vocabulary);

  /// Writes a line.
  Fields();
  ~Fields();
  Fields(const Fields&) = delete;
  Fields& operator=(const Fields&) = delete;

  bool reads() const { return vocabulary_ != nullptr; }
  const Vocabulary& vocabulary() const { return *vocabulary_; }  ///< @pre reads()
  bool has(const std::string& name);                             ///< @pre reads()

  /// A field of every line. Of a member that may be absent, one that must be there is read.
  template <typename T, typename... Form>
  void required(const std::string& name, T& value, const Form&... form) {
    exchange(*state_, name, value, form...);
  }

  template <typename T, typename... Form>
  void required(const std::string& name, std::optional<T>& value, const Form&... form) {
    if (reads()) value.emplace();
    if (value) exchange(*state_, name, *value, form...);
  }

  /// A field of every line that is written; where it is absent, the member stays as it is.
  template <typename T, typename... Form>
  void given(const std::string& name, T& value, const Form&... form) {
    if (!reads() || has(name)) exchange(*state_, name, value, form...);
  }

  /// A field that is written when the member has a value, or one that isn't that of its type (none, false, empty, 0).
  template <typename T, typename... Form>
  void seldom(const std::string& name, T& value, const Form&... form) {
    if (reads() ? has(name) : value != T()) exchange(*state_, name, value, form...);
  }

  template <typename T, typename... Form>
  void seldom(const std::string& name, std::optional<T>& value, const Form&... form) {
    if (reads() ? has(name) : value.has_value()) required(name, value, form...);
  }

  /// A place of the sketch (two numbers) or of the model (three).
  void place(const std::string& name, Vec2& sketch, ModelPlace& model);

  /// Of "shift", "ctrl", "alt", "super"; no field when there are none.
  void modifiers(std::vector<std::string>& modifiers);

  /// @throws Mistake with that sentence when a line is read for which it doesn't hold
  void require(bool holds, const std::string& sentence) const {
    if (reads() && !holds) throw Mistake{sentence};
  }

  /// @throws Mistake naming the first field that was never asked for
  void refuse_unknown() const;

  /// All that was written, without the line's end.
  std::string line() const;

 private:
  std::unique_ptr<FieldState> state_;
  const Vocabulary* vocabulary_ = nullptr;
};

}  // namespace croquis::recorded

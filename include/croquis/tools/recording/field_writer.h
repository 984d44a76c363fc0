// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "croquis/base/parameter.h"
#include "croquis/geometry/vector.h"
#include "croquis/tools/recording/fields.h"

namespace croquis::recorded {

/// Writes the fields of one line in the order they are given; Fields reads them. Numbers read back exactly.
class FieldWriter {
 public:
  FieldWriter();
  ~FieldWriter();
  FieldWriter(const FieldWriter&) = delete;
  FieldWriter& operator=(const FieldWriter&) = delete;

  void verb(const std::string& verb) { text("do", verb); }

  void text(const std::string& name, const std::string& value);
  void flag(const std::string& name, bool value);
  void number(const std::string& name, double value);
  void number_or_infinite(const std::string& name, double value);
  void count(const std::string& name, std::int64_t value);
  void indices(const std::string& name, const std::vector<Index>& values);
  void names(const std::string& name, const std::vector<std::string>& values);
  void number_lists(const std::string& name, const std::vector<std::vector<double>>& values);
  void value(const std::string& name, const ParameterValue& value);
  void pair(const std::string& name, const Vec2& value);
  void triple(const std::string& name, const Vec3& value);
  void place(const std::string& name, const Vec2& sketch, const ModelPlace& model);
  void modifiers(const std::vector<std::string>& modifiers);  ///< nothing when there are none

  /// All that was written, as one line without its end.
  std::string line() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace croquis::recorded

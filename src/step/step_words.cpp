// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cctype>

#include "step/step_file.h"

namespace croquis {

std::optional<LengthUnit> length_unit_named(std::string_view word) {
  if (word == "mm") return LengthUnit::Millimetre;
  if (word == "cm") return LengthUnit::Centimetre;
  if (word == "m") return LengthUnit::Metre;
  if (word == "inch" || word == "in") return LengthUnit::Inch;
  return std::nullopt;
}

bool is_step_path(std::string_view path) {
  std::string lower(path);
  std::ranges::transform(lower, lower.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return lower.ends_with(".step") || lower.ends_with(".stp");
}

}  // namespace croquis

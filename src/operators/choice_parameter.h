// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "croquis/base/parameter.h"

namespace croquis {

/// A parameter with named choices, of which the first is the default; "preset", the last one, leaves it to the preset.
template <std::size_t size>
ParameterDescription choice_or_preset(const std::string& name, const std::array<const char*, size>& choices,
                                      const std::string& sentence) {
  std::vector<std::string> all(choices.begin(), choices.end());
  all.emplace_back("preset");
  return choice_parameter(name, all, sentence);
}

/// The value of an enumeration that one of its names, in its order, stands for.
template <typename Enum, std::size_t size>
Enum named(const std::array<const char*, size>& names, const std::string& name) {
  return static_cast<Enum>(std::ranges::find(names, name) - names.begin());
}

}  // namespace croquis

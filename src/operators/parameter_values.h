// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "croquis/base/parameter.h"

namespace croquis {

/// A parameter with named choices; the first is the default.
inline ParameterDescription choice(const std::string& name, const std::vector<std::string>& choices,
                                   const std::string& sentence) {
  return {name, ParameterType::Choice, choices.front(), 0, 0, choices, "", sentence};
}

/// Values of complete parameters, whose type is known from their description.
inline const std::string& text(const ParameterValues& parameters, const std::string& name) {
  return std::get<std::string>(parameters.at(name));
}
inline double number(const ParameterValues& parameters, const std::string& name) {
  return std::get<double>(parameters.at(name));
}

}  // namespace croquis

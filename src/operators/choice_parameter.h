// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "croquis/base/parameter.h"

namespace croquis {

/// A parameter with named choices; the first is the default.
inline ParameterDescription choice(const std::string& name, const std::vector<std::string>& choices,
                                   const std::string& sentence) {
  return {name, ParameterType::Choice, choices.front(), 0, 0, choices, "", sentence};
}

}  // namespace croquis

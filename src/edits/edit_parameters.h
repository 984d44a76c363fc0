// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "croquis/base/parameter.h"
#include "croquis/geometry/vector.h"

/// How edits describe and read their parameters.
namespace croquis {

/// Three numbers, "0,0,1", in a text.
/// @param missing for a parameter that wasn't given
/// @throws Error (E_PARAMETER) for anything but three finite numbers
Vec3 vector_of(const ParameterValues& parameters, const std::string& name, const Vec3& missing);

bool is_given(const ParameterValues& parameters, const std::string& name);

}  // namespace croquis

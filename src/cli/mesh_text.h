// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "croquis/geometry/mesh_report.h"

namespace croquis::cli {

/// A mesh report as a few lines for people.
/// @param added of the self-intersections those that weren't there before, where that is known
std::string mesh_text(const MeshReport& report, std::optional<std::size_t> added = {});

/// "12.5": a coordinate with as many digits as help to find the place.
std::string number_text(double value);

/// "12,345": counts in messages.
std::string grouped(std::size_t number);

}  // namespace croquis::cli

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "io/svg/svg_outline.h"
#include "io/svg/svg_scanner.h"

namespace croquis {

struct SvgOutline {
  std::vector<SvgSubpath> subpaths;
  std::optional<SvgTextError> error;  ///< the subpaths are those before it
};

/// Path data: every command, absolute and relative (SVG 1.1, 8.3).
SvgOutline parse_svg_path(std::string_view data);

/// The points of a polyline or polygon. @param closed for a polygon
SvgOutline parse_svg_points(std::string_view points, bool closed);

}  // namespace croquis

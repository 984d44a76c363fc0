// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string_view>

#include "io/svg/svg_path.h"

namespace croquis {

/// The value of an element's attribute, empty when it is not there.
using SvgAttributes = std::function<std::string_view(const char* name)>;

bool is_svg_shape(std::string_view element);

/// The outline of a path, polyline, polygon, line, rect, circle or ellipse in its own coordinates. Empty for shapes
/// that SVG does not draw (no data, no width). Lengths may be in px, mm, cm, in, pt, pc (96 px to the inch).
SvgOutline svg_shape(std::string_view element, const SvgAttributes& attributes);

/// A length attribute; `fallback` when it is not there.
double svg_length(const SvgAttributes& attributes, const char* name, double fallback,
                  std::optional<SvgTextError>& error);

}  // namespace croquis

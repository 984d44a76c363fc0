// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string_view>

#include "io/svg/svg_path.h"

namespace croquis {

/// What percentages are of: the viewBox of the svg element or symbol around.
struct SvgViewport {
  Vec2 size = Vec2::Zero();  ///< user units; 0 where nothing says so
};

/// The value of an element's attribute, empty when it is not there.
using SvgAttributes = std::function<std::string_view(const char* name)>;

bool is_svg_shape(std::string_view element);

/// The outline of a path, polyline, polygon, line, rect, circle or ellipse in its own coordinates. Empty for shapes
/// that SVG does not draw (no data, no width). Lengths may be in px, mm, cm, in, pt, pc (96 px to the inch) or
/// percent of the viewport's width, height or, for radii of circles, root mean square of both (SVG 1.1, 7.10).
SvgOutline svg_shape(std::string_view element, const SvgAttributes& attributes, const SvgViewport& viewport);

/// Reads length attributes of one element.
class SvgLengths {
 public:
  SvgLengths(const SvgAttributes& attributes, const SvgViewport& viewport)
      : attributes_(attributes), viewport_(viewport) {}

  /// `fallback` when it is not there or no length.
  double at(const char* name, double fallback = 0);

  /// The first that is no length.
  const std::optional<SvgTextError>& error() const { return error_; }

 private:
  std::optional<double> factor_of(std::string_view unit, std::string_view name) const;

  const SvgAttributes& attributes_;
  SvgViewport viewport_;
  std::optional<SvgTextError> error_;
};

}  // namespace croquis

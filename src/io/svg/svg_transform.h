// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>

#include <Eigen/Geometry>

#include "io/svg/svg_scanner.h"

namespace croquis {

struct SvgTransform {
  Eigen::Affine2d map = Eigen::Affine2d::Identity();
  std::optional<SvgTextError> error;
};

/// A list of matrix, translate, scale, rotate, skewX and skewY, the last one applied first (SVG 1.1, 7.6); also as
/// style sheets write it, with units and for one axis (CSS Transforms 1, section 12).
SvgTransform parse_svg_transform(std::string_view text);

}  // namespace croquis

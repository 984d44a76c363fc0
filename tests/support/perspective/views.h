// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <numbers>
#include <string>
#include <vector>

#include "croquis/geometry/camera.h"
#include "support/perspective/solids.h"

namespace croquis::test {

/// Where a solid is seen from. Angles in radians.
struct View {
  std::string name;
  double field_of_view = 50 * std::numbers::pi / 180;  ///< across a picture that is `image_size` wide
  double azimuth = 36.87 * std::numbers::pi / 180;     ///< of the forward direction from y towards -x
  double elevation = 26.57 * std::numbers::pi / 180;   ///< the camera looks down by so much; 0: upright stays upright
  Vec2 principal_offset = Vec2::Zero();                ///< of the principal point from the centre, × image_size
  Vec2 placement = Vec2::Zero();                       ///< of the solid's middle from the centre, × image_size
  double fill = 0.8;                                   ///< how much of the sheet the solid takes, larger way
  Vec2 origin = Vec2::Zero();                          ///< px, upper left corner of the sheet
  Vec2 image_size = Vec2(1000, 750);                   ///< px
};

/// The camera that sees the solid like that. Its picture coordinates are those of the sheet, origin included.
Camera camera_for(const PerspectiveSolid& solid, const View& view);

/// Fields of view of 25, 50 and 80 degrees; all vanishing points are finite.
std::vector<View> three_point_views();

View level_view();       ///< upright edges are parallel in the picture (2-point)
View frontal_view();     ///< only y has a finite vanishing point (1-point)
View off_centre_view();  ///< the principal point lies 12 % of the width off the centre
View cropped_view();     ///< a part of a larger sheet: its corner isn't (0,0), the principal point lies far off

/// All of the above.
std::vector<View> all_views();

}  // namespace croquis::test

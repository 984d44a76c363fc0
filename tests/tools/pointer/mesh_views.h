// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "croquis/tools/pointer/view_frame.h"

namespace croquis::test {

/// A camera described by plain numbers, so that projections can be checked without matrices.
struct TestCamera {
  Vec3 eye = {0, 0, 5};
  Vec3 target = Vec3::Zero();
  Vec3 up = Vec3::UnitY();
  double half_height = 0.4;  ///< perspective: tangent of half the upright angle; parallel: half the height, model units
  bool perspective = true;
  double near = 0.1, far = 100;
  Vec2 size = {800, 600};

  ViewFrame frame() const;

  /// By similar triangles.
  Vec2 pixel_of(const Vec3& place) const;

  Vec3 forward() const;
  Vec3 right() const;
  Vec3 upward() const;
};

}  // namespace croquis::test

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "croquis/geometry/vector.h"

/// Distances, angles and radii between places of the model.
namespace croquis {

/// At b, between the directions to a and c: degrees, 0..180; 0 where a place is b itself.
double angle_at(const Vec3& a, const Vec3& b, const Vec3& c);

/// Of the circle through three places; infinite where they lie on a line.
double radius_through(const Vec3& a, const Vec3& b, const Vec3& c);

/// One thing that was measured, and where its value stands.
struct MeasuredValue {
  std::string name;  ///< "Distance", "Angle", "Radius"
  double value = 0;  ///< model units, degrees
  std::string text;  ///< "5", "90°", "∞"
  Vec3 at = Vec3::Zero();
};

/// Of two places their distance; of three the distances along the way, the angle at the second one, and the radius of
/// the circle through them. Of fewer places nothing.
/// @param places at most three, finite
std::vector<MeasuredValue> measured(const std::vector<Vec3>& places);

/// The same as lines of text, with the differences along the axes behind each distance.
std::string measured_text(const std::vector<Vec3>& places);

}  // namespace croquis

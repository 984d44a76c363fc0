// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "croquis/geometry/attribute_network.h"
#include "croquis/geometry/vector.h"

namespace croquis {

/// Weights of a polygon's corners, with the sum 1, whose mean is the place: smooth inside, linear along the sides.
/// Source: Floater 2003, "Mean value coordinates", equation (2.1).
/// @param polygon at least 3 corners, in either direction, convex or not
std::vector<double> mean_value_weights(std::span<const Vec2> polygon, const Vec2& place);

/// Places along a loop, each once.
/// @param parts of each side
std::vector<Vec3> traced_loop(const AttributeNetwork& network, const std::vector<AttributeSide>& loop,
                              std::size_t parts = 16);

/// Sum of the cross products of neighbours: twice the area seen from its direction. Zero of what has no area.
Vec3 newell_normal(const std::vector<Vec3>& places);

/// About where places near a face lie in its domain: those of the loop are known, those inside follow by mean values in
/// the plane across the loop's normal. Good enough to separate the sides of a curve that divides the face.
class FaceMap {
 public:
  FaceMap(const AttributeNetwork& network, const AttributeFace& face);

  Vec2 operator()(const Vec3& place) const;
  Vec2 operator()(const FanPlace& fan) const;

 private:
  Vec2 seen(const Vec3& place) const { return {place.dot(right_), place.dot(up_)}; }

  Vec3 right_, up_;
  std::vector<Vec2> corners_;  ///< of the domain
  Vec2 middle_ = Vec2::Zero();
  std::vector<Vec2> rim_;     ///< the loop as it is seen …
  std::vector<Vec2> places_;  ///< … and where that is in the domain
};

}  // namespace croquis

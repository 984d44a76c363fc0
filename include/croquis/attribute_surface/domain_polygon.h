// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "croquis/geometry/attribute_network.h"
#include "croquis/geometry/vector.h"

/// The plane polygons that faces are maps of.
/// Source: Kim and Park 2006, section 2.2 (a triangle of the curves' lengths), here for any number of sides as the
/// polygon in a circle.
namespace croquis {

/// A strictly convex polygon of perimeter 1, counter-clockwise. Side k goes from corner k to corner k + 1.
struct DomainPolygon {
  std::vector<Vec2> corners;
  std::vector<double> side_lengths;  ///< as wanted: parts of the perimeter, relaxed where they allow no polygon
  double beta = 0;                   ///< 0..1, how far lengths were moved towards equal ones; 0: not at all
  double radius = 0;                 ///< of the circle through the corners; 0 where they have none
  bool centre_inside = true;         ///< that circle's
  Vec2 middle = Vec2::Zero();        ///< mean of the corners: where fans of places begin
  Vec2 centroid = Vec2::Zero();      ///< of the area
};

/// The polygon in a circle whose sides are in proportion to the lengths. Lengths that allow no polygon, or hardly one,
/// because one of them is more than 0.95 of the others together, are moved towards equal ones just far enough (beta);
/// those below 1/1000 of the sum are raised to that first. Continuous in the lengths.
/// @param lengths at least 3, finite, >= 0, not all 0
DomainPolygon chordlength_polygon(std::span<const double> lengths);

/// For comparison: a right triangle, the square, or the regular polygon.
/// @param sides at least 3
DomainPolygon uniform_polygon(std::size_t sides);

/// c + a (V[corner] - c) + b (V[corner + 1] - c) with the polygon's middle c.
/// @pre fan.corner is a corner
Vec2 place_in(const DomainPolygon& polygon, const FanPlace& fan);

/// The fan coordinates of a place: a and b are >= 0 in the corner that is found, for places outside too.
FanPlace fan_place_in(const DomainPolygon& polygon, const Vec2& place);

/// Distances of a place to the lines of the sides, inwards positive: the least of them.
double distance_inside(const DomainPolygon& polygon, const Vec2& place);

}  // namespace croquis

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "croquis/attribute_surface/face_surface.h"
#include "croquis/base/progress.h"
#include "croquis/geometry/vector.h"

namespace croquis {

/// For each side of a loop the fractions of its samples in the loop's direction: from 0, without 1, which is the next
/// side's.
using FaceRim = std::vector<std::vector<double>>;

/// Triangles in the domain of a face: first the places inside, then those of the rim, from the start of the loop on.
struct FacePlaces {
  std::vector<Vec2> places;
  std::size_t inner_count = 0;
  std::vector<std::array<Index, 3>> triangles;  ///< counter-clockwise
};

/// The same with the surface at them.
struct FaceSamples {
  FacePlaces plane;
  std::vector<Vec3> points;   ///< of the places inside
  std::vector<Vec3> normals;  ///< of all places, unit; zero where the surface has none
  double error = 0;           ///< model units: largest chord error inside that was left because of a limit

  std::size_t byte_size() const;
};

/// Places along the sides, in the loop's order.
std::vector<Vec2> rim_places(const FaceSurface& surface, const FaceRim& rim);

/// Whether a place is inside of a convex rim, and at neither it nor any of these places.
bool is_apart(const Vec2& place, const std::vector<Vec2>& rim, const std::vector<Vec2>& places);

/// The footprints of points and of the knots of inner curves, no two at one place, all of them inside the rim.
std::vector<Vec2> attribute_places(const FaceSurface& surface, const std::vector<Vec2>& rim);

/// Rings around the middle of the domain. Where all sides have n samples, ring j has j places per side, so there are
/// 1 + N n (n + 1) / 2 places and N n² triangles; the domain of a face of two curves has N = 4 sides of n / 2 samples.
/// Otherwise the rings are joined to the rim by a constrained Delaunay triangulation.
/// @param insert_attributes points are places, instead of those of the rings nearest to them, and so are knots of inner
///                          curves, as far apart as rings
FacePlaces fan_places(const FaceSurface& surface, const FaceRim& rim, bool insert_attributes);

/// A constrained Delaunay triangulation of what the rim encloses.
/// @param inner places inside the rim, no two of them equal
FacePlaces joined_places(const std::vector<Vec2>& rim, std::vector<Vec2> inner);

/// Evaluates the surface at all places. At sides of mode Smooth the normal is the fence's.
FaceSamples evaluate_places(const FaceSurface& surface, const FaceRim& rim, FacePlaces places);

struct RefinedPlaces {
  FacePlaces plane;
  double error = 0;  ///< model units: 0, or the largest chord error that was left because of a limit
};

struct RefinementOptions {
  double tolerance = 0;            ///< model units, > 0
  bool insert_attributes = true;   ///< points and inner curves are vertices
  std::size_t most_inner = 60000;  ///< places inside a face
};

/// A Delaunay triangulation of the domain with places added where the surface is farther than the tolerance from a
/// triangle: at 25 places of each triangle, none along the rim, which keeps to its curves already.
/// @throws Cancelled
RefinedPlaces refined_places(const FaceSurface& surface, const FaceRim& rim, Progress& progress,
                             const RefinementOptions& options);

}  // namespace croquis

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "support/random.h"
#include "support/scans/known_scans.h"

/// How known scans are made, step by step.
namespace croquis::test {

inline constexpr double base_height = -1.25;  // where statues are cut off

/// A scan in the making: all that is kept of a surface seen, and which holes are cut into it.
struct ScanDraft {
  ScanKind kind;
  Random random;
  std::function<double(const Vec3&)> solid;
  KnownScan scan;
  PolyMesh surface;           // that holes are cut into; what is missing of it is known
  std::vector<Index> labels;  // of the surface's faces: by which view they are seen; or none
  int overlap_rings = 0;      // of faces, by which views overlap
  Vec3 view = Vec3::UnitZ();  // of a single view
};

/// Unit directions all around z, evenly.
/// @param low, high between which their heights above the horizon are drawn, radians
std::vector<Vec3> directions_around(Random& random, std::size_t count, double low, double high);

/// Removes what wasn't seen, by the kind of scan: bases, backs, mouths, what is occluded, gaps between views.
void lose_parts(ScanDraft& draft, HoleCutter& cutter);

/// Takes the views apart from each other, each a little out of place, with the rings of faces by which they overlap.
/// The surface's views are moved alike: what is missing of one lies where that one lies.
/// @param number per face of the surface its number in the mesh, or none
void misplace_views(ScanDraft& draft, const std::vector<Index>& number);

/// Per face of a mesh the side that it is part of, between creases of more than 25 degrees.
std::vector<Index> sides_of(const PolyMesh& mesh);

/// Noise, and what is there but shouldn't be, by the kind of scan.
void make_dirty(ScanDraft& draft);

/// Turns, scales and moves all: nobody's scan lies straight, around the origin, and is three units across.
void place_anywhere(ScanDraft& draft);

}  // namespace croquis::test

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "croquis/base/finding.h"
#include "croquis/base/progress.h"
#include "croquis/geometry/curve_network.h"

/// Which loops of a curve network are the faces of a solid.
///
/// Candidates are the regions of planes and short loops in space; of these a set is chosen that has every curve in
/// exactly two faces and costs least, by branch and bound. Flat regions are free; loops in space cost more the more
/// they bend, the more sides they have and if all of these are straight. Faces inside the solid need no removal: a
/// curve that already has two faces has no room for a third.
namespace croquis {

/// A curve of the network as part of a loop.
struct CurveUse {
  Index curve = no_index;
  bool reversed = false;  ///< from the curve's end to its start
  friend bool operator==(const CurveUse&, const CurveUse&) = default;
};

using CurveLoop = std::vector<CurveUse>;

struct NetworkFace {
  std::vector<CurveLoop> loops;  ///< the outer one first, counter-clockwise seen from outside; holes clockwise
  bool planar = true;            ///< lies in a plane, exactly or nearly; else it is to be a smooth patch
  Vec3 origin = Vec3::Zero();    ///< a point of the plane, or of the mean plane
  Vec3 normal = Vec3::UnitZ();   ///< unit, outwards; of faces in space that of the mean plane
  double flatness = 0;           ///< greatest distance of the curves from that plane, model units
  double cost = 0;
  Index shell = no_index;
};

struct NetworkShell {
  std::vector<Index> faces;
  bool closed = false;
  bool is_void = false;  ///< bounds a cavity inside another shell; its faces look into the cavity
};

/// Faces that fit together, ordered by geometry alone.
struct FaceSet {
  std::vector<NetworkFace> faces;
  std::vector<NetworkShell> shells;
  double cost = 0;  ///< sum over the faces of their cost less 1, and for curves 3 for the first side
                    ///< without a face and 2.5 for the second
};

/// Names a face by the ids of its curves, in any order.
using FaceName = std::vector<std::string>;

struct FaceFindingOptions {
  std::size_t max_sides = 8;        ///< of loops in space, 2..12
  std::size_t max_sides_late = 12;  ///< if nothing closes with the above
  std::size_t node_limit = 200000;  ///< of each search
  double margin = 0.25;             ///< sets that cost this much more than the best count as alternatives
  std::size_t max_alternatives = 8;
  double plane_tolerance = 0.01;    ///< of oblique planes, × diagonal of the network's box
  std::vector<FaceName> fixed;      ///< faces that must be there; names that fit no candidate are ignored
  std::vector<FaceName> forbidden;  ///< faces that must not be there
};

struct FaceFindingResult {
  FaceSet best;
  std::vector<FaceSet> alternatives;  ///< by cost, without the best
  std::vector<Index> dangling;        ///< curves with a loose end, which bound nothing; ascending
  std::vector<Index> bridges;         ///< curves that alone hold two parts together and bound nothing; ascending
  std::vector<Index> open_curves;     ///< that have fewer than two faces; ascending
  std::size_t candidates = 0;
  std::size_t internal_rejected = 0;  ///< regions of planes that lie inside the solid: bounded by curves whose two
                                      ///< faces are others, and not part of another face
  std::size_t nodes = 0;              ///< of all searches
  Findings warnings;                  ///< DANGLING, NOT_CLOSED, NONPLANAR_STRAIGHT_FACE, MISSING_STROKE, AMBIGUOUS,
                                      ///< SEARCH_LIMIT
};

/// Finds the faces. Parts that share no candidate are solved on their own. Where no set closes, as many sides of curves
/// as possible get a face and the rest is named by NOT_CLOSED. The result depends on the geometry alone, not on the
/// order, direction and ids of curves.
/// @throws Cancelled
FaceFindingResult find_faces(const CurveNetwork& network, Progress& progress, const FaceFindingOptions& options = {});

}  // namespace croquis

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "algorithms/perspective/faces/solid_graph.h"

namespace croquis {

/// Edges of a graph that lie in a plane.
struct EdgePlane {
  Vec3 origin = Vec3::Zero();
  Vec3 normal = Vec3::UnitZ();
  int axis = -1;             ///< 0..2: exactly at right angles to that axis; -1: oblique
  std::vector<Index> edges;  ///< ascending
};

/// Planes at right angles to an axis, found by coordinates that are bit-identical, then oblique ones through pairs of
/// straight edges that meet.
/// @param tolerance of oblique planes, model units
std::vector<EdgePlane> planes_of(const CurveNetwork& network, const SolidGraph& graph, double tolerance);

/// The bounded regions of the drawing that edges make in their plane, with and without holes, and their outlines.
/// @param number of the plane, for the candidates
std::vector<FaceCandidate> faces_in_plane(const SolidGraph& graph, const EdgePlane& plane, Index number);

}  // namespace croquis

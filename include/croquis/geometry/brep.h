// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "croquis/base/finding.h"
#include "croquis/geometry/affine3.h"
#include "croquis/geometry/bounds.h"
#include "croquis/geometry/gregory_patch.h"
#include "croquis/geometry/rational_cubic.h"

namespace croquis {

struct BrepVertex {
  Vec3 point = Vec3::Zero();        ///< model units
  Index network_vertex = no_index;  ///< of the curve network; several where solids touch in one of its vertices
};

/// A curve that faces meet in.
struct BrepEdge {
  std::string id;          ///< unique; of the network's curve, the stroke, if there is one
  Index curve = no_index;  ///< of the network; no_index: no stroke, divides an outline of strokes into faces
  Index start = no_index;  ///< vertex of the B-rep
  Index end = no_index;
  std::vector<RationalCubic> pieces;  ///< the exact curve
  std::vector<RationalCubic> fitted;  ///< one or two polynomial cubics close to it, which patches are spanned from
  bool straight = false;
  std::array<Index, 2> half_edges = {no_index, no_index};  ///< from start to end, and back; no_index: no face there
  bool smooth = false;                                     ///< both faces have the same normals along the edge
  /// Of smooth edges: directions across it at its start and end, into the face of the first half-edge. Both faces'
  /// slopes are made of it and the edge's own direction.
  std::array<Vec3, 2> across = {Vec3::Zero(), Vec3::Zero()};
};

struct BrepHalfEdge {
  Index edge = no_index;
  bool reversed = false;  ///< runs from the edge's end to its start
  Index loop = no_index;
  Index next = no_index;  ///< half-edge
};

struct BrepLoop {
  Index face = no_index;
  Index first = no_index;  ///< half-edge
};

/// A face: trimmed plane or Gregory patches.
///
/// Loops run counter-clockwise seen from outside, holes clockwise. A face of four sides with one patch has the patch's
/// side i along the i-th half-edge of its loop. A face of n sides with n patches has the middle of the face as their
/// common corner 2: patch i has corner 0 at the start of half-edge i, corner 1 at its middle, corner 3 at the middle
/// of the half-edge before.
struct BrepFace {
  Index shell = no_index;
  Index outline = no_index;  ///< number of the outline of strokes that it fills; several faces may fill one together
  std::vector<Index> loops;  ///< the outer one first
  bool planar = true;
  Vec3 origin = Vec3::Zero();         ///< of planar faces: a point of the plane
  Vec3 normal = Vec3::UnitZ();        ///< of planar faces: unit, outwards. Of others: of the mean plane
  double flatness = 0;                ///< of planar faces: greatest distance of their edges from the plane
  std::vector<GregoryPatch> patches;  ///< none for planar faces
};

struct BrepShell {
  std::vector<Index> faces;
  bool closed = false;
  bool is_void = false;  ///< bounds a cavity inside another shell
};

/// What bounds a solid: shells of faces, faces with loops, loops of half-edges, edges, vertices. Plain arrays that
/// refer to each other by index. Open shells are allowed: their edges lack a half-edge.
struct Brep {
  std::vector<BrepVertex> vertices;
  std::vector<BrepEdge> edges;
  std::vector<BrepHalfEdge> half_edges;
  std::vector<BrepLoop> loops;
  std::vector<BrepFace> faces;
  std::vector<BrepShell> shells;

  Index start_of(Index half_edge) const;
  Index end_of(Index half_edge) const;
  Index face_of(Index half_edge) const { return loops[half_edges[half_edge].loop].face; }

  /// The half-edge on the other side of the edge, or no_index.
  Index twin(Index half_edge) const;

  /// The half-edges of a loop in order, from its first.
  std::vector<Index> around(Index loop) const;
};

/// Diagonal of the box around the control points of all edges, model units: what tolerances are parts of.
double size_of(const Brep& brep);

/// The numbers in V - E + F - R = 2 (S - G).
struct BrepFigures {
  std::size_t vertices = 0;
  std::size_t edges = 0;
  std::size_t faces = 0;
  std::size_t rings = 0;  ///< loops beyond the first of each face
  std::size_t shells = 0;
  std::size_t open_edges = 0;         ///< that lack a half-edge
  std::optional<std::int64_t> genus;  ///< handles, summed over the shells; none for open shells
};

BrepFigures inspect(const Brep& brep);

/// What contradicts itself, each an error E_INTERNAL that names the element: indices out of range, elements that don't
/// know each other, loops that aren't closed or don't join end to start, edges without curves, faces whose patches
/// don't fit their loop, a genus that isn't a whole number or is negative. Linear.
Findings validate(const Brep& brep);

/// Of all vertices and control points, which hold the curves and patches between them.
BoundingBox bounds_of(const Brep& brep);

/// The mapped B-rep, exactly: affine maps keep rational cubics and Gregory patches. A map that mirrors turns every loop
/// round, so that loops still run counter-clockwise seen from outside.
/// @param map invertible
Brep transformed(const Brep& brep, const Affine3& map);

}  // namespace croquis

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "croquis/base/progress.h"
#include "croquis/base/report.h"
#include "croquis/geometry/poly_mesh.h"

namespace croquis {

/// The figures of a mesh as it stands: nothing is welded, turned or dropped before counting.
struct MeshReport {
  std::size_t vertices = 0;  ///< all of them, used or not
  std::size_t faces = 0;
  std::size_t edges = 0;                  ///< unordered pairs of different vertices that follow each other in a face
  std::size_t boundary_edges = 0;         ///< edges of one face
  std::size_t boundary_loops = 0;         ///< see MeshTopology::boundary_loops
  std::size_t components = 0;             ///< of faces joined by edges; a common vertex alone joins nothing
  std::int64_t euler_characteristic = 0;  ///< V - E + F with the vertices that faces use

  /// Handles, summed over the shells; a vertex that several fans share counts once for each. None for an open mesh, for
  /// one with an edge of more than two faces, and for one that can't be oriented: these have no such number.
  std::optional<std::int64_t> genus;

  std::size_t nonmanifold_edges = 0;     ///< edges of more than two faces
  std::size_t nonmanifold_vertices = 0;  ///< used, with more than one fan or at a non-manifold edge
  std::size_t degenerate_faces = 0;      ///< see degenerate_faces()

  /// The faces as written agree: no edge is run one way more than once more often than the other way.
  bool oriented = true;
  bool closed = false;                            ///< has faces and no boundary edge
  std::optional<std::size_t> self_intersections;  ///< see find_self_intersections; none if not asked for
  double area = 0;                                ///< polygons by their cut into triangles, see polygon_cut
  std::optional<double> volume;  ///< by the same cut, positive when the faces look outwards; none for an open mesh
  std::optional<std::array<Vec3, 2>> bounds;  ///< least and greatest coordinates of all vertices; none without any
};

/// Takes the figures. Any soup is accepted; near-linear (see find_self_intersections).
/// @throws Error (E_INDEX, E_NOT_FINITE) for a mesh whose indices or positions are unusable
/// @throws Cancelled
MeshReport inspect(const PolyMesh& mesh, bool count_self_intersections, Progress& progress);

/// The report's `mesh` object, with null for figures that there are none of.
Report to_report(const MeshReport& figures);

}  // namespace croquis

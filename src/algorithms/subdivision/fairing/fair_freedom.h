// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include <Eigen/SparseCore>

#include "algorithms/subdivision/levels/weight_rows.h"
#include "croquis/geometry/mesh_topology.h"

namespace croquis::subdivision {

/// In which directions a vertex may move: 0 to 3 of unit length, at right angles to each other.
using Directions = std::vector<Vec3>;

using Freedom = std::vector<Directions>;  ///< #V of a cage

/// The part of a move that is free.
Vec3 allowed(const Directions& directions, const Vec3& move);

/// Everything may move.
Freedom full_freedom(std::size_t vertex_count);

/// Vertices of planar faces beside tagged edges keep to the planes of these faces.
void keep_planes_beside_tags(const PolyMesh& mesh, const MeshTopology& topology, Freedom& freedom);

/// Vertices that nothing may move: pins, the boundary, vertices without faces and, if asked, those of tagged edges.
void hold(const PolyMesh& mesh, const MeshTopology& topology, bool hold_tags, Freedom& freedom);

/// The vertex moves as columns of one matrix, 3 #V by #unknowns.
Eigen::SparseMatrix<double> freedom_matrix(const Freedom& freedom);

}  // namespace croquis::subdivision

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include <Eigen/SparseCore>

#include "algorithms/subdivision/levels/level_geometry.h"
#include "croquis/geometry/mesh_topology.h"
#include "croquis/subdivision/edge_chain.h"
#include "croquis/subdivision/level.h"

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

/// The cotangent Laplacian of a level, #V by #V: applied to positions, a row's squared length is the squared mean
/// curvature (times 4) integrated around its vertex. Rows of the boundary, of sharp edges and of pins are empty.
WeightMatrix fair_laplacian(const Level& level, std::span<const Vec3> positions);

/// Minimises |second differences|^2 / h^2 + w |C - C0|^2 over the inner vertices of an open chain or all of a closed
/// one. A planar chain moves within its plane.
/// @param points        of the chain's vertices in order
/// @param edge_length   h
/// @return the moved points
std::vector<Vec3> fair_chain(const EdgeChain& chain, const ChainShape& shape, std::vector<Vec3> points,
                             double edge_length, double weight);

}  // namespace croquis::subdivision

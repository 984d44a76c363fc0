// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "algorithms/remeshing/remesh_points.h"
#include "croquis/implicit/box_weight.h"
#include "croquis/implicit/point_tree.h"

namespace croquis::remeshing {

/// Where the surface of a piece with open rims ends: beyond 1.5 cells from all data, unless in the box of a hole that
/// is filled, and half a cell beyond a rim that stays open or gets a patch.
class OpenBorders {
 public:
  /// @param cell,edge the cubes' edge and the mesh's mean edge: data can't be nearer to everything than these
  OpenBorders(const RemeshPiece& piece, const RemeshPoints& points, const std::vector<RimPlace>& rims,
              std::vector<implicit::Box> holes, double cell, double edge, int threads);

  /// Thread-safe; log n.
  bool is_beyond(const Vec3& place) const;

 private:
  const RemeshPoints& points_;
  implicit::PointTree tree_;
  std::vector<Vec3> outwards_;  // per place on such a rim
  std::vector<Index> rim_of_;   // of a point: into outwards_, or no_index; empty without rims
  std::vector<implicit::Box> holes_;
  double far_, over_;
};

/// Of every vertex the lowest one that edges lead to.
std::vector<Index> parts_of(const PolyMesh& mesh);

/// Number of parts that edges join, vertices without triangles left out.
std::size_t part_count(const PolyMesh& mesh);

/// The mesh without some of its faces, and without the vertices that nothing uses then. Order stays.
PolyMesh without(const PolyMesh& mesh, std::span<const std::uint8_t> removed);

/// Removes faces that are marked; then those that hang on a border by one vertex or stick out of it by two edges, until
/// every vertex is manifold.
PolyMesh sound_without(const PolyMesh& mesh, std::vector<std::uint8_t> removed);

/// The same for triangles with a marked vertex.
PolyMesh trimmed(const PolyMesh& mesh, std::span<const std::uint8_t> beyond);

/// Points that no vertex is within `distance` of, ascending.
std::vector<Index> far_points(const PolyMesh& mesh, std::span<const Vec3> points, double distance, int threads,
                              Progress& progress);

/// Removes connected parts that hardly any point lies on. Parts that points do lie on stay, however many.
/// @param other positions of the same vertices elsewhere, which go along; or none
/// @return how many were removed
std::size_t drop_strays(PolyMesh& mesh, std::span<const Vec3> points, int threads, Progress& progress,
                        std::vector<Vec3>* other = nullptr);

}  // namespace croquis::remeshing

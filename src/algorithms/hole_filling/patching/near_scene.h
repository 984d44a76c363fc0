// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <mutex>
#include <span>
#include <vector>

#include <Eigen/Geometry>

#include "croquis/base/progress.h"
#include "croquis/hole_filling/hole_site.h"

namespace croquis::hole_filling {

/// Finds a surface's triangles in boxes, for all holes of a mesh. The first few queries visit every triangle; then
/// a tree of boxes is made, which costs about as much as these and makes each further one cheap. Thread-safe.
class SurfaceSearch {
 public:
  using Box = Eigen::AlignedBox3d;

  /// Keeps references.
  SurfaceSearch(const PolyMesh& mesh, const SurfaceView& view) : mesh_(mesh), view_(view) {}

  /// Triangles whose boxes meet the box, ascending.
  std::vector<Index> near(const Box& box) const;

  /// So far, of triangles and of the tree.
  std::size_t boxes_looked_at() const { return looked_at_; }

 private:
  Box box_of(Index triangle) const;
  std::vector<Index> near_by_looking_at_all(const Box& box) const;
  void make_tree() const;
  /// @return how many boxes it looked at
  std::size_t descend(std::size_t level, std::size_t node, const Box& box, std::vector<Index>& found) const;

  const PolyMesh& mesh_;
  const SurfaceView& view_;
  mutable std::atomic<std::size_t> questions_ = 0;
  mutable std::atomic<std::size_t> looked_at_ = 0;
  mutable std::once_flag made_;
  mutable std::vector<Index> order_;              ///< triangles, neighbours mostly behind one another
  mutable std::vector<std::vector<Box>> levels_;  ///< around eights of triangles, of the level before, up to one
};

/// Of the site's surface, by its search, or where it has none by one of its own.
std::vector<Index> triangles_near(const HoleSite& site, const SurfaceSearch::Box& box);

/// A triangle of a patch that meets something where it shouldn't.
struct Clash {
  Index triangle = 0;      ///< of the patch
  Index other = no_index;  ///< another one of the patch, a lower number, or no_index: the surface
};

/// The part of a surface within a box, for asking again and again what patches would cut.
class NearScene {
 public:
  NearScene(const HoleSite& site, const Eigen::AlignedBox3d& box);

  /// @param points    new vertices, numbered behind those of the mesh
  /// @param triangles within the box
  /// @throws Cancelled
  std::vector<Clash> clashes(std::span<const Vec3> points, std::span<const std::array<Index, 3>> triangles,
                             Progress& progress) const;

  /// How many clashes these triangles of the patch have with the surface, each other and the rest of it: for asking
  /// what a few changed ones do. Visits boxes of all, but compares what is near them alone.
  /// @param chosen numbers of triangles, each once
  /// @throws Cancelled
  std::size_t count_clashes_of(std::span<const Index> chosen, std::span<const Vec3> points,
                               std::span<const std::array<Index, 3>> triangles, Progress& progress) const;

 private:
  /// By the scene's numbers, new vertices behind its own.
  std::array<Index, 3> in_scene(std::array<Index, 3> triangle) const;

  const SurfaceView& view_;
  Index vertex_count_;           ///< of the mesh
  std::vector<Index> vertices_;  ///< of the view, sorted, per vertex of the scene
  PolyMesh scene_;
};

}  // namespace croquis::hole_filling

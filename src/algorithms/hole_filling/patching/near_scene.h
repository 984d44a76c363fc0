// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <mutex>
#include <optional>
#include <span>
#include <vector>

#include "algorithms/hole_filling/analysis/box_search.h"
#include "croquis/base/progress.h"
#include "croquis/hole_filling/hole_patch.h"
#include "croquis/hole_filling/hole_site.h"

namespace croquis::hole_filling {

/// Finds a surface's triangles in boxes, for all holes of a mesh. The first few queries visit every triangle; then
/// a tree of boxes is made, which costs about as much as these and makes each further one cheap. Thread-safe.
class SurfaceSearch {
 public:
  /// Keeps references.
  SurfaceSearch(const PolyMesh& mesh, const SurfaceView& view) : box_of_{mesh, view} {}

  /// Triangles whose boxes meet the box, ascending.
  std::vector<Index> near(const Box& box) const;

  /// So far, of triangles and of the tree.
  std::size_t boxes_looked_at() const { return looked_at_; }

 private:
  struct BoxOfTriangle {
    const PolyMesh& mesh;
    const SurfaceView& view;

    Box operator()(Index triangle) const {
      return box_of(view.triangles[triangle], [&](Index vertex) -> const Vec3& { return mesh.positions[vertex]; });
    }
  };

  const BoxOfTriangle box_of_;
  mutable std::atomic<std::size_t> questions_ = 0;
  mutable std::atomic<std::size_t> looked_at_ = 0;
  mutable std::once_flag made_;
  mutable std::optional<BoxSearch<BoxOfTriangle>> tree_;
};

/// Of the site's surface, by its search, or where it has none by one of its own.
std::vector<Index> triangles_near(const HoleSite& site, const Box& box);

/// A triangle of a patch that meets something where it shouldn't.
struct Clash {
  Index triangle = 0;      ///< of the patch
  Index other = no_index;  ///< another one of the patch, a lower number, or no_index: the surface
};

/// The part of a surface within a box, for asking again and again what patches would cut.
class NearScene {
 public:
  NearScene(const HoleSite& site, const Box& box);

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

/// Whether an edge of the site's rims goes through a triangle of the surface: every patch has a triangle at that edge,
/// so none can be sound. False where rounding leaves it open. Near-linear in the rims and what lies near them.
bool rims_cross_surface(const HoleSite& site);

/// Flips edges of a patch's triangles that meet something they shouldn't, wherever a flip leaves fewer such pairs; for
/// the few triangles that a faired patch runs into a rough rim with. At most 300 flips are looked at.
/// @return whether nothing meets any more
/// @throws Cancelled
bool untangle(const HoleSite& site, HolePatch& patch, Progress& progress);

}  // namespace croquis::hole_filling

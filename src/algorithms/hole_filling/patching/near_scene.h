// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <vector>

#include <Eigen/Geometry>

#include "croquis/base/progress.h"
#include "croquis/hole_filling/hole_analysis.h"

namespace croquis::hole_filling {

/// A triangle of a patch that meets something where it shouldn't.
struct Clash {
  Index triangle = 0;      ///< of the patch
  Index other = no_index;  ///< another one of the patch, a lower number, or no_index: the surface
};

/// The part of a surface within a box, for asking again and again what patches would cut.
class NearScene {
 public:
  /// Linear in the view.
  NearScene(const PolyMesh& mesh, const SurfaceView& view, const Eigen::AlignedBox3d& box);

  /// @param points    new vertices, numbered behind those of the mesh
  /// @param triangles within the box
  /// @throws Cancelled
  std::vector<Clash> clashes(std::span<const Vec3> points, std::span<const std::array<Index, 3>> triangles,
                             Progress& progress) const;

 private:
  const SurfaceView& view_;
  Index vertex_count_;           ///< of the mesh
  std::vector<Index> vertices_;  ///< of the view, sorted, per vertex of the scene
  PolyMesh scene_;
};

}  // namespace croquis::hole_filling

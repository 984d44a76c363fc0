// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include <Eigen/Geometry>

#include "algorithms/perspective/camera/sheet_frame.h"
#include "croquis/perspective/vertex_coordinates.h"

namespace croquis {

std::vector<PromotedStroke> promoted_strokes(const PerspectiveDrawing& drawing, std::span<const StrokeGroup> groups,
                                             const CameraEstimate& camera, const CoordinateOptions& options) {
  const double unit = SheetFrame(drawing).unit;
  const double limit = std::max(options.promote_sigmas * camera.sigma, options.promote_distance * unit);
  std::vector<PromotedStroke> promoted;
  for (std::size_t s = 0; s < drawing.strokes.size(); ++s) {
    const PerspectiveStroke& stroke = drawing.strokes[s];
    if (!stroke.straight || groups[s] == StrokeGroup::Unknown || is_parallel(groups[s])) continue;
    if (!stroke.start().allFinite() || !stroke.end().allFinite()) continue;
    std::array<double, 2> misses{};
    std::array<std::size_t, 2> axes{};
    for (std::size_t i = 0; i < 2; ++i) {
      axes[i] = (static_cast<std::size_t>(axis_of(groups[s])) + 1 + i) % 3;
      misses[i] = vanishing_residual(camera.vanishing_points[axes[i]], stroke.start(), stroke.end());
    }
    const std::size_t nearer = misses[0] <= misses[1] ? 0 : 1;
    // A short stroke misses neither by much: the other axis has to be told from it beyond the noise, too.
    if (misses[nearer] >= limit || misses[1 - nearer] <= std::max(options.promote_ratio * misses[nearer], limit))
      continue;
    promoted.push_back({static_cast<Index>(s), static_cast<StrokeGroup>(axes[nearer])});
  }
  return promoted;
}

}  // namespace croquis

// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <utility>

#include <Eigen/Geometry>

#include "algorithms/perspective/camera/sheet_frame.h"
#include "croquis/base/limits.h"
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
    if (!are_usable_numbers(stroke.start()) || !are_usable_numbers(stroke.end())) continue;
    PerAxis<double> misses;
    for (int k = 0; k < 3; ++k) {
      misses[k] = vanishing_residual(camera.vanishing_points[k], stroke.start(), stroke.end());
    }
    const int one = (axis_of(groups[s]) + 1) % 3;
    const int other = (axis_of(groups[s]) + 2) % 3;
    const auto [nearer, farther] = misses[one] <= misses[other] ? std::pair(one, other) : std::pair(other, one);
    // A short stroke misses neither by much: the other axis has to be told from it beyond the noise, too.
    if (misses[nearer] >= limit || misses[farther] <= std::max(options.promote_ratio * misses[nearer], limit)) continue;
    promoted.push_back({static_cast<Index>(s), static_cast<StrokeGroup>(nearer)});
  }
  return promoted;
}

}  // namespace croquis

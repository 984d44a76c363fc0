// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/perspective/coordinates/plane_merging.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <set>
#include <tuple>
#include <utility>

#include <Eigen/Geometry>

#include "algorithms/perspective/camera/sheet_frame.h"
#include "croquis/base/limits.h"
#include "croquis/perspective/vertex_coordinates.h"

namespace croquis {
namespace {

/// Residuals are never judged as smaller than this, u.
constexpr double least_noise = 0.3;

/// Two neighbouring planes of one axis and one component, by a slot of each.
struct PlanePair {
  double gap = 0;
  Index low = no_index;   // slot
  Index high = no_index;  // slot
};

struct Plane {
  Index component;
  int axis;
  double value;
  Index slot;
};

std::vector<Plane> sorted_planes(const SolvedVertices& now) {
  std::vector<Plane> planes(now.table.class_count(), Plane{no_index, 0, 0, no_index});
  for (Index v = 0; v < now.table.vertex_count(); ++v) {
    for (int k = 0; k < 3; ++k) {
      const Index c = now.table.of_vertex[v][static_cast<std::size_t>(k)];
      if (planes[c].slot != no_index) continue;
      planes[c] = {now.table.component[v], k, now.solution.values[c], 3 * v + static_cast<Index>(k)};
    }
  }
  std::sort(planes.begin(), planes.end(), [](const Plane& a, const Plane& b) {
    return std::tie(a.component, a.axis, a.value, a.slot) < std::tie(b.component, b.axis, b.value, b.slot);
  });
  return planes;
}

std::vector<PlanePair> near_pairs(const SolvedVertices& now, double limit) {
  std::vector<double> diagonals(now.table.components);
  for (Index c = 0; c < now.table.components; ++c) diagonals[c] = component_diagonal(now, c);
  const std::vector<Plane> planes = sorted_planes(now);
  std::vector<PlanePair> pairs;
  for (std::size_t i = 1; i < planes.size(); ++i) {
    const Plane& low = planes[i - 1];
    const Plane& high = planes[i];
    const double gap = high.value - low.value;
    if (low.component != high.component || low.axis != high.axis || gap > limit * diagonals[low.component]) continue;
    pairs.push_back({gap, low.slot, high.slot});
  }
  std::stable_sort(pairs.begin(), pairs.end(), [](const PlanePair& a, const PlanePair& b) { return a.gap < b.gap; });
  return pairs;
}

/// In a coarse drawing planes that are one may be farther apart. Steps that were meant are safe, their edges join
/// vertices that would get to the same place.
double gap_limit(const TiedVertices& tied, double noise, const CoordinateOptions& options) {
  constexpr double deviations = 4;
  constexpr double greatest = 0.05;
  Eigen::AlignedBox2d box;
  for (const Vec2& place : tied.seen.places) box.extend(place);
  const double coarse = deviations * noise / box.diagonal().norm();
  return std::max(options.merge_distance, std::min(coarse, greatest));
}

/// The coordinate that both ends of a stroke have in common and along which the ray goes most.
int passed_axis(StrokeGroup group, const Vec3& ray) {
  const int axis = axis_of(group);
  if (!is_parallel(group)) return axis;
  const int one = (axis + 1) % 3;
  const int other = (axis + 2) % 3;
  return std::abs(ray[one]) >= std::abs(ray[other]) ? one : other;
}

}  // namespace

double component_diagonal(const SolvedVertices& solved, Index component) {
  Eigen::AlignedBox3d box;
  for (Index v = 0; v < solved.table.vertex_count(); ++v) {
    if (solved.table.component[v] == component) box.extend(solved.solution.position(solved.table, v));
  }
  return box.isEmpty() ? 0 : box.diagonal().norm();
}

std::vector<MergedPlanes> merge_planes(TiedVertices& tied, SolvedVertices& now, double sigma,
                                       const CoordinateOptions& options, Progress& progress) {
  const double noise = std::max({now.solution.rms_of_freedom(), sigma, least_noise});
  const double most_rise = options.merge_rise * noise * noise;
  const double limit = gap_limit(tied, noise, options);
  std::vector<MergedPlanes> merged;
  std::set<std::pair<Index, Index>> refused;
  for (bool again = true; again;) {
    again = false;
    for (const PlanePair& pair : near_pairs(now, limit)) {
      if (refused.contains({pair.low, pair.high})) continue;
      progress.check();
      const std::vector<Vec3> near = now.positions();
      tied.ties.equal.emplace_back(pair.low, pair.high);
      SolvedVertices trial = solved(tied, &near);
      const bool fits = trial.solution.in_front && trial.solution.squares - now.solution.squares <= most_rise &&
                        !has_coincident_vertices(trial.table);
      if (!fits) {
        tied.ties.equal.pop_back();
        refused.insert({pair.low, pair.high});
        continue;
      }
      merged.push_back({static_cast<int>(pair.low % 3), pair.low / 3, pair.high / 3, pair.gap});
      now = std::move(trial);
      again = true;  // neighbours have changed
      break;
    }
  }
  return merged;
}

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
    // A short stroke misses neither by much: the other axis has to differ from it by more than the noise, too.
    if (misses[nearer] >= limit || misses[farther] <= std::max(options.promote_ratio * misses[nearer], limit)) continue;
    promoted.push_back({static_cast<Index>(s), static_cast<StrokeGroup>(nearer)});
  }
  return promoted;
}

std::vector<Vec3> propagate(const PerspectiveDrawing& drawing, const DrawingVertices& vertices,
                            const CameraEstimate& camera, std::span<const StrokeGroup> groups, Index from,
                            double first_depth) {
  const TiedVertices tied = tied_vertices(drawing, vertices, camera, groups);
  std::vector<Vec3> positions(vertices.vertices.size(), Vec3::Constant(std::numeric_limits<double>::quiet_NaN()));
  positions[from] = first_depth * tied.seen.ray(from);
  std::deque<Index> queue{from};
  while (!queue.empty()) {
    const Index a = queue.front();
    queue.pop_front();
    for (const StrokeEnd& end : vertices.vertices[a].ends) {
      const Index b = vertices.of_stroke[end.stroke][end.at_end ? 0 : 1];
      if (groups[end.stroke] == StrokeGroup::Unknown || b == no_index || positions[b].allFinite()) continue;
      const Vec3 ray = tied.seen.ray(b);
      const int axis = passed_axis(groups[end.stroke], ray);
      positions[b] = positions[a][axis] / ray[axis] * ray;
      if (positions[b].allFinite()) queue.push_back(b);
    }
  }
  return positions;
}

}  // namespace croquis

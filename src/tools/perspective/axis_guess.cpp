// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/tools/perspective/axis_guess.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include <Eigen/Dense>

namespace croquis {
namespace {

constexpr double angle_of_one_degree = std::numbers::pi / 180;

/// A line of the hand points this well to a vanishing point that is known …
constexpr double solved_limit = 7 * angle_of_one_degree;
/// … or only estimated from a few lines …
constexpr double estimated_limit = 15 * angle_of_one_degree;
/// … and worse by what its ends may miss, where it is short.
constexpr double end_miss_px = 3;
constexpr double most_limit = 20 * angle_of_one_degree;
/// One that points to one of them so many times better than to any other one was meant for it up to most_limit.
constexpr double clearly_better = 2.5;

/// Without a better guess: the first lines of a hand may have given a camera that is far off.
constexpr double farthest_limit = 35 * angle_of_one_degree;

/// From upright, up to which a line is z before anything is known.
constexpr double upright_limit = 20 * angle_of_one_degree;

/// Vertices have the same coordinate when it differs by less than this share of the network's size.
constexpr double same_share = 1e-9;

Vec3 meeting_place(const PerspectiveDrawing& drawing, int axis) {
  // Hartley's normalisation: about the sheet's centre, by its diagonal.
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  for (const PerspectiveStroke& stroke : drawing.strokes) {
    if (!is_parallel(stroke.group) || axis_of(stroke.group) != axis) continue;
    const Vec2 a = (stroke.start() - drawing.centre()) / drawing.diagonal();
    const Vec2 way = (stroke.end() - stroke.start()) / drawing.diagonal();
    if (way.norm() == 0) continue;
    const Vec2 normal = left_of(way).normalized();
    const Vec3 line(normal.x(), normal.y(), -normal.dot(a));
    sum += way.squaredNorm() * line * line.transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(sum);
  const Vec3 place = solver.eigenvectors().col(0);
  Vec3 result;
  result << drawing.diagonal() * place.head<2>() + place.z() * drawing.centre(), place.z();
  return result;
}

std::optional<Vec3> estimated_vanishing_point(const PerspectiveDrawing& drawing, int axis) {
  std::size_t count = 0;
  Vec2 only = Vec2::Zero();
  for (const PerspectiveStroke& stroke : drawing.strokes) {
    if (!is_parallel(stroke.group) || axis_of(stroke.group) != axis) continue;
    if (stroke.end() == stroke.start()) continue;
    only = stroke.end() - stroke.start();
    ++count;
  }
  if (count == 0) return std::nullopt;
  if (count == 1) return Vec3(only.x(), only.y(), 0);
  return meeting_place(drawing, axis);
}

/// For an axis of which no line was drawn yet.
int axis_by_slope(const Vec2& direction) {
  const double from_upright = std::atan2(std::abs(direction.x()), std::abs(direction.y()));
  if (from_upright < upright_limit) return 2;
  return direction.x() * direction.y() > 0 ? 0 : 1;  // y goes down: what falls to the right has a product above 0
}

std::optional<Index> vertex_at(const SolvedDrawing& solved, const Vec2& place, double reach) {
  std::optional<Index> nearest;
  for (std::size_t i = 0; i < solved.network.vertices.size(); ++i) {
    const Vec3& vertex = solved.network.vertices[i];
    if (!(solved.camera.depth(vertex) > 0)) continue;
    const double distance = (solved.camera.project(vertex) - place).norm();
    if (distance > reach) continue;
    reach = distance;
    nearest = static_cast<Index>(i);
  }
  return nearest;
}

/// Radians, and the axis; the best first.
using AxisAngle = std::pair<double, int>;

std::vector<AxisAngle> angles_to(const std::array<std::optional<Vec3>, 3>& points, const Vec2& from, const Vec2& to) {
  std::vector<AxisAngle> angles;
  for (int axis = 0; axis < 3; ++axis) {
    const auto& point = points[static_cast<std::size_t>(axis)];
    if (point) angles.emplace_back(angle_to(*point, (from + to) / 2, to - from), axis);
  }
  std::ranges::sort(angles);
  return angles;
}

double extent_of(const CurveNetwork& network) {
  Vec3 low = network.vertices.front(), high = low;
  for (const Vec3& vertex : network.vertices) {
    low = low.cwiseMin(vertex);
    high = high.cwiseMax(vertex);
  }
  return (high - low).norm();
}

StrokeGroup plane_group(int axis) { return static_cast<StrokeGroup>(3 + axis); }

}  // namespace

std::array<std::optional<Vec3>, 3> seen_vanishing_points(const PerspectiveDrawing& drawing,
                                                         const SolvedDrawing* solved) {
  std::array<std::optional<Vec3>, 3> points;
  for (int axis = 0; axis < 3; ++axis) {
    const auto i = static_cast<std::size_t>(axis);
    points[i] = solved ? std::optional(solved->vanishing_points[i]) : estimated_vanishing_point(drawing, axis);
  }
  return points;
}

double angle_to(const Vec3& vanishing_point, const Vec2& place, const Vec2& direction) {
  const Vec2 wanted = vanishing_point.head<2>() - vanishing_point.z() * place;
  return std::atan2(std::abs(cross(wanted, direction)), std::abs(wanted.dot(direction)));
}

std::optional<StrokeGroup> guess_axis(const PerspectiveDrawing& drawing, const SolvedDrawing* solved, const Vec2& from,
                                      const Vec2& to) {
  const Vec2 direction = to - from;
  if (direction.norm() == 0) return std::nullopt;
  const auto points = seen_vanishing_points(drawing, solved);
  const std::vector<AxisAngle> angles = angles_to(points, from, to);
  const double limit = (solved ? solved_limit : estimated_limit) + std::atan2(end_miss_px, direction.norm());
  const bool clear = angles.size() == 3 && angles[1].first > clearly_better * angles[0].first;
  if (!angles.empty() && angles[0].first < (clear ? most_limit : std::min(limit, most_limit)))
    return static_cast<StrokeGroup>(angles[0].second);
  if (solved) return std::nullopt;
  const int sloped = axis_by_slope(direction);
  if (!points[static_cast<std::size_t>(sloped)]) return static_cast<StrokeGroup>(sloped);
  for (const int axis : {0, 1}) {
    if (sloped != 2 && !points[static_cast<std::size_t>(axis)]) return static_cast<StrokeGroup>(axis);
  }
  return std::nullopt;
}

std::optional<StrokeGroup> nearest_axis(const PerspectiveDrawing& drawing, const SolvedDrawing* solved,
                                        const Vec2& from, const Vec2& to) {
  const std::vector<AxisAngle> angles = angles_to(seen_vanishing_points(drawing, solved), from, to);
  if (angles.empty() || angles[0].first > farthest_limit) return std::nullopt;
  return static_cast<StrokeGroup>(angles[0].second);
}

StrokeGroup guess_plane(const SolvedDrawing* solved, const Vec2& from, const Vec2& to, double reach,
                        StrokeGroup preferred) {
  if (solved == nullptr) return preferred;
  const auto start = vertex_at(*solved, from, reach);
  const auto end = vertex_at(*solved, to, reach);
  if (!start || !end || *start == *end) return preferred;
  const Vec3& a = solved->network.vertices[*start];
  const Vec3& b = solved->network.vertices[*end];
  const double limit = same_share * extent_of(solved->network);
  const Vec3 sight = ((a + b) / 2 - solved->camera.eye).normalized();
  StrokeGroup best = preferred;
  double frontal = -1;
  for (int axis = 0; axis < 3; ++axis) {
    if (std::abs(a[axis] - b[axis]) > limit) continue;
    const StrokeGroup group = plane_group(axis);
    if (group == preferred) return group;
    if (std::abs(sight[axis]) > frontal) std::tie(best, frontal) = std::pair(group, std::abs(sight[axis]));
  }
  return best;
}

}  // namespace croquis

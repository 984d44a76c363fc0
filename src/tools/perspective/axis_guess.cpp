// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/tools/perspective/axis_guess.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include <Eigen/Dense>

#include "croquis/tools/perspective/drawing_edit.h"

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

/// Of a curve at its end, from the axis that it is tangent to: ends of the hand's curves are worse than its lines.
constexpr double tangent_limit = 18 * angle_of_one_degree;
/// From a line that the curve goes on from: its end was moved to that line's end, which turns its direction.
constexpr double continued_limit = 40 * angle_of_one_degree;
/// The sum of both ends' angles, against that of the next best two axes.
constexpr double clearly_better_sum = 1.6;

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

/// Directions of a curve at its ends, each with the place it is taken at.
struct EndDirection {
  Vec2 from, to;
};

std::vector<EndDirection> end_directions(const StrokeShape& shape) {
  std::vector<EndDirection> ends;
  if (shape.straight) return ends;
  const PictureCubic &first = shape.pieces.front(), &last = shape.pieces.back();
  for (const EndDirection& end : {EndDirection{first[0], first[1]}, EndDirection{last[2], last[3]}}) {
    if (end.from != end.to) ends.push_back(end);
  }
  return ends;
}

/// The two axes that a curve's ends run along, where it begins along one and ends along another one: those that both
/// ends together fit clearly better than any other two.
std::vector<int> both_end_axes(const std::array<std::optional<Vec3>, 3>& points,
                               const std::vector<EndDirection>& ends) {
  if (ends.size() != 2 || !points[0] || !points[1] || !points[2]) return {};
  const auto angle = [&](const EndDirection& end, int axis) {
    const Vec3& point = *points[static_cast<std::size_t>(axis)];
    return angle_to(point, (end.from + end.to) / 2, end.to - end.from);
  };
  std::array<AxisAngle, 3> sums;  // of the planes, by their normals
  for (int normal = 0; normal < 3; ++normal) {
    const int a = (normal + 1) % 3, b = (normal + 2) % 3;
    const double sum = std::min(angle(ends[0], a) + angle(ends[1], b), angle(ends[0], b) + angle(ends[1], a));
    sums[static_cast<std::size_t>(normal)] = {sum, normal};
  }
  std::ranges::sort(sums);
  if (sums[0].first > 2 * tangent_limit || sums[1].first < clearly_better_sum * sums[0].first) return {};
  return {(sums[0].second + 1) % 3, (sums[0].second + 2) % 3};
}

/// The axis of the line that a curve goes on from at its end, where there is one.
std::optional<int> axis_continued(const PerspectiveDrawing& drawing, const EndDirection& end) {
  std::optional<int> axis;
  double best = continued_limit;
  for (const PerspectiveStroke& stroke : drawing.strokes) {
    const auto meets = [&](const Vec2& place) { return place == end.from || place == end.to; };
    if (!is_parallel(stroke.group) || !has_vertices(stroke) || (!meets(stroke.start()) && !meets(stroke.end())))
      continue;
    const Vec2 line = stroke.end() - stroke.start(), way = end.to - end.from;
    const double angle = std::atan2(std::abs(cross(line, way)), std::abs(line.dot(way)));
    if (angle >= best) continue;
    best = angle;
    axis = axis_of(stroke.group);
  }
  return axis;
}

/// The axes that a curve runs along at its ends: none, one, or two that differ.
std::vector<int> end_axes(const PerspectiveDrawing& drawing, const std::array<std::optional<Vec3>, 3>& points,
                          const StrokeShape& shape) {
  const std::vector<EndDirection> ends = end_directions(shape);
  std::vector<int> axes;
  for (const EndDirection& end : ends) {
    const auto axis = axis_continued(drawing, end);
    if (axis && std::ranges::find(axes, *axis) == axes.end()) axes.push_back(*axis);
  }
  if (axes.size() == 2) return axes;
  if (std::vector<int> both = both_end_axes(points, ends); !both.empty()) return both;
  axes.clear();
  for (const EndDirection& end : ends) {
    if (const auto axis = axis_continued(drawing, end)) {
      if (std::ranges::find(axes, *axis) == axes.end()) axes.push_back(*axis);
      continue;
    }
    const std::vector<AxisAngle> angles = angles_to(points, end.from, end.to);
    const bool clear = angles.size() < 2 || angles[1].first > clearly_better * angles[0].first;
    if (angles.empty() || angles[0].first > tangent_limit || !clear) continue;
    if (std::ranges::find(axes, angles[0].second) == axes.end()) axes.push_back(angles[0].second);
  }
  return axes;
}

/// By the axis at right angles.
using Planes = std::array<bool, 3>;

/// In which both vertices lie.
Planes shared_planes(const CurveNetwork& network, Index a, Index b) {
  const Vec3 way = network.vertices[a] - network.vertices[b];
  const double limit = same_share * extent_of(network);
  return {std::abs(way.x()) <= limit, std::abs(way.y()) <= limit, std::abs(way.z()) <= limit};
}

/// Of the planes that may be, the preferred one, else the most frontal. Unknown: nothing separates them.
StrokeGroup best_plane(const Planes& may, const Vec3& sight, StrokeGroup preferred) {
  if (preferred != StrokeGroup::Unknown && may[static_cast<std::size_t>(axis_of(preferred))]) return preferred;
  StrokeGroup best = StrokeGroup::Unknown;
  double frontal = std::ranges::count(may, true) == 1 ? -1 : 0;
  for (int axis = 0; axis < 3; ++axis) {
    if (!may[static_cast<std::size_t>(axis)] || std::abs(sight[axis]) <= frontal) continue;
    std::tie(best, frontal) = std::pair(plane_group(axis), std::abs(sight[axis]));
  }
  return best;
}

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

StrokeGroup guess_plane(const PerspectiveDrawing& drawing, const SolvedDrawing* solved, const StrokeShape& shape,
                        double reach, StrokeGroup preferred) {
  const auto start = solved ? vertex_at(*solved, shape.start(), reach) : std::nullopt;
  const auto end = solved ? vertex_at(*solved, shape.end(), reach) : std::nullopt;
  Vec3 sight = Vec3::Zero();
  if (const auto known = start ? start : end) sight = solved->network.vertices[*known] - solved->camera.eye;
  Planes shared = {false, false, false}, spanned = {true, true, true};
  if (start && end && *start != *end) shared = shared_planes(solved->network, *start, *end);
  const std::vector<int> axes = end_axes(drawing, seen_vanishing_points(drawing, solved), shape);
  for (const int axis : axes) spanned[static_cast<std::size_t>(axis)] = false;
  Planes may = shared;
  for (std::size_t k = 0; k < 3; ++k) may[k] = shared[k] && spanned[k];
  // Vertices of pieces that nothing ties together share no coordinate, though they are meant to.
  if (std::ranges::count(may, true) == 0) may = std::ranges::count(shared, true) > 0 ? shared : spanned;
  if (axes.empty() && std::ranges::count(shared, true) == 0) return preferred;
  return best_plane(may, sight, preferred);
}

}  // namespace croquis

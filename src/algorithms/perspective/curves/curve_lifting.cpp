// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/perspective/curve_lifting.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "algorithms/perspective/camera/sheet_frame.h"
#include "algorithms/perspective/curves/rational_lift.h"
#include "algorithms/perspective/solid/plane_axes.h"
#include "algorithms/perspective/stroke_words.h"

namespace croquis {
namespace {

/// Into the piece from its start, or from its end.
Vec2 leaving_direction(const PictureCubic& piece, bool from_end) {
  const Vec2& origin = from_end ? piece[3] : piece[0];
  for (std::size_t i = 1; i < 4; ++i) {
    const Vec2 step = piece[from_end ? 3 - i : i] - origin;
    if (step.norm() > 0) return step;
  }
  return Vec2::Zero();
}

double turn_between(const PictureCubic& before, const PictureCubic& after) {
  const Vec2 arriving = -leaving_direction(before, true);
  const Vec2 leaving = leaving_direction(after, false);
  return std::atan2(std::abs(cross(arriving, leaving)), arriving.dot(leaving));
}

class Lifting {
 public:
  Lifting(const PerspectiveDrawing& drawing, const DrawingVertices& vertices, const VertexCoordinates& coordinates,
          const CurveOptions& options)
      : drawing_(drawing), vertices_(vertices), coordinates_(coordinates), options_(options) {}

  LiftedCurves run() {
    std::vector<Index> behind;
    std::vector<Index> strokes;
    for (Index s = 0; s < drawing_.strokes.size(); ++s) {
      if (has_ends(s)) strokes.push_back(s);
    }
    std::vector<std::vector<std::vector<RationalCubic>>> lifted;
    std::vector<Index> kept;
    for (const Index s : strokes) {
      auto pieces = lift(s);
      if (pieces) {
        kept.push_back(s);
        lifted.push_back(std::move(*pieces));
      } else {
        behind.push_back(s);
      }
    }
    add_vertices(kept);
    for (std::size_t i = 0; i < kept.size(); ++i) add_curves(kept[i], lifted[i]);
    warn(behind);
    return std::move(result_);
  }

 private:
  bool has_ends(Index s) {
    const std::array<Index, 2>& ends = vertices_.of_stroke[s];
    if (drawing_.strokes[s].role != StrokeRole::Edge) return false;
    const bool lifted =
        ends[0] != no_index && ends[1] != no_index && coordinates_.in_front[ends[0]] && coordinates_.in_front[ends[1]];
    if (!lifted) result_.flat.push_back(s);
    return lifted;
  }

  std::optional<std::vector<std::vector<RationalCubic>>> lift(Index s) const {
    const std::array<Index, 2>& ends = vertices_.of_stroke[s];
    return lifted_stroke(drawing_.strokes[s], drawing_.strokes[s].group, coordinates_.positions[ends[0]],
                         coordinates_.positions[ends[1]], coordinates_.camera);
  }

  void add_vertices(const std::vector<Index>& strokes) {
    std::vector<bool> used(vertices_.vertices.size(), false);
    for (const Index s : strokes) {
      for (const Index v : vertices_.of_stroke[s]) used[v] = true;
    }
    result_.vertex.assign(used.size(), no_index);
    for (Index v = 0; v < used.size(); ++v) {
      if (used[v]) result_.vertex[v] = add_vertex(coordinates_.positions[v]);
    }
  }

  Index add_vertex(const Vec3& position) {
    result_.network.vertices.push_back(position);
    return static_cast<Index>(result_.network.vertices.size() - 1);
  }

  /// One curve, or one for each part between corners.
  void add_curves(Index s, const std::vector<std::vector<RationalCubic>>& pieces) {
    const PerspectiveStroke& stroke = drawing_.strokes[s];
    std::vector<std::size_t> begins{0};
    for (std::size_t i = 1; i < pieces.size(); ++i) {
      if (turn_between(stroke.pieces[i - 1], stroke.pieces[i]) > options_.joint_angle) begins.push_back(i);
    }
    Index at = result_.vertex[vertices_.of_stroke[s][0]];
    for (std::size_t part = 0; part < begins.size(); ++part) {
      const bool last = part + 1 == begins.size();
      const std::size_t end = last ? pieces.size() : begins[part + 1];
      NetworkCurve curve;
      curve.id = begins.size() == 1 ? stroke.id : stroke.id + "/" + std::to_string(part + 1);
      for (std::size_t i = begins[part]; i < end; ++i) {
        curve.pieces.insert(curve.pieces.end(), pieces[i].begin(), pieces[i].end());
      }
      curve.start = at;
      curve.end = last ? result_.vertex[vertices_.of_stroke[s][1]] : add_vertex(curve.pieces.back().points[3]);
      at = curve.end;
      curve.straight = end == begins[part] + 1 && is_straight(stroke.pieces[begins[part]]);
      if (curve.straight) {
        curve.pieces = {straight_cubic(curve.pieces.front().points[0], curve.pieces.back().points[3])};
      }
      result_.network.curves.push_back(std::move(curve));
      result_.stroke.push_back(s);
    }
  }

  void warn(const std::vector<Index>& behind) {
    for (const Subject& subject : stroke_subjects(drawing_, behind)) {
      result_.warnings.push_back(make_warning(Category::Geometry, "CURVE_BEHIND_HORIZON",
                                              "Stroke " + subject.id +
                                                  " crosses the horizon of the plane that its group says, and stays in "
                                                  "the picture: check its group.",
                                              {subject}));
    }
    result_.flat.insert(result_.flat.end(), behind.begin(), behind.end());
    std::sort(result_.flat.begin(), result_.flat.end());
  }

  const PerspectiveDrawing& drawing_;
  const DrawingVertices& vertices_;
  const VertexCoordinates& coordinates_;
  const CurveOptions& options_;
  LiftedCurves result_;
};

constexpr int fit_rounds = 30;
constexpr std::size_t fit_samples = 33;

struct EndDirections {
  Vec3 start = Vec3::Zero();  // unit, into the curve
  Vec3 end = Vec3::Zero();
};

EndDirections end_directions(const RationalCubic& curve) {
  const NetworkCurve alone{{}, no_index, no_index, {curve}};
  return {alone.direction_from_start(), alone.direction_from_end()};
}

std::array<double, 4> bernstein(double t) {
  const double s = 1 - t;
  return {s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t};
}

class HandleFit {
 public:
  HandleFit(const RationalCubic& exact, const EndDirections& directions)
      : exact_(exact), directions_(directions), start_(exact.points[0]), end_(exact.points[3]) {
    for (std::size_t i = 0; i < fit_samples; ++i) {
      const double t = static_cast<double>(i) / (fit_samples - 1);
      samples_[i] = exact.at(t);
      parameters_[i] = t;
    }
  }

  RationalCubic run() {
    RationalCubic cubic = least_squares();
    for (int round = 0; round < fit_rounds; ++round) {
      move_to_foot_points(cubic);
      cubic = least_squares();
    }
    move_to_foot_points(cubic);
    return cubic;
  }

  void measure(const RationalCubic& cubic, const Camera& camera, FittedCurve& fitted) const {
    for (std::size_t i = 0; i < fit_samples; ++i) {
      const Vec3 point = cubic.at(parameters_[i]);
      fitted.error = std::max(fitted.error, (point - samples_[i]).norm());
      fitted.distance = std::max(fitted.distance, (camera.project(point) - camera.project(samples_[i])).norm());
    }
  }

 private:
  /// Handle lengths for the parameters so far.
  RationalCubic least_squares() const {
    Eigen::Matrix2d matrix = Eigen::Matrix2d::Zero();
    Vec2 right = Vec2::Zero();
    for (std::size_t i = 0; i < fit_samples; ++i) {
      const std::array<double, 4> b = bernstein(parameters_[i]);
      const Vec3 rest = samples_[i] - (b[0] + b[1]) * start_ - (b[2] + b[3]) * end_;
      Eigen::Matrix<double, 3, 2> columns;
      columns << b[1] * directions_.start, b[2] * directions_.end;
      matrix += columns.transpose() * columns;
      right += columns.transpose() * rest;
    }
    Vec2 lengths = matrix.fullPivLu().solve(right);
    // Handles that would turn back say that the samples are nearly on a line.
    const double third = (end_ - start_).norm() / 3;
    for (int i = 0; i < 2; ++i) {
      if (!(lengths[i] > 0)) lengths[i] = third;
    }
    return {{start_, start_ + lengths[0] * directions_.start, end_ + lengths[1] * directions_.end, end_}};
  }

  void move_to_foot_points(const RationalCubic& cubic) {
    for (std::size_t i = 1; i + 1 < fit_samples; ++i) {
      double& t = parameters_[i];
      const Vec3 away = cubic.at(t) - samples_[i];
      const Vec3 first = cubic.derivative(t);
      const double s = 1 - t;
      const auto& p = cubic.points;
      const Vec3 second = 6 * (s * (p[2] - 2 * p[1] + p[0]) + t * (p[3] - 2 * p[2] + p[1]));
      const double slope = first.squaredNorm() + away.dot(second);
      if (slope > 0) t = std::clamp(t - away.dot(first) / slope, 0.0, 1.0);
    }
  }

  const RationalCubic& exact_;
  EndDirections directions_;
  Vec3 start_, end_;
  std::array<Vec3, fit_samples> samples_;
  std::array<double, fit_samples> parameters_{};
};

/// What has the same coordinate at all points of the exact curve keeps it bit by bit.
void keep_planes(const RationalCubic& exact, RationalCubic& cubic) {
  for (int k = 0; k < 3; ++k) {
    const double* level = common_level({&exact, 1}, k);
    if (level == nullptr) continue;
    for (Vec3& point : cubic.points) point[k] = *level;
  }
}

RationalCubic fitted_once(const RationalCubic& exact, const EndDirections& directions, const Camera& camera,
                          FittedCurve& fitted) {
  HandleFit fit(exact, directions);
  RationalCubic cubic = fit.run();
  keep_planes(exact, cubic);
  fit.measure(cubic, camera, fitted);
  return cubic;
}

}  // namespace

LiftedCurves lift_curves(const PerspectiveDrawing& drawing, const DrawingVertices& vertices,
                         const VertexCoordinates& coordinates, const CurveOptions& options) {
  return Lifting(drawing, vertices, coordinates, options).run();
}

std::vector<FittedCurve> fit_curves(const CurveNetwork& network, const Camera& camera, double unit,
                                    const CurveOptions& options) {
  Eigen::AlignedBox3d box;
  for (const Vec3& vertex : network.vertices) box.extend(vertex);
  const double most_error = options.fit_error * (box.isEmpty() ? 0 : box.diagonal().norm());
  std::vector<FittedCurve> all;
  for (const NetworkCurve& curve : network.curves) {
    FittedCurve fitted;
    for (const RationalCubic& piece : curve.pieces) {
      FittedCurve part = fit_polynomial(piece, camera, options.fit_distance * unit, most_error);
      fitted.pieces.insert(fitted.pieces.end(), part.pieces.begin(), part.pieces.end());
      fitted.distance = std::max(fitted.distance, part.distance);
      fitted.error = std::max(fitted.error, part.error);
    }
    all.push_back(std::move(fitted));
  }
  return all;
}

FittedCurve fit_polynomial(const RationalCubic& exact, const Camera& camera, double most_distance, double most_error) {
  if (exact.is_polynomial()) {
    FittedCurve same;
    same.pieces = {exact};
    same.pieces[0].weights = {1, 1, 1, 1};
    return same;
  }
  const EndDirections directions = end_directions(exact);
  FittedCurve one;
  one.pieces = {fitted_once(exact, directions, camera, one)};
  if (one.distance <= most_distance || one.error <= most_error) return one;
  auto [first, second] = exact.split(0.5);
  keep_planes(exact, first);
  keep_planes(exact, second);
  const Vec3 along = exact.derivative(0.5).normalized();
  FittedCurve two;
  two.pieces = {fitted_once(first, {directions.start, -along}, camera, two),
                fitted_once(second, {along, directions.end}, camera, two)};
  return two;
}

}  // namespace croquis

// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/geometry/bezier_fit.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

namespace croquis {
namespace {

constexpr int fit_rounds = 16;          // of solving and moving parameters
constexpr int plain_rounds = 2;         // in which distances along the curve count fully, as long as it is far off
constexpr int most_idle = 3;            // rounds without gain
constexpr double least_gain = 0.95;     // × the distance before
constexpr double along_weight = 1e-2;   // of distances along the curve in later rounds
constexpr int settling_steps = 4;       // of parameters on the curve that was chosen
constexpr double hold = 1e-9;           // pulls what the points don't determine towards the lower degree's curve
constexpr double least_handle = 1e-2;   // × chord / degree: shorter ones, or backward, are kinks
constexpr double straight_turn = 1e-3;  // radians: a given direction that a straight curve may miss

using Control = std::vector<Vec3>;

/// Bernstein polynomials of that degree.
Eigen::VectorXd bernstein(std::size_t degree, double t) {
  Eigen::VectorXd values = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(degree) + 1);
  values[0] = 1;
  for (Eigen::Index n = 1; n <= static_cast<Eigen::Index>(degree); ++n) {
    for (Eigen::Index j = n; j > 0; --j) values[j] = (1 - t) * values[j] + t * values[j - 1];
    values[0] *= 1 - t;
  }
  return values;
}

struct CurvePlace {
  Vec3 point, first, second;  ///< and derivatives
};

/// By de Casteljau's scheme; control points may be few.
CurvePlace place_on(const Control& control, double t) {
  Control p = control;
  const std::size_t n = p.size() - 1;
  CurvePlace place{Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
  const double degree = static_cast<double>(n);
  for (std::size_t left = n; left > 0; --left) {
    if (left == 2) place.second = degree * (degree - 1) * (p[2] - 2 * p[1] + p[0]);
    if (left == 1) place.first = degree * (p[1] - p[0]);
    for (std::size_t j = 0; j < left; ++j) p[j] += t * (p[j + 1] - p[j]);
  }
  place.point = p[0];
  return place;
}

Control elevated(const Control& control) {
  const std::size_t n = control.size();
  Control result{control.front()};
  for (std::size_t j = 1; j < n; ++j) {
    const double part = static_cast<double>(j) / static_cast<double>(n);
    result.push_back(part * control[j - 1] + (1 - part) * control[j]);
  }
  result.push_back(control.back());
  return result;
}

/// One curve for a whole row of points.
class RowFit {
 public:
  RowFit(std::span<const Vec3> points, const BezierFitOptions& options) : points_(points), options_(options) {
    parameters_.push_back(0);
    for (std::size_t i = 1; i < points.size(); ++i)
      parameters_.push_back(parameters_.back() + (points[i] - points[i - 1]).norm());
    for (double& t : parameters_) t /= parameters_.back();
  }

  /// The lowest degree that keeps the tolerance, or else the nearest curve.
  FittedBezier run() const {
    FittedBezier best = nearest_curve();
    best.parameters = parameters_;
    for (int step = 0; step < settling_steps; ++step)
      best.parameters = nearest_parameters(best.control, std::move(best.parameters));
    return best;
  }

  /// Where to divide a row: the farthest point of the row's middle half.
  std::size_t worst_within(const FittedBezier& curve) const {
    const std::size_t n = points_.size();
    const std::vector<double>& at = curve.parameters;
    std::size_t worst = n / 2;
    double greatest = -1;
    for (std::size_t i = std::max<std::size_t>(1, n / 4); i < n - std::max<std::size_t>(1, n / 4); ++i) {
      const double distance = (place_on(curve.control, at[i]).point - points_[i]).norm();
      if (distance > greatest) worst = i;
      greatest = std::max(greatest, distance);
    }
    return worst;
  }

 private:
  FittedBezier nearest_curve() const {
    FittedBezier best{0, points_.size() - 1, {points_.front(), points_.back()}, 0, {}};
    best.distance = greatest_distance(best.control, parameters_);
    if (best.distance <= options_.tolerance && directions_suit_line()) return best;
    Control control = first_guess();
    bool has_curve = false;
    for (std::size_t degree = control.size() - 1; degree <= most_degree(); ++degree) {
      while (control.size() <= degree) control = elevated(control);
      double distance = 0;
      const Control fitted = fit(control, distance);
      if (!is_usable(fitted)) continue;
      control = fitted;
      if (has_curve && distance >= best.distance) continue;
      has_curve = true;
      best.control = fitted;
      best.distance = distance;
      if (distance <= options_.tolerance) break;
    }
    if (!has_curve) best.control = first_guess();
    if (!has_curve) best.distance = greatest_distance(best.control, parameters_);
    return best;
  }

  Vec3 chord() const { return points_.back() - points_.front(); }
  bool has_directions() const { return options_.start_direction || options_.end_direction; }

  bool directions_suit_line() const {
    if (chord().norm() == 0) return false;
    const auto suits = [&](const std::optional<Vec3>& direction) {
      return !direction || angle_between(*direction, chord()) <= straight_turn;
    };
    return suits(options_.start_direction) && suits(options_.end_direction);
  }

  std::size_t most_degree() const {
    const std::size_t n = points_.size();
    const std::size_t determined = n <= 4 ? n - 1 : 3 + (n - 4) / 2;
    return std::clamp<std::size_t>(determined, has_directions() ? 3 : 1, options_.most_degree);
  }

  /// Without directions straight, of degree 2; with them a cubic that has them.
  Control first_guess() const {
    const Vec3 &a = points_.front(), &b = points_.back();
    if (!has_directions()) return elevated({a, b});
    double length = 0;
    for (std::size_t i = 1; i < points_.size(); ++i) length += (points_[i] - points_[i - 1]).norm();
    const Vec3 straight = chord() / 3;
    const Vec3 out = options_.start_direction ? Vec3(length / 3 * *options_.start_direction) : straight;
    const Vec3 in = options_.end_direction ? Vec3(length / 3 * *options_.end_direction) : straight;
    return {a, a + out, b - in, b};
  }

  bool is_usable(const Control& control) const {
    const std::size_t n = control.size() - 1;
    const double least = least_handle * chord().norm() / static_cast<double>(n);
    const bool starts = !options_.start_direction || (control[1] - control[0]).dot(*options_.start_direction) >= least;
    const bool ends = !options_.end_direction || (control[n] - control[n - 1]).dot(*options_.end_direction) >= least;
    return starts && ends;
  }

  double greatest_distance(const Control& control, const std::vector<double>& at) const {
    const std::vector<double> nearest = nearest_parameters(control, at);
    double greatest = 0;
    for (std::size_t i = 0; i < points_.size(); ++i)
      greatest = std::max(greatest, (place_on(control, nearest[i]).point - points_[i]).norm());
    return greatest;
  }

  /// One Newton step for each inner point, where it comes nearer.
  std::vector<double> nearest_parameters(const Control& control, std::vector<double> at) const {
    for (std::size_t i = 1; i + 1 < at.size(); ++i) {
      const CurvePlace place = place_on(control, at[i]);
      const Vec3 offset = place.point - points_[i];
      const double slope = place.first.squaredNorm() + offset.dot(place.second);
      if (!(slope > 0)) continue;
      const double moved = std::clamp(at[i] - offset.dot(place.first) / slope, 0.0, 1.0);
      if ((place_on(control, moved).point - points_[i]).squaredNorm() < offset.squaredNorm()) at[i] = moved;
    }
    return at;
  }

  /// Each column of what may change: a control point's coordinate, or how far a handle reaches.
  Eigen::MatrixXd freedoms(std::size_t degree) const {
    const auto rows = static_cast<Eigen::Index>(3 * (degree + 1));
    Eigen::MatrixXd columns = Eigen::MatrixXd::Zero(rows, rows);
    Eigen::Index count = 0;
    for (std::size_t j = 1; j < degree; ++j) {
      const auto row = static_cast<Eigen::Index>(3 * j);
      const auto& direction = j == 1            ? options_.start_direction
                              : j + 1 == degree ? options_.end_direction
                                                : std::optional<Vec3>();
      if (direction) {
        columns.col(count++).segment<3>(row) = *direction;
      } else {
        for (Eigen::Index axis = 0; axis < 3; ++axis) columns(row + axis, count++) = 1;
      }
    }
    return columns.leftCols(count);
  }

  /// The next curve, by least squares. Distances along it count little, so that parameters needn't follow step by step
  /// (tangent distance minimization: Wang, Pottmann and Liu 2006, section 3.2).
  Control solved(const Control& control, const std::vector<double>& at, double along) const {
    const Eigen::MatrixXd free = freedoms(control.size() - 1);
    const auto count = static_cast<Eigen::Index>(control.size());
    Eigen::MatrixXd all = hold * static_cast<double>(at.size()) * Eigen::MatrixXd::Identity(3 * count, 3 * count);
    Eigen::VectorXd wanted = Eigen::VectorXd::Zero(3 * count);
    for (std::size_t i = 1; i + 1 < at.size(); ++i) {
      const CurvePlace place = place_on(control, at[i]);
      const Vec3 tangent = unit_or_zero(place.first);
      const Eigen::Matrix3d across = Eigen::Matrix3d::Identity() - (1 - along) * tangent * tangent.transpose();
      const Eigen::VectorXd values = bernstein(control.size() - 1, at[i]);
      const Vec3 miss = across * (points_[i] - place.point);
      for (Eigen::Index a = 0; a < count; ++a) {
        wanted.segment<3>(3 * a) += values[a] * miss;
        for (Eigen::Index b = 0; b < count; ++b) all.block<3, 3>(3 * a, 3 * b) += values[a] * values[b] * across;
      }
    }
    const Eigen::VectorXd moves = free * (free.transpose() * all * free).ldlt().solve(free.transpose() * wanted);
    Control result = control;
    for (std::size_t j = 1; j + 1 < result.size(); ++j) result[j] += moves.segment<3>(static_cast<Eigen::Index>(3 * j));
    return result;
  }

  Control fit(Control control, double& distance) const {
    std::vector<double> at = parameters_;
    Control best = control;
    distance = greatest_distance(control, at);
    int idle = 0;
    for (int round = 0; round < fit_rounds && idle < most_idle; ++round) {
      control = solved(control, at, round < plain_rounds ? 1 : along_weight);
      for (int step = 0; step < 2; ++step) at = nearest_parameters(control, at);
      const double reached = greatest_distance(control, at);
      idle = reached < least_gain * distance ? 0 : idle + 1;
      if (reached >= distance) continue;
      distance = reached;
      best = control;
      if (distance <= options_.tolerance / 4) break;
    }
    return best;
  }

  std::span<const Vec3> points_;
  const BezierFitOptions& options_;
  std::vector<double> parameters_;
};

void fit_rows(std::span<const Vec3> points, std::size_t offset, const BezierFitOptions& options,
              std::vector<FittedBezier>& result) {
  const RowFit fit(points, options);
  FittedBezier curve = fit.run();
  if (!options.divide || curve.distance <= options.tolerance || points.size() < 3) {
    curve.first += offset;
    curve.last += offset;
    result.push_back(std::move(curve));
    return;
  }
  const std::size_t at = fit.worst_within(curve);
  const Vec3 direction = row_direction(points, at, 4 * options.tolerance);
  BezierFitOptions before = options, after = options;
  if (direction != Vec3::Zero()) before.end_direction = after.start_direction = direction;
  fit_rows(points.subspan(0, at + 1), offset, before, result);
  fit_rows(points.subspan(at), offset + at, after, result);
}

/// The point at least `reach` of arc length away, and the length up to there.
std::pair<std::size_t, double> walk(std::span<const Vec3> points, std::size_t from, int step,
                                    std::pair<double, bool> reach_closed) {
  const auto [reach, closed] = reach_closed;
  const std::size_t n = points.size();
  double length = 0;
  std::size_t at = from;
  for (std::size_t taken = 0; taken < n / 2 && (taken == 0 || length < reach); ++taken) {
    if (!closed && (step > 0 ? at + 1 == n : at == 0)) break;
    const std::size_t next = step > 0 ? (at + 1) % n : (at + n - 1) % n;
    length += (points[next] - points[at]).norm();
    at = next;
  }
  return {at, length};
}

}  // namespace

std::vector<FittedBezier> fit_beziers(std::span<const Vec3> points, const BezierFitOptions& options) {
  std::vector<FittedBezier> result;
  fit_rows(points, 0, options, result);
  return result;
}

Vec3 row_direction(std::span<const Vec3> points, std::size_t at, double reach, bool closed) {
  const auto [before, back] = walk(points, at, -1, {reach, closed});
  const auto [after, ahead] = walk(points, at, 1, {reach, closed});
  const Vec3 arriving = points[at] - points[before], leaving = points[after] - points[at];
  if (back == 0 && ahead == 0) return Vec3::Zero();
  if (back == 0) return unit_or_zero(leaving);
  if (ahead == 0) return unit_or_zero(arriving);
  return unit_or_zero(arriving * (ahead / back) + leaving * (back / ahead));
}

}  // namespace croquis

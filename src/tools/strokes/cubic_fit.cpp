// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/strokes/cubic_fit.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace croquis {
namespace {

constexpr int newton_rounds = 4;

/// A piece's points may miss by this many times the RMS tolerance, so that one bad place isn't averaged away.
constexpr double largest_over_rms = 3;

/// Handles outside these shares of the chord come from a degenerate least-squares system: loops or cusps.
constexpr double shortest_handle = 0.01;
constexpr double longest_handle = 2;

Vec2 first_derivative(const CubicSegment& c, double t) {
  const double s = 1 - t;
  return 3 * (s * s * (c[1] - c[0]) + 2 * s * t * (c[2] - c[1]) + t * t * (c[3] - c[2]));
}

Vec2 second_derivative(const CubicSegment& c, double t) {
  return 6 * ((1 - t) * (c[2] - 2 * c[1] + c[0]) + t * (c[3] - 2 * c[2] + c[1]));
}

std::vector<double> chord_parameters(std::span<const Vec2> points) {
  std::vector<double> parameters = {0};
  for (std::size_t i = 1; i < points.size(); ++i)
    parameters.push_back(parameters.back() + (points[i] - points[i - 1]).norm());
  for (double& parameter : parameters) parameter /= std::max(parameters.back(), 1e-300);
  return parameters;
}

/// The best lengths of the two handles for given parameters: a 2 × 2 system of normal equations.
CubicSegment least_squares_cubic(std::span<const Vec2> points, const std::vector<double>& parameters, const Vec2& begin,
                                 const Vec2& end) {
  const Vec2& p0 = points.front();
  const Vec2& p3 = points.back();
  double a00 = 0, a01 = 0, a11 = 0, b0 = 0, b1 = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double t = parameters[i];
    const double s = 1 - t;
    const double w1 = 3 * s * s * t;
    const double w2 = 3 * s * t * t;
    const Vec2 rest = points[i] - (s * s * s + w1) * p0 - (t * t * t + w2) * p3;
    a00 += w1 * w1;
    a01 -= w1 * w2 * begin.dot(end);
    a11 += w2 * w2;
    b0 += w1 * begin.dot(rest);
    b1 -= w2 * end.dot(rest);
  }
  const double chord = (p3 - p0).norm();
  const double determinant = a00 * a11 - a01 * a01;
  double first = (b0 * a11 - b1 * a01) / determinant;
  double second = (a00 * b1 - a01 * b0) / determinant;
  const auto usable = [chord](double x) { return x >= shortest_handle * chord && x <= longest_handle * chord; };
  if (!usable(first) || !usable(second)) first = second = chord / 3;
  return {p0, p0 + first * begin, p3 - second * end, p3};
}

struct Misses {
  double rms = 0;
  double largest = 0;
};

Misses misses(std::span<const Vec2> points, const CubicSegment& cubic, const std::vector<double>& parameters) {
  double sum = 0;
  double largest = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double squared = (point_at(cubic, parameters[i]) - points[i]).squaredNorm();
    sum += squared;
    largest = std::max(largest, squared);
  }
  return {std::sqrt(sum / static_cast<double>(points.size())), std::sqrt(largest)};
}

std::size_t worst_of_middle_half(std::span<const Vec2> points, const FittedPiece& piece) {
  const std::size_t count = points.size();
  const std::size_t low = std::max<std::size_t>(1, count / 4);
  const std::size_t high = std::min(count - 2, count - 1 - count / 4);
  std::size_t worst = count / 2;
  double largest = -1;
  for (std::size_t i = low; i <= high; ++i) {
    const double distance = (point_at(piece.cubic, piece.parameters[i]) - points[i]).squaredNorm();
    if (distance > largest) std::tie(worst, largest) = std::pair(i, distance);
  }
  return worst;
}

/// Splits recursively; every split leaves at most three quarters, so the depth is logarithmic.
class ChainFitter {
 public:
  ChainFitter(std::span<const Vec2> points, double reach, double tolerance)
      : points_(points), reach_(reach), tolerance_(tolerance) {}

  void fit(std::size_t first, std::size_t last, const Vec2& begin, const Vec2& end) {
    const std::span<const Vec2> part = points_.subspan(first, last - first + 1);
    FittedPiece piece{first, last, {}, chord_parameters(part)};
    if (improve(part, begin, end, piece) || part.size() == 2) {
      pieces_.push_back(std::move(piece));
      return;
    }
    const std::size_t middle = first + worst_of_middle_half(part, piece);
    const Vec2 tangent = tangent_within(points_, middle, reach_);
    fit(first, middle, begin, tangent);
    fit(middle, last, tangent, end);
  }

  std::vector<FittedPiece> take() { return std::move(pieces_); }

 private:
  bool improve(std::span<const Vec2> part, const Vec2& begin, const Vec2& end, FittedPiece& piece) const {
    for (int round = 0; round <= newton_rounds; ++round) {
      piece.cubic = least_squares_cubic(part, piece.parameters, begin, end);
      const Misses missed = misses(part, piece.cubic, piece.parameters);
      if (missed.rms <= tolerance_ && missed.largest <= largest_over_rms * tolerance_) return true;
      if (missed.rms > 30 * tolerance_) return false;  // Newton steps gain a few times at most: split at once
      if (round == newton_rounds) break;
      for (std::size_t i = 1; i + 1 < part.size(); ++i)
        piece.parameters[i] = nearest_on_cubic(piece.cubic, part[i], piece.parameters[i]);
    }
    return false;
  }

  std::span<const Vec2> points_;
  double reach_;
  double tolerance_;
  std::vector<FittedPiece> pieces_;
};

/// The farthest point from `at` in one direction that is within reach, at least the next one.
std::size_t within_reach(std::span<const Vec2> points, std::size_t at, int step, double reach) {
  std::size_t best = at;
  double gone = 0;
  const std::size_t limit = step > 0 ? points.size() - 1 : 0;
  while (best != limit) {
    const std::size_t next = step > 0 ? best + 1 : best - 1;
    gone += (points[next] - points[best]).norm();
    if (best != at && gone > reach) break;
    best = next;
  }
  return best;
}

/// Direction of a parabola at the joint of two chords: each weighs with the other's length.
Vec2 parabola_direction(const Vec2& in, const Vec2& out) {
  const double a = in.norm();
  const double b = out.norm();
  if (a == 0 || b == 0) return (a == 0 ? out : in).normalized();
  const Vec2 direction = in * (b / a) + out * (a / b);
  return direction.norm() > 1e-9 * (a + b) ? Vec2(direction.normalized()) : Vec2(out / b);
}

}  // namespace

Vec2 tangent_within(std::span<const Vec2> points, std::size_t at, double reach) {
  const Vec2& before = points[within_reach(points, at, -1, reach)];
  const Vec2& after = points[within_reach(points, at, 1, reach)];
  return parabola_direction(points[at] - before, after - points[at]);
}

Vec2 tangent_at_begin(std::span<const Vec2> points, double reach) {
  const std::size_t near = within_reach(points, 0, 1, reach);
  const std::size_t far = within_reach(points, near, 1, reach);
  const Vec2 first = points[near] - points[0];
  const Vec2 second = points[far] - points[near];
  const double a = first.norm();
  const double b = second.norm();
  if (far == near || a == 0 || b == 0) return first.normalized();
  const Vec2 direction = first / a - (second / b - first / a) * (a / (a + b));
  return direction.dot(first) > 0 ? Vec2(direction.normalized()) : Vec2(first / a);
}

double nearest_on_cubic(const CubicSegment& cubic, const Vec2& point, double start) {
  const Vec2 offset = point_at(cubic, start) - point;
  const Vec2 d1 = first_derivative(cubic, start);
  const double slope = d1.squaredNorm() + offset.dot(second_derivative(cubic, start));
  if (!(slope > 0)) return start;
  const double better = std::clamp(start - offset.dot(d1) / slope, 0.0, 1.0);
  return (point_at(cubic, better) - point).squaredNorm() <= offset.squaredNorm() ? better : start;
}

std::vector<FittedPiece> fit_cubics(std::span<const Vec2> points, const Vec2& begin, const Vec2& end, double reach,
                                    double tolerance) {
  ChainFitter fitter(points, reach, tolerance);
  fitter.fit(0, points.size() - 1, begin, end);
  return fitter.take();
}

}  // namespace croquis

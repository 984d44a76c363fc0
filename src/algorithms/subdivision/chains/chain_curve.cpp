// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/subdivision/chain_curve.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "croquis/geometry/mesh_tags.h"

namespace croquis::subdivision {
namespace {

constexpr int most_pieces_per_span = 256;

std::vector<Vec3> points_of(const EdgeChain& chain, std::span<const Vec3> positions) {
  std::vector<Vec3> points;
  for (const Index vertex : chain.vertices) points.push_back(positions[vertex]);
  return points;
}

/// Knots 0, 1, 2, …
void set_uniform_knots(ChainCurve& curve) {
  curve.knots.resize(curve.control_points.size() + static_cast<std::size_t>(curve.degree) + 1);
  std::iota(curve.knots.begin(), curve.knots.end(), 0.0);
}

ChainCurve closed_curve(std::vector<Vec3> points, int degree) {
  ChainCurve curve;
  curve.degree = degree;
  curve.closed = true;
  const std::size_t count = points.size();
  for (int i = 0; i < degree; ++i) points.push_back(points[static_cast<std::size_t>(i) % count]);
  curve.control_points = std::move(points);
  set_uniform_knots(curve);
  return curve;
}

ChainCurve bezier(const Vec3& a, const Vec3& b, const Vec3& c) {
  return {2, {a, b, c}, {0, 0, 0, 1, 1, 1}, false, true};
}

bool stays(ChainEnd end, const Rules& rules) { return end == ChainEnd::Corner || rules.chain_ends == ChainEnds::Pin; }

/// A chain of one edge: kept between corners, drawn together at ends that retract.
ChainCurve single_edge_curve(const EdgeChain& chain, const std::vector<Vec3>& points, const Rules& rules) {
  const Vec3 middle = (points[0] + points[1]) / 2;
  const bool first = stays(chain.ends[0], rules), last = stays(chain.ends[1], rules);
  if (rules.chain_ends == ChainEnds::Retract && !(first && last)) {
    const Vec3& rest = first ? points[0] : last ? points[1] : middle;
    return bezier(rest, rest, rest);
  }
  ChainCurve curve = bezier(points[0], middle, points[1]);
  curve.exact = first && last;
  return curve;
}

Vec3 mirrored(const Vec3& point, const Vec3& centre) { return 2 * centre - point; }

/// The span of knots that holds a parameter.
std::size_t span_of(const ChainCurve& curve, double parameter) {
  const auto degree = static_cast<std::size_t>(curve.degree);
  std::size_t span = degree;
  while (span + 1 < curve.control_points.size() && curve.knots[span + 1] <= parameter) ++span;
  return span;
}

Vec3 de_boor(const ChainCurve& curve, std::size_t span, double parameter) {
  const auto degree = static_cast<std::size_t>(curve.degree);
  std::array<Vec3, 4> points;
  for (std::size_t j = 0; j <= degree; ++j) points[j] = curve.control_points[span - degree + j];
  for (std::size_t round = 1; round <= degree; ++round) {
    for (std::size_t j = degree; j >= round; --j) {
      const double low = curve.knots[span - degree + j];
      const double high = curve.knots[span + 1 + j - round];
      const double share = (parameter - low) / (high - low);
      points[j] = (1 - share) * points[j - 1] + share * points[j];
    }
  }
  return points[degree];
}

/// A bound of the second derivative on a span: the control points of the derivative curve.
double second_derivative_bound(const ChainCurve& curve, std::size_t span) {
  const auto degree = static_cast<std::size_t>(curve.degree);
  const auto& knots = curve.knots;
  const auto first = [&](std::size_t i) -> Vec3 {
    return static_cast<double>(degree) * (curve.control_points[i + 1] - curve.control_points[i]) /
           (knots[i + degree + 1] - knots[i + 1]);
  };
  double bound = 0;
  for (std::size_t i = span - degree; i + 2 <= span; ++i) {
    const Vec3 second =
        static_cast<double>(degree - 1) * (first(i + 1) - first(i)) / (knots[i + degree + 1] - knots[i + 2]);
    bound = std::max(bound, second.norm());
  }
  return bound;
}

/// Chords of `pieces` equal parts stay within the tolerance: |c''| (length / pieces)^2 / 8.
int pieces_of(const ChainCurve& curve, std::size_t span, double tolerance) {
  const double length = curve.knots[span + 1] - curve.knots[span];
  const double pieces = length * std::sqrt(second_derivative_bound(curve, span) / (8 * tolerance));
  if (!(pieces < most_pieces_per_span)) return most_pieces_per_span;
  return std::max(1, static_cast<int>(std::ceil(pieces)));
}

std::vector<EdgeChain> infinite_chains(const Level& level) { return edge_chains(level, infinite_sharpness); }

bool ends_inside(const std::vector<EdgeChain>& chains) {
  return std::any_of(chains.begin(), chains.end(), [](const EdgeChain& chain) {
    return !chain.closed && (chain.ends[0] == ChainEnd::Dart || chain.ends[1] == ChainEnd::Dart);
  });
}

bool ends_at_corners(const std::vector<EdgeChain>& chains) {
  return std::any_of(chains.begin(), chains.end(), [](const EdgeChain& chain) {
    return !chain.closed && (chain.ends[0] == ChainEnd::Corner || chain.ends[1] == ChainEnd::Corner);
  });
}

}  // namespace

ChainCurve doo_sabin_curve(const EdgeChain& chain, std::span<const Vec3> positions, const Rules& rules) {
  std::vector<Vec3> points = points_of(chain, positions);
  if (chain.closed) return closed_curve(std::move(points), 2);
  if (points.size() == 2) return single_edge_curve(chain, points, rules);
  ChainCurve curve;
  curve.degree = 2;
  curve.control_points = std::move(points);
  set_uniform_knots(curve);
  const std::size_t last = curve.knots.size() - 1;
  if (stays(chain.ends[0], rules)) curve.knots[0] = curve.knots[1] = curve.knots[2];
  if (stays(chain.ends[1], rules)) curve.knots[last] = curve.knots[last - 1] = curve.knots[last - 2];
  for (const ChainEnd end : chain.ends) {
    if (stays(end, rules) ? rules.profile == Profile::Plain : rules.chain_ends == ChainEnds::Smooth) {
      curve.exact = false;
    }
  }
  return curve;
}

ChainCurve cubic_curve(const EdgeChain& chain, std::span<const Vec3> positions) {
  std::vector<Vec3> points = points_of(chain, positions);
  if (chain.closed) return closed_curve(std::move(points), 3);
  ChainCurve curve;
  curve.degree = 3;
  curve.exact = chain.ends[0] == ChainEnd::Corner && chain.ends[1] == ChainEnd::Corner;
  const Vec3 before = mirrored(points[1], points[0]);
  const Vec3 after = mirrored(points[points.size() - 2], points.back());
  points.insert(points.begin(), before);
  points.push_back(after);
  curve.control_points = std::move(points);
  set_uniform_knots(curve);
  return curve;
}

std::vector<ChainCurve> limit_curves(const DooSabinPlan& plan, const PositionBuffers& buffers, const Rules& rules) {
  int k = 0;
  while (k < plan.levels() && plan.banded(k + 1)) ++k;
  const std::vector<EdgeChain> chains = infinite_chains(plan.level(k));
  const bool smooth_ends = rules.chain_ends == ChainEnds::Smooth && ends_inside(chains);
  const bool plain_corners = rules.profile == Profile::Plain && ends_at_corners(chains);
  if (smooth_ends || plain_corners) k = plan.levels();
  std::vector<ChainCurve> curves;
  for (const EdgeChain& chain : infinite_chains(plan.level(k))) {
    curves.push_back(doo_sabin_curve(chain, buffers.levels[static_cast<std::size_t>(k)], rules));
  }
  return curves;
}

std::vector<ChainCurve> limit_curves(const UniformPlan& plan, const PositionBuffers& buffers) {
  const int k = ends_inside(infinite_chains(plan.level(0))) ? plan.levels() : 0;
  std::vector<ChainCurve> curves;
  for (const EdgeChain& chain : infinite_chains(plan.level(k))) {
    curves.push_back(cubic_curve(chain, buffers.levels[static_cast<std::size_t>(k)]));
  }
  return curves;
}

Vec3 point_at(const ChainCurve& curve, double parameter) {
  return de_boor(curve, span_of(curve, parameter), parameter);
}

std::vector<Vec3> sampled(const ChainCurve& curve, double tolerance) {
  const auto degree = static_cast<std::size_t>(curve.degree);
  std::vector<Vec3> points = {point_at(curve, curve.knots[degree])};
  for (std::size_t span = degree; span < curve.control_points.size(); ++span) {
    const double begin = curve.knots[span], length = curve.knots[span + 1] - begin;
    if (length <= 0) continue;
    const int pieces = pieces_of(curve, span, tolerance);
    for (int i = 1; i <= pieces; ++i) points.push_back(de_boor(curve, span, begin + length * i / pieces));
  }
  if (curve.closed) points.back() = points.front();
  return points;
}

}  // namespace croquis::subdivision

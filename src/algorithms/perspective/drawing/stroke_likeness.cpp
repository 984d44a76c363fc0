// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/perspective/drawing/stroke_likeness.h"

#include <algorithm>
#include <ranges>

namespace croquis {
namespace {

constexpr int samples_per_cubic = 24;

std::vector<PictureCubic> turned_pieces(std::vector<PictureCubic> pieces) {
  std::ranges::reverse(pieces);
  for (PictureCubic& piece : pieces) std::ranges::reverse(piece);
  return pieces;
}

std::vector<double> coordinates_of(const std::vector<PictureCubic>& pieces) {
  std::vector<double> result;
  for (const PictureCubic& piece : pieces) {
    for (const Vec2& point : piece) result.insert(result.end(), {point.x(), point.y()});
  }
  return result;
}

Vec2 point_of(const PictureCubic& p, double t) {
  const double s = 1 - t;
  return s * s * s * p[0] + 3 * s * s * t * p[1] + 3 * s * t * t * p[2] + t * t * t * p[3];
}

/// Polyline of a stroke whose ends are moved.
std::vector<Vec2> samples_of(const std::vector<PictureCubic>& pieces, const Vec2& start, const Vec2& end) {
  std::vector<Vec2> samples{start};
  const Vec2 first = start - pieces.front()[0], last = end - pieces.back()[3];
  const auto count = static_cast<double>(pieces.size() * samples_per_cubic);
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    for (int k = 1; k <= samples_per_cubic; ++k) {
      const double way = static_cast<double>(i * samples_per_cubic + static_cast<std::size_t>(k)) / count;
      const Vec2 shift = (1 - way) * first + way * last;
      samples.emplace_back(point_of(pieces[i], static_cast<double>(k) / samples_per_cubic) + shift);
    }
  }
  return samples;
}

double distance_to(const Vec2& point, const std::vector<Vec2>& line) {
  double best = (point - line[0]).squaredNorm();
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Vec2 step = line[i] - line[i - 1];
    const double square = step.squaredNorm();
    const double t = square > 0 ? std::clamp((point - line[i - 1]).dot(step) / square, 0.0, 1.0) : 0.0;
    best = std::min(best, (point - line[i - 1] - t * step).squaredNorm());
  }
  return std::sqrt(best);
}

}  // namespace

StrokeLook look_of(const PerspectiveStroke& stroke) {
  std::vector<double> forwards = coordinates_of(stroke.pieces);
  std::vector<double> backwards = coordinates_of(turned_pieces(stroke.pieces));
  return {std::min(std::move(forwards), std::move(backwards)), stroke.group, stroke.role, stroke.weight};
}

double distance_between(const PerspectiveStroke& a, const PerspectiveStroke& b, bool turned) {
  const std::vector<Vec2> first = samples_of(a.pieces, a.start(), a.end());
  const std::vector<Vec2> second = samples_of(turned ? turned_pieces(b.pieces) : b.pieces, a.start(), a.end());
  double largest = 0;
  for (const Vec2& point : first) largest = std::max(largest, distance_to(point, second));
  for (const Vec2& point : second) largest = std::max(largest, distance_to(point, first));
  return largest;
}

}  // namespace croquis

// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/strokes/ring_shape.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "croquis/silhouette/stroke_data.h"

namespace croquis::silhouette {
namespace {

/// A ring is as wide as at this quantile of its width, and even where it is no wider than that by this factor.
constexpr double width_quantile = 0.2;
constexpr double even_factor = 1.6;

/// Share of an outline along which its ring must be even.
constexpr double even_share = 0.6;

/// Largest width of a ring for the radius of its hole, by how much speaks for a part: nothing, one, two, more things.
constexpr std::array<double, 4> widest_ring{1.2, 0.8, 0.62, 0.5};

/// A ring that nothing speaks against may be this wide where it is even all round: a doughnut.
constexpr double widest_round_ring = 2.2;
constexpr double round_factor = 1.5;

/// Samples of an outline that are measured: enough for its shape.
constexpr std::size_t measured_samples = 64;

/// Widths of the ring between an outline and the one around it, ascending.
std::vector<double> ring_widths(const Points& inner, const Points& outer) {
  const std::size_t step = std::max<std::size_t>(1, inner.size() / measured_samples);
  std::vector<double> widths;
  for (std::size_t i = 0; i < inner.size(); i += step) {
    double width = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < outer.size(); ++k) {
      width =
          std::min(width, (nearest_on_segment(inner[i], outer[k], outer[(k + 1) % outer.size()]) - inner[i]).norm());
    }
    widths.push_back(width);
  }
  std::ranges::sort(widths);
  return widths;
}

}  // namespace

bool is_hole_of_ring(const Points& inner, const Points& outer, std::size_t things) {
  const std::vector<double> widths = ring_widths(inner, outer);
  const double width = widths[static_cast<std::size_t>(width_quantile * static_cast<double>(widths.size()))];
  const auto even = std::upper_bound(widths.begin(), widths.end(), even_factor * width) - widths.begin();
  const double radius = 2 * std::abs(signed_area(inner)) / length(inner, true);
  const bool round = widths.back() <= round_factor * widths.front() && width <= widest_round_ring * radius;
  if (things == 0 && round) return true;
  const double widest = widest_ring[std::min(things, widest_ring.size() - 1)];
  return static_cast<double>(even) >= even_share * static_cast<double>(widths.size()) && width <= widest * radius;
}

std::optional<bool> told_hole(const Drawing& drawing, const std::vector<Index>& strokes) {
  for (const Index stroke : strokes) {
    const StrokeKind kind = stroke_kind(drawing.strokes[stroke]).value_or(StrokeKind::Visible);
    const bool told = kind == StrokeKind::Hole || kind == StrokeKind::Part || kind == StrokeKind::Blob;
    if (told) return kind == StrokeKind::Hole;
  }
  return std::nullopt;
}

}  // namespace croquis::silhouette

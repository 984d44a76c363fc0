// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/strokes/bar_search.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "algorithms/silhouette/strokes/tremble.h"

namespace croquis::silhouette {
namespace {

// So many samples next to an end can't be its own bar: a line doesn't turn back on itself that fast.
constexpr double own_samples = 8;
// Nor can what lies within so many times the reach along it.
constexpr double own_reach = 2;
// A line that ends exactly on its bar must be found to meet it: fractions of a segment, far above rounding.
constexpr double fraction_slack = 1e-9;

}  // namespace

/// The last bit of a line and the ray ahead of it.
struct BarSearch::Probe {
  Index line = 0;
  bool at_start = false;
  EndReach wanted;
  Vec2 end = Vec2::Zero();
  Points path;                ///< from the line's inside through its end to the tip of the ray
  std::vector<double> along;  ///< per point of the path: arc length from the end
};

BarSearch::BarSearch(const std::vector<CleanLine>& lines, const DrawingScale& scale)
    : lines_(lines), scale_(scale), grid_(line_segments(lines), scale.step) {
  for (const CleanLine& line : lines) largest_ = std::max(largest_, line.size);
}

// A small part's end misses the large outline that it passes behind by as much as that outline is off.
double BarSearch::reach(Index line, Index bar) const {
  return scale_.reach(std::max(lines_[line].size, lines_[bar].size));
}

BarSearch::Probe BarSearch::probe(Index line, bool at_start, const EndReach& wanted) const {
  const Points& points = lines_[line].points;
  Probe probe{line, at_start, wanted, lines_[line].end(at_start), {}, {}};
  const double ahead = wanted.factor * scale_.reach(std::max(lines_[line].size, largest_));
  // An overshoot longer than nearly half the line is no overshoot.
  const double back = std::min({wanted.most_back, ahead, 0.45 * croquis::length(points, false)});
  const Vec2 tangent = end_direction(lines_[line], at_start, scale_);
  probe.path = {probe.end + ahead * tangent, probe.end};
  probe.along = {ahead, 0};
  const std::size_t count = points.size();
  for (std::size_t i = 1; i < count && probe.along.back() > -back; ++i) {
    const Vec2& next = points[at_start ? i : count - 1 - i];
    const Vec2 piece = next - probe.path.back();
    const double length = piece.norm();
    const double share = std::min(1.0, (back + probe.along.back()) / length);
    if (length <= 0) continue;
    probe.along.push_back(probe.along.back() - share * length);
    probe.path.push_back(probe.path.back() + share * piece);
  }
  std::reverse(probe.path.begin(), probe.path.end());
  std::reverse(probe.along.begin(), probe.along.end());
  return probe;
}

bool BarSearch::is_left_out(const Probe& probe, const GridSegment& segment) const {
  const std::vector<Index>& elsewhere = probe.wanted.elsewhere;
  const Index stroke = lines_[segment.line].stroke[segment.position];
  return is_own_end(probe, segment) || std::find(elsewhere.begin(), elsewhere.end(), stroke) != elsewhere.end();
}

bool BarSearch::is_own_end(const Probe& probe, const GridSegment& segment) const {
  if (segment.line != probe.line) return false;
  const double last = lines_[probe.line].segment_count() - 1.0;
  return (probe.at_start ? segment.position : last - segment.position) <
         std::max(own_samples, own_reach * probe.along.back() / scale_.step);
}

double BarSearch::distance_to_open_end(Index line, double parameter) const {
  if (lines_[line].closed) return std::numeric_limits<double>::infinity();
  return scale_.step * std::min(parameter, lines_[line].segment_count() - parameter);
}

std::vector<BarHit> BarSearch::hits(const Probe& probe) const {
  std::vector<BarHit> found;
  for (std::size_t k = 0; k + 1 < probe.path.size(); ++k) {
    const Vec2& a = probe.path[k];
    const Vec2& b = probe.path[k + 1];
    grid_.near_box(a.cwiseMin(b), a.cwiseMax(b), [&](Index i) {
      const GridSegment& segment = grid_.segments()[i];
      if (is_left_out(probe, segment)) return;
      const double f = crossing_fraction(a, b, segment.a, segment.b);
      const double g = crossing_fraction(segment.a, segment.b, a, b);
      // Written so that the undefined fractions of parallel segments are refused.
      if (!(std::min(f, g) >= -fraction_slack && std::max(f, g) <= 1 + fraction_slack)) return;
      const double along = probe.along[k] + f * (probe.along[k + 1] - probe.along[k]);
      if (std::abs(along) > probe.wanted.factor * reach(probe.line, segment.line)) return;
      const double fraction = std::clamp(g, 0.0, 1.0);
      found.push_back(
          {along, segment.line, segment.position + fraction, segment.a + fraction * (segment.b - segment.a)});
    });
  }
  std::sort(found.begin(), found.end(), [](const BarHit& a, const BarHit& b) { return a.along < b.along; });
  return found;
}

std::optional<BarHit> BarSearch::nearest(const Probe& probe) const {
  std::optional<BarHit> best;
  const Vec2 reach = Vec2::Constant(probe.along.back());
  grid_.near_box(probe.end - reach, probe.end + reach, [&](Index i) {
    const GridSegment& segment = grid_.segments()[i];
    if (is_left_out(probe, segment)) return;
    const double fraction = nearest_parameter(probe.end, segment.a, segment.b);
    const double parameter = segment.position + fraction;
    const Vec2 at = segment.a + fraction * (segment.b - segment.a);
    const double distance = (at - probe.end).norm();
    if (distance > probe.wanted.factor * this->reach(probe.line, segment.line) || (best && distance >= best->along))
      return;
    // Two loose ends that lie near one another are no junction.
    if (distance_to_open_end(segment.line, parameter) <= 0) return;
    best = BarHit{distance, segment.line, parameter, at};
  });
  return best;
}

std::optional<BarHit> BarSearch::find(Index line, bool at_start, const EndReach& wanted) const {
  const Probe searching = probe(line, at_start, wanted);
  const std::vector<BarHit> found = hits(searching);
  // Where two lines overshoot each other, the one that goes on for less is the stem.
  const auto is_the_stem = [&](const BarHit& hit) {
    return hit.along >= 0 || distance_to_open_end(hit.bar, hit.parameter) >= -hit.along;
  };
  // A crossing on the line itself comes before anything ahead of it: it would be a crossing in full view.
  const auto hit = std::find_if(found.begin(), found.end(), is_the_stem);
  if (hit != found.end()) return *hit;
  if (const std::optional<BarHit> beside = nearest(searching)) return beside;
  if (!found.empty()) return found.back();
  return std::nullopt;
}

}  // namespace croquis::silhouette

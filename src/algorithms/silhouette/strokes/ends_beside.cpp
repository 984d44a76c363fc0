// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/strokes/ends_beside.h"

#include <algorithm>
#include <cmath>

namespace croquis::silhouette {
namespace {

// The hand's tremble brings an end to a line next to it by no more than this share of the smaller one's size.
constexpr double tremble_share = 0.08;
// Ends at one body stay so many steps apart, and a line is cut back by as many.
constexpr double apart_steps = 2;

/// The place on a bar so many steps from another one; none beyond the ends of an open bar.
std::optional<BarHit> place_beside(const CleanLine& bar, const BarHit& hit, double steps) {
  const double last = bar.segment_count();
  double parameter = hit.parameter + steps;
  if (bar.closed) {
    parameter -= last * std::floor(parameter / last);
  } else if (parameter <= 0 || parameter >= last) {
    return std::nullopt;
  }
  return BarHit{0, hit.bar, parameter, point_at(bar.points, parameter)};
}

/// Where a line's end meets the body of the limb beside it; none when it is too far from that one's end.
std::optional<BarHit> beside(const std::vector<CleanLine>& lines, Index line, bool at_start, const BarHit& hit,
                             const EndHits& hits, const DrawingScale& scale) {
  const CleanLine& limb = lines[hit.bar];
  if (limb.closed || hit.bar == line) return std::nullopt;
  const bool near_start = hit.parameter < 0.5 * limb.segment_count();
  const double to_end = scale.step * (near_start ? hit.parameter : limb.segment_count() - hit.parameter);
  const std::optional<BarHit>& body = hits[hit.bar][near_start ? 0 : 1];
  const double most = scale.tremble * tremble_share * std::min(lines[line].size, limb.size);
  const std::optional<BarHit>& other_of_limb = hits[hit.bar][near_start ? 1 : 0];
  const std::optional<BarHit>& other = hits[line][at_start ? 1 : 0];
  if (!body || body->bar == line || body->bar == hit.bar || to_end > most) return std::nullopt;
  if (!other || !other_of_limb || other->bar != body->bar || other_of_limb->bar != body->bar) return std::nullopt;
  const double cut = std::max(0.0, -hit.along) + apart_steps * scale.step;
  const Points& points = lines[line].points;
  const auto back = static_cast<std::size_t>(std::ceil(cut / scale.step)) + 1;
  if (points.size() < 2 * back) return std::nullopt;
  const Vec2& from = at_start ? points[back] : points[points.size() - 1 - back];
  std::optional<BarHit> best;
  for (const double steps : {-apart_steps, apart_steps}) {
    std::optional<BarHit> place = place_beside(lines[body->bar], *body, steps);
    if (place && (!best || (place->at - from).norm() < (best->at - from).norm())) best = place;
  }
  if (best) best->along = -cut;
  return best;
}

}  // namespace

void pass_beside_ends(const std::vector<CleanLine>& lines, const DrawingScale& scale, EndHits& hits) {
  if (scale.tremble <= 0) return;
  const EndHits found = hits;
  for (Index line = 0; line < lines.size(); ++line) {
    for (const bool at_start : {true, false}) {
      std::optional<BarHit>& hit = hits[line][at_start ? 0 : 1];
      if (!hit) continue;
      if (const std::optional<BarHit> other = beside(lines, line, at_start, *hit, found, scale)) hit = other;
    }
  }
}

}  // namespace croquis::silhouette

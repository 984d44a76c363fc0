// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>
#include <span>
#include <utility>

#include "algorithms/silhouette/reading/reading_program.h"
#include "algorithms/silhouette/strokes/drawing_findings.h"
#include "croquis/base/text.h"

namespace croquis::silhouette {
namespace {

// Bends sharper than this angle within so many steps are corners.
constexpr double corner_angle = std::numbers::pi / 3;
constexpr double corner_reach = 3;

// Limbs of one line are as wide as this share of the drawing's diagonal, and no wider than that of their own length.
constexpr double width_share = 0.035;
constexpr double slenderness = 0.3;
// So far (in widths) they go on within what they grow out of; an end that misses it by less than that is led there.
constexpr double depth_within = 1;
constexpr double farthest_miss = 1.5;
// Where they run beside a contour, more than so many widths from where they grow out of it, they are thin enough to
// keep that share of their distance from it, but not thinner than that share of their width.
constexpr double root_length = 1.5;
constexpr double distance_share = 0.7;
constexpr double thinnest = 0.3;
// Places along a limb are this share of its width apart; its round ends have so many corners.
constexpr double place_share = 0.4;
constexpr int circle_points = 20;

/// The sample of lines that is nearest to a place; infinitely far where there is none.
struct NearestSample {
  Index line = no_index;
  Vec2 place = Vec2::Zero();
  double distance = std::numeric_limits<double>::infinity();
};

/// @param lines that have `points`
/// @param first line that is looked at
template <typename Line>
NearestSample nearest_sample(const std::vector<Line>& lines, Index first, const Vec2& place) {
  NearestSample nearest;
  for (Index line = first; line < lines.size(); ++line) {
    for (const Vec2& point : lines[line].points) {
      const double distance = (point - place).norm();
      if (distance < nearest.distance) nearest = {line, point, distance};
    }
  }
  return nearest;
}

/// A line before it is smoothed, and the ends that it has.
struct Chain {
  StrokeChain strokes;
  std::array<Index, 2> ends{no_index, no_index};  ///< positions in Connections::ends
  bool bridged = false;                           ///< see CleanLine
};

/// Follows joined ends. Ends come in pairs (start, end) per stroke, so e ^ 1 is the other end of the same stroke.
std::vector<Chain> chains_of(const Connections& connections, const Reading& reading) {
  std::vector<const EndJoin*> joins(connections.ends.size(), nullptr);
  for (const Index j : reading.joins) {
    const EndJoin& join = connections.joins[j];
    joins[join.a] = joins[join.b] = &join;
  }
  std::vector<Index> first_end(reading.kinds.size(), no_index);
  for (Index e = 0; e < connections.ends.size(); e += 2) first_end[connections.ends[e].stroke] = e;
  std::vector<char> done(reading.kinds.size(), 0);
  std::vector<Chain> chains;
  for (Index s = 0; s < reading.kinds.size(); ++s) {
    if (reading.kinds[s] != LineKind::Contour || done[s] != 0) continue;
    Chain& chain = chains.emplace_back();
    chain.strokes.links.push_back({s, false});
    chain.strokes.closed = first_end[s] == no_index;
    if (!chain.strokes.closed) chain.ends = {first_end[s], first_end[s] + 1};
    for (const std::size_t k : {1U, 0U}) {
      while (!chain.strokes.closed && joins[chain.ends[k]] != nullptr) {
        const EndJoin& join = *joins[chain.ends[k]];
        const Index next = join.a == chain.ends[k] ? join.b : join.a;
        const LineEnd& end = connections.ends[next];
        if (end.stroke == s) {
          chain.strokes.closed = true;
          chain.bridged = join.gap >= 1;
          chain.ends = {no_index, no_index};
          break;
        }
        done[end.stroke] = 1;
        auto& links = chain.strokes.links;
        links.insert(k == 1 ? links.end() : links.begin(), {end.stroke, end.at_start == (k == 0)});
        chain.ends[k] = next ^ 1U;
      }
    }
  }
  return chains;
}

/// Smooths a line of densely sampled points and samples it once per step.
void finish(CleanLine& line, double step, int passes) {
  const double reach = corner_reach * step;
  TaubinOptions smoothing;
  smoothing.passes = passes;
  smoothing.fixed.assign(line.points.size(), false);
  for (const Index corner : corners_of(line.points, line.closed, reach, corner_angle)) smoothing.fixed[corner] = true;
  const Points drawn = line.points;
  line.points = taubin_smooth(line.points, line.closed, smoothing);
  const std::vector<Index> kept = corners_of(line.points, line.closed, reach, corner_angle);
  Points points;
  std::vector<Index> stroke;
  for (const double parameter : even_parameters(line.points, line.closed, step, kept)) {
    points.push_back(point_at(line.points, parameter));
    line.raw.push_back(point_at(drawn, parameter));
    stroke.push_back(line.stroke[static_cast<std::size_t>(parameter)]);
  }
  line.points = std::move(points);
  line.stroke = std::move(stroke);
  line.size = size_of(line.points, line.closed);
}

CleanLine line_of(const EnclosedRegion& region, const std::vector<SampledStroke>& strokes) {
  CleanLine line;
  line.closed = true;
  line.points = region.outline;
  for (const Index s : region.stroke) {
    const Index stroke = strokes[s].stroke;
    line.stroke.push_back(stroke);
    if (std::ranges::count(line.strokes, stroke) == 0) line.strokes.push_back(stroke);
  }
  return line;
}

/// One warning for each gap that joins close, but for small ones of strokes that close themselves.
Findings gaps_closed(const Drawing& drawing, const SampledDrawing& sampled, const Connections& connections,
                     const Reading& reading) {
  Findings findings;
  for (const Index join : reading.joins) {
    const LineEnd& a = connections.ends[connections.joins[join].a];
    const LineEnd& b = connections.ends[connections.joins[join].b];
    const double distance = (b.place - a.place).norm();
    if (a.stroke == b.stroke && distance < sampled.scale.close) continue;
    const Index first = sampled.strokes[a.stroke].stroke, second = sampled.strokes[b.stroke].stroke;
    const Vec2 at = (a.place + b.place) / 2;
    const std::string where = first == second
                                  ? "between the ends of " + in_quotes(drawing, first)
                                  : "between " + in_quotes(drawing, first) + " and " + in_quotes(drawing, second);
    std::vector<Subject> subjects{stroke_subject(drawing, first, at)};
    if (first != second) subjects.push_back(stroke_subject(drawing, second, at));
    findings.push_back(make_warning(Category::Geometry, "W_GAP",
                                    "Closed a gap of " + number_text(distance, 4) + " " + where, std::move(subjects)));
  }
  return findings;
}

/// A stretch of a stroke that becomes a limb.
struct Limb {
  Points points;
  Index stroke = 0;              ///< index into Drawing::strokes
  std::vector<double> radius{};  ///< per point
};

/// Adds the stretches of a stroke outside everything, with a bit of it within at both ends.
void add_limbs(const SampledStroke& stroke, double usual_width, const std::vector<CleanLine>& contours,
               std::vector<Limb>& limbs) {
  const double width = std::min(usual_width, slenderness * stroke.length);
  const Points points = even_points(stroke.points, stroke.closed, place_share * width);
  std::vector<bool> inside;
  for (const Vec2& point : points) {
    inside.push_back(std::ranges::any_of(
        contours, [&](const CleanLine& line) { return line.closed && encloses(line.points, point); }));
  }
  // Ends that nearly reach something are led into it.
  const auto led = [&](const Vec2& end, bool& within) {
    const NearestSample nearest = nearest_sample(contours, 0, end);
    if (nearest.distance == 0 || nearest.distance > farthest_miss * width) return end;
    within = true;
    return Vec2(nearest.place + depth_within * width / nearest.distance * (nearest.place - end));
  };
  const auto more = static_cast<std::size_t>(depth_within / place_share) + 1;
  const double root = (depth_within + root_length) * width;
  for (std::size_t begin = 0, end = 0; begin < points.size(); begin = end) {
    while (end < points.size() && inside[end] == inside[begin]) ++end;
    if (inside[begin] || end - begin < 2) continue;
    const std::size_t first = begin - std::min(begin, more), last = std::min(points.size(), end + more);
    bool starts_within = first < begin;
    bool ends_within = end < last;
    const auto stretch = std::span(points).subspan(first, last - first);
    auto& [line, index, radius] = limbs.emplace_back(Limb{Points(stretch.begin(), stretch.end()), stroke.stroke});
    if (!starts_within) line.insert(line.begin(), led(line.front(), starts_within));
    if (!ends_within) line.push_back(led(line.back(), ends_within));
    const std::vector<double> arcs = arc_lengths(line, false);
    for (std::size_t i = 0; i < line.size(); ++i) {
      const bool at_root = (starts_within && arcs[i] < root) || (ends_within && arcs.back() - arcs[i] < root);
      const double thin = distance_share * nearest_sample(contours, 0, line[i]).distance;
      radius.push_back(at_root ? width / 2 : std::clamp(thin, thinnest * width / 2, width / 2));
    }
  }
}

CleanLine line_of(const Points& ring, const std::vector<Limb>& limbs, double step) {
  CleanLine line;
  line.closed = true;
  line.points = even_points(ring, true, step);
  line.raw = line.points;
  for (const Vec2& point : line.points) {
    line.stroke.push_back(limbs[nearest_sample(limbs, 0, point).line].stroke);
  }
  const std::set<Index> strokes(line.stroke.begin(), line.stroke.end());
  line.strokes.assign(strokes.begin(), strokes.end());
  line.size = size_of(line.points, true);
  line.tube = true;
  return line;
}

/// Outlines of everything within the radii of limbs: the hulls of neighbouring circles.
std::vector<CleanLine> outlines_of(const std::vector<Limb>& limbs, const DrawingScale& scale) {
  namespace bg = boost::geometry;
  using BoostPoint = bg::model::d2::point_xy<double>;
  using Polygon = bg::model::polygon<BoostPoint>;
  using Polygons = bg::model::multi_polygon<Polygon>;
  const Vec2 origin = limbs.front().points.front();  // Boost counts in whole numbers: coordinates are to be small
  const auto unite = [](Polygons& all, const auto& piece) {
    Polygons joined;
    bg::union_(all, piece, joined);
    all = std::move(joined);
  };
  Polygons all;
  for (const auto& [line, stroke, radius] : limbs) {
    Polygons limb;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
      bg::model::multi_point<BoostPoint> circles;
      for (const std::size_t k : {i, i + 1}) {
        for (int corner = 0; corner < circle_points; ++corner) {
          const double angle = corner * 2 * std::numbers::pi / circle_points;
          const Vec2 place = line[k] + radius[k] * Vec2(std::cos(angle), std::sin(angle));
          const Vec2 at = (place - origin) / scale.unit;
          circles.push_back({at.x(), at.y()});
        }
      }
      Polygon hull;
      bg::convex_hull(circles, hull);
      unite(limb, hull);
    }
    unite(all, limb);
  }
  std::vector<CleanLine> outlines;
  for (const Polygon& polygon : all) {
    Points ring;
    for (const BoostPoint& point : polygon.outer()) ring.push_back(origin + scale.unit * Vec2(point.x(), point.y()));
    ring.pop_back();  // the first one again
    if (signed_area(ring) < 0) std::ranges::reverse(ring);
    outlines.push_back(line_of(ring, limbs, scale.step));
  }
  return outlines;
}

}  // namespace

ContourLines contour_lines(const Drawing& drawing, const SampledDrawing& sampled, const Connections& connections,
                           const Envelope& envelope, const Reading& reading, int passes, const Progress& progress) {
  ContourLines result;
  result.findings = gaps_closed(drawing, sampled, connections, reading);
  const std::vector<SampledStroke>& strokes = sampled.strokes;
  std::vector<Index> line_of_stroke(strokes.size(), no_index);
  std::vector<int> direction(strokes.size(), 1);  // of a stroke in its line
  const std::vector<Chain> chains = chains_of(connections, reading);
  for (const Chain& chain : chains) {
    for (const ChainLink& link : chain.strokes.links) {
      line_of_stroke[link.index] = static_cast<Index>(result.lines.size());
      if (link.reversed) direction[link.index] = -1;
    }
    result.lines.push_back(join_chain(chain.strokes, strokes, sampled.scale));
    result.lines.back().bridged = chain.bridged;
  }
  const auto first_region = static_cast<Index>(chains.size());
  for (const Index region : reading.regions) result.lines.push_back(line_of(envelope.regions[region], strokes));
  for (CleanLine& line : result.lines) {
    progress.check();
    finish(line, sampled.scale.step, passes);
  }
  for (std::size_t line = 0; line < chains.size(); ++line) {
    for (std::size_t k = 0; k < 2; ++k) {
      const auto found = std::ranges::find(reading.meetings, chains[line].ends[k],
                                           [&](Index meeting) { return connections.meetings[meeting].end; });
      if (found == reading.meetings.end()) continue;
      const EndMeeting& meeting = connections.meetings[*found];
      // The outline of a region, which lies on its left, stands for all strokes on it.
      const bool is_region = line_of_stroke[meeting.bar] == no_index;
      const Index bar =
          is_region ? nearest_sample(result.lines, first_region, meeting.at).line : line_of_stroke[meeting.bar];
      const int side = is_region ? 1 : meeting.side * direction[meeting.bar];
      result.lines[line].targets[k] = EndTarget{bar, meeting.at, std::abs(meeting.along), side};
    }
  }
  return result;
}

std::vector<CleanLine> tube_outlines(const SampledDrawing& sampled, const Reading& reading,
                                     const std::vector<CleanLine>& contours, double diagonal) {
  std::vector<Limb> limbs;
  for (Index s = 0; s < reading.kinds.size(); ++s) {
    if (reading.kinds[s] == LineKind::Tube) add_limbs(sampled.strokes[s], width_share * diagonal, contours, limbs);
  }
  return limbs.empty() ? std::vector<CleanLine>{} : outlines_of(limbs, sampled.scale);
}

}  // namespace croquis::silhouette

// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/reading/reading_lines.h"

#include <algorithm>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

#include "algorithms/silhouette/strokes/drawing_findings.h"

namespace croquis::silhouette {
namespace {

// Bends sharper than this angle within so many steps are corners.
constexpr double corner_angle = std::numbers::pi / 3;
constexpr double corner_reach = 3;

/// A line before it is smoothed, and the ends that it has.
struct Chain {
  StrokeChain strokes;
  std::array<Index, 2> ends{no_index, no_index};  ///< positions in Connections::ends
  double gap = 0;                                 ///< of a closed one whose stroke closes itself, see EndJoin
};

/// Follows joined ends. Ends come in pairs (start, end) per stroke, so e ^ 1 is the other end of the same stroke.
std::vector<Chain> chains_of(const Connections& connections, const Reading& reading) {
  std::vector<const EndJoin*> joins(connections.ends.size(), nullptr);
  for (const EndJoin& join : reading.joins) joins[join.a] = joins[join.b] = &join;
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
          chain.gap = join.gap;
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

Finding gap_warning(const Drawing& drawing, Index first, Index second, const Vec2& at, double distance) {
  const std::string where = first == second
                                ? "between the ends of " + in_quotes(drawing, first)
                                : "between " + in_quotes(drawing, first) + " and " + in_quotes(drawing, second);
  std::vector<Subject> subjects{stroke_subject(drawing, first, at)};
  if (first != second) subjects.push_back(stroke_subject(drawing, second, at));
  return make_warning(Category::Geometry, "W_GAP", "Closed a gap of " + length_text(distance) + " " + where,
                      std::move(subjects));
}

}  // namespace

ContourLines contour_lines(const Drawing& drawing, const SampledDrawing& sampled, const Connections& connections,
                           const Envelope& envelope, const Reading& reading, int passes, const Progress& progress) {
  ContourLines result;
  const std::vector<SampledStroke>& strokes = sampled.strokes;
  for (const EndJoin& join : reading.joins) {
    const LineEnd& a = connections.ends[join.a];
    const LineEnd& b = connections.ends[join.b];
    const double distance = (b.place - a.place).norm();
    if (a.stroke == b.stroke && distance < sampled.scale.close) continue;
    result.findings.push_back(
        gap_warning(drawing, strokes[a.stroke].stroke, strokes[b.stroke].stroke, (a.place + b.place) / 2, distance));
  }
  std::vector<Index> line_of_stroke(strokes.size(), no_index);
  std::vector<int> direction(strokes.size(), 1);  // of a stroke in its line
  const std::vector<Chain> chains = chains_of(connections, reading);
  for (const Chain& chain : chains) {
    for (const ChainLink& link : chain.strokes.links) {
      line_of_stroke[link.index] = static_cast<Index>(result.lines.size());
      if (link.reversed) direction[link.index] = -1;
    }
    result.lines.push_back(join_chain(chain.strokes, strokes, sampled.scale));
    result.lines.back().bridged = chain.strokes.closed && chain.gap >= 1;
  }
  for (const Index region : reading.regions) result.lines.push_back(line_of(envelope.regions[region], strokes));
  for (CleanLine& line : result.lines) {
    progress.check();
    finish(line, sampled.scale.step, passes);
  }
  // The outline of a region stands for all strokes on it.
  const auto bar_of = [&](const EndMeeting& meeting) {
    if (line_of_stroke[meeting.bar] != no_index) return line_of_stroke[meeting.bar];
    Index found = no_index;
    double least = std::numeric_limits<double>::infinity();
    for (Index line = static_cast<Index>(chains.size()); line < result.lines.size(); ++line) {
      for (const Vec2& point : result.lines[line].points) {
        if ((point - meeting.at).norm() >= least) continue;
        least = (point - meeting.at).norm();
        found = line;
      }
    }
    return found;
  };
  result.targets.resize(result.lines.size());
  for (std::size_t line = 0; line < chains.size(); ++line) {
    for (std::size_t k = 0; k < 2; ++k) {
      const auto meeting = std::ranges::find(reading.meetings, chains[line].ends[k], &EndMeeting::end);
      if (meeting == reading.meetings.end()) continue;
      const Index bar = bar_of(*meeting);
      if (bar == no_index) continue;
      // Regions lie on the left of their outlines.
      const int side = bar < chains.size() ? meeting->side * direction[meeting->bar] : 1;
      result.targets[line][k] = EndTarget{bar, meeting->at, std::abs(meeting->along), side};
    }
  }
  return result;
}

}  // namespace croquis::silhouette

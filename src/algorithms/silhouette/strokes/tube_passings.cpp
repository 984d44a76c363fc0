// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <tuple>
#include <utility>

#include "algorithms/silhouette/strokes/drawing_findings.h"
#include "algorithms/silhouette/strokes/tube_outline.h"
#include "croquis/base/text.h"
#include "croquis/geometry/segment_grid.h"

namespace croquis::silhouette {
namespace {

// The crossing of two outlines lies no farther from that of their centre lines than this share beyond what straight
// strands would have, which cross at this sine at least.
constexpr double reach_share = 1.5;
constexpr double least_sine = 0.2;

/// A centre line led on beyond its ends, so that an end over another tube is a crossing, too.
struct ExtendedLine {
  Points points;
  bool closed = false;
  double before = 0;  ///< so much was added before the first point
  std::vector<double> arcs;

  double along(const GridSegment& segment, double fraction) const {
    return arcs[segment.position] + fraction * (segment.b - segment.a).norm() - before;
  }
};

std::vector<ExtendedLine> extended_lines(const std::vector<CentreLine>& tubes) {
  double thickest = 0;
  for (const CentreLine& tube : tubes) thickest = std::max(thickest, std::ranges::max(tube.radius));
  std::vector<ExtendedLine> lines;
  for (const CentreLine& tube : tubes) {
    ExtendedLine& line = lines.emplace_back(ExtendedLine{tube.points, tube.closed, 0, {}});
    if (!tube.closed) {
      const double more = (tube_tip + 1) * thickest;
      line.before = more;
      line.points.insert(line.points.begin(),
                         tube.points.front() + more * end_chord(tube.points, true, tube.radius.front()));
      line.points.push_back(tube.points.back() + more * end_chord(tube.points, false, tube.radius.back()));
    }
    line.arcs = arc_lengths(line.points, line.closed);
  }
  return lines;
}

/// The radius of a tube at a place of its extended line.
double radius_along(const CentreLine& tube, double along) {
  const double share = along / length(tube.points, tube.closed);
  const auto last = static_cast<double>(tube.radius.size() - 1);
  return tube.radius[static_cast<std::size_t>(std::clamp(share * last, 0.0, last))];
}

/// Whether a place is beyond an end of the tube, or no farther before it than that.
bool is_at_end(const CentreLine& tube, double along, double reach) {
  return !tube.closed && (along < reach || along > length(tube.points, false) - reach);
}

std::vector<TubePassing> crossings_of_centre_lines(const std::vector<CentreLine>& tubes, double step) {
  constexpr double endless = std::numeric_limits<double>::infinity();
  const std::vector<ExtendedLine> lines = extended_lines(tubes);
  std::vector<TubePassing> passings;
  for (const SegmentContact& contact : find_contacts(SegmentGrid(segments_of(lines), step))) {
    if (!contact.crosses()) continue;
    TubePassing passing;
    passing.crossing.at = contact.at;
    passing.tube = {contact.a.line, contact.b.line};
    passing.along = {lines[contact.a.line].along(contact.a, contact.fraction_a),
                     lines[contact.b.line].along(contact.b, contact.fraction_b)};
    const Vec2 u = (contact.a.b - contact.a.a).normalized(), v = (contact.b.b - contact.b.a).normalized();
    const double sine = std::max(least_sine, std::abs(cross(u, v)));
    const double both =
        radius_along(tubes[passing.tube[0]], passing.along[0]) + radius_along(tubes[passing.tube[1]], passing.along[1]);
    for (std::size_t k = 0; k < 2; ++k) {
      const CentreLine& tube = tubes[passing.tube[k]];
      passing.reach[k] = reach_share * both / sine;
      passing.period[k] = tube.closed ? length(tube.points, true) : endless;
    }
    passings.push_back(passing);
  }
  return passings;
}

/// How far two places along a centre line are apart.
double apart(double a, double b, double period) {
  const double distance = std::abs(a - b);
  return std::isfinite(period) ? std::min(distance, std::abs(period - distance)) : distance;
}

Finding overlap_beside(const Drawing& drawing, const std::vector<CentreLine>& tubes, const TubePlace& a,
                       const TubePlace& b, const Vec2& at) {
  const CentreLine &first = tubes[a.tube], &second = tubes[b.tube];
  const double period = first.closed ? length(first.points, true) : std::numeric_limits<double>::infinity();
  const bool bend =
      a.tube == b.tube && apart(a.along, b.along, period) < tube_loop_reach * radius_along(first, a.along);
  const std::string place = " at (" + number_text(at.x(), 5) + ", " + number_text(-at.y(), 5) + "): ";
  std::string sentence = "The tube " + in_quotes(drawing, first.stroke);
  std::vector<Subject> subjects{stroke_subject(drawing, first.stroke, at)};
  if (a.tube != b.tube) {
    subjects.push_back(stroke_subject(drawing, second.stroke, at));
    sentence = "The tubes " + in_quotes(drawing, first.stroke) + " and " + in_quotes(drawing, second.stroke) +
               " overlap side by side" + place + "draw them farther apart";
  } else {
    sentence += (bend ? " bends more sharply than its radius allows" : " overlaps itself side by side") + place +
                (bend ? "draw a wider bend" : "draw its strands farther apart");
  }
  subjects.push_back(crossing_subject(drawing, at));
  return make_error(Category::Geometry, "E_TUBE", sentence + ", or give it a smaller radius", std::move(subjects));
}

/// Leaves the passings at which outlines cross as those of two strands do. What else crosses lies side by side.
void match_outlines(const Drawing& drawing, const std::vector<CentreLine>& tubes, const std::vector<CleanLine>& lines,
                    double step, TubePassings& found) {
  std::vector<GridSegment> segments;
  for (Index line = 0; line < lines.size(); ++line) {
    if (lines[line].centre_line != no_index) add_segments(lines[line], line, segments);
  }
  std::vector<int> corners(found.all.size(), 0);
  std::vector<char> wrong(tubes.size(), 0);
  const auto refuse = [&](const TubePlace& a, const TubePlace& b, const Vec2& at) {
    if (wrong[a.tube] != 0 && wrong[b.tube] != 0) return;
    LineFinding& finding = found.findings.emplace_back(LineFinding{overlap_beside(drawing, tubes, a, b, at), {}});
    for (Index line = 0; line < lines.size(); ++line) {
      if (lines[line].centre_line == a.tube || lines[line].centre_line == b.tube) finding.lines.push_back(line);
    }
    wrong[a.tube] = wrong[b.tube] = 1;
  };
  for (const SegmentContact& contact : find_contacts(SegmentGrid(std::move(segments), step))) {
    const TubePlace a = lines[contact.a.line].tube_place(contact.a.position);
    const TubePlace b = lines[contact.b.line].tube_place(contact.b.position);
    const PassingAt passing = passing_at(found.all, a, b);
    if (passing.passing == no_index) {
      refuse(a, b, contact.at);
    } else {
      ++corners[passing.passing];
    }
  }
  std::vector<TubePassing> kept;
  for (Index k = 0; k < corners.size(); ++k) {
    const TubePassing& passing = found.all[k];
    const TubePlace a{passing.tube[0], passing.along[0]}, b{passing.tube[1], passing.along[1]};
    const bool at_end =
        is_at_end(tubes[a.tube], a.along, passing.reach[0]) || is_at_end(tubes[b.tube], b.along, passing.reach[1]);
    if (corners[k] == 4 || (at_end && corners[k] == 2)) {
      kept.push_back(passing);
    } else if (corners[k] != 0 || !at_end) {
      refuse(a, b, passing.crossing.at);
    }
  }
  found.all = std::move(kept);
}

/// Numbers the crossings along every tube and says which strand lies in front.
void decide_over(const Drawing& drawing, const std::vector<CentreLine>& tubes, std::vector<TubePassing>& passings) {
  std::vector<char> is_given(passings.size(), 0);
  for (Index tube = 0; tube < tubes.size(); ++tube) {
    std::vector<std::tuple<double, Index, Index>> visits;  // along, passing, which of its two
    for (Index p = 0; p < passings.size(); ++p) {
      for (const Index k : {0U, 1U}) {
        if (passings[p].tube[k] == tube) visits.emplace_back(passings[p].along[k], p, k);
      }
    }
    std::ranges::sort(visits);
    const Stroke& stroke = drawing.strokes[tubes[tube].stroke];
    const std::vector<std::string_view> words = over_words(stroke);
    Index position = 0;
    bool turn = false;  // of the last crossing with itself: over
    for (const auto& [along, p, k] : visits) {
      TubePassing& passing = passings[p];
      const Index other = passing.tube[1 - k];
      if (other == tube) turn = !turn;
      if (other == tube && k == 1) continue;
      const std::string_view word = position < words.size() ? words[position] : auto_word;
      const bool given = word != auto_word;
      bool over = word == over_word;
      if (!given) over = other == tube ? turn : !is_set_behind(stroke, drawing.strokes[tubes[other].stroke]);
      // Tubes come in the order of drawing: the word of the later one is read last, and without one it is in front.
      if (given || (other <= tube && is_given[p] == 0)) passing.first_over = over == (k == 0);
      is_given[p] |= given ? 1 : 0;
      if (other <= tube) {
        passing.crossing = {tubes[tube].stroke, tubes[other].stroke, position, passing.first_over == (k == 0),
                            passing.crossing.at};
      }
      ++position;
    }
  }
}

}  // namespace

PassingAt passing_at(const std::vector<TubePassing>& passings, const TubePlace& a, const TubePlace& b) {
  PassingAt found;
  double least = 1;
  for (Index p = 0; p < passings.size(); ++p) {
    const TubePassing& passing = passings[p];
    for (const Index k : {0U, 1U}) {  // a is the first of the two, or the second
      if (passing.tube[k] != a.tube || passing.tube[1 - k] != b.tube) continue;
      const double distance =
          std::max(apart(a.along, passing.along[k], passing.period[k]) / passing.reach[k],
                   apart(b.along, passing.along[1 - k], passing.period[1 - k]) / passing.reach[1 - k]);
      if (distance >= least) continue;
      least = distance;
      found = {p, passing.first_over == (k == 0) ? 0U : 1U};
    }
  }
  return found;
}

TubePassings find_passings(const Drawing& drawing, const std::vector<CentreLine>& tubes,
                           const std::vector<CleanLine>& lines, const DrawingScale& scale) {
  TubePassings found;
  if (tubes.empty()) return found;
  found.all = crossings_of_centre_lines(tubes, scale.step);
  match_outlines(drawing, tubes, lines, scale.step, found);
  decide_over(drawing, tubes, found.all);
  return found;
}

}  // namespace croquis::silhouette

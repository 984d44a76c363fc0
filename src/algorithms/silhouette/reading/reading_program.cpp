// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/reading/reading_program.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "algorithms/silhouette/reading/reading_costs.h"
#include "croquis/geometry/disjoint_sets.h"
#include "croquis/geometry/polyline.h"

namespace croquis::silhouette {
namespace {

using Term = IntegerProgram::Term;
using Sides = ReadingVariables::Sides;

// Bounds of the search for one reading: branches, and how much better than it another one may be. The first reading
// gets all that it needs of the branches for all of them; the last resort needs hardly any.
constexpr int maximum_reading_nodes = 200;
constexpr int maximum_nodes = 400;
constexpr int least_nodes = 20;
constexpr double reading_gap = 0.003;
// A stroke bounds the region on one side of it when it does so over this share of its length.
constexpr double sided_share = 0.5;
// A stroke that costs so much more as a contour than otherwise is none, even where others could pass behind it.
constexpr double hopeless = 3;
// An end that is cut off at a bar takes a crossing with it that lies within this share of what is cut off.
constexpr double cut_share = 0.9;
// A stroke lies on an outline that shares this much of the length of the shorter one.
constexpr double least_shared = 0.04;

/// Whether a stroke that was given a kind may be read as another one.
bool allowed(StrokeKind given, LineKind kind) {
  switch (given) {
    case StrokeKind::Visible:
    case StrokeKind::Hidden: return true;
    case StrokeKind::Contour: return kind == LineKind::Contour || kind == LineKind::Region;
    case StrokeKind::Part:
    case StrokeKind::Blob:
    case StrokeKind::Hole: return kind == LineKind::Contour;
    case StrokeKind::Detail:
    case StrokeKind::Scribble: return kind == LineKind::Detail;
    case StrokeKind::Tube: return kind == LineKind::Tube;
    case StrokeKind::Ignored: return kind == LineKind::Ignored;
  }
  return true;
}

constexpr Index on_left = 0, on_right = 1;

void add_terms(const Sides& variables, double factor, std::vector<Term>& row) {
  row.push_back({variables[on_left], factor});
  if (variables[on_right] != variables[on_left]) row.push_back({variables[on_right], factor});
}

double share_in(double part, double whole) { return whole > 0 ? std::min(1.0, part / whole) : 0; }

/// What is measured of a stroke, once.
struct StrokeFeatures {
  bool closed = false;
  double size = 0;               ///< in parts of the drawing's
  double length = 0;             ///< in parts of all lines'
  double width = 0;              ///< of what it encloses, in parts of the drawing's size
  double seen = 0;               ///< see Envelope
  double outside = 0;            ///< see Envelope
  double shared = 0;             ///< the largest share of it on one outline
  double crossings = 0;          ///< what they cost
  double hanging = 0;            ///< how much of the drawing's length the strokes that touch one another up to it are
  double pattern = 0;            ///< how much it is one of many curls or spots within everything
  int side = 0;                  ///< where the region that it bounds has its surface: left (+1), right (-1), or 0
  std::vector<Index> regions{};  ///< on whose outlines it lies

  bool is_within() const { return seen == 0 && outside == 0; }

  /// Of a whole outline: what it costs that it encloses little, or is one of many.
  double cost_as_outline() const {
    return costs::thin_outline * std::max(0.0, 1 - width / costs::thin_width) + costs::one_of_many * pattern;
  }

  double cost(LineKind kind) const {
    switch (kind) {
      case LineKind::Contour: return costs::contour + crossings + (closed ? cost_as_outline() : 0);
      case LineKind::Region:
        return costs::stroke_of_region + costs::rest_of_stroke * (1 - shared) * std::min(1.0, 2 * size) +
               costs::lost_of_stroke * outside;
      case LineKind::Detail:
        return costs::detail + costs::outline_left_out * seen + costs::size * std::min(1.0, 2 * size) +
               (closed ? (1 - pattern) * (costs::closed_detail + 4 * size) : 0) + costs::detail_outside * outside;
      case LineKind::Tube:
        return costs::tube + costs::outline_as_tube * seen + costs::tube_inside * (1 - outside) +
               costs::tube_size * size + costs::tube_apart * (1 - hanging);
      case LineKind::Ignored:
        return costs::ignored + costs::outline_left_out * seen + costs::ignored_hanging * hanging +
               costs::ignored_length * length;
    }
    return 0;
  }
};

/// Of all strokes.
std::vector<StrokeFeatures> features_of(const std::vector<SampledStroke>& strokes, const Connections& found,
                                        const Envelope& envelope) {
  double total = 0;
  for (const SampledStroke& stroke : strokes) total += stroke.length;
  std::vector<StrokeFeatures> all;
  for (Index s = 0; s < strokes.size(); ++s) {
    const SampledStroke& line = strokes[s];
    const double width = 2 * std::abs(signed_area(line.points)) / line.length / envelope.diagonal;
    StrokeFeatures& own =
        all.emplace_back(StrokeFeatures{line.closed, share_in(line.size, envelope.diagonal),
                                        share_in(line.length, total), width, envelope.seen[s], envelope.outside[s]});
    double left = 0;
    for (Index r = 0; r < envelope.regions.size(); ++r) {
      const EnclosedRegion& region = envelope.regions[r];
      own.shared = std::max(own.shared, share_in(region.shared[s], line.length));
      left += region.left[s];
      const double shorter = std::min(line.length, length(region.outline, true));
      if (region.shared[s] > least_shared * shorter) own.regions.push_back(r);
    }
    if (std::abs(left) >= sided_share * line.length) own.side = left > 0 ? 1 : -1;
  }
  DisjointSets things(strokes.size());
  for (const auto& [pair, count] : found.crossings) {
    const auto& [a, b] = pair;
    things.unite(a, b);
    const Index smaller = strokes[a].size < strokes[b].size ? a : b;  // that is to blame
    all[smaller].crossings += a == b ? costs::own_crossing * std::min(count, costs::most_own_crossings)
                                     : costs::crossing * std::min(count, costs::most_crossings);
  }
  for (const EndMeeting& meeting : found.meetings) things.unite(found.ends[meeting.end].stroke, meeting.bar);
  for (const EndJoin& join : found.joins) {
    if (join.gap < 1) things.unite(found.ends[join.a].stroke, found.ends[join.b].stroke);
  }
  // Strokes that touch one another hang on the drawing where one of them lies on the outline of a region, or where they
  // are half of the drawing themselves, such as a man of sticks.
  std::vector<double> hanging(strokes.size(), 0);
  for (Index s = 0; s < all.size(); ++s) hanging[things.root(s)] += all[s].regions.empty() ? 2 * all[s].length : 1;
  for (Index s = 0; s < all.size(); ++s) all[s].hanging = std::min(1.0, hanging[things.root(s)]);
  constexpr double alike = 2, least = 4, most = 7;  // a face has four
  for (StrokeFeatures& own : all) {
    const auto others = std::ranges::count_if(all, [&](const StrokeFeatures& other) {
      const double ratio = other.size / own.size;
      return other.is_within() && ratio < alike && ratio > 1 / alike;
    });
    if (own.is_within()) own.pattern = std::clamp((static_cast<double>(others) - 1 - least) / (most - least), 0.0, 1.0);
  }
  return all;
}

/// Per stroke: what it costs at least as a contour, with the cheapest meaning of its ends.
std::vector<double> least_contour_costs(const std::vector<StrokeFeatures>& features, const Connections& found) {
  std::vector<double> end(found.ends.size(), IntegerProgram::unbounded), hidden = end;
  const auto lower = [](std::vector<double>& least, const EndJoin& pair) {
    for (const Index e : {pair.a, pair.b}) least[e] = std::min(least[e], pair.cost / 2);
  };
  for (const EndJoin& pair : found.hidden) lower(hidden, pair);
  for (const EndJoin& join : found.joins) lower(end, join);
  for (const EndMeeting& meeting : found.meetings) {
    end[meeting.end] = std::min(end[meeting.end], meeting.cost + hidden[meeting.end]);
  }
  std::vector<double> least;
  for (const StrokeFeatures& stroke : features) least.push_back(stroke.cost(LineKind::Contour));
  for (Index e = 0; e < end.size(); ++e) least[found.ends[e].stroke] += end[e];
  return least;
}

/// What a reading is chosen from.
struct Candidates {
  const std::vector<SampledStroke>& strokes;
  const Connections& connections;
  std::size_t regions;
  std::vector<StrokeFeatures> features;  ///< per stroke

  Index stroke_of(Index end) const { return connections.ends[end].stroke; }
};

/// Σ x(s,k,o) = 1.
void add_strokes(const Candidates& from, IntegerProgram& program, ReadingVariables& variables) {
  const std::vector<double> least = least_contour_costs(from.features, from.connections);
  for (Index s = 0; s < from.strokes.size(); ++s) {
    const StrokeFeatures& own = from.features[s];
    const double cost_as_tube = own.closed ? IntegerProgram::unbounded : own.cost(LineKind::Tube);
    const double otherwise = std::min({own.cost(LineKind::Detail), own.cost(LineKind::Ignored), cost_as_tube});
    const bool is_hopeless = from.strokes[s].given_kind == StrokeKind::Visible && least[s] > otherwise + hopeless;
    std::array<Sides, ReadingVariables::kind_count> kinds{};
    std::vector<Term> one;
    for (std::size_t k = 0; k < kinds.size(); ++k) {
      const auto kind = static_cast<LineKind>(k);
      const bool possible = from.connections.doubled[s] != no_index ? kind == LineKind::Ignored
                            : kind == LineKind::Region              ? !own.regions.empty()
                            : kind == LineKind::Tube                ? !own.closed
                                                                    : kind != LineKind::Contour || !is_hopeless;
      const double most = possible && allowed(from.strokes[s].given_kind, kind) ? 1 : 0;
      const bool bounds = kind == LineKind::Contour || kind == LineKind::Region;
      kinds[k].fill(program.add_variable(0, bounds && own.side < 0 ? 0 : most, own.cost(kind)));
      if (bounds) kinds[k][on_right] = program.add_variable(0, own.side > 0 ? 0 : most, own.cost(kind));
      add_terms(kinds[k], 1, one);
    }
    program.add_row(one, 1, 1);
    variables.kind.push_back(kinds);
  }
  variables.kinds_end = program.variable_count();
}

/// Σ_o x(s,Region,o) <= Σ r of regions that s lies on; Σ_o x(s,Contour,o) + r <= 1 for these.
void add_regions(const Candidates& from, IntegerProgram& program, ReadingVariables& variables) {
  for (std::size_t k = 0; k < from.regions; ++k) {
    variables.region.emplace_back().fill(program.add_variable(0, 1, costs::region));
  }
  for (Index s = 0; s < from.strokes.size(); ++s) {
    std::vector<Term> needs_one;
    add_terms(variables.of(s, LineKind::Region), 1, needs_one);
    for (const Index k : from.features[s].regions) {
      add_terms(variables.region[k], -1, needs_one);
      std::vector<Term> either;
      add_terms(variables.region[k], 1, either);
      add_terms(variables.of(s, LineKind::Contour), 1, either);
      program.add_row(std::move(either), 0, 1);
    }
    program.add_row(std::move(needs_one), -IntegerProgram::unbounded, 0);
  }
}

/// Σ j(o) + Σ m(o) = x(s,Contour,o) at each end for each side; Σ h(o) = Σ m(o) likewise;
/// Σ_o m(o) <= x(bar,Contour,p) + x(bar,Region,p) for the side p of the bar that the meeting says.
void add_connections(const Candidates& from, IntegerProgram& program, ReadingVariables& variables) {
  const std::vector<StrokeFeatures>& features = from.features;
  const std::vector<LineEnd>& ends = from.connections.ends;
  std::vector<std::vector<Term>> visible(2 * ends.size()), hidden(2 * ends.size());  // per end and side
  for (Index e = 0; e < ends.size(); ++e) {
    for (const Index side : {on_left, on_right}) {
      visible[2 * e + side].push_back({variables.of(ends[e].stroke, LineKind::Contour)[side], -1});
    }
  }
  // A line that goes on from one end to another one of its kind is walked against the direction of one of their
  // strokes.
  const auto add_pair = [&](const EndJoin& pair, double more, std::vector<std::vector<Term>>& rows) {
    const bool turned = ends[pair.a].at_start == ends[pair.b].at_start;
    Sides taken{};
    for (const Index side : {on_left, on_right}) {
      taken[side] = program.add_variable(0, 1, pair.cost + more);
      rows[2 * pair.a + side].push_back({taken[side], 1});
      rows[2 * pair.b + (turned ? 1 - side : side)].push_back({taken[side], 1});
    }
    return taken;
  };
  for (const EndJoin& join : from.connections.joins) {
    const Index a = from.stroke_of(join.a), b = from.stroke_of(join.b);
    const bool opens_within = join.gap >= 1 && features[a].is_within() && features[b].is_within();
    const double more = (a == b ? features[a].cost_as_outline() : 0) + (opens_within ? costs::opening_within : 0);
    variables.join.push_back(add_pair(join, more, visible));
  }
  for (const EndMeeting& meeting : from.connections.meetings) {
    const Index front = meeting.side > 0 ? on_left : on_right;
    std::vector<Term> has_bar{{variables.of(meeting.bar, LineKind::Contour)[front], -1},
                              {variables.of(meeting.bar, LineKind::Region)[front], -1}};
    Sides& taken = variables.meeting.emplace_back();
    for (const Index side : {on_left, on_right}) {
      taken[side] = program.add_variable(0, 1, meeting.cost);
      visible[2 * meeting.end + side].push_back({taken[side], 1});
      hidden[2 * meeting.end + side].push_back({taken[side], -1});
    }
    add_terms(taken, 1, has_bar);
    program.add_row(std::move(has_bar), -1, 0);
  }
  for (const EndJoin& pair : from.connections.hidden) {
    const Index stroke = from.stroke_of(pair.a);
    const bool is_limb = from.stroke_of(pair.b) == stroke;
    const Sides taken = add_pair(pair, is_limb ? features[stroke].cost_as_outline() : 0, hidden);
    // The surface of a limb lies in what its line goes round.
    variables.hidden.push_back(taken);
    if (is_limb) program.fix(taken[signed_area(from.strokes[stroke].points) > 0 ? on_right : on_left], 0);
  }
  for (auto* rows : {&visible, &hidden}) {
    for (std::vector<Term>& row : *rows) {
      if (!row.empty()) program.add_row(std::move(row), 0, 0);
    }
  }
}

/// A line has hidden ends when an end of one of its strokes meets a bar.
void add_open_lines(const Connections& connections, IntegerProgram& program, ReadingVariables& variables) {
  const auto open_of = [&](Index end) { return variables.open[connections.ends[end].stroke]; };
  for (std::size_t s = 0; s < variables.kind.size(); ++s) variables.open.push_back(program.add_variable(0, 1, 0));
  std::vector<std::vector<Term>> meets_bar;  // per end
  for (const LineEnd& end : connections.ends) meets_bar.push_back({{variables.open[end.stroke], -1}});
  for (std::size_t i = 0; i < variables.meeting.size(); ++i) {
    add_terms(variables.meeting[i], 1, meets_bar[connections.meetings[i].end]);
  }
  for (std::vector<Term>& row : meets_bar) program.add_row(std::move(row), -1, 0);
  for (std::size_t i = 0; i < variables.join.size(); ++i) {
    const Index a = open_of(connections.joins[i].a);
    const Index b = open_of(connections.joins[i].b);
    if (a == b) continue;
    for (const auto& [from, to] : {std::pair(a, b), std::pair(b, a)}) {
      std::vector<Term> row{{from, 1}, {to, -1}};
      add_terms(variables.join[i], 1, row);
      program.add_row(std::move(row), -1, 1);
    }
  }
}

}  // namespace

ReadingProgram::ReadingProgram(const std::vector<SampledStroke>& strokes, const Connections& connections,
                               const Envelope& envelope)
    : strokes_(strokes), connections_(connections) {
  const Candidates from{strokes, connections, envelope.regions.size(), features_of(strokes, connections, envelope)};
  for (const StrokeFeatures& own : from.features) can_be_limb_.push_back(!own.closed && own.hanging >= 1 ? 1 : 0);
  add_strokes(from, program_, variables_);
  add_regions(from, program_, variables_);
  add_connections(from, program_, variables_);
}

void ReadingProgram::pin(Index a, Index b, bool joined) {
  std::vector<Term> taken;
  bool may_be_hidden = false;
  const auto add = [&](const std::vector<EndJoin>& pairs, const std::vector<Sides>& variables) {
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      if (pairs[i].a != std::min(a, b) || pairs[i].b != std::max(a, b)) continue;
      add_terms(variables[i], 1, taken);
      may_be_hidden = may_be_hidden || &pairs == &connections_.hidden;
    }
  };
  add(connections_.joins, variables_.join);
  add(connections_.hidden, variables_.hidden);
  if (!joined || may_be_hidden) {
    if (!taken.empty()) program_.add_row(std::move(taken), joined ? 1 : 0, joined ? 1 : 0);
    return;
  }
  // Only the likeliest hidden pairs are among the candidates: contours of this one are completed all the same.
  for (const Index end : {a, b}) {
    std::vector<Term> contour;
    add_terms(variables_.of(stroke_of(end), LineKind::Contour), 1, contour);
    program_.add_row(std::move(contour), 1, 1);
  }
}

std::optional<Reading> ReadingProgram::best() {
  const int nodes = std::clamp(maximum_nodes - nodes_, least_nodes, maximum_reading_nodes);
  const IntegerProgram::Solution solution = program_.solve(nodes, reading_gap, variables_.kinds_end);
  nodes_ += solution.nodes;
  if (solution.values.empty()) return std::nullopt;
  const auto is_taken = [&](const Sides& sides) {
    return solution.values[sides[on_left]] != 0 || solution.values[sides[on_right]] != 0;
  };
  const auto taken_of = [&](const std::vector<Sides>& candidates) {
    std::vector<Index> taken;
    for (Index i = 0; i < candidates.size(); ++i) {
      if (is_taken(candidates[i])) taken.push_back(i);
    }
    return taken;
  };
  Reading reading{
      {}, taken_of(variables_.join), taken_of(variables_.meeting), taken_of(variables_.region), solution.cost};
  for (const auto& kinds : variables_.kind) {
    reading.kinds.push_back(static_cast<LineKind>(std::ranges::find_if(kinds, is_taken) - kinds.begin()));
  }
  return reading;
}

void ReadingProgram::exclude(const Reading& reading, const std::vector<Index>& strokes, bool connections) {
  const auto is_meant = [&](Index stroke) { return strokes.empty() || std::ranges::count(strokes, stroke) > 0; };
  std::vector<Term> all;
  double count = 0;
  const auto add = [&](const Sides& taken) {
    add_terms(taken, 1, all);
    ++count;
  };
  for (Index s = 0; s < strokes_.size(); ++s) {
    if (!is_meant(s)) continue;
    add(variables_.of(s, reading.kinds[s]));
    // Whether a line is a detail or none makes no difference to contours.
    if (reading.kinds[s] == LineKind::Detail) add_terms(variables_.of(s, LineKind::Ignored), 1, all);
    if (reading.kinds[s] == LineKind::Ignored) add_terms(variables_.of(s, LineKind::Detail), 1, all);
  }
  for (std::size_t i = 0; connections && i < reading.joins.size(); ++i) {
    const EndJoin& join = connections_.joins[reading.joins[i]];
    if (is_meant(stroke_of(join.a)) || is_meant(stroke_of(join.b))) add(variables_.join[reading.joins[i]]);
  }
  for (std::size_t i = 0; connections && i < reading.meetings.size(); ++i) {
    const EndMeeting& meeting = connections_.meetings[reading.meetings[i]];
    if (is_meant(stroke_of(meeting.end)) || is_meant(meeting.bar)) add(variables_.meeting[reading.meetings[i]]);
  }
  program_.add_row(std::move(all), 0, count - 1);
}

bool ReadingProgram::exclude_crossing(const Reading& reading, Index a, Index b, const Vec2& at) {
  DisjointSets lines(strokes_.size());
  for (const Index join : reading.joins) {
    lines.unite(stroke_of(connections_.joins[join].a), stroke_of(connections_.joins[join].b));
  }
  const auto is_open = [&](Index stroke) {
    return reading.kinds[stroke] == LineKind::Contour && std::ranges::any_of(reading.meetings, [&](Index meeting) {
             return lines.root(stroke_of(connections_.meetings[meeting].end)) == lines.root(stroke);
           });
  };
  if (!is_open(a) || !is_open(b)) return false;
  if (variables_.open.empty()) add_open_lines(connections_, program_, variables_);
  std::vector<Term> terms;
  add_terms({variables_.open[a], variables_.open[b]}, 1, terms);
  // Other connections may cut off the end that crosses.
  for (Index i = 0; i < variables_.meeting.size(); ++i) {
    const EndMeeting& meeting = connections_.meetings[i];
    const Index stroke = stroke_of(meeting.end);
    const bool cuts =
        meeting.along < 0 && -meeting.along > cut_share * (connections_.ends[meeting.end].place - at).norm();
    const bool taken = std::ranges::count(reading.meetings, i) > 0;
    if ((stroke == a || stroke == b) && cuts && !taken) add_terms(variables_.meeting[i], -1, terms);
  }
  program_.add_row(std::move(terms), -IntegerProgram::unbounded, a == b ? 0 : 1);
  return true;
}

std::vector<Index> ReadingProgram::contradictions() const {
  std::vector<Index> given, contradicting;
  for (Index s = 0; s < strokes_.size(); ++s) {
    if (strokes_[s].given_kind == StrokeKind::Visible) continue;
    given.push_back(s);
    IntegerProgram without = program_;
    for (const LineKind kind : {LineKind::Contour, LineKind::Detail, LineKind::Ignored}) set_most(without, s, kind, 1);
    if (!without.solve(least_nodes, reading_gap, variables_.kinds_end).values.empty()) contradicting.push_back(s);
  }
  return contradicting.empty() ? given : contradicting;
}

void ReadingProgram::set_most(IntegerProgram& program, Index stroke, LineKind kind, double most) const {
  for (const Index variable : variables_.of(stroke, kind)) program.set_bounds(variable, 0, most);
}

void ReadingProgram::forbid_loss(Index stroke) {
  set_most(program_, stroke, LineKind::Detail, 0);
  if (can_be_limb_[stroke] != 0) set_most(program_, stroke, LineKind::Ignored, 0);
}

void ReadingProgram::forbid(LineKind kind) {
  for (Index s = 0; s < strokes_.size(); ++s) set_most(program_, s, kind, 0);
}

void ReadingProgram::allow_regions_only() {
  forbid(LineKind::Contour);
  for (const Sides& region : variables_.region) program_.fix(region[on_left], 1);
}

}  // namespace croquis::silhouette

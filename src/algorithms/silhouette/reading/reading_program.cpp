// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/reading/reading_program.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include <Eigen/Geometry>

#include "algorithms/silhouette/reading/reading_costs.h"
#include "croquis/geometry/disjoint_sets.h"
#include "croquis/geometry/polyline.h"

namespace croquis::silhouette {
namespace {

using Term = IntegerProgram::Term;

// Bounds of the search for one reading: branches, and how much better than it another one may be. The first reading
// gets all that it needs of the branches for all of them; the last resort needs hardly any.
constexpr int maximum_reading_nodes = 300;
constexpr int maximum_nodes = 600;
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

/// Whether a stroke of which that is told may be taken for that.
bool allowed(StrokeKind told, LineKind kind) {
  switch (told) {
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

bool contains(const std::vector<EndJoin>& joins, const EndJoin& join) {
  return std::ranges::any_of(joins, [&](const EndJoin& other) { return other.a == join.a && other.b == join.b; });
}

bool contains(const std::vector<EndMeeting>& meetings, const EndMeeting& meeting) {
  return std::ranges::any_of(meetings, [&](const EndMeeting& other) {
    return other.end == meeting.end && other.bar == meeting.bar && other.side == meeting.side;
  });
}

constexpr std::size_t on_left = 0, on_right = 1;

void add_terms(const std::array<Index, 2>& variables, double factor, std::vector<Term>& row) {
  row.push_back({variables[on_left], factor});
  if (variables[on_right] != variables[on_left]) row.push_back({variables[on_right], factor});
}

double share_in(double part, double whole) { return whole > 0 ? std::min(1.0, part / whole) : 0; }

}  // namespace

ReadingProgram::ReadingProgram(const std::vector<SampledStroke>& strokes, const Connections& connections,
                               const Envelope& envelope)
    : strokes_(strokes), connections_(connections), envelope_(envelope), crossings_(strokes.size(), 0) {
  Eigen::AlignedBox2d box;
  total_length_ = 0;
  for (const SampledStroke& stroke : strokes) {
    total_length_ += stroke.length;
    for (const Vec2& point : stroke.points) box.extend(point);
  }
  extent_ = box.diagonal().norm();
  for (const StrokeCrossing& crossing : connections.crossings) {
    if (crossing.a == crossing.b) {
      crossings_[crossing.a] += costs::own_crossing * std::min(crossing.count, costs::most_own_crossings);
    } else {  // the smaller one is to blame
      const Index smaller = strokes[crossing.a].size < strokes[crossing.b].size ? crossing.a : crossing.b;
      crossings_[smaller] += costs::crossing * std::min(crossing.count, costs::most_crossings);
    }
  }
  hanging_ = hanging();
  add_strokes();
  add_regions();
  add_connections();
}

/// Per stroke how much of the drawing's length the strokes that touch one another up to it are, 0..1: all of it where
/// one of them lies on the outline of a region, or they are half of the drawing, such as a man of sticks.
std::vector<double> ReadingProgram::hanging() const {
  DisjointSets things(strokes_.size());
  for (const StrokeCrossing& crossing : connections_.crossings) things.unite(crossing.a, crossing.b);
  for (const EndMeeting& meeting : connections_.meetings)
    things.unite(connections_.ends[meeting.end].stroke, meeting.bar);
  for (const EndJoin& join : connections_.joins) {
    if (join.gap < 1) things.unite(connections_.ends[join.a].stroke, connections_.ends[join.b].stroke);
  }
  std::vector<double> share(strokes_.size(), 0), hanging;
  for (Index s = 0; s < strokes_.size(); ++s) {
    share[things.root(s)] += lies_on_any(s) ? 1 : 2 * share_in(strokes_[s].length, total_length_);
  }
  for (Index s = 0; s < strokes_.size(); ++s) hanging.push_back(std::min(1.0, share[things.root(s)]));
  return hanging;
}

bool ReadingProgram::lies_on(Index stroke, const EnclosedRegion& region) const {
  return region.shared[stroke] > least_shared * std::min(strokes_[stroke].length, length(region.outline, true));
}

bool ReadingProgram::lies_on_any(Index stroke) const {
  return std::ranges::any_of(envelope_.regions, [&](const auto& region) { return lies_on(stroke, region); });
}

bool ReadingProgram::is_within(Index stroke) const {
  return envelope_.seen[stroke] == 0 && envelope_.outside[stroke] == 0;
}

/// How much a stroke is one of many curls or spots within everything, 0..1. A face has four.
double ReadingProgram::pattern(Index stroke) const {
  constexpr double alike = 2;
  constexpr double least = 4, most = 7;
  if (!is_within(stroke)) return 0;
  int others = 0;
  for (Index s = 0; s < strokes_.size(); ++s) {
    const double ratio = strokes_[s].size / strokes_[stroke].size;
    if (s != stroke && is_within(s) && ratio < alike && ratio > 1 / alike) ++others;
  }
  return std::clamp((others - least) / (most - least), 0.0, 1.0);
}

/// Of a stroke that is a whole outline: what it costs that it encloses little, or is one of many.
double ReadingProgram::cost_as_outline(Index stroke) const {
  const SampledStroke& line = strokes_[stroke];
  const double width = 2 * std::abs(signed_area(line.points)) / line.length;
  return costs::thin_outline * std::max(0.0, 1 - width / (costs::thin_width * extent_)) +
         costs::one_of_many * pattern(stroke);
}

double ReadingProgram::cost(Index stroke, LineKind kind) const {
  const SampledStroke& line = strokes_[stroke];
  const double seen = envelope_.seen[stroke];
  const double outside = envelope_.outside[stroke];
  const double size = share_in(line.size, extent_);
  switch (kind) {
    case LineKind::Contour: return costs::contour + crossings_[stroke] + (line.closed ? cost_as_outline(stroke) : 0);
    case LineKind::Region: {
      double shared = 0;
      for (const EnclosedRegion& region : envelope_.regions) shared = std::max(shared, region.shared[stroke]);
      const double rest = 1 - share_in(shared, line.length);
      return costs::stroke_of_region + costs::rest_of_stroke * rest * std::min(1.0, 2 * size) +
             costs::lost_of_stroke * outside;
    }
    case LineKind::Detail:
      return costs::detail + costs::outline_left_out * seen + costs::size * std::min(1.0, 2 * size) +
             (line.closed ? (1 - pattern(stroke)) * (costs::closed_detail + 4 * size) : 0) +
             costs::detail_outside * outside;
    case LineKind::Tube:
      return costs::tube + costs::outline_as_tube * seen + costs::tube_inside * (1 - outside) +
             costs::tube_size * size + costs::tube_apart * (1 - hanging_[stroke]);
    case LineKind::Ignored:
      return costs::ignored + costs::outline_left_out * seen + costs::ignored_hanging * hanging_[stroke] +
             costs::ignored_length * share_in(line.length, total_length_);
  }
  return 0;
}

/// The side on which a stroke's surface lies as far as the region that it bounds tells: left (+1), right (-1), or 0.
int ReadingProgram::known_side(Index stroke) const {
  double left = 0;
  for (const EnclosedRegion& region : envelope_.regions) left += region.left[stroke];
  if (std::abs(left) < sided_share * strokes_[stroke].length) return 0;
  return left > 0 ? 1 : -1;
}

double ReadingProgram::least_other_cost(Index stroke) const {
  const double otherwise = std::min(cost(stroke, LineKind::Detail), cost(stroke, LineKind::Ignored));
  return strokes_[stroke].closed ? otherwise : std::min(otherwise, cost(stroke, LineKind::Tube));
}

/// Per stroke: what it costs at least as a contour, with the cheapest meaning of its ends.
std::vector<double> ReadingProgram::least_contour_costs() const {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::vector<double> end(connections_.ends.size(), infinity), hidden(connections_.ends.size(), infinity);
  const auto lower = [](double& least, double cost) { least = std::min(least, cost); };
  for (const HiddenPair& pair : connections_.hidden) {
    lower(hidden[pair.a], pair.cost / 2);
    lower(hidden[pair.b], pair.cost / 2);
  }
  for (const EndMeeting& meeting : connections_.meetings) lower(end[meeting.end], meeting.cost + hidden[meeting.end]);
  for (const EndJoin& join : connections_.joins) {
    lower(end[join.a], join.cost / 2);
    lower(end[join.b], join.cost / 2);
  }
  std::vector<double> least;
  for (Index s = 0; s < strokes_.size(); ++s) least.push_back(cost(s, LineKind::Contour));
  for (Index e = 0; e < connections_.ends.size(); ++e) least[connections_.ends[e].stroke] += end[e];
  return least;
}

void ReadingProgram::add_strokes() {
  const std::vector<double> least = least_contour_costs();
  for (Index s = 0; s < strokes_.size(); ++s) {
    const int known = known_side(s);
    const bool told = strokes_[s].told != StrokeKind::Visible;
    const bool is_hopeless = !told && least[s] > least_other_cost(s) + hopeless;
    std::array<Sides, kind_count> kinds{};
    std::vector<Term> one;
    for (std::size_t k = 0; k < kind_count; ++k) {
      const auto kind = static_cast<LineKind>(k);
      const bool possible = connections_.doubled[s] != no_index ? kind == LineKind::Ignored
                            : kind == LineKind::Region          ? lies_on_any(s)
                            : kind == LineKind::Tube            ? !strokes_[s].closed
                                                                : kind != LineKind::Contour || !is_hopeless;
      const double most = possible && allowed(strokes_[s].told, kind) ? 1 : 0;
      if (kind == LineKind::Contour || kind == LineKind::Region) {
        kinds[k][on_left] = program_.add_variable(0, known < 0 ? 0 : most, cost(s, kind));
        kinds[k][on_right] = program_.add_variable(0, known > 0 ? 0 : most, cost(s, kind));
      } else {
        kinds[k].fill(program_.add_variable(0, most, cost(s, kind)));
      }
      add_terms(kinds[k], 1, one);
    }
    program_.add_row(one, 1, 1);
    kind_.push_back(kinds);
  }
  kinds_end_ = program_.variable_count();
}

void ReadingProgram::add_regions() {
  for (std::size_t k = 0; k < envelope_.regions.size(); ++k) {
    region_.push_back(program_.add_variable(0, 1, costs::region));
  }
  for (Index s = 0; s < strokes_.size(); ++s) {
    std::vector<Term> needs_one;
    add_terms(variables(s, LineKind::Region), 1, needs_one);
    for (std::size_t k = 0; k < region_.size(); ++k) {
      if (!lies_on(s, envelope_.regions[k])) continue;
      needs_one.push_back({region_[k], -1});
      std::vector<Term> either{{region_[k], 1}};
      add_terms(variables(s, LineKind::Contour), 1, either);
      program_.add_row(std::move(either), 0, 1);
    }
    program_.add_row(std::move(needs_one), -IntegerProgram::unbounded, 0);
  }
}

void ReadingProgram::add_connections() {
  const std::vector<LineEnd>& ends = connections_.ends;
  std::vector<std::array<std::vector<Term>, 2>> visible(ends.size()), hidden(ends.size());  // per end and side
  for (Index e = 0; e < ends.size(); ++e) {
    for (const std::size_t side : {on_left, on_right}) {
      visible[e][side].push_back({variables(ends[e].stroke, LineKind::Contour)[side], -1});
    }
  }
  // A line that goes on from one end to another one of its kind is walked against the direction of one of their
  // strokes.
  const auto add_pair = [&](Index a, Index b, double cost, auto& rows) {
    const bool turned = ends[a].at_start == ends[b].at_start;
    Sides taken{};
    for (const std::size_t side : {on_left, on_right}) {
      taken[side] = program_.add_variable(0, 1, cost);
      rows[a][side].push_back({taken[side], 1});
      rows[b][turned ? 1 - side : side].push_back({taken[side], 1});
    }
    return taken;
  };
  for (const EndJoin& join : connections_.joins) {
    const Index a = ends[join.a].stroke, b = ends[join.b].stroke;
    const bool opens_within = join.gap >= 1 && is_within(a) && is_within(b);
    const double more = (a == b ? cost_as_outline(a) : 0) + (opens_within ? costs::opening_within : 0);
    join_.push_back(add_pair(join.a, join.b, join.cost + more, visible));
  }
  for (const EndMeeting& meeting : connections_.meetings) {
    const std::size_t front = meeting.side > 0 ? on_left : on_right;
    std::vector<Term> has_bar{{variables(meeting.bar, LineKind::Contour)[front], -1},
                              {variables(meeting.bar, LineKind::Region)[front], -1}};
    Sides taken{};
    for (const std::size_t side : {on_left, on_right}) {
      taken[side] = program_.add_variable(0, 1, meeting.cost);
      visible[meeting.end][side].push_back({taken[side], 1});
      hidden[meeting.end][side].push_back({taken[side], -1});
      has_bar.push_back({taken[side], 1});
    }
    meeting_.push_back(taken);
    program_.add_row(std::move(has_bar), -1, 0);
  }
  for (const HiddenPair& pair : connections_.hidden) {
    const Index stroke = ends[pair.a].stroke;
    const bool is_limb = ends[pair.b].stroke == stroke;
    const Sides taken = add_pair(pair.a, pair.b, pair.cost + (is_limb ? cost_as_outline(stroke) : 0), hidden);
    // The surface of a limb lies in what its line goes round.
    if (is_limb) program_.fix(taken[signed_area(strokes_[stroke].points) > 0 ? on_right : on_left], 0);
  }
  for (auto* rows : {&visible, &hidden}) {
    for (auto& sides : *rows) {
      for (std::vector<Term>& row : sides) {
        if (!row.empty()) program_.add_row(std::move(row), 0, 0);
      }
    }
  }
}

std::optional<Reading> ReadingProgram::best() {
  const int nodes = std::clamp(maximum_nodes - nodes_, least_nodes, maximum_reading_nodes);
  const IntegerProgram::Solution solution = program_.solve(nodes, reading_gap, kinds_end_);
  nodes_ += solution.nodes;
  if (solution.values.empty()) return std::nullopt;
  const auto taken = [&](Index variable) { return solution.values[variable] != 0; };
  const auto either_taken = [&](const Sides& sides) { return taken(sides[on_left]) || taken(sides[on_right]); };
  Reading reading;
  for (Index s = 0; s < strokes_.size(); ++s) {
    const auto kind = std::ranges::find_if(kind_[s], either_taken);
    reading.kinds.push_back(static_cast<LineKind>(kind - kind_[s].begin()));
  }
  for (std::size_t i = 0; i < join_.size(); ++i) {
    if (either_taken(join_[i])) reading.joins.push_back(connections_.joins[i]);
  }
  for (std::size_t i = 0; i < meeting_.size(); ++i) {
    if (either_taken(meeting_[i])) reading.meetings.push_back(connections_.meetings[i]);
  }
  for (Index k = 0; k < region_.size(); ++k) {
    if (taken(region_[k])) reading.regions.push_back(k);
  }
  return reading;
}

void ReadingProgram::exclude(const Reading& reading, const std::vector<Index>& strokes, bool connections) {
  const auto is_meant = [&](Index stroke) { return strokes.empty() || std::ranges::count(strokes, stroke) > 0; };
  const auto stroke_of = [&](Index end) { return connections_.ends[end].stroke; };
  std::vector<Term> all;
  double count = 0;
  const auto add = [&](const Sides& taken) {
    add_terms(taken, 1, all);
    ++count;
  };
  for (Index s = 0; s < strokes_.size(); ++s) {
    if (!is_meant(s)) continue;
    add(variables(s, reading.kinds[s]));
    // Whether a line is a detail or none makes no difference to contours.
    if (reading.kinds[s] == LineKind::Detail) add_terms(variables(s, LineKind::Ignored), 1, all);
    if (reading.kinds[s] == LineKind::Ignored) add_terms(variables(s, LineKind::Detail), 1, all);
  }
  for (std::size_t i = 0; connections && i < join_.size(); ++i) {
    const EndJoin& join = connections_.joins[i];
    if (!contains(reading.joins, join)) continue;
    if (is_meant(stroke_of(join.a)) || is_meant(stroke_of(join.b))) add(join_[i]);
  }
  for (std::size_t i = 0; connections && i < meeting_.size(); ++i) {
    const EndMeeting& meeting = connections_.meetings[i];
    if (!contains(reading.meetings, meeting)) continue;
    if (is_meant(stroke_of(meeting.end)) || is_meant(meeting.bar)) add(meeting_[i]);
  }
  program_.add_row(std::move(all), 0, count - 1);
}

/// A line has hidden ends when an end of one of its strokes meets a bar.
void ReadingProgram::add_open_lines() {
  for (Index s = 0; s < strokes_.size(); ++s) open_.push_back(program_.add_variable(0, 1, 0));
  for (std::size_t i = 0; i < meeting_.size(); ++i) {
    std::vector<Term> row{{open_[connections_.ends[connections_.meetings[i].end].stroke], -1}};
    add_terms(meeting_[i], 1, row);
    program_.add_row(std::move(row), -1, 0);
  }
  for (std::size_t i = 0; i < join_.size(); ++i) {
    const Index a = open_[connections_.ends[connections_.joins[i].a].stroke];
    const Index b = open_[connections_.ends[connections_.joins[i].b].stroke];
    if (a == b) continue;
    for (const auto& [from, to] : {std::pair(a, b), std::pair(b, a)}) {
      std::vector<Term> row{{from, 1}, {to, -1}};
      add_terms(join_[i], 1, row);
      program_.add_row(std::move(row), -1, 1);
    }
  }
}

bool ReadingProgram::exclude_crossing(const Reading& reading, Index a, Index b, const Vec2& at) {
  DisjointSets lines(strokes_.size());
  const auto stroke_of = [&](Index end) { return connections_.ends[end].stroke; };
  for (const EndJoin& join : reading.joins) lines.unite(stroke_of(join.a), stroke_of(join.b));
  const auto is_open = [&](Index stroke) {
    return reading.kinds[stroke] == LineKind::Contour &&
           std::ranges::any_of(reading.meetings, [&](const auto& meeting) {
             return lines.root(stroke_of(meeting.end)) == lines.root(stroke);
           });
  };
  if (!is_open(a) || !is_open(b)) return false;
  if (open_.empty()) add_open_lines();
  std::vector<Term> terms;
  double most = -1;
  for (const Index stroke : std::set{a, b}) {
    add_terms(variables(stroke, LineKind::Contour), 1, terms);
    terms.push_back({open_[stroke], 1});
    most += 2;
  }
  // Other connections may cut off the end that crosses.
  for (std::size_t i = 0; i < meeting_.size(); ++i) {
    const EndMeeting& meeting = connections_.meetings[i];
    const Index stroke = stroke_of(meeting.end);
    const bool cuts =
        meeting.along < 0 && -meeting.along > cut_share * (connections_.ends[meeting.end].place - at).norm();
    if ((stroke == a || stroke == b) && cuts && !contains(reading.meetings, meeting)) add_terms(meeting_[i], -1, terms);
  }
  for (std::size_t i = 0; i < join_.size(); ++i) {
    const EndJoin& join = connections_.joins[i];
    const auto both = std::minmax({stroke_of(join.a), stroke_of(join.b)});
    if (both == std::minmax({a, b}) && !contains(reading.joins, join)) add_terms(join_[i], -1, terms);
  }
  program_.add_row(std::move(terms), -IntegerProgram::unbounded, most);
  return true;
}

std::vector<Index> ReadingProgram::contradictions() const {
  std::vector<Index> told, contradicting;
  for (Index s = 0; s < strokes_.size(); ++s) {
    if (strokes_[s].told == StrokeKind::Visible) continue;
    told.push_back(s);
    IntegerProgram without = program_;
    for (const LineKind kind : {LineKind::Contour, LineKind::Detail, LineKind::Ignored}) set_most(without, s, kind, 1);
    if (!without.solve(least_nodes, reading_gap, kinds_end_).values.empty()) contradicting.push_back(s);
  }
  return contradicting.empty() ? told : contradicting;
}

void ReadingProgram::set_most(IntegerProgram& program, Index stroke, LineKind kind, double most) const {
  for (const Index variable : variables(stroke, kind)) program.set_bounds(variable, 0, most);
}

void ReadingProgram::forbid_loss(Index stroke) {
  set_most(program_, stroke, LineKind::Detail, 0);
  const bool can_be_limb = !strokes_[stroke].closed && hanging_[stroke] >= 1;
  if (can_be_limb) set_most(program_, stroke, LineKind::Ignored, 0);
}

void ReadingProgram::forbid(LineKind kind) {
  for (Index s = 0; s < strokes_.size(); ++s) set_most(program_, s, kind, 0);
}

void ReadingProgram::allow_regions_only() {
  forbid(LineKind::Contour);
  for (const Index region : region_) program_.fix(region, 1);
}

}  // namespace croquis::silhouette

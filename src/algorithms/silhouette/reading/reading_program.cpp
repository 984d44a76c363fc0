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

/// What is measured of a stroke, once.
struct ReadingProgram::Features {
  bool closed = false;
  double size = 0;       ///< in parts of the drawing's
  double length = 0;     ///< in parts of all lines'
  double width = 0;      ///< of what it encloses, in parts of the drawing's size
  double seen = 0;       ///< see Envelope
  double outside = 0;    ///< see Envelope
  double shared = 0;     ///< the largest share of it on one outline
  double crossings = 0;  ///< what they cost
  double hanging = 0;    ///< how much of the drawing's length the strokes that touch one another up to it are
  double pattern = 0;    ///< how much it is one of many curls or spots within everything
  int side = 0;          ///< where the surface lies as the region that it bounds tells: left (+1), right (-1), or 0
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

  double least_other_cost() const {
    const double otherwise = std::min(cost(LineKind::Detail), cost(LineKind::Ignored));
    return closed ? otherwise : std::min(otherwise, cost(LineKind::Tube));
  }
};

ReadingProgram::ReadingProgram(const std::vector<SampledStroke>& strokes, const Connections& connections,
                               const Envelope& envelope)
    : strokes_(strokes), connections_(connections) {
  const std::vector<Features> features = measure(envelope);
  for (const Features& stroke : features) can_be_limb_.push_back(!stroke.closed && stroke.hanging >= 1 ? 1 : 0);
  add_strokes(features);
  add_regions(features, envelope.regions.size());
  add_connections(features);
}

std::vector<ReadingProgram::Features> ReadingProgram::measure(const Envelope& envelope) const {
  Eigen::AlignedBox2d box;
  double total = 0;
  DisjointSets things(strokes_.size());
  for (const SampledStroke& stroke : strokes_) {
    total += stroke.length;
    for (const Vec2& point : stroke.points) box.extend(point);
  }
  const double extent = box.diagonal().norm();
  std::vector<Features> all;
  for (Index s = 0; s < strokes_.size(); ++s) {
    const SampledStroke& line = strokes_[s];
    const double width = 2 * std::abs(signed_area(line.points)) / line.length / extent;
    Features& own = all.emplace_back(Features{line.closed, share_in(line.size, extent), share_in(line.length, total),
                                              width, envelope.seen[s], envelope.outside[s]});
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
  for (const auto& [a, b, count] : connections_.crossings) {
    things.unite(a, b);
    const Index smaller = strokes_[a].size < strokes_[b].size ? a : b;  // that is to blame
    all[smaller].crossings += a == b ? costs::own_crossing * std::min(count, costs::most_own_crossings)
                                     : costs::crossing * std::min(count, costs::most_crossings);
  }
  for (const EndMeeting& meeting : connections_.meetings) things.unite(stroke_of(meeting.end), meeting.bar);
  for (const EndJoin& join : connections_.joins) {
    if (join.gap < 1) things.unite(stroke_of(join.a), stroke_of(join.b));
  }
  // Strokes that touch one another hang on the drawing where one of them lies on the outline of a region, or where they
  // are half of the drawing themselves, such as a man of sticks.
  std::vector<double> hanging(strokes_.size(), 0);
  for (Index s = 0; s < all.size(); ++s) hanging[things.root(s)] += all[s].regions.empty() ? 2 * all[s].length : 1;
  for (Index s = 0; s < all.size(); ++s) {
    constexpr double alike = 2, least = 4, most = 7;  // a face has four
    all[s].hanging = std::min(1.0, hanging[things.root(s)]);
    const auto is_alike = [&](const Features& other) {
      const double ratio = other.size / all[s].size;
      return other.is_within() && ratio < alike && ratio > 1 / alike;
    };
    const auto others = std::ranges::count_if(all, is_alike) - 1;
    if (all[s].is_within())
      all[s].pattern = std::clamp((static_cast<double>(others) - least) / (most - least), 0.0, 1.0);
  }
  return all;
}

/// Per stroke: what it costs at least as a contour, with the cheapest meaning of its ends.
std::vector<double> ReadingProgram::least_contour_costs(const std::vector<Features>& features) const {
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
  for (const Features& stroke : features) least.push_back(stroke.cost(LineKind::Contour));
  for (Index e = 0; e < connections_.ends.size(); ++e) least[stroke_of(e)] += end[e];
  return least;
}

void ReadingProgram::add_strokes(const std::vector<Features>& features) {
  const std::vector<double> least = least_contour_costs(features);
  for (Index s = 0; s < strokes_.size(); ++s) {
    const int known = features[s].side;
    const bool told = strokes_[s].told != StrokeKind::Visible;
    const bool is_hopeless = !told && least[s] > features[s].least_other_cost() + hopeless;
    std::array<Sides, kind_count> kinds{};
    std::vector<Term> one;
    for (std::size_t k = 0; k < kind_count; ++k) {
      const auto kind = static_cast<LineKind>(k);
      const bool possible = connections_.doubled[s] != no_index ? kind == LineKind::Ignored
                            : kind == LineKind::Region          ? !features[s].regions.empty()
                            : kind == LineKind::Tube            ? !strokes_[s].closed
                                                                : kind != LineKind::Contour || !is_hopeless;
      const double most = possible && allowed(strokes_[s].told, kind) ? 1 : 0;
      if (kind == LineKind::Contour || kind == LineKind::Region) {
        kinds[k][on_left] = program_.add_variable(0, known < 0 ? 0 : most, features[s].cost(kind));
        kinds[k][on_right] = program_.add_variable(0, known > 0 ? 0 : most, features[s].cost(kind));
      } else {
        kinds[k].fill(program_.add_variable(0, most, features[s].cost(kind)));
      }
      add_terms(kinds[k], 1, one);
    }
    program_.add_row(one, 1, 1);
    kind_.push_back(kinds);
  }
  kinds_end_ = program_.variable_count();
}

void ReadingProgram::add_regions(const std::vector<Features>& features, std::size_t count) {
  for (std::size_t k = 0; k < count; ++k) region_.push_back(program_.add_variable(0, 1, costs::region));
  for (Index s = 0; s < strokes_.size(); ++s) {
    std::vector<Term> needs_one;
    add_terms(variables(s, LineKind::Region), 1, needs_one);
    for (const Index k : features[s].regions) {
      needs_one.push_back({region_[k], -1});
      std::vector<Term> either{{region_[k], 1}};
      add_terms(variables(s, LineKind::Contour), 1, either);
      program_.add_row(std::move(either), 0, 1);
    }
    program_.add_row(std::move(needs_one), -IntegerProgram::unbounded, 0);
  }
}

void ReadingProgram::add_connections(const std::vector<Features>& features) {
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
    const Index a = stroke_of(join.a), b = stroke_of(join.b);
    const bool opens_within = join.gap >= 1 && features[a].is_within() && features[b].is_within();
    const double more = (a == b ? features[a].cost_as_outline() : 0) + (opens_within ? costs::opening_within : 0);
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
    const Sides taken =
        add_pair(pair.a, pair.b, pair.cost + (is_limb ? features[stroke].cost_as_outline() : 0), hidden);
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
  std::vector<std::vector<Term>> meets_bar;  // per end
  for (const LineEnd& end : connections_.ends) meets_bar.push_back({{open_[end.stroke], -1}});
  for (std::size_t i = 0; i < meeting_.size(); ++i) add_terms(meeting_[i], 1, meets_bar[connections_.meetings[i].end]);
  for (std::vector<Term>& row : meets_bar) program_.add_row(std::move(row), -1, 0);
  for (std::size_t i = 0; i < join_.size(); ++i) {
    const Index a = open_[stroke_of(connections_.joins[i].a)];
    const Index b = open_[stroke_of(connections_.joins[i].b)];
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
    terms.push_back({open_[stroke], 1});
    ++most;
  }
  // Other connections may cut off the end that crosses.
  for (std::size_t i = 0; i < meeting_.size(); ++i) {
    const EndMeeting& meeting = connections_.meetings[i];
    const Index stroke = stroke_of(meeting.end);
    const bool cuts =
        meeting.along < 0 && -meeting.along > cut_share * (connections_.ends[meeting.end].place - at).norm();
    if ((stroke == a || stroke == b) && cuts && !contains(reading.meetings, meeting)) add_terms(meeting_[i], -1, terms);
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
  if (can_be_limb_[stroke] != 0) set_most(program_, stroke, LineKind::Ignored, 0);
}

void ReadingProgram::forbid(LineKind kind) {
  for (Index s = 0; s < strokes_.size(); ++s) set_most(program_, s, kind, 0);
}

void ReadingProgram::allow_regions_only() {
  forbid(LineKind::Contour);
  for (const Index region : region_) program_.fix(region, 1);
}

}  // namespace croquis::silhouette

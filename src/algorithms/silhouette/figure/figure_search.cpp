// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <iterator>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <utility>

#include <Eigen/Geometry>

#include "algorithms/silhouette/figure/labelling.h"
#include "algorithms/silhouette/strokes/drawing_findings.h"
#include "croquis/geometry/disjoint_sets.h"

namespace croquis::silhouette {
namespace {

// A bound of the branches of all searches for matchings of a part; drawings of 64 hidden ends need some ten.
constexpr int maximum_branches = 2000;
// A bound of the arcs of all matchings that are crossed, some ten thousandths of a second each: many hidden ends in a
// part that can't be labelled would otherwise take a minute.
constexpr std::size_t maximum_arcs = 10'000;
// Samples nearer to a crossing than this share of their segment give way to it: no slivers beside crossings. Next the
// same when that is too coarse for two lines that run close to one another.
constexpr std::array<double, 2> mergings{0.15, 1e-4};
// What lies in the open gets other shapes, so many times.
constexpr int maximum_reshapings = 4;
// What leaving out an end costs, far above all completions.
constexpr double cost_left_out = 1e4;
constexpr int branches_for_failure = 200;
constexpr std::size_t most_faults_named = 3;

/// Indices of lines, ascending. A unit is lines that are only labelled together.
using Lines = std::vector<Index>;

/// Indices of the candidates that are taken.
using Matching = std::vector<Index>;

/// Leaves out candidates that the drawing's pins exclude.
void leave_pinned(const FigureContext& context, PartLines& part) {
  std::vector<StrokeEnd> ends;
  for (const Index end : part.ends) ends.push_back(stroke_end(context, context.junctions.ends[end]));
  for (const auto& [pair, joined] : context.pins) {
    std::erase_if(part.candidates, [&](const CompletionCandidate& candidate) {
      const auto is_pinned = [&](Index end) { return std::ranges::count(pair, ends[end]) > 0; };
      const bool both = is_pinned(candidate.a) && is_pinned(candidate.b);
      return joined ? !both && (is_pinned(candidate.a) || is_pinned(candidate.b)) : both;
    });
  }
}

PartLines part_of(const FigureContext& context, const std::vector<Lines>& units, const CompletionOptions& options) {
  PartLines part;
  for (const Lines& unit : units) part.lines.insert(part.lines.end(), unit.begin(), unit.end());
  std::ranges::sort(part.lines);
  for (Index e = 0; e < context.junctions.ends.size(); ++e) {
    if (std::ranges::binary_search(part.lines, context.junctions.ends[e].line)) part.ends.push_back(e);
  }
  part.candidates = completion_candidates(context.lines, context.junctions, part.ends, options);
  leave_pinned(context, part);
  return part;
}

/// What the drawing says lies behind what comes before what is cheapest: where nothing seen shows it.
void order_as_set(const FigureContext& context, Arrangement& arrangement) {
  for (ContourCrossing& crossing : arrangement.contour_crossings) {
    const auto& [a, b] = crossing.strands;
    const auto is_behind = [&](const ContourCrossing::Strand& one, const ContourCrossing::Strand& other) {
      return is_set_behind(context.drawing, arrangement.contours[one.contour].strokes,
                           arrangement.contours[other.contour].strokes);
    };
    if (crossing.over != no_index || a.contour == b.contour) continue;
    if (is_behind(a, b)) crossing.over = 1;
    if (is_behind(b, a)) crossing.over = 0;
  }
}

/// @param may_leave_out ends; then the first edges stand for those
MatchingSearch matchings_of(const PartLines& part, bool may_leave_out) {
  std::vector<MatchingEdge> edges;
  for (Index end = 0; may_leave_out && end < part.ends.size(); ++end) edges.push_back({end, end, cost_left_out});
  for (const CompletionCandidate& candidate : part.candidates) {
    const double cost = candidate.cost();
    edges.push_back({candidate.a, candidate.b, may_leave_out ? std::min(cost, cost_left_out) : cost});
  }
  return {static_cast<Index>(part.ends.size()), edges, may_leave_out ? branches_for_failure : maximum_branches};
}

std::vector<ChosenCompletion> in_likeliest_shapes(const Matching& matching) {
  std::vector<ChosenCompletion> chosen;
  for (const Index candidate : matching) chosen.push_back({candidate, 0});
  return chosen;
}

/// Crosses the contours of a matching and finds the faces: none when the surface would lie on both sides of a contour,
/// or contours touch.
/// @param refuse what contradicts at crossings alone, before the faces are found: that takes most of the time
Arrangement arrange(const FigureContext& context, const PartLines& part, const std::vector<ChosenCompletion>& chosen,
                    bool refuse) {
  Arrangement closed = close_contours(context, part, chosen);
  if (closed.paths.empty()) return closed;
  Arrangement result;
  for (const double merging : mergings) {
    result = cross_contours(closed, context.order, context.scale.step, merging);
    order_as_set(context, result);
    if (refuse && label_arrangement(result, LabellingRules::Full).side.empty()) break;
    find_faces(result);
    if (result.conflicts.empty()) break;
  }
  return result;
}

/// Gives their next shapes to completions that would lie in the open; false when there are none.
bool reshape(const Arrangement& arrangement, const PartLines& part, std::vector<ChosenCompletion>& chosen) {
  std::set<Index> bare;
  const Labelling relaxed = label_arrangement(arrangement, LabellingRules::Slack);
  for (const Index wrong : relaxed.wrong_arcs) {
    const FigureArc& arc = arrangement.arcs[wrong];
    Index completion = no_index;
    for (Index k = 0; !arc.visible && completion == no_index && k < arc.count; ++k) {
      completion = arrangement.origins[arrangement.segment_of(arc, k)].completion;
    }
    if (completion != no_index) bare.insert(completion);
  }
  bool any = false;
  for (const Index k : bare) {
    const CompletionCandidate& candidate = part.candidates[chosen[k].candidate];
    if (candidate.given != no_index || chosen[k].shape + 1 >= candidate.shapes.size()) continue;
    ++chosen[k].shape;
    any = true;
  }
  return any;
}

/// The matching with its likeliest shapes, then with others for what would lie in the open.
/// @param tried before it; the first one is nearly always right
/// @param arcs  crossed so far
std::optional<LabelledFigure> try_matching(const FigureContext& context, const PartLines& part,
                                           const Matching& matching, int tried, std::size_t& arcs) {
  std::vector<ChosenCompletion> chosen = in_likeliest_shapes(matching);
  for (int round = 0;; ++round) {
    Arrangement arrangement = arrange(context, part, chosen, tried > 0 && round == 0);
    arcs += arrangement.arcs.size();
    if (arrangement.winding.empty()) return std::nullopt;
    arrangement.nested = read_nesting(context.drawing, arrangement);
    const Labelling labelling = label_arrangement(arrangement, LabellingRules::Full);
    if (!labelling.side.empty()) return build_figure(context, std::move(arrangement), labelling);
    if (round == maximum_reshapings || !reshape(arrangement, part, chosen)) return std::nullopt;
  }
}

/// Strokes and how they are called.
struct NamedStrokes {
  std::vector<Subject> subjects;
  std::string names;

  void add(const Drawing& drawing, Index stroke, const Vec2& at) {
    subjects.push_back(stroke_subject(drawing, stroke, at));
    names += (names.empty() ? "" : ", ") + in_quotes(drawing, stroke);
  }
};

std::vector<Subject> all_strokes(const FigureContext& context, const PartLines& part) {
  std::set<Index> strokes;
  for (const Index line : part.lines) {
    strokes.insert(context.lines[line].strokes.begin(), context.lines[line].strokes.end());
  }
  std::vector<Subject> subjects;
  for (const Index stroke : strokes) subjects.push_back(stroke_subject(context.drawing, stroke));
  return subjects;
}

/// E_TOUCH, at a place where there are no faces.
Finding contours_touch(const FigureContext& context, const PartLines& part, const Vec2& at) {
  std::set<Index> strokes;
  for (const Index line : part.lines) {
    const CleanLine& clean = context.lines[line];
    for (std::size_t i = 0; i < clean.points.size(); ++i) {
      if ((clean.points[i] - at).norm() <= context.scale.step) strokes.insert(clean.stroke[i]);
    }
  }
  NamedStrokes touching;
  for (const Index stroke : strokes) touching.add(context.drawing, stroke, at);
  if (strokes.empty()) touching = {all_strokes(context, part), "hidden lines"};
  return make_error(Category::Geometry, "E_TOUCH",
                    "Contours meet in one point or overlap (" + touching.names + "): move one of them a little",
                    std::move(touching.subjects));
}

/// E_NO_LABELLING for lines whose hidden ends can't all be paired, naming those that are left.
Finding ends_without_partner(const FigureContext& context, const PartLines& part) {
  NamedStrokes left_out;
  for (const Index edge : matchings_of(part, true).next().value_or(Matching{})) {
    if (edge >= part.ends.size()) continue;
    const HiddenEnd& end = context.junctions.ends[part.ends[edge]];
    left_out.add(context.drawing, context.lines[end.line].end_stroke(end.at_start), end.at);
  }
  if (left_out.subjects.empty()) {
    return no_solid("the hidden ends can't all be connected in pairs", all_strokes(context, part));
  }
  return no_solid("nothing comes out again that the hidden end of " + left_out.names + " could be connected to",
                  std::move(left_out.subjects));
}

/// E_NO_LABELLING naming the lines of which a labelling with blame had to break a rule; E_TOUCH where contours meet in
/// a way that nothing resolves.
Finding no_labelling(const FigureContext& context, const PartLines& part, const Arrangement& arrangement) {
  if (!arrangement.conflicts.empty()) return contours_touch(context, part, arrangement.conflicts.front());
  Labelling blamed;
  if (!arrangement.winding.empty()) blamed = label_arrangement(arrangement, LabellingRules::Blame);
  std::vector<std::string> faults;
  std::vector<Subject> subjects;
  const auto blame = [&](Index segment) {
    const Index stroke = arrangement.origins[segment].stroke;
    const Vec2& at = arrangement.points[arrangement.segments[segment].front()];
    subjects.push_back(stroke_subject(context.drawing, stroke, at));
    return in_quotes(context.drawing, stroke);
  };
  const auto blame_middle = [&](const FigureArc& arc) { return blame(arrangement.segment_of(arc, arc.count / 2)); };
  for (const Index wrong : blamed.wrong_arcs) {
    const FigureArc& arc = arrangement.arcs[wrong];
    const std::string stroke = blame_middle(arc);
    faults.push_back(arc.visible ? "the drawn part of " + stroke + " would be covered"
                                 : "the hidden part of " + stroke + " would lie in the open");
  }
  for (const Index wrong : blamed.wrong_crossings) {
    const auto& [a, b] = arrangement.contour_crossings[wrong].strands;
    const std::string first = blame(arrangement.first_segment[a.contour] + a.position);
    const std::string second = blame(arrangement.first_segment[b.contour] + b.position);
    faults.push_back(first);
    faults.back().append(" and ").append(second).append(" contradict one another");
  }
  for (const Index wrong : blamed.wrong_faces) {
    for (Index e = 0; e < arrangement.arcs.size(); ++e) {
      const FigureArc& arc = arrangement.arcs[e];
      if (arrangement.beside_arc[e][blamed.side[arc.contour] > 0 ? 1 : 0] != wrong) continue;
      faults.push_back(blame_middle(arc) + " would be the edge of nothing");
    }
  }
  if (faults.empty()) {
    return no_solid("the lines that stop at others contradict one another", all_strokes(context, part));
  }
  std::string why = faults.front();
  for (std::size_t i = 1; i < faults.size() && i < most_faults_named; ++i) why += ", and " + faults[i];
  return no_solid(why, std::move(subjects));
}

/// Completes and labels the contours of some units together: one figure, or a finding.
LabelledDrawing search_figure(const FigureContext& context, const std::vector<Lines>& units, const Progress& progress) {
  CompletionOptions options = context.options.completion;
  PartLines part = part_of(context, units, options);
  MatchingSearch matchings = matchings_of(part, false);
  std::optional<Matching> matching = matchings.next();
  if (!matching) {
    // Among thin tubes a wide body's completion may seem too costly, though it is the only one there is.
    options.maximum_cost = std::numeric_limits<double>::max();
    part = part_of(context, units, options);
    matchings = matchings_of(part, false);
    matching = matchings.next();
  }
  LabelledDrawing result;
  if (!matching) {
    result.findings.push_back(ends_without_partner(context, part));
    return result;
  }
  const Matching cheapest = *matching;
  std::size_t arcs = 0;
  for (int tried = 0; matching && tried < options.maximum_matchings && arcs < maximum_arcs; ++tried) {
    progress.check();
    std::optional<LabelledFigure> figure = try_matching(context, part, *matching, tried, arcs);
    if (figure) {
      result.figures.push_back(*std::move(figure));
      return result;
    }
    matching = matchings.next();
  }
  const Arrangement failed = arrange(context, part, in_likeliest_shapes(cheapest), false);
  result.findings.push_back(no_labelling(context, part, failed));
  return result;
}

/// Units that are solved together and what came of it.
struct Group {
  std::vector<Lines> units;                ///< by their first lines
  Eigen::AlignedBox2d box;                 ///< of the lines, then of the completed contours
  std::optional<LabelledDrawing> outcome;  ///< with the findings of what was left out
};

/// Per line its unit: lines that stop at one another, that something known joins, or of one object.
std::vector<Index> units_of_lines(const FigureContext& context) {
  DisjointSets joined(context.lines.size());
  for (const HiddenEnd& end : context.junctions.ends) joined.unite(end.line, end.bar);
  for (const GivenPiece& given : context.junctions.given) {
    joined.unite(context.junctions.ends[given.from].line, context.junctions.ends[given.to].line);
  }
  for (const auto& [pair, together] : context.pins) {
    Index first = no_index;
    for (const HiddenEnd& end : context.junctions.ends) {
      if (!together || std::ranges::count(pair, stroke_end(context, end)) == 0) continue;
      if (first != no_index) joined.unite(first, end.line);
      first = end.line;
    }
  }
  std::map<std::string, Index> first_of_object;
  std::map<Index, Index> first_of_tube;
  for (Index line = 0; line < context.lines.size(); ++line) {
    const Index tube = context.lines[line].centre_line;
    if (tube != no_index) joined.unite(line, first_of_tube.try_emplace(tube, line).first->second);
    const std::string& object = context.lines[line].object;
    if (!object.empty()) joined.unite(line, first_of_object.try_emplace(object, line).first->second);
  }
  std::vector<Index> unit_of;
  joined.number(unit_of);
  return unit_of;
}

/// A fault between two units excludes both, unless one of them is out already for a reason of its own.
std::set<Index> bad_units(const std::vector<Index>& unit_of, const LineFindings& faults) {
  std::vector<std::set<Index>> faulty;
  for (const LineFinding& fault : faults) {
    std::set<Index>& units = faulty.emplace_back();
    for (const Index line : fault.lines) units.insert(unit_of[line]);
  }
  std::set<Index> bad;
  for (const std::set<Index>& units : faulty) {
    if (units.size() == 1) bad.insert(*units.begin());
  }
  const std::set<Index> bad_by_itself = bad;
  for (const std::set<Index>& units : faulty) {
    const auto is_out = [&](Index unit) { return bad_by_itself.contains(unit); };
    if (std::ranges::none_of(units, is_out)) bad.insert(units.begin(), units.end());
  }
  return bad;
}

/// Joins groups whose boxes overlap, keeping the order of their first units.
void merge_overlapping(std::vector<Group>& groups) {
  for (auto group = groups.begin(); group != groups.end();) {
    const auto overlaps = [&](const Group& other) { return other.box.intersects(group->box); };
    const auto into = std::find_if(groups.begin(), group, overlaps);
    if (into == group) {
      ++group;
      continue;
    }
    into->units.insert(into->units.end(), group->units.begin(), group->units.end());
    std::ranges::sort(into->units);
    into->box.extend(group->box);
    into->outcome.reset();
    groups.erase(group);
    group = groups.begin();  // others may overlap the larger box
  }
}

/// All units together; if that fails, those that can be labelled alone, one after the other as far as they go together.
/// What is left out has its reason.
LabelledDrawing search_without_bad(const FigureContext& context, const std::vector<Lines>& units,
                                   const Progress& progress) {
  LabelledDrawing all = search_figure(context, units, progress);
  if (!all.figures.empty() || units.size() == 1) return all;
  LabelledDrawing result;
  std::vector<Lines> accepted;
  for (const Lines& unit : units) {
    LabelledDrawing found = search_figure(context, {unit}, progress);
    accepted.push_back(unit);
    if (!found.figures.empty() && accepted.size() > 1) found = search_figure(context, accepted, progress);
    std::ranges::move(found.findings, std::back_inserter(result.findings));
    if (found.figures.empty()) {
      accepted.pop_back();
    } else {
      result.figures = std::move(found.figures);
    }
  }
  return result;
}

}  // namespace

MatchingSearch::MatchingSearch(Index nodes, const std::vector<MatchingEdge>& edges, int maximum_branches)
    : branches_left_(maximum_branches) {
  std::vector<std::vector<IntegerProgram::Term>> one(nodes);
  for (const MatchingEdge& edge : edges) {
    const Index taken = program_.add_variable(0, 1, edge.cost);
    one[edge.a].push_back({taken, 1});
    if (edge.b != edge.a) one[edge.b].push_back({taken, 1});
  }
  for (std::vector<IntegerProgram::Term>& row : one) program_.add_row(std::move(row), 1, 1);
}

std::optional<std::vector<Index>> MatchingSearch::next() {
  if (done_ || limit_reached()) return std::nullopt;
  const IntegerProgram::Solution solution = program_.solve(branches_left_);
  branches_left_ = solution.status == IntegerProgram::Status::Limit ? 0 : branches_left_ - solution.nodes;
  done_ = solution.status != IntegerProgram::Status::Optimal;
  if (done_) return std::nullopt;
  std::vector<Index> taken;
  std::vector<IntegerProgram::Term> same;
  for (Index e = 0; e < solution.values.size(); ++e) {
    if (solution.values[e] == 0) continue;
    taken.push_back(e);
    same.push_back({e, 1});
  }
  done_ = taken.empty();
  if (!done_) program_.add_row(std::move(same), 0, static_cast<double>(taken.size()) - 1);
  return taken;
}

LabelledDrawing label_parts(const FigureContext& context, const Progress& progress) {
  const std::vector<Index> unit_of = units_of_lines(context);
  const std::set<Index> bad = bad_units(unit_of, context.junctions.findings);
  std::vector<Group> groups(unit_of.size());
  for (Index line = 0; line < unit_of.size(); ++line) {
    if (bad.contains(unit_of[line])) continue;
    Group& group = groups[unit_of[line]];
    group.units.resize(1);
    group.units.front().push_back(line);
    for (const Vec2& point : context.lines[line].points) group.box.extend(point);
  }
  std::erase_if(groups, [](const Group& group) { return group.units.empty(); });
  // Completions may reach beyond the strokes and into other groups: then those are solved together. Each round has
  // fewer groups than the one before.
  merge_overlapping(groups);
  for (std::size_t before = 0; before != groups.size(); merge_overlapping(groups)) {
    before = groups.size();
    for (Group& group : groups) {
      if (group.outcome) continue;
      group.outcome = search_without_bad(context, group.units, progress);
      for (const LabelledFigure& figure : group.outcome->figures) {
        for (const Vec2& point : figure.points) group.box.extend(point);
      }
    }
  }
  LabelledDrawing result;
  for (Group& group : groups) {
    std::ranges::move(group.outcome->figures, std::back_inserter(result.figures));
    std::ranges::move(group.outcome->findings, std::back_inserter(result.findings));
  }
  return result;
}

}  // namespace croquis::silhouette

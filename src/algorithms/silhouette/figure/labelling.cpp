// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/figure/labelling.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <set>
#include <utility>

#include "algorithms/silhouette/strokes/drawing_findings.h"
#include "algorithms/silhouette/strokes/visible_crossings.h"
#include "croquis/geometry/polyline.h"
#include "croquis/solver/integer_program.h"

namespace croquis::silhouette {
namespace {

/// Per contour those that cross it.
std::vector<std::set<Index>> crossed_contours(const Arrangement& arrangement) {
  std::vector<std::set<Index>> crossed(arrangement.contours.size());
  for (const ContourCrossing& crossing : arrangement.contour_crossings) {
    const auto [a, b] = std::pair(crossing.strands[0].contour, crossing.strands[1].contour);
    if (a == b) continue;
    crossed[a].insert(b);
    crossed[b].insert(a);
  }
  return crossed;
}

/// Per contour the smallest one that it lies in, no_index for none. Contours that don't cross lie in one another with
/// all of their arcs or none.
std::vector<Index> surrounding_contours(const Arrangement& arrangement, const std::vector<double>& area,
                                        const std::vector<std::set<Index>>& crossed) {
  std::vector<Index> around(area.size(), no_index);
  for (Index c = 0; c < area.size(); ++c) {
    const Index face = arrangement.beside_arc[arrangement.segment_arc[arrangement.first_segment[c]]].front();
    for (Index o = 0; o < area.size(); ++o) {
      if (o == c || std::abs(area[o]) <= std::abs(area[c]) || crossed[c].contains(o)) continue;
      const bool smallest = around[c] == no_index || std::abs(area[o]) < std::abs(area[around[c]]);
      if (arrangement.winding[face][o] != 0 && smallest) around[c] = o;
    }
  }
  return around;
}

/// Whether a contour within another is marked as the edge of a hole; none where nothing says so or not.
std::optional<bool> chosen_nesting(const Drawing& drawing, const ContourPath& path, const ContourPath& around) {
  if (const std::optional<bool> by_kind = hole_by_kind(drawing, path.strokes)) return by_kind;
  const std::string own = object_of_strokes(drawing, path.strokes);
  if (own.empty()) return std::nullopt;
  return own == object_of_strokes(drawing, around.strokes);
}

// Deepest label that is looked for; also the "big M" that switches the rules of a crossing.
constexpr double deepest = 12;
// One wrong arc costs more than any number of hidden surfaces, and a wrong crossing or face more than one of its arcs.
constexpr double slack_cost = 1000;
constexpr double rule_cost = 2500;
// Area decides only between labellings of equal depth.
constexpr double area_cost = 0.01;
// Drawings need a handful of nodes; this bounds the rest.
constexpr int labelling_nodes = 1000;
// Any rule that can be broken explains something.
constexpr int blaming_nodes = 40;
constexpr double unbounded = IntegerProgram::unbounded;

using Terms = std::vector<IntegerProgram::Term>;

/// A variable that is above 0 where a rule is broken.
struct Slack {
  Index variable = 0;
  Index what = 0;                                  ///< the rule is of
  std::vector<Index> Labelling::*wrong = nullptr;  ///< the list of such things
};

/// The integer program and what its variables stand for.
struct LabellingProgram {
  const Arrangement& arrangement;
  LabellingRules rules;
  IntegerProgram program;
  std::vector<Index> depth;    ///< per arc
  std::vector<Index> side;     ///< per contour: o
  std::vector<Index> over;     ///< per crossing: 1 where the first strand is in front
  std::vector<Index> missing;  ///< per face, with blame: surfaces
  std::vector<Slack> slacks;

  Index add_slack(double most, double cost, Index what, std::vector<Index> Labelling::*wrong) {
    slacks.push_back({program.add_variable(0, most, cost), what, wrong});
    return slacks.back().variable;
  }
};

/// (f) for arcs.
void add_depths(LabellingProgram& labels) {
  for (Index e = 0; e < labels.arrangement.arcs.size(); ++e) {
    const bool visible = labels.arrangement.arcs[e].visible;
    const bool is_known = labels.arrangement.may_be_covered[e] == 0;
    const bool strict = is_known && labels.rules == LabellingRules::Full;
    const Index n = labels.program.add_variable(strict && !visible ? 1 : 0, strict && visible ? 0 : deepest, 1);
    labels.depth.push_back(n);
    if (strict || !is_known) continue;
    const Index slack = labels.add_slack(visible ? deepest : 1, slack_cost, e, &Labelling::wrong_arcs);
    labels.program.add_row({{n, 1}, {slack, visible ? -1.0 : 1.0}}, visible ? -unbounded : 1, visible ? 0 : unbounded);
  }
}

void add_sides(LabellingProgram& labels) {
  const std::vector<double>& area = labels.arrangement.area;
  const double whole = std::max(std::accumulate(area.begin(), area.end(), 0.0), 1e-300);
  for (Index c = 0; c < labels.arrangement.contours.size(); ++c) {
    const int side = labels.arrangement.contours[c].side;
    double covered = 0;
    for (std::size_t f = 0; f < area.size(); ++f) covered += area[f] * labels.arrangement.winding[f][c] / whole;
    labels.side.push_back(labels.program.add_variable(side > 0 ? 1 : 0, side < 0 ? 0 : 1, 2 * area_cost * covered));
  }
}

/// How the depth of a strand changes at a crossing.
/// @param terms that the depth after it has more than the one before
void add_step(const ContourCrossing::Strand& strand, Index crossing, Terms terms, double change,
              LabellingProgram& labels) {
  terms.push_back({labels.depth[strand.after], 1});
  terms.push_back({labels.depth[strand.before], -1});
  for (int sign = 1; labels.rules == LabellingRules::Blame && sign >= -1; sign -= 2) {
    const Index slack = labels.add_slack(deepest, rule_cost, crossing, &Labelling::wrong_crossings);
    terms.push_back({slack, static_cast<double>(sign)});
  }
  labels.program.add_row(std::move(terms), change, change);
}

/// (c) and (d), for each strand as the upper one: it is that where base + slope x = 1, and y is the product of this and
/// its o.
void add_crossing_rules(Index k, LabellingProgram& labels) {
  const ContourCrossing& crossing = labels.arrangement.contour_crossings[k];
  IntegerProgram& program = labels.program;
  const Index x = labels.over[k];
  for (Index s = 0; s < 2; ++s) {
    const ContourCrossing::Strand& upper = crossing.strands[s];
    const ContourCrossing::Strand& lower = crossing.strands[1 - s];
    const double base = s == 0 ? 0 : 1;
    const double slope = s == 0 ? 1 : -1;
    const double turn = slope * crossing.sign;
    const Index o = labels.side[upper.contour];
    if (crossing.over == 1 - s) {  // it is the lower one, which the other doesn't notice
      add_step(lower, k, {}, 0, labels);
      continue;
    }
    Index y = o;
    if (crossing.over == no_index) {
      y = program.add_variable(0, 1, 0);
      program.add_row({{y, 1}, {x, -slope}}, -unbounded, base);
      program.add_row({{y, 1}, {o, -1}}, -unbounded, 0);
      program.add_row({{y, 1}, {x, -slope}, {o, -1}}, base - 1, unbounded);
    }
    add_step(lower, k, {{y, -2 * turn}, {x, turn * slope}}, -turn * base, labels);
    for (const Index above : {upper.before, upper.after}) {
      for (const Index below : {lower.before, lower.after}) {
        if (above == below) continue;
        program.add_row({{labels.depth[above], 1}, {labels.depth[below], -1}, {x, deepest * slope}}, -unbounded,
                        deepest * (1 - base));
      }
    }
  }
}

/// Adds factor * w of a face to a row's terms.
/// @return the constant that is missing there
double add_layers(const LabellingProgram& labels, Index face, double factor, Terms& terms) {
  if (labels.rules == LabellingRules::Blame) terms.push_back({labels.missing[face], factor});
  double turns = 0;
  for (Index c = 0; c < labels.side.size(); ++c) {
    const int winding = labels.arrangement.winding[face][c];
    if (winding != 0) terms.push_back({labels.side[c], 2 * factor * winding});
    turns += winding;
  }
  return factor * turns;
}

/// (a) and (b).
void add_layer_rules(LabellingProgram& labels) {
  for (Index f = 0; f < labels.arrangement.winding.size(); ++f) {
    if (labels.rules == LabellingRules::Blame) {
      labels.missing.push_back(labels.add_slack(deepest, rule_cost, f, &Labelling::wrong_faces));
    }
    Terms terms;
    const double turns = add_layers(labels, f, 1, terms);
    if (!terms.empty()) labels.program.add_row(std::move(terms), turns, unbounded);
  }
  for (Index arc = 0; arc < labels.arrangement.arcs.size(); ++arc) {
    Terms terms{{labels.depth[arc], 2}};
    double turns = 0;
    for (const Index face : labels.arrangement.beside_arc[arc]) turns += add_layers(labels, face, -1, terms);
    labels.program.add_row(std::move(terms), -unbounded, turns - 1);
  }
}

}  // namespace

std::vector<NestedOutline> read_nesting(const Drawing& drawing, Arrangement& arrangement) {
  const std::vector<ContourPath>& paths = arrangement.paths;
  std::vector<double> area;
  area.reserve(paths.size());
  for (const ContourPath& path : paths) area.push_back(signed_area(path.points));
  const std::vector<std::set<Index>> crossed = crossed_contours(arrangement);
  const std::vector<Index> around = surrounding_contours(arrangement, area, crossed);
  const auto is_open = [&](Index c) { return around[c] != no_index && paths[c].side == 0; };
  // From the outside in: what lies in a hole is no part of the surface around the hole.
  std::vector<std::pair<int, Index>> order;
  for (Index c = 0; c < paths.size(); ++c) {
    int depth = 0;
    for (Index o = around[c]; o != no_index; o = around[o]) ++depth;
    if (is_open(c)) order.emplace_back(depth, c);
  }
  std::ranges::sort(order);
  std::vector<NestedOutline> nested;
  for (const auto& [depth, c] : order) {
    const Index outer = around[c];
    const auto filled_side = [&](Index contour) { return area[contour] >= 0 ? 1 : -1; };
    if (arrangement.contours[outer].side == -filled_side(outer)) continue;  // bounds a hole
    // What covers the outline around or is covered by it, and what else lies within it.
    std::size_t things = crossed[outer].size() + (is_open(outer) ? 2 : 0);
    for (Index other = 0; other < paths.size(); ++other) {
      if (other != c && around[other] == outer && is_open(other)) ++things;
    }
    const std::optional<bool> chosen = chosen_nesting(drawing, paths[c], paths[outer]);
    const bool hole = chosen ? *chosen : is_hole_of_ring(paths[c].points, paths[outer].points, things);
    arrangement.contours[c].side = (hole ? -1 : 1) * filled_side(c);
    nested.push_back(
        {paths[c].strokes.front(), paths[outer].strokes.front(), hole, chosen.has_value(), paths[c].points.front()});
  }
  return nested;
}

Labelling label_arrangement(const Arrangement& arrangement, LabellingRules rules) {
  LabellingProgram labels{arrangement, rules, {}, {}, {}, {}, {}, {}};
  add_sides(labels);
  for (const ContourCrossing& crossing : arrangement.contour_crossings) {
    labels.over.push_back(labels.program.add_variable(crossing.over == 0 ? 1 : 0, crossing.over == 1 ? 0 : 1, 0));
  }
  const Index first = labels.program.variable_count();  // all else follows from sides and what lies over what
  add_depths(labels);
  for (Index k = 0; k < arrangement.contour_crossings.size(); ++k) add_crossing_rules(k, labels);
  if (!arrangement.winding.empty()) add_layer_rules(labels);
  const std::vector<int> values =
      labels.program.solve(rules == LabellingRules::Blame ? blaming_nodes : labelling_nodes, 0, first).values;
  Labelling result;
  if (values.empty()) return result;
  for (const Index n : labels.depth) result.depth.push_back(values[n]);
  for (const Index o : labels.side) result.side.push_back(2 * values[o] - 1);
  for (const Index x : labels.over) result.is_swapped.push_back(values[x] == 0 ? 1 : 0);
  for (const auto& [slack, what, wrong] : labels.slacks) {
    if (values[slack] > 0) (result.*wrong).push_back(what);
  }
  return result;
}

std::string object_of_strokes(const Drawing& drawing, const std::vector<Index>& strokes) {
  for (const Index stroke : strokes) {
    if (!drawing.strokes[stroke].object.empty()) return drawing.strokes[stroke].object;
  }
  return {};
}

Findings nested_findings(const Drawing& drawing, const LabelledFigure& figure) {
  Findings findings;
  for (const auto& [stroke, around, hole, chosen, at] : figure.nested) {
    if (chosen) continue;
    const std::string names = in_quotes(drawing, stroke) + " lies within " + in_quotes(drawing, around);
    Finding note = make_warning(Category::Geometry, "W_NESTED",
                                names + (hole ? " and was read as a hole: mark it as a part if it lies in front"
                                              : " and was read as a part in front: mark it as a hole if it is one"),
                                {stroke_subject(drawing, stroke, at)});
    note.severity = Severity::Info;
    findings.push_back(std::move(note));
  }
  return findings;
}

}  // namespace croquis::silhouette

// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/figure/labelling.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "croquis/solver/integer_program.h"

namespace croquis::silhouette {
namespace {

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

/// Variables that are above 0 where a rule is broken, and what of.
using Slacks = std::vector<std::pair<Index, Index>>;

/// The integer program and what its variables stand for.
struct LabellingProgram {
  const Arrangement& arrangement;
  const Faces& faces;
  LabellingRules rules;
  IntegerProgram program;
  std::vector<Index> depth;  ///< per arc
  std::vector<Index> side;   ///< per contour: o
  std::vector<Index> over;   ///< per crossing: 1 where the first strand is in front
  Slacks arc_slacks, crossing_slacks, face_slacks;

  /// A variable by which a rule may be broken.
  Index add_slack(double most, double cost, Index what, Slacks& slacks) {
    slacks.emplace_back(program.add_variable(0, most, cost), what);
    return slacks.back().first;
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
    const Index slack = labels.add_slack(visible ? deepest : 1, slack_cost, e, labels.arc_slacks);
    labels.program.add_row({{n, 1}, {slack, visible ? -1.0 : 1.0}}, visible ? -unbounded : 1, visible ? 0 : unbounded);
  }
}

void add_sides(LabellingProgram& labels) {
  const Faces& faces = labels.faces;
  const double whole = std::max(std::accumulate(faces.area.begin(), faces.area.end(), 0.0), 1e-300);
  for (Index c = 0; c < labels.arrangement.contours.size(); ++c) {
    const int side = labels.arrangement.contours[c].side;
    double covered = 0;
    for (std::size_t f = 0; f < faces.area.size(); ++f) covered += faces.area[f] * faces.winding[f][c] / whole;
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
    const Index slack = labels.add_slack(deepest, rule_cost, crossing, labels.crossing_slacks);
    terms.push_back({slack, static_cast<double>(sign)});
  }
  labels.program.add_row(std::move(terms), change, change);
}

/// (c) and (d), for each strand as the upper one: it is that where base + slope x = 1, and y is the product of this and
/// its o.
void add_crossing_rules(Index k, LabellingProgram& labels) {
  const ContourCrossing& crossing = labels.arrangement.crossings[k];
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
  if (labels.rules == LabellingRules::Blame) terms.push_back({labels.face_slacks[face].first, factor});
  double turns = 0;
  for (Index c = 0; c < labels.side.size(); ++c) {
    const int winding = labels.faces.winding[face][c];
    if (winding != 0) terms.push_back({labels.side[c], 2 * factor * winding});
    turns += winding;
  }
  return factor * turns;
}

/// (a) and (b).
void add_layer_rules(LabellingProgram& labels) {
  for (Index f = 0; f < labels.faces.winding.size(); ++f) {
    if (labels.rules == LabellingRules::Blame) labels.add_slack(deepest, rule_cost, f, labels.face_slacks);
    Terms terms;
    const double turns = add_layers(labels, f, 1, terms);
    if (!terms.empty()) labels.program.add_row(std::move(terms), turns, unbounded);
  }
  for (Index arc = 0; arc < labels.arrangement.arcs.size(); ++arc) {
    Terms terms{{labels.depth[arc], 2}};
    double turns = 0;
    for (const Index face : labels.faces.beside_arc[arc]) turns += add_layers(labels, face, -1, terms);
    labels.program.add_row(std::move(terms), -unbounded, turns - 1);
  }
}

}  // namespace

Labelling label_arrangement(const Arrangement& arrangement, const Faces& faces, LabellingRules rules) {
  LabellingProgram labels{arrangement, faces, rules, {}, {}, {}, {}, {}, {}, {}};
  add_sides(labels);
  for (const ContourCrossing& crossing : arrangement.crossings) {
    labels.over.push_back(labels.program.add_variable(crossing.over == 0 ? 1 : 0, crossing.over == 1 ? 0 : 1, 0));
  }
  const Index first = labels.program.variable_count();  // all else follows from sides and what lies over what
  add_depths(labels);
  for (Index k = 0; k < arrangement.crossings.size(); ++k) add_crossing_rules(k, labels);
  if (!faces.winding.empty()) add_layer_rules(labels);
  const std::vector<int> values =
      labels.program.solve(rules == LabellingRules::Blame ? blaming_nodes : labelling_nodes, 0, first).values;
  Labelling result;
  if (values.empty()) return result;
  const auto broken = [&](const Slacks& slacks) {
    std::vector<Index> what;
    for (const auto& [slack, of] : slacks) {
      if (values[slack] > 0) what.push_back(of);
    }
    return what;
  };
  for (const Index n : labels.depth) result.depth.push_back(values[n]);
  for (const Index o : labels.side) result.side.push_back(2 * values[o] - 1);
  for (const Index x : labels.over) result.is_swapped.push_back(values[x] == 0 ? 1 : 0);
  result.wrong_arcs = broken(labels.arc_slacks);
  result.wrong_crossings = broken(labels.crossing_slacks);
  result.wrong_faces = broken(labels.face_slacks);
  return result;
}

}  // namespace croquis::silhouette

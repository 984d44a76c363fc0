// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/figure/labelling.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

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
constexpr int maximum_labelling_nodes = 5000;
// Any rule that can be broken explains something.
constexpr int maximum_blaming_nodes = 40;

using Term = IntegerProgram::Term;

class Program {
 public:
  Program(const Arrangement& arrangement, const std::vector<int>& sides, const Faces& faces, LabellingRules rules)
      : arrangement_(arrangement), faces_(faces), rules_(rules), ends_(arc_ends(arrangement)) {
    add_arcs();
    add_contours(sides);
    for (const ContourCrossing& crossing : arrangement_.crossings) add_crossing(crossing);
    if (rules_ != LabellingRules::Local) add_layer_rules();
  }

  Labelling solve() const {
    const IntegerProgram::Solution solution =
        program_.solve(rules_ == LabellingRules::Blame ? maximum_blaming_nodes : maximum_labelling_nodes);
    Labelling result;
    result.status = solution.status;
    if (solution.values.empty()) return result;
    for (const Index n : depth_) result.depth.push_back(solution.values[n]);
    for (const Index o : orientation_) result.side.push_back(2 * solution.values[o] - 1);
    for (const Index x : over_) result.a_is_over.push_back(solution.values[x] != 0 ? 1 : 0);
    for (Index arc = 0; arc < slack_.size(); ++arc) {
      if (slack_[arc] != no_index && solution.values[slack_[arc]] > 0) result.wrong_arcs.push_back(arc);
    }
    for (const auto& [slack, crossing] : crossing_slack_) {
      if (solution.values[slack] > 0) result.wrong_crossings.push_back(crossing);
    }
    for (Index face = 0; face < face_slack_.size(); ++face) {
      if (solution.values[face_slack_[face]] > 0) result.wrong_faces.push_back(face);
    }
    return result;
  }

 private:
  /// (f) for arcs.
  void add_arcs() {
    for (Index e = 0; e < arrangement_.arcs.size(); ++e) {
      const FigureArc& arc = arrangement_.arcs[e];
      const bool is_known = arrangement_.may_be_covered[e] == 0;
      const bool strict = is_known && rules_ != LabellingRules::Slack && rules_ != LabellingRules::Blame;
      const double least = strict && !arc.visible ? 1 : 0;
      const double most = strict && arc.visible ? 0 : deepest;
      const Index n = program_.add_variable(least, most, 1);
      depth_.push_back(n);
      slack_.push_back(no_index);
      if (strict || !is_known) continue;
      const Index slack = program_.add_variable(0, arc.visible ? deepest : 1, slack_cost);
      slack_.back() = slack;
      if (arc.visible) {
        program_.add_row({{n, 1}, {slack, -1}}, -IntegerProgram::unbounded, 0);
      } else {
        program_.add_row({{n, 1}, {slack, 1}}, 1, IntegerProgram::unbounded);
      }
    }
  }

  void add_contours(const std::vector<int>& sides) {
    const double whole = std::max(std::accumulate(faces_.area.begin(), faces_.area.end(), 0.0), 1e-300);
    for (Index c = 0; c < arrangement_.contours.size(); ++c) {
      double covered = 0;
      for (std::size_t f = 0; f < faces_.area.size(); ++f) covered += faces_.area[f] * faces_.winding[f][c] / whole;
      orientation_.push_back(
          program_.add_variable(sides[c] > 0 ? 1 : 0, sides[c] < 0 ? 0 : 1, 2 * area_cost * covered));
    }
  }

  void add_crossing(const ContourCrossing& k) {
    const Around a{depth_[ends_.before(k.contour_a, k.position_a)], depth_[ends_.after(k.contour_a, k.position_a)]};
    const Around b{depth_[ends_.before(k.contour_b, k.position_b)], depth_[ends_.after(k.contour_b, k.position_b)]};
    const bool a_over = k.over == ContourCrossing::Over::A;
    const bool b_over = k.over == ContourCrossing::Over::B;
    const Index x = program_.add_variable(a_over ? 1 : 0, b_over ? 0 : 1, 0);
    over_.push_back(x);
    const double s = k.sign;
    if (a_over || b_over) {
      const Around& upper = a_over ? a : b;
      const Around& lower = a_over ? b : a;
      const Index o = orientation_[a_over ? k.contour_a : k.contour_b];
      const double turn = a_over ? s : -s;
      add_step({{lower.after, 1}, {lower.before, -1}, {o, -2 * turn}}, -turn);
      add_step({{upper.after, 1}, {upper.before, -1}}, 0);
      add_order(upper, lower, x, a_over ? Known::XIsOne : Known::XIsZero);
      return;
    }
    add_free_crossing(a, b, x, s, orientation_[k.contour_a], orientation_[k.contour_b]);
  }

  /// How a depth changes at the latest crossing.
  void add_step(std::vector<Term> terms, double change) {
    for (int sign = 1; rules_ == LabellingRules::Blame && sign >= -1; sign -= 2) {
      const Index slack = program_.add_variable(0, deepest, rule_cost);
      terms.push_back({slack, static_cast<double>(sign)});
      crossing_slack_.emplace_back(slack, static_cast<Index>(over_.size()) - 1);
    }
    program_.add_row(std::move(terms), change, change);
  }

  struct Around {
    Index before;
    Index after;
  };

  enum class Known { No, XIsOne, XIsZero };

  /// (c) and (d) with y = x o_A and v = (1 - x) o_B.
  void add_free_crossing(const Around& a, const Around& b, Index x, double s, Index o_a, Index o_b) {
    constexpr double any = IntegerProgram::unbounded;
    const Index y = program_.add_variable(0, 1, 0);
    const Index v = program_.add_variable(0, 1, 0);
    program_.add_row({{y, 1}, {x, -1}}, -any, 0);
    program_.add_row({{y, 1}, {o_a, -1}}, -any, 0);
    program_.add_row({{y, 1}, {x, -1}, {o_a, -1}}, -1, any);
    program_.add_row({{v, 1}, {x, 1}}, -any, 1);
    program_.add_row({{v, 1}, {o_b, -1}}, -any, 0);
    program_.add_row({{v, 1}, {x, 1}, {o_b, -1}}, 0, any);
    add_step({{b.after, 1}, {b.before, -1}, {y, -2 * s}, {x, s}}, 0);
    add_step({{a.after, 1}, {a.before, -1}, {v, 2 * s}, {x, s}}, s);
    add_order(a, b, x, Known::No);
    add_order(b, a, x, Known::No, true);
  }

  /// The upper contour's arcs lie no deeper than the lower one's; where that is not known, only for one value of x.
  void add_order(const Around& upper, const Around& lower, Index x, Known known, bool when_zero = false) {
    for (const Index n : {upper.before, upper.after}) {
      for (const Index m : {lower.before, lower.after}) {
        if (n == m) continue;
        if (known != Known::No) {
          program_.add_row({{n, 1}, {m, -1}}, -IntegerProgram::unbounded, 0);
        } else {
          program_.add_row({{n, 1}, {m, -1}, {x, when_zero ? -deepest : deepest}}, -IntegerProgram::unbounded,
                           when_zero ? 0 : deepest);
        }
      }
    }
  }

  /// (a) and (b).
  void add_layer_rules() {
    constexpr double any = IntegerProgram::unbounded;
    const auto add_layers = [&](Index face, double factor, std::vector<Term>& terms) {
      if (rules_ == LabellingRules::Blame) terms.push_back({face_slack_[face], factor / 2});
      return add_windings(faces_.winding[face], factor, terms);
    };
    for (Index f = 0; f < faces_.winding.size(); ++f) {
      if (rules_ == LabellingRules::Blame) face_slack_.push_back(program_.add_variable(0, deepest, rule_cost));
      std::vector<Term> terms;
      const double turns = add_layers(f, 2, terms);
      if (!terms.empty()) program_.add_row(std::move(terms), turns, any);
    }
    for (Index arc = 0; arc < arrangement_.arcs.size(); ++arc) {
      std::vector<Term> terms{{depth_[arc], 2}};
      const double turns = add_layers(faces_.left[arc], -2, terms) + add_layers(faces_.right[arc], -2, terms);
      program_.add_row(std::move(terms), -any, -turns - 1);
    }
  }

  /// Adds factor Σ winding_c o_c to a row; returns Σ winding_c.
  double add_windings(const std::vector<int>& winding, double factor, std::vector<Term>& terms) const {
    double sum = 0;
    for (Index c = 0; c < winding.size(); ++c) {
      if (winding[c] == 0) continue;
      terms.push_back({orientation_[c], factor * winding[c]});
      sum += winding[c];
    }
    return sum;
  }

  const Arrangement& arrangement_;
  const Faces& faces_;
  LabellingRules rules_;
  ArcEnds ends_;
  IntegerProgram program_;
  std::vector<Index> depth_;                             ///< variables, per arc
  std::vector<Index> orientation_;                       ///< per contour
  std::vector<Index> over_;                              ///< per crossing
  std::vector<Index> slack_;                             ///< per arc, no_index where it can't break a rule
  std::vector<Index> face_slack_;                        ///< per face, with slack
  std::vector<std::pair<Index, Index>> crossing_slack_;  ///< variables and their crossings
};

}  // namespace

Labelling label_arrangement(const Arrangement& arrangement, const std::vector<int>& sides, const Faces& faces,
                            LabellingRules rules) {
  return Program(arrangement, sides, faces, rules).solve();
}

std::vector<int> face_layers(const Faces& faces, const std::vector<int>& side) {
  std::vector<int> layers;
  for (const std::vector<int>& winding : faces.winding) {
    int sum = 0;
    for (std::size_t c = 0; c < winding.size(); ++c) sum += side[c] * winding[c];
    layers.push_back(sum);
  }
  return layers;
}

}  // namespace croquis::silhouette

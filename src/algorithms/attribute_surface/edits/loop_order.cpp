// SPDX-License-Identifier: GPL-3.0-or-later
// Curves put into the order of a loop.
#include <algorithm>
#include <limits>
#include <set>
#include <utility>

#include "algorithms/attribute_surface/edits/element_removal.h"
#include "algorithms/attribute_surface/edits/open_loop.h"
#include "algorithms/attribute_surface/network/loop_curves.h"
#include "croquis/attribute_surface/face_edit.h"
#include "croquis/attribute_surface/loop_search.h"

namespace croquis {
namespace {

constexpr std::size_t most_loop_sides = 64;

std::string curve_name(const AttributeNetwork& network, Index curve) { return quoted(network.curves[curve].id); }

/// Sorts the curves of one loop, or says why they are none.
class LoopOrder {
 public:
  LoopOrder(const AttributeNetwork& network, const std::vector<Index>& curves, double tolerance)
      : network_(network), curves_(curves), ends_(network, curves, tolerance) {}

  SortedLoop run() {
    if (!check_count()) return std::move(loop_);
    if (!check_ends()) return std::move(loop_);
    walk();
    if (loop_.sides.size() < curves_.size()) refuse_parts();
    return std::move(loop_);
  }

 private:
  void complain(const char* code, const std::string& sentence, const std::vector<Index>& named) {
    std::vector<Subject> subjects;
    for (const Index curve : named) subjects.push_back(named_curve(network_.curves[curve].id));
    loop_.findings.push_back(make_error(Category::Geometry, code, sentence, std::move(subjects)));
  }

  bool check_count() {
    const std::set<Index> each(curves_.begin(), curves_.end());
    if (each.size() < curves_.size())
      complain("E_DUP_CURVE", "A curve is named twice: a loop has each of its curves once.", {});
    if (curves_.size() > most_loop_sides)
      complain("E_TOO_MANY",
               "A loop of " + std::to_string(curves_.size()) + " curves has more than 64: leave some out.", {});
    const bool lone = curves_.size() == 1 && ends_.of(0, false) != ends_.of(0, true);
    if (curves_.empty()) complain("E_TOO_FEW", "No curve is chosen: choose those around a patch.", {});
    if (lone)
      complain("E_TOO_FEW",
               "Curve " + curve_name(network_, curves_[0]) + " isn't closed: choose all curves around a patch.",
               {curves_[0]});
    return loop_.findings.empty();
  }

  /// At each place two curves have to meet.
  bool check_ends() {
    std::vector<std::size_t> loose;
    std::vector<std::size_t> meeting(2 * curves_.size());
    for (std::size_t end = 0; end < meeting.size(); ++end) ++meeting[ends_.of(end / 2, end % 2 == 1)];
    for (std::size_t end = 0; end < meeting.size(); ++end) {
      if (meeting[end] == 1) loose.push_back(end_at(end));
      if (meeting[end] > 2) refuse_branch(end);
    }
    if (loop_.findings.empty() && !loose.empty()) refuse_gaps(std::move(loose));
    return loop_.findings.empty();
  }

  /// The end whose place has that number.
  std::size_t end_at(std::size_t place) const {
    for (std::size_t end = 0; end < 2 * curves_.size(); ++end) {
      if (ends_.of(end / 2, end % 2 == 1) == place) return end;
    }
    return 0;
  }

  Vec3 place_of(std::size_t end) const { return end_place(network_, {curves_[end / 2], end % 2 == 0}); }

  void refuse_branch(std::size_t place) {
    std::vector<Index> named;
    std::string names;
    for (std::size_t end = 0; end < 2 * curves_.size(); ++end) {
      if (ends_.of(end / 2, end % 2 == 1) != place) continue;
      named.push_back(curves_[end / 2]);
      names += (names.empty() ? "" : ", ") + curve_name(network_, curves_[end / 2]);
    }
    complain("E_OPEN_LOOP", "Curves " + names + " all meet at one place: leave out those that aren't around the patch.",
             named);
  }

  /// Pairs loose ends that are nearest to one another, and names the gap between them.
  void refuse_gaps(std::vector<std::size_t> loose) {
    while (loose.size() >= 2) {
      std::pair<std::size_t, std::size_t> nearest{0, 1};
      double least = std::numeric_limits<double>::infinity();
      for (std::size_t i = 0; i < loose.size(); ++i) {
        for (std::size_t k = i + 1; k < loose.size(); ++k) {
          const double distance = (place_of(loose[i]) - place_of(loose[k])).norm();
          if (distance >= least) continue;
          least = distance;
          nearest = {i, k};
        }
      }
      const Index a = curves_[loose[nearest.first] / 2];
      const Index b = curves_[loose[nearest.second] / 2];
      const std::string who = a == b ? "Both ends of curve " + curve_name(network_, a)
                                     : "Curves " + curve_name(network_, a) + " and " + curve_name(network_, b);
      complain("E_OPEN_LOOP",
               who + " are " + length_text(network_, least) +
                   " apart: move their ends together, or choose the curve between them.",
               a == b ? std::vector{a} : std::vector{a, b});
      loose.erase(loose.begin() + static_cast<std::ptrdiff_t>(nearest.second));
      loose.erase(loose.begin() + static_cast<std::ptrdiff_t>(nearest.first));
    }
  }

  void refuse_parts() {
    std::string names;
    std::vector<Index> others;
    for (const Index curve : curves_) {
      if (std::ranges::find(loop_.sides, curve, &AttributeSide::curve) == loop_.sides.end()) others.push_back(curve);
    }
    complain("E_OPEN_LOOP",
             "The curves are more than one loop: choose those of the loop with curve " +
                 curve_name(network_, curves_[0]) + " or those of the loop with curve " +
                 curve_name(network_, others.front()) + ".",
             {curves_[0], others.front()});
    loop_.sides.clear();
    loop_.snaps.clear();
  }

  void walk() {
    std::vector<bool> used(curves_.size());
    std::size_t at = 0;
    bool reversed = false;
    while (!used[at]) {
      used[at] = true;
      loop_.sides.push_back({curves_[at], reversed});
      const std::size_t place = ends_.of(at, !reversed);
      const auto next = next_at(place, used);
      if (!next) break;
      at = next->first;
      reversed = next->second;
    }
    if (loop_.sides.size() == curves_.size()) note_snaps();
  }

  /// The unused curve with an end at a place, and whether that is its last one.
  std::optional<std::pair<std::size_t, bool>> next_at(std::size_t place, const std::vector<bool>& used) const {
    for (std::size_t i = 0; i < curves_.size(); ++i) {
      if (used[i]) continue;
      if (ends_.of(i, false) == place) return std::pair{i, false};
      if (ends_.of(i, true) == place) return std::pair{i, true};
    }
    return std::nullopt;
  }

  void note_snaps() {
    for (std::size_t i = 0; i < loop_.sides.size(); ++i) {
      const AttributeSide& before = loop_.sides[i];
      const AttributeSide& after = loop_.sides[(i + 1) % loop_.sides.size()];
      const Index node = end_node(network_, before);
      if (node != no_index && node == start_node(network_, after)) continue;
      const double distance = (end_place(network_, before) - start_place(network_, after)).norm();
      loop_.snaps.push_back({before, after, distance});
    }
  }

  const AttributeNetwork& network_;
  const std::vector<Index>& curves_;
  CurveEnds ends_;
  SortedLoop loop_;
};

}  // namespace

void turn_loop_round(SortedLoop& loop) {
  if (loop.sides.empty()) return;
  std::ranges::reverse(loop.sides.begin() + 1, loop.sides.end());
  for (AttributeSide& side : loop.sides) side.reversed = !side.reversed;
  for (LoopGap& gap : loop.snaps) {
    std::swap(gap.before, gap.after);
    gap.before.reversed = !gap.before.reversed;
    gap.after.reversed = !gap.after.reversed;
  }
}

int turn_of_neighbours(const AttributeNetwork& network, const std::vector<AttributeSide>& sides) {
  int turn = 0;
  for (const AttributeFace& face : network.faces) {
    for (const AttributeSide& other : face.loop) {
      const auto own = std::ranges::find(sides, other.curve, &AttributeSide::curve);
      if (own != sides.end()) turn += own->reversed != other.reversed ? 1 : -1;
    }
  }
  return turn;
}

SortedLoop sort_loop(const AttributeNetwork& network, const std::vector<Index>& curves, double tolerance) {
  SortedLoop loop = LoopOrder(network, curves, tolerance).run();
  if (turn_of_neighbours(network, loop.sides) < 0) turn_loop_round(loop);
  return loop;
}

AddedElement close_loop(AttributeNetwork network, const SortedLoop& loop) {
  struct NamedSide {
    std::string curve;
    bool reversed;
  };
  std::vector<NamedSide> sides;
  for (const AttributeSide& side : loop.sides) sides.push_back({network.curves[side.curve].id, side.reversed});
  for (const NamedSide& side : sides) network = tie_ends(std::move(network), side.curve, 0);
  const auto side_of = [&](const NamedSide& side) {
    return AttributeSide{require_element(network, NetworkElement::Curve, side.curve), side.reversed};
  };
  for (std::size_t i = 0; i < sides.size() && sides.size() > 1; ++i) {
    const Index end = end_node(network, side_of(sides[i]));
    const Index start = start_node(network, side_of(sides[(i + 1) % sides.size()]));
    if (end == start) continue;
    const auto [first, later] = std::minmax({end, start});
    const std::string later_id = network.nodes[later].id, first_id = network.nodes[first].id;
    network = merge_nodes(std::move(network), later_id, first_id);
  }
  std::vector<AttributeSide> sorted;
  for (const NamedSide& side : sides) sorted.push_back(side_of(side));
  return add_face(std::move(network), std::move(sorted));
}

}  // namespace croquis

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <span>
#include <vector>

#include "app/studio/studio.h"
#include "croquis/operators/hole_wishes.h"

namespace croquis::app {

/// The parameters of a `fill` operation per hole, so that one hole can be changed without touching the others, and
/// joined again.
class HolePlan {
 public:
  HolePlan() = default;

  /// @throws Error (E_PARAMETER) when the wishes can't be parsed
  HolePlan(const Studio& studio, const Node& node);

  /// Of one hole alone; empty when nothing is wished.
  HoleWish wish(Index hole) const;
  const std::vector<HoleWish>& bridges() const { return bridges_; }
  bool is_bridged(Index hole) const;

  void fill(std::span<const Index> holes);

  /// Fills what a selection of all fills, whatever single holes were given; how they are made stays.
  /// @param open holes that stay open then: what is wished of their shape alone would fill them
  void fill_all(hole_filling::Selection select, std::span<const Index> open);

  /// What was wished of them goes away; those that would be filled with others are left.
  void reopen(std::span<const Index> holes);

  /// Those that hold one of the holes are no more; what else was wished of holes stays.
  void part_bridges(std::span<const Index> holes);

  /// One patch joins the rims.
  void bridge(std::span<const Index> holes);

  /// Changes how holes are made. Open ones stay open. @param filled ids of those that are filled now, sorted
  template <typename Change>
  void change(std::span<const Index> holes, std::span<const Index> filled, Change&& change_wish) {
    for (const Index hole : holes) {
      HoleWish& changed = entry(hole);
      change_wish(changed);
      keep_as_is(changed, filled);
    }
    forget_empty();
  }

  /// The parameters that are to be set.
  ParameterValues values() const;

 private:
  HoleWish& entry(Index hole);
  static void keep_as_is(HoleWish& wish, std::span<const Index> filled);
  void forget_empty();

  FillChoice choice_;  ///< without its wishes, which follow
  std::map<Index, HoleWish> single_;
  std::vector<HoleWish> bridges_;
};

}  // namespace croquis::app

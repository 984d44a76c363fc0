// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tools/holes/hole_plan.h"

#include <algorithm>
#include <utility>

#include "app/tools/holes/filling.h"

namespace croquis::app {
namespace {

bool has(std::span<const Index> holes, Index hole) {
  return std::find(holes.begin(), holes.end(), hole) != holes.end();
}

bool says_nothing(const HoleWish& wish) {
  HoleWish empty;
  empty.holes = wish.holes;
  return wish == empty;
}

/// The values given in the later one, and else those of the earlier one.
void merge(HoleWish& earlier, const HoleWish& later) {
  if (later.fill) earlier.fill = later.fill;
  if (!later.fairness.empty()) earlier.fairness = later.fairness;
  if (!later.kernel.empty()) earlier.kernel = later.kernel;
  if (later.bulge) earlier.bulge = later.bulge;
  if (later.trim_rim) earlier.trim_rim = later.trim_rim;
  earlier.through.insert(earlier.through.end(), later.through.begin(), later.through.end());
}

bool same_but_holes(const HoleWish& a, HoleWish b) {
  b.holes = a.holes;
  return a == b;
}

}  // namespace

HolePlan::HolePlan(const Studio& studio, const Node& node) {
  ParameterValues values;
  for (const char* name : {"select", "only", "holes"}) values[name] = filling_value(studio, node, name);
  choice_ = read_fill_choice(values);
  for (const HoleWish& wish : std::exchange(choice_.wishes, {})) {
    if (wish.bridge) {
      bridges_.push_back(wish);
      continue;
    }
    for (const Index hole : wish.holes) merge(entry(hole), wish);
  }
}

HoleWish HolePlan::wish(Index hole) const {
  const auto found = single_.find(hole);
  return found == single_.end() ? HoleWish{{hole}, false, {}, {}, {}, {}, {}, {}} : found->second;
}

bool HolePlan::is_bridged(Index hole) const {
  return std::any_of(bridges_.begin(), bridges_.end(), [&](const HoleWish& wish) { return has(wish.holes, hole); });
}

HoleWish& HolePlan::entry(Index hole) {
  HoleWish& wish = single_[hole];
  wish.holes = {hole};
  return wish;
}

void HolePlan::keep_as_is(HoleWish& wish, std::span<const Index> filled) {
  // Any wish fills the hole, unless its `fill` is false.
  if (!wish.fill && !has(filled, wish.holes.front())) wish.fill = false;
}

void HolePlan::forget_empty() {
  std::erase_if(single_, [](const auto& entry) { return says_nothing(entry.second); });
}

void HolePlan::part_bridges(std::span<const Index> holes) {
  std::erase_if(bridges_, [&](const HoleWish& wish) {
    return std::any_of(wish.holes.begin(), wish.holes.end(), [&](Index hole) { return has(holes, hole); });
  });
}

void HolePlan::fill(std::span<const Index> holes) {
  for (const Index hole : holes) {
    if (!is_bridged(hole)) entry(hole).fill = true;
  }
}

void HolePlan::fill_all(hole_filling::Selection select, std::span<const Index> open) {
  choice_.select = select;
  choice_.only.clear();
  for (auto& [hole, wish] : single_) wish.fill.reset();
  forget_empty();
  for (auto& [hole, wish] : single_) wish.fill = !has(open, hole);
  part_bridges(open);
}

void HolePlan::reopen(std::span<const Index> holes) {
  part_bridges(holes);
  for (const Index hole : holes) {
    single_.erase(hole);
    if (choice_.select != hole_filling::Selection::None || !choice_.only.empty()) entry(hole).fill = false;
  }
}

void HolePlan::bridge(std::span<const Index> holes) {
  part_bridges(holes);
  HoleWish wish;
  wish.holes.assign(holes.begin(), holes.end());
  wish.bridge = true;
  for (const Index hole : holes) single_.erase(hole);
  bridges_.push_back(std::move(wish));
}

ParameterValues HolePlan::values() const {
  FillChoice choice = choice_;
  std::vector<HoleWish>& wishes = choice.wishes;
  for (const auto& [hole, wish] : single_) {
    const auto same = std::find_if(wishes.begin(), wishes.end(),
                                   [&, &own = wish](const HoleWish& other) { return same_but_holes(own, other); });
    if (same == wishes.end() || !wish.through.empty())
      wishes.push_back(wish);
    else
      same->holes.push_back(hole);
  }
  wishes.insert(wishes.end(), bridges_.begin(), bridges_.end());
  return to_parameters(choice);
}

}  // namespace croquis::app

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <map>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include "croquis/base/members.h"
#include "croquis/geometry/vector.h"
#include "croquis/silhouette/options.h"

namespace croquis::silhouette {

/// Two objects of a figure, a < b.
using ObjectPair = std::pair<Index, Index>;

/// How two objects are held; see AttachedPair.
struct HeldPair {
  Hold hold = Hold::Joined;  ///< or Resting: the upper one lies on the lower one; each stays a surface of its own
  double kappa = 0;          ///< of joined ones, which may sink into one another
  double blend = 0;          ///< of joined ones; 0: a sharp seam
};
constexpr auto members(const HeldPair& pair) { return std::tie(pair.hold, pair.kappa, pair.blend); }
static_assert(lists_every_member<HeldPair>);

/// The pairs of a figure's objects that don't just keep the gap.
struct Attachments {
  std::map<ObjectPair, HeldPair> held;

  /// None for objects that aren't joined, and for an object and itself.
  std::optional<double> kappa(Index a, Index b) const {
    const auto found = held.find(std::minmax(a, b));
    const bool joined = found != held.end() && found->second.hold == Hold::Joined;
    return joined ? std::optional(found->second.kappa) : std::nullopt;
  }

  bool resting(Index a, Index b) const {
    const auto found = held.find(std::minmax(a, b));
    return found != held.end() && found->second.hold == Hold::Resting;
  }

  /// Ascending.
  std::vector<ObjectPair> pairs(Hold hold) const {
    std::vector<ObjectPair> found;
    for (const auto& [pair, how] : held) {
      if (how.hold == hold) found.push_back(pair);
    }
    return found;
  }

  bool any(Hold hold) const {
    return std::ranges::any_of(held, [hold](const auto& entry) { return entry.second.hold == hold; });
  }

  /// Whether the object is joined to another one.
  bool joins(Index object) const {
    return std::ranges::any_of(held, [object](const auto& entry) {
      const auto& [pair, how] = entry;
      return how.hold == Hold::Joined && (pair.first == object || pair.second == object);
    });
  }
};
inline auto members(const Attachments& attachments) { return std::tie(attachments.held); }

/// Gap between an object and one that rests on it: too small to be seen, kept by files that round to u / 100.
/// @param scale L
/// @param unit u
inline double resting_gap(double scale, double unit) { return std::max(0.01 * scale, 0.1 * unit); }

/// Distance of the middles of two attached parts of these half thicknesses: kappa times that of touching ones, but sunk
/// by at least two fifths of the thinner one. Surfaces that only touch have no sound union.
inline double attached_distance(double kappa, double a, double b) {
  constexpr double least_sinking = 0.4;
  return std::min(kappa * (a + b), a + b - least_sinking * std::min(a, b));
}

}  // namespace croquis::silhouette

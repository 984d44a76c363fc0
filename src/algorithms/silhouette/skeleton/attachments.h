// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <map>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include "algorithms/silhouette/skeleton/skeleton.h"
#include "croquis/geometry/vector.h"

namespace croquis::silhouette {

/// How the pairs of a figure's objects are held that don't just keep the gap.
class Attachments {
 public:
  using Pair = std::pair<Index, Index>;  ///< objects (a, b), a < b

  /// Joined: they may sink into one another. A later call for the same pair counts.
  /// @param kappa 0..1, see AttachedPair
  void add(Index a, Index b, double kappa);

  /// Resting: the upper one lies on the lower one; each stays a surface of its own. A later call counts.
  void rest(Index a, Index b);

  /// Whether no pair is joined.
  bool empty() const { return kappa_.empty(); }

  /// None for objects that aren't joined, and for an object and itself.
  std::optional<double> kappa(Index a, Index b) const;

  bool resting(Index a, Index b) const;

  /// Whether the object is joined to another one.
  bool involves(Index object) const;

  /// Objects that are joined, each group ascending, in the order of their first objects.
  std::vector<std::vector<Index>> groups() const;

  /// The two then keep apart.
  void release(Index a, Index b);

  /// Joined ones, with their kappa.
  const std::map<Pair, double>& pairs() const { return kappa_; }

  /// Ascending.
  const std::vector<Pair>& resting_pairs() const { return resting_; }

 private:
  std::map<Pair, double> kappa_;
  std::vector<Pair> resting_;
};

inline auto members(const Attachments& attachments) {
  return std::tie(attachments.pairs(), attachments.resting_pairs());
}

/// Gap between an object and one that rests on it: too small to be seen, kept by files that round to u / 100.
/// @param scale L
/// @param unit u
inline double resting_gap(double scale, double unit) { return std::max(0.01 * scale, 0.1 * unit); }

/// Distance of the middles of two attached parts of these half thicknesses: kappa times that of touching ones, but sunk
/// by at least two fifths of the thinner one. Surfaces that only touch have no sound union.
double attached_distance(double kappa, double a, double b);

/// Per object the median radius of its skeleton's nodes, up to the last one that has nodes; 0 for one without.
std::vector<double> object_radii(const Skeleton& skeleton);

/// Per object, how hard it is to move: its median radius / L, the factor of its rows and thus the root of its
/// energies'. Where parts press on one another, the thin one gives way and the wide one keeps its shape.
std::vector<double> row_stiffness(const Skeleton& skeleton);

}  // namespace croquis::silhouette

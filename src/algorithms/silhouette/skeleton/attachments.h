// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "algorithms/silhouette/skeleton/skeleton.h"
#include "croquis/geometry/vector.h"

namespace croquis::silhouette {

/// The pairs of a figure's objects that may sink into one another, and how deep.
class Attachments {
 public:
  /// @param kappa 0..1, see AttachedPair
  void add(Index a, Index b, double kappa) { kappa_[std::minmax(a, b)] = kappa; }

  bool empty() const { return kappa_.empty(); }

  /// None for objects that must keep apart, and for an object and itself.
  std::optional<double> kappa(Index a, Index b) const;

  bool involves(Index object) const;

  /// Objects that are attached, each group ascending, in the order of their first objects.
  std::vector<std::vector<Index>> groups() const;

  /// Without the pairs among these objects.
  Attachments without(const std::vector<Index>& group) const;

  /// By objects (a, b), a < b.
  const std::map<std::pair<Index, Index>, double>& pairs() const { return kappa_; }

 private:
  std::map<std::pair<Index, Index>, double> kappa_;
};

inline auto members(const Attachments& attachments) { return std::tie(attachments.pairs()); }

/// Distance of the middles of two attached parts of these half thicknesses: kappa times that of touching ones, but sunk
/// by at least two fifths of the thinner one. Surfaces that only touch have no sound union.
double attached_distance(double kappa, double a, double b);

/// How hard an object is to move; the factors are those of its rows, the roots of its energies'.
struct RowStiffness {
  /// Of all its rows: mean radius / L, so that the limb moves and not the body.
  double all = 1;
  /// Besides that, of its rows that pull it to the sketch plane: (mean radius / the largest of its group)^2. The
  /// body holds its limb in depth; else legs would swing back to the plane below the body and cross.
  double distance = 1;
};

/// @return per object up to the last one attached, 1 for those that aren't; none without attachments
std::vector<RowStiffness> row_stiffness(const Skeleton& skeleton, const Attachments& attachments);

}  // namespace croquis::silhouette

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "croquis/hole_filling/hole_site.h"
#include "croquis/hole_filling/implicit_options.h"
#include "croquis/implicit/local_fit.h"

namespace croquis::hole_filling {

/// Smooth sides that meet at creases, as one function: each side has a fit of its own, and of these the greatest (where
/// the crease is convex) or the least (where it is concave) counts, as a tree decides.
class CreaseField {
 public:
  /// A node of the tree: a side, or the greater or lesser of two nodes before it.
  struct Node {
    int side = -1;  ///< or -1
    bool is_greater = false;
    std::size_t first = 0, second = 0;
  };

  struct Value {
    double value = 0;
    std::size_t side = 0;  ///< which of them it comes from
  };

  CreaseField(std::vector<std::shared_ptr<const implicit::LocalFit>> fits, std::vector<Node> tree)
      : fits_(std::move(fits)), tree_(std::move(tree)) {}

  std::size_t side_count() const { return fits_.size(); }
  const implicit::LocalFit& fit(std::size_t side) const { return *fits_[side]; }
  Value value(const Vec3& point) const;

  /// This as a field; it shares what it needs.
  implicit::Field field() const;

 private:
  std::vector<std::shared_ptr<const implicit::LocalFit>> fits_;
  std::vector<Node> tree_;  ///< the last one counts
};

/// Whether creases (see crease_cosine) end at the rims: twice at least, since each that runs in runs out again or meets
/// others. Linear in the faces around the rims, and far cheaper than `fit_sides`.
bool creases_run_in(const HoleSite& site);

/// The mean distance of the known points to the continued sides, × mean rim edge, beyond which no sides are seen.
inline constexpr double usual_side_residual = 0.2;

/// Splits the surface around a site at its creases (see crease_cosine), continues each side that reaches the rims (Yoo
/// 2005, eq. 1-6), and finds the tree under which all known points come to lie nearest to the surface: so creases that
/// run into the hole go on in it.
/// @param most_residual see usual_side_residual
/// @return nothing when there are fewer than two sides or more than five, or no tree fits
std::optional<CreaseField> fit_sides(const HoleSite& site, const ImplicitOptions& options,
                                     double most_residual = usual_side_residual);

}  // namespace croquis::hole_filling

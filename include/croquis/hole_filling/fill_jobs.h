// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "croquis/hole_filling/fill_holes.h"

namespace croquis::hole_filling {

/// Holes that one patch joins, and how it is to be made.
struct FillJob {
  std::vector<Index> holes;  ///< ascending
  PatchWish wish;
  bool bridge = false;             ///< a band between the rims
  bool is_cap = false;             ///< closes an open section: flat
  bool waits = false;              ///< for another job to join it: nothing is made of it alone
  std::vector<Index> strays = {};  ///< of the holes, ascending: islands of a few triangles that hang at another rim by
                                   ///< a vertex, and are let go where no patch joins them all
};

/// Jobs that wait, one for each border that the selection leaves open: where the surface around a hole goes on to the
/// border of a smaller piece, that is an island of the hole. Linear.
std::vector<FillJob> waiting_jobs(std::span<const Hole> holes, const FillOptions& options,
                                  const std::vector<bool>& is_border);

/// Those of a group of companions. Linear.
std::vector<Index> strays_among(std::span<const Hole> all, const std::vector<Index>& group);

/// The job for the other holes alone.
FillJob without_strays(const FillJob& job);

/// What is to be done, by the lowest holes: companions that are both chosen are one job, and so are rims that a request
/// bridges. A job follows the requests that name any of its holes, later ones over earlier ones, then the options.
/// Linear but for sorting.
/// @param is_chosen per hole
std::vector<FillJob> make_jobs(std::span<const Hole> holes, const FillOptions& options,
                               const std::vector<bool>& is_chosen);

/// Rings of faces to be removed around each hole, 0 for holes that aren't chosen.
std::vector<int> rings_to_trim(std::span<const Hole> holes, const FillOptions& options,
                               const std::vector<bool>& is_chosen);

}  // namespace croquis::hole_filling

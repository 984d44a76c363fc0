// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "croquis/hole_filling/fill_holes.h"
#include "croquis/hole_filling/hole_patch.h"

/// Which holes are filled: one rule for the algorithms and for hosts that list the holes first.
namespace croquis::hole_filling {

/// What a selection goes by.
struct HoleSize {
  HoleClass kind = HoleClass::Simple;
  double diameter = 0;  ///< model units
};

/// Whether a selection names a hole, or why it doesn't.
enum class Naming {
  Named,
  NotChosen,  ///< Selection::None names nothing
  Border,     ///< Selection::Inner leaves open what looks like the border of an open surface
  Largest,    ///< Selection::AllButLargest leaves this one open: of several of that diameter, the first
  TooWide     ///< its diameter is greater than the greatest that is filled
};

/// Per hole. Linear.
/// @param max_diameter as FillOptions has it
std::vector<Naming> named_holes(std::span<const HoleSize> holes, Selection selection, double max_diameter);

/// Which holes the options ask to fill: what fill_holes goes by.
struct HoleChoice {
  std::vector<bool> is_chosen;      ///< per hole
  std::vector<std::string> reason;  ///< why a hole isn't
  std::vector<bool> is_border;      ///< it isn't since it looks like a border, and may prove to be an island's
};

/// By `requests` where they name a hole, else by `only` where that isn't empty, else by the selection. Linear, but for
/// the list of ids.
/// @throws Error (E_PARAMETER) with one finding for every id in `only` that no hole has
HoleChoice choose_holes(std::span<const Hole> holes, const FillOptions& options);

/// Holes that one patch joins, how it is to be made, and what came of it.
struct FillJob {
  std::vector<Index> holes;  ///< ascending
  PatchSettings settings;
  bool bridge = false;               ///< a band between the rims
  bool is_cap = false;               ///< closes an open section: flat
  bool waits = false;                ///< for another job to join it: nothing is made of it alone
  std::vector<Index> detached = {};  ///< of the holes, ascending: islands of a few triangles that hang at another rim
                                     ///< by a vertex, and are let go where no patch joins them all
  std::optional<HolePatch> patch = {};  ///< verified; none when no method had a sound one
  HoleOutcome outcome = {};             ///< of each of the holes, without what depends on the patch alone
};

/// Jobs that wait, one for each border that the selection leaves open: where the surface around a hole goes on to the
/// border of a smaller piece, that is an island of the hole. Linear.
std::vector<FillJob> waiting_jobs(std::span<const Hole> holes, const FillOptions& options,
                                  const std::vector<bool>& is_border);

/// Those of a group of companions. Linear.
std::vector<Index> detached_among(std::span<const Hole> all, const std::vector<Index>& group);

/// The job for the other holes alone.
FillJob without_detached(const FillJob& job);

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

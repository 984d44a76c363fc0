// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/hole_filling/patching/patch_ladder.h"

#include <algorithm>
#include <utility>

#include "algorithms/hole_filling/continuation/crease_field.h"
#include "croquis/hole_filling/wide_holes.h"

namespace croquis::hole_filling {
namespace {

// Smoothing for noise, × the usual one.
constexpr double noisy_values = 10;
constexpr double noisy_gradients = 6;

/// Without being asked for, creases go on only where the sides between them fit the surface around this well (see
/// fit_sides): what runs into holes of rough or crumpled surfaces is hardly an edge of the thing.
constexpr double trusted_residual = 0.03;

/// And in holes up to this, × the size of the component.
constexpr double widest_creased = 0.35;

ImplicitOptions adapted(ImplicitOptions options, Preset preset) {
  if (preset == Preset::Noisy) {
    options.value_smoothing *= noisy_values;
    options.gradient_smoothing *= noisy_gradients;
  }
  if (preset == Preset::Paper) options.both_sides = false;
  return options;
}

constexpr std::ptrdiff_t cubes_rung = 1;
constexpr std::ptrdiff_t flat_rungs = 4;

void add_implicit(const ImplicitOptions& options, std::size_t most_triangles, Ladder& ladder) {
  ladder.push_back(implicit_patcher(options, most_triangles));
  ladder.push_back(polygonised_patcher(options, most_triangles));
  ladder.push_back(implicit_patcher(options, most_triangles, true));
}

/// A bulge turns the rings around the rim; their curvature, which continuity 2 goes by, is then that of the turn.
void add_smooth(const PatchWish& wish, std::size_t most_triangles, Ladder& ladder) {
  if (wish.fairness == Fairness::Curved && wish.bulge == 0) ladder.push_back(faired_patcher(2, most_triangles));
  ladder.push_back(faired_patcher(1, most_triangles));
  ladder.push_back(faired_patcher(1, most_triangles, true));
}

void add_flat(Ladder& ladder) {
  ladder.push_back(minimal_patcher());
  ladder.push_back(dihedral_patcher());
  ladder.push_back(plane_patcher());
  ladder.push_back(avoiding_patcher());
}

/// In the order that repairs known surface best.
void add_validated(const ImplicitOptions& options, std::size_t most_triangles, Ladder& ladder) {
  const Ladder ways = {creased_patcher(options, most_triangles), implicit_patcher(options, most_triangles),
                       faired_patcher(2, most_triangles)};
  for (std::size_t rank = 0; rank < ways.size(); ++rank) ladder.push_back(validated_patcher(ways, rank));
  ladder.push_back(polygonised_patcher(options, most_triangles));
  ladder.push_back(implicit_patcher(options, most_triangles, true));
}

/// Whether the surface at each of two rims goes on towards the other one.
bool face_each_other(const Hole& a, const Hole& b) {
  const Vec3 way = b.centre - a.centre;
  return a.conormal.dot(way) > 0 && b.conormal.dot(way) < 0;
}

bool joins_two_rims(const HoleSite& site) {
  if (site.polygon.loop_count() != 2) return false;
  return site.bridge || site.analysis->holes[site.holes.front()].kind == HoleClass::Tunnel;
}

bool is_plain_slit(const HoleSite& site) {
  return site.holes.size() == 1 && site.analysis->holes[site.holes.front()].kind == HoleClass::Slit &&
         site.wish.bulge == 0;
}

/// Where triangulations of the rims, which the projecting methods begin with, often cut through the surface; or may
/// pass a piece of it that belongs to the hole.
bool is_hard_to_triangulate(const HoleSite& site) {
  if (site.holes.size() > 1) return true;
  return is_wide(*site.analysis, site.holes.front());
}

/// Whether a piece that isn't the site's is in its middle: it may belong to the hole, and is found by cubes alone.
bool has_piece_inside(const HoleSite& site, const Hole& widest) {
  return std::ranges::any_of(site.analysis->holes, [&](const Hole& other) {
    return other.component != widest.component && 2 * (other.centre - widest.centre).norm() < widest.diameter &&
           !std::ranges::binary_search(site.holes, other.id);
  });
}

/// Fits of single sides know neither bulges nor other kernels.
bool goes_on_with_creases(const HoleSite& site) {
  if (site.wish.bulge != 0 || site.wish.implicit.kernel != implicit::Kernel::Hermite) return false;
  const auto diameter = [&](Index hole) { return site.analysis->holes[hole].diameter; };
  const Hole& widest = site.analysis->holes[std::ranges::max(site.holes, {}, diameter)];
  return widest.diameter <= widest_creased * site.analysis->component_size[widest.component] && creases_run_in(site) &&
         !has_piece_inside(site, widest);
}

Ladder ladder_between(const HoleSite& site, Preset preset, std::size_t most_triangles) {
  const auto& holes = site.analysis->holes;
  const bool is_flat = site.wish.fairness == Fairness::Flat;
  Ladder ladder;
  if (!is_flat) {
    if (site.wish.fairness == Fairness::Implicit && face_each_other(holes[site.holes[0]], holes[site.holes[1]]))
      add_implicit(adapted(site.wish.implicit, preset), most_triangles, ladder);
    add_smooth(site.wish, most_triangles, ladder);
  }
  ladder.push_back(band_patcher(false));
  ladder.push_back(band_patcher(true));
  add_flat(ladder);
  return ladder;
}

}  // namespace

Ladder ladder_for(const PatchWish& wish, Preset preset, bool is_cap, std::size_t most_triangles) {
  Fairness fairness = is_cap ? Fairness::Flat : wish.fairness;
  if (!wish.through.empty()) fairness = Fairness::Implicit;
  Ladder ladder;
  if (fairness == Fairness::Implicit) {
    const ImplicitOptions options = adapted(wish.implicit, preset);
    if (preset == Preset::Sharp && wish.through.empty()) {
      add_validated(options, most_triangles, ladder);
    } else {
      add_implicit(options, most_triangles, ladder);
    }
  }
  if (fairness != Fairness::Flat) add_smooth(wish, most_triangles, ladder);
  add_flat(ladder);
  return ladder;
}

Ladder ladder_for(const HoleSite& site, Preset preset, bool is_cap, std::size_t most_triangles) {
  if (!site.wish.through.empty()) return ladder_for(site.wish, preset, false, most_triangles);
  if (joins_two_rims(site)) return ladder_between(site, preset, most_triangles);
  if (preset == Preset::Sharp && site.holes.size() > 1) preset = Preset::Standard;  // probes have no islands
  Ladder ladder = ladder_for(site.wish, preset, is_cap, most_triangles);
  const bool is_implicit = !is_cap && site.wish.fairness == Fairness::Implicit && preset != Preset::Sharp;
  if (is_implicit && is_hard_to_triangulate(site)) {
    std::rotate(ladder.begin(), ladder.begin() + cubes_rung, ladder.begin() + cubes_rung + 1);
    // Walls: what goes straight on may cut through the other skin.
    ladder.insert(ladder.end() - flat_rungs,
                  polygonised_patcher(adapted(site.wish.implicit, preset), most_triangles, true));
  }
  if (is_implicit && preset == Preset::Auto && goes_on_with_creases(site))
    ladder.insert(ladder.begin(), creased_patcher(site.wish.implicit, most_triangles, trusted_residual));
  if (is_plain_slit(site)) ladder.insert(ladder.begin(), zip_patcher());
  return ladder;
}

}  // namespace croquis::hole_filling

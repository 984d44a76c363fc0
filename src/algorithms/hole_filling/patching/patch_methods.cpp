// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/hole_filling/patching/patch_methods.h"

#include <algorithm>
#include <functional>
#include <utility>

#include "algorithms/hole_filling/analysis/sorted_lists.h"
#include "algorithms/hole_filling/continuation/creases.h"
#include "algorithms/hole_filling/patching/near_scene.h"

namespace croquis::hole_filling {
namespace {

/// Creases go on in holes up to this without being asked for, × the size of the component.
constexpr double widest_creased = 0.35;

/// Whether the surface at each of two rims goes on towards the other one.
bool face_each_other(const HoleSite& site) {
  const Hole &a = site.analysis->holes[site.holes[0]], &b = site.analysis->holes[site.holes[1]];
  const Vec3 way = b.centre - a.centre;
  return a.conormal.dot(way) > 0 && b.conormal.dot(way) < 0;
}

/// Where triangulations of the rims, which the projecting method begins with, often cut through the surface; or may
/// pass a piece of it that belongs to the hole.
bool is_hard_to_triangulate(const HoleSite& site) {
  return site.holes.size() > 1 || is_wide(*site.analysis, site.holes.front());
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
  if (site.preset != Preset::Auto && site.preset != Preset::Sharp) return false;
  if (site.settings.bulge != 0 || site.settings.implicit.kernel != implicit::Kernel::Hermite) return false;
  const Hole& widest = widest_hole(site);
  const bool is_wanted = site.preset == Preset::Sharp ||
                         widest.diameter <= widest_creased * site.analysis->component_size[widest.component];
  return is_wanted && creases_run_in(site) && !has_piece_inside(site, widest);
}

constexpr std::size_t most_avoiding_points = 300;

/// Searches: as many as cost about half a second, within these bounds. Where they came to something on known scans,
/// rims of 120 points and more took 8 at most, and no rim more than 100.
constexpr std::size_t least_searches = 25;
constexpr std::size_t most_searches = 300;
constexpr std::size_t search_cost = 100000000;  ///< sum of cubes of points

std::size_t searches_for(std::size_t points) {
  return std::clamp(search_cost / (points * points * points), least_searches, most_searches);
}

/// Points of the polygon become vertices of the mesh.
Triangles in_vertices_of(const HoleSite& site, Triangles triangles) {
  for (auto& t : triangles) {
    for (Index& corner : t) corner = site.vertices[corner];
  }
  return triangles;
}

std::optional<HolePatch> patch_of(const HoleSite& site, std::optional<Triangles> triangles) {
  if (!triangles) return std::nullopt;
  return HolePatch{site.holes, {}, in_vertices_of(site, std::move(*triangles))};
}

/// Triangles to forbid: those that meet the surface, and of two that meet the costlier one. Each ascending.
Triangles offenders(const HoleSite& site, const NearScene& scene, const Triangles& triangulation, Progress& progress) {
  const auto cost = [&](const Triangle& t) {
    return triangle_cost(site.polygon.points[t[0]], site.polygon.points[t[1]], site.polygon.points[t[2]]);
  };
  Triangles found;
  for (const Clash& clash : scene.clashes({}, in_vertices_of(site, triangulation), progress)) {
    const auto& later = triangulation[clash.triangle];
    const bool other_is_worse = clash.other != no_index && cost(triangulation[clash.other]) > cost(later);
    found.push_back(other_is_worse ? triangulation[clash.other] : later);
    std::ranges::sort(found.back());
  }
  return found;
}

std::optional<Triangles> search_avoiding(const HoleSite& site, Progress& progress) {
  const std::size_t points = site.polygon.points.size();
  if (points <= 3 || points > most_avoiding_points) return std::nullopt;  // a triangle has no other triangulation
  const NearScene scene(site, box_of(site.polygon.points, std::identity()));
  RimPolygon polygon = site.polygon;
  MinimalTriangulations triangulations(polygon, bridged_order(polygon));
  for (std::size_t searches = searches_for(points); searches > 0; --searches) {
    progress.check();
    auto found = triangulations.next(progress);
    if (!found) return std::nullopt;
    const Triangles forbidden = offenders(site, scene, *found, progress);
    if (forbidden.empty()) return found;
    polygon.avoided.insert(polygon.avoided.end(), forbidden.begin(), forbidden.end());
    sort_unique(polygon.avoided);
  }
  return std::nullopt;
}

std::optional<Triangles> cutting_nothing(const HoleSite& site, Progress& progress) {
  const NearScene scene(site, box_of(site.polygon.points, std::identity()));
  auto triangles = least_folding_triangulation(site, progress);
  if (triangles && offenders(site, scene, *triangles, progress).empty()) return triangles;
  if (site.polygon.points.size() > most_avoiding_points) return plane_triangulation(site.polygon);
  return avoiding_triangulation(site, progress);
}

}  // namespace

std::string name_of(const Method& method) {
  const std::string behind = method.careful ? "-careful" : "";
  switch (method.maker) {
    case Maker::Creased: return "creased";
    case Maker::Implicit: return "implicit" + behind;
    case Maker::Cubes: return "implicit-cubes" + behind;
    case Maker::Smooth: return "cgal-c1" + behind;
    case Maker::Band: return method.careful ? "band-shortest" : "band";
    case Maker::Flat: return method.careful ? "avoiding" : "minimal";
  }
  return "";
}

bool joins_two_rims(const HoleSite& site) {
  if (site.polygon.loop_count() != 2) return false;
  return site.bridge || site.analysis->holes[site.holes.front()].kind == HoleClass::Tunnel;
}

std::vector<Method> methods_for(const HoleSite& site, bool is_cap) {
  const bool is_pulled = !site.settings.through.empty();
  const bool is_between = !is_pulled && joins_two_rims(site);
  const Fairness fairness = is_pulled ? Fairness::Implicit : is_cap ? Fairness::Flat : site.settings.fairness;
  const bool is_implicit = fairness == Fairness::Implicit && (!is_between || face_each_other(site));
  const bool is_hard = !is_pulled && !is_between && is_hard_to_triangulate(site);
  std::vector<Method> methods;
  if (is_implicit) {
    if (!is_pulled && !is_between && goes_on_with_creases(site)) methods.push_back({Maker::Creased});
    methods.push_back({is_hard ? Maker::Cubes : Maker::Implicit});
    methods.push_back({is_hard ? Maker::Implicit : Maker::Cubes});
    methods.push_back({Maker::Implicit, true});
  }
  if (fairness != Fairness::Flat) {
    methods.push_back({Maker::Smooth});
    methods.push_back({Maker::Smooth, true});
  }
  // Walls: what goes straight on may cut through the other skin.
  if (is_implicit && is_hard) methods.push_back({Maker::Cubes, true});
  if (is_between) methods.insert(methods.end(), {{Maker::Band}, {Maker::Band, true}});
  methods.insert(methods.end(), {{Maker::Flat}, {Maker::Flat, true}});
  return methods;
}

std::optional<HolePatch> make_patch(const Method& method, const HoleSite& site, Progress& progress) {
  switch (method.maker) {
    case Maker::Creased: return creased_patch(site, progress);
    case Maker::Implicit: return implicit_patch(site, method.careful, progress);
    case Maker::Cubes: return cubes_patch(site, method.careful, progress);
    case Maker::Smooth: return smooth_patch(site, method.careful, progress);
    case Maker::Band: return band_patch(site, method.careful, progress);
    case Maker::Flat: return flat_patch(site, method.careful, progress);
  }
  return std::nullopt;
}

SiteMemory* SiteMemory::of(const HoleSite& site) {
  SiteMemory* memory = site.memory;
  if (memory != nullptr && memory->blocked_ != site.polygon.blocked) {
    const std::optional<double> crease_cosine = memory->crease_cosine;
    *memory = {};
    memory->crease_cosine = crease_cosine;
    memory->blocked_ = site.polygon.blocked;
  }
  return memory;
}

std::optional<RimField> fitted_once(const HoleSite& site, const RimFitOptions& how) {
  SiteMemory* memory = SiteMemory::of(site);
  if (memory == nullptr || !how.guides.empty()) return fit_rims(site, how);
  const bool is_full = how.every_normal || !continues_curvature(site);  // few normals count by r^5 alone
  const SiteMemory::Smoothness smoothness = {how.stiffness, how.other_sheets, is_full};
  const auto known = memory->fields.find(smoothness);
  return known != memory->fields.end() ? known->second : memory->fields[smoothness] = fit_rims(site, how);
}

std::optional<Triangles> avoiding_triangulation(const HoleSite& site, Progress& progress) {
  SiteMemory* memory = SiteMemory::of(site);
  if (memory == nullptr) return search_avoiding(site, progress);
  if (!memory->avoiding) memory->avoiding = search_avoiding(site, progress);
  return *memory->avoiding;
}

std::optional<HolePatch> band_patch(const HoleSite& site, bool shortest, Progress& progress) {
  const BandCost cost = shortest ? BandCost::Length : BandCost::Area;
  return patch_of(site, band_triangulation(site.polygon, cost, progress));
}

std::optional<HolePatch> flat_patch(const HoleSite& site, bool careful, Progress& progress) {
  progress.check();
  if (careful) return patch_of(site, cutting_nothing(site, progress));
  auto found = triangulate_rim(site.polygon, progress);
  if (!found) return std::nullopt;
  return patch_of(site, std::move(found->triangles));
}

}  // namespace croquis::hole_filling

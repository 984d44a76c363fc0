// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <utility>

#include "algorithms/hole_filling/analysis/sorted_lists.h"
#include "algorithms/hole_filling/fairing/fairing.h"
#include "algorithms/hole_filling/patching/near_scene.h"
#include "algorithms/hole_filling/patching/patch_methods.h"

namespace croquis::hole_filling {
namespace {

/// The Delaunay tetrahedra of points in special position have a triangle for each pair of them.
constexpr std::size_t most_dihedral_points = 1500;

const double usual_density = std::sqrt(2.0);  // CGAL's for triangles of the rim's own size

/// Edges of the even start, × those of the rim: methods that go on from it cut them on the surface.
constexpr double even_coarseness = 2;

/// Fairing with a ring of the surface follows its slope weakly: a bulge turns the ring by as many times the angle.
constexpr double faired_turn = 4;

constexpr double allowed_height = 0.5;  ///< of a patch, × diameter of the hole
constexpr double allowed_growth = 1.3;  ///< × height of the smooth patch

/// The patch as seen in the rim's plane lies beside the surface, not over it: the surest start for long rims, which
/// area alone folds.
std::optional<Triangles> base_for_fairing(const HoleSite& site, bool careful, Progress& progress) {
  const RimPolygon& rims = site.polygon;
  std::optional<Triangles> triangles;
  if (joins_two_rims(site)) triangles = band_triangulation(rims, careful ? BandCost::Length : BandCost::Area, progress);
  if (!triangles && careful) triangles = avoiding_triangulation(site, progress);
  if (!triangles) triangles = least_folding_triangulation(site, progress);
  if (!triangles && rims.points.size() > most_dihedral_points) triangles = plane_triangulation(rims);
  if (triangles) return triangles;
  auto found = triangulate_rim(rims, progress);
  if (!found) return std::nullopt;
  return std::move(found->triangles);
}

/// A patch with the faces around it, as fairing takes it: about the rim's centre and of unit size.
struct LocalSite {
  LoosePatch patch;
  std::vector<Index> vertices;  ///< of the view, sorted, per point
  Vec3 centre = Vec3::Zero();
  double size = 1;

  Index number(Index vertex) const { return place_in(vertices, vertex); }
};

LocalSite make_local_site(const HoleSite& site, const Triangles& patch) {
  const SurfaceView& view = site.analysis->view;
  LocalSite local;
  const Hole& widest = widest_hole(site);
  local.centre = widest.centre;
  local.size = widest.diameter;
  Triangles around;
  for (const Index t : surroundings(site, 1)) around.push_back(view.triangles[t]);
  local.vertices = vertices_of(around);
  std::optional<RimHinge> hinge;
  if (site.settings.bulge != 0) hinge.emplace(site, site.settings.bulge);
  for (const Index v : local.vertices) {
    const Vec3& place = site.mesh->positions[v];
    const Vec3 shown = hinge ? Vec3(place + faired_turn * (hinge->place(place) - place)) : place;
    local.patch.points.push_back((shown - local.centre) / local.size);
  }
  local.patch.known = local.vertices.size();
  const auto number = [&](Index vertex) { return local.number(vertex); };
  const auto known = [&](Index point) { return number(view.representative_of(site.vertices[point])); };
  for (const auto& [a, b, c] : around) local.patch.surroundings.push_back({number(a), number(b), number(c)});
  for (const auto& [a, b, c] : patch) local.patch.triangles.push_back({known(a), known(b), known(c)});
  return local;
}

/// CGAL's density that gives triangles of the rim's own size, or larger ones where these would be too many.
double density_for(const HoleSite& site, const Triangles& patch) {
  double area = 0;
  for (const auto& [a, b, c] : patch)
    area += triangle_area(site.polygon.points[a], site.polygon.points[b], site.polygon.points[c]);
  const double edge = mean_rim_edge(site);
  const double equilateral = std::sqrt(3.0) / 4 * edge * edge;
  const double predicted = equilateral > 0 ? area / equilateral : 0;
  const double share = std::min(1.0, static_cast<double>(site.most_triangles) / std::max(1.0, predicted));
  return usual_density * std::sqrt(share);
}

HolePatch in_mesh(const HoleSite& site, const LocalSite& local) {
  std::vector<std::pair<Index, Index>> rim;  // number in the local site, vertex of the mesh
  for (const Index v : site.vertices) rim.emplace_back(local.number(site.analysis->view.representative_of(v)), v);
  std::ranges::sort(rim);
  const auto known = static_cast<Index>(local.patch.known);
  const auto first_new = static_cast<Index>(site.mesh->vertex_count());
  HolePatch patch{site.holes, {}, local.patch.triangles};
  for (const Vec3& point : std::span(local.patch.points).subspan(known))
    patch.points.push_back(point * local.size + local.centre);
  for (Triangle& t : patch.triangles) {
    for (Index& corner : t)
      corner = corner >= known ? first_new + (corner - known)
                               : std::ranges::lower_bound(rim, std::pair(corner, Index{0}))->second;
  }
  return patch;
}

std::optional<HolePatch> refined_and_faired(const HoleSite& site, bool careful, Progress& progress) {
  const auto triangles = base_for_fairing(site, careful, progress);
  if (!triangles) return std::nullopt;
  LocalSite local = make_local_site(site, *triangles);
  if (!cgal_refine_and_fair(local.patch, density_for(site, *triangles), progress)) return std::nullopt;
  HolePatch patch = in_mesh(site, local);
  if (careful && !untangle(site, patch, progress)) return std::nullopt;
  return patch;
}

/// The greatest distance of places from the plane that is nearest to a hole's rim.
double height_of(const std::vector<Vec3>& places, const Hole& hole) {
  double height = 0;
  for (const Vec3& place : places) height = std::max(height, std::abs(hole.normal.dot(place - hole.centre)));
  return height;
}

/// Such a patch lies on the surface around its hole instead of over the hole: its height says nothing.
bool folds_back(const HoleSite& site, const HolePatch& patch) {
  for (const std::vector<RimFold>& rim : rim_folds(patch, *site.mesh, *site.analysis)) {
    if (std::ranges::any_of(rim, [](const RimFold& at) { return std::abs(at.angle) > doubtful_fold; })) return true;
  }
  return false;
}

}  // namespace

std::optional<Triangles> least_folding_triangulation(const HoleSite& site, Progress& progress) {
  const RimPolygon& rim = site.polygon;
  if (rim.loop_count() > 1 || rim.points.size() > most_dihedral_points) return std::nullopt;
  std::vector<Vec3> beyond;  // normals of the faces on the other side of the rim
  for (const Index corner : site.corners) beyond.push_back(triangle_normal(site, corner / 3).normalized());
  return dihedral_triangulation(rim, beyond, cgal_delaunay_triangles(rim.points), progress);
}

/// Other methods begin with this one's patch.
std::optional<HolePatch> smooth_patch(const HoleSite& site, bool careful, Progress& progress) {
  SiteMemory* memory = SiteMemory::of(site);
  if (memory == nullptr) return refined_and_faired(site, careful, progress);
  const auto known = memory->smooth.find(careful);
  if (known != memory->smooth.end()) return known->second;
  return memory->smooth[careful] = refined_and_faired(site, careful, progress);
}

std::optional<HolePatch> even_patch(const HoleSite& site, Progress& progress) {
  progress.check();
  auto triangles = plane_triangulation(site.polygon);
  if (!triangles) triangles = base_for_fairing(site, false, progress);
  if (!triangles) return std::nullopt;
  LocalSite local = make_local_site(site, *triangles);
  const double thinning = usual_density / density_for(site, *triangles);
  const LoosePatch start = local.patch;
  if (!refine_evenly(local.patch, even_coarseness * thinning)) return std::nullopt;
  if (local.patch.points.size() == start.points.size()) {
    local.patch = start;
    if (!refine_evenly(local.patch, thinning)) return std::nullopt;
  }
  if (!fair_evenly(local.patch)) return std::nullopt;
  return in_mesh(site, local);
}

bool rises_too_far(const HoleSite& site, const HolePatch& patch, Progress& progress) {
  if (site.bridge || site.settings.bulge != 0 || !site.settings.through.empty()) return false;
  const Hole& hole = widest_hole(site);
  const double rims = height_of(site.polygon.points, hole), height = std::max(rims, height_of(patch.points, hole));
  if (height <= std::max(allowed_height * hole.diameter, allowed_growth * rims)) return false;
  const auto smooth = smooth_patch(site, false, progress);
  if (smooth && folds_back(site, *smooth)) return false;
  return !smooth || height > allowed_growth * std::max(rims, height_of(smooth->points, hole));
}

}  // namespace croquis::hole_filling

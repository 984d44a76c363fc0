// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "algorithms/hole_filling/continuation/rim_hinge.h"
#include "algorithms/hole_filling/fairing/cgal_patch.h"
#include "algorithms/hole_filling/fairing/even_fairing.h"
#include "algorithms/hole_filling/fairing/even_refinement.h"
#include "algorithms/hole_filling/patching/avoiding_triangulation.h"
#include "algorithms/hole_filling/patching/patcher.h"
#include "algorithms/hole_filling/patching/site_memory.h"
#include "algorithms/hole_filling/patching/untangling.h"
#include "algorithms/hole_filling/triangulation/band_triangulation.h"
#include "algorithms/hole_filling/triangulation/dihedral_triangulation.h"
#include "algorithms/hole_filling/triangulation/plane_triangulation.h"
#include "algorithms/hole_filling/triangulation/triangle_cost.h"

namespace croquis::hole_filling {
namespace {

/// The Delaunay tetrahedra of points in special position have a triangle for each pair of them.
constexpr std::size_t most_dihedral_points = 1500;

const double usual_density = std::sqrt(2.0);  // CGAL's for triangles of the rim's own size

/// Edges of the even start, × those of the rim: methods that go on from it cut them on the surface.
constexpr double even_coarseness = 2;

/// Of fairing to continuity 2. The weights of the first are measured on the triangulation of the rim, which is nearly
/// flat: what is made so has the right tangents, but too much or too little curvature behind them.
constexpr int curved_rounds = 2;

/// Fairing with a ring or two of the surface follows its slope weakly: it gets more rings.
constexpr double faired_turn = 4;

std::optional<std::vector<Triangle>> by_area(const HoleSite& site, Progress& progress) {
  auto found = triangulate_rim(site.polygon, progress);
  if (!found) return std::nullopt;
  return std::move(found->triangles);
}

std::optional<std::vector<Triangle>> by_dihedral_angle(const HoleSite& site, Progress& progress) {
  if (site.polygon.loop_count() > 1 || site.polygon.points.size() > most_dihedral_points) return std::nullopt;
  const std::vector<Vec3> beyond = normals_beyond(site);
  return dihedral_triangulation(site.polygon, beyond, cgal_delaunay_triangles(site.polygon.points), progress);
}

/// Two rims that a band is to join, whatever lies between them.
std::optional<std::vector<Triangle>> by_band(const HoleSite& site, BandCost cost, Progress& progress) {
  const bool is_tunnel = site.analysis->holes[site.holes.front()].kind == HoleClass::Tunnel;
  if (!site.bridge && !is_tunnel) return std::nullopt;
  return band_triangulation(site.polygon, cost, progress);
}

/// The patch as seen in the rim's plane lies beside the surface, not over it: the surest start for long rims, which
/// area alone folds.
std::optional<std::vector<Triangle>> base_for_fairing(const HoleSite& site, Progress& progress) {
  auto triangles = by_band(site, BandCost::Area, progress);
  if (!triangles) triangles = by_dihedral_angle(site, progress);
  if (!triangles && site.polygon.points.size() > most_dihedral_points) triangles = plane_triangulation(site.polygon);
  if (!triangles) triangles = by_area(site, progress);
  return triangles;
}

std::optional<std::vector<Triangle>> careful_base(const HoleSite& site, Progress& progress) {
  auto triangles = by_band(site, BandCost::Length, progress);
  if (!triangles) triangles = avoiding_triangulation(site, progress);
  return triangles ? std::move(triangles) : base_for_fairing(site, progress);
}

/// Points of the polygon become vertices of the mesh.
HolePatch flat_patch(const HoleSite& site, std::vector<Triangle> triangles) {
  for (Triangle& t : triangles) {
    for (Index& corner : t) corner = site.vertices[corner];
  }
  return {site.holes, {}, std::move(triangles)};
}

class MinimalPatcher : public Patcher {
 public:
  const char* method() const override { return "minimal"; }

  std::optional<HolePatch> attempt(const HoleSite& site, Progress& progress) const override {
    auto triangles = by_area(site, progress);
    if (!triangles) return std::nullopt;
    return flat_patch(site, std::move(*triangles));
  }
};

class AvoidingPatcher : public Patcher {
 public:
  const char* method() const override { return "avoiding"; }

  std::optional<HolePatch> attempt(const HoleSite& site, Progress& progress) const override {
    auto triangles = avoiding_triangulation(site, progress);
    if (!triangles) return std::nullopt;
    return flat_patch(site, std::move(*triangles));
  }
};

class PlanePatcher : public Patcher {
 public:
  const char* method() const override { return "plane"; }

  std::optional<HolePatch> attempt(const HoleSite& site, Progress& progress) const override {
    progress.check();
    auto triangles = plane_triangulation(site.polygon);
    if (!triangles) return std::nullopt;
    return flat_patch(site, std::move(*triangles));
  }
};

class DihedralPatcher : public Patcher {
 public:
  const char* method() const override { return "dihedral"; }

  std::optional<HolePatch> attempt(const HoleSite& site, Progress& progress) const override {
    auto triangles = by_dihedral_angle(site, progress);
    if (!triangles) return std::nullopt;
    return flat_patch(site, std::move(*triangles));
  }
};

/// The site's neighbourhood as CGAL takes it: about the rim's centre and of unit size.
struct LocalSite {
  FairingInput input;
  std::vector<Index> vertices;  ///< of the view, sorted, per point
  Vec3 centre = Vec3::Zero();
  double size = 1;

  Index number(Index vertex) const {
    return static_cast<Index>(std::lower_bound(vertices.begin(), vertices.end(), vertex) - vertices.begin());
  }
};

LocalSite make_local_site(const HoleSite& site, const std::vector<Triangle>& patch, unsigned continuity) {
  const SurfaceView& view = site.analysis->view;
  LocalSite local;
  const Hole& widest =
      site.analysis->holes[*std::max_element(site.holes.begin(), site.holes.end(), [&](Index a, Index b) {
        return site.analysis->holes[a].diameter < site.analysis->holes[b].diameter;
      })];
  local.centre = widest.centre;
  local.size = widest.diameter;
  const std::vector<Index> around = surroundings(site, continuity == 2 ? 2 : 1);
  for (const Index t : around)
    local.vertices.insert(local.vertices.end(), view.triangles[t].begin(), view.triangles[t].end());
  std::sort(local.vertices.begin(), local.vertices.end());
  local.vertices.erase(std::unique(local.vertices.begin(), local.vertices.end()), local.vertices.end());
  std::optional<RimHinge> hinge;
  if (site.wish.bulge != 0) hinge.emplace(site, site.wish.bulge);
  for (const Index v : local.vertices) {
    const Vec3& place = site.mesh->positions[v];
    const Vec3 shown = hinge ? Vec3(place + faired_turn * (hinge->place(place) - place)) : place;
    local.input.points.push_back((shown - local.centre) / local.size);
  }
  const auto renumbered = [&](const Triangle& t) {
    return Triangle{local.number(t[0]), local.number(t[1]), local.number(t[2])};
  };
  for (const Index t : around) local.input.surroundings.push_back(renumbered(view.triangles[t]));
  for (const Triangle& t : patch) {
    local.input.patch.push_back(
        renumbered({view.representative_of(site.vertices[t[0]]), view.representative_of(site.vertices[t[1]]),
                    view.representative_of(site.vertices[t[2]])}));
  }
  local.input.continuity = continuity;
  return local;
}

/// CGAL's density that gives triangles of the rim's own size, or larger ones where these would be too many.
double density_for(const HoleSite& site, const std::vector<Triangle>& patch, std::size_t most_triangles) {
  double area = 0;
  for (const auto& [a, b, c] : patch)
    area += triangle_area(site.polygon.points[a], site.polygon.points[b], site.polygon.points[c]);
  const double edge = mean_rim_edge(site);
  const double equilateral = std::sqrt(3.0) / 4 * edge * edge;
  const double predicted = equilateral > 0 ? area / equilateral : 0;
  const double share = std::min(1.0, static_cast<double>(most_triangles) / std::max(1.0, predicted));
  return usual_density * std::sqrt(share);
}

HolePatch in_mesh(const HoleSite& site, const LocalSite& local, const FairingResult& faired) {
  std::vector<std::pair<Index, Index>> rim;  // number in the local site, vertex of the mesh
  for (const Index v : site.vertices) rim.emplace_back(local.number(site.analysis->view.representative_of(v)), v);
  std::sort(rim.begin(), rim.end());
  const auto known = static_cast<Index>(local.vertices.size());
  const auto first_new = static_cast<Index>(site.mesh->vertex_count());
  HolePatch patch{site.holes, {}, faired.patch};
  for (const Vec3& point : faired.new_points) patch.points.push_back(point * local.size + local.centre);
  for (Triangle& t : patch.triangles) {
    for (Index& corner : t)
      corner = corner >= known ? first_new + (corner - known)
                               : std::lower_bound(rim.begin(), rim.end(), std::pair(corner, Index{0}))->second;
  }
  return patch;
}

class FairedPatcher : public Patcher {
 public:
  FairedPatcher(unsigned continuity, std::size_t most_triangles, bool careful)
      : continuity_(continuity), most_triangles_(most_triangles), careful_(careful) {}

  const char* method() const override {
    if (careful_) return continuity_ == 2 ? "cgal-c2-careful" : "cgal-c1-careful";
    return continuity_ == 2 ? "cgal-c2" : "cgal-c1";
  }

  /// Other methods begin with this one's patch.
  std::optional<HolePatch> attempt(const HoleSite& site, Progress& progress) const override {
    return made_once(site, method(), [&] { return faired(site, progress); });
  }

 private:
  std::optional<HolePatch> faired(const HoleSite& site, Progress& progress) const {
    const auto triangles = careful_ ? careful_base(site, progress) : base_for_fairing(site, progress);
    if (!triangles) return std::nullopt;
    LocalSite local = make_local_site(site, *triangles, continuity_);
    local.input.density = density_for(site, *triangles, most_triangles_);
    if (continuity_ == 2) local.input.rounds = curved_rounds;
    const auto result = cgal_refine_and_fair(local.input, progress);
    if (!result) return std::nullopt;
    HolePatch patch = in_mesh(site, local, *result);
    if (careful_ && !untangle(site, patch, progress)) return std::nullopt;
    return patch;
  }

  unsigned continuity_;
  std::size_t most_triangles_;
  bool careful_;
};

class EvenPatcher : public Patcher {
 public:
  explicit EvenPatcher(std::size_t most_triangles) : most_triangles_(most_triangles) {}

  const char* method() const override { return "even"; }

  std::optional<HolePatch> attempt(const HoleSite& site, Progress& progress) const override {
    progress.check();
    auto triangles = plane_triangulation(site.polygon);
    if (!triangles) triangles = base_for_fairing(site, progress);
    if (!triangles) return std::nullopt;
    const LocalSite local = make_local_site(site, *triangles, 1);
    const double thinning = usual_density / density_for(site, *triangles, most_triangles_);
    auto refined = refine_evenly(local.input, even_coarseness * thinning);
    if (refined && refined->new_points.empty()) refined = refine_evenly(local.input, thinning);
    if (!refined || !fair_evenly(local.input, *refined)) return std::nullopt;
    return in_mesh(site, local, *refined);
  }

 private:
  std::size_t most_triangles_;
};

}  // namespace

std::shared_ptr<const Patcher> minimal_patcher() { return std::make_shared<MinimalPatcher>(); }
std::shared_ptr<const Patcher> avoiding_patcher() { return std::make_shared<AvoidingPatcher>(); }
std::shared_ptr<const Patcher> plane_patcher() { return std::make_shared<PlanePatcher>(); }
std::shared_ptr<const Patcher> dihedral_patcher() { return std::make_shared<DihedralPatcher>(); }
std::shared_ptr<const Patcher> faired_patcher(unsigned continuity, std::size_t most_triangles, bool careful) {
  return std::make_shared<FairedPatcher>(continuity, most_triangles, careful);
}
std::shared_ptr<const Patcher> evenly_faired_patcher(std::size_t most_triangles) {
  return std::make_shared<EvenPatcher>(most_triangles);
}

}  // namespace croquis::hole_filling

// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/remeshing/remesh_field.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

#include "croquis/hole_filling/hole_site.h"
#include "croquis/hole_filling/surface_reach.h"
#include "croquis/implicit/offset_points.h"

namespace croquis::remeshing {
namespace {

using namespace hole_filling;

constexpr std::size_t most_hole_centres = 400;       // of a hole's domain
constexpr std::size_t most_hole_candidates = 20000;  // thinning looks at all of them
constexpr double least_rim_reach = 4;                // × edge of the rim
constexpr double hole_rim_spacing = 0.7;             // × edge
constexpr double hole_spacing_slope = 0.25;          // per distance from the rim
constexpr double hole_spacing_growth = 1.15;

/// Nearest first, each unless a taken one is nearer than the spacing there; nothing when they are too many.
std::optional<std::vector<Index>> spread(std::span<const ReachedVertex> reached, const std::vector<Vec3>& positions,
                                         double spacing, double slope) {
  std::vector<Index> taken;
  for (const ReachedVertex& r : reached) {
    const double least = std::max(spacing, slope * r.distance);
    const bool is_free = std::all_of(taken.begin(), taken.end(), [&](Index v) {
      return (positions[r.vertex] - positions[v]).squaredNorm() >= least * least;
    });
    if (!is_free) continue;
    if (taken.size() == most_hole_centres) return std::nullopt;
    taken.push_back(r.vertex);
  }
  return taken;
}

class HoleDomain {
 public:
  HoleDomain(const PolyMesh& mesh, const HoleAnalysis& analysis, std::span<const Index> group)
      : mesh_(mesh),
        site_(make_site(mesh, analysis, group, {})),
        edge_(mean_rim_edge(site_)),
        size_(widest_diameter(site_)) {}

  std::vector<Index> centres(double reach) const {
    std::vector<ReachedVertex> reached = reach_from_rims(site_, std::max(least_rim_reach * edge_, reach * size_));
    const std::size_t stride = reached.size() / most_hole_candidates + 1;
    std::vector<ReachedVertex> sampled;
    for (std::size_t i = 0; i < reached.size(); i += stride) sampled.push_back(reached[i]);
    for (double scale = 1;; scale *= hole_spacing_growth) {
      auto taken =
          spread(sampled, mesh_.positions, scale * hole_rim_spacing * edge_, std::min(scale, 2.0) * hole_spacing_slope);
      if (taken) return std::move(*taken);
    }
  }

  implicit::Box box(double growth) const {
    implicit::Box box = implicit::bounds(site_.polygon.points);
    box.low.array() -= growth * size_;
    box.high.array() += growth * size_;
    return box;
  }

  double edge() const { return edge_; }

 private:
  const PolyMesh& mesh_;
  HoleSite site_;
  double edge_ = 0, size_ = 0;
};

/// Places that requests lead the surface through, for the holes of a group.
std::vector<Vec3> through(const std::vector<HoleRequest>& requests, std::span<const Index> group) {
  std::vector<Vec3> places;
  for (const HoleRequest& request : requests) {
    const bool applies = std::any_of(request.holes.begin(), request.holes.end(), [&](Index hole) {
      return std::find(group.begin(), group.end(), hole) != group.end();
    });
    if (applies) places.insert(places.end(), request.through.begin(), request.through.end());
  }
  return places;
}

}  // namespace

implicit::DomainOptions domain_options(const RemeshOptions& options, double edge) {
  implicit::DomainOptions domains;
  const bool is_paper = options.fill.preset == Preset::Paper;
  domains.leaf_points = options.leaf_points;
  domains.min_points = options.min_points;
  domains.max_points = options.max_points;
  domains.overlap = options.overlap;
  domains.equal_boxes = is_paper;
  domains.offset = 0.5 * edge;
  domains.offset_both_sides = !is_paper;
  domains.fit.kernel = options.fill.implicit.kernel;
  domains.fit.value_smoothing = options.fill.implicit.value_smoothing;
  domains.fit.gradient_smoothing = options.fill.implicit.gradient_smoothing;
  domains.threads = options.fill.threads;
  return domains;
}

std::vector<implicit::ExtraDomain> hole_domains(const PolyMesh& mesh, const HoleAnalysis& analysis,
                                                const RemeshPiece& piece, const std::vector<Vec3>& normals,
                                                const RemeshOptions& options, double growth, const Progress& progress) {
  std::vector<implicit::ExtraDomain> domains;
  if (options.fill.preset == Preset::Paper) return domains;
  for (const std::vector<Index>& group : piece.groups) {
    progress.check();
    const HoleDomain hole(mesh, analysis, group);
    implicit::ExtraDomain domain;
    domain.box = hole.box(growth);
    for (const Index v : hole.centres(options.fill.implicit.reach)) {
      domain.constraints.positions.push_back(mesh.positions[v]);
      domain.constraints.gradients.push_back(normals[v]);
    }
    for (const Vec3& place : through(options.fill.requests, group)) {
      domain.constraints.positions.push_back(place);
      domain.constraints.gradients.emplace_back(Vec3::Zero());
    }
    if (!implicit::takes_gradients(options.fill.implicit.kernel))
      domain.constraints = implicit::with_offset_points(domain.constraints.positions, domain.constraints.gradients,
                                                        {0.5 * hole.edge(), 6, true})
                               .constraints;
    domains.push_back(std::move(domain));
  }
  return domains;
}

}  // namespace croquis::remeshing

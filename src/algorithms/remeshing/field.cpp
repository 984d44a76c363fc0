// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/remeshing/field.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>

#include <Eigen/Geometry>

#include "croquis/base/parallel.h"
#include "croquis/hole_filling/hole_site.h"
#include "croquis/implicit/offset_points.h"

namespace croquis::remeshing {
namespace {

using namespace hole_filling;

constexpr double quadric_reach = 4;                  // × mean edge of the rim, around it
constexpr double smooth_dihedral = 0.5;              // cosine: beyond, the normal of an edge isn't known
constexpr std::size_t most_hole_centres = 400;       // of a hole's domain
constexpr std::size_t most_hole_candidates = 20000;  // thinning looks at all of them
constexpr double least_rim_reach = 4;                // × edge of the rim
constexpr double hole_rim_spacing = 0.7;             // × edge
constexpr double hole_spacing_slope = 0.25;          // per distance from the rim
constexpr double hole_spacing_growth = 1.15;
constexpr std::uint8_t unsound = SurfaceView::NoArea | SurfaceView::Sliver;

Vec3 sound_normal(const PolyMesh& mesh, const SurfaceView& view, std::size_t triangle) {
  if ((view.flags[triangle] & unsound) != 0) return Vec3::Zero();
  const auto& [a, b, c] = view.triangles[triangle];
  return unit_or_zero((mesh.positions[b] - mesh.positions[a]).cross(mesh.positions[c] - mesh.positions[a]));
}

Vec3 normal_at(const PolyMesh& mesh, const SurfaceView& view, const TriangleFans& fans, std::size_t vertex) {
  Vec3 sum = Vec3::Zero();
  for (const Index corner : fans.at(vertex)) {
    if ((view.flags[corner / 3] & unsound) != 0) continue;
    const Vec3 out = mesh.positions[fans.next(corner)] - mesh.positions[vertex];
    const Vec3 in = mesh.positions[fans.previous(corner)] - mesh.positions[vertex];
    const Vec3 across = out.cross(in);
    const double length = across.norm();
    if (length > 0) sum += std::atan2(length, out.dot(in)) / length * across;
  }
  return unit_or_zero(sum);
}

/// The vertices on the rims of a group of holes, with their normals.
std::vector<ReachedVertex> rim_normals(const PolyMesh& mesh, const HoleAnalysis& analysis,
                                       const std::vector<Index>& group) {
  const HoleSite site = make_site(mesh, analysis, group, {});
  std::vector<ReachedVertex> reached = reach_from_rims(site, quadric_reach * mean_rim_edge(site));
  fit_rim_normals(reached, mesh.positions, tree_of(reached, mesh.positions));
  return {reached.begin(), std::ranges::find_if(reached, [](const ReachedVertex& r) { return r.distance != 0; })};
}

/// Of an edge between two triangles the mean, where they are smooth there.
Vec3 edge_normal(const PolyMesh& mesh, const SurfaceView& view, Index corner) {
  const Vec3 normal = sound_normal(mesh, view, corner / 3);
  if (!view.has_opposite(corner)) return normal;
  const Vec3 beyond = sound_normal(mesh, view, view.opposite[corner] / 3);
  return beyond.dot(normal) > smooth_dihedral ? unit_or_zero(normal + beyond) : Vec3(Vec3::Zero());
}

/// Puts points on the long edges of a triangle, once per edge, and in rows along the longest one inside.
void add_samples(const PolyMesh& mesh, const SurfaceView& view, Index triangle, double edge, RemeshPoints& points) {
  const double spacing = sample_spacing * edge, longest_allowed = longest_edge * edge;
  const auto add_row = [&](const Vec3& from, const Vec3& along, double length, const Vec3& normal) {
    const auto steps = static_cast<int>(std::ceil(length / spacing));
    for (int s = 1; s < steps; ++s) {
      points.positions.emplace_back(from + static_cast<double>(s) / steps * along);
      points.normals.push_back(normal);
      points.triangles.push_back(triangle);
    }
  };
  const auto place = [&](std::size_t i) -> const Vec3& { return mesh.positions[view.triangles[triangle][i % 3]]; };
  std::size_t longest = 0;
  std::array<double, 3> lengths;
  for (std::size_t i = 0; i < 3; ++i) {
    lengths[i] = (place(i + 1) - place(i)).norm();
    if (lengths[i] > lengths[longest]) longest = i;
    const Index corner = 3 * triangle + static_cast<Index>(i);
    const bool is_done = view.has_opposite(corner) && view.opposite[corner] < corner;
    if (lengths[i] > longest_allowed && !is_done)
      add_row(place(i), place(i + 1) - place(i), lengths[i], edge_normal(mesh, view, corner));
  }
  const double length = lengths[longest];
  if (length <= longest_allowed) return;
  const Vec3& from = place(longest);
  const Vec3 along = place(longest + 1) - from, up = place(longest + 2) - from;
  const Vec3 normal = sound_normal(mesh, view, triangle);
  const auto rows = static_cast<int>(std::ceil(along.cross(up).norm() / length / spacing));
  for (int r = 1; r < rows; ++r) {
    const double t = static_cast<double>(r) / rows;
    add_row(from + t * up, (1 - t) * along, (1 - t) * length, normal);
  }
}

/// Nearest first, each unless a taken one is nearer than the spacing there; nothing when they are too many.
std::optional<std::vector<Index>> spread(std::span<const ReachedVertex> reached, const std::vector<Vec3>& positions,
                                         double spacing, double slope) {
  std::vector<Index> taken;
  for (const ReachedVertex& r : reached) {
    const double least = std::max(spacing, slope * r.distance);
    const bool is_free = std::ranges::all_of(
        taken, [&](Index v) { return (positions[r.vertex] - positions[v]).squaredNorm() >= least * least; });
    if (!is_free) continue;
    if (taken.size() == most_hole_centres) return std::nullopt;
    taken.push_back(r.vertex);
  }
  return taken;
}

/// The vertices around a hole that its domain goes by.
std::vector<Index> hole_centres(const HoleSite& site, double reach) {
  const double edge = mean_rim_edge(site);
  const std::vector<ReachedVertex> reached =
      reach_from_rims(site, std::max(least_rim_reach * edge, reach * widest_diameter(site)));
  const std::size_t stride = reached.size() / most_hole_candidates + 1;
  std::vector<ReachedVertex> sampled;
  for (std::size_t i = 0; i < reached.size(); i += stride) sampled.push_back(reached[i]);
  for (double scale = 1;; scale *= hole_spacing_growth) {
    auto taken = spread(sampled, site.mesh->positions, scale * hole_rim_spacing * edge,
                        std::min(scale, 2.0) * hole_spacing_slope);
    if (taken) return std::move(*taken);
  }
}

implicit::ExtraDomain hole_domain(const HoleSite& site, const std::vector<Vec3>& normals, const RemeshOptions& options,
                                  double growth) {
  implicit::ExtraDomain domain;
  domain.box = implicit::bounds(site.polygon.points);
  domain.box.low.array() -= growth * widest_diameter(site);
  domain.box.high.array() += growth * widest_diameter(site);
  implicit::Constraints& constraints = domain.constraints;
  for (const Index v : hole_centres(site, options.fill.implicit.reach)) {
    constraints.positions.push_back(site.mesh->positions[v]);
    constraints.gradients.push_back(normals[v]);
  }
  for (const HoleRequest& request : options.fill.requests) {
    if (std::ranges::find_first_of(request.holes, site.holes) == request.holes.end()) continue;
    constraints.positions.insert(constraints.positions.end(), request.through.begin(), request.through.end());
    constraints.gradients.resize(constraints.positions.size(), Vec3::Zero());
  }
  if (!implicit::takes_gradients(options.fill.implicit.kernel))
    constraints =
        implicit::with_offset_points(constraints.positions, constraints.gradients, {0.5 * mean_rim_edge(site), 6, true})
            .constraints;
  return domain;
}

}  // namespace

double typical_edge(const PolyMesh& mesh, const SurfaceView& view) {
  double sum = 0;
  for (const auto& t : view.triangles) {
    for (std::size_t i = 0; i < 3; ++i) sum += (mesh.positions[t[(i + 1) % 3]] - mesh.positions[t[i]]).norm();
  }
  return std::min(sum / (3 * static_cast<double>(view.triangles.size())), longest_typical_edge * view.diagonal);
}

std::vector<Vec3> vertex_normals(const PolyMesh& mesh, const HoleAnalysis& analysis, const TriangleFans& fans,
                                 const RemeshPieces& pieces, int threads, Progress& progress) {
  std::vector<Vec3> normals(mesh.vertex_count());
  for_each_part(normals.size(), vertices_per_part, threads, progress, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) normals[v] = normal_at(mesh, analysis.view, fans, v);
  });
  std::vector<const std::vector<Index>*> groups;
  for (const RemeshPiece& piece : pieces.pieces)
    for (const std::vector<Index>& group : piece.groups) groups.push_back(&group);
  std::vector<std::vector<ReachedVertex>> rims(groups.size());
  for_each_part(groups.size(), 1, threads, progress, [&](std::size_t begin, std::size_t end) {
    for (std::size_t g = begin; g < end; ++g) rims[g] = rim_normals(mesh, analysis, *groups[g]);
  });
  for (const std::vector<ReachedVertex>& rim : rims)
    for (const ReachedVertex& vertex : rim) normals[vertex.vertex] = vertex.normal;
  return normals;
}

RemeshPoints points_of(const PolyMesh& mesh, const HoleAnalysis& analysis, const RemeshPiece& piece,
                       const std::vector<Vec3>& normals, double edge) {
  RemeshPoints points;
  points.positions.reserve(piece.vertices.size());
  points.normals.reserve(piece.vertices.size());
  for (const Index v : piece.vertices) {
    points.positions.push_back(mesh.positions[v]);
    points.normals.push_back(normals[v]);
  }
  for (const Index t : piece.triangles) add_samples(mesh, analysis.view, t, edge, points);
  return points;
}

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
  domains.borrow = true;
  domains.lazy = true;
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
    domains.push_back(hole_domain(make_site(mesh, analysis, group, {}), normals, options, growth));
  }
  return domains;
}

}  // namespace croquis::remeshing

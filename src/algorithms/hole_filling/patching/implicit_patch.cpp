// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numeric>
#include <utility>

#include <Eigen/Geometry>

#include "algorithms/hole_filling/analysis/sorted_lists.h"
#include "algorithms/hole_filling/continuation/rim_field.h"
#include "algorithms/hole_filling/fairing/fairing.h"
#include "algorithms/hole_filling/patching/near_scene.h"
#include "algorithms/hole_filling/patching/patch_methods.h"
#include "croquis/implicit/surface_improvement.h"

namespace croquis::hole_filling {
namespace {

constexpr double careful_stiffness = 3;  // the smoothing's factor
constexpr int usual_rounds = 3;
constexpr int draft_rounds = 2;          // of a patch that is only to be pulled
constexpr int smoothings_per_round = 2;  // per round

/// Newton's steps square what is left: one shorter than this ends within 1e-3 of an edge of the surface, and the next
/// smoothing moves farther than that anyway. × cell
constexpr double draft_accuracy = 0.03;
constexpr double final_accuracy = 1e-4;

/// Steps are damped where the field is flatter than 0.2, and then take too many to get there. What is near the surface
/// already after the draft comes to rest on it by Newton's own, down to this gradient.
constexpr double least_settling_gradient = 0.01;
constexpr int most_settling_steps = 6;

/// A patch that moves farther from its rims than this is given up: the surface around doesn't close. × size
constexpr double longest_way = 1.5;

constexpr std::size_t most_guides = 80;
constexpr int size_rounds = 10;

/// The zero set has a vertex this near to any place that it goes through, or it doesn't go there. × edge
constexpr double farthest_pin = 1.5;

Index given_count(const HoleSite& site) { return static_cast<Index>(site.mesh->vertex_count()); }

/// Vertices of the mesh that a patch uses, ascending: the first points of the loose patch.
std::vector<Index> rim_of(const HoleSite& site, const HolePatch& patch) {
  std::vector<Index> rim = vertices_of(patch.triangles);
  rim.erase(std::ranges::lower_bound(rim, given_count(site)), rim.end());
  return rim;
}

/// Continues the rim's sizes inwards, ring by ring; what lies deeper than there are rounds has their mean.
void spread_sizes(LoosePatch& loose) {
  const double mean = std::accumulate(loose.sizes.begin(), loose.sizes.end(), 0.0) / static_cast<double>(loose.known);
  loose.sizes.resize(loose.points.size(), mean);
  for (int round = 0; round < size_rounds; ++round) {
    std::vector<double> sums(loose.points.size(), 0), counts(loose.points.size(), 0);
    for (const auto& [a, b, c] : loose.triangles) {
      sums[a] += loose.sizes[b] + loose.sizes[c];
      sums[b] += loose.sizes[c] + loose.sizes[a];
      sums[c] += loose.sizes[a] + loose.sizes[b];
      for (const Index v : {a, b, c}) counts[v] += 2;
    }
    for (std::size_t v = loose.known; v < loose.points.size(); ++v) {
      if (counts[v] > 0) loose.sizes[v] = sums[v] / counts[v];
    }
  }
}

/// The patch as the editing takes it.
LoosePatch loosened(const HoleSite& site, const std::vector<Index>& rim, const HolePatch& patch) {
  const auto number = [&](Index v) {
    return v < given_count(site) ? place_in(rim, v) : v - given_count(site) + static_cast<Index>(rim.size());
  };
  LoosePatch loose;
  loose.known = rim.size();
  for (const Index v : rim) loose.points.push_back(site.mesh->positions[v]);
  loose.points.insert(loose.points.end(), patch.points.begin(), patch.points.end());
  for (const auto& [a, b, c] : patch.triangles) loose.triangles.push_back({number(a), number(b), number(c)});
  std::vector<std::array<Index, 2>> rim_edges;
  for (Index i = 0; i < site.vertices.size(); ++i)
    rim_edges.push_back({number(site.vertices[i]), number(site.vertices[site.polygon.next(i)])});
  loose.sizes = mean_lengths({loose.points.data(), loose.known}, rim_edges);
  spread_sizes(loose);
  return loose;
}

HolePatch fastened(const HoleSite& site, const std::vector<Index>& rim, const LoosePatch& loose) {
  const auto rim_count = static_cast<Index>(rim.size());
  HolePatch patch{site.holes, {loose.points.begin() + rim_count, loose.points.end()}, loose.triangles};
  for (auto& t : patch.triangles) {
    for (Index& v : t) v = v < rim_count ? rim[v] : v - rim_count + given_count(site);
  }
  return patch;
}

/// Asks for larger triangles where there would be more than `most`.
void limit_count(LoosePatch& loose, std::size_t most) {
  double predicted = 0;
  for (const auto& [a, b, c] : loose.triangles) {
    const double size = (loose.sizes[a] + loose.sizes[b] + loose.sizes[c]) / 3;
    predicted += triangle_area(loose.points[a], loose.points[b], loose.points[c]) / (std::sqrt(3.0) / 4 * size * size);
  }
  const double growth = std::sqrt(std::max(1.0, predicted / static_cast<double>(most)));
  for (std::size_t v = loose.known; v < loose.sizes.size(); ++v) loose.sizes[v] *= growth;
}

/// Of the equilateral triangle of mean area.
double mean_edge(const LoosePatch& loose) {
  double area = 0;
  for (const auto& [a, b, c] : loose.triangles)
    area += triangle_area(loose.points[a], loose.points[b], loose.points[c]);
  return std::sqrt(4 / std::sqrt(3.0) * area / static_cast<double>(loose.triangles.size()));
}

/// Where the place to begin from decides whether a patch comes to rest.
bool is_any_wide(const HoleSite& site) {
  return std::ranges::any_of(site.holes, [&](Index id) { return is_wide(*site.analysis, id); });
}

/// The new vertex nearest to each of the places, each another one; fewer when there aren't so many near enough.
std::vector<std::size_t> nearest_free(const LoosePatch& loose, std::span<const Vec3> places) {
  const auto free = std::span(loose.points).subspan(loose.known);
  std::vector<std::size_t> pins;
  for (const std::size_t i : nearest_points(free, places.first(std::min(places.size(), free.size())))) {
    const std::size_t pin = loose.known + i;
    if ((loose.points[pin] - places[pins.size()]).norm() > farthest_pin * loose.sizes[pin]) break;
    pins.push_back(pin);
  }
  return pins;
}

/// Vertices near the places that the patch goes through come to lie there.
/// @return marks of what stays: they and the rims
std::vector<std::uint8_t> pinned(LoosePatch& loose, const std::vector<Vec3>& places) {
  std::vector<std::uint8_t> fixed(loose.points.size(), 0);
  std::fill_n(fixed.begin(), loose.known, std::uint8_t{1});
  const std::vector<std::size_t> pins = nearest_free(loose, places);
  for (std::size_t i = 0; i < pins.size(); ++i) {
    loose.points[pins[i]] = places[i];
    fixed[pins[i]] = 1;
  }
  return fixed;
}

bool has_run_away(const RimField& surface, const LoosePatch& loose, const std::vector<Vec3>& through) {
  Box reach = box_of(std::span(loose.points).first(loose.known), std::identity());
  for (const Vec3& place : through) reach.extend(place);
  const Vec3 way = Vec3::Constant(longest_way * surface.size);
  const Box allowed(reach.min() - way, reach.max() + way);
  return !std::ranges::all_of(loose.points, [&](const Vec3& p) { return allowed.contains(p); });
}

/// @return how many points are still not on the surface
std::size_t settle(const RimField& surface, const std::vector<std::uint8_t>& fixed,
                   implicit::ProjectionOptions projection, LoosePatch& loose) {
  projection.least_gradient = least_settling_gradient;
  projection.iterations = most_settling_steps;
  return implicit::project(loose.points, fixed, surface.field(), projection).not_converged;
}

/// @param projected after so many smoothings, a divisor of those of a round; in the last round after each
bool move_onto(const HoleSite& site, const RimField& surface, LoosePatch& loose, int rounds, int projected,
               Progress& progress) {
  const std::vector<Vec3>& through = site.settings.through;
  implicit::ProjectionOptions projection;
  projection.cell = std::max(surface.edge, mean_edge(loose));
  projection.iterations = 20 + static_cast<int>(std::min(200.0, 2 * surface.size / projection.cell));
  projection.accuracy = draft_accuracy;
  projection.threads = 1;
  for (int round = 0; round < rounds; ++round) {
    progress.check();
    const bool is_last = round + 1 == rounds;
    const std::vector<std::uint8_t> fixed = pinned(loose, through);
    if (round == 0) implicit::project(loose.points, fixed, surface.field(), projection);
    std::size_t not_converged = 0;
    for (int i = 0; i < smoothings_per_round; ++i) {
      relax(loose, fixed);
      if (!is_last && (i + 1) % projected != 0) continue;
      if (is_last && i + 1 == smoothings_per_round) projection.accuracy = final_accuracy;
      not_converged = implicit::project(loose.points, fixed, surface.field(), projection).not_converged;
    }
    if (is_last && not_converged > 0) not_converged = settle(surface, fixed, projection, loose);
    if (has_run_away(surface, loose, through) || (is_last && not_converged > 0)) return false;
    if (is_last) break;
    limit_count(loose, site.most_triangles);
    if (!bring_to_size(loose)) return false;
  }
  return true;
}

/// Smoothing keeps the field a little off the rim: the patch follows by a harmonic displacement.
void meet_rim(const HoleSite& site, const RimField& surface, HolePatch& patch) {
  const HarmonicValues harmonic(patch, given_count(site));
  std::vector<Vec3> feet;
  for (const Index v : harmonic.rim_vertices()) feet.push_back(site.mesh->positions[v]);
  implicit::ProjectionOptions projection;
  projection.cell = surface.edge;
  projection.accuracy = final_accuracy;
  projection.threads = 1;
  implicit::project(feet, {}, surface.field(), projection);
  Eigen::MatrixXd offsets(std::ssize(feet), 3);
  for (std::size_t i = 0; i < feet.size(); ++i)
    offsets.row(static_cast<Eigen::Index>(i)) =
        (site.mesh->positions[harmonic.rim_vertices()[i]] - feet[i]).transpose();
  const Eigen::MatrixXd moves = harmonic.continued(offsets);
  for (std::size_t i = 0; i < patch.points.size(); ++i)
    patch.points[i] += moves.row(static_cast<Eigen::Index>(i)).transpose();
}

/// Places of a patch with their normals, no two nearer than `spacing`, which grows until they are `most_guides` at
/// most.
std::vector<PassingPoint> guides_on(const PolyMesh& mesh, const HolePatch& patch, double spacing) {
  const auto given = static_cast<Index>(mesh.vertex_count());
  const auto at = [&](Index v) -> const Vec3& { return v < given ? mesh.positions[v] : patch.points[v - given]; };
  std::vector<Vec3> normals(patch.points.size(), Vec3::Zero());
  for (const auto& [a, b, c] : patch.triangles) {
    const Vec3 normal = (at(b) - at(a)).cross(at(c) - at(a));
    for (const Index v : {a, b, c}) {
      if (v >= given) normals[v - given] += normal;
    }
  }
  std::vector<PassingPoint> all;
  for (std::size_t v = 0; v < patch.points.size(); ++v) {
    if (normals[v].norm() > 0) all.push_back({patch.points[v], normals[v].normalized()});
  }
  return spread_out(all, spacing, most_guides);
}

/// @param guides further places of the surface
std::optional<HolePatch> continued_from(const HoleSite& site, const HolePatch& start, std::vector<PassingPoint> guides,
                                        bool careful, int rounds, Progress& progress) {
  progress.check();
  const auto surface = fitted_once(site, {careful ? careful_stiffness : 1, careful, std::move(guides)});
  if (!surface) return std::nullopt;
  auto patch = lay_onto(site, *surface, start, rounds, progress);
  if (patch && careful) untangle(site, *patch, progress);
  return patch;
}

std::optional<HolePatch> freely_continued(const HoleSite& site, bool careful, int rounds, Progress& progress) {
  const bool is_quick = !careful && !is_any_wide(site);
  const auto start = is_quick ? even_patch(site, progress) : smooth_patch(site, careful, progress);
  if (!start || start->points.empty()) return start;
  return continued_from(site, *start, {}, careful, rounds, progress);
}

}  // namespace

std::optional<HolePatch> lay_onto(const HoleSite& site, const RimField& surface, const HolePatch& start, int rounds,
                                  Progress& progress) {
  const std::vector<Vec3>& through = site.settings.through;
  const std::vector<Index> rim = rim_of(site, start);
  LoosePatch loose = loosened(site, rim, start);
  // From creases, and over wide holes, smoothing twice may lead too far away.
  const int projected = rounds > usual_rounds || is_any_wide(site) ? 1 : smoothings_per_round;
  if (!move_onto(site, surface, loose, rounds, projected, progress)) return std::nullopt;
  const std::vector<std::size_t> pins = nearest_free(loose, through);
  if (pins.size() < through.size()) return std::nullopt;
  HolePatch patch = fastened(site, rim, loose);
  meet_rim(site, surface, patch);
  for (std::size_t i = 0; i < pins.size(); ++i) patch.points[pins[i] - loose.known] = through[i];
  patch.domain_points = surface.domain_points;
  return patch;
}

/// A patch that is to go through places comes first as it is, and is pulled there; what it looks like then guides the
/// fit. The places alone would be met by a spike.
std::optional<HolePatch> implicit_patch(const HoleSite& site, bool careful, Progress& progress) {
  const std::vector<Vec3>& through = site.settings.through;
  const int rounds = careful ? most_rounds : usual_rounds;
  if (through.empty()) return freely_continued(site, careful, rounds, progress);
  HoleSite plain = site;
  plain.settings.through.clear();
  plain.memory = nullptr;
  auto start = freely_continued(plain, careful, draft_rounds, progress);
  if (!start) start = smooth_patch(plain, careful, progress);
  if (!start || !displace_through(*site.mesh, *start, through)) return std::nullopt;
  auto guides = guides_on(*site.mesh, *start, 2 * mean_rim_edge(site));
  return continued_from(site, *start, std::move(guides), careful, rounds, progress);
}

}  // namespace croquis::hole_filling

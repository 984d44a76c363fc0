// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/hole_filling/cross_validation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "algorithms/hole_filling/surface_reach.h"
#include "algorithms/hole_filling/triangle_distance.h"
#include "croquis/base/error.h"

namespace croquis::hole_filling {
namespace {

constexpr std::size_t most_probes = 6;
constexpr std::size_t most_vertices = 20000;  // of the surface around that is looked at
constexpr std::size_t most_hidden = 300;      // places compared per probe
constexpr double reach = 1.2;                 // × diameter of the hole
constexpr double probe_radius = 0.25;         // × diameter of the hole
constexpr double least_radius = 2.5;          // × edge: a disc of some twenty triangles
constexpr double margin = 2;                  // × edge, that stay between the rim and a disc

/// The known surface around a site, by itself.
struct Surroundings {
  PolyMesh mesh;
  std::vector<double> distance;  ///< per vertex, to the rims
  double edge = 0, size = 0;
};

Surroundings surroundings_of(const HoleSite& site) {
  Surroundings around;
  double perimeter = 0;
  for (const Index id : site.holes) {
    perimeter += site.analysis->holes[id].perimeter;
    around.size = std::max(around.size, site.analysis->holes[id].diameter);
  }
  around.edge = perimeter / static_cast<double>(site.vertices.size());
  auto reached = reach_from_rims(site, std::max(reach * around.size, 4 * least_radius * around.edge));
  if (reached.size() > most_vertices) reached.resize(most_vertices);
  std::vector<std::pair<Index, Index>> number;  // vertex of the view, of the surroundings
  for (const ReachedVertex& r : reached) {
    number.emplace_back(r.vertex, static_cast<Index>(number.size()));
    around.mesh.positions.push_back(site.mesh->positions[r.vertex]);
    around.distance.push_back(r.distance);
  }
  std::sort(number.begin(), number.end());
  const auto numbered = [&](Index v) -> std::optional<Index> {
    const auto place = std::lower_bound(number.begin(), number.end(), std::pair(v, Index{0}));
    if (place == number.end() || place->first != v) return std::nullopt;
    return place->second;
  };
  for (const auto& t : site.analysis->view.triangles) {
    const auto a = numbered(t[0]), b = numbered(t[1]), c = numbered(t[2]);
    if (a && b && c) around.mesh.add_triangle(*a, *b, *c);
  }
  return around;
}

/// Vertices beside the rims that are far from each other.
std::vector<Index> spread_centres(const Surroundings& around, double radius) {
  std::vector<Index> candidates;
  for (Index v = 0; v < around.distance.size(); ++v) {
    const double beyond = around.distance[v] - radius - margin * around.edge;
    if (beyond >= 0 && beyond <= radius) candidates.push_back(v);
  }
  std::vector<Index> centres;
  std::vector<double> nearest(candidates.size(), std::numeric_limits<double>::infinity());
  while (centres.size() < most_probes && !candidates.empty()) {
    const auto next = std::max_element(nearest.begin(), nearest.end()) - nearest.begin();
    if (!(nearest[static_cast<std::size_t>(next)] > radius)) break;
    centres.push_back(candidates[static_cast<std::size_t>(next)]);
    for (std::size_t i = 0; i < candidates.size(); ++i) {
      const double distance = (around.mesh.positions[candidates[i]] - around.mesh.positions[centres.back()]).norm();
      nearest[i] = std::min(nearest[i], distance);
    }
  }
  return centres;
}

bool lies_in(const PolyMesh& mesh, std::size_t face, const Vec3& centre, double radius) {
  const auto corners = mesh.face(face);
  return std::all_of(corners.begin(), corners.end(),
                     [&](Index v) { return (mesh.positions[v] - centre).norm() < radius; });
}

Vec3 middle_of(const PolyMesh& mesh, std::size_t face) {
  const auto c = mesh.face(face);
  return (mesh.positions[c[0]] + mesh.positions[c[1]] + mesh.positions[c[2]]) / 3;
}

}  // namespace

CrossValidation::CrossValidation(const HoleSite& site, Progress& progress) : wish_(site.wish) {
  wish_.bulge = 0;
  wish_.through.clear();
  const Surroundings around = surroundings_of(site);
  const double radius = std::max(probe_radius * around.size, least_radius * around.edge);
  for (const Index centre : spread_centres(around, radius)) {
    progress.check();
    const Vec3& place = around.mesh.positions[centre];
    Probe probe;
    probe.mesh.positions = around.mesh.positions;
    std::vector<char> is_beside(around.mesh.vertex_count(), 0);
    for (std::size_t f = 0; f < around.mesh.face_count(); ++f) {
      const auto corners = around.mesh.face(f);
      if (!lies_in(around.mesh, f, place, radius)) {
        probe.mesh.add_triangle(corners[0], corners[1], corners[2]);
        continue;
      }
      probe.hidden.push_back(middle_of(around.mesh, f));
      for (const Index v : corners) is_beside[v] = 1;
    }
    if (probe.hidden.empty() || probe.mesh.face_count() == 0) continue;
    Progress analysing;
    probe.analysis = analyse_holes(probe.mesh, analysing);
    std::vector<Index> rims;  // made by the disc alone
    for (const Hole& hole : probe.analysis.holes) {
      if (std::all_of(hole.vertices.begin(), hole.vertices.end(), [&](Index v) { return is_beside[v] != 0; }))
        rims.push_back(hole.id);
    }
    if (rims.size() != 1) continue;
    probe.hole = rims.front();
    const std::size_t stride = probe.hidden.size() / most_hidden + 1;
    for (std::size_t i = 0; i * stride < probe.hidden.size(); ++i) probe.hidden[i] = probe.hidden[i * stride];
    probe.hidden.resize((probe.hidden.size() + stride - 1) / stride);
    probes_.push_back(std::move(probe));
  }
}

double CrossValidation::error(const Patcher& patcher, Progress& progress) const {
  if (probes_.empty()) return std::numeric_limits<double>::infinity();
  double sum = 0;
  for (const Probe& probe : probes_) sum += error_at(probe, patcher, progress);
  return sum / static_cast<double>(probes_.size());
}

double CrossValidation::error_at(const Probe& probe, const Patcher& patcher, Progress& progress) const {
  const Index hole = probe.hole;
  HoleSite site = make_site(probe.mesh, probe.analysis, {&hole, 1}, {});
  site.wish = wish_;
  const auto patch = patcher.attempt(site, progress);
  if (!patch) return std::numeric_limits<double>::infinity();
  const auto given = static_cast<Index>(probe.mesh.vertex_count());
  const auto at = [&](Index v) { return v < given ? probe.mesh.positions[v] : patch->points[v - given]; };
  std::vector<std::array<Vec3, 3>> triangles;
  for (const auto& [a, b, c] : patch->triangles) triangles.push_back({at(a), at(b), at(c)});
  double sum = 0;
  for (const Vec3& place : probe.hidden) sum += distance_to_triangles(place, triangles);
  return sum / static_cast<double>(probe.hidden.size());
}

}  // namespace croquis::hole_filling

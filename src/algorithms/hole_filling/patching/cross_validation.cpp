// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/hole_filling/patching/cross_validation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "algorithms/hole_filling/continuation/known_surface.h"
#include "algorithms/hole_filling/patching/triangle_distance.h"
#include "croquis/base/error.h"

namespace croquis::hole_filling {
namespace {

constexpr std::size_t most_probes = 6;
constexpr std::size_t most_vertices = 20000;  // of the surface around that is looked at
constexpr std::size_t most_hidden = 300;      // places compared per probe
constexpr double disc_reach = 1.2;            // × diameter of the hole
constexpr double probe_radius = 0.25;         // × diameter of the hole
constexpr double least_radius = 2.5;          // × edge: a disc of some twenty triangles
constexpr double disc_margin = 2;             // × edge, that stay between the rim and a disc

/// Vertices beside the rims that are far from each other.
std::vector<Index> spread_centres(const KnownSurface& around, double radius) {
  std::vector<Index> candidates;
  for (Index v = 0; v < around.distance.size(); ++v) {
    const double beyond = around.distance[v] - radius - disc_margin * around.edge;
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
  const KnownSurface around = known_surface(site, disc_reach, 4 * least_radius, most_vertices);
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
  double sum = 0;
  for (const double error : errors(patcher, progress)) sum += error;
  const double mean = sum / static_cast<double>(probes_.size());
  return std::isfinite(mean) ? mean : std::numeric_limits<double>::infinity();
}

std::vector<double> CrossValidation::errors(const Patcher& patcher, Progress& progress) const {
  std::vector<double> errors;
  for (const Probe& probe : probes_) errors.push_back(error_at(probe, patcher, progress));
  return errors;
}

double CrossValidation::error_at(const Probe& probe, const Patcher& patcher, Progress& progress) const {
  const Index hole = probe.hole;
  HoleSite site = make_site(probe.mesh, probe.analysis, {&hole, 1}, {});
  site.wish = wish_;
  const auto patch = patcher.attempt(site, progress);
  if (!patch) return std::numeric_limits<double>::quiet_NaN();
  const auto given = static_cast<Index>(probe.mesh.vertex_count());
  const auto at = [&](Index v) { return v < given ? probe.mesh.positions[v] : patch->points[v - given]; };
  std::vector<std::array<Vec3, 3>> triangles;
  for (const auto& [a, b, c] : patch->triangles) triangles.push_back({at(a), at(b), at(c)});
  double sum = 0;
  for (const Vec3& place : probe.hidden) sum += distance_to_triangles(place, triangles);
  return sum / static_cast<double>(probe.hidden.size());
}

}  // namespace croquis::hole_filling

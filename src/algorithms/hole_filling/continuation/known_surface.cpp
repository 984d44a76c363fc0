// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/hole_filling/continuation/known_surface.h"

#include <algorithm>

#include "algorithms/hole_filling/continuation/crease_angle.h"
#include "algorithms/hole_filling/continuation/vertex_numbers.h"

namespace croquis::hole_filling {
namespace {

/// All at the vertices reached, ascending.
std::vector<Index> triangles_at(const SurfaceView& view, const std::vector<ReachedVertex>& reached) {
  std::vector<Index> triangles;
  for (const ReachedVertex& r : reached) {
    triangles.push_back(r.corner / 3);
    add_fan(view, r.corner, triangles);
  }
  std::sort(triangles.begin(), triangles.end());
  triangles.erase(std::unique(triangles.begin(), triangles.end()), triangles.end());
  return triangles;
}

}  // namespace

KnownSurface known_surface(const HoleSite& site, double reach, double least_reach, std::size_t most_vertices) {
  auto reached = reach_from_rims(site, std::max(reach * widest_diameter(site), least_reach * mean_rim_edge(site)));
  if (reached.size() > most_vertices) reached.resize(most_vertices);
  return known_surface(site, reached);
}

KnownSurface known_surface(const HoleSite& site, const std::vector<ReachedVertex>& reached) {
  const SurfaceView& view = site.analysis->view;
  KnownSurface known;
  known.edge = mean_rim_edge(site);
  known.size = widest_diameter(site);
  known.crease_cosine = crease_cosine(site);
  VertexNumbers numbers;
  for (const ReachedVertex& r : reached) {
    numbers.number(r.vertex);
    known.mesh.positions.push_back(site.mesh->positions[r.vertex]);
    known.distance.push_back(r.distance);
  }
  for (const Index triangle : triangles_at(view, reached)) {
    const auto& t = view.triangles[triangle];
    const Index a = numbers.known_number(t[0]), b = numbers.known_number(t[1]), c = numbers.known_number(t[2]);
    if (a != no_index && b != no_index && c != no_index) known.mesh.add_triangle(a, b, c);
  }
  return known;
}

}  // namespace croquis::hole_filling

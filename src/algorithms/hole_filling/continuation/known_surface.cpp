// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/hole_filling/continuation/known_surface.h"

#include <algorithm>
#include <optional>
#include <utility>

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

double size_of(const HoleSite& site) {
  double size = 0;
  for (const Index id : site.holes) size = std::max(size, site.analysis->holes[id].diameter);
  return size;
}

double mean_edge(const HoleSite& site) {
  double perimeter = 0;
  for (const Index id : site.holes) perimeter += site.analysis->holes[id].perimeter;
  return perimeter / static_cast<double>(site.vertices.size());
}

}  // namespace

KnownSurface known_surface(const HoleSite& site, double reach, double least_reach, std::size_t most_vertices) {
  auto reached = reach_from_rims(site, std::max(reach * size_of(site), least_reach * mean_edge(site)));
  if (reached.size() > most_vertices) reached.resize(most_vertices);
  return known_surface(site, reached);
}

KnownSurface known_surface(const HoleSite& site, const std::vector<ReachedVertex>& reached) {
  const SurfaceView& view = site.analysis->view;
  KnownSurface known;
  known.edge = mean_edge(site);
  known.size = size_of(site);
  std::vector<std::pair<Index, Index>> numbers;  // vertex of the view, of the known surface
  for (const ReachedVertex& r : reached) {
    numbers.emplace_back(r.vertex, static_cast<Index>(numbers.size()));
    known.mesh.positions.push_back(site.mesh->positions[r.vertex]);
    known.distance.push_back(r.distance);
  }
  std::sort(numbers.begin(), numbers.end());
  const auto number_of = [&](Index v) -> std::optional<Index> {
    const auto place = std::lower_bound(numbers.begin(), numbers.end(), std::pair(v, Index{0}));
    if (place == numbers.end() || place->first != v) return std::nullopt;
    return place->second;
  };
  for (const Index triangle : triangles_at(view, reached)) {
    const auto& t = view.triangles[triangle];
    const auto a = number_of(t[0]), b = number_of(t[1]), c = number_of(t[2]);
    if (a && b && c) known.mesh.add_triangle(*a, *b, *c);
  }
  return known;
}

}  // namespace croquis::hole_filling

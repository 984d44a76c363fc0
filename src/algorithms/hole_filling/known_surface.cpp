// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/hole_filling/known_surface.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "algorithms/hole_filling/surface_reach.h"

namespace croquis::hole_filling {

KnownSurface known_surface(const HoleSite& site, double reach, double least_reach, std::size_t most_vertices) {
  KnownSurface known;
  double perimeter = 0;
  for (const Index id : site.holes) {
    perimeter += site.analysis->holes[id].perimeter;
    known.size = std::max(known.size, site.analysis->holes[id].diameter);
  }
  known.edge = perimeter / static_cast<double>(site.vertices.size());
  auto reached = reach_from_rims(site, std::max(reach * known.size, least_reach * known.edge));
  if (reached.size() > most_vertices) reached.resize(most_vertices);
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
  for (const auto& t : site.analysis->view.triangles) {
    const auto a = number_of(t[0]), b = number_of(t[1]), c = number_of(t[2]);
    if (a && b && c) known.mesh.add_triangle(*a, *b, *c);
  }
  return known;
}

}  // namespace croquis::hole_filling

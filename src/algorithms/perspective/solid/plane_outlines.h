// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <map>
#include <span>
#include <vector>

#include "algorithms/perspective/solid/plane_axes.h"
#include "croquis/geometry/brep.h"

namespace croquis {

/// The outlines of a plane face, flat: as planar triangulations take them.
struct PlaneOutlines {
  std::vector<std::vector<Index>> loops;    ///< each outline's vertices, in its order
  std::vector<Index> vertices;              ///< #V, each vertex of the loops once, in the order of the loops
  std::vector<Vec2> places;                 ///< #V by 2, in the plane
  std::vector<std::array<Index, 2>> sides;  ///< of all loops, indices into `vertices`
};

/// @param positions of all vertices
/// @param along     (Index half_edge) -> its vertices, from its origin to its end
template <typename Along>
PlaneOutlines plane_outlines(const Brep& brep, const BrepFace& face, std::span<const Vec3> positions,
                             const Along& along) {
  PlaneOutlines flat;
  const auto [u, v] = plane_axes(face.normal);
  std::map<Index, Index> numbers;
  const auto number_of = [&](Index vertex) {
    const auto [known, is_new] = numbers.try_emplace(vertex, static_cast<Index>(flat.vertices.size()));
    if (is_new) {
      flat.vertices.push_back(vertex);
      flat.places.emplace_back(u.dot(positions[vertex]), v.dot(positions[vertex]));
    }
    return known->second;
  };
  for (const Index loop : face.loops) {
    std::vector<Index>& outline = flat.loops.emplace_back();
    for (const Index half_edge : brep.around(loop)) {
      const std::vector<Index> vertices = along(half_edge);
      outline.insert(outline.end(), vertices.begin(), vertices.end() - 1);
    }
    for (std::size_t i = 0; i < outline.size(); ++i)
      flat.sides.push_back({number_of(outline[i]), number_of(outline[(i + 1) % outline.size()])});
  }
  return flat;
}

/// The vertices of an edge in the direction of one of its half-edges.
/// @param of_edge from its start to its end
inline std::vector<Index> vertices_along(const Brep& brep, Index half_edge, std::vector<Index> of_edge) {
  if (brep.half_edges[half_edge].reversed) std::ranges::reverse(of_edge);
  return of_edge;
}

}  // namespace croquis

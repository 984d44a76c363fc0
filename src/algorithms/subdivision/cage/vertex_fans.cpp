// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/subdivision/cage/vertex_fans.h"

#include <numeric>

namespace croquis::subdivision {
namespace {

struct Fan {
  Index vertex;        ///< before the split
  Index first_corner;  ///< from which turning counter-clockwise reaches all
};

/// The clockwise end of the fan, or the corner itself where it closes.
Index fan_start(const HalfEdges& mesh, const CornerFaces& around, Index corner) {
  Index start = corner;
  while (mesh.twin[start] != no_index) {
    start = around.next(mesh.twin[start]);
    if (start == corner) break;
  }
  return start;
}

/// Fans by their lowest corners; sets the fan of each corner.
std::vector<Fan> number_fans(const HalfEdges& mesh, std::vector<Index>& fan_of_corner) {
  const CornerFaces around(mesh);
  std::vector<Fan> fans;
  fan_of_corner.assign(mesh.corner_count(), no_index);
  for (Index corner = 0; corner < mesh.corner_count(); ++corner) {
    if (fan_of_corner[corner] != no_index) continue;
    const auto fan = static_cast<Index>(fans.size());
    fans.push_back({mesh.corner_vertex[corner], fan_start(mesh, around, corner)});
    for (Index c = fans.back().first_corner; c != no_index && fan_of_corner[c] == no_index;
         c = mesh.twin[around.previous(c)]) {
      fan_of_corner[c] = fan;
    }
  }
  return fans;
}

}  // namespace

VertexFans split_vertices_into_fans(HalfEdges& mesh, std::size_t vertex_count) {
  std::vector<Index> fan_of_corner;
  const std::vector<Fan> fans = number_fans(mesh, fan_of_corner);

  VertexFans result;
  std::vector<Index> offsets(vertex_count + 1, 0);
  for (const Fan& fan : fans) ++offsets[fan.vertex + std::size_t{1}];
  for (Index vertex = 0; vertex < vertex_count; ++vertex) {
    if (offsets[vertex + std::size_t{1}] == 0) result.loose.push_back(vertex);
    if (offsets[vertex + std::size_t{1}] > 1) result.split.push_back(vertex);
  }
  std::partial_sum(offsets.begin(), offsets.end(), offsets.begin());

  result.source_vertex.resize(fans.size());
  mesh.vertex_corner.resize(fans.size());
  std::vector<Index> number(fans.size());
  for (std::size_t fan = 0; fan < fans.size(); ++fan) {
    number[fan] = offsets[fans[fan].vertex]++;
    result.source_vertex[number[fan]] = fans[fan].vertex;
    mesh.vertex_corner[number[fan]] = fans[fan].first_corner;
  }
  for (std::size_t corner = 0; corner < mesh.corner_count(); ++corner) {
    mesh.corner_vertex[corner] = number[fan_of_corner[corner]];
  }
  return result;
}

}  // namespace croquis::subdivision

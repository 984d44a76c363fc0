// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/hole_filling/patching/open_sheet.h"

#include <algorithm>
#include <numeric>

#include "croquis/geometry/mesh_topology.h"

namespace croquis::hole_filling {
namespace {

PolyMesh with_faces(const PolyMesh& mesh, const std::vector<bool>& stays) {
  std::vector<Index> number(mesh.vertex_count(), no_index);
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    if (!stays[f]) continue;
    for (const Index v : mesh.face(f)) number[v] = 0;
  }
  PolyMesh kept;
  for (std::size_t v = 0; v < number.size(); ++v) {
    if (number[v] == no_index) continue;
    number[v] = static_cast<Index>(kept.vertex_count());
    kept.positions.push_back(mesh.positions[v]);
  }
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    if (stays[f]) kept.add_triangle(number[face[0]], number[face[1]], number[face[2]]);
  }
  return kept;
}

/// Takes triangles away from the border, round by round; a round looks only at what the one before has changed.
class Peeling {
 public:
  Peeling(const PolyMesh& mesh, std::vector<bool>& stays) : topology_(mesh), stays_(stays) {}

  void run() {
    std::vector<Index> faces(topology_.face_count()), vertices(topology_.vertex_count());
    std::iota(faces.begin(), faces.end(), Index{0});
    std::iota(vertices.begin(), vertices.end(), Index{0});
    for (;;) {
      find_rough(faces, vertices);
      if (peeled_.empty()) return;
      faces.clear();
      vertices.clear();
      for (const Index face : peeled_) {
        for (Index corner = 3 * face; corner < 3 * face + 3; ++corner) {
          vertices.push_back(topology_.vertex(corner));
          const Index across = topology_.opposite(corner);
          if (across != no_index) faces.push_back(topology_.face(across));
        }
      }
    }
  }

 private:
  /// Peels those of the faces that have two border edges, and all around those of the vertices where borders touch.
  void find_rough(const std::vector<Index>& faces, const std::vector<Index>& vertices) {
    peeled_.clear();
    for (const Index face : faces) {
      if (stays_[face] && is_border(3 * face) + is_border(3 * face + 1) + is_border(3 * face + 2) > 1)
        peeled_.push_back(face);
    }
    for (const Index vertex : vertices) {
      if (borders_at(vertex) < 2) continue;
      for (const Index corner : topology_.vertex_corners(vertex)) {
        if (stays_[topology_.face(corner)]) peeled_.push_back(topology_.face(corner));
      }
    }
    for (const Index face : peeled_) stays_[face] = false;
  }

  /// Whether what stays ends at the edge of a corner whose face stays.
  int is_border(Index corner) const {
    const Index across = topology_.opposite(corner);
    return across == no_index || !stays_[topology_.face(across)] ? 1 : 0;
  }

  int borders_at(Index vertex) const {
    int count = 0;
    for (const Index corner : topology_.vertex_corners(vertex)) {
      if (stays_[topology_.face(corner)]) count += is_border(corner);
    }
    return count;
  }

  MeshTopology topology_;
  std::vector<bool>& stays_;
  std::vector<Index> peeled_;
};

}  // namespace

PolyMesh open_sheet(const PolyMesh& triangles, std::span<const std::uint8_t> left_out) {
  std::vector<bool> stays(triangles.face_count());
  for (std::size_t f = 0; f < stays.size(); ++f)
    stays[f] = std::ranges::none_of(triangles.face(f), [&](Index v) { return left_out[v] != 0; });
  Peeling(triangles, stays).run();
  return with_faces(triangles, stays);
}

std::vector<BorderLoop> border_loops(const PolyMesh& sheet) {
  const MeshTopology topology(sheet);
  std::vector<BorderLoop> loops;
  for (std::size_t i = 0; i < topology.boundary_loops().size(); ++i) {
    const auto loop = topology.boundary_loops()[i];
    const Index corner = topology.vertex_corners(loop.front()).front();
    loops.push_back({{loop.begin(), loop.end()}, topology.component(topology.face(corner))});
  }
  return loops;
}

PolyMesh components_of(const PolyMesh& sheet, const std::vector<bool>& wanted) {
  const MeshTopology topology(sheet);
  std::vector<bool> stays(sheet.face_count());
  for (Index f = 0; f < sheet.face_count(); ++f) stays[f] = wanted[topology.component(f)];
  return with_faces(sheet, stays);
}

}  // namespace croquis::hole_filling

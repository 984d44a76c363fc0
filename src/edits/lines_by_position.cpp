// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/edits/lines_by_position.h"

#include <utility>

#include "croquis/edits/apply_edits.h"
#include "croquis/implicit/point_tree.h"

namespace croquis {
namespace {

Vec3 mean_place(const PolyMesh& mesh, std::span<const Index> vertices) {
  Vec3 sum = Vec3::Zero();
  for (const Index vertex : vertices) sum += mesh.positions[vertex];
  return sum / static_cast<double>(vertices.size());
}

Vec3 place_of(const PolyMesh& mesh, const MeshTopology& topology, ComponentKind kind, Index element) {
  if (kind == ComponentKind::Vertex) return mesh.positions[element];
  if (kind == ComponentKind::Edge) return mean_place(mesh, topology.edge_vertices(element));
  return mean_place(mesh, mesh.face(element));
}

/// The element of each place's nearest one.
Elements nearest_elements(const PolyMesh& mesh, const MeshTopology& topology, ComponentKind kind,
                          const std::vector<Vec3>& places) {
  std::vector<Vec3> known;
  for (const Index element : all_elements(element_count(topology, kind))) {
    known.push_back(place_of(mesh, topology, kind, element));
  }
  const implicit::PointTree tree(known);
  Elements elements;
  for (const Vec3& place : places) {
    const Index element = tree.nearest(place);
    if (element != no_index) elements.push_back(element);
  }
  return sorted_unique(std::move(elements));
}

}  // namespace

std::vector<EditLine> lines_by_position(PolyMesh before, PolyMesh now, std::span<const EditLine> lines,
                                        const EditRegistry& registry, Progress& progress) {
  std::vector<EditLine> found;
  for (const EditLine& line : lines) {
    progress.check();
    const MeshTopology old_topology(before);
    const MeshTopology topology(now);
    // First: it refuses elements that aren't there.
    MeshEdit old_edit = apply_edit(before, old_topology, line, registry);
    EditLine moved = line;
    std::vector<Vec3> places;
    for (const Index element : line.target.elements) {
      places.push_back(place_of(before, old_topology, line.target.kind, element));
    }
    moved.target.elements = nearest_elements(now, topology, line.target.kind, places);
    MeshEdit edit = apply_edit(now, topology, moved, registry);
    before = std::move(old_edit.mesh);
    now = std::move(edit.mesh);
    found.push_back(std::move(moved));
    progress.report(static_cast<double>(found.size()) / static_cast<double>(lines.size()));
  }
  return found;
}

}  // namespace croquis

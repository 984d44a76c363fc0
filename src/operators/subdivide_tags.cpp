// SPDX-License-Identifier: GPL-3.0-or-later
#include "operators/subdivide_tags.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>
#include <vector>

#include "croquis/geometry/polygon_area.h"
#include "croquis/io/mesh_tags_file.h"
#include "croquis/subdivision/cage.h"

namespace croquis {
namespace {

using Edge = std::array<Index, 2>;

Edge sorted(Edge edge) {
  if (edge[0] > edge[1]) std::swap(edge[0], edge[1]);
  return edge;
}

std::set<Edge> edges_of(const std::vector<Crease>& creases) {
  std::set<Edge> edges;
  for (const Crease& crease : creases) edges.insert(sorted(crease.vertices));
  return edges;
}

std::vector<Vec3> face_normals(const subdivision::Cage& cage) {
  std::vector<Vec3> normals;
  for (Index f = 0; f < cage.topology.face_count(); ++f) {
    normals.push_back(area_normal(cage.positions, cage.topology.face(f)));
  }
  return normals;
}

}  // namespace

MeshTags united_tags(const MeshTags& own, const MeshTags& added) {
  MeshTags united;
  const std::set<Edge> replaced = edges_of(added.creases);
  for (const Crease& crease : own.creases) {
    if (!replaced.contains(sorted(crease.vertices))) united.creases.push_back(crease);
  }
  united.creases.insert(united.creases.end(), added.creases.begin(), added.creases.end());
  united.pins = own.pins;
  const std::set<Index> pinned(own.pins.begin(), own.pins.end());
  for (const Index pin : added.pins) {
    if (!pinned.contains(pin)) united.pins.push_back(pin);
  }
  std::set<std::string> names;
  for (const CreaseSet& set : added.sets) names.insert(set.name);
  for (const CreaseSet& set : own.sets) {
    if (!names.contains(set.name)) united.sets.push_back(set);
  }
  united.sets.insert(united.sets.end(), added.sets.begin(), added.sets.end());
  return united;
}

PortDescription tags_input() {
  return {"tags", ValueType::Report,
          "Sharp edges and pins (croquis-tags-1), added to the cage's own; of two tags of an edge these count.", false,
          true};
}

std::shared_ptr<const PolyMesh> tagged_cage(const Values& inputs, Findings& warnings) {
  const auto cage = inputs.at("cage").as<PolyMesh>();
  const auto tags = inputs.find("tags");
  if (tags == inputs.end()) return cage;
  MeshTagsReadResult read = read_mesh_tags(tags->second.get<Report>());
  warnings = std::move(read.warnings);
  PolyMesh mesh = *cage;
  mesh.tags = united_tags(mesh.tags, read.tags);
  return std::make_shared<const PolyMesh>(std::move(mesh));
}

MeshTags with_sharp_angles(const PolyMesh& mesh, double angle, const subdivision::Rules& rules) {
  const subdivision::Cage cage = subdivision::make_cage(mesh, rules).cage;
  const subdivision::HalfEdges& topology = cage.topology;
  const subdivision::CornerFaces faces(topology);
  const std::vector<Vec3> normals = face_normals(cage);
  const std::set<Edge> tagged = edges_of(mesh.tags.creases);
  MeshTags tags = mesh.tags;
  for (const Index corner : topology.edge_corner) {
    const Index twin = topology.twin[corner];
    if (twin == no_index) continue;
    if (!(angle_between(normals[faces.face(corner)], normals[faces.face(twin)]) > angle)) continue;
    const Edge edge =
        sorted({cage.source_vertex[topology.corner_vertex[corner]], cage.source_vertex[topology.corner_vertex[twin]]});
    if (!tagged.contains(edge)) tags.creases.push_back({edge, infinite_sharpness});
  }
  return tags;
}

}  // namespace croquis

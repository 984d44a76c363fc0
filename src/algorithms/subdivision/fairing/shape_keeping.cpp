// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/subdivision/shape_keeping.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>

#include <Eigen/Geometry>

#include "algorithms/subdivision/cage/face_cutting.h"
#include "croquis/base/error.h"
#include "croquis/geometry/edge_channels.h"
#include "croquis/geometry/mesh_topology.h"

namespace croquis::subdivision {
namespace {

/// Whether each face is in the region.
std::vector<bool> membership(const PolyMesh& mesh, std::span<const Index> faces) {
  std::vector<bool> member(mesh.face_count(), false);
  Findings findings;
  for (const Index face : faces) {
    if (face < member.size()) {
      member[face] = true;
      continue;
    }
    findings.push_back(make_error(Category::Malformed, "E_INDEX",
                                  "The region names face " + std::to_string(face) + " of a mesh with " +
                                      std::to_string(mesh.face_count()) + " faces; leave it out.",
                                  {numbered_subject(SubjectKind::Face, face)}));
  }
  if (!findings.empty()) throw Error(std::move(findings));
  return member;
}

/// Tags and pins the edges that `chosen` accepts.
template <typename Chosen>
void keep_edges(PolyMesh& mesh, const MeshTopology& topology, const Chosen& chosen) {
  TagChanges changes(mesh.tags);
  for (Index edge = 0; edge < topology.edge_count(); ++edge) {
    if (!chosen(edge)) continue;
    const auto ends = topology.edge_vertices(edge);
    if (topology.edge_corners(edge).size() > 1) changes.add_crease(ends);
    for (const Index vertex : ends) changes.add_pin(vertex);
  }
  changes.finish();
}

std::size_t faces_in(const MeshTopology& topology, Index edge, const std::vector<bool>& member) {
  const auto corners = topology.edge_corners(edge);
  return static_cast<std::size_t>(
      std::count_if(corners.begin(), corners.end(), [&](Index corner) { return member[topology.face(corner)]; }));
}

std::map<Index, FaceTriangles> cuts_of_bent_faces(const PolyMesh& mesh, const std::vector<bool>& member) {
  const MeshTopology topology(mesh);
  std::map<Index, FaceTriangles> cuts;
  for (Index face = 0; face < mesh.face_count(); ++face) {
    if (!member[face] || mesh.face(face).size() < 4 || relative_deviation(mesh, face) <= planar_tolerance) continue;
    cuts.emplace(face, triangulated_face(mesh, topology, face));
  }
  return cuts;
}

Findings notices_of(const std::map<Index, FaceTriangles>& cuts) {
  if (cuts.empty()) return {};
  std::vector<Subject> subjects;
  for (const auto& [face, triangles] : cuts) {
    subjects.push_back(numbered_subject(SubjectKind::Face, face));
  }
  const std::string count = std::to_string(cuts.size());
  return {make_warning(Category::Geometry, "W_TRIANGULATED",
                       count +
                           (cuts.size() == 1 ? " face of the region isn't planar and was"
                                             : " faces of the region aren't planar and were") +
                           " cut into triangles, to be kept exactly.",
                       std::move(subjects))};
}

/// Pairs of tagged edges' other ends at each vertex; more than two are counted but not kept.
struct TaggedEnds {
  std::size_t count = 0;
  std::array<Index, 2> others = {no_index, no_index};
};

std::vector<TaggedEnds> tagged_ends(const PolyMesh& mesh, const MeshTopology& topology) {
  std::vector<TaggedEnds> ends(mesh.vertex_count());
  const std::vector<double> sharpness = edge_sharpness(mesh.tags, topology);
  for (Index edge = 0; edge < topology.edge_count(); ++edge) {
    const bool boundary = topology.edge_corners(edge).size() == 1;
    if (sharpness[edge] == 0 && !boundary) continue;
    const auto [a, b] = topology.edge_vertices(edge);
    for (const auto& [from, to] : {std::pair(a, b), std::pair(b, a)}) {
      TaggedEnds& at = ends[from];
      if (boundary) at.count += 3;  // nothing at the boundary is a crease vertex
      if (at.count < 2) at.others[at.count] = to;
      ++at.count;
    }
  }
  return ends;
}

double turn(const Vec3& before, const Vec3& at, const Vec3& after) {
  const Vec3 in = at - before;
  const Vec3 out = after - at;
  return std::atan2(in.cross(out).norm(), in.dot(out));
}

}  // namespace

KeptRegion keep_region(const PolyMesh& mesh, std::span<const Index> faces) {
  const std::vector<bool> member = membership(mesh, faces);
  const auto cuts = cuts_of_bent_faces(mesh, member);
  CutMesh cut = with_faces_cut(mesh, cuts);
  KeptRegion result{std::move(cut.mesh), std::move(cut.source_face), {}, notices_of(cuts)};
  std::vector<bool> kept(result.source_face.size());
  for (Index face = 0; face < kept.size(); ++face) {
    kept[face] = member[result.source_face[face]];
    if (kept[face]) result.region.push_back(face);
  }
  const MeshTopology topology(result.mesh);
  keep_edges(result.mesh, topology, [&](Index edge) { return faces_in(topology, edge, kept) > 0; });
  return result;
}

PolyMesh keep_outline(const PolyMesh& mesh, std::span<const Index> faces) {
  const std::vector<bool> member = membership(mesh, faces);
  const MeshTopology topology(mesh);
  PolyMesh result = mesh;
  keep_edges(result, topology, [&](Index edge) {
    const std::size_t inside = faces_in(topology, edge, member);
    return inside > 0 && (inside < topology.edge_corners(edge).size() || topology.edge_corners(edge).size() == 1);
  });
  return result;
}

PolyMesh pin_kinks(const PolyMesh& mesh, double least_turn) {
  const MeshTopology topology(mesh);
  PolyMesh result = mesh;
  TagChanges changes(result.tags);
  const std::vector<TaggedEnds> ends = tagged_ends(mesh, topology);
  for (Index v = 0; v < ends.size(); ++v) {
    if (ends[v].count != 2) continue;
    const auto& [a, b] = ends[v].others;
    if (turn(mesh.positions[a], mesh.positions[v], mesh.positions[b]) > least_turn) changes.add_pin(v);
  }
  changes.finish();
  return result;
}

}  // namespace croquis::subdivision

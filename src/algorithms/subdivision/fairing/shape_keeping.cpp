// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/subdivision/shape_keeping.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <string>
#include <utility>

#include <Eigen/Geometry>

#include "croquis/base/error.h"
#include "croquis/geometry/edge_channels.h"
#include "croquis/geometry/mesh_topology.h"
#include "croquis/geometry/polygon_area.h"
#include "croquis/geometry/polygon_cut.h"

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

std::array<Index, 2> sorted(std::array<Index, 2> vertices) {
  if (vertices[1] < vertices[0]) std::swap(vertices[0], vertices[1]);
  return vertices;
}

void finish_pins(std::vector<Index>& pins) {
  std::sort(pins.begin(), pins.end());
  pins.erase(std::unique(pins.begin(), pins.end()), pins.end());
}

/// Tags the edges that `chosen` accepts as sharp for ever, but on the boundary, and pins their ends. A finite crease
/// becomes infinite and leaves the named sets, whose members share one sharpness.
template <typename Chosen>
void keep_edges(PolyMesh& mesh, const MeshTopology& topology, const Chosen& chosen) {
  MeshTags& tags = mesh.tags;
  std::map<std::array<Index, 2>, std::size_t> crease_of;
  for (std::size_t i = 0; i < tags.creases.size(); ++i) crease_of[sorted(tags.creases[i].vertices)] = i;
  for (Index edge = 0; edge < topology.edge_count(); ++edge) {
    if (!chosen(edge)) continue;
    const std::array<Index, 2> ends = topology.edge_vertices(edge);
    tags.pins.insert(tags.pins.end(), ends.begin(), ends.end());
    if (topology.edge_corners(edge).size() == 1) continue;
    const std::array<Index, 2> vertices = sorted(ends);
    const auto [place, is_new] = crease_of.try_emplace(vertices, tags.creases.size());
    if (is_new) {
      tags.creases.push_back({vertices, infinite_sharpness});
    } else if (tags.creases[place->second].sharpness != infinite_sharpness) {
      tags.creases[place->second].sharpness = infinite_sharpness;
      for (CreaseSet& set : tags.sets) std::erase(set.edges, vertices);
    }
  }
  finish_pins(tags.pins);
}

std::size_t faces_in(const MeshTopology& topology, Index edge, const std::vector<bool>& member) {
  const auto corners = topology.edge_corners(edge);
  return static_cast<std::size_t>(
      std::count_if(corners.begin(), corners.end(), [&](Index corner) { return member[topology.face(corner)]; }));
}

/// Triangles that replace a face, as corner numbers within it.
using FaceTriangles = std::vector<std::array<Index, 3>>;

struct CutMesh {
  PolyMesh mesh;
  std::vector<Index> source_face;  ///< #F of `mesh`
};

/// Replaces faces by triangles, in place of the face; attributes of faces and corners are those of the source.
CutMesh with_faces_cut(const PolyMesh& mesh, const std::map<Index, FaceTriangles>& cuts) {
  CutMesh result{mesh, {}};
  result.mesh.face_offsets = {0};
  result.mesh.corners.clear();
  std::vector<Index> source_corner;
  const auto add = [&](Index face, auto corners) {
    for (const Index corner : corners) {
      source_corner.push_back(mesh.face_offsets[face] + corner);
      result.mesh.corners.push_back(mesh.face(face)[corner]);
    }
    result.mesh.face_offsets.push_back(static_cast<Index>(result.mesh.corners.size()));
    result.source_face.push_back(face);
  };
  for (Index face = 0; face < mesh.face_count(); ++face) {
    if (const auto cut = cuts.find(face); cut != cuts.end()) {
      for (const auto& triangle : cut->second) add(face, triangle);
    } else {
      std::vector<Index> all(mesh.face(face).size());
      std::iota(all.begin(), all.end(), Index{0});
      add(face, all);
    }
  }
  for (AttributeChannel& channel : result.mesh.channels) {
    if (channel.domain == Domain::Face) channel = gathered(channel, result.source_face);
    if (channel.domain == Domain::Corner) channel = gathered(channel, source_corner);
  }
  renumber_edge_channels(mesh, {}, result.mesh);
  return result;
}

/// Cut as polygon_cut does, but without diagonals that are edges of the mesh already where there is another.
std::map<Index, FaceTriangles> cuts_of_bent_faces(const PolyMesh& mesh, const std::vector<bool>& member) {
  const MeshTopology topology(mesh);
  std::map<Index, FaceTriangles> cuts;
  for (Index face = 0; face < mesh.face_count(); ++face) {
    if (!member[face] || mesh.face(face).size() < 4 || is_planar(mesh, face)) continue;
    cuts.emplace(face, polygon_cut(mesh.positions, mesh.face(face),
                                   [&](Index a, Index b) { return find_edge(topology, a, b) != no_index; }));
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

bool is_planar(const PolyMesh& mesh, Index face) {
  // Coordinates of files in single precision are that far off.
  constexpr double tolerance = 1e-6;
  Vec3 centre = Vec3::Zero();
  for (const Index vertex : mesh.face(face)) centre += mesh.positions[vertex];
  centre /= static_cast<double>(mesh.face(face).size());
  const Vec3 normal = area_normal(mesh, face).normalized();
  double deviation = 0;
  double radius = 0;
  for (const Index vertex : mesh.face(face)) {
    deviation = std::max(deviation, std::abs((mesh.positions[vertex] - centre).dot(normal)));
    radius = std::max(radius, (mesh.positions[vertex] - centre).norm());
  }
  return !(radius > 0) || deviation / (2 * radius) <= tolerance;
}

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
  const std::vector<TaggedEnds> ends = tagged_ends(mesh, topology);
  for (Index v = 0; v < ends.size(); ++v) {
    if (ends[v].count != 2) continue;
    const auto& [a, b] = ends[v].others;
    if (turn(mesh.positions[a], mesh.positions[v], mesh.positions[b]) > least_turn) result.tags.pins.push_back(v);
  }
  finish_pins(result.tags.pins);
  return result;
}

}  // namespace croquis::subdivision

// SPDX-License-Identifier: GPL-3.0-or-later
#include "subdivision/subdivided.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "croquis/geometry/mesh_topology.h"

namespace croquis::test {

using subdivision::CornerFaces;
using subdivision::HalfEdges;
using subdivision::Level;

Subdivided subdivide(const PolyMesh& mesh, int levels, const subdivision::Rules& rules) {
  subdivision::Cage cage = subdivision::make_cage(mesh, rules).cage;
  Progress progress;
  subdivision::DooSabinPlan plan(cage, rules, levels, progress);
  subdivision::PositionBuffers buffers;
  plan.positions(cage.positions, buffers);
  return {std::move(cage), std::move(plan), std::move(buffers)};
}

Counts counts(const HalfEdges& mesh) { return {mesh.vertex_count(), mesh.edge_count(), mesh.face_count()}; }

std::map<std::size_t, std::size_t> faces_by_size(const HalfEdges& mesh) {
  std::map<std::size_t, std::size_t> sizes;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) ++sizes[mesh.face(f).size()];
  return sizes;
}

double sum_of_squares(const std::vector<Vec3>& points) {
  double sum = 0;
  for (const Vec3& point : points) sum += point.squaredNorm();
  return sum;
}

namespace {

/// Calls use(centroid, a, b) for each triangle of each face's fan.
template <typename Use>
void for_each_triangle(const HalfEdges& mesh, const std::vector<Vec3>& points, Use&& use) {
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    Vec3 centroid = Vec3::Zero();
    for (const Index v : face) centroid += points[v] / static_cast<double>(face.size());
    for (std::size_t i = 0; i < face.size(); ++i) use(centroid, points[face[i]], points[face[(i + 1) % face.size()]]);
  }
}

Vec3 area_vector(const HalfEdges& mesh, const std::vector<Vec3>& points, Index face) {
  const auto corners = mesh.face(face);
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 0; i < corners.size(); ++i) {
    sum +=
        (points[corners[i]] - points[corners[0]]).cross(points[corners[(i + 1) % corners.size()]] - points[corners[0]]);
  }
  return sum;
}

PolyMesh faces_of(const HalfEdges& mesh) {
  PolyMesh result;
  result.positions.assign(mesh.vertex_count(), Vec3::Zero());
  result.face_offsets.assign(mesh.face_offsets.begin(), mesh.face_offsets.end());
  result.corners.assign(mesh.corner_vertex.begin(), mesh.corner_vertex.end());
  return result;
}

std::string twin_fault(const HalfEdges& mesh, const CornerFaces& around) {
  std::vector<int> uses(mesh.edge_count(), 0);
  for (Index c = 0; c < mesh.corner_count(); ++c) {
    const std::string name = "half-edge " + std::to_string(c);
    const Index twin = mesh.twin[c];
    if (mesh.corner_edge[c] >= mesh.edge_count()) return name + " has no edge";
    ++uses[mesh.corner_edge[c]];
    if (twin == no_index) continue;
    if (twin >= mesh.corner_count() || twin == c || mesh.twin[twin] != c) return name + " has a wrong twin";
    if (mesh.corner_edge[twin] != mesh.corner_edge[c]) return name + " has another edge than its twin";
    if (mesh.corner_vertex[twin] != mesh.corner_vertex[around.next(c)]) return name + " ends elsewhere than its twin";
    if (mesh.corner_vertex[c] != mesh.corner_vertex[around.next(twin)]) return name + " starts elsewhere";
  }
  for (Index e = 0; e < mesh.edge_count(); ++e) {
    const Index c = mesh.edge_corner[e];
    if (c >= mesh.corner_count() || mesh.corner_edge[c] != e)
      return "edge " + std::to_string(e) + " isn't its corner's";
    if (uses[e] != (mesh.twin[c] == no_index ? 1 : 2)) return "edge " + std::to_string(e) + " has a wrong count";
  }
  return "";
}

std::string fan_fault(const HalfEdges& mesh, const CornerFaces& around) {
  std::vector<std::size_t> valence(mesh.vertex_count(), 0);
  for (const Index v : mesh.corner_vertex) {
    if (v >= mesh.vertex_count()) return "a corner is out of range";
    ++valence[v];
  }
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    const std::string name = "vertex " + std::to_string(v);
    const Index start = mesh.vertex_corner[v];
    if (start >= mesh.corner_count() || mesh.corner_vertex[start] != v) return name + " isn't its corner's";
    std::size_t reached = 0;
    Index corner = start;
    do {
      ++reached;
      corner = mesh.twin[around.previous(corner)];
    } while (corner != no_index && corner != start && reached <= valence[v]);
    if (reached != valence[v]) return name + " doesn't reach its fan";
  }
  return "";
}

}  // namespace

double volume(const HalfEdges& mesh, const std::vector<Vec3>& points) {
  double sum = 0;
  for_each_triangle(mesh, points, [&](const Vec3& a, const Vec3& b, const Vec3& c) { sum += a.dot(b.cross(c)) / 6; });
  return sum;
}

double area(const HalfEdges& mesh, const std::vector<Vec3>& points) {
  double sum = 0;
  for_each_triangle(mesh, points,
                    [&](const Vec3& a, const Vec3& b, const Vec3& c) { sum += (b - a).cross(c - a).norm() / 2; });
  return sum;
}

double dihedral_degrees(const HalfEdges& mesh, const std::vector<Vec3>& points, Index edge) {
  const CornerFaces around(mesh);
  const Index corner = mesh.edge_corner[edge];
  const Vec3 a = area_vector(mesh, points, around.face(corner));
  const Vec3 b = area_vector(mesh, points, around.face(mesh.twin[corner]));
  return std::atan2(a.cross(b).norm(), a.dot(b)) * 180 / std::numbers::pi;
}

double largest_untagged_dihedral(const Level& level, const std::vector<Vec3>& points) {
  const HalfEdges& mesh = level.topology;
  const CornerFaces around(mesh);
  std::vector<bool> tagged(mesh.edge_count());
  for (const auto& tag : level.sharp) tagged[tag.edge] = true;
  double largest = 0;
  for (Index edge = 0; edge < mesh.edge_count(); ++edge) {
    const Index corner = mesh.edge_corner[edge];
    if (tagged[edge] || mesh.twin[corner] == no_index) continue;
    const Vec3 a = area_vector(mesh, points, around.face(corner));
    const Vec3 b = area_vector(mesh, points, around.face(mesh.twin[corner]));
    largest = std::max(largest, std::atan2(a.cross(b).norm(), a.dot(b)) * 180 / std::numbers::pi);
  }
  return largest;
}

std::array<Index, 2> edge_ends(const HalfEdges& mesh, Index edge) {
  const CornerFaces around(mesh);
  const Index corner = mesh.edge_corner[edge];
  return {mesh.corner_vertex[corner], mesh.corner_vertex[around.next(corner)]};
}

std::vector<Index> tagged_vertices(const Level& level) {
  const CornerFaces around(level.topology);
  std::vector<Index> vertices;
  for (const auto& tag : level.sharp) {
    const Index corner = level.topology.edge_corner[tag.edge];
    vertices.push_back(level.topology.corner_vertex[corner]);
    vertices.push_back(level.topology.corner_vertex[around.next(corner)]);
  }
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

bool same_points(const std::vector<Vec3>& a, const std::vector<Vec3>& b, double tolerance) {
  if (a.size() != b.size()) return false;
  const Vec3 direction = Vec3(0.3, 0.5, 0.8).normalized();
  std::vector<std::pair<double, std::size_t>> along(b.size());
  for (std::size_t i = 0; i < b.size(); ++i) along[i] = {b[i].dot(direction), i};
  std::sort(along.begin(), along.end());
  return std::all_of(a.begin(), a.end(), [&](const Vec3& point) {
    const double place = point.dot(direction);
    auto found = std::lower_bound(along.begin(), along.end(), std::pair(place - tolerance, std::size_t{0}));
    for (; found != along.end() && found->first <= place + tolerance; ++found) {
      if ((b[found->second] - point).norm() <= tolerance) return true;
    }
    return false;
  });
}

std::string fault(const HalfEdges& mesh) {
  if (mesh.face_offsets.front() != 0 || mesh.face_offsets.back() != mesh.corner_count()) return "offsets don't fit";
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    if (mesh.face_offsets[f + 1] < mesh.face_offsets[f] + 3) return "face " + std::to_string(f) + " is too small";
  }
  const CornerFaces around(mesh);
  if (const std::string found = twin_fault(mesh, around); !found.empty()) return found;
  if (const std::string found = fan_fault(mesh, around); !found.empty()) return found;

  const MeshTopology counted(faces_of(mesh));
  if (counted.edge_count() != mesh.edge_count()) return "two edges join the same vertices";
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    if (counted.fan_count(v) != 1) return "vertex " + std::to_string(v) + " hasn't one fan";
  }
  for (Index c = 0; c < mesh.corner_count(); ++c) {
    if (counted.opposite(c) != mesh.twin[c]) return "half-edge " + std::to_string(c) + " has another twin by its faces";
  }
  return "";
}

}  // namespace croquis::test

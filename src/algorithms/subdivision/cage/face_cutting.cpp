// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/subdivision/cage/face_cutting.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include <Eigen/Geometry>

#include "algorithms/subdivision/cage/tag_changes.h"
#include "croquis/geometry/edge_channels.h"
#include "croquis/geometry/polygon_area.h"

namespace croquis::subdivision {
namespace {

Vec3 centre(const PolyMesh& mesh, Index face) {
  Vec3 sum = Vec3::Zero();
  for (const Index vertex : mesh.face(face)) sum += mesh.positions[vertex];
  return sum / static_cast<double>(mesh.face(face).size());
}

/// A face laid into the plane across its area normal.
std::vector<Vec2> flattened(const PolyMesh& mesh, Index face) {
  const Vec3 normal = area_normal(mesh, face).normalized();
  const Vec3 u = normal.unitOrthogonal();
  const Vec3 v = normal.cross(u);
  const Vec3 origin = centre(mesh, face);
  std::vector<Vec2> points;
  for (const Index vertex : mesh.face(face)) {
    const Vec3 offset = mesh.positions[vertex] - origin;
    points.emplace_back(offset.dot(u), offset.dot(v));
  }
  return points;
}

bool inside(const Vec2& point, const Vec2& a, const Vec2& b, const Vec2& c) {
  return cross(b - a, point - a) >= 0 && cross(c - b, point - b) >= 0 && cross(a - c, point - c) >= 0;
}

/// Takes ears off one polygon; `rest` lists the corners that are left.
class EarCutter {
 public:
  EarCutter(const PolyMesh& mesh, const MeshTopology& topology, Index face)
      : topology_(topology), vertices_(mesh.face(face)), points_(flattened(mesh, face)), rest_(vertices_.size()) {
    std::iota(rest_.begin(), rest_.end(), Index{0});
  }

  FaceTriangles cut() {
    FaceTriangles triangles;
    while (rest_.size() > 3) {
      const std::size_t ear = choose();
      triangles.push_back(triangle(ear));
      rest_.erase(rest_.begin() + static_cast<std::ptrdiff_t>(ear));
    }
    triangles.push_back({rest_[0], rest_[1], rest_[2]});
    return triangles;
  }

 private:
  std::array<Index, 3> triangle(std::size_t tip) const {
    const std::size_t n = rest_.size();
    return {rest_[(tip + n - 1) % n], rest_[tip], rest_[(tip + 1) % n]};
  }

  bool is_ear(const std::array<Index, 3>& t) const {
    if (cross(points_[t[1]] - points_[t[0]], points_[t[2]] - points_[t[1]]) <= 0) return false;
    return std::none_of(rest_.begin(), rest_.end(), [&](Index corner) {
      return std::find(t.begin(), t.end(), corner) == t.end() &&
             inside(points_[corner], points_[t[0]], points_[t[1]], points_[t[2]]);
    });
  }

  bool diagonal_is_edge(const std::array<Index, 3>& t) const {
    return find_edge(topology_, vertices_[t[0]], vertices_[t[2]]) != no_index;
  }

  /// The ear with the shortest diagonal; where none is left (a face that crosses itself), the shortest diagonal.
  std::size_t choose() const {
    std::size_t best = 0;
    auto best_cost = std::make_tuple(true, true, 0.0);
    for (std::size_t i = 0; i < rest_.size(); ++i) {
      const auto t = triangle(i);
      const auto cost = std::make_tuple(diagonal_is_edge(t), !is_ear(t), (points_[t[0]] - points_[t[2]]).norm());
      if (i > 0 && best_cost <= cost) continue;
      best = i;
      best_cost = cost;
    }
    return best;
  }

  const MeshTopology& topology_;
  std::span<const Index> vertices_;
  std::vector<Vec2> points_;
  std::vector<Index> rest_;
};

}  // namespace

double relative_deviation(const PolyMesh& mesh, Index face) {
  const Vec3 origin = centre(mesh, face);
  const Vec3 normal = area_normal(mesh, face).normalized();
  double deviation = 0;
  double radius = 0;
  for (const Index vertex : mesh.face(face)) {
    deviation = std::max(deviation, std::abs((mesh.positions[vertex] - origin).dot(normal)));
    radius = std::max(radius, (mesh.positions[vertex] - origin).norm());
  }
  return radius > 0 ? deviation / (2 * radius) : 0;
}

FaceTriangles triangulated_face(const PolyMesh& mesh, const MeshTopology& topology, Index face) {
  return EarCutter(mesh, topology, face).cut();
}

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

}  // namespace croquis::subdivision

// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/meshes/surface_distance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>

#include "croquis/geometry/polyline.h"
#include "support/random.h"

namespace croquis::test {
namespace {

constexpr std::size_t leaf_size = 4;

double segment_distance2(const Vec3& p, const Vec3& a, const Vec3& b) {
  return (p - nearest_on_segment(p, a, b)).squaredNorm();
}

double triangle_distance2(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 normal = (b - a).cross(c - a);
  const auto is_inside = [&](const Vec3& from, const Vec3& to) { return (to - from).cross(p - from).dot(normal) >= 0; };
  if (normal.squaredNorm() > 0 && is_inside(a, b) && is_inside(b, c) && is_inside(c, a)) {
    const double height = (p - a).dot(normal.normalized());
    return height * height;
  }
  return std::min({segment_distance2(p, a, b), segment_distance2(p, b, c), segment_distance2(p, c, a)});
}

double box_distance2(const Vec3& p, const Vec3& low, const Vec3& high) {
  return (p - p.cwiseMax(low).cwiseMin(high)).squaredNorm();
}

}  // namespace

SurfaceDistance::SurfaceDistance(const PolyMesh& mesh, std::size_t first_face) {
  for (std::size_t f = first_face; f < mesh.face_count(); ++f) add_fan(mesh, f);
  if (!triangles_.empty()) build(0, triangles_.size());
}

SurfaceDistance::SurfaceDistance(const PolyMesh& mesh, std::span<const Index> faces) {
  for (const Index f : faces) add_fan(mesh, f);
  if (!triangles_.empty()) build(0, triangles_.size());
}

void SurfaceDistance::add_fan(const PolyMesh& mesh, std::size_t face) {
  const auto corners = mesh.face(face);
  for (std::size_t i = 1; i + 1 < corners.size(); ++i)
    triangles_.push_back({mesh.positions[corners[0]], mesh.positions[corners[i]], mesh.positions[corners[i + 1]]});
}

void SurfaceDistance::build(std::size_t begin, std::size_t end) {
  const std::size_t at = nodes_.size();
  Node node{triangles_[begin].a, triangles_[begin].a, begin, end, 0};
  for (std::size_t i = begin; i < end; ++i) {
    for (const Vec3& p : {triangles_[i].a, triangles_[i].b, triangles_[i].c})
      node.low = node.low.cwiseMin(p), node.high = node.high.cwiseMax(p);
  }
  nodes_.push_back(node);
  if (end - begin <= leaf_size) return;
  Eigen::Index axis = 0;
  (node.high - node.low).maxCoeff(&axis);
  const std::size_t middle = (begin + end) / 2;
  const auto from = triangles_.begin();
  const auto place = [axis](const Triangle& t) { return t.a[axis] + t.b[axis] + t.c[axis]; };
  std::nth_element(from + static_cast<std::ptrdiff_t>(begin), from + static_cast<std::ptrdiff_t>(middle),
                   from + static_cast<std::ptrdiff_t>(end),
                   [&](const Triangle& a, const Triangle& b) { return place(a) < place(b); });
  build(begin, middle);
  nodes_[at].right = nodes_.size();
  build(middle, end);
}

double SurfaceDistance::operator()(const Vec3& point) const {
  double least2 = std::numeric_limits<double>::infinity();
  if (nodes_.empty()) return least2;
  std::vector<std::size_t> pending = {0};
  while (!pending.empty()) {
    const Node& node = nodes_[pending.back()];
    const std::size_t left = pending.back() + 1;
    pending.pop_back();
    if (box_distance2(point, node.low, node.high) >= least2) continue;
    if (node.right == 0) {
      for (std::size_t i = node.begin; i < node.end; ++i)
        least2 = std::min(least2, triangle_distance2(point, triangles_[i].a, triangles_[i].b, triangles_[i].c));
      continue;
    }
    const bool is_left_nearer = box_distance2(point, nodes_[left].low, nodes_[left].high) <
                                box_distance2(point, nodes_[node.right].low, nodes_[node.right].high);
    pending.push_back(is_left_nearer ? node.right : left);
    pending.push_back(is_left_nearer ? left : node.right);
  }
  return std::sqrt(least2);
}

std::vector<Vec3> sample_faces(const PolyMesh& mesh, std::span<const Index> faces, std::size_t count,
                               std::uint64_t seed) {
  const auto corner = [&](Index face, std::size_t i) { return mesh.positions[mesh.face(face)[i]]; };
  const auto area = [&](Index face, std::size_t i) {
    const Vec3 a = corner(face, 0);
    return (corner(face, i) - a).cross(corner(face, i + 1) - a).norm() / 2;
  };
  double whole = 0;
  for (const Index f : faces) {
    for (std::size_t i = 1; i + 1 < mesh.face(f).size(); ++i) whole += area(f, i);
  }
  Random random(seed);
  std::vector<Vec3> samples;
  double due = 0.5;
  for (const Index f : faces) {
    for (std::size_t i = 1; i + 1 < mesh.face(f).size(); ++i) {
      due += whole > 0 ? static_cast<double>(count) * area(f, i) / whole : 1;
      for (; due >= 1; --due) {
        double u = random.unit(), v = random.unit();
        if (u + v > 1) u = 1 - u, v = 1 - v;
        samples.emplace_back((1 - u - v) * corner(f, 0) + u * corner(f, i) + v * corner(f, i + 1));
      }
    }
  }
  return samples;
}

DistanceSummary summary_of_distances(std::span<const Vec3> points, const SurfaceDistance& surface) {
  DistanceSummary summary;
  for (const Vec3& p : points) {
    const double distance = surface(p);
    summary.mean += distance / static_cast<double>(points.size());
    summary.greatest = std::max(summary.greatest, distance);
  }
  return summary;
}

}  // namespace croquis::test

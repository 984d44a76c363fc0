// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/smooth_surface.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

#include "croquis/geometry/disjoint_sets.h"
#include "render/polygon_triangulation.h"

namespace croquis::render {
namespace {

/// One face's side of an edge.
struct EdgeSide {
  Index low = 0, high = 0;     // welded vertices
  Index corner = 0, next = 0;  // from the edge's start to its end in the face's sense
  Index face = 0;
  bool ascending = false;  // the face runs from low to high
};

struct Context {
  const PolyMesh& mesh;
  std::span<const glm::dvec3> positions;
  std::span<const Index> welded;
  std::vector<glm::dvec3> face_normals = {};
};

glm::dvec3 unit_or_zero(const glm::dvec3& vector) {
  const double length = glm::length(vector);
  return length > 0 ? vector / length : glm::dvec3(0);
}

std::vector<glm::dvec3> face_normals(const Context& context) {
  std::vector<glm::dvec3> normals;
  normals.reserve(context.mesh.face_count());
  std::vector<glm::dvec3> polygon;
  for (std::size_t f = 0; f < context.mesh.face_count(); ++f) {
    polygon.clear();
    for (const Index vertex : context.mesh.face(f)) polygon.push_back(context.positions[vertex]);
    normals.push_back(unit_or_zero(area_vector(polygon)));
  }
  return normals;
}

std::vector<EdgeSide> sorted_edge_sides(const Context& context) {
  std::vector<EdgeSide> sides;
  sides.reserve(context.mesh.corners.size());
  for (Index f = 0; f < context.mesh.face_count(); ++f) {
    const Index begin = context.mesh.face_offsets[f];
    const Index end = context.mesh.face_offsets[f + 1];
    for (Index corner = begin; corner < end; ++corner) {
      const Index next = corner + 1 < end ? corner + 1 : begin;
      const Index a = context.welded[context.mesh.corners[corner]];
      const Index b = context.welded[context.mesh.corners[next]];
      if (a != b) sides.push_back({std::min(a, b), std::max(a, b), corner, next, f, a < b});
    }
  }
  std::sort(sides.begin(), sides.end(), [](const EdgeSide& a, const EdgeSide& b) {
    return std::tie(a.low, a.high, a.corner) < std::tie(b.low, b.high, b.corner);
  });
  return sides;
}

bool is_smooth(std::span<const EdgeSide> edge, const Context& context, double cosine) {
  if (edge.size() != 2 || edge[0].ascending == edge[1].ascending) return false;
  const glm::dvec3& a = context.face_normals[edge[0].face];
  const glm::dvec3& b = context.face_normals[edge[1].face];
  return a != glm::dvec3(0) && b != glm::dvec3(0) && glm::dot(a, b) > cosine;
}

double angle_between(const glm::dvec3& a, const glm::dvec3& b) {
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

std::vector<glm::dvec3> group_normals(const Context& context, std::span<const Index> groups) {
  std::vector<glm::dvec3> normals(groups.size(), glm::dvec3(0));
  for (std::size_t f = 0; f < context.mesh.face_count(); ++f) {
    const auto face = context.mesh.face(f);
    for (std::size_t i = 0; i < face.size(); ++i) {
      const glm::dvec3& here = context.positions[face[i]];
      const glm::dvec3 ahead = context.positions[face[(i + 1) % face.size()]] - here;
      const glm::dvec3 behind = context.positions[face[(i + face.size() - 1) % face.size()]] - here;
      normals[groups[context.mesh.face_offsets[f] + i]] += angle_between(ahead, behind) * context.face_normals[f];
    }
  }
  for (glm::dvec3& normal : normals) normal = unit_or_zero(normal);
  return normals;
}

/// Numbers the sets 0, 1, … in the order of their lowest elements.
std::vector<Index> dense_numbers(DisjointSets& sets, std::size_t count, Index& set_count) {
  std::vector<Index> numbers(count);
  set_count = 0;
  for (Index i = 0; i < count; ++i) {
    const Index root = sets.root(i);
    numbers[i] = root == i ? set_count++ : numbers[root];
  }
  return numbers;
}

}  // namespace

std::vector<Index> weld(std::span<const glm::dvec3> positions) {
  std::vector<Index> order(positions.size());
  std::iota(order.begin(), order.end(), Index{0});
  const auto key = [&](Index i) { return std::tie(positions[i].x, positions[i].y, positions[i].z); };
  std::sort(order.begin(), order.end(), [&](Index a, Index b) { return key(a) != key(b) ? key(a) < key(b) : a < b; });
  std::vector<Index> welded(positions.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool same = i > 0 && positions[order[i]] == positions[order[i - 1]];
    welded[order[i]] = same ? welded[order[i - 1]] : order[i];
  }
  return welded;
}

SmoothSurface find_smooth_surface(const PolyMesh& mesh, std::span<const glm::dvec3> positions,
                                  std::span<const Index> welded, std::span<const Index> face_parts,
                                  double crease_angle) {
  Context context{mesh, positions, welded};
  context.face_normals = face_normals(context);
  const std::vector<EdgeSide> sides = sorted_edge_sides(context);
  const double cosine = std::cos(crease_angle);

  SmoothSurface surface;
  DisjointSets corners(mesh.corners.size());
  DisjointSets faces(mesh.face_count());
  for (std::size_t begin = 0, end = 0; begin < sides.size(); begin = end) {
    while (end < sides.size() && sides[end].low == sides[begin].low && sides[end].high == sides[begin].high) ++end;
    surface.edges.push_back({sides[begin].corner, sides[begin].next});
    if (!is_smooth({sides.data() + begin, sides.data() + end}, context, cosine)) continue;
    const EdgeSide& a = sides[begin];
    const EdgeSide& b = sides[begin + 1];
    corners.unite(a.corner, b.next);
    corners.unite(a.next, b.corner);
    if (face_parts[a.face] == face_parts[b.face]) faces.unite(a.face, b.face);
  }

  surface.corner_groups.resize(mesh.corners.size());
  for (Index c = 0; c < mesh.corners.size(); ++c) surface.corner_groups[c] = corners.root(c);
  surface.normals = group_normals(context, surface.corner_groups);
  surface.face_patches = dense_numbers(faces, mesh.face_count(), surface.patch_count);
  return surface;
}

}  // namespace croquis::render

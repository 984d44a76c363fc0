// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/geometry/smooth_surface.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

#include "croquis/geometry/disjoint_sets.h"
#include "croquis/geometry/surface_normals.h"

namespace croquis {
namespace {

/// One face's side of an edge, in the list of the edge's lower vertex.
struct EdgeSide {
  Index high = 0;    // the other welded vertex
  Index corner = 0;  // where the face starts to run along the edge
  Index face = 0;
};

/// All sides of edges: those of one lower vertex in a row, by their higher vertex, then by corner.
struct EdgeSides {
  std::vector<Index> first;  // #V+1
  std::vector<EdgeSide> sides;
};

struct Context {
  const PolyMesh& mesh;
  std::span<const Index> welded;
  std::vector<Vec3> face_normals = {};

  Index next(const EdgeSide& side) const {
    const Index end = mesh.face_offsets[side.face + 1];
    return side.corner + 1 < end ? side.corner + 1 : mesh.face_offsets[side.face];
  }
  Index start(const EdgeSide& side) const { return welded[mesh.corners[side.corner]]; }
};

/// Calls with the side and its lower vertex for every corner whose edge has two ends.
template <typename Visit>
void for_each_side(const Context& context, const Visit& visit) {
  const PolyMesh& mesh = context.mesh;
  for (Index f = 0; f < mesh.face_count(); ++f) {
    for (Index corner = mesh.face_offsets[f]; corner < mesh.face_offsets[f + 1]; ++corner) {
      EdgeSide side{0, corner, f};
      const Index a = context.start(side);
      const Index b = context.welded[mesh.corners[context.next(side)]];
      if (a == b) continue;
      side.high = std::max(a, b);
      visit(std::min(a, b), side);
    }
  }
}

/// Lists are short: grouping sides by their lower vertices is far quicker than sorting all of them.
EdgeSides collect_edge_sides(const Context& context) {
  EdgeSides result;
  result.first.assign(context.welded.size() + 2, 0);
  for_each_side(context, [&](Index low, const EdgeSide&) { ++result.first[low + 2]; });
  std::partial_sum(result.first.begin(), result.first.end(), result.first.begin());
  result.sides.resize(result.first.back());
  for_each_side(context, [&](Index low, const EdgeSide& side) { result.sides[result.first[low + 1]++] = side; });
  result.first.pop_back();
  for (std::size_t v = 0; v + 1 < result.first.size(); ++v) {
    const auto at = [&](std::size_t i) { return result.sides.begin() + static_cast<std::ptrdiff_t>(i); };
    std::sort(at(result.first[v]), at(result.first[v + 1]), [](const EdgeSide& a, const EdgeSide& b) {
      return std::tie(a.high, a.corner) < std::tie(b.high, b.corner);
    });
  }
  return result;
}

bool is_smooth(std::span<const EdgeSide> edge, const Context& context, double cosine) {
  if (edge.size() != 2 || context.start(edge[0]) == context.start(edge[1])) return false;
  const Vec3& a = context.face_normals[edge[0].face];
  const Vec3& b = context.face_normals[edge[1].face];
  return a != Vec3::Zero() && b != Vec3::Zero() && a.dot(b) > cosine;
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

/// Calls with each edge's sides and its two welded vertices, lower first.
template <typename Visit>
void for_each_edge(const EdgeSides& all, const Visit& visit) {
  for (Index low = 0; low + 1 < all.first.size(); ++low) {
    for (std::size_t begin = all.first[low], end = begin; begin < all.first[low + 1]; begin = end) {
      while (end < all.first[low + 1] && all.sides[end].high == all.sides[begin].high) ++end;
      visit(std::span(all.sides).subspan(begin, end - begin), std::array<Index, 2>{low, all.sides[begin].high});
    }
  }
}

}  // namespace

std::vector<std::array<Index, 2>> tagged_edges(const MeshTags& tags, std::span<const Index> welded, double least) {
  std::vector<std::array<Index, 2>> edges;
  for (const Crease& crease : tags.creases) {
    // Tags that fit no edge are refused where they are used; a picture shows what is there.
    if (!(crease.sharpness >= least) || std::max(crease.vertices[0], crease.vertices[1]) >= welded.size()) continue;
    const auto [low, high] = std::minmax(welded[crease.vertices[0]], welded[crease.vertices[1]]);
    edges.push_back({low, high});
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

std::vector<Index> joined_places(std::span<const Vec3> positions) {
  std::vector<Index> order(positions.size());
  std::iota(order.begin(), order.end(), Index{0});
  const auto key = [&](Index i) { return std::tie(positions[i].x(), positions[i].y(), positions[i].z()); };
  std::sort(order.begin(), order.end(), [&](Index a, Index b) { return key(a) != key(b) ? key(a) < key(b) : a < b; });
  std::vector<Index> welded(positions.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool same = i > 0 && positions[order[i]] == positions[order[i - 1]];
    welded[order[i]] = same ? welded[order[i - 1]] : order[i];
  }
  return welded;
}

SmoothSurface find_smooth_surface(const PolyMesh& mesh, std::span<const Vec3> positions, std::span<const Index> welded,
                                  std::span<const Index> face_parts, const Sharpness& sharpness) {
  Context context{mesh, welded};
  context.face_normals = face_normals({mesh.face_offsets, mesh.corners}, positions);
  const double cosine = std::cos(sharpness.crease_angle);

  SmoothSurface surface;
  surface.edges.reserve(mesh.corners.size() / 2);
  DisjointSets corners(mesh.corners.size());
  DisjointSets faces(mesh.face_count());
  auto tag = sharpness.tagged_edges.begin();  // edges come in the same order
  for_each_edge(collect_edge_sides(context), [&](std::span<const EdgeSide> edge, const std::array<Index, 2>& ends) {
    surface.edges.push_back({edge[0].corner, context.next(edge[0])});
    while (tag != sharpness.tagged_edges.end() && *tag < ends) ++tag;
    if (tag != sharpness.tagged_edges.end() && *tag == ends) return;
    if (!is_smooth(edge, context, cosine)) return;
    corners.unite(edge[0].corner, context.next(edge[1]));
    corners.unite(context.next(edge[0]), edge[1].corner);
    if (face_parts[edge[0].face] == face_parts[edge[1].face]) faces.unite(edge[0].face, edge[1].face);
  });
  surface.corner_groups = dense_numbers(corners, mesh.corners.size(), surface.group_count);
  surface.face_patches = dense_numbers(faces, mesh.face_count(), surface.patch_count);
  return surface;
}

}  // namespace croquis

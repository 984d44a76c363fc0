// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/remeshing/surface_parts.h"

#include <algorithm>
#include <utility>

#include <Eigen/Geometry>

#include "algorithms/remeshing/field.h"
#include "croquis/base/parallel.h"
#include "croquis/geometry/disjoint_sets.h"
#include "croquis/geometry/triangle_fans.h"
#include "croquis/implicit/point_tree.h"

namespace croquis::remeshing {
namespace {

constexpr int ear_rounds = 2;                  // borders get straighter; more would remove narrow sheets
constexpr std::size_t vertices_per_vote = 20;  // a part with fewer points per vertex is not backed by data
constexpr double lost_beyond = 1.25;  // × cell: a surface has vertices at less than one cell of any of its points
constexpr double few_lost = 0.001;    // of the points of a piece: not worth four times the triangles

/// Marks faces at faults of the border; false when there are none.
bool mark_invalid(const PolyMesh& mesh, bool ears, std::vector<std::uint8_t>& removed) {
  const TriangleFans fans(mesh.vertex_count(), mesh.corners);
  bool found = false;
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
    const auto fan = fans.at(v);
    const bool is_ear = ears && fan.size() == 1;
    if (!is_ear && fans.link(v) != TriangleFans::Link::Broken) continue;
    for (const Index corner : fan) removed[corner / 3] = 1;
    found = true;
  }
  return found;
}

/// Removes connected parts for whose lowest vertices that holds. @param parts see parts_of @return how many
template <typename Goes>
std::size_t drop_parts(PolyMesh& mesh, const std::vector<Index>& parts, const Goes& goes) {
  std::size_t count = 0;
  for (Index v = 0; v < parts.size(); ++v) count += parts[v] == v && goes(v) ? 1U : 0U;
  if (count == 0) return 0;
  std::vector<std::uint8_t> removed(mesh.face_count(), 0);
  for (std::size_t f = 0; f < removed.size(); ++f) removed[f] = goes(parts[mesh.corners[3 * f]]) ? 1 : 0;
  mesh = without(mesh, removed);
  return count;
}

/// Of every point the nearest vertex; none without any.
std::vector<Index> nearest_vertices(const PolyMesh& mesh, std::span<const Vec3> points, int threads,
                                    Progress& progress) {
  Progress ordering = progress.step("look for lost detail", 0.3);
  const implicit::PointTree tree(mesh.positions, threads, ordering);
  Progress looking = progress.step("look for lost detail", 0.7);
  std::vector<Index> nearest(points.size());
  for_each_part(points.size(), vertices_per_part, threads, looking, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) nearest[i] = tree.nearest(points[i]);
  });
  return nearest;
}

}  // namespace

std::vector<std::array<Vec3, 3>> places_of(const PolyMesh& mesh) {
  std::vector<std::array<Vec3, 3>> triangles;
  triangles.reserve(mesh.face_count());
  for (std::size_t f = 0; f < mesh.face_count(); ++f) triangles.push_back(places_of(mesh.positions, mesh.face(f)));
  return triangles;
}

void set_triangle_offsets(PolyMesh& mesh) {
  mesh.face_offsets.reserve(mesh.corners.size() / 3 + 1);
  while (mesh.face_offsets.back() < mesh.corners.size()) mesh.face_offsets.push_back(mesh.face_offsets.back() + 3);
}

std::vector<Index> parts_of(const PolyMesh& mesh) {
  DisjointSets sets(mesh.vertex_count());
  for (std::size_t c = 0; c < mesh.corners.size(); c += 3) {
    sets.unite(mesh.corners[c], mesh.corners[c + 1]);
    sets.unite(mesh.corners[c], mesh.corners[c + 2]);
  }
  return sets.take_roots();
}

std::size_t part_count(const PolyMesh& mesh) {
  const std::vector<Index> parts = parts_of(mesh);
  std::vector<std::uint8_t> used(parts.size(), 0);
  for (const Index v : mesh.corners) used[parts[v]] = 1;
  return static_cast<std::size_t>(std::ranges::count(used, 1));
}

PolyMesh without(const PolyMesh& mesh, std::span<const std::uint8_t> removed) {
  std::vector<Index> number(mesh.vertex_count(), no_index);
  for (std::size_t c = 0; c < mesh.corners.size(); ++c)
    if (removed[c / 3] == 0) number[mesh.corners[c]] = 0;
  PolyMesh kept;
  for (std::size_t v = 0; v < number.size(); ++v) {
    if (number[v] == no_index) continue;
    number[v] = static_cast<Index>(kept.positions.size());
    kept.positions.push_back(mesh.positions[v]);
  }
  for (std::size_t c = 0; c < mesh.corners.size(); ++c)
    if (removed[c / 3] == 0) kept.corners.push_back(number[mesh.corners[c]]);
  set_triangle_offsets(kept);
  return kept;
}

PolyMesh sound_without(const PolyMesh& mesh, std::vector<std::uint8_t> removed) {
  PolyMesh kept = without(mesh, removed);
  for (int round = 0;; ++round) {
    removed.assign(kept.face_count(), 0);
    if (!mark_invalid(kept, round < ear_rounds, removed)) return kept;
    kept = without(kept, removed);
  }
}

PolyMesh trimmed(const PolyMesh& mesh, std::span<const std::uint8_t> beyond) {
  std::vector<std::uint8_t> removed(mesh.face_count(), 0);
  for (std::size_t c = 0; c < mesh.corners.size(); ++c)
    if (beyond[mesh.corners[c]] != 0) removed[c / 3] = 1;
  return sound_without(mesh, std::move(removed));
}

std::vector<Index> far_points(const PolyMesh& mesh, std::span<const Vec3> points, double distance, int threads,
                              Progress progress) {
  const std::vector<Index> nearest = nearest_vertices(mesh, points, threads, progress);
  std::vector<Index> far;
  for (Index i = 0; i < nearest.size(); ++i)
    if (nearest[i] == no_index || (points[i] - mesh.positions[nearest[i]]).squaredNorm() > distance * distance)
      far.push_back(i);
  return far;
}

std::vector<Index> lost_points(const PolyMesh& surface, std::span<const Vec3> points, double cell, int threads,
                               Progress progress) {
  return far_points(surface, points, lost_beyond * cell, threads, std::move(progress));
}

bool are_few(std::size_t lost, std::size_t points) {
  return static_cast<double>(lost) <= few_lost * static_cast<double>(points);
}

void drop_small(PolyMesh& mesh, double size) {
  const std::vector<Index> parts = parts_of(mesh);
  std::vector<Eigen::AlignedBox3d> boxes(parts.size());
  for (Index v = 0; v < parts.size(); ++v) boxes[parts[v]].extend(mesh.positions[v]);
  drop_parts(mesh, parts, [&](Index part) { return boxes[part].diagonal().norm() < size; });
}

std::size_t drop_detached(PolyMesh& mesh, std::span<const Vec3> points, int threads, Progress progress) {
  const std::vector<Index> parts = parts_of(mesh);
  std::vector<std::size_t> sizes(parts.size(), 0), votes(parts.size(), 0);
  for (const Index part : parts) ++sizes[part];
  if (sizes.empty() || sizes[parts.front()] == parts.size()) return 0;
  for (const Index vertex : nearest_vertices(mesh, points, threads, progress)) ++votes[parts[vertex]];
  return drop_parts(mesh, parts, [&](Index part) { return votes[part] * vertices_per_vote < sizes[part]; });
}

}  // namespace croquis::remeshing

// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/remeshing/remesh_trimming.h"

#include <algorithm>
#include <utility>

#include "algorithms/remeshing/vertices_per_part.h"
#include "croquis/base/parallel.h"
#include "croquis/geometry/disjoint_sets.h"

namespace croquis::remeshing {
namespace {

using namespace hole_filling;

constexpr double far_from_data = 1.5;          // × cell or mean edge, whichever is longer
constexpr double reach_over_rim = 0.5;         // × cell
constexpr int ear_rounds = 2;                  // borders get straighter; more would remove narrow sheets
constexpr std::size_t vertices_per_vote = 20;  // a part with fewer points per vertex is not backed by data

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

}  // namespace

OpenBorders::OpenBorders(const RemeshPiece& piece, const RemeshPoints& points, const std::vector<RimPlace>& rims,
                         std::vector<implicit::Box> holes, double cell, double edge, int threads)
    : points_(points),
      tree_(points.positions, threads),
      rim_of_(points.positions.size(), no_index),
      holes_(std::move(holes)),
      far_(far_from_data * std::max(cell, edge)),
      over_(reach_over_rim * cell) {
  for (const RimPlace& rim : rims) {
    const auto found = std::lower_bound(piece.vertices.begin(), piece.vertices.end(), rim.vertex);
    const bool ends = rim.fate >= RimFate::Left;
    if (!ends || found == piece.vertices.end() || *found != rim.vertex) continue;
    rim_of_[static_cast<std::size_t>(found - piece.vertices.begin())] = static_cast<Index>(outwards_.size());
    outwards_.push_back(rim.outwards);
  }
}

bool OpenBorders::is_beyond(const Vec3& place) const {
  const Index nearest = tree_.nearest(place);
  const Vec3 away = place - points_.positions[nearest];
  const Index rim = rim_of_[nearest];
  if (rim != no_index && away.dot(outwards_[rim]) > over_) return true;
  if (away.squaredNorm() <= far_ * far_) return false;
  return std::none_of(holes_.begin(), holes_.end(), [&](const implicit::Box& box) { return box.contains(place); });
}

std::vector<Index> parts_of(const PolyMesh& mesh) {
  DisjointSets sets(mesh.vertex_count());
  for (std::size_t c = 0; c < mesh.corners.size(); c += 3) {
    sets.unite(mesh.corners[c], mesh.corners[c + 1]);
    sets.unite(mesh.corners[c], mesh.corners[c + 2]);
  }
  std::vector<Index> parts(mesh.vertex_count());
  for (Index v = 0; v < parts.size(); ++v) parts[v] = sets.root(v);
  return parts;
}

std::size_t part_count(const PolyMesh& mesh) {
  const std::vector<Index> parts = parts_of(mesh);
  std::vector<std::uint8_t> used(parts.size(), 0);
  for (const Index v : mesh.corners) used[parts[v]] = 1;
  return static_cast<std::size_t>(std::count(used.begin(), used.end(), 1));
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
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    if (removed[f] != 0) continue;
    const auto face = mesh.face(f);
    kept.add_triangle(number[face[0]], number[face[1]], number[face[2]]);
  }
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
                              Progress& progress) {
  std::vector<std::uint8_t> is_far(points.size(), 1);
  Progress ordering = progress.step("look for lost detail", 0.3);
  const implicit::PointTree tree(mesh.positions, threads, ordering);
  Progress looking = progress.step("look for lost detail", 0.7);
  for_each_part(points.size(), vertices_per_part, threads, looking, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end && tree.size() > 0; ++i) {
      const Vec3 away = points[i] - mesh.positions[tree.nearest(points[i])];
      is_far[i] = away.squaredNorm() > distance * distance ? 1 : 0;
    }
  });
  std::vector<Index> far;
  for (Index i = 0; i < is_far.size(); ++i)
    if (is_far[i] != 0) far.push_back(i);
  return far;
}

std::size_t drop_strays(PolyMesh& mesh, std::span<const Vec3> points, int threads, Progress& progress,
                        std::vector<Vec3>* other) {
  const std::vector<Index> parts = parts_of(mesh);
  std::vector<std::size_t> sizes(mesh.vertex_count(), 0), votes(mesh.vertex_count(), 0);
  for (const Index part : parts) ++sizes[part];
  if (sizes.empty() || sizes[parts.front()] == mesh.vertex_count()) return 0;
  const implicit::PointTree tree(mesh.positions);
  std::vector<Index> nearest(points.size());
  for_each_part(points.size(), vertices_per_part, threads, progress, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) nearest[i] = tree.nearest(points[i]);
  });
  for (const Index vertex : nearest) ++votes[parts[vertex]];
  const auto is_stray = [&](Index part) { return votes[part] * vertices_per_vote < sizes[part]; };
  std::vector<std::uint8_t> removed(mesh.face_count(), 0);
  for (std::size_t f = 0; f < removed.size(); ++f) removed[f] = is_stray(parts[mesh.corners[3 * f]]) ? 1 : 0;
  std::size_t strays = 0;
  for (Index v = 0; v < parts.size(); ++v) strays += parts[v] == v && is_stray(v) ? 1U : 0U;
  if (strays == 0) return 0;
  if (other != nullptr) {
    std::swap(mesh.positions, *other);
    std::vector<Vec3> kept = without(mesh, removed).positions;
    mesh.positions = std::exchange(*other, std::move(kept));
  }
  mesh = without(mesh, removed);
  return strays;
}

}  // namespace croquis::remeshing

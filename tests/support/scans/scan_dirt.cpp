// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "croquis/geometry/disjoint_sets.h"
#include "croquis/geometry/mesh_topology.h"
#include "support/meshes/mesh_shapes.h"
#include "support/meshes/surface_distance.h"
#include "support/scans/scan_damage.h"
#include "support/scans/scan_draft.h"
#include "support/scans/triangle_measures.h"
#include "support/scans/virtual_scans.h"

namespace croquis::test {
namespace {

/// Takes views apart from each other and moves each.
void move_views(PolyMesh& mesh, const std::vector<Index>& labels, const std::vector<Eigen::Affine3d>& moves) {
  const std::vector<Index> view_of = split_between(mesh, labels);
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
    if (view_of[v] != no_index) mesh.positions[v] = moves[view_of[v]] * mesh.positions[v];
  }
}

}  // namespace

void misplace_views(ScanDraft& draft, const std::vector<Index>& number) {
  PolyMesh& mesh = draft.scan.mesh;
  const double edge = mean_edge_of(mesh);
  std::vector<Index> labels(mesh.face_count());
  for (std::size_t f = 0; f < number.size(); ++f) {
    if (number[f] != no_index) labels[number[f]] = draft.labels[f];
  }
  PolyMesh overlaps;
  overlaps.positions = mesh.positions;
  std::vector<Index> all_labels = labels;
  const Index views = *std::max_element(draft.labels.begin(), draft.labels.end()) + 1;
  for (Index view = 0; view < views; ++view) {
    std::vector<bool> is_own(mesh.face_count());
    for (std::size_t f = 0; f < labels.size(); ++f) is_own[f] = labels[f] == view;
    for (int ring = 0; ring < draft.overlap_rings; ++ring) {
      std::vector<bool> is_reached(mesh.vertex_count(), false);
      for (std::size_t f = 0; f < labels.size(); ++f) {
        if (is_own[f]) std::ranges::for_each(mesh.face(f), [&](Index v) { is_reached[v] = true; });
      }
      for (std::size_t f = 0; f < labels.size(); ++f) {
        if (is_own[f] || std::ranges::none_of(mesh.face(f), [&](Index v) { return is_reached[v]; })) continue;
        is_own[f] = true;
        overlaps.add_face(mesh.face(f));
        all_labels.push_back(view);
      }
    }
  }
  for (std::size_t f = 0; f < overlaps.face_count(); ++f) mesh.add_face(overlaps.face(f));
  std::vector<Eigen::Affine3d> moves;
  for (Index view = 0; view < views; ++view) {
    const auto vary = [&] { return draft.random.between(-1, 1); };
    const Vec3 shift = 0.4 * edge * Vec3(vary(), vary(), vary());
    const Vec3 axis = Vec3(vary(), vary(), vary()).normalized();
    moves.push_back(Eigen::Translation3d(shift) * Eigen::AngleAxisd(0.4 * edge * vary(), axis));
  }
  move_views(mesh, all_labels, moves);
  move_views(draft.surface, draft.labels, moves);
}

std::vector<Index> sides_of(const PolyMesh& mesh) {
  constexpr double cosine = 0.906;
  const MeshTopology topology(mesh);
  DisjointSets sets(mesh.face_count());
  for (Index corner = 0; corner < topology.corner_count(); ++corner) {
    const Index other = topology.opposite(corner);
    if (other == no_index) continue;
    const Index a = topology.face(corner), b = topology.face(other);
    if (normal_of_triangle(mesh, a).dot(normal_of_triangle(mesh, b)) > cosine) sets.unite(a, b);
  }
  std::vector<Index> sides;
  sets.number(sides);
  return sides;
}

void make_dirty(ScanDraft& draft) {
  KnownScan& scan = draft.scan;
  Random& random = draft.random;
  switch (draft.kind) {
    case ScanKind::Photogrammetry: {
      const double far = 2.5 * mean_edge_of(scan.mesh);
      const SurfaceDistance to_truth(scan.truth);
      add_lumps(scan.mesh, random, random.between(0.05, 0.3));
      const double share = random.between(0.02, 0.2);
      for (KnownHole& hole : scan.holes) {
        if (hole.kind != HoleKind::Pinhole)
          scan.stray_triangles += add_stray_triangles(scan.mesh, random, hole.rim, share);
      }
      scan.fins = random.below(4);
      add_fins(scan.mesh, random, scan.fins);
      scan.floating_pieces = 1 + random.below(20);
      add_floating_pieces(scan.mesh, random, scan.floating_pieces,
                          [&](const Vec3& p) { return to_truth(p) > far && draft.solid(p) > 0; });
      break;
    }
    case ScanKind::RangeView:
      add_depth_noise(scan.mesh, random, draft.view, mean_edge_of(scan.mesh) * random.between(0.02, 0.15));
      break;
    case ScanKind::Part: add_lumps(scan.mesh, random, random.between(0, 0.02)); break;
    case ScanKind::RangeViews: add_lumps(scan.mesh, random, random.between(0.02, 0.15)); break;
    default:
      if (random.unit() < 0.5) add_lumps(scan.mesh, random, random.between(0.01, 0.1));
  }
}

void place_anywhere(ScanDraft& draft) {
  Random& random = draft.random;
  const auto vary = [&] { return random.between(-1, 1); };
  const Vec3 axis = Vec3(vary(), vary(), vary()).normalized();
  const double size = std::pow(10, random.between(-2, 3));
  const Vec3 away = 5 * size * Vec3(vary(), vary(), vary());
  const double angle = random.between(0, 2 * std::numbers::pi);
  const Eigen::Affine3d move = Eigen::Translation3d(away) * Eigen::AngleAxisd(angle, axis) * Eigen::Scaling(size);
  draft.scan.truth = transformed(std::move(draft.scan.truth), move);
  draft.scan.mesh = transformed(std::move(draft.scan.mesh), move);
  for (KnownHole& hole : draft.scan.holes) {
    for (Vec3& p : hole.places) p = move * p;
  }
}

}  // namespace croquis::test

// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <span>
#include <utility>

#include "croquis/geometry/disjoint_sets.h"
#include "croquis/geometry/mesh_topology.h"
#include "support/scans/scan_draft.h"
#include "support/scans/triangle_measures.h"
#include "support/scans/virtual_scans.h"
#include "support/scans/waves.h"

namespace croquis::test {
namespace {

/// The faces for which it is so, in pieces joined across edges, the largest first; each ascending.
std::vector<std::vector<Index>> pieces_where(const PolyMesh& mesh, const std::vector<bool>& is_in) {
  const MeshTopology topology(mesh);
  DisjointSets sets(mesh.face_count());
  for (Index edge = 0; edge < topology.edge_count(); ++edge) {
    const auto corners = topology.edge_corners(edge);
    const Index face = topology.face(corners[0]);
    for (const Index corner : corners) {
      if (is_in[face] && is_in[topology.face(corner)]) sets.unite(face, topology.face(corner));
    }
  }
  std::map<Index, std::vector<Index>> by_root;
  for (Index f = 0; f < mesh.face_count(); ++f) {
    if (is_in[f]) by_root[sets.root(f)].push_back(f);
  }
  std::vector<std::vector<Index>> pieces;
  for (auto& [root, faces] : by_root) pieces.push_back(std::move(faces));
  std::stable_sort(pieces.begin(), pieces.end(), [](const auto& a, const auto& b) { return a.size() > b.size(); });
  return pieces;
}

/// Brings the vertices that the faces have in common with others to the height.
void flatten_rim(PolyMesh& mesh, const std::vector<Index>& faces, double height) {
  std::vector<bool> is_gone(mesh.face_count(), false), is_kept(mesh.vertex_count(), false);
  for (const Index f : faces) is_gone[f] = true;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    if (!is_gone[f]) std::ranges::for_each(mesh.face(f), [&](Index v) { is_kept[v] = true; });
  }
  for (const Index f : faces) {
    for (const Index v : mesh.face(f)) {
      if (is_kept[v]) mesh.positions[v].z() = height;
    }
  }
}

void open_base(ScanDraft& draft, HoleCutter& cutter) {
  const double edge = mean_edge_of(draft.surface);
  std::vector<bool> is_base(draft.surface.face_count());
  for (std::size_t f = 0; f < is_base.size(); ++f) {
    const auto t = draft.surface.face(f);
    is_base[f] =
        std::ranges::all_of(t, [&](Index v) { return draft.surface.positions[v].z() < base_height + 0.3 * edge; });
  }
  for (auto& piece : pieces_where(draft.surface, is_base)) {
    if (piece.size() < 20) continue;
    flatten_rim(draft.surface, piece, base_height);
    flatten_rim(draft.scan.truth, piece, base_height);
    cutter.remove(HoleKind::Opening, std::move(piece));
  }
}

/// Everything behind a wavy surface across the head, and half of the time all below the neck.
void open_back(ScanDraft& draft, HoleCutter& cutter) {
  Random& random = draft.random;
  const Vec3 behind = Vec3(-1, random.between(-0.3, 0.3), random.between(-0.4, 0.4)).normalized();
  const double from = random.between(0.1, 0.5), ragged = random.between(0, 0.06);
  const double neck = random.unit() < 0.5 ? random.between(-1.1, -0.7) : -10;
  const Waves waves(random, 0.5, 4);
  std::vector<bool> is_gone(draft.surface.face_count());
  for (std::size_t f = 0; f < is_gone.size(); ++f) {
    const Vec3 p = centre_of_triangle(draft.surface, f);
    is_gone[f] = p.dot(behind) > from + ragged * waves.at(p) || p.z() < neck;
  }
  auto pieces = pieces_where(draft.surface, is_gone);
  if (!pieces.empty()) cutter.remove(HoleKind::Opening, std::move(pieces[0]));
}

/// What isn't seen from outside: per connected piece of six faces at least, the largest counting as an opening.
void lose_occluded(ScanDraft& draft, HoleCutter& cutter, std::span<const Vec3> directions, bool has_opening) {
  auto removed = seen_from(draft.surface, directions).removed;
  std::stable_sort(removed.begin(), removed.end(), [](const auto& a, const auto& b) { return a.size() > b.size(); });
  for (std::size_t i = 0; i < removed.size(); ++i)
    cutter.remove(has_opening && i == 0 ? HoleKind::Opening : HoleKind::Occluded, std::move(removed[i]));
}

void open_pot(ScanDraft& draft, HoleCutter& cutter) {
  Random& random = draft.random;
  if (random.unit() < 0.3) {  // the lip is lost: both skins end there
    double top = -10;
    for (const Vec3& p : draft.surface.positions) top = std::max(top, p.z());
    const double below = top - random.between(0.08, 0.2);
    std::vector<bool> is_gone(draft.surface.face_count());
    for (std::size_t f = 0; f < is_gone.size(); ++f) is_gone[f] = centre_of_triangle(draft.surface, f).z() > below;
    auto pieces = pieces_where(draft.surface, is_gone);
    cutter.remove(HoleKind::Opening, std::move(pieces[0]));
    return;
  }
  std::vector<Vec3> directions = directions_around(random, 6, 0.5, 1.1);
  for (const Vec3& d : directions_around(random, 4, -0.6, 0)) directions.push_back(d);
  directions.push_back(-Vec3::UnitZ());
  lose_occluded(draft, cutter, directions, true);
}

/// Per face of a thing around the origin the view that it shows itself to best: of normal and place, and evened out by
/// the majority of neighbours, so that views have few and smooth borders.
std::vector<Index> best_views(const PolyMesh& mesh, const std::vector<Vec3>& directions) {
  constexpr int rounds = 10;
  std::vector<Index> labels(mesh.face_count(), 0);
  for (std::size_t f = 0; f < labels.size(); ++f) {
    const Vec3 shown = normal_of_triangle(mesh, f) + centre_of_triangle(mesh, f);
    for (Index i = 1; i < directions.size(); ++i) {
      if (shown.dot(directions[i]) > shown.dot(directions[labels[f]])) labels[f] = i;
    }
  }
  const MeshTopology topology(mesh);
  for (int round = 0; round < rounds; ++round) {
    const std::vector<Index> before = labels;
    for (Index f = 0; f < labels.size(); ++f) {
      std::array<Index, 3> around{};
      for (Index i = 0; i < 3; ++i) {
        const Index other = topology.opposite(3 * f + i);
        around[i] = other == no_index ? before[f] : before[topology.face(other)];
      }
      for (Index i = 0; i < 3; ++i) {
        if (around[i] == around[(i + 1) % 3]) labels[f] = around[i];
      }
    }
  }
  return labels;
}

/// The faces at vertices that several views have.
std::vector<bool> faces_between(const PolyMesh& mesh, const std::vector<Index>& labels) {
  std::vector<Index> label_of(mesh.vertex_count(), no_index);
  std::vector<bool> is_between(mesh.vertex_count(), false);
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    for (const Index v : mesh.face(f)) {
      if (label_of[v] == no_index) label_of[v] = labels[f];
      if (label_of[v] != labels[f]) is_between[v] = true;
    }
  }
  std::vector<bool> result(mesh.face_count());
  for (std::size_t f = 0; f < mesh.face_count(); ++f)
    result[f] = std::ranges::any_of(mesh.face(f), [&](Index v) { return is_between[v]; });
  return result;
}

/// Every face belongs to one view. Between views a row of faces is missing, or they overlap.
void divide_into_views(ScanDraft& draft, HoleCutter& cutter) {
  Random& random = draft.random;
  std::vector<Vec3> directions = directions_around(random, 3 + random.below(4), -0.4, 0.7);
  if (random.unit() < 0.5) directions.push_back(Vec3::UnitZ());
  draft.labels = best_views(draft.surface, directions);
  lose_occluded(draft, cutter, directions, false);
  if (random.unit() < 0.5) {
    draft.overlap_rings = 1 + static_cast<int>(random.below(4));
    return;
  }
  std::vector<bool> is_gap = faces_between(draft.surface, draft.labels);
  for (const HoleCut& cut : cutter.cuts()) {
    for (const Index f : cut.faces) is_gap[f] = false;
  }
  for (auto& piece : pieces_where(draft.surface, is_gap)) cutter.remove(HoleKind::Gap, std::move(piece));
}

}  // namespace

std::vector<Vec3> directions_around(Random& random, std::size_t count, double low, double high) {
  std::vector<Vec3> directions;
  const double begin = random.unit();
  for (std::size_t i = 0; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * (begin + static_cast<double>(i) / static_cast<double>(count));
    const double height = random.between(low, high);
    directions.emplace_back(std::cos(angle) * std::cos(height), std::sin(angle) * std::cos(height), std::sin(height));
  }
  return directions;
}

void lose_parts(ScanDraft& draft, HoleCutter& cutter) {
  switch (draft.kind) {
    case ScanKind::Statue: open_base(draft, cutter); break;
    case ScanKind::Face: open_back(draft, cutter); break;
    case ScanKind::Pot: open_pot(draft, cutter); break;
    case ScanKind::RangeViews: divide_into_views(draft, cutter); break;
    case ScanKind::Bones:
      if (draft.random.unit() < 0.3) lose_occluded(draft, cutter, directions_around(draft.random, 8, -0.7, 0.9), false);
      break;
    default: break;
  }
}

}  // namespace croquis::test

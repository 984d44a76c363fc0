// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/scans/known_scans.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <span>
#include <utility>

#include "croquis/geometry/mesh_topology.h"
#include "support/meshes/surface_distance.h"
#include "support/random.h"
#include "support/scans/random_solids.h"
#include "support/scans/scan_damage.h"
#include "support/scans/scan_draft.h"
#include "support/scans/sculptures.h"
#include "support/scans/triangle_measures.h"
#include "support/scans/uneven_density.h"
#include "support/scans/virtual_scans.h"

namespace croquis::test {
namespace {

constexpr std::size_t places_per_hole = 400;
using Solid = std::function<double(const Vec3&)>;

/// Thin walls, spikes and bars are lost with fewer triangles.
std::size_t least_triangles(SolidKind kind) {
  switch (kind) {
    case SolidKind::Pot: return 25000;
    case SolidKind::Bones: return 30000;
    case SolidKind::Thorns: return 12000;
    default: return 5000;
  }
}

/// Mostly near the least.
std::size_t size_by(Random& random, std::size_t least) {
  const double share = random.unit(), low = static_cast<double>(least);
  return static_cast<std::size_t>(low * std::pow(200000 / low, share * share));
}

SolidKind solid_of(ScanKind kind, Random& random) {
  const auto one_of = [&](std::initializer_list<SolidKind> kinds) {
    return kinds.begin()[random.below(static_cast<Index>(kinds.size()))];
  };
  switch (kind) {
    case ScanKind::Photogrammetry:
      return one_of({SolidKind::Blob, SolidKind::Figure, SolidKind::Face, SolidKind::Thorns});
    case ScanKind::RangeView:
    case ScanKind::RangeViews:
      return one_of({SolidKind::Blob, SolidKind::Figure, SolidKind::Face, SolidKind::Pot, SolidKind::Bones});
    case ScanKind::Statue: return SolidKind::Figure;
    case ScanKind::Pot: return SolidKind::Pot;
    case ScanKind::Face: return SolidKind::Face;
    case ScanKind::Part: return SolidKind::Part;
    case ScanKind::Thorns: return SolidKind::Thorns;
    case ScanKind::Bones: return SolidKind::Bones;
  }
  return SolidKind::Blob;
}

Solid solid_for(SolidKind what, Random& random) {
  const Solid whole = random_solid(what, random.bits());
  if (what != SolidKind::Figure) return whole;
  return [whole](const Vec3& p) { return std::max(whole(p), base_height - p.z()); };
}

PolyMesh truth_of(ScanDraft& draft, std::size_t triangles) {
  if (draft.kind != ScanKind::Photogrammetry) return sculpt(draft.solid, triangles, draft.kind == ScanKind::Part);
  const double ratio = draft.random.between(4, 30);
  const PolyMesh coarse =
      sculpt(draft.solid, static_cast<std::size_t>(static_cast<double>(triangles) / std::pow(ratio, 0.6)));
  return with_uneven_density(coarse, draft.solid, draft.random.bits(), triangles, ratio);
}

/// The holes that a scan gets, those first that need most room.
std::vector<HoleKind> plan_of(ScanKind kind, Random& random) {
  std::vector<HoleKind> plan;
  const auto add = [&](HoleKind hole, double count) {
    for (; random.unit() < count; --count) plan.push_back(hole);
  };
  add(HoleKind::Huge, 0.4);
  add(HoleKind::Bent, kind == ScanKind::Bones ? 1.5 : 0.1);
  add(HoleKind::Islands, 0.6);
  add(HoleKind::Large, 1);
  const bool has_walls = kind == ScanKind::Pot || kind == ScanKind::Thorns;
  add(HoleKind::BothSkins, has_walls ? 1.5 : 0.1);
  add(HoleKind::Crease, kind == ScanKind::Part ? 4 : kind == ScanKind::Thorns ? 2 : 0.5);
  add(HoleKind::Near, 0.5);
  add(HoleKind::Middle, 2);
  add(HoleKind::Small, 2);
  add(HoleKind::Pinhole, kind == ScanKind::Photogrammetry ? 3 : 0.1);
  return plan;
}

// The mesh of what is left.

/// For every face of the surface its number in the mesh, or none.
std::vector<Index> take_kept_faces(ScanDraft& draft, const std::vector<HoleCut>& cuts) {
  std::vector<Index> number(draft.surface.face_count(), 0);
  for (const HoleCut& cut : cuts) {
    for (const Index f : cut.faces) number[f] = no_index;
  }
  Index count = 0;
  draft.scan.mesh.positions = draft.surface.positions;
  for (Index f = 0; f < number.size(); ++f) {
    if (number[f] == no_index) continue;
    number[f] = count++;
    draft.scan.mesh.add_face(draft.surface.face(f));
  }
  return number;
}

/// Rims as they are before views are taken apart.
void find_rims(ScanDraft& draft, const std::vector<HoleCut>& cuts, const std::vector<Index>& number) {
  const MeshTopology topology(draft.surface);
  for (const HoleCut& cut : cuts) {
    KnownHole& hole = draft.scan.holes.emplace_back();
    hole.kind = cut.kind;
    for (const Index f : cut.faces) {
      for (Index corner = 3 * f; corner < 3 * f + 3; ++corner) {
        const Index other = topology.opposite(corner);
        if (other == no_index || number[topology.face(other)] == no_index) continue;
        hole.rim.push_back(3 * number[topology.face(other)] + other % 3);
      }
    }
  }
}

void find_places(ScanDraft& draft, const std::vector<HoleCut>& cuts) {
  for (std::size_t i = 0; i < cuts.size(); ++i)
    draft.scan.holes[i].places = sample_faces(draft.surface, cuts[i].faces, places_per_hole);
  std::erase_if(draft.scan.holes, [](const KnownHole& hole) { return hole.rim.empty(); });  // within others
}

void look_once(ScanDraft& draft, std::size_t triangles) {
  const Vec3 towards = directions_around(draft.random, 1, -0.3, 0.6)[0];
  double area = 0;
  for (std::size_t f = 0; f < draft.scan.truth.face_count(); ++f) area += area_of_triangle(draft.scan.truth, f);
  const double spacing = std::sqrt(0.5 * area / static_cast<double>(triangles));  // a view shows a quarter of the area
  draft.view = towards;
  draft.surface = without_loose_vertices(range_images(draft.scan.truth, std::span(&towards, 1), spacing));
}

}  // namespace

const char* name_of(ScanKind kind) {
  constexpr std::array names = {"photogrammetry", "range view", "range views", "statue", "pot",
                                "face",           "part",       "thorns",      "bones"};
  return names[static_cast<std::size_t>(kind)];
}

KnownScan known_scan(ScanKind kind, std::uint64_t seed, std::size_t triangles) {
  ScanDraft draft{kind, Random(seed * 104729 + static_cast<std::uint64_t>(kind)), {}, {}, {}, {}, 0, Vec3::UnitZ()};
  Random& random = draft.random;
  const SolidKind what = solid_of(kind, random);
  const std::size_t least =
      kind == ScanKind::RangeViews ? std::max<std::size_t>(least_triangles(what), 12000) : least_triangles(what);
  const std::size_t chosen = size_by(random, least);
  triangles = triangles == 0 ? chosen : std::max(triangles, least);
  draft.solid = solid_for(what, random);
  KnownScan& scan = draft.scan;
  scan.truth = truth_of(draft, triangles);
  scan.diagonal = diagonal_of(scan.truth);
  draft.surface = scan.truth;
  if (kind == ScanKind::RangeView) look_once(draft, triangles);

  HoleCutter cutter(draft.surface, random.bits());
  lose_parts(draft, cutter);
  for (const HoleKind hole : plan_of(kind, random)) cutter.cut(hole);
  const std::vector<Index> number = take_kept_faces(draft, cutter.cuts());
  find_rims(draft, cutter.cuts(), number);
  if (kind == ScanKind::RangeViews) misplace_views(draft, number);
  find_places(draft, cutter.cuts());

  scan.has_seams = kind == ScanKind::Part && random.unit() < 0.5;
  make_dirty(draft);
  if (scan.has_seams) split_between(scan.mesh, sides_of(scan.mesh));
  place_anywhere(draft);
  scan.mesh = without_loose_vertices(scan.mesh);
  if (scan.has_seams) {
    std::vector<bool> is_moved;
    for (std::size_t v = 0; v < scan.mesh.vertex_count(); ++v) is_moved.push_back(random.unit() < 0.5);
    misplace_last_bits(scan.mesh, random, is_moved);
  }
  scan.diagonal = diagonal_of(scan.truth);
  return std::move(draft.scan);
}

}  // namespace croquis::test

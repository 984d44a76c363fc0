// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <set>
#include <vector>

#include <catch2/catch.hpp>

#include "croquis/geometry/mesh_topology.h"
#include "support/meshes/surface_distance.h"
#include "support/scans/known_scans.h"
#include "support/scans/random_solids.h"
#include "support/scans/sculptures.h"
#include "support/scans/virtual_scans.h"

using namespace croquis;
using namespace croquis::test;

namespace {

constexpr std::size_t small_scan = 8000;

/// No edge of any number of faces but two, no vertex of several fans.
bool is_closed_and_manifold(const PolyMesh& mesh) {
  const MeshTopology topology(mesh);
  for (Index v = 0; v < topology.vertex_count(); ++v) {
    if (!topology.is_manifold(v)) return false;
  }
  return topology.boundary_loops().size() == 0;
}

/// The edges from corners that more than one face has.
std::size_t closed_edges(const PolyMesh& mesh, const std::vector<Index>& corners) {
  const MeshTopology topology(mesh);
  return static_cast<std::size_t>(std::ranges::count_if(
      corners, [&](Index corner) { return topology.edge_corners(topology.edge(corner)).size() != 1; }));
}

}  // namespace

TEST_CASE("things that are scanned are closed and manifold, and another one for every seed") {
  for (const SolidKind kind : all_solid_kinds) {
    std::set<std::size_t> sizes;
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
      CAPTURE(name_of(kind), seed);
      constexpr std::size_t wanted = 25000;
      const PolyMesh mesh = sculpt(random_solid(kind, seed), wanted, kind == SolidKind::Part);
      CHECK(is_closed_and_manifold(mesh));
      CHECK(static_cast<double>(mesh.face_count()) > 0.8 * wanted);
      CHECK(static_cast<double>(mesh.face_count()) < 1.2 * wanted);
      sizes.insert(mesh.face_count());
    }
    CHECK(sizes.size() > 2);
  }
}

TEST_CASE("what was scanned is known: a closed thing, and holes whose rims are open and lie around what is missing") {
  for (const ScanKind kind : all_scan_kinds) {
    for (std::uint64_t seed = 1; seed <= 2; ++seed) {
      CAPTURE(name_of(kind), seed);
      const KnownScan scan = known_scan(kind, seed, small_scan);
      CHECK(is_closed_and_manifold(scan.truth));
      CHECK(scan.holes.size() > 1);
      CHECK(validate(scan.mesh).empty());
      const SurfaceDistance truth(scan.truth);
      const double edge = mean_edge_of(scan.mesh);
      for (const KnownHole& hole : scan.holes) {
        CAPTURE(name_of(hole.kind));
        REQUIRE_FALSE(hole.rim.empty());
        REQUIRE_FALSE(hole.places.empty());
        CHECK(closed_edges(scan.mesh, hole.rim) == 0);
        for (const Vec3& p : hole.places) CHECK(truth(p) < 2 * edge);  // views are out of place
      }
    }
  }
}

TEST_CASE("a seed gives the same scan every time, and other seeds other ones") {
  for (const ScanKind kind : all_scan_kinds) {
    const KnownScan one = known_scan(kind, 2, 6000), again = known_scan(kind, 2, 6000);
    const KnownScan other = known_scan(kind, 3, 6000);
    CHECK(one.mesh.positions == again.mesh.positions);
    CHECK(one.mesh.corners == again.mesh.corners);
    CHECK(one.mesh.positions != other.mesh.positions);
  }
}

TEST_CASE("over some seeds every kind of hole comes") {
  std::set<HoleKind> seen;
  for (const ScanKind kind : all_scan_kinds) {
    const std::uint64_t seeds = kind == ScanKind::RangeViews ? 7 : 2;  // every other one has gaps
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
      for (const KnownHole& hole : known_scan(kind, seed, small_scan).holes) seen.insert(hole.kind);
    }
  }
  for (const HoleKind kind : all_hole_kinds) {
    CAPTURE(name_of(kind));
    CHECK(seen.contains(kind));
  }
}

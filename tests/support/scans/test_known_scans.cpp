// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include <catch2/catch.hpp>

#include "croquis/geometry/mesh_topology.h"
#include "support/meshes/surface_distance.h"
#include "support/scans/known_scans.h"
#include "support/scans/random_solids.h"
#include "support/scans/scans.h"
#include "support/scans/sculptures.h"
#include "support/scans/triangle_measures.h"
#include "support/scans/uneven_density.h"
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

std::size_t count_of(const KnownScan& scan, HoleKind kind) {
  return static_cast<std::size_t>(
      std::ranges::count_if(scan.holes, [&](const KnownHole& hole) { return hole.kind == kind; }));
}

/// The greatest distance of two vertices of the rim.
double width_of(const KnownScan& scan, const KnownHole& hole) {
  double width = 0;
  for (const Index a : hole.rim) {
    for (const Index b : hole.rim) {
      const Vec3 across = scan.mesh.positions[scan.mesh.corners[a]] - scan.mesh.positions[scan.mesh.corners[b]];
      width = std::max(width, across.norm());
    }
  }
  return width;
}

/// Triangles per area around faces: the mean of each face and its neighbours.
std::vector<double> densities(const PolyMesh& mesh) {
  const MeshTopology topology(mesh);
  std::vector<double> result;
  for (Index f = 0; f < mesh.face_count(); ++f) {
    std::set<Index> around;
    for (const Index v : mesh.face(f)) {
      for (const Index corner : topology.vertex_corners(v)) around.insert(topology.face(corner));
    }
    double area = 0;
    for (const Index face : around) area += area_of_triangle(mesh, face);
    result.push_back(static_cast<double>(around.size()) / area);
  }
  std::sort(result.begin(), result.end());
  return result;
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

TEST_CASE("uneven density reaches the ratio told, on the surface, with the number of triangles told") {
  const auto solid = random_solid(SolidKind::Blob, 3);
  const PolyMesh even = sculpt(solid, 4000);
  const PolyMesh uneven = with_uneven_density(even, solid, 5, 24000, 30);
  CHECK(is_closed_and_manifold(uneven));
  CHECK(static_cast<double>(uneven.face_count()) == Approx(24000).epsilon(0.25));
  const std::vector<double> density = densities(uneven);
  const std::size_t few = density.size() / 100;
  CHECK(density[density.size() - few] / density[few] > 15);
  for (const Vec3& p : uneven.positions) CHECK(std::abs(solid(p)) < 2e-3);
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

TEST_CASE("scans by photogrammetry have pieces in the air, stray triangles, pinches and edges of three faces") {
  std::size_t pinches = 0, fins = 0, strays = 0;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    CAPTURE(seed);
    const KnownScan scan = known_scan(ScanKind::Photogrammetry, seed, small_scan);
    const MeshTopology topology(scan.mesh);
    std::size_t many = 0, several_fans = 0;
    for (Index edge = 0; edge < topology.edge_count(); ++edge) many += topology.edge_corners(edge).size() > 2;
    for (Index v = 0; v < topology.vertex_count(); ++v) several_fans += topology.fan_count(v) > 1;
    CHECK(many == scan.fins);
    CHECK(several_fans >= count_of(scan, HoleKind::Pinhole));
    CHECK(scan.floating_pieces > 0);
    CHECK(topology.component_count() >= scan.floating_pieces + 1);  // islands are pieces, too
    pinches += several_fans, fins += scan.fins, strays += scan.stray_triangles;
  }
  CHECK(pinches > 6);
  CHECK(fins > 2);
  CHECK(strays > 20);
}

TEST_CASE("statues are open at a flat base, heads at the back, both about 40 % of the diagonal wide") {
  for (const ScanKind kind : {ScanKind::Statue, ScanKind::Face}) {
    std::vector<double> widths;
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      const KnownScan scan = known_scan(kind, seed, small_scan);
      const auto hole = std::ranges::find(scan.holes, HoleKind::Opening, &KnownHole::kind);
      REQUIRE(hole != scan.holes.end());
      widths.push_back(width_of(scan, *hole) / scan.diagonal);
    }
    std::sort(widths.begin(), widths.end());
    CHECK(widths.front() > 0.2);
    CHECK(widths[2] > 0.3);
    CHECK(widths[2] < 0.6);
  }
}

TEST_CASE("sides of machined parts have seams that differ by the last bits alone") {
  std::size_t with_seams = 0;
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    const KnownScan scan = known_scan(ScanKind::Part, seed, small_scan);
    if (!scan.has_seams) continue;
    ++with_seams;
    std::vector<Vec3> sorted = scan.mesh.positions;
    std::ranges::sort(sorted, [](const Vec3& a, const Vec3& b) { return a.x() < b.x(); });
    std::size_t nearly = 0;
    for (std::size_t i = 0; i + 1 < sorted.size(); ++i) {
      const double distance = (sorted[i] - sorted[i + 1]).norm();
      if (distance == 0) continue;
      if (distance < 1e-14 * scan.diagonal) ++nearly;
    }
    CHECK(nearly > 20);
  }
  CHECK(with_seams > 1);
}

TEST_CASE("bones have rims of 300 edges and more bent around them") {
  std::size_t longest = 0;
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const KnownScan scan = known_scan(ScanKind::Bones, seed, 40000);
    for (const KnownHole& hole : scan.holes) {
      if (hole.kind == HoleKind::Bent) longest = std::max(longest, hole.rim.size());
    }
  }
  CHECK(longest >= 300);
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

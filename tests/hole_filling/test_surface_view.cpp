// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include <catch2/catch.hpp>

#include "algorithms/hole_filling/analysis/analysis_steps.h"
#include "croquis/base/error.h"
#include "croquis/geometry/mesh_report.h"
#include "croquis/geometry/mesh_topology.h"
#include "croquis/hole_filling/surface_view.h"
#include "support/meshes/mesh_shapes.h"
#include "support/random.h"
#include "support/scans/scans.h"

using namespace croquis;
using namespace croquis::test;
using namespace croquis::hole_filling;

namespace {

SurfaceView view_of(const PolyMesh& mesh, double weld_tolerance = usual_weld_tolerance) {
  Progress progress;
  return view_surface(mesh, progress, weld_tolerance);
}

/// The mesh with a seam where it crosses x = 0.1, whose right side is off by up to `noise`.
PolyMesh with_noisy_seam(const PolyMesh& mesh, std::uint64_t seed, double noise) {
  Random random(seed);
  PolyMesh cut = mesh;
  std::map<Index, Index> copies;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    double middle = 0;
    for (const Index v : mesh.face(static_cast<Index>(f))) middle += mesh.positions[v].x() / 3;
    if (middle < 0.1) continue;
    for (std::size_t i = 3 * f; i < 3 * f + 3; ++i) {
      const auto [copy, is_new] = copies.emplace(mesh.corners[i], static_cast<Index>(cut.positions.size()));
      if (is_new) {
        const double x = random.unit(), y = random.unit();
        const Vec3 shift = Vec3(x, y, random.unit()) * 2 - Vec3::Ones();
        cut.positions.push_back(mesh.positions[mesh.corners[i]] + noise / 2 * shift);
      }
      cut.corners[i] = copy->second;
    }
  }
  return cut;
}

std::vector<std::string> codes_of(const PolyMesh& mesh) {
  try {
    view_of(mesh);
  } catch (const Error& error) {
    std::vector<std::string> codes;
    for (const Finding& finding : error.findings()) codes.push_back(finding.code);
    return codes;
  }
  return {};
}

/// Triangles on few vertices, so that edges have any number of them.
/// @param window of these vertices each takes its corners, from there on along the way from the first to the last one
PolyMesh crowded_soup(std::uint64_t seed, Index vertices, Index triangles, Index window) {
  Random random(seed);
  PolyMesh mesh;
  for (Index v = 0; v < vertices; ++v) {
    const double x = random.unit(), y = random.unit();
    mesh.positions.emplace_back(x, y, random.unit());
  }
  while (mesh.face_count() < triangles) {
    const Index first = static_cast<Index>(mesh.face_count()) * (vertices - window) / triangles;
    const Index a = first + random.below(window), b = first + random.below(window), c = first + random.below(window);
    if (a != b && b != c && c != a) mesh.add_triangle(a, b, c);
  }
  return mesh;
}

}  // namespace

TEST_CASE("neighbours agree with the topology of the mesh, on any soup") {
  for (std::uint64_t seed = 0; seed < 120; ++seed) {
    const bool is_ordered = seed % 2 != 0;  // numbers in order and in none are matched in different ways
    const Index vertices = is_ordered ? 300 : 4 + static_cast<Index>(seed % 20);
    const PolyMesh mesh = crowded_soup(seed, vertices, is_ordered ? 400 : 30, is_ordered ? 8 : vertices);
    const MeshTopology topology(mesh);
    const SurfaceView view = view_of(mesh);
    REQUIRE(view.triangles.size() == mesh.face_count());
    std::size_t crowded = 0;
    for (Index edge = 0; edge < topology.edge_count(); ++edge) crowded += topology.edge_corners(edge).size() > 2;
    CHECK(view.nonmanifold_edges == crowded);
    CHECK(view.component_count == topology.component_count());
    std::size_t rims = 0;
    for (Index corner = 0; corner < view.opposite.size(); ++corner) {
      // Turning moves corners: compare edges by their vertices.
      const std::set<Index> ends = {view.origin(corner), view.target(corner)};
      Index same = no_index;
      for (Index i = corner - corner % 3; i < corner - corner % 3 + 3; ++i) {
        if (std::set<Index>{topology.vertex(i), topology.vertex(topology.next(i))} == ends) same = i;
      }
      REQUIRE(same != no_index);
      CHECK((view.opposite[corner] == no_index) == (topology.edge_corners(topology.edge(same)).size() == 1));
      CHECK((view.opposite[corner] == nonmanifold_edge) == (topology.edge_corners(topology.edge(same)).size() > 2));
      if (view.has_opposite(corner)) {
        CHECK(view.opposite[view.opposite[corner]] == corner);
        CHECK(view.opposite[corner] / 3 == topology.face(topology.opposite(same)));
      }
      rims += view.opposite[corner] == no_index;
    }
    CHECK(view.rim_corners.size() == rims);
    for (Index a = 0; a < mesh.face_count(); ++a) CHECK(view.component[a] == topology.component(a));
  }
}

TEST_CASE("a soup of triangles at the same places is joined as the mesh that it was") {
  const PolyMesh mesh = random_cuts(round_sphere(3), 1, 3, 0.2, 0.4).mesh;
  const SurfaceView joined = view_of(mesh);
  const SurfaceView soup = view_of(as_soup(mesh));
  CHECK(joined.welded_vertices == 0);
  CHECK(joined.representative.empty());
  CHECK(soup.welded_vertices > 0);
  CHECK(soup.opposite == joined.opposite);
  CHECK(soup.component_count == 1);
}

TEST_CASE("the lowest used vertex of a place stands for it, and both zeros are one place") {
  PolyMesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-0.0, 0, -0.0}, {1, 0, 0}, {1, -1, 0}};
  mesh.add_triangle(1, 2, 3);
  mesh.add_triangle(3, 5, 4);
  const SurfaceView view = view_of(mesh);
  CHECK(view.representative == std::vector<Index>{0, 1, 2, 3, 1, 5});  // vertex 0 is nobody's
  CHECK(view.welded_vertices == 1);
  CHECK(view.rim_corners.size() == 4);
}

TEST_CASE("vertices are joined as a search of all places would join them, however many there are") {
  for (const int width : {1, 3, 30, 3000}) {
    PolyMesh mesh;
    Random random(static_cast<std::uint64_t>(width));
    const auto coordinate = [&] { return random.below(static_cast<Index>(width)) / 7.0; };
    for (int v = 0; v < 5000; ++v) {
      const double x = coordinate(), y = coordinate();
      mesh.positions.emplace_back(x, y, width > 3 ? coordinate() : v % 2);
    }
    for (Index v = 0; v + 2 < mesh.vertex_count(); v += 3) mesh.add_triangle(v, v + 1, v + 2);
    mesh.add_triangle(0, 1, static_cast<Index>(mesh.vertex_count()) - 1);
    std::map<std::array<double, 3>, Index> lowest;
    std::size_t joined = 0;
    Progress progress;
    const Welding welding = weld_identical(mesh, progress);
    for (Index v = 0; v < mesh.vertex_count(); ++v) {
      if (v + 2 == mesh.vertex_count()) continue;  // nobody's
      const Vec3& p = mesh.positions[v];
      const auto [place, is_new] = lowest.insert({{p.x(), p.y(), p.z()}, v});
      joined += is_new ? 0U : 1U;
      if (!welding.representative.empty()) CHECK(welding.representative[v] == place->second);
    }
    CHECK(welding.welded == joined);
    CHECK(welding.representative.empty() == (joined == 0));
  }
}

TEST_CASE("the minority of a sheet is turned to agree with the rest") {
  const PolyMesh straight = random_cuts(round_sphere(3), 5, 2, 0.2, 0.4).mesh;
  Random random(3);
  PolyMesh mixed = straight;
  std::set<Index> turned;
  while (turned.size() < mixed.face_count() / 3) {
    const Index face = random.below(static_cast<Index>(mixed.face_count()));
    if (turned.insert(face).second) mixed = flipped_face(mixed, face);
  }
  const SurfaceView view = view_of(mixed);
  CHECK(view.turned_faces == turned.size());
  CHECK(view.one_sided_components == 0);
  for (Index t = 0; t < view.triangles.size(); ++t) {
    CHECK(((view.flags[t] & SurfaceView::Turned) != 0) == turned.contains(view.face[t]));
    for (Index corner = 3 * t; corner < 3 * t + 3; ++corner) {
      if (!view.has_opposite(corner)) continue;
      CHECK(view.origin(corner) == view.target(view.opposite[corner]));
      CHECK(view.target(corner) == view.origin(view.opposite[corner]));
    }
  }
}

TEST_CASE("a band with half a turn is reported as one-sided") {
  CHECK(view_of(moebius(7)).one_sided_components == 1);
  CHECK(view_of(merged(moebius(5), grid(2, 2))).one_sided_components == 1);
  CHECK(view_of(merged(moebius(5), grid(2, 2))).component_count == 2);
}

TEST_CASE("polygons are seen as triangles of their face") {
  const SurfaceView view = view_of(cube());
  CHECK(view.triangles.size() == 12);
  CHECK(view.rim_corners.empty());
  for (Index t = 0; t < 12; ++t) CHECK(view.face[t] == t / 2);
}

TEST_CASE("triangles without area are flagged, and those with two corners at one place left out") {
  PolyMesh mesh = sheet(2, 2);
  mesh.positions.emplace_back(0.5, 0, 0);
  mesh.add_triangle(0, 1, 9);  // a crack along an edge of the border
  mesh.positions.emplace_back(0, 0, 0);
  mesh.add_triangle(0, 10, 3);  // vertex 10 is where vertex 0 is
  const SurfaceView view = view_of(mesh);
  CHECK(view.triangles.size() == 9);
  CHECK(view.dropped_triangles == 1);
  CHECK(view.unsound_triangles == 1);
  CHECK((view.flags[8] & SurfaceView::NoArea) != 0);
}

TEST_CASE("meshes that can't be viewed are refused by what is wrong with them") {
  CHECK(codes_of(PolyMesh()) == std::vector<std::string>{"E_NO_FACES"});
  PolyMesh points = sheet(1, 1);
  for (Vec3& p : points.positions) p = Vec3(1, 2, 3);
  CHECK(codes_of(points) == std::vector<std::string>{"E_DEGENERATE"});
  PolyMesh line = sheet(1, 1);
  for (Vec3& p : line.positions) p = Vec3(p.x() + p.y(), 0, 0);
  CHECK(codes_of(line) == std::vector<std::string>{"E_DEGENERATE"});
  PolyMesh broken = sheet(1, 1);
  broken.positions[2].y() = std::numeric_limits<double>::quiet_NaN();
  broken.corners[0] = 77;
  const auto codes = codes_of(broken);
  CHECK(std::set<std::string>(codes.begin(), codes.end()) == std::set<std::string>{"E_INDEX", "E_NOT_FINITE"});
}

TEST_CASE("seams that differ by rounding are none, at any scale, unless they are to be kept apart") {
  const PolyMesh ball = round_sphere(3);
  for (const double scale : {1e-3, 1.0, 1e4}) {
    for (const double noise : {1e-16, 1e-12, 5e-7}) {
      const PolyMesh seamed = scaled(rotated(with_noisy_seam(ball, 5, noise), 0.7, Vec3(1, 2, 3)), scale);
      const SurfaceView joined = view_of(seamed);
      CHECK(joined.rim_corners.empty());
      CHECK(joined.component_count == 1);
      CHECK(joined.dropped_triangles == 0);
      CHECK(joined.widest_weld <= 2 * (noise + 1e-15) * scale);
      const SurfaceView apart = view_of(seamed, 0);
      if (noise > 1e-13) CHECK(apart.nearly_welded_vertices == 0);
      if (noise > 1e-13) CHECK_FALSE(apart.rim_corners.empty());
    }
  }
}

TEST_CASE("wider seams are joined by as wide a tolerance, and no edge loses its length") {
  const PolyMesh ball = round_sphere(3);  // edges of 0.14
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const double noise = 0.001 * static_cast<double>(seed);
    const PolyMesh seamed = with_noisy_seam(ball, seed, noise);
    CHECK_FALSE(view_of(seamed).rim_corners.empty());
    const SurfaceView joined = view_of(seamed, noise);
    CHECK(joined.rim_corners.empty());
    CHECK(joined.dropped_triangles == 0);
    // Wider than its edges: what is nearer than half an edge is joined, and no triangle disappears.
    CHECK(view_of(scaled(seamed, 1), 1).dropped_triangles == 0);
  }
}

TEST_CASE("a joined soup has the figures of the mesh that it was, and all its inner edges are seams") {
  PolyMesh mesh = random_cuts(round_sphere(3), 1, 3, 0.2, 0.4).mesh;
  Progress progress;
  const MeshReport whole = inspect(mesh, true, progress);
  const PolyMesh soup = as_soup(mesh);
  const SurfaceView view = view_of(soup);
  const JoinedMesh joint = joined(soup, view);
  const MeshReport again = inspect(joint.mesh, true, progress);
  CHECK(again.edges == whole.edges);
  CHECK(again.boundary_edges == whole.boundary_edges);
  CHECK(again.boundary_loops == whole.boundary_loops);
  CHECK(again.euler_characteristic == whole.euler_characteristic);
  CHECK(again.self_intersections == 0);
  CHECK(joint.face.size() == mesh.face_count());
  CHECK(count_seam_edges(soup, view) == whole.edges - whole.boundary_edges);
  CHECK(count_seam_edges(mesh, view_of(mesh)) == 0);
  // A face that shrinks to a line when its corners are joined is left out, and the others keep their numbers.
  const Index corner = mesh.corners[0];
  mesh.positions.push_back(mesh.positions[corner]);
  const std::array<Index, 3> line = {corner, static_cast<Index>(mesh.vertex_count() - 1), mesh.corners[1]};
  mesh.add_face(line);
  mesh.add_face(std::array<Index, 3>{corner, mesh.corners[1], mesh.corners[2]});
  const JoinedMesh shrunk = joined(mesh, view_of(mesh));
  CHECK(shrunk.face.size() == mesh.face_count() - 1);
  CHECK(shrunk.face.back() == mesh.face_count() - 1);
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <set>
#include <string>
#include <vector>

#include <Eigen/Geometry>
#include <catch2/catch.hpp>

#include "algorithms/remeshing/edge_collapse.h"
#include "algorithms/remeshing/flat_faces.h"
#include "croquis/geometry/mesh_topology.h"
#include "hole_filling/fill_invariants.h"
#include "remeshing/remeshed.h"
#include "support/meshes/mesh_shapes.h"
#include "support/meshes/surface_distance.h"
#include "support/random.h"
#include "support/scans/scans.h"
#include "support/scans/sculptures.h"
#include "support/scans/virtual_scans.h"

using namespace croquis;
using namespace croquis::test;
using namespace croquis::hole_filling;
using namespace croquis::remeshing;

namespace {

RemeshOptions adaptive(double share) {
  RemeshOptions options;
  options.adaptive = share;
  return options;
}

/// Of the cubes, for scans whose cells aren't enlarged.
double cell_of(const PolyMesh& scan) { return std::min(mean_edge_of(scan), diagonal_of(scan) / 40); }

std::vector<Index> all_faces(const PolyMesh& mesh) {
  std::vector<Index> faces(mesh.face_count());
  std::iota(faces.begin(), faces.end(), Index{0});
  return faces;
}

/// The greatest distance of places all over every face of one surface to the other.
double farthest(const PolyMesh& from, const PolyMesh& to) {
  constexpr int steps = 4;
  std::vector<Vec3> places = sample_faces(from, all_faces(from), 20'000);
  for (std::size_t f = 0; f < from.face_count(); ++f) {
    const auto face = from.face(f);
    const Vec3 &a = from.positions[face[0]], &b = from.positions[face[1]], &c = from.positions[face[2]];
    for (int i = 0; i <= steps; ++i)
      for (int j = 0; i + j <= steps; ++j) places.emplace_back(a + (i * (b - a) + j * (c - a)) / steps);
  }
  return summary_of_distances(places, SurfaceDistance(to)).greatest;
}

double least_angle(const PolyMesh& mesh) {
  double least = 180;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3 &a = mesh.positions[face[i]], &b = mesh.positions[face[(i + 1) % 3]],
                 &c = mesh.positions[face[(i + 2) % 3]];
      least = std::min(least, std::acos((b - a).normalized().dot((c - a).normalized())) * 180 / std::numbers::pi);
    }
  }
  return least;
}

/// Edges of one face, by the places of their ends.
std::set<std::array<double, 6>> rim_edges(const PolyMesh& mesh) {
  const MeshTopology topology(mesh);
  std::set<std::array<double, 6>> edges;
  for (Index e = 0; e < topology.edge_count(); ++e) {
    if (topology.edge_corners(e).size() != 1) continue;
    const Vec3 &a = mesh.positions[topology.edge_vertices(e)[0]], &b = mesh.positions[topology.edge_vertices(e)[1]];
    edges.insert({a.x(), a.y(), a.z(), b.x(), b.y(), b.z()});
  }
  return edges;
}

Vec3 direction(Random& random) {
  for (;;) {
    const Vec3 v(random.between(-1, 1), random.between(-1, 1), random.between(-1, 1));
    if (v.norm() > 0.1 && v.norm() < 1) return v.normalized();
  }
}

struct Thing {
  std::string name;
  PolyMesh scan;
  double most_faces = 1;  ///< share of them that may be left at 0.1 cells
};

std::vector<Thing> flat_things() {
  return {{"box with holes", random_cuts(divided_box(30), 1, 4, 0.06, 0.15).mesh, 0.25},
          {"plate", transformed(divided_box(40), Eigen::Affine3d(Eigen::Scaling(1.0, 1.0, 0.2))), 0.3},
          {"turned box", rotated(divided_box(24), 0.7, Vec3(1, 2, 3).normalized()), 0.3},
          {"bracket", sculpt(Sculpture::Bracket, 8000), 0.5},
          {"double torus", triangulated(double_torus()), 0.5},
          {"sheet with holes", random_cuts(sheet(60, 60), 3, 5, 2, 6).mesh, 0.3}};
}

std::vector<Thing> round_things() {
  return {{"sphere with holes", random_cuts(round_sphere(5), 1, 4, 0.1, 0.35).mesh, 0.5},
          {"armour", sculpt(Sculpture::Armour, 5000), 0.9},
          {"open tube", open_tube(1, 4, 60, 40), 0.6},
          {"shell", shell(4, 0.05), 0.9},
          {"thin shell", shell(4, 0.02), 0.9},
          {"balls that cross", merged(round_sphere(4), translated(round_sphere(4), Vec3(1.5, 0, 0))), 0.7}};
}

/// Places all over a model farther than half a cell from the scan, but near holes.
std::size_t places_off_scan(const Thing& thing, const RemeshResult& made) {
  const SurfaceDistance to_scan(thing.scan);
  const auto in_hole = [&](const Vec3& place) {
    return std::ranges::any_of(made.analysis.holes, [&](const Hole& hole) {
      return std::ranges::any_of(
          hole.vertices, [&](Index v) { return (thing.scan.positions[v] - place).norm() <= 1.5 * hole.diameter; });
    });
  };
  const double near = 0.5 * cell_of(thing.scan);
  std::size_t far = 0;
  for (const Vec3& place : sample_faces(made.mesh, all_faces(made.mesh), 5'000))
    far += to_scan(place) > near && !in_hole(place) ? 1U : 0U;
  return far;
}

void check_merging(const std::vector<Thing>& things) {
  for (const Thing& thing : things) {
    CAPTURE(thing.name);
    const RemeshResult full = remesh(thing.scan);
    for (const double share : {0.1, 1.0}) {
      CAPTURE(share);
      const RemeshResult made = remesh(thing.scan, adaptive(share));
      const MeshReport report = report_of(made.mesh), before = report_of(full.mesh);
      CHECK(made.full_faces == full.mesh.face_count());
      CHECK(static_cast<double>(made.mesh.face_count()) <= thing.most_faces * static_cast<double>(made.full_faces));
      CHECK(report.euler_characteristic == before.euler_characteristic);
      CHECK(report.components == before.components);
      CHECK(report.boundary_loops == before.boundary_loops);
      CHECK(report.nonmanifold_edges == 0);
      CHECK(report.nonmanifold_vertices == 0);
      CHECK(report.oriented);
      CHECK(report.self_intersections == std::size_t{0});
      CHECK(made.checks.manifold);
      CHECK(made.checks.open_loops == full.checks.open_loops);
      CHECK(made.checks.loose_points == full.checks.loose_points);
      CHECK(validate(made.mesh).empty());
      const double bound = share * cell_of(thing.scan) * (1 + 1e-9);
      CHECK(farthest(made.mesh, full.mesh) <= bound);
      CHECK(farthest(full.mesh, made.mesh) <= bound);
      CHECK(least_angle(made.mesh) >= std::min(14.9, 0.999 * least_angle(full.mesh)));
      CHECK(rim_edges(made.mesh) == rim_edges(full.mesh));
      CHECK(places_off_scan(thing, made) == 0);
    }
  }
}

}  // namespace

TEST_CASE("flat things lose most faces, within the bound, and stay sound") { check_merging(flat_things()); }

TEST_CASE("round and open things lose fewer faces, within the bound, and stay sound") { check_merging(round_things()); }

TEST_CASE("vertices of a model with merged faces are some of the full one's, with their values") {
  PolyMesh scan = random_cuts(divided_box(24), 2, 4, 0.1, 0.2).mesh;
  std::vector<float> heights, normals;
  for (const Vec3& p : scan.positions) {
    heights.push_back(static_cast<float>(p.z()));
    for (const double x : {1.0, 0.0, 0.0}) normals.push_back(static_cast<float>(x));
  }
  scan.channels.push_back({"height", Domain::Vertex, 1, heights, {}});
  scan.channels.push_back({"normal", Domain::Vertex, 3, normals, {}});
  const RemeshResult full = remesh(scan), made = remesh(scan, adaptive(0.2));
  std::map<std::array<double, 3>, std::size_t> vertex_at;
  for (std::size_t v = 0; v < full.mesh.vertex_count(); ++v) {
    const Vec3& p = full.mesh.positions[v];
    vertex_at[{p.x(), p.y(), p.z()}] = v;
  }
  for (const char* name : {"height", "normal", "confidence"}) {
    const AttributeChannel *of_full = full.mesh.channel(name, Domain::Vertex),
                           *of_made = made.mesh.channel(name, Domain::Vertex);
    REQUIRE(of_full != nullptr);
    REQUIRE(of_made != nullptr);
    const auto &was = std::get<std::vector<float>>(of_full->data), &is = std::get<std::vector<float>>(of_made->data);
    const auto width = static_cast<std::size_t>(of_made->width);
    REQUIRE(is.size() == width * made.mesh.vertex_count());
    for (std::size_t v = 0; v < made.mesh.vertex_count(); ++v) {
      const Vec3& p = made.mesh.positions[v];
      const auto found = vertex_at.find({p.x(), p.y(), p.z()});
      REQUIRE(found != vertex_at.end());
      for (std::size_t k = 0; k < width; ++k) CHECK(is[width * v + k] == was[width * found->second + k]);
    }
  }
  const auto labels = [](const RemeshResult& result) {
    const auto& patches = std::get<std::vector<std::int32_t>>(result.mesh.channel("patch_id", Domain::Face)->data);
    return std::set<std::int32_t>(patches.begin(), patches.end());
  };
  CHECK(labels(made) == labels(full));
  CHECK(labels(made).size() == 5);
  for (std::size_t h = 0; h < made.outcomes.size(); ++h) {
    CHECK(made.outcomes[h].confidence == full.outcomes[h].confidence);
    CHECK(made.outcomes[h].new_faces > 0);
    CHECK(made.outcomes[h].new_faces <= full.outcomes[h].new_faces);
  }
}

TEST_CASE("without a bound no face is merged, and a wider one merges more") {
  const PolyMesh scan = random_cuts(ring_torus(80, 40), 1, 5, 0.06, 0.2).mesh;
  const RemeshResult plain = remesh(scan), none = remesh(scan, adaptive(0));
  CHECK(none.mesh.positions == plain.mesh.positions);
  CHECK(none.mesh.corners == plain.mesh.corners);
  CHECK(none.full_faces == none.mesh.face_count());
  std::size_t before = none.mesh.face_count();
  for (const double share : {0.01, 0.05, 0.2, 1.0}) {
    CAPTURE(share);
    const RemeshResult made = remesh(scan, adaptive(share));
    CHECK(made.mesh.face_count() < before);
    CHECK(made.mesh.face_count() <= made.predicted_faces);
    before = made.mesh.face_count();
  }
}

TEST_CASE("any number of threads merges the same faces, at any scale") {
  const PolyMesh scan = sculpt(Sculpture::Bracket, 8000);
  RemeshOptions options = adaptive(0.1);
  options.fill.threads = 1;
  const PolyMesh one = remesh(scan, options).mesh;
  for (const int threads : {2, 8}) {
    options.fill.threads = threads;
    const PolyMesh other = remesh(scan, options).mesh;
    CHECK(other.positions == one.positions);
    CHECK(other.corners == one.corners);
    CHECK(other.channels.back().data == one.channels.back().data);
  }
  const PolyMesh tiny = remesh(scaled(scan, 1.0 / 1024), options).mesh;
  CHECK(tiny.corners == one.corners);
}

TEST_CASE("sharp edges stay while the faces beside them are merged") {
  RemeshOptions options = remesh_preset(Preset::Sharp);
  const PolyMesh scan = divided_box(20);
  const PolyMesh full = remesh(scan, options).mesh;
  options.adaptive = 0.1;
  const PolyMesh made = remesh(scan, options).mesh;
  CHECK(made.face_count() * 5 < full.face_count());
  const double bound = 0.1 * options.cell * cell_of(scan) * (1 + 1e-9);
  CHECK(farthest(made, full) <= bound);
  CHECK(farthest(scan, made) <= farthest(scan, full) + bound);
}

TEST_CASE("collapses keep what must stay, and lie where they are said to") {
  const PolyMesh mesh = sheet(20, 20);
  std::vector<VertexRole> roles(mesh.vertex_count(), VertexRole::Free);
  for (std::size_t v = 0; v < roles.size(); ++v) {
    const Vec3& p = mesh.positions[v];
    if (p.x() == 0 || p.y() == 0 || p.x() == 20 || p.y() == 20) roles[v] = VertexRole::Kept;
    if ((p - Vec3(10, 10, 0)).norm() < 2.5) roles[v] = VertexRole::Fenced;
  }
  const std::vector<std::uint8_t> halvings(mesh.vertex_count(), 0);
  Progress progress;
  const CollapsedMesh left = collapse_edges(mesh, roles, {1e-9, 6, halvings}, progress);
  CHECK(left.triangles.size() * 3 < mesh.face_count());
  std::set<Index> used;
  double area = 0;
  for (const auto& [a, b, c] : left.triangles) {
    used.insert({a, b, c});
    const Vec3 normal = (mesh.positions[b] - mesh.positions[a]).cross(mesh.positions[c] - mesh.positions[a]);
    CHECK(normal.z() > 0);
    area += 0.5 * normal.z();
    for (const Index end : {b, c}) CHECK((mesh.positions[end] - mesh.positions[a]).norm() <= 6);
  }
  CHECK(area == Approx(400));
  for (Index v = 0; v < roles.size(); ++v) {
    if (roles[v] != VertexRole::Free) CHECK(used.contains(v));
    CHECK((left.home[v] == no_index) == used.contains(v));
  }
  CHECK(std::ranges::is_sorted(left.face_of));
}

TEST_CASE("a triangle is proven to be near to a surface if and only if it is, but for a little") {
  Random random(7);
  const PolyMesh ball = round_sphere(3);
  std::vector<std::array<Vec3, 3>> surface;
  for (std::size_t f = 0; f < ball.face_count(); ++f) {
    const auto face = ball.face(f);
    surface.push_back({ball.positions[face[0]], ball.positions[face[1]], ball.positions[face[2]]});
  }
  const TriangleTree tree(surface);
  const SurfaceDistance exact(ball);
  std::vector<std::array<Vec3, 3>> triangles;
  std::vector<double> off;
  for (int i = 0; i < 400; ++i) {
    std::array<Vec3, 3> t;
    const Vec3 middle = direction(random);
    for (Vec3& p : t) p = (middle + random.between(0.02, 0.5) * direction(random)).normalized();
    double most = 0;
    for (int a = 0; a <= 60; ++a)
      for (int b = 0; a + b <= 60; ++b)
        most = std::max(most, exact(Vec3(t[0] + (a * (t[1] - t[0]) + b * (t[2] - t[0])) / 60)));
    triangles.push_back(t);
    off.push_back(most);
  }
  Progress progress;
  for (const double distance : {0.003, 0.01, 0.03, 0.1}) {
    const std::vector<Index> beyond = faces_beyond(triangles, {}, tree, distance, 2, progress);
    for (Index i = 0; i < triangles.size(); ++i) {
      const bool is_beyond = std::ranges::binary_search(beyond, i);
      if (off[i] > distance) CHECK(is_beyond);
      if (off[i] < 0.9 * distance) CHECK_FALSE(is_beyond);
    }
  }
}

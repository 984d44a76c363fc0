// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "croquis/base/error.h"
#include "croquis/geometry/mesh_report.h"
#include "support/meshes/mesh_shapes.h"
#include "support/random.h"

using namespace croquis;
using namespace croquis::test;

namespace {

MeshReport figures_of(const PolyMesh& mesh, bool count_self_intersections = false) {
  Progress progress;
  return inspect(mesh, count_self_intersections, progress);
}

struct Shape {
  std::string name;
  PolyMesh mesh;
  std::size_t vertices, edges, faces, components, loops;
  std::optional<std::int64_t> genus;
  bool oriented, closed;
};

std::vector<Shape> shapes() {
  return {
      {"tetrahedron", tetrahedron(), 4, 6, 4, 1, 0, 0, true, true},
      {"cube", cube(), 8, 12, 6, 1, 0, 0, true, true},
      {"sphere", uv_sphere(8, 6), 42, 88, 48, 1, 0, 0, true, true},
      {"torus", torus(7, 5), 35, 70, 35, 1, 0, 1, true, true},
      {"double torus", double_torus(), 48, 100, 50, 1, 0, 2, true, true},
      {"torus and double torus", merged(torus(7, 5), double_torus()), 83, 170, 85, 2, 0, 3, true, true},
      {"grid", grid(4, 3), 20, 31, 12, 1, 1, std::nullopt, true, false},
      {"Moebius strip", moebius(6), 12, 18, 6, 1, 1, std::nullopt, false, false},
      {"common vertex", tetrahedra_sharing_vertex(), 7, 12, 8, 2, 0, 0, true, true},
      {"common edge", tetrahedra_sharing_edge(), 6, 11, 8, 1, 0, std::nullopt, true, true},
      {"one face turned", flipped_face(cube(), 3), 8, 12, 6, 1, 0, 0, false, true},
      {"opened torus", without_faces(torus(7, 5), std::vector<Index>{0}), 35, 70, 34, 1, 1, std::nullopt, true, false},
  };
}

void check_counts(const Shape& shape, const PolyMesh& mesh) {
  const MeshReport figures = figures_of(mesh);
  INFO(shape.name);
  CHECK(figures.vertices == shape.vertices);
  CHECK(figures.edges == shape.edges);
  CHECK(figures.faces == shape.faces);
  CHECK(figures.components == shape.components);
  CHECK(figures.boundary_loops == shape.loops);
  CHECK(figures.euler_characteristic ==
        static_cast<std::int64_t>(shape.vertices + shape.faces) - static_cast<std::int64_t>(shape.edges));
  CHECK(figures.genus == shape.genus);
  CHECK(figures.oriented == shape.oriented);
  CHECK(figures.closed == shape.closed);
  CHECK(figures.degenerate_faces == 0);
}

/// The Klein bottle as a torus grid whose last row is joined mirrored.
PolyMesh klein_bottle(Index n) {
  PolyMesh mesh = torus(n, n);
  mesh.corners.clear();
  mesh.face_offsets = {0};
  const auto at = [n](Index i, Index j) { return i < n ? i * n + j % n : (2 * n - j) % n; };
  for (Index i = 0; i < n; ++i) {
    for (Index j = 0; j < n; ++j) {
      mesh.add_face(std::array<Index, 4>{at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return mesh;
}

}  // namespace

TEST_CASE("shapes have the figures that counting gives") {
  for (const Shape& shape : shapes()) check_counts(shape, shape.mesh);
}

TEST_CASE("figures do not depend on the order of vertices, faces and corners") {
  for (const Shape& shape : shapes()) {
    const MeshReport before = figures_of(shape.mesh);
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      const PolyMesh other = shuffled(shape.mesh, seed);
      check_counts(shape, other);
      const MeshReport after = figures_of(other);
      CHECK(after.nonmanifold_edges == before.nonmanifold_edges);
      CHECK(after.nonmanifold_vertices == before.nonmanifold_vertices);
      CHECK(after.area == Approx(before.area).epsilon(1e-12));
      CHECK(after.volume.has_value() == before.volume.has_value());
      if (before.volume) CHECK(*after.volume == Approx(*before.volume).epsilon(1e-12).margin(1e-12));
    }
  }
}

TEST_CASE("area and volume are those of the solid") {
  CHECK(figures_of(tetrahedron()).volume == Approx(1.0 / 6));
  CHECK(figures_of(tetrahedron()).area == Approx(1.5 + std::sqrt(3.0) / 2));
  CHECK(figures_of(cube()).volume == Approx(1.0));
  CHECK(figures_of(cube()).area == Approx(6.0));
  CHECK(figures_of(double_torus()).volume == Approx(13.0));
  CHECK(figures_of(double_torus()).area == Approx(50.0));
  CHECK(figures_of(grid(4, 3)).area == Approx(12.0));
  CHECK_FALSE(figures_of(grid(4, 3)).volume);
  CHECK(*figures_of(uv_sphere(200, 100)).volume == Approx(4 * std::numbers::pi / 3).epsilon(2e-3));
  CHECK(*figures_of(torus(200, 200)).volume == Approx(2 * std::numbers::pi * std::numbers::pi * 0.16).epsilon(2e-3));
}

TEST_CASE("turning all faces over changes the sign of the volume only") {
  const MeshReport figures = figures_of(flipped(double_torus()));
  CHECK(*figures.volume == Approx(-13.0));
  CHECK(figures.area == Approx(50.0));
  CHECK(figures.oriented);
  CHECK(figures.genus == 2);
}

TEST_CASE("polygons that are not flat are measured by their cut into triangles") {
  // The top is cut beside the raised corner, so a pyramid over half of it is added.
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const MeshReport figures = figures_of(shuffled(bent_box(), seed));
    CHECK(*figures.volume == Approx(7.0 / 6));
    CHECK(figures.area == Approx(6.5 + std::sqrt(3.0) / 2));
  }
}

TEST_CASE("motions keep area and volume and scaling multiplies them") {
  Random random(11);
  for (const PolyMesh& mesh : {tetrahedron(), torus(9, 6), double_torus(), uv_sphere(9, 7)}) {
    const MeshReport before = figures_of(mesh);
    for (int i = 0; i < 5; ++i) {
      const Vec3 axis(random.between(-1, 1), random.between(-1, 1), random.between(0.1, 1));
      const double factor = std::exp(random.between(-5, 5));
      const MeshReport after =
          figures_of(translated(scaled(rotated(mesh, random.between(0, 6), axis), factor), 10 * axis));
      CHECK(after.area == Approx(before.area * factor * factor).epsilon(1e-9));
      CHECK(*after.volume == Approx(*before.volume * factor * factor * factor).epsilon(1e-9));
      CHECK(after.genus == before.genus);
    }
  }
}

TEST_CASE("a cube far from the origin keeps its volume") {
  const MeshReport figures = figures_of(translated(cube(), {1e6, -3e6, 2e6}));
  CHECK(*figures.volume == Approx(1.0).epsilon(1e-14));
  CHECK((*figures.bounds)[0] == Vec3(1e6, -3e6, 2e6));
  CHECK((*figures.bounds)[1] == Vec3(1e6 + 1, -3e6 + 1, 2e6 + 1));
}

TEST_CASE("non-manifold places are counted") {
  const MeshReport edge = figures_of(tetrahedra_sharing_edge());
  CHECK(edge.nonmanifold_edges == 1);
  CHECK(edge.nonmanifold_vertices == 2);
  const MeshReport vertex = figures_of(tetrahedra_sharing_vertex());
  CHECK(vertex.nonmanifold_edges == 0);
  CHECK(vertex.nonmanifold_vertices == 1);
  CHECK(*vertex.volume == Approx(1.0 / 3));
  const MeshReport touching = figures_of(without_faces(grid(4, 4), std::vector<Index>{5, 10}));
  CHECK(touching.nonmanifold_vertices == 1);
  CHECK(touching.boundary_edges == 16 + 8);
}

TEST_CASE("a Klein bottle is closed and has no genus") {
  const MeshReport figures = figures_of(klein_bottle(6));
  CHECK(figures.closed);
  CHECK_FALSE(figures.oriented);
  CHECK(figures.euler_characteristic == 0);
  CHECK(figures.nonmanifold_vertices == 0);
  CHECK_FALSE(figures.genus);
}

TEST_CASE("genus adds up over nested and mixed shells, turned or not") {
  const PolyMesh nested = merged(scaled(uv_sphere(8, 6), 5), flipped(torus(7, 5)));
  CHECK(figures_of(nested).genus == 1);
  CHECK(figures_of(merged(nested, translated(double_torus(), {20, 0, 0}))).genus == 3);
}

TEST_CASE("a duplicate face makes its edges non-manifold") {
  PolyMesh mesh = tetrahedron();
  mesh.add_triangle(0, 2, 1);
  const MeshReport figures = figures_of(mesh, true);
  CHECK(figures.nonmanifold_edges == 3);
  CHECK(figures.self_intersections == 1);
  CHECK_FALSE(figures.genus);
}

TEST_CASE("vertices without faces count as vertices, not for Euler") {
  PolyMesh mesh = tetrahedron();
  mesh.positions.emplace_back(5, 5, 5);
  const MeshReport figures = figures_of(mesh);
  CHECK(figures.vertices == 5);
  CHECK(figures.euler_characteristic == 2);
  CHECK(figures.nonmanifold_vertices == 0);
  CHECK(figures.genus == 0);
  CHECK((*figures.bounds)[1] == Vec3(5, 5, 5));
}

TEST_CASE("meshes of nothing, of points and of lines have empty figures") {
  PolyMesh mesh;
  CHECK_FALSE(figures_of(mesh).bounds);
  CHECK_FALSE(figures_of(mesh).closed);
  mesh.positions = {{0, 0, 0}, {1, 2, 3}};
  mesh.add_line(std::array<Index, 2>{0, 1});
  const MeshReport figures = figures_of(mesh, true);
  CHECK(figures.vertices == 2);
  CHECK(figures.edges == 0);
  CHECK(figures.components == 0);
  CHECK(figures.euler_characteristic == 0);
  CHECK_FALSE(figures.closed);
  CHECK_FALSE(figures.genus);
  CHECK_FALSE(figures.volume);
  CHECK(figures.self_intersections == 0);
  CHECK((*figures.bounds)[1] == Vec3(1, 2, 3));
}

TEST_CASE("faces without an area are degenerate, thin ones are not") {
  PolyMesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 1, 1}, {3, 3, 3}, {3, 3, std::nextafter(3.0, 4.0)}, {0, 0, 0}};
  mesh.add_triangle(0, 1, 2);                       // on a line
  mesh.add_triangle(0, 1, 3);                       // all but on a line
  mesh.add_triangle(0, 4, 1);                       // two corners in one place
  mesh.add_triangle(0, 1, 0);                       // a vertex twice
  mesh.add_face(std::array<Index, 2>{0, 1});        // two corners
  mesh.add_face(std::array<Index, 4>{0, 1, 2, 4});  // a polygon on a line
  mesh.add_face(std::array<Index, 4>{0, 4, 1, 3});  // a polygon that begins in one place twice
  CHECK(figures_of(mesh).degenerate_faces == 5);
}

TEST_CASE("self-intersections are counted on demand only") {
  CHECK_FALSE(figures_of(cube(), false).self_intersections);
  CHECK(figures_of(cube(), true).self_intersections == 0);
  CHECK(*figures_of(merged(cube(), translated(cube(), {0.5, 0.3, 0.2})), true).self_intersections > 0);
}

TEST_CASE("unusable meshes are refused with every finding") {
  PolyMesh mesh = cube();
  mesh.positions[0].x() = std::numeric_limits<double>::quiet_NaN();
  mesh.corners[3] = 99;
  try {
    figures_of(mesh);
    FAIL("accepted");
  } catch (const Error& error) {
    CHECK(error.findings().size() == 2);
  }
}

TEST_CASE("the report has every key of a mesh's figures, null where there is none") {
  const Report open = to_report(figures_of(grid(2, 2)));
  const std::vector<std::string> keys = {"vertices",
                                         "faces",
                                         "edges",
                                         "boundary_edges",
                                         "boundary_loops",
                                         "components",
                                         "euler_characteristic",
                                         "genus",
                                         "nonmanifold_edges",
                                         "nonmanifold_vertices",
                                         "degenerate_faces",
                                         "oriented",
                                         "closed",
                                         "self_intersections",
                                         "area",
                                         "volume",
                                         "bounds"};
  REQUIRE(open.as_object().size() == keys.size());
  for (std::size_t i = 0; i < keys.size(); ++i) CHECK(open.as_object()[i].first == keys[i]);
  CHECK(open.at("genus").is_null());
  CHECK(open.at("volume").is_null());
  CHECK(open.at("self_intersections").is_null());
  CHECK(open.at("area").as_number() == Approx(4.0));
  CHECK(open.at("bounds").as_array()[1].as_array()[0].as_number() == 2.0);
  const Report closed = to_report(figures_of(torus(4, 4), true));
  CHECK(closed.at("genus").as_integer() == 1);
  CHECK(closed.at("self_intersections").as_integer() == 0);
  CHECK(to_report(figures_of(PolyMesh{})).at("bounds").is_null());
}

TEST_CASE("inspection stops when asked and tells its progress up to the end") {
  std::vector<double> fractions;
  Progress progress([&](double fraction, const std::string&) { fractions.push_back(fraction); });
  inspect(torus(50, 50), true, progress);
  CHECK(std::is_sorted(fractions.begin(), fractions.end()));
  CHECK(fractions.back() == 1.0);
  const std::atomic<bool> cancel{true};
  Progress stopped({}, &cancel);
  CHECK_THROWS_AS(inspect(cube(), true, stopped), Cancelled);
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include <catch2/catch.hpp>

#include "croquis/base/error.h"
#include "croquis/edits/apply_edits.h"
#include "croquis/geometry/mesh_report.h"
#include "support/meshes/mesh_shapes.h"
#include "support/random.h"

namespace croquis {
namespace {

EditedMesh edited(const PolyMesh& mesh, const std::string& text) {
  Progress progress;
  return apply_edits(mesh, parse_edit_lines(text), progress);
}

MeshReport figures(const PolyMesh& mesh) {
  Progress progress;
  return inspect(mesh, true, progress);
}

Finding refusal(const PolyMesh& mesh, const std::string& text) {
  try {
    edited(mesh, text);
  } catch (const Error& error) {
    return error.findings().front();
  }
  FAIL("accepted: " << text);
  return {};
}

/// The face of a cube that looks along +z.
Index top_of(const PolyMesh& mesh) {
  for (Index face = 0; face < mesh.face_count(); ++face) {
    const auto corners = mesh.face(face);
    if (std::all_of(corners.begin(), corners.end(), [&](Index v) { return mesh.positions[v].z() == 1; })) return face;
  }
  return no_index;
}

TEST_CASE("a box with a hole is made by three lines") {
  const PolyMesh cube = test::cube();
  const std::string top = std::to_string(top_of(cube));
  const EditedMesh box =
      edited(cube, "inset faces=" + top + " width=0.2; extrude faces=" + top + " distance=-0.5\nsharpness edges=all");
  const MeshReport report = figures(box.mesh);
  CHECK(report.closed);
  CHECK(report.oriented);
  CHECK(report.self_intersections == 0);
  CHECK(report.euler_characteristic == 2);
  CHECK(report.volume == Approx(1 - 0.6 * 0.6 * 0.5));
  CHECK(box.mesh.face_count() == 6 + 4 + 4);
  CHECK(box.mesh.tags.creases.size() == report.edges);
  CHECK(std::count(box.face_source.begin(), box.face_source.end(), no_index) == 8);
  CHECK(std::count(box.vertex_source.begin(), box.vertex_source.end(), no_index) == 0);
  for (std::size_t v = 0; v < 8; ++v) CHECK(box.mesh.positions[v] == cube.positions[v]);
}

TEST_CASE("an inset leaves every edge by its width, in any place and size") {
  test::Random random(8);
  for (int round = 0; round < 60; ++round) {
    const double size = random.between(0.01, 100);
    const Vec3 axis = Vec3(random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)).normalized();
    const PolyMesh mesh = test::translated(test::rotated(test::scaled(test::cube(), size), random.between(0, 6), axis),
                                           size * Vec3(3, -2, 1));
    const Index face = random.below(6);
    const double width = random.between(0.01, 0.49) * size;
    const EditedMesh inset = edited(mesh, "inset faces=" + std::to_string(face) + " width=" + to_text(width));
    const auto outer = mesh.face(face);
    const auto inner = inset.mesh.face(face);
    REQUIRE(inner.size() == 4);
    for (std::size_t i = 0; i < 4; ++i) {
      const Vec3& a = mesh.positions[outer[i]];
      const Vec3 along = (mesh.positions[outer[(i + 1) % 4]] - a).normalized();
      const Vec3 to = inset.mesh.positions[inner[i]] - a;
      CHECK((to - to.dot(along) * along).norm() == Approx(width));
    }
    CHECK(figures(inset.mesh).volume == Approx(size * size * size));
    CHECK(figures(inset.mesh).closed);
  }
}

TEST_CASE("faces that are inset together stay together, and curved ones stay sound") {
  const PolyMesh grid = test::grid(4, 3);
  const EditedMesh part = edited(grid, "inset faces=5,6 width=0.1");
  CHECK(part.mesh.face_count() == grid.face_count() + 6);
  const EditedMesh whole = edited(grid, "inset faces=all width=0.1");
  CHECK(whole.mesh.face_count() == grid.face_count() + 14);
  CHECK(figures(whole.mesh).area == Approx(12));
  for (const PolyMesh& mesh : {test::uv_sphere(12, 8), test::torus(12, 8)}) {
    const EditedMesh ring = edited(mesh, "inset faces=0-11 width=0.02");
    CHECK(figures(ring.mesh).closed);
    CHECK(figures(ring.mesh).self_intersections == figures(mesh).self_intersections);
    CHECK(figures(ring.mesh).euler_characteristic == figures(mesh).euler_characteristic);
  }
}

TEST_CASE("an inset without room is refused with a width that has room") {
  for (const double size : {1.0, 0.003, 800.0}) {
    const PolyMesh cube = test::scaled(test::cube(), size);
    const Finding finding = refusal(cube, "inset faces=2 width=" + to_text(0.51 * size));
    CHECK(finding.code == "E_INPUT");
    CHECK(finding.subjects.front().index == 2);
    const std::size_t at = finding.message.rfind(' ');
    const double room = std::stod(finding.message.substr(at + 1));
    CHECK(room == Approx(0.5 * size).epsilon(0.01));
    CHECK_NOTHROW(edited(cube, "inset faces=2 width=" + to_text(0.98 * room)));
  }
}

TEST_CASE("each line counts the elements that the one before made") {
  const EditedMesh moved = edited(test::grid(1, 1), "extrude faces=0 by=0,0,1; extrude faces=0 by=0,0,1");
  CHECK(moved.mesh.face_count() == 1 + 4 + 4);
  const auto top = moved.mesh.face(0);
  for (const Index v : top) CHECK(moved.mesh.positions[v].z() == 2);
  const Finding finding = refusal(test::cube(), "delete faces=5; extrude faces=5 distance=1");
  CHECK(finding.code == "E_EDIT");
  CHECK(finding.message.find("'extrude faces=5 distance=1'") != std::string::npos);
  CHECK(finding.message.find("only 5 faces") != std::string::npos);
  CHECK(refusal(test::cube(), "delete faces=all; pin vertices=all").code == "E_EDIT");
}

TEST_CASE("moving back and forth gives the mesh back, turning and scaling about the middle leave the middle") {
  const PolyMesh torus = test::torus(9, 6);
  const EditedMesh same = edited(torus, "move edges=3-20 by=1,2,4; move edges=3-20 by=-1,-2,-4");
  CHECK(same.mesh.corners == torus.corners);
  for (std::size_t v = 0; v < torus.vertex_count(); ++v) {
    CHECK((same.mesh.positions[v] - torus.positions[v]).norm() < 1e-12);
  }
  const EditedMesh turned = edited(torus,
                                   "rotate vertices=all axis=1,1,0 degrees=120; scale faces=all factors=2,2,2; rotate "
                                   "vertices=all axis=1,1,0 degrees=240");
  for (std::size_t v = 0; v < torus.vertex_count(); ++v) {
    CHECK((turned.mesh.positions[v] - 2 * torus.positions[v]).norm() < 1e-9);
  }
}

TEST_CASE("what an edit refuses is refused in a sentence") {
  const PolyMesh cube = test::cube();
  CHECK(refusal(cube, "extrude faces=0").message.find("distance") != std::string::npos);
  CHECK(refusal(cube, "rotate faces=0 axis=0,0,0").code == "E_INPUT");
  CHECK(refusal(cube, "loop-cut edges=0,1").message.find("one edge") != std::string::npos);
  for (const char* vector : {"1,2", "1,2,3,4", "a,b,c", "1,2,nan", "1,,2"}) {
    CHECK(refusal(cube, std::string("move faces=0 by=") + vector).code == "E_PARAMETER");
  }
}

TEST_CASE("random edits on random meshes never break a mesh that was sound") {
  test::Random random(21);
  const std::vector<const char*> lines = {"extrude faces=# distance=0.1",
                                          "inset faces=# width=0.001",
                                          "loop-cut edges=#",
                                          "dissolve edges=#",
                                          "move vertices=# by=0.01,0,0",
                                          "pin vertices=#",
                                          "sharpness edges=# value=3"};
  for (int round = 0; round < 30; ++round) {
    PolyMesh mesh = round % 2 == 0 ? test::torus(7, 5) : test::cube();
    for (int step = 0; step < 8; ++step) {
      std::string line = lines[random.below(static_cast<std::uint32_t>(lines.size()))];
      line.replace(line.find('#'), 1, std::to_string(random.below(5)));
      INFO(line);
      try {
        mesh = edited(mesh, line).mesh;
      } catch (const Error& error) {
        CHECK((error.findings().front().code == "E_INPUT" || error.findings().front().code == "E_EDIT"));
      }
    }
    CHECK(validate(mesh).empty());
    const MeshReport report = figures(mesh);
    CHECK(report.closed);
    CHECK(report.oriented);
    CHECK(report.euler_characteristic == (round % 2 == 0 ? 0 : 2));
  }
}

TEST_CASE("lines found again by position are the same ones on the same mesh, and follow new numbers") {
  const PolyMesh torus = test::torus(9, 7);
  const auto lines = parse_edit_lines(
      "move vertices=5,11 by=0,0,0.02; extrude faces=20,21 distance=0.1; sharpness edges=3,9; pin vertices=all");
  Progress progress;
  CHECK(lines_by_position(torus, torus, lines, progress) == lines);
  const auto found = lines_by_position(torus, test::shuffled(torus, 3), lines, progress);
  REQUIRE(found.size() == lines.size());
  for (std::size_t i = 0; i < lines.size(); ++i) {
    CHECK(found[i].parameters == lines[i].parameters);
    CHECK(found[i].target.elements.size() == lines[i].target.elements.size());
  }
  CHECK_THROWS_AS(lines_by_position(test::cube(), torus, lines, progress), Error);
}

TEST_CASE("an edit begins with numbers only where its defaults do nothing") {
  const PolyMesh cube = test::cube();
  const MeshTopology topology(cube);
  for (const Edit& edit : all_edits()) {
    const EditDescription& description = edit.description;
    const EditLine line = starting_line(cube, topology, edit, {description.kinds.front(), false, {0}});
    INFO(to_text(line));
    CHECK(line.parameters.size() == (description.start ? 1 : 0));
    if (description.start) CHECK_NOTHROW(apply_edit(cube, topology, line));
  }
}

}  // namespace
}  // namespace croquis

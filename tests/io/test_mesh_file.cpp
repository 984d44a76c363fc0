// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <atomic>
#include <cmath>

#include <catch2/catch.hpp>

#include "croquis/geometry/mesh_report.h"
#include "croquis/io/mesh_file.h"
#include "io/mesh_compare.h"
#include "io/scratch.h"
#include "support/meshes/mesh_shapes.h"
#include "support/random.h"

using namespace croquis;
using namespace croquis::test;

namespace {

struct Encoding {
  MeshFormat format;
  bool ascii;
};

const std::vector<Encoding> keeping_all = {
    {MeshFormat::Obj, true}, {MeshFormat::Ply, true}, {MeshFormat::Ply, false}, {MeshFormat::Off, true}};

// Coordinates that use every bit of a double.
PolyMesh awkward(PolyMesh mesh, std::uint64_t seed) {
  Random random(seed);
  for (Vec3& p : mesh.positions) {
    for (double& x : p) x = (x + random.between(-1, 1)) * std::pow(10.0, random.between(-12, 12));
  }
  return mesh;
}

std::vector<PolyMesh> family() {
  return {tetrahedron(),
          cube(),
          uv_sphere(11, 7),
          torus(7, 5),
          grid(5, 4),
          moebius(6),
          tetrahedra_sharing_edge(),
          awkward(uv_sphere(40, 30), 1),
          awkward(random_soup(3, 50), 2)};
}

}  // namespace

TEST_CASE("a format is known by its extension in any case") {
  CHECK(mesh_format_of("a/b.c/model.OBJ") == MeshFormat::Obj);
  CHECK(mesh_format_of("ply") == MeshFormat::Ply);
  CHECK(mesh_format_of(".Stl") == MeshFormat::Stl);
  CHECK(mesh_format_of("x.off") == MeshFormat::Off);
  CHECK(mesh_format_of("x.glb") == MeshFormat::Glb);
  for (const char* other : {"", "x.svg", "dir.obj/file", "a/obj", "model.obj.bak"}) CHECK(!mesh_format_of(other));
}

TEST_CASE("every format of the list is read and written") {
  Progress progress;
  for (const MeshFormat format : mesh_formats()) {
    INFO(to_string(format));
    CHECK(mesh_format_of("x" + extension_of(format)) == format);
    const std::string bytes = write_mesh(cube(), format, {}, progress).bytes;
    const Findings refused = findings_of([&] { read_mesh(bytes, format, "cube", progress); });
    CHECK(refused.empty());
  }
}

TEST_CASE("polygons, vertex order and every bit of a coordinate survive OBJ, PLY and OFF") {
  for (const PolyMesh& mesh : family()) {
    for (const Encoding& encoding : keeping_all) {
      const MeshWriteResult written = write(mesh, encoding.format, {0, encoding.ascii});
      CHECK(written.warnings.empty());
      CHECK(difference(read(written.bytes, encoding.format).mesh, mesh) == "");
    }
  }
}

TEST_CASE("the report's area and volume are those of the triangles in STL and GLB files, for bent polygons too") {
  Random random(5);
  std::vector<PolyMesh> meshes = {bent_box(), scaled(shuffled(bent_box(), 1), 7), cube(), double_torus()};
  for (const PolyMesh& shape : {torus(7, 5), double_torus(), uv_sphere(9, 7)}) {
    PolyMesh mesh = shape;
    for (Vec3& position : mesh.positions) {
      for (double& x : position) x = static_cast<double>(static_cast<float>(x + random.between(-0.1, 0.1)));
    }
    meshes.push_back(std::move(mesh));
  }
  for (const PolyMesh& mesh : meshes) {
    Progress progress;
    const MeshReport told = inspect(mesh, true, progress);
    for (const Encoding& encoding :
         {Encoding{MeshFormat::Stl, false}, {MeshFormat::Stl, true}, {MeshFormat::Glb, false}}) {
      const MeshReport written =
          inspect(read(write(mesh, encoding.format, {0, encoding.ascii}).bytes, encoding.format).mesh, true, progress);
      CHECK(written.closed);
      CHECK(*written.volume == Approx(*told.volume).epsilon(1e-12));
      CHECK(written.area == Approx(told.area).epsilon(1e-12));
      CHECK((*written.self_intersections > 0) == (*told.self_intersections > 0));
    }
  }
}

TEST_CASE("writing what was read gives the same bytes") {
  for (const PolyMesh& mesh : family()) {
    for (const Encoding& encoding : keeping_all) {
      const std::string once = write(mesh, encoding.format, {0, encoding.ascii}).bytes;
      CHECK(write(read(once, encoding.format).mesh, encoding.format, {0, encoding.ascii}).bytes == once);
    }
  }
}

TEST_CASE("as_written gives exactly the positions that read back") {
  const PolyMesh rough = awkward(cube(), 9);
  PolyMesh floats = rough;
  for (Vec3& p : floats.positions) {
    for (double& x : p) x = static_cast<double>(static_cast<float>(x));
  }
  for (const PolyMesh& mesh : {rough, floats}) {
    for (const int precision : {0, 1, 3, 9, 17}) {
      for (const bool ascii : {false, true}) {
        for (const MeshFormat format : {MeshFormat::Obj, MeshFormat::Ply, MeshFormat::Off}) {
          const MeshWriteOptions options{precision, ascii};
          const PolyMesh back = read(write(mesh, format, options).bytes, format).mesh;
          CHECK(difference(back, as_written(mesh, format, options)) == "");
          if (keeps_positions(mesh, format, options)) CHECK(back.positions == mesh.positions);
        }
        const MeshWriteOptions options{precision, ascii};
        INFO(precision << ascii);
        const PolyMesh stl = as_written(triangulated(mesh), MeshFormat::Stl, options);
        const PolyMesh back = read(write(triangulated(mesh), MeshFormat::Stl, options).bytes, MeshFormat::Stl).mesh;
        for (std::size_t f = 0; f < back.face_count(); ++f) {
          for (std::size_t i = 0; i < 3; ++i) {
            CHECK(back.positions[back.face(f)[i]] == stl.positions[stl.face(f)[i]]);
          }
        }
      }
    }
  }
}

TEST_CASE("a precision shortens text and rounds to that many digits") {
  PolyMesh mesh = tetrahedron();
  mesh.positions[0] = Vec3(1.23456789, -0.000123456789, 12345.6789);
  const PolyMesh back = read(write(mesh, MeshFormat::Obj, {4, false}).bytes, MeshFormat::Obj).mesh;
  CHECK(back.positions[0] == Vec3(1.235, -0.0001235, 1.235e4));
}

TEST_CASE("a byte order mark before text is no damage") {
  for (const MeshFormat format : {MeshFormat::Obj, MeshFormat::Ply, MeshFormat::Off, MeshFormat::Stl}) {
    const std::string bytes = write(tetrahedron(), format, {0, true}).bytes;
    CHECK(difference(read("\xef\xbb\xbf" + bytes, format).mesh, read(bytes, format).mesh) == "");
  }
  CHECK(refusal("\xef\xbb\xbf", MeshFormat::Obj)[0].code == "E_EMPTY");
}

TEST_CASE("files of nothing are empty in every format") {
  for (const MeshFormat format :
       {MeshFormat::Obj, MeshFormat::Ply, MeshFormat::Stl, MeshFormat::Off, MeshFormat::Glb}) {
    for (const std::string bytes : {"", "\n", " \r\n\t\n"}) CHECK(refusal(bytes, format)[0].code == "E_EMPTY");
  }
}

TEST_CASE("files without faces and with all points equal are malformed in every format") {
  PolyMesh points;
  points.positions = {Vec3(0, 0, 0), Vec3(1, 0, 0)};
  PolyMesh point;
  point.positions.assign(4, Vec3(1, 1, 1));
  point.add_triangle(0, 1, 2);
  point.add_triangle(1, 2, 3);
  for (const Encoding& encoding : keeping_all) {
    const MeshWriteOptions options{0, encoding.ascii};
    CHECK(refusal(write(points, encoding.format, options).bytes, encoding.format)[0].code == "E_NO_FACES");
    CHECK(refusal(write(point, encoding.format, options).bytes, encoding.format)[0].code == "E_DEGENERATE");
  }
  CHECK(refusal(write(point, MeshFormat::Stl).bytes, MeshFormat::Stl)[0].code == "E_DEGENERATE");
  CHECK(refusal("solid none\nendsolid none\n", MeshFormat::Stl)[0].code == "E_NO_FACES");
}

TEST_CASE("faces that use a vertex twice are kept and told once") {
  const MeshReadResult result =
      read("OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n3 0 1 2\n3 0 1 1\n4 0 1 0 2\n3 1 2 3\n", MeshFormat::Off);
  CHECK(result.mesh.face_count() == 4);
  REQUIRE(result.warnings.size() == 1);
  CHECK(result.warnings[0].code == "W_DEGENERATE");
  REQUIRE(result.warnings[0].subjects.size() == 3);
  CHECK(result.warnings[0].subjects[1].index == 1);
  CHECK(result.warnings[0].subjects[2].index == 2);
}

TEST_CASE("all findings come at once, at most a hundred of a kind and then how many more") {
  std::string text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv nan 0 0\n";
  for (int i = 0; i < 250; ++i) text += "f 1 2 77\n";
  const Findings findings = refusal(text, MeshFormat::Obj);
  CHECK(findings.size() == 102);
  CHECK(findings[0].code == "E_NOT_FINITE");
  CHECK(findings[101].code == "E_INDEX");
  CHECK_THAT(findings[101].message, Catch::Contains("150 more"));
}

TEST_CASE("positions that are not finite can be kept for a caller who drops their faces") {
  const std::string text = "v 0 0 0\nv 1 0 0\nv 0 nan 0\nv 0 1 0\nf 1 2 3\nf 1 2 4\n";
  Progress progress;
  MeshSource source{text, MeshFormat::Obj, "file"};
  source.keep_not_finite = true;
  const MeshReadResult result = read_mesh(source, progress);
  CHECK(result.mesh.face_count() == 2);
  REQUIRE(result.warnings.size() == 1);
  CHECK(result.warnings[0].code == "W_NOT_FINITE");
  CHECK(result.warnings[0].subjects.at(1).index == 2);
}

TEST_CASE("what OBJ and OFF can't hold is told in one warning that names it") {
  const PolyMesh mesh = with_attributes(cube());
  for (const MeshFormat format : {MeshFormat::Obj, MeshFormat::Off}) {
    const Findings warnings = write(mesh, format).warnings;
    REQUIRE(warnings.size() == 1);
    CHECK(warnings[0].code == "W_FORMAT_LOSS");
    for (const char* name : {"'confidence'", "'sensor'", "'patch'", "'tag'"}) {
      CHECK_THAT(warnings[0].message, Catch::Contains(name));
    }
  }
}

TEST_CASE("no format of meshes can hold attributes of edges, and each says so") {
  PolyMesh mesh = tetrahedron();
  mesh.channels.push_back({"weight", Domain::Edge, 1, std::vector<float>(6, 1), {}});
  for (const MeshFormat format :
       {MeshFormat::Obj, MeshFormat::Ply, MeshFormat::Stl, MeshFormat::Off, MeshFormat::Glb}) {
    const Findings warnings = write(mesh, format).warnings;
    REQUIRE(warnings.size() == 1);
    CHECK(warnings[0].code == "W_FORMAT_LOSS");
    CHECK_THAT(warnings[0].message, Catch::Contains("'weight' of edges"));
  }
}

TEST_CASE("every format but OBJ says that it can't hold tags") {
  PolyMesh mesh = tetrahedron();
  mesh.tags = {{{{0, 1}, 2}}, {1, 2}, {}};
  CHECK(write(mesh, MeshFormat::Obj).warnings.empty());
  for (const MeshFormat format : {MeshFormat::Ply, MeshFormat::Stl, MeshFormat::Off, MeshFormat::Glb}) {
    const Findings warnings = write(mesh, format).warnings;
    REQUIRE(warnings.size() == 1);
    CHECK_THAT(warnings[0].message, Catch::Contains("1 sharp edge and 2 pins"));
  }
}

TEST_CASE("reading and writing stop when asked to and report progress up to one") {
  const PolyMesh mesh = grid(400, 400);
  for (const Encoding& encoding : {Encoding{MeshFormat::Obj, true},
                                   {MeshFormat::Ply, true},
                                   {MeshFormat::Ply, false},
                                   {MeshFormat::Off, true},
                                   {MeshFormat::Stl, true},
                                   {MeshFormat::Stl, false},
                                   {MeshFormat::Glb, false}}) {
    const MeshWriteOptions options{0, encoding.ascii};
    const std::string bytes = write(mesh, encoding.format, options).bytes;
    double last = 0;
    int reports = 0;
    Progress watched([&](double fraction, const std::string&) {
      CHECK(fraction >= last);
      last = fraction;
      ++reports;
    });
    read_mesh(bytes, encoding.format, "file", watched);
    CHECK(last == 1);
    CHECK(reports > 1);
    const std::atomic<bool> cancel = true;
    Progress cancelled({}, &cancel);
    CHECK_THROWS_AS(read_mesh(bytes, encoding.format, "file", cancelled), Cancelled);
    CHECK_THROWS_AS(write_mesh(mesh, encoding.format, options, cancelled), Cancelled);
  }
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "cli/process.h"
#include "croquis/io/mesh_file.h"
#include "support/meshes/mesh_shapes.h"

namespace croquis::test {
namespace {

using Json = nlohmann::json;

std::string bytes_of(const PolyMesh& mesh, MeshFormat format) {
  Progress progress;
  return write_mesh(mesh, format, {}, progress).bytes;
}

TEST_CASE("info reports a torus from every format") {
  const ScratchFolder folder;
  for (const auto& [format, name] : {std::pair{MeshFormat::Obj, "t.obj"},
                                     {MeshFormat::Ply, "t.ply"},
                                     {MeshFormat::Stl, "t.stl"},
                                     {MeshFormat::Off, "t.off"}}) {
    const std::string path = folder.write(name, bytes_of(torus(24, 12), format));
    const ProcessResult result = run_cli({"info", path, "--json", "--quiet", "--self-intersections"});
    INFO(name << result.err);
    REQUIRE(result.code == 0);
    const Json mesh = Json::parse(result.out)["mesh"];
    CHECK(mesh["vertices"] == 24 * 12);
    CHECK(mesh["euler_characteristic"] == 0);
    CHECK(mesh["genus"] == 1);
    CHECK(mesh["closed"] == true);
    CHECK(mesh["oriented"] == true);
    CHECK(mesh["self_intersections"] == 0);
    CHECK(run_cli({"check", path}).code == 0);
  }
}

TEST_CASE("check refuses what is no solid and tells every reason") {
  const ScratchFolder folder;
  const auto codes = [&](const PolyMesh& mesh) {
    const std::string path = folder.write("m.ply", bytes_of(mesh, MeshFormat::Ply));
    const ProcessResult result = run_cli({"check", path, "--json", "--quiet"});
    CHECK(result.code == 4);
    std::vector<std::string> list;
    const Json report = Json::parse(result.out);
    for (const Json& error : report.at("errors")) list.push_back(error.at("code"));
    return list;
  };
  using List = std::vector<std::string>;
  CHECK(codes(grid(3, 3)) == List{"E_NOT_CLOSED"});
  PolyMesh flipped = tetrahedron();
  std::swap(flipped.corners[0], flipped.corners[1]);
  CHECK(codes(flipped) == List{"E_NOT_ORIENTED"});
  PolyMesh pierced = cube();
  const PolyMesh second = cube();
  for (const Vec3& position : second.positions) pierced.positions.push_back(position + Vec3(0.3, 0.4, 0.5));
  for (std::size_t f = 0; f < second.face_count(); ++f) {
    std::vector<Index> moved(second.face(f).begin(), second.face(f).end());
    for (Index& vertex : moved) vertex += 8;
    pierced.add_face(moved);
  }
  CHECK(codes(pierced) == List{"E_SELF_INTERSECTION"});
}

TEST_CASE("convert keeps a mesh through all formats and back") {
  const ScratchFolder folder;
  const std::string original = folder.write("a.obj", bytes_of(torus(9, 7), MeshFormat::Obj));
  REQUIRE(run_cli({"convert", original, "-o", folder / "b.ply"}).code == 0);
  REQUIRE(run_cli({"convert", folder / "b.ply", "-o", folder / "c.off"}).code == 0);
  REQUIRE(run_cli({"convert", folder / "c.off", "-o", folder / "d.obj"}).code == 0);
  CHECK(slurp(folder / "d.obj") == slurp(original));
  const ProcessResult stream = run_cli({"convert", "-", "--input-format", "obj", "-o", "-", "--output-format", "obj"},
                                       {.standard_input = slurp(original)});
  CHECK(stream.code == 0);
  CHECK(stream.out == slurp(original));
}

TEST_CASE("with -o - the JSON object is the last line of standard error") {
  const ScratchFolder folder;
  const std::string path = folder.write("a.obj", bytes_of(cube(), MeshFormat::Obj));
  const ProcessResult result = run_cli({"convert", path, "-o", "-", "--output-format", "obj", "--json"});
  REQUIRE(result.code == 0);
  CHECK(result.out.starts_with("v "));
  const auto last = result.err.rfind('\n', result.err.size() - 2);
  const Json json = Json::parse(result.err.substr(last == std::string::npos ? 0 : last + 1));
  CHECK(json["command"] == "convert");
  CHECK(json["mesh"]["faces"] == 6);
}

TEST_CASE("a format that can't hold everything says so, and --strict makes it an exit code") {
  const ScratchFolder folder;
  const std::string path = folder.write("a.obj", bytes_of(cube(), MeshFormat::Obj));
  const ProcessResult result = run_cli({"convert", path, "-o", folder / "a.stl"});
  CHECK(result.code == 0);
  CHECK(result.err.find("W_FORMAT_LOSS") != std::string::npos);
  CHECK(run_cli({"convert", path, "-o", folder / "a.stl", "--strict"}).code == 1);
}

/// Two crossed tetrahedra, closed and oriented.
PolyMesh crossed() { return merged(tetrahedron(), translated(tetrahedron(), Vec3(0.1, 0.1, 0.1))); }

TEST_CASE(
    "a mesh that is made and crosses itself is told, with the number of pairs, and --strict makes it an exit code") {
  const ScratchFolder folder;
  const std::string cage = folder.write("cage.obj", bytes_of(crossed(), MeshFormat::Obj));
  const std::string kettle = std::string(CROQUIS_SOURCE_DIR) + "/examples/data/surface/kettle.json";
  const std::vector<std::vector<std::string>> commands = {{"edit", cage, "--do", "move vertices=0 by=0,0,0.01"},
                                                          {"subdivide", cage, "--levels", "1"},
                                                          {"fill", cage},
                                                          {"surface", kettle}};
  for (std::vector<std::string> words : commands) {
    words.insert(words.end(), {"-o", folder / "out.obj", "--json", "--quiet"});
    const ProcessResult result = run_cli(words);
    INFO(words.front() << result.err);
    REQUIRE(result.code == 0);
    const Json report = Json::parse(result.out);
    const auto pairs = report["mesh"]["self_intersections"].get<std::size_t>();
    CHECK(pairs > 0);
    std::size_t told = 0;
    for (const Json& warning : report["warnings"]) {
      CHECK(warning["code"] != "W_OPEN");
      if (warning["code"] != "W_SELF_INTERSECTION") continue;
      ++told;
      CHECK_THAT(warning["message"].get<std::string>(), Catch::Contains(std::to_string(pairs) + " pairs of faces"));
    }
    CHECK(told == 1);
    words.push_back("--strict");
    CHECK(run_cli(words).code == 1);
  }
}

TEST_CASE("an open mesh in a file for printing is told, in a file of another kind it isn't") {
  const ScratchFolder folder;
  const std::string open = folder.write("open.ply", bytes_of(triangulated(grid(2, 2)), MeshFormat::Ply));
  const std::string box = folder.write("box.ply", bytes_of(triangulated(cube()), MeshFormat::Ply));
  const auto is_told = [&](const std::string& command, const std::string& input, const std::string& name) {
    const ProcessResult result = run_cli({command, input, "-o", folder / name});
    CHECK(result.code == 0);
    return result.err.find("W_OPEN") != std::string::npos;
  };
  for (const char* command : {"convert", "subdivide"}) {
    CHECK(is_told(command, open, "open.stl"));
    CHECK_FALSE(is_told(command, open, "open.obj"));
    CHECK_FALSE(is_told(command, box, "box.stl"));
  }
  const std::string bracket = std::string(CROQUIS_SOURCE_DIR) + "/examples/data/perspective/bracket.svg";
  const auto codes_without = [&](std::vector<std::string> words) {
    words.insert(words.begin(), {"perspective", bracket, "-o", folder / "bracket.obj"});
    return run_cli(words).err;
  };
  CHECK_THAT(codes_without({"--ignore", "e02", "--ignore", "e05"}), Catch::Contains("W_OPEN"));
  CHECK_THAT(codes_without({}), !Catch::Contains("W_OPEN"));
}

TEST_CASE("malformed files are refused with exit code 3, quickly and in little memory") {
  const ScratchFolder folder;
  const std::string ply =
      "ply\nformat binary_little_endian 1.0\nelement vertex 4000000000\nproperty double x\n"
      "property double y\nproperty double z\nelement face 4000000000\n"
      "property list uchar int vertex_indices\nend_header\n";
  const std::vector<std::pair<std::string, std::string>> files = {
      {"empty.obj", ""},
      {"garbage.obj", "\x01\x02 nothing of the kind \xff\xfe\n"},
      {"index.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 7\n"},
      {"nan.obj", "v 0 0 nan\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"},
      {"inf.off", "OFF\n3 1 0\n0 0 1e999\n1 0 0\n0 1 0\n3 0 1 2\n"},
      {"points.obj", "v 0 0 0\nv 1 0 0\n"},
      {"same.off", "OFF\n3 1 0\n1 1 1\n1 1 1\n1 1 1\n3 0 1 2\n"},
      {"huge.ply", ply},
      {"huge.off", "OFF\n2000000000 2000000000 0\n0 0 0\n"},
      {"truncated.stl", std::string(80, ' ') + std::string("\x10\x00\x00\x00", 4) + "short"},
  };
  for (const auto& [name, bytes] : files) {
    const std::string path = folder.write(name, bytes);
    const ProcessResult result = run_cli({"check", path, "--json"});
    INFO(name << ": " << result.err);
    CHECK(result.code == 3);
    CHECK(result.peak_kilobytes < 200 * 1024);
    const Json json = Json::parse(result.out);
    CHECK(json["error"]["code"].get<std::string>().starts_with("E_"));
    CHECK(json["error"]["message"].get<std::string>().find(name) != std::string::npos);
  }
  CHECK(run_cli({"info", folder / "missing.obj"}).code == 3);
  CHECK(run_cli({"info", folder.path().string() + "/", "--input-format", "obj"}).code == 3);
}

TEST_CASE("an output that can't be written is exit code 6 and leaves nothing behind") {
  const ScratchFolder folder;
  const std::string path = folder.write("a.obj", bytes_of(cube(), MeshFormat::Obj));
  const ProcessResult missing = run_cli({"convert", path, "-o", folder / "missing/b.ply"});
  CHECK(missing.code == 6);
  CHECK(missing.out.find("Wrote") == std::string::npos);
  CHECK(run_cli({"convert", path, "-o", path + "/b.ply"}).code == 6);
  CHECK(folder.names() == std::vector<std::string>{"a.obj"});
}

TEST_CASE("an existing output survives a failed conversion") {
  const ScratchFolder folder;
  const std::string bad = folder.write("bad.obj", "v 0 0 0\nf 1 2 3\n");
  const std::string kept = folder.write("kept.ply", "precious");
  CHECK(run_cli({"convert", bad, "-o", kept}).code == 3);
  CHECK(slurp(kept) == "precious");
}

}  // namespace
}  // namespace croquis::test

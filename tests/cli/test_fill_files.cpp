// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <set>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "cli/process.h"
#include "cli/scan_files.h"
#include "support/meshes/mesh_shapes.h"
#include "support/sanitizers.h"
#include "support/scans/scans.h"

namespace croquis::test {
namespace {

const Words formats = {"ply", "obj", "off", "stl"};

/// Volatile: GCC 12 may drop the rounding to 32 bits and back.
PolyMesh as_floats(PolyMesh mesh) {
  for (Vec3& position : mesh.positions) {
    for (double& coordinate : position) {
      const volatile float rounded = static_cast<float>(coordinate);
      coordinate = static_cast<double>(rounded);
    }
  }
  return mesh;
}

TEST_CASE("a scan with holes comes back closed, and begins with the scan, in every format") {
  for (const std::string& format : formats) {
    INFO(format);
    const ScratchFolder folder;
    const std::string input = folder.write("scan." + format, bytes_of(holed_scan(), *mesh_format_of(format)));
    const Json report = filled(input, folder / ("out." + format));
    CHECK(report["mesh"]["closed"] == true);
    CHECK(report["mesh"]["oriented"] == true);
    CHECK(report["mesh"]["components"] == 1);
    CHECK(report["mesh"]["euler_characteristic"] == 2);
    CHECK(report["mesh"]["self_intersections"] == 0);
    CHECK(report["details"]["holes"].size() == 5);
    CHECK(holes_with(report, "fill").size() == 5);
    if (format != "stl") CHECK(report["warnings"].empty());
    CHECK(run_cli({"check", folder / ("out." + format)}).code == 0);
    if (format != "stl") CHECK(begins_with(mesh_in(folder / ("out." + format)), mesh_in(input)));
  }
}

TEST_CASE("a triangle soup of an STL file is filled, its triangles first and as they were") {
  const ScratchFolder folder;
  const std::string input = folder.write("scan.stl", bytes_of(holed_scan(), MeshFormat::Stl));
  filled(input, folder / "out.stl");
  constexpr std::size_t header = 84, record = 50;
  const std::string before = slurp(input), after = slurp(folder / "out.stl");
  REQUIRE(after.size() > before.size());
  std::size_t same = 0;
  // Of each record the corners: the normal is computed.
  for (std::size_t at = header; at < before.size(); at += record) {
    if (before.compare(at + 12, 36, after, at + 12, 36) == 0) ++same;
  }
  CHECK(same == (before.size() - header) / record);
}

TEST_CASE("filling a filled file changes not a byte, and neither do threads") {
  for (const std::string& format : formats) {
    INFO(format);
    const ScratchFolder folder;
    const std::string input = folder.write("scan." + format, bytes_of(holed_scan(), *mesh_format_of(format)));
    filled(input, folder / ("a." + format));
    const Json again = filled(folder / ("a." + format), folder / ("b." + format));
    CHECK(slurp(folder / ("a." + format)) == slurp(folder / ("b." + format)));
    CHECK(again["details"]["summary"] == "No holes.");
    CHECK(again["details"]["holes"].empty());
    for (const char* threads : {"2", "8"}) {
      filled(input, folder / ("c." + format), {"--threads", threads});
      CHECK(slurp(folder / ("a." + format)) == slurp(folder / ("c." + format)));
    }
  }
}

TEST_CASE("scans of 32-bit numbers stay so, all others keep every digit") {
  const ScratchFolder folder;
  const auto has_doubles = [](const std::string& ply) {
    return ply.substr(0, ply.find("end_header")).find("double x") != std::string::npos;
  };
  filled(folder.write("single.ply", ply_of(as_floats(holed_scan()))), folder / "a.ply");
  CHECK_FALSE(has_doubles(slurp(folder / "a.ply")));
  filled(folder.write("double.ply", ply_of(holed_scan())), folder / "b.ply");
  CHECK(has_doubles(slurp(folder / "b.ply")));
  // Millimetres far from the origin.
  const PolyMesh far = translated(scaled(holed_scan(), 100), Vec3(1e6, -2e6, 3e6));
  const Json report = filled(folder.write("far.ply", ply_of(far)), folder / "c.ply");
  CHECK(report["mesh"]["closed"] == true);
  CHECK(report["mesh"]["self_intersections"] == 0);
  CHECK(begins_with(mesh_in(folder / "c.ply"), far));
}

TEST_CASE("colours go on into patches, those given stay, and faces tell their patch") {
  const ScratchFolder folder;
  PolyMesh given = holed_scan();
  std::vector<std::uint8_t> colors;
  for (const Vec3& p : given.positions) {
    for (int i = 0; i < 3; ++i) colors.push_back(static_cast<std::uint8_t>(100 + 50 * p[i]));
  }
  given.channels.push_back({"color", Domain::Vertex, 3, colors, {}});
  const Json report = filled(folder.write("scan.ply", ply_of(given)), folder / "out.ply");
  const PolyMesh mesh = mesh_in(folder / "out.ply");
  const auto& painted = std::get<std::vector<std::uint8_t>>(mesh.channel("color", Domain::Vertex)->data);
  CHECK(std::equal(colors.begin(), colors.end(), painted.begin()));
  for (std::size_t i = colors.size(); i < painted.size(); ++i) {
    const double there = 100 + 50 * mesh.positions[i / 3][static_cast<Eigen::Index>(i % 3)];
    CHECK(std::abs(painted[i] - there) < 12);  // colours continue a plane's, the sphere bends away from it
  }
  const auto& patches = std::get<std::vector<std::int32_t>>(mesh.channel("patch_id", Domain::Face)->data);
  const auto old_end = patches.begin() + static_cast<std::ptrdiff_t>(given.face_count());
  CHECK(std::all_of(patches.begin(), old_end, [](std::int32_t id) { return id == -1; }));
  // Four holes' patches: the ring and its island share one.
  CHECK(std::set<std::int32_t>(old_end, patches.end()) == std::set<std::int32_t>{0, 1, 2, 3});
  filled(folder / "scan.ply", folder / "plain.ply", {"--patch-ids=false"});
  CHECK(mesh_in(folder / "plain.ply").channel("patch_id", Domain::Face) == nullptr);
  CHECK(mesh_in(folder / "plain.ply").corners == mesh.corners);
}

TEST_CASE("files that can't be read are refused with their code and leave nothing behind") {
  struct Case {
    std::string name, bytes, code;
  };
  const std::string good = ply_of(holed_sphere());
  const std::string header =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n";
  const std::vector<Case> cases = {
      {"empty.ply", "", "E_EMPTY"},
      {"cut.ply", good.substr(0, good.size() - 20), "E_TRUNCATED"},
      {"garbage.obj", "\x01\x02\xff garbage\n", "E_SYNTAX"},
      {"counts.off", "OFF\n2000000000 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", "E_COUNT"},
      {"index.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 7\n", "E_INDEX"},
      {"negative.ply",
       header + "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 -2\n",
       "E_INDEX"},
      {"nan.obj", "v 0 0 nan\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "E_NOT_FINITE"},
      {"points.ply", header + "end_header\n0 0 0\n1 0 0\n0 1 0\n", "E_NO_FACES"},
      {"point.off", "OFF\n3 1 0\n1 1 1\n1 1 1\n1 1 1\n3 0 1 2\n", "E_DEGENERATE"},
      {"claims.ply",
       "ply\nformat binary_little_endian 1.0\nelement vertex 4000000000\nproperty float x\nproperty float y\nproperty "
       "float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n0",
       "E_TRUNCATED"}};
  const ScratchFolder folder;
  for (const Case& bad : cases) {
    INFO(bad.name);
    const ProcessResult result =
        run_cli({"fill", folder.write(bad.name, bad.bytes), "-o", folder / "out.ply", "--json"});
    CHECK(result.code == 3);
    const Json json = Json::parse(result.out);
    CHECK(json["command"] == "fill");
    const std::string code = json["error"]["code"];
    CHECK((code == bad.code || (bad.code == "E_COUNT" && code == "E_TRUNCATED")));
    CHECK(json["error"]["message"].get<std::string>().find(bad.name) != std::string::npos);
    CHECK(result.peak_kilobytes < 100 * 1024);
    CHECK_FALSE(std::filesystem::exists(folder / "out.ply"));
  }
  CHECK(run_cli({"fill", folder / "missing.ply", "-o", folder / "out.ply"}).code == 3);
}

TEST_CASE("bad vertices are dropped on request, with their faces and nothing else") {
  PolyMesh given = holed_sphere();
  const PolyMesh whole = given;
  std::vector<std::int32_t> numbers;
  for (std::size_t v = 0; v < given.vertex_count(); ++v) numbers.push_back(static_cast<std::int32_t>(v));
  given.channels.push_back({"number", Domain::Vertex, 1, numbers, {}});
  constexpr Index bad = 50;
  const auto lost = static_cast<std::size_t>(
      std::count_if(whole.corners.begin(), whole.corners.end(), [](Index v) { return v == bad; }));
  const ScratchFolder folder;
  for (const double value : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    given.positions[bad].y() = value;
    const std::string input = folder.write("scan.ply", ply_of(given));
    const ProcessResult refused = run_cli({"fill", input, "-o", folder / "out.ply", "--json"});
    CHECK(refused.code == 3);
    const Json subjects = Json::parse(refused.out)["error"]["subject"];
    CHECK(std::any_of(subjects.begin(), subjects.end(),
                      [](const Json& subject) { return subject["kind"] == "vertex" && subject["id"] == "50"; }));
    const Json report = filled(input, folder / "out.ply", {"--drop-bad"});
    CHECK(codes_of(report["warnings"]) == Words{"W_NOT_FINITE", "W_BAD_DROPPED"});
    CHECK(report["details"]["untouched_vertices"] == given.vertex_count() - 1);
    CHECK(report["details"]["holes"].size() == 2);
    CHECK(report["mesh"]["closed"] == true);
    CHECK(report["mesh"]["faces"] == whole.face_count() - lost + report["details"]["new_faces"].get<std::size_t>());
    const PolyMesh mesh = mesh_in(folder / "out.ply");
    const auto& kept = std::get<std::vector<std::int32_t>>(mesh.channel("number", Domain::Vertex)->data);
    for (std::size_t v = 0; v + 1 < given.vertex_count(); ++v) {
      const std::size_t old = v < bad ? v : v + 1;
      CHECK(kept[v] == static_cast<std::int32_t>(old));
      CHECK(mesh.positions[v] == whole.positions[old]);
    }
  }
  const std::string clean = folder.write("clean.ply", ply_of(whole));
  CHECK(filled(clean, folder / "out.ply", {"--drop-bad"})["warnings"].empty());
  const std::string none = folder.write("none.obj", "v 0 0 nan\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  CHECK(run_cli({"fill", none, "-o", folder / "none.ply", "--drop-bad"}).code == 3);
  CHECK_FALSE(std::filesystem::exists(folder / "none.ply"));
}

TEST_CASE("a scan is piped through") {
  const ScratchFolder folder;
  const std::string input = folder.write("scan.ply", ply_of(holed_sphere()));
  filled(input, folder / "out.ply");
  const ProcessResult piped =
      run_cli({"fill", "-", "--input-format", "ply", "-o", "-", "--output-format", "ply", "--json", "--quiet"},
              {.standard_input = slurp(input)});
  CHECK(piped.code == 0);
  CHECK(piped.out == slurp(folder / "out.ply"));
  CHECK(Json::parse(piped.err)["mesh"]["closed"] == true);
}

TEST_CASE("filling stops at its limits without a trace") {
  const ScratchFolder folder;
  const std::string input = folder.write("scan.ply", ply_of(random_cuts(round_sphere(6), 3, 12, 0.1, 0.2).mesh));
  const ProcessResult late = run_cli({"fill", input, "-o", folder / "out.ply", "--timeout", "0.02", "--json"});
  CHECK(late.code == 5);
  CHECK(Json::parse(late.out)["error"]["code"] == "E_TIMEOUT");
  if (!is_sanitized) {
    const ProcessResult large = run_cli({"fill", input, "-o", folder / "out.ply", "--max-memory", "24M", "--json"});
    CHECK(large.code == 5);
    CHECK(Json::parse(large.out)["error"]["code"] == "E_MEMORY");
  }
  CHECK(folder.names() == Words{"scan.ply"});
  CHECK(run_cli({"fill", input, "-o", folder / "no/such/folder.ply"}).code == 6);
}

}  // namespace
}  // namespace croquis::test

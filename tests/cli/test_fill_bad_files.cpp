// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "cli/process.h"
#include "cli/scan_files.h"
#include "support/meshes/mesh_shapes.h"
#include "support/random.h"
#include "support/sample_count.h"
#include "support/sanitizers.h"
#include "support/scans/scans.h"

/// Files as strangers have them, damaged in every way: none crashes, hangs, eats memory or leaves something behind.
namespace croquis::test {
namespace {

const Words formats = {"ply", "obj", "off", "stl"};

/// Exit code 3 with a finding that names the file, in under a second (× slowness) and 200 MB, and nothing written.
void check_refused(const ScratchFolder& folder, const std::string& input) {
  const ProcessResult result = run_cli({"fill", input, "-o", folder / "out.ply", "--json"});
  CHECK(result.code == 3);
  CHECK(result.cpu_seconds < slowness);
  CHECK(result.peak_kilobytes < 200 * 1024);
  const Json json = Json::parse(result.out);
  REQUIRE(json["errors"].size() > 0);
  CHECK(json["error"]["message"].get<std::string>().find(std::filesystem::path(input).filename()) != std::string::npos);
  CHECK(json["error"]["code"].get<std::string>().starts_with("E_"));
  CHECK_FALSE(std::filesystem::exists(folder / "out.ply"));
}

TEST_CASE("a file that ends too early is refused, wherever it ends") {
  const PolyMesh scan = holed_sphere();
  for (const std::string& format : formats) {
    const std::string whole = bytes_of(scan, *mesh_format_of(format));
    const auto steps = static_cast<std::size_t>(sample_count(8, 100));
    for (std::size_t i = 0; i < steps; ++i) {
      INFO(format << " " << i);
      const ScratchFolder folder;
      const std::string input = folder.write("scan." + format, whole.substr(0, whole.size() * i / steps));
      if (format == "obj") {  // a shorter one may be a whole one
        const int code = run_cli({"fill", input, "-o", folder / "out.ply"}).code;
        CHECK((code == 0 || code == 3));
      } else {
        check_refused(folder, input);
      }
    }
  }
}

TEST_CASE("files with bytes changed at random are filled or refused, never worse") {
  const PolyMesh scan = cut(round_sphere(2), Vec3(0, 0, 1), 0.6).mesh;
  for (const std::string& format : formats) {
    const std::string whole = bytes_of(scan, *mesh_format_of(format));
    for (std::uint64_t seed = 0; seed < static_cast<std::uint64_t>(sample_count(10, 300)); ++seed) {
      INFO(format << " " << seed);
      Random random(seed);
      std::string damaged = whole;
      for (std::uint32_t i = 0; i <= random.below(6); ++i)
        damaged[random.below(static_cast<std::uint32_t>(damaged.size()))] = static_cast<char>(random.below(256));
      const ScratchFolder folder;
      const std::string input = folder.write("scan." + format, damaged);
      const ProcessResult result = run_cli({"fill", input, "-o", folder / "out.ply", "--json", "--select", "all"});
      CHECK((result.code == 0 || result.code == 3 || result.code == 4));
      CHECK(result.cpu_seconds < 5 * slowness);
      CHECK(result.peak_kilobytes < 200 * 1024);
      CHECK_FALSE(Json::parse(result.out).is_null());
      CHECK((result.code == 0) == std::filesystem::exists(folder / "out.ply"));
    }
  }
}

TEST_CASE("headers that claim more than the file holds are refused before memory is taken") {
  const ScratchFolder folder;
  const std::string places = "property float x\nproperty float y\nproperty float z\n";
  const std::string list = "property list uchar int vertex_indices\nend_header\n";
  const auto ply = [&](const std::string& format, const std::string& vertices, const std::string& faces) {
    return "ply\nformat " + format + " 1.0\nelement vertex " + vertices + "\n" + places + "element face " + faces +
           "\n" + list + std::string(300, '\1');
  };
  for (const char* format : {"ascii", "binary_little_endian", "binary_big_endian"}) {
    check_refused(folder, folder.write("vertices.ply", ply(format, "4000000000", "1")));
    check_refused(folder, folder.write("faces.ply", ply(format, "3", "4000000000")));
    check_refused(folder, folder.write("both.ply", ply(format, "99999999999999999999", "99999999999999999999")));
    check_refused(folder, folder.write("less.ply", ply(format, "-5", "1")));
  }
  check_refused(folder, folder.write("a.off", "OFF\n4000000000 1 0\n0 0 0\n"));
  check_refused(folder, folder.write("b.off", "OFF\n3 4000000000 0\n0 0 0\n1 0 0\n0 1 0\n"));
  check_refused(folder, folder.write("c.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n4000000000 0 1 2\n"));
  check_refused(folder, folder.write("d.stl", std::string(80, ' ') + "\xff\xff\xff\xff" + std::string(50, '\0')));
}

TEST_CASE("one bad number among many is named by its element") {
  const PolyMesh scan = holed_sphere();
  const std::string last = std::to_string(scan.vertex_count() - 1);
  struct Case {
    std::string name, kind, id, code;
    PolyMesh mesh;
  };
  std::vector<Case> cases;
  PolyMesh far = scan, none = scan, wrong = scan;
  far.positions.back().x() = std::numeric_limits<double>::infinity();
  none.positions.back().z() = std::numeric_limits<double>::quiet_NaN();
  wrong.corners.back() = static_cast<Index>(scan.vertex_count() + 3);
  cases.push_back({"far.ply", "vertex", last, "E_NOT_FINITE", far});
  cases.push_back({"none.off", "vertex", last, "E_NOT_FINITE", none});
  cases.push_back({"wrong.ply", "face", std::to_string(scan.face_count() - 1), "E_INDEX", wrong});
  for (const Case& bad : cases) {
    INFO(bad.name);
    const ScratchFolder folder;
    const std::string format = bad.name.substr(bad.name.size() - 3);
    const std::string input = folder.write(bad.name, bytes_of(bad.mesh, *mesh_format_of(format)));
    check_refused(folder, input);
    const Json json = Json::parse(run_cli({"fill", input, "-o", folder / "out.ply", "--json"}).out);
    CHECK(json["error"]["code"] == bad.code);
    const Json& subjects = json["error"]["subject"];
    CHECK(std::any_of(subjects.begin(), subjects.end(),
                      [&](const Json& subject) { return subject["kind"] == bad.kind && subject["id"] == bad.id; }));
  }
}

TEST_CASE("a model of one point, of a line, or of faces without area is refused or comes back as it is") {
  const ScratchFolder folder;
  check_refused(folder, folder.write("point.obj", "v 1 1 1\nv 1 1 1\nv 1 1 1\nf 1 2 3\n"));
  for (const char* line : {"v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n", "v 0 0 0\nv 1 0 0\nf 1 2 1\n"}) {
    const std::string input = folder.write("line.obj", line);
    const ProcessResult result = run_cli({"fill", input, "-o", folder / "line.ply", "--json", "--select", "all"});
    CHECK((result.code == 0 || result.code == 3));
    CHECK(result.cpu_seconds < slowness);
  }
}

TEST_CASE("an interrupted filling ends at once, with nothing left behind and what was there kept") {
  const ScratchFolder folder;
  const std::string input = folder.write("scan.ply", ply_of(random_cuts(round_sphere(6), 3, 40, 0.05, 0.15).mesh));
  int interruptions = 0;
  // What it reports shows that it listens by then, however busy the machine is.
  for (const char* step : {"{", "join faces", "find rims", "make patches", "verify patches"}) {
    INFO(step);
    folder.write("out.ply", "something of mine");
    const ProcessResult result =
        run_cli({"fill", input, "-o", folder / "out.ply", "--json", "--progress", "json"}, {.interrupt_at = step});
    if (result.code == 0) continue;  // it was done before
    ++interruptions;
    CHECK(result.code == 130);
    CHECK(result.cpu_seconds_interrupted < 0.2 * slowness);
    CHECK(slurp(folder / "out.ply") == "something of mine");
    CHECK(folder.names() == Words{"out.ply", "scan.ply"});
  }
  CHECK(interruptions > 0);
}

}  // namespace
}  // namespace croquis::test

// SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>
#include <string>

#include <catch2/catch.hpp>

#include "cli/process.h"
#include "croquis/io/attribute_network_file.h"
#include "croquis/io/mesh_file.h"
#include "support/scratch_folder.h"

/// Commands that make attribute networks.
namespace croquis::test {
namespace {

const std::filesystem::path shipped = std::filesystem::path(CROQUIS_SOURCE_DIR) / "examples/data";

AttributeNetwork network_in(const std::string& path) {
  AttributeNetworkReadResult read = read_attribute_network(slurp(path), path);
  CHECK(read.warnings.empty());
  return read.network;
}

TEST_CASE("every shipped sketch becomes curves whose ends are their nodes") {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(shipped)) {
    if (entry.path().extension() != ".svg") continue;
    INFO(entry.path());
    const ScratchFolder folder;
    const ProcessResult result = run_cli({"contour_network", entry.path(), "-o", folder / "curves.json"});
    INFO(result.err);
    REQUIRE(result.code == 0);
    const AttributeNetwork network = network_in(folder / "curves.json");
    CHECK(network.curves.size() >= 2);
    for (const AttributeCurve& curve : network.curves) {
      const auto control = control_polygon(network, curve);
      CHECK(control.front() == network.nodes[curve.from].point);
      CHECK(control.back() == network.nodes[curve.to].point);
    }
    ++count;
  }
  CHECK(count >= 10);
}

TEST_CASE("sharp edges of a mesh file become curves, and what is chosen wrongly is named") {
  const ScratchFolder folder;
  const std::string bolt = (shipped / "bolt.obj").string();
  REQUIRE(run_cli({"edge_network", bolt, "--select", "sharp", "-o", folder / "curves.json"}).code == 0);
  CHECK(network_in(folder / "curves.json").curves.size() == 24);

  const ProcessResult closed = run_cli({"edge_network", bolt, "-o", folder / "none.json"});
  CHECK(closed.code == 4);
  CHECK(closed.err.find("E_NO_EDGES") != std::string::npos);
  const ProcessResult wrong = run_cli({"edge_network", bolt, "--edges", "0-999", "-o", folder / "none.json"});
  CHECK(wrong.code == 2);
  CHECK(wrong.err.find("0-999") != std::string::npos);
  CHECK(!std::filesystem::exists(std::filesystem::path(folder / "none.json")));
}

TEST_CASE("a drawing of a dot alone makes no network") {
  const ScratchFolder folder;
  const std::string dot =
      folder.write("dot.svg", "<svg xmlns=\"http://www.w3.org/2000/svg\"><path id=\"p\" d=\"M 5 5 L 5 5\"/></svg>");
  const ProcessResult result = run_cli({"contour_network", dot, "-o", folder / "none.json"});
  CHECK(result.code != 0);
  CHECK(result.err.find("E_NO_STROKES") != std::string::npos);
}

TEST_CASE("holes of a mesh file are patched by curves, and networks become cages that subdivide goes on from") {
  const ScratchFolder folder;
  const std::string open = folder.write("open.obj",
                                        "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nv 1 1 1\n"
                                        "f 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\n");
  const ProcessResult patched =
      run_cli({"surface_patch", open, "--join", "crease", "-o", folder / "closed.obj", "--json", "--quiet"});
  INFO(patched.err);
  REQUIRE(patched.code == 0);
  CHECK(patched.out.find("1 of 1 hole closed.") != std::string::npos);
  CHECK(run_cli({"check", folder / "closed.obj"}).code == 0);
  const ProcessResult wrong = run_cli({"surface_patch", open, "--only", "3", "-o", folder / "none.obj"});
  CHECK(wrong.code == 2);
  CHECK(wrong.err.find("There is no hole 3") != std::string::npos);

  const std::string pocket = (shipped / "surface" / "pocket5.json").string();
  const ProcessResult cage = run_cli({"surface_cage", pocket, "--segments", "4", "-o", folder / "cage.obj"});
  INFO(cage.err);
  REQUIRE(cage.code == 0);
  CHECK(run_cli({"subdivide", folder / "cage.obj", "-o", folder / "smooth.obj"}).code == 0);
}

}  // namespace
}  // namespace croquis::test

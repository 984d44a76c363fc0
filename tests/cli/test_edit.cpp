// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "cli/process.h"
#include "cli/scan_files.h"
#include "support/meshes/mesh_shapes.h"

namespace croquis::test {
namespace {

TEST_CASE("edits come as options or as lines of a file, with the same bytes") {
  const ScratchFolder folder;
  const std::string cube_file = folder.write("cube.ply", ply_of(cube()));
  const std::string steps =
      folder.write("steps.txt", "# a box with a hole\ninset faces=1 width=0.2\n\nextrude faces=1 distance=-0.5\n");
  const ProcessResult result = run_cli({"edit", cube_file, "--do", "inset faces=1 width=0.2", "--do",
                                        "extrude faces=1 distance=-0.5", "-o", folder / "options.ply", "--json"});
  REQUIRE(result.code == 0);
  const Json report = Json::parse(result.out);
  CHECK(report["mesh"]["closed"] == true);
  CHECK(report["mesh"]["volume"].get<double>() == Approx(0.82));
  CHECK(report["details"]["edits"].size() == 2);
  REQUIRE(run_cli({"edit", cube_file, "--do", "@" + steps, "-o", folder / "file.ply"}).code == 0);
  CHECK(slurp(folder / "options.ply") == slurp(folder / "file.ply"));
  CHECK(run_cli({"check", folder / "file.ply"}).code == 0);
}

TEST_CASE("edits that can't be made are refused by their lines, and nothing is written") {
  const ScratchFolder folder;
  const std::string cube_file = folder.write("cube.ply", ply_of(cube()));
  const auto refused = [&](const std::string& lines, int code) {
    const ProcessResult result = run_cli({"edit", cube_file, "--do", lines, "-o", folder / "out.ply", "--json"});
    INFO(lines << result.err);
    CHECK(result.code == code);
    CHECK(folder.names() == Words{"cube.ply"});
    return Json::parse(result.out);
  };
  const Json two = refused("melt faces=1; inset faces=1 breadth=2", 2);
  REQUIRE(two["errors"].size() == 2);
  CHECK(two["errors"][0]["code"] == "E_EDIT");
  CHECK(two["errors"][0]["message"].get<std::string>().find("'melt faces=1'") != std::string::npos);
  CHECK(refused("extrude faces=6 distance=1", 2)["error"]["code"] == "E_EDIT");
  CHECK(refused("inset faces=1 width=0.5", 2)["error"]["code"] == "E_INPUT");
  CHECK(refused("@missing.txt", 3)["error"]["code"] == "E_FILE_OPEN");
}

TEST_CASE("the list of edits has every edit with its elements and parameters") {
  const Json list = Json::parse(run_cli({"edits", "--json"}).out)["details"]["edits"];
  CHECK(list.size() >= 10);
  for (const Json& edit : list) {
    CHECK(edit["id"].is_string());
    CHECK(!edit["elements"].empty());
    CHECK(edit["parameters"].is_array());
  }
}

}  // namespace
}  // namespace croquis::test

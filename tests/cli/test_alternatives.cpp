// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <fstream>
#include <iterator>
#include <string>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "cli/process.h"

namespace croquis::test {
namespace {

using Json = nlohmann::json;

const std::string ring_and_bar = std::string(CROQUIS_SOURCE_DIR) + "/examples/data/ring_and_bar.svg";

std::string bytes_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// The drawing with what a reading says written to its strokes.
std::string with_said(std::string svg, const Json& says) {
  for (const Json& said : says) {
    const std::string id = "id=\"" + said["stroke"].get<std::string>() + "\"";
    const std::size_t at = svg.find(id);
    REQUIRE(at != std::string::npos);
    svg.insert(at, "data-" + said["key"].get<std::string>() + "=\"" + said["value"].get<std::string>() + "\" ");
  }
  return svg;
}

TEST_CASE("readings are written one after the other, the first as without the option") {
  const ScratchFolder folder;
  REQUIRE(run_cli({"inflate", ring_and_bar, "-o", folder / "plain.obj", "--quiet"}).code == 0);
  const ProcessResult result =
      run_cli({"inflate", ring_and_bar, "-o", folder / "solid.obj", "--alternatives", "3", "--json", "--quiet"});
  INFO(result.err);
  REQUIRE(result.code == 0);
  CHECK(folder.names() == std::vector<std::string>{"plain.obj", "solid-1.obj", "solid-2.obj", "solid-3.obj"});
  CHECK(bytes_of(folder / "solid-1.obj") == bytes_of(folder / "plain.obj"));
  const Json rows = Json::parse(result.out)["details"]["alternatives"];
  REQUIRE(rows.size() == 3);
  CHECK(rows[0]["cost"] == 0);
  CHECK(rows[0]["differs"].empty());
  for (std::size_t i = 1; i < 3; ++i) {
    const std::string name = "solid-" + std::to_string(i + 1) + ".obj";
    CHECK(rows[i]["file"] == folder / name);
    CHECK(rows[i]["cost"] >= rows[i - 1]["cost"]);
    CHECK_FALSE(rows[i]["differs"].empty());
    CHECK(run_cli({"check", folder / name, "--self-intersections"}).code == 0);
    // What is said of its strokes gives that reading by itself.
    const std::string said = folder.write("said.svg", with_said(bytes_of(ring_and_bar), rows[i]["says"]));
    REQUIRE(run_cli({"inflate", said, "-o", folder / "said.obj", "--quiet"}).code == 0);
    CHECK(bytes_of(folder / "said.obj") == bytes_of(folder / name));
    CHECK(bytes_of(folder / name) != bytes_of(folder / "plain.obj"));
  }
}

TEST_CASE("a drawing without other readings says so") {
  const ScratchFolder folder;
  const std::string disc = folder.write(
      "disc.svg", R"(<svg xmlns="http://www.w3.org/2000/svg"><circle id="disc" cx="0" cy="0" r="90"/></svg>)");
  const ProcessResult all = run_cli({"inflate", disc, "-o", folder / "solid.obj", "--alternatives", "99"});
  CHECK(all.code == 0);
  CHECK(all.err.find("no more than 1 reading") != std::string::npos);
  CHECK(all.err.find("W_ALTERNATIVES") != std::string::npos);
  const ProcessResult one = run_cli({"inflate", disc, "-o", folder / "one.obj", "--alternatives", "1"});
  CHECK(one.code == 0);
  CHECK(one.err.find("W_ALTERNATIVES") == std::string::npos);
  CHECK(folder.names() == std::vector<std::string>{"disc.svg", "one-1.obj", "solid-1.obj"});
}

}  // namespace
}  // namespace croquis::test

// SPDX-License-Identifier: GPL-3.0-or-later
// run --sweep: one parameter with several values, as a sheet of pictures.
#include <cmath>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "cli/process.h"
#include "croquis/io/png.h"
#include "croquis/io/project_file.h"
#include "support/meshes/mesh_shapes.h"

namespace croquis::test {
namespace {

using Json = nlohmann::json;

/// A cube that is subdivided (levels 0 to 8), with its edges to be sharpened by an angle.
std::string smooth_cube(const ScratchFolder& folder) {
  Node cage;
  cage.name = "cage";
  cage.source = std::make_shared<const PolyMesh>(cube());
  Node smooth;
  smooth.name = "smooth";
  smooth.operation = "subdivide";
  smooth.inputs["cage"] = {1, "value"};
  Progress progress;
  save_project(folder / "a.croq", {Document().with(cage).with(smooth), {}, {}}, progress);
  return folder / "a.croq";
}

Picture picture_of(const std::string& path) { return decode_png(slurp(path), path); }

Json swept(const std::string& project, const std::string& output, const std::string& sweep, int code = 0) {
  const ProcessResult result = run_cli({"run", project, "-o", output, "--sweep", sweep, "--json"});
  INFO(result.err);
  CHECK(result.code == code);
  return Json::parse(result.out);
}

/// Pixels as dark as the text below pictures.
std::size_t ink_in(const Picture& picture, int left, int top, int width, int height) {
  std::size_t dark = 0;
  for (int y = top; y < top + height; ++y) {
    for (int x = left; x < left + width; ++x) {
      const auto at =
          4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) + static_cast<std::size_t>(x));
      if (picture.rgba[at] < 60 && picture.rgba[at + 1] < 60) ++dark;
    }
  }
  return dark;
}

TEST_CASE("a sweep of whole numbers evaluates each, and draws them in a grid with their values") {
  const ScratchFolder folder;
  const std::string project = smooth_cube(folder);
  const Json json = swept(project, folder / "a.png", "smooth.levels=0:4:5");
  const Json values = json["details"]["values"];
  REQUIRE(values.size() == 5);
  for (std::size_t i = 0; i < 5; ++i) {
    CHECK(values[i]["value"] == static_cast<double>(i));
    CHECK(values[i]["failed"] == false);
    CHECK(values[i]["errors"].empty());
    if (i > 0) CHECK(values[i]["faces"] > 3 * values[i - 1]["faces"].get<int>());
  }
  CHECK(json["warnings"].empty());
  CHECK(json["details"]["columns"] == 3);
  const Picture sheet = picture_of(folder / "a.png");
  const int across = sheet.width / 3, down = sheet.height / 2;
  CHECK(sheet.width == 3 * across);
  CHECK(sheet.height == 2 * down);
  // Text below each of the five, none below the sixth place.
  for (int place = 0; place < 6; ++place) {
    const std::size_t dark = ink_in(sheet, place % 3 * across, place / 3 * down + down - 26, across, 24);
    CHECK((dark > 20) == (place < 5));
  }
}

TEST_CASE("the values of a number are evenly spaced, both ends among them, and one value is the first") {
  const ScratchFolder folder;
  const std::string project = smooth_cube(folder);
  const Json values = swept(project, folder / "a.png", "smooth.sharp-angle=30:120:4")["details"]["values"];
  REQUIRE(values.size() == 4);
  for (std::size_t i = 0; i < 4; ++i) CHECK(values[i]["value"] == Approx(30 + 30.0 * static_cast<double>(i)));
  const Json one = swept(project, folder / "b.png", "2.levels=2:3:1");
  CHECK(one["details"]["values"].size() == 1);
  CHECK(one["details"]["values"][0]["value"] == 2);
  const Json back = swept(project, folder / "c.png", "smooth.levels=3:1:3");
  CHECK(back["details"]["values"][0]["value"] == 3);
  CHECK(back["details"]["values"][2]["value"] == 1);
  // Whole numbers between others are rounded, and none comes twice.
  const Json rounded = swept(project, folder / "d.png", "smooth.levels=0:3:3");
  CHECK(rounded["details"]["values"][1]["value"] == 2);
}

TEST_CASE("the same sweep twice is the same bytes") {
  const ScratchFolder folder;
  const std::string project = smooth_cube(folder);
  swept(project, folder / "a.png", "smooth.levels=1:2:2");
  swept(project, folder / "b.png", "smooth.levels=1:2:2");
  CHECK(slurp(folder / "a.png") == slurp(folder / "b.png"));
}

TEST_CASE("what can't be swept is one sentence, and nothing is written") {
  const ScratchFolder folder;
  const std::string project = smooth_cube(folder);
  for (const char* sweep :
       {"smooth.levels", "smooth.levels=1:2", "smooth.levels=1:2:3:4", "levels=1:2:2", "egg.levels=1:2:2",
        "smooth.colour=1:2:2", "smooth.levels=-1:2:2", "smooth.levels=0:99:2", "smooth.levels=0.5:2:2",
        "smooth.levels=1:2:0", "smooth.levels=1:2:101", "smooth.levels=1:2:x", "smooth.levels=1:3:5",
        "smooth.scheme=1:2:2", "smooth.sharp-angle=nan:2:2", "cage.levels=1:2:2"}) {
    const ProcessResult result = run_cli({"run", project, "-o", folder / "a.png", "--sweep", sweep, "--json"});
    INFO(sweep << ": " << result.err);
    CHECK(result.code == 2);
    const Json json = Json::parse(result.out);
    REQUIRE(json["errors"].size() == 1);
    CHECK(json["error"]["message"].get<std::string>().ends_with("."));
  }
  CHECK(run_cli({"run", project, "-o", folder / "a.obj", "--sweep", "smooth.levels=1:2:2"}).code == 2);
  CHECK(folder.names() == std::vector<std::string>{"a.croq"});
}

TEST_CASE("a value that fails has a tile that says so and a warning; when all fail nothing is written") {
  const ScratchFolder folder;
  // Ten levels of so many faces are refused before anything is computed.
  Node cage;
  cage.name = "cage";
  cage.source = std::make_shared<const PolyMesh>(grid(300, 300));
  Node smooth;
  smooth.name = "smooth";
  smooth.operation = "subdivide";
  smooth.inputs["cage"] = {1, "value"};
  Progress progress;
  save_project(folder / "large.croq", {Document().with(cage).with(smooth), {}, {}}, progress);
  const Json json = swept(folder / "large.croq", folder / "a.png", "smooth.levels=0:10:2");
  const Json values = json["details"]["values"];
  CHECK(values[0]["failed"] == false);
  CHECK(values[1]["failed"] == true);
  CHECK(values[1]["faces"] == 0);
  REQUIRE(values[1]["errors"].size() >= 1);
  REQUIRE(json["warnings"].size() >= 1);
  CHECK(json["warnings"][0]["message"].get<std::string>().starts_with("With levels = 10: "));
  const Picture sheet = picture_of(folder / "a.png");
  CHECK(ink_in(sheet, sheet.width / 2, 20, sheet.width / 2, 150) > 100);
  CHECK(run_cli({"run", folder / "large.croq", "-o", folder / "b.png", "--strict", "--sweep", "smooth.levels=0:10:2"})
            .code == 1);
  const ProcessResult none =
      run_cli({"run", folder / "large.croq", "-o", folder / "c.png", "--sweep", "smooth.levels=10:10:1"});
  CHECK((none.code == 4 || none.code == 5));
  CHECK(folder.names() == std::vector<std::string>{"a.png", "b.png", "large.croq"});
}

}  // namespace
}  // namespace croquis::test

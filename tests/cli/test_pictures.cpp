// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <fstream>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "cli/process.h"
#include "croquis/io/png.h"
#include "support/pictures/drawn_picture.h"
#include "support/random.h"

namespace croquis::test {
namespace {

using Json = nlohmann::json;

std::string png_of(const std::vector<InkLine>& lines, const PictureLook& look) {
  return encode_png({look.width, look.height, drawn_pixels(lines, look)});
}

std::filesystem::path written(const std::filesystem::path& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary) << bytes;
  return path;
}

/// A head with an eye and an ear, photographed on a desk.
std::string photo() {
  PictureLook look;
  look.desk = 50;
  look.fading = 0.3;
  look.shadow = 0.3;
  look.shadow_edge = 20;
  look.noise = 0.015;
  return png_of({ink_circle({500, 380}, 220), ink_circle({450, 330}, 16, true), ink_circle({820, 300}, 60)}, look);
}

/// The code of the only error, with its exit code; the sentence is about the file.
std::string refusal_of(const std::filesystem::path& input, int exit_code) {
  const ScratchFolder folder;
  const ProcessResult result = run_cli({"inflate", input, "-o", folder / "a.obj", "--json", "--quiet"});
  INFO(result.out << result.err);
  CHECK(result.code == exit_code);
  CHECK_FALSE(std::filesystem::exists(folder / "a.obj"));
  const Json error = Json::parse(result.out).at("error");
  CHECK(error.at("message").get<std::string>().find(input.filename().string()) != std::string::npos);
  return error.at("code");
}

TEST_CASE("inflate makes the solid of a photographed drawing") {
  const ScratchFolder folder;
  const ProcessResult result =
      run_cli({"inflate", written(folder / "sheet.png", photo()), "-o", folder / "a.obj", "--json", "--quiet"});
  INFO(result.err);
  REQUIRE(result.code == 0);
  const Json report = Json::parse(result.out);
  CHECK(report.at("details").at("strokes") == 3);
  CHECK(report.at("mesh").at("closed") == true);
  CHECK(report.at("mesh").at("self_intersections") == 0);
  const Json& bounds = report.at("mesh").at("bounds");
  const auto bound = [&](std::size_t end, std::size_t axis) { return bounds.at(end).at(axis).get<double>(); };
  CHECK(std::abs(bound(0, 0) - 280) < 4);
  CHECK(std::abs(bound(1, 0) - 880) < 4);
  CHECK(std::abs(bound(0, 1) + 600) < 4);
  CHECK(std::abs(bound(1, 1) + 160) < 4);
  CHECK(run_cli({"check", folder / "a.obj"}).code == 0);
  const ProcessResult piped =
      run_cli({"inflate", "-", "-o", folder / "b.obj", "--input-format", "png", "--quiet"}, {photo()});
  CHECK(piped.code == 0);
  CHECK(slurp(folder / "a.obj") == slurp(folder / "b.obj"));
}

TEST_CASE("pictures that hold no drawing, are damaged or of other formats are refused in one sentence") {
  const ScratchFolder folder;
  const std::string whole = photo();
  CHECK(refusal_of(written(folder / "half.png", whole.substr(0, whole.size() / 2)), 3) == "E_PICTURE_FILE");
  std::string changed = whole;
  changed[changed.size() / 2] = static_cast<char>(changed[changed.size() / 2] ^ 1);
  CHECK(refusal_of(written(folder / "changed.png", changed), 3) == "E_PICTURE_FILE");
  CHECK(refusal_of(written(folder / "photo.jpg", "\xFF\xD8\xFF\xE0 and so on"), 3) == "E_PICTURE_FILE");
  CHECK(refusal_of(written(folder / "blank.png", png_of({}, {})), 3) == "E_NO_STROKES");
  Random random(5);
  std::vector<InkLine> grass;
  for (int i = 0; i < 3000; ++i) {
    const Vec2 root(random.between(0, 1000), random.between(0, 750));
    grass.push_back(ink_line({root, root + Vec2(random.between(-40, 40), -random.between(30, 90))}));
  }
  CHECK(refusal_of(written(folder / "grass.png", png_of(grass, {})), 4) == "E_NO_LINE_DRAWING");
}

}  // namespace
}  // namespace croquis::test

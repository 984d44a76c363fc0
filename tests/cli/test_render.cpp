// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>

#include "cli/process.h"

namespace croquis::test {
namespace {

const char* const wedge =
    "v 0 0 0\nv 4 0 0\nv 4 2 0\nv 0 2 0\nv 0 0 -1\nv 4 0 -1\n"
    "f 1 2 3 4\nf 5 6 2 1\nf 4 3 6 5\nf 1 4 5\nf 2 6 3\n";

/// Width or height from the header of a PNG.
unsigned png_number(const std::string& png, std::size_t at) {
  unsigned number = 0;
  for (std::size_t i = 0; i < 4; ++i) number = number << 8 | static_cast<unsigned char>(png.at(at + i));
  return number;
}

TEST_CASE("render writes a picture of the size asked for, without a display") {
  const ScratchFolder folder;
  const std::string model = folder.write("wedge.obj", wedge);
  for (const char* view : {"front", "side", "top", "persp"}) {
    const ProcessResult result =
        run_cli({"render", model, "-o", folder / "p.png", "--view", view, "--size", "320x200"});
    INFO(view << result.err);
    REQUIRE(result.code == 0);
    const std::string png = slurp(folder / "p.png");
    CHECK(png.substr(1, 3) == "PNG");
    CHECK(png_number(png, 16) == 320);
    CHECK(png_number(png, 20) == 200);
  }
}

TEST_CASE("the same picture twice is the same bytes, another view or the wire is not") {
  const ScratchFolder folder;
  const std::string model = folder.write("wedge.obj", wedge);
  const auto picture = [&](std::vector<std::string> extra) {
    std::vector<std::string> arguments = {"render", model, "-o", "-", "--size", "200x150"};
    arguments.insert(arguments.end(), extra.begin(), extra.end());
    return run_cli(arguments).out;
  };
  const std::string first = picture({});
  CHECK(first == picture({}));
  CHECK(first != picture({"--view", "top"}));
  CHECK(first != picture({"--wire"}));
}

TEST_CASE("a model whose z axis points up looks as if it had been turned upright") {
  const ScratchFolder folder;
  const std::string model = folder.write("wedge.obj", wedge);
  const std::string lying = folder.write("lying.obj",
                                         "v 0 0 0\nv 4 0 0\nv 4 0 2\nv 0 0 2\nv 0 1 0\nv 4 1 0\n"
                                         "f 1 2 3 4\nf 5 6 2 1\nf 4 3 6 5\nf 1 4 5\nf 2 6 3\n");
  for (const char* view : {"front", "side", "top", "persp"}) {
    INFO(view);
    const auto picture = [&](const std::string& file, const char* up) {
      return run_cli({"render", file, "-o", "-", "--size", "200x150", "--view", view, "--up", up}).out;
    };
    CHECK(picture(model, "y") == picture(lying, "z"));
    CHECK(picture(model, "y") != picture(lying, "y"));
  }
}

TEST_CASE("a skeleton of lines alone can be drawn") {
  const ScratchFolder folder;
  const std::string lines = folder.write("lines.obj", "v 0 0 0\nv 1 2 0\nv 2 0 1\nl 1 2 3\n");
  CHECK(run_cli({"render", lines, "-o", folder / "lines.png"}).code == 0);
}

}  // namespace
}  // namespace croquis::test

// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <limits>

#include <catch2/catch.hpp>

#include "croquis/render/mesh_item.h"
#include "croquis/render/value_color.h"
#include "render/picture_probe.h"
#include "support/meshes/mesh_shapes.h"

using namespace croquis;
using namespace croquis::render;
using namespace croquis::test;

namespace {

constexpr PictureSize size = {60, 40};

/// CIE lightness of a colour, for light that a screen shows by sRGB.
double lightness(const glm::dvec3& display) {
  const auto linear = [](double level) {
    const double v = level / 255;
    return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
  };
  const double light = 0.2126 * linear(display.r) + 0.7152 * linear(display.g) + 0.0722 * linear(display.b);
  return light > 0.008856 ? 116 * std::cbrt(light) - 16 : 903.3 * light;
}

/// Three by two squares of 20 pixels, face 0 lower left; vertices are numbered by rows of four.
PolyMesh tiles(std::vector<float> confidence, std::vector<std::int32_t> patches = {}) {
  PolyMesh mesh = test::scaled(test::grid(3, 2), 20);
  mesh.channels.push_back({"confidence", Domain::Vertex, 1, std::move(confidence), {}});
  if (!patches.empty()) mesh.channels.push_back({"patch_id", Domain::Face, 1, std::move(patches), {}});
  return mesh;
}

RenderedPicture picture_of_tiles(Renderer& renderer, const PolyMesh& mesh) {
  Scene scene;
  scene.meshes.emplace_back(make_mesh_item(mesh));
  return pixel_picture(renderer, scene, size);
}

const std::vector<float> ones(12, 1.0F);

}  // namespace

TEST_CASE("values' colours get lighter all the way, evenly enough to be read in grey") {
  double before = lightness(value_color(0));
  CHECK(before < 25);
  for (int i = 1; i <= 20; ++i) {
    const double now = lightness(value_color(i / 20.0));
    CHECK(now > before + 1.5);
    before = now;
  }
  CHECK(before > 85);
}

TEST_CASE("neighbouring stops of the legend differ for people without red or green, too") {
  const std::vector<ValueSample> legend = value_legend(5);
  REQUIRE(legend.size() == 5);
  CHECK(legend.front().label == "0 %");
  CHECK(legend[3].label == "75 %");
  CHECK(legend.back().value == 1);
  CHECK(legend.back().color == value_color(1));
  for (std::size_t i = 1; i < legend.size(); ++i) {
    // Whatever the hue, lightness alone tells them apart.
    CHECK(lightness(legend[i].color) - lightness(legend[i - 1].color) > 10);
  }
  CHECK(value_legend(0).size() == 2);
}

TEST_CASE("values beyond the scale have its ends' colours, none has grey") {
  CHECK(value_color(-3) == value_color(0));
  CHECK(value_color(7) == value_color(1));
  const Color none = value_color(std::numeric_limits<double>::quiet_NaN());
  CHECK((none.r == none.g && none.g == none.b));
}

TEST_CASE("faces of patches show their values up to the rim, the scan's own stay clay") {
  with_renderer([](Renderer& renderer) {
    std::vector<float> confidence = ones;
    for (const std::size_t vertex : {0U, 1U, 4U, 5U}) confidence[vertex] = 0.25F;  // face 0's
    const PolyMesh mesh = tiles(confidence, {3, -1, -1, -1, -1, 0});
    const RenderedPicture picture = picture_of_tiles(renderer, with_value_colors(mesh));
    CHECK(count_color(picture, palette_color(0)) == 4 * 20 * 20);
    CHECK(count_color(picture, value_color(0.25)) == 20 * 20);
    CHECK(count_color(picture, value_color(1)) == 20 * 20);  // a patch without doubt is still marked
  });
}

TEST_CASE("without marks faces with doubt are coloured, and colours blend between their corners") {
  with_renderer([](Renderer& renderer) {
    std::vector<float> confidence = ones;
    confidence[0] = 0;
    const RenderedPicture picture = picture_of_tiles(renderer, with_value_colors(tiles(confidence)));
    CHECK(count_color(picture, palette_color(0)) == 5 * 20 * 20);
    CHECK(brightness(pixel(picture, 1, 38)) < brightness(value_color(0.3)));
    CHECK(brightness(pixel(picture, 18, 21)) > brightness(value_color(0.7)));
  });
}

TEST_CASE("faces that keep their colour keep the one they had") {
  with_renderer([](Renderer& renderer) {
    PolyMesh mesh = tiles(ones, {-1, -1, 0, -1, -1, -1});
    std::vector<std::array<std::uint8_t, 3>> colors(6, {10, 200, 30});
    colors[1] = {200, 10, 30};
    color_faces(mesh, colors);
    const RenderedPicture picture = picture_of_tiles(renderer, with_value_colors(mesh));
    CHECK(count_color(picture, {10, 200, 30, 255}) == 4 * 20 * 20);
    CHECK(count_color(picture, {200, 10, 30, 255}) == 20 * 20);
    CHECK(count_color(picture, value_color(1)) == 20 * 20);
  });
}

TEST_CASE("meshes without values, and faces with one that is none, stay as they are") {
  const PolyMesh plain = test::grid(3, 2);
  CHECK(with_value_colors(plain).channels.empty());
  std::vector<float> confidence(12, 0.5F);
  confidence[0] = std::numeric_limits<float>::quiet_NaN();
  const PolyMesh colored = with_value_colors(tiles(confidence));
  const auto& numbers = std::get<std::vector<float>>(colored.channel("color", Domain::Corner)->data);
  CHECK(std::isnan(numbers[0]));
  CHECK_FALSE(std::isnan(numbers[3 * 4]));
  // A moved mesh with the same values is drawn by an update, one with others anew.
  const MeshItemPtr item = make_mesh_item(colored);
  PolyMesh moved = colored;
  moved.positions[3].z() += 1;
  CHECK(update_mesh_item(item, moved)->plan == item->plan);
  CHECK(update_mesh_item(item, with_value_colors(tiles(ones)))->plan != item->plan);
}

TEST_CASE("other channels, scales and values of faces can be shown") {
  PolyMesh mesh = test::grid(2, 1);
  mesh.channels.push_back({"error", Domain::Face, 1, std::vector<double>{4, 2}, {}});
  const PolyMesh colored = with_value_colors(mesh, {"error", 4, 0, ""});
  const auto& numbers = std::get<std::vector<float>>(colored.channel("color", Domain::Corner)->data);
  CHECK(numbers[0] == Approx(value_color(0).r / 255.0));
  CHECK(numbers[3 * 4] == Approx(value_color(0.5).r / 255.0));
}

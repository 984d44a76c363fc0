// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "croquis/base/error.h"
#include "render/picture_probe.h"
#include "support/meshes/mesh_shapes.h"

using namespace croquis;
using namespace croquis::render;
using namespace croquis::test;

namespace {

constexpr PictureSize size = {60, 40};
constexpr Color orange = {255, 128, 16, 255}, white = {255, 255, 255, 255};

/// Three by two squares of 20 pixels that fill the picture, face 0 lower left.
PolyMesh tiles() { return test::scaled(test::grid(3, 2), 20); }

Color tile_color(const RenderedPicture& picture, int face) {
  return pixel(picture, 10 + 20 * (face % 3), 30 - 20 * (face / 3));
}

}  // namespace

TEST_CASE("highlighted faces take the colour exactly up to their edges, others keep theirs") {
  with_renderer([](Renderer& renderer) {
    Scene scene;
    const MeshItemPtr item = make_mesh_item(tiles());
    scene.meshes.emplace_back(item);
    scene.highlights.push_back(make_face_highlight(item, std::vector<Index>{4, 0}, orange));
    const RenderedPicture picture = pixel_picture(renderer, scene, size);
    CHECK(count_color(picture, orange) == 2 * 20 * 20);
    CHECK(count_color(picture, palette_color(0)) == 4 * 20 * 20);
    CHECK(tile_color(picture, 0) == orange);
    CHECK(tile_color(picture, 4) == orange);
  });
}

TEST_CASE("a half strong highlight is half of the face's colour, and a later one lies over it") {
  with_renderer([](Renderer& renderer) {
    Scene scene;
    const MeshItemPtr item = make_mesh_item(tiles());
    scene.meshes.emplace_back(item);
    scene.highlights.push_back(make_face_highlight(item, std::vector<Index>{1, 2}, {0, 0, 0, 128}));
    scene.highlights.push_back(make_face_highlight(item, std::vector<Index>{2}, orange));
    const RenderedPicture picture = pixel_picture(renderer, scene, size);
    CHECK(glm::length(glm::vec4(tile_color(picture, 1)) - 0.5F * glm::vec4(palette_color(0))) < 140);
    CHECK(brightness(tile_color(picture, 1)) == Approx(brightness(palette_color(0)) / 2.0).margin(2));
    CHECK(tile_color(picture, 2) == orange);
  });
}

TEST_CASE("highlights lie in the surface at any slope: no pixel of theirs flickers through") {
  with_renderer([](Renderer& renderer) {
    const MeshItemPtr item = make_mesh_item(test::uv_sphere(64, 32));
    std::vector<Index> all(64 * 32);
    for (Index f = 0; f < all.size(); ++f) all[f] = f;
    Scene scene;
    scene.meshes.emplace_back(item);
    const PictureSize large = {200, 200};
    const Camera camera = frame(item->bounds, view_direction(NamedView::Perspective), 1);
    const auto clay = [&](const Color& color) { return color == palette_color(0); };
    RenderOptions options = flat_options();
    options.supersampling = 1;
    const int covered = count_pixels(render_picture(renderer, scene, camera, options, large), clay);
    scene.highlights.push_back(make_face_highlight(item, all, orange));
    const RenderedPicture picture = render_picture(renderer, scene, camera, options, large);
    CHECK(count_color(picture, orange) == covered);
    CHECK(count_pixels(picture, clay) == 0);
  });
}

TEST_CASE("faces highlighted in a wire are filled, behind what covers them") {
  const MeshStyle style = GENERATE(MeshStyle::wire_only(), MeshStyle::hidden_lines_removed());
  with_renderer([&](Renderer& renderer) {
    Scene scene;
    const MeshItemPtr item = make_mesh_item(tiles());
    scene.meshes.emplace_back(item, Emphasis{}, style);
    scene.meshes.emplace_back(make_mesh_item(test::translated(test::scaled(test::grid(1, 2), 20), {0, 0, 5})));
    scene.highlights.push_back(make_face_highlight(item, std::vector<Index>{0, 1}, orange));
    const RenderedPicture picture = pixel_picture(renderer, scene, size);
    CHECK(tile_color(picture, 0) == palette_color(0));
    CHECK(tile_color(picture, 1) == orange);
    CHECK(tile_color(picture, 2) == white);
  });
}

TEST_CASE("a highlight of a mesh that is not shown draws nothing") {
  with_renderer([](Renderer& renderer) {
    Scene scene;
    scene.meshes.emplace_back(make_mesh_item(tiles()));
    scene.highlights = {make_face_highlight(make_mesh_item(tiles()), std::vector<Index>{0}, orange), nullptr};
    CHECK(count_color(pixel_picture(renderer, scene, size), orange) == 0);
  });
}

TEST_CASE("faces that the mesh does not have are all named") {
  try {
    make_face_highlight(make_mesh_item(tiles()), std::vector<Index>{2, 6, 99}, orange);
    FAIL("accepted");
  } catch (const Error& error) {
    REQUIRE(error.findings().size() == 2);
    CHECK(error.findings()[0].code == "E_INDEX");
    CHECK(error.findings()[1].message.find("face 99") != std::string::npos);
  }
}

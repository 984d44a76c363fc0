// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>

#include "render/picture_probe.h"
#include "support/meshes/mesh_shapes.h"

using namespace croquis;
using namespace croquis::render;
using namespace croquis::test;

namespace {

constexpr PictureSize size = {60, 60};
constexpr Color white = {255, 255, 255, 255};

/// A square of one colour about the picture's middle, at a height over the paper; a unit is a pixel.
MeshItemPtr square(double side, double height, const std::array<std::uint8_t, 3>& color) {
  PolyMesh mesh = test::translated(test::scaled(test::grid(1, 1), side), {30 - side / 2, 30 - side / 2, height});
  color_faces(mesh, {color});
  return make_mesh_item(mesh);
}

RenderedPicture draw(Renderer& renderer, const Scene& scene, int samples) {
  RenderOptions options = flat_options();
  options.supersampling = samples;
  options.occlusion = samples > 1;
  return render_picture(renderer, scene, pixel_camera(size), options, size);
}

void check_near(const Color& seen, const glm::vec3& wanted) {
  for (int i = 0; i < 3; ++i) CHECK(std::abs(static_cast<float>(seen[i]) - wanted[i]) <= 2);
}

constexpr glm::vec3 paper(255), red(255, 0, 0), blue(0, 0, 255);

}  // namespace

TEST_CASE("a translucent face lets through what is behind it, paper and surface") {
  const int samples = GENERATE(1, 3);
  with_renderer([&](Renderer& renderer) {
    Scene scene;
    scene.meshes.emplace_back(square(40, 10, {255, 0, 0}), Emphasis{}, MeshStyle::translucent(0.4));
    scene.meshes.emplace_back(square(20, 0, {0, 0, 255}));
    const RenderedPicture picture = draw(renderer, scene, samples);
    check_near(pixel(picture, 30, 30), 0.6F * blue + 0.4F * red);
    check_near(pixel(picture, 30, 15), 0.6F * paper + 0.4F * red);
    CHECK(pixel(picture, 30, 5) == white);
    CHECK(count_color(picture, white) == 60 * 60 - 40 * 40);
  });
}

TEST_CASE("what is in front of a translucent face hides it") {
  const int samples = GENERATE(1, 3);
  with_renderer([&](Renderer& renderer) {
    Scene scene;
    scene.meshes.emplace_back(square(40, 0, {255, 0, 0}), Emphasis{}, MeshStyle::translucent(0.4));
    scene.meshes.emplace_back(square(20, 10, {0, 0, 255}));
    const RenderedPicture picture = draw(renderer, scene, samples);
    CHECK(count_color(picture, {0, 0, 255, 255}) == 20 * 20);
  });
}

TEST_CASE("translucent meshes lie over each other by depth, in whatever order they are listed") {
  const bool swapped = GENERATE(false, true);
  with_renderer([&](Renderer& renderer) {
    const Shown<MeshItem> near(square(40, 10, {255, 0, 0}), {}, MeshStyle::translucent(0.5));
    const Shown<MeshItem> far(square(40, 0, {0, 0, 255}), {}, MeshStyle::translucent(0.5));
    Scene scene;
    scene.meshes = swapped ? std::vector{far, near} : std::vector{near, far};
    check_near(pixel(draw(renderer, scene, 3), 30, 30), 0.25F * paper + 0.25F * blue + 0.5F * red);
  });
}

TEST_CASE("a translucent mesh covers no marks and leaves no trace in later pictures") {
  with_renderer([](Renderer& renderer) {
    Scene scene;
    scene.meshes.emplace_back(square(20, 0, {0, 0, 255}));
    const RenderedPicture before = draw(renderer, scene, 3);
    Scene veiled = scene;
    veiled.meshes.emplace_back(square(40, 10, {255, 0, 0}), Emphasis{}, MeshStyle::translucent());
    Mark mark{{30, 30, 5}, MarkShape::Square, 8, {0, 255, 0, 255}};
    mark.outline.a = 0;
    veiled.marks.emplace_back(make_mark_item(std::vector{mark}, MarkDepth::Tested));
    CHECK(pixel(draw(renderer, veiled, 3), 30, 30) == Color(0, 255, 0, 255));
    CHECK(draw(renderer, scene, 3).rgba == before.rgba);
  });
}

TEST_CASE("opacity 1 is a mesh as ever, 0 is none") {
  with_renderer([](Renderer& renderer) {
    Scene scene;
    MeshStyle style = MeshStyle::translucent(1);
    scene.meshes.emplace_back(square(20, 0, {0, 0, 255}), Emphasis{}, style);
    CHECK(count_color(draw(renderer, scene, 3), {0, 0, 255, 255}) == 20 * 20);
    scene.meshes[0].style.opacity = 0;
    CHECK(count_color(draw(renderer, scene, 3), white) == 60 * 60);
  });
}

TEST_CASE("a translucent ball shows its far side through its near one, and its rim is denser") {
  with_renderer([](Renderer& renderer) {
    PolyMesh ball = test::translated(test::scaled(test::uv_sphere(64, 32), 25), {30, 30, 0});
    color_faces(ball, std::vector<std::array<std::uint8_t, 3>>(ball.face_count(), {0, 0, 0}));
    Scene scene;
    scene.meshes.emplace_back(make_mesh_item(ball), Emphasis{}, MeshStyle::translucent(0.5));
    const RenderedPicture picture = draw(renderer, scene, 3);
    CHECK(brightness(pixel(picture, 30, 30)) == Approx(255 * 0.25).margin(4));
    CHECK(brightness(pixel(picture, 7, 30)) < brightness(pixel(picture, 30, 30)) - 15);
  });
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <cstdlib>
#include <vector>

#include <catch2/catch.hpp>

#include "croquis/base/error.h"
#include "croquis/render/picture.h"
#include "render/picture_probe.h"
#include "support/meshes/mesh_shapes.h"

using namespace croquis;
using namespace croquis::render;
using namespace croquis::test;

namespace {

constexpr PictureSize size = {80, 60};
constexpr Color red = {200, 0, 0, 255}, green = {0, 200, 0, 255}, blue = {0, 0, 200, 255}, grey = {90, 90, 90, 255};

std::vector<std::uint8_t> bytes_of(const std::vector<Color>& pixels) {
  std::vector<std::uint8_t> bytes;
  for (const Color& one : pixels) bytes.insert(bytes.end(), {one.r, one.g, one.b, one.a});
  return bytes;
}

/// Each pixel of it covers ten of the view's.
Scene shown(const PictureItemPtr& item, double opacity = 1) {
  const PictureLevel& level = item->levels.front();
  Scene scene;
  scene.pictures.push_back({item, {20, 10, 0}, {10.0 * level.width, 0, 0}, {0, 10.0 * level.height, 0}, opacity});
  return scene;
}

PictureItemPtr four_colors() { return make_picture_item(bytes_of({red, green, blue, grey}), 2, 2); }

bool is_near(const Color& a, const Color& b, int by = 2) {
  return std::abs(a.r - b.r) <= by && std::abs(a.g - b.g) <= by && std::abs(a.b - b.b) <= by;
}

}  // namespace

TEST_CASE("the same scene gives the same bytes, from another renderer, too") {
  const PolyMesh mesh = test::rotated(test::torus(60, 30), 0.7, {1, 1, 0});
  RenderOptions options;
  options.wire = true;
  std::vector<std::vector<std::uint8_t>> pictures;
  for (int round = 0; round < 2; ++round) {
    with_renderer([&](Renderer& renderer) {
      for (int i = 0; i < 2; ++i) {
        pictures.push_back(picture_of(renderer, mesh, NamedView::Perspective, options, {160, 120}).rgba);
      }
    });
  }
  for (const auto& picture : pictures) CHECK(picture == pictures.front());
}

TEST_CASE("an empty scene is the background, light above and dark below") {
  with_renderer([](Renderer& renderer) {
    const RenderOptions options;
    const RenderedPicture picture = render_picture(renderer, Scene{}, Camera(), options, {7, 400});
    CHECK(picture.rgba.size() == 7 * 400 * 4);
    CHECK(pixel(picture, 3, 0) == options.background_top);
    CHECK(pixel(picture, 3, 399) == options.background_bottom);
    for (int y = 1; y < 400; ++y) CHECK(pixel(picture, 0, y).r <= pixel(picture, 6, y - 1).r);
  });
}

TEST_CASE("meshes without area, without faces or with one point are drawn without trouble") {
  PolyMesh flat = test::cube();
  for (Vec3& position : flat.positions) position.z() = 0;
  PolyMesh point = test::cube();
  for (Vec3& position : point.positions) position.setConstant(3);
  PolyMesh segment;
  segment.positions = {{0, 0, 0}, {1, 0, 0}};
  segment.add_face(std::vector<Index>{0, 1, 0});
  segment.add_line(std::vector<Index>{0, 1});
  PolyMesh lonely;
  lonely.positions = {{1, 2, 3}};
  RenderOptions options;
  options.wire = true;
  with_renderer([&](Renderer& renderer) {
    for (const PolyMesh& mesh : {flat, point, segment, lonely}) {
      for (const NamedView view : {NamedView::Front, NamedView::Side, NamedView::Perspective}) {
        CHECK_NOTHROW(picture_of(renderer, mesh, view, options, {64, 48}));
      }
    }
  });
}

TEST_CASE("sizes out of range are refused, width and height both named") {
  with_renderer([](Renderer& renderer) {
    try {
      render_picture(renderer, Scene{}, Camera(), {}, {0, max_picture_size + 1});
      FAIL("accepted");
    } catch (const Error& error) {
      REQUIRE(error.findings().size() == 2);
      CHECK(error.findings()[0].code == "E_PICTURE_SIZE");
      CHECK(error.findings()[0].category == Category::Usage);
      CHECK(error.findings()[1].message.find("8193") != std::string::npos);
    }
    CHECK(render_picture(renderer, Scene{}, Camera(), {}, {1, 1}).rgba.size() == 4);
  });
}

TEST_CASE("a picture in tiles shows what the same picture in one piece shows") {
  // The torus straddles the border between the first and the second tile.
  const std::vector<MeshItemPtr> items = {make_mesh_item(test::rotated(test::torus(90, 40), 1.1, {1, 0.2, 0}))};
  RenderOptions options;
  options.supersampling = 1;
  const Camera camera = frame(bounds_of(items), view_direction(NamedView::Perspective), 1.0);
  with_renderer([&](Renderer& renderer) {
    const RenderedPicture tiled = render_picture(renderer, items, camera, options, {1500, 600});
    // Half as large it fits into one tile.
    const RenderedPicture whole = render_picture(renderer, items, camera, options, {750, 300});
    double difference = 0;
    double at_seam = 0;
    for (int y = 0; y < 300; ++y) {
      for (int x = 0; x < 750; ++x) {
        const Color a = pixel(whole, x, y);
        const double b = 0.25 * (pixel(tiled, 2 * x, 2 * y).g + pixel(tiled, 2 * x + 1, 2 * y).g +
                                 pixel(tiled, 2 * x, 2 * y + 1).g + pixel(tiled, 2 * x + 1, 2 * y + 1).g);
        difference += std::abs(a.g - b);
        if (std::abs(x - 512) < 3) at_seam += std::abs(a.g - b);
      }
    }
    CHECK(difference / (750 * 300) < 2);
    CHECK(at_seam / (5 * 300) < 6);
  });
}

TEST_CASE("large coordinates and tiny ones give the same picture") {
  const PolyMesh reference = test::rotated(test::torus(60, 30), 0.7, {1, 1, 0});
  const double scale = GENERATE(1e-12, 1e12);
  with_renderer([&](Renderer& renderer) {
    const RenderedPicture a = picture_of(renderer, reference, NamedView::Perspective, {}, {160, 120});
    const RenderedPicture b =
        picture_of(renderer, test::scaled(reference, scale), NamedView::Perspective, {}, {160, 120});
    // Rounding decides on single samples at outlines, on nothing else.
    int difference = 0;
    for (std::size_t i = 0; i < a.rgba.size(); ++i) difference += std::abs(a.rgba[i] - b.rgba[i]);
    CHECK(difference < 0.3 * static_cast<double>(a.rgba.size()));
  });
}

TEST_CASE("a picture lies where it is put, upright, and nothing else changes") {
  with_renderer([](Renderer& renderer) {
    const RenderedPicture picture = pixel_picture(renderer, shown(four_colors()), size);
    // The view's rows count from above: the picture covers rows 30..49 and columns 20..39.
    CHECK(is_near(pixel(picture, 22, 32), red));
    CHECK(is_near(pixel(picture, 37, 32), green));
    CHECK(is_near(pixel(picture, 22, 47), blue));
    CHECK(is_near(pixel(picture, 37, 47), grey));
    const int covered = count_pixels(picture, [](const Color& c) { return c.r < 250 || c.g < 250 || c.b < 250; });
    CHECK(covered == 20 * 20);
  });
}

TEST_CASE("opacity and the picture's own alpha mix it with what is behind, without a dark rim") {
  with_renderer([](Renderer& renderer) {
    const auto half = make_picture_item(bytes_of(std::vector<Color>(4, {200, 0, 0, 128})), 2, 2);
    CHECK(is_near(pixel(pixel_picture(renderer, shown(half), size), 30, 40), {227, 127, 127, 255}));
    const auto full = make_picture_item(bytes_of(std::vector<Color>(4, red)), 2, 2);
    CHECK(is_near(pixel(pixel_picture(renderer, shown(full, 0.25), size), 30, 40), {241, 191, 191, 255}));
    CHECK(count_color(pixel_picture(renderer, shown(full, 0), size), {255, 255, 255, 255}) == 80 * 60);
    // Colour of what can't be seen takes no part in the mean of neighbours.
    const auto rim = make_picture_item(bytes_of({red, {0, 0, 0, 0}, red, {0, 0, 0, 0}}), 2, 2);
    const Color middle = pixel(pixel_picture(renderer, shown(rim), size), 30, 40);
    CHECK(middle.r > 220);
  });
}

TEST_CASE("surfaces cover pictures and leave them seen beside them, drawn finely or quickly; lines lie over both") {
  const bool quick = GENERATE(false, true);
  with_renderer([&](Renderer& renderer) {
    Scene scene = shown(make_picture_item(bytes_of(std::vector<Color>(4, red)), 2, 2));
    PolyMesh box = test::translated(test::scaled(test::cube(), 6), {27, 17, 0});
    color_faces(box, std::vector<std::array<std::uint8_t, 3>>(6, {0, 0, 200}));
    scene.meshes.emplace_back(make_mesh_item(box));
    RenderOptions options = flat_options();
    options.supersampling = quick ? 1 : 2;
    options.occlusion = !quick;
    const auto drawn = [&] { return draw_once(renderer, scene, pixel_camera(size), options, size); };
    const Color covered = pixel(drawn(), 30, 40);
    CAPTURE(int(covered.r), int(covered.g), int(covered.b));
    CHECK(is_near(covered, blue));
    CHECK(is_near(pixel(drawn(), 22, 32), red));
    scene.lines.emplace_back(make_line_item(LinePath{{{{20, 15.5, 0}, 1, {}}, {{40, 15.5, 0}, 1, {}}}, false},
                                            LineStyle{4, {0, 0, 0, 255}, {}, LineDepth::OnTop}));
    CHECK(is_near(pixel(drawn(), 25, 44), {0, 0, 0, 255}));
  });
}

TEST_CASE("a large picture is seen at once, comes in slices within the budget, and moving it sends nothing") {
  with_renderer([](Renderer& renderer) {
    constexpr std::size_t budget = 2'000'000;
    std::vector<std::uint8_t> pixels(std::size_t{4} * 1500 * 1000, 255);
    for (std::size_t i = 0; i < pixels.size(); i += 4) pixels[i] = pixels[i + 1] = 0;
    Scene scene = shown(make_picture_item(pixels, 1500, 1000));
    scene.pictures[0].right = {40, 0, 0};
    scene.pictures[0].upwards = {0, 30, 0};
    RenderOptions options = flat_options();
    options.upload_budget = budget;
    int drawings = 0;
    do {
      const std::size_t before = renderer.uploaded().bytes;
      const RenderedPicture picture = draw_once(renderer, scene, pixel_camera(size), options, size);
      CHECK(renderer.uploaded().bytes - before <= budget);
      CHECK(is_near(pixel(picture, 40, 40), {0, 0, 255, 255}));
      ++drawings;
    } while (renderer.pending() && drawings < 50);
    CHECK(drawings > 2);
    CHECK(drawings < 50);
    const std::size_t all = renderer.uploaded().bytes;
    scene.pictures[0].corner = {0, 0, 0};
    scene.pictures[0].opacity = 0.5;
    draw_once(renderer, scene, pixel_camera(size), options, size);
    CHECK(renderer.uploaded().bytes == all);
  });
}

TEST_CASE("pictures become smaller level by level, down to a pixel, whatever their sides") {
  const auto [width, height] = GENERATE(table<int, int>({{1, 1}, {5, 1}, {7, 3}, {64, 64}, {1, 9}}));
  const std::vector<std::uint8_t> pixels(static_cast<std::size_t>(4 * width * height), 80);
  const PictureItemPtr item = make_picture_item(pixels, width, height);
  CHECK(item->levels.back().width == 1);
  CHECK(item->levels.back().height == 1);
  for (const PictureLevel& level : item->levels) {
    CHECK(level.rgba.size() == static_cast<std::size_t>(4 * level.width * level.height));
    CHECK(level.rgba[3] == 80);
    CHECK(level.rgba[0] == 25);
  }
}

TEST_CASE("pictures of no size, too large ones, and those without all of their bytes are refused") {
  const std::vector<std::uint8_t> bytes(16, 0);
  CHECK_THROWS_AS(make_picture_item(bytes, 0, 4), Error);
  CHECK_THROWS_AS(make_picture_item(bytes, 2, 3), Error);
  CHECK_THROWS_AS(make_picture_item(std::vector<std::uint8_t>(4 * 4097), 4097, 1), Error);
  CHECK_NOTHROW(make_picture_item(bytes, 2, 2));
}

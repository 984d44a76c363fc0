// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <cstdlib>

#include <catch2/catch.hpp>

#include "croquis/base/error.h"
#include "croquis/render/picture.h"
#include "render/picture_probe.h"
#include "support/meshes/mesh_shapes.h"

using namespace croquis;
using namespace croquis::render;
using croquis::test::picture_of;
using croquis::test::pixel;
using croquis::test::with_renderer;

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
  const double size = GENERATE(1e-12, 1e12);
  with_renderer([&](Renderer& renderer) {
    const RenderedPicture a = picture_of(renderer, reference, NamedView::Perspective, {}, {160, 120});
    const RenderedPicture b =
        picture_of(renderer, test::scaled(reference, size), NamedView::Perspective, {}, {160, 120});
    // Rounding decides on single samples at outlines, on nothing else.
    int difference = 0;
    for (std::size_t i = 0; i < a.rgba.size(); ++i) difference += std::abs(a.rgba[i] - b.rgba[i]);
    CHECK(difference < 0.3 * static_cast<double>(a.rgba.size()));
  });
}

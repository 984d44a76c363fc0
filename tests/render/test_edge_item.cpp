// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <limits>
#include <vector>

#include <catch2/catch.hpp>

#include "croquis/base/error.h"
#include "croquis/render/edge_item.h"
#include "render/picture_probe.h"
#include "support/meshes/mesh_shapes.h"

using namespace croquis;
using namespace croquis::render;
using namespace croquis::test;

namespace {

constexpr PictureSize size = {80, 60};
constexpr Color magenta = {200, 0, 112, 255}, teal = {22, 156, 142, 255};

int column_of(const RenderedPicture& picture, int x, const Color& color) {
  int count = 0;
  for (int y = 0; y < picture.height; ++y) count += pixel(picture, x, y) == color ? 1 : 0;
  return count;
}

/// A roof whose two sides fall away (or rise) from its ridge at y = 30 with that slope; the ridge is vertices 2 and 3.
PolyMesh roof(double slope) {
  PolyMesh mesh;
  for (const double y : {0.0, 30.0, 60.0}) {
    for (const double x : {0.0, 80.0}) mesh.positions.emplace_back(x, y, -slope * std::abs(y - 30));
  }
  mesh.add_face(std::vector<Index>{0, 1, 3, 2});
  mesh.add_face(std::vector<Index>{2, 3, 5, 4});
  return mesh;
}

RenderedPicture picture_with(Renderer& renderer, const PolyMesh& mesh, const LineItemPtr& edges, int samples) {
  Scene scene;
  scene.meshes.emplace_back(make_mesh_item(mesh));
  scene.lines.emplace_back(edges);
  RenderOptions options = flat_options();
  options.supersampling = samples;
  Camera camera = pixel_camera(size);
  camera.eye.z = 1000;
  return render_picture(renderer, scene, camera, options, size);
}

}  // namespace

TEST_CASE("a thick edge keeps all of its width on ridges and in folds of any slope") {
  const int samples = GENERATE(1, 3);
  const double slope = GENERATE(0.0, 1.0, 3.0, -1.0, -3.0, 20.0);
  with_renderer([&](Renderer& renderer) {
    const PolyMesh mesh = roof(slope);
    const std::vector<StyledEdge> edges = {{{2, 3}, magenta, 8}};
    const RenderedPicture picture = picture_with(renderer, mesh, make_edge_item(mesh.positions, edges), samples);
    for (int x = 6; x < 74; x += 4) CHECK(column_of(picture, x, magenta) == 8);
  });
}

TEST_CASE("an edge that the surface hides is not seen, nor where it comes near the surface's rim") {
  with_renderer([](Renderer& renderer) {
    PolyMesh mesh = test::translated(test::scaled(test::grid(1, 1), 40), {20, 10, 50});
    const auto first = static_cast<Index>(mesh.positions.size());
    for (const double y : {30.0, 10.5}) {
      for (const double x : {0.0, 80.0}) mesh.positions.emplace_back(x, y, 0);
    }
    const std::vector<StyledEdge> edges = {{{first, first + 1}, magenta, 6}, {{first + 2, first + 3}, teal, 6}};
    const RenderedPicture picture = picture_with(renderer, mesh, make_edge_item(mesh.positions, edges), 1);
    CHECK(column_of(picture, 10, magenta) == 6);
    CHECK(column_of(picture, 40, magenta) == 0);
    CHECK(column_of(picture, 10, teal) >= 5);
    CHECK(column_of(picture, 40, teal) == 0);
  });
}

TEST_CASE("edges of different colours meet without gaps and each keeps its half") {
  with_renderer([](Renderer& renderer) {
    PolyMesh mesh = test::scaled(test::grid(2, 1), 40);
    const std::vector<StyledEdge> edges = {{{0, 1}, magenta, 10}, {{1, 2}, teal, 10}};
    Scene scene;
    scene.meshes.emplace_back(make_mesh_item(test::translated(mesh, {0, 30, 0})));
    const PolyMesh raised = test::translated(mesh, {0, 30, 0});
    scene.lines.emplace_back(make_edge_item(raised.positions, edges));
    const RenderedPicture picture = pixel_picture(renderer, scene, size);
    for (int x = 0; x < 80; ++x) {
      CHECK(column_of(picture, x, magenta) + column_of(picture, x, teal) == 10);
    }
    CHECK(column_of(picture, 36, magenta) == 10);
    CHECK(column_of(picture, 44, teal) == 10);
  });
}

TEST_CASE("thick edges of a cube in many colours leave no holes at its corners") {
  const int samples = GENERATE(1, 3);
  with_renderer([&](Renderer& renderer) {
    const PolyMesh cube = test::cube();
    std::vector<StyledEdge> edges;
    for (std::size_t f = 0; f < cube.face_count(); ++f) {
      const auto face = cube.face(f);
      for (std::size_t i = 0; i < face.size(); ++i) {
        const auto level = static_cast<std::uint8_t>(10 * edges.size());
        if (face[i] < face[(i + 1) % 4]) edges.push_back({{face[i], face[(i + 1) % 4]}, {level, 0, 120, 255}, 9});
      }
    }
    REQUIRE(edges.size() == 12);
    Scene scene;
    scene.meshes.emplace_back(make_mesh_item(cube));
    scene.lines.emplace_back(make_edge_item(cube.positions, edges));
    RenderOptions options = flat_options();
    options.supersampling = samples;
    const PictureSize large = {320, 240};
    const Camera camera = frame(scene.meshes[0].item->bounds, view_direction(NamedView::Perspective), large.aspect());
    const RenderedPicture picture = render_picture(renderer, scene, camera, options, large);
    const auto inked = [&](int x, int y) { return pixel(picture, x, y).g == 0 && pixel(picture, x, y).b == 120; };
    int holes = 0;
    int inside = 0;
    for (int y = 1; y + 1 < large.height; ++y) {
      for (int x = 1; x + 1 < large.width; ++x) {
        const bool surrounded = inked(x - 1, y) && inked(x + 1, y) && inked(x, y - 1) && inked(x, y + 1);
        inside += surrounded ? 1 : 0;
        holes += surrounded && !inked(x, y) ? 1 : 0;
      }
    }
    CHECK(holes == 0);
    CHECK(inside > 4000);
  });
}

TEST_CASE("an edge on top is seen through everything, and widths differ per edge") {
  with_renderer([](Renderer& renderer) {
    PolyMesh mesh = test::translated(test::scaled(test::grid(1, 1), 60), {10, 0, 50});
    mesh.positions.insert(mesh.positions.end(), {{0, 20, 0}, {80, 20, 0}, {0, 40, 0}, {80, 40, 0}});
    const std::vector<StyledEdge> edges = {{{4, 5}, magenta, 4}, {{6, 7}, teal, 10}};
    const LineItemPtr item = make_edge_item(mesh.positions, edges, LineDepth::OnTop);
    CHECK(item->runs.size() == 1);
    const RenderedPicture picture = picture_with(renderer, mesh, item, 1);
    CHECK(column_of(picture, 40, magenta) == 4);
    CHECK(column_of(picture, 40, teal) == 10);
  });
}

TEST_CASE("edges that can not be drawn are named") {
  std::vector<Vec3> places = {{0, 0, 0}, {1, 0, 0}};
  CHECK_THROWS_AS(make_edge_item(places, std::vector<StyledEdge>{{{0, 2}, magenta, 3}}), Error);
  CHECK_THROWS_AS(make_edge_item(places, std::vector<StyledEdge>{{{no_index, 1}, magenta, 3}}), Error);
  places[1].z() = std::numeric_limits<double>::infinity();
  CHECK_THROWS_AS(make_edge_item(places, std::vector<StyledEdge>{{{0, 1}, magenta, 3}}), Error);
  CHECK(make_edge_item(places, {})->corners.empty());
}

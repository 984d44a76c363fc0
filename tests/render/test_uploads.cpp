// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <vector>

#include <catch2/catch.hpp>

#include "render/picture_probe.h"
#include "support/meshes/mesh_shapes.h"

using namespace croquis;
using namespace croquis::render;
using namespace croquis::test;

namespace {

constexpr PictureSize size = {160, 120};
constexpr std::size_t budget = 400'000;

/// Some 3.4 MB on the graphics card.
PolyMesh large_mesh() { return test::torus(250, 200); }

std::size_t bytes_of(const MeshItem& item) {
  return item.vertices.size() * sizeof(SurfaceVertex) + item.paint.size() * sizeof(SurfacePaint) +
         4 * item.triangles.size();
}

Camera camera_of(const MeshItemPtr& item) {
  return frame(item->bounds, view_direction(NamedView::Perspective), size.aspect());
}

RenderOptions in_slices() {
  RenderOptions options = RenderOptions::interactive();
  options.upload_budget = budget;
  return options;
}

bool shows_anything(const RenderedPicture& picture, const RenderedPicture& empty) { return picture.rgba != empty.rgba; }

}  // namespace

TEST_CASE("a large mesh goes up in slices within the budget and ends in the same picture") {
  with_renderer([](Renderer& renderer) {
    const MeshItemPtr item = make_mesh_item(large_mesh());
    Scene scene;
    scene.meshes.emplace_back(item);
    const Camera camera = camera_of(item);
    const RenderedPicture empty = draw_once(renderer, {}, camera, in_slices(), size);
    std::size_t drawings = 0;
    RenderedPicture picture;
    do {
      const std::size_t before = renderer.uploaded().bytes;
      picture = draw_once(renderer, scene, camera, in_slices(), size);
      CHECK(renderer.uploaded().bytes - before <= budget);
      CHECK(shows_anything(picture, empty));
      ++drawings;
    } while (renderer.pending() && drawings < 100);
    CHECK(drawings == (bytes_of(*item) + budget - 1) / budget);
    CHECK(renderer.uploaded().bytes == bytes_of(*item));
    Renderer at_once;
    CHECK(picture.rgba == draw_once(at_once, scene, camera, RenderOptions::interactive(), size).rgba);
    CHECK_FALSE(at_once.pending());
    const std::size_t before = renderer.uploaded().bytes;
    draw_once(renderer, scene, camera, in_slices(), size);
    CHECK(renderer.uploaded().bytes == before);
  });
}

TEST_CASE("buffers of two sizes stay while they take turns, those of many sizes go") {
  with_renderer([](Renderer& renderer) {
    const MeshItemPtr item = make_mesh_item(test::cube());
    Scene scene;
    scene.meshes.emplace_back(item);
    const auto draw = [&](int width) {
      draw_once(renderer, scene, camera_of(item), RenderOptions::interactive(), {width, 700});
    };
    for (int width = 800; width < 1100; width += 20) {
      draw(width);
      CHECK(renderer.kept_samples() < 6'000'000 + 700 * 1100);
    }
    CHECK(renderer.kept_samples() > 4'000'000);  // 0.6 to 0.8 million each
    draw(2000);
    draw(2100);
    const std::size_t two = renderer.kept_samples();
    draw(2000);
    CHECK(renderer.kept_samples() == two);
  });
}

TEST_CASE("triangles show as they come, and before them the box") {
  with_renderer([](Renderer& renderer) {
    const MeshItemPtr item = make_mesh_item(large_mesh());
    Scene scene;
    scene.meshes.emplace_back(item);
    const auto clay = [](const Color& color) { return color.r > color.b + 8; };
    std::vector<int> covered;
    do {
      covered.push_back(count_pixels(draw_once(renderer, scene, camera_of(item), in_slices(), size), clay));
    } while (renderer.pending());
    CHECK(covered.front() == 0);
    CHECK(std::is_sorted(covered.begin(), covered.end()));
    CHECK(covered[covered.size() - 2] > 0);
    CHECK(covered[covered.size() - 2] < covered.back());
  });
}

TEST_CASE("small items are there at once beside a large one, in whatever order") {
  with_renderer([](Renderer& renderer) {
    const MeshItemPtr large = make_mesh_item(large_mesh());
    PolyMesh box = test::translated(test::cube(), {2, 0, 0});
    color_faces(box, std::vector<std::array<std::uint8_t, 3>>(6, {0, 0, 255}));
    const MeshItemPtr small = make_mesh_item(box);
    Scene scene;
    scene.meshes = {large, small};
    RenderOptions options = flat_options();
    options.upload_budget = 10'000;
    Bounds bounds = large->bounds;
    bounds.add(small->bounds);
    const Camera camera = frame(bounds, view_direction(NamedView::Front), size.aspect());
    const RenderedPicture first = draw_once(renderer, scene, camera, options, size);
    CHECK(renderer.pending());
    CHECK(count_color(first, {0, 0, 255, 255}) > 200);
    draw_once(renderer, Scene{{small}, {}, {}}, camera, options, size);
    CHECK_FALSE(renderer.pending());
  });
}

TEST_CASE("an update sends positions and normals alone, at once, and looks like a fresh item") {
  with_renderer([](Renderer& renderer) {
    PolyMesh mesh = large_mesh();
    Scene scene;
    scene.meshes.emplace_back(make_mesh_item(mesh), Emphasis{}, MeshStyle::shaded_wire());
    const Camera camera = camera_of(scene.meshes[0].item);
    draw_once(renderer, scene, camera, RenderOptions::interactive(), size);
    for (Vec3& position : mesh.positions) position.z() *= 1.5;
    scene.meshes[0].item = update_mesh_item(scene.meshes[0].item, mesh);
    const UploadCount before = renderer.uploaded();
    RenderOptions options = in_slices();
    const RenderedPicture updated = draw_once(renderer, scene, camera, options, size);
    CHECK(renderer.uploaded().bytes - before.bytes == mesh.vertex_count() * sizeof(SurfaceVertex));
    CHECK(renderer.uploaded().transfers - before.transfers == 1);
    CHECK_FALSE(renderer.pending());
    scene.meshes[0].item = make_mesh_item(mesh);
    CHECK(updated.rgba == draw_once(renderer, scene, camera, RenderOptions::interactive(), size).rgba);
  });
}

TEST_CASE("updates that come faster than a large mesh goes up do not keep it from arriving") {
  with_renderer([](Renderer& renderer) {
    PolyMesh mesh = large_mesh();
    Scene scene;
    scene.meshes.emplace_back(make_mesh_item(mesh));
    const Camera camera = camera_of(scene.meshes[0].item);
    int drawings = 0;
    do {
      draw_once(renderer, scene, camera, in_slices(), size);
      mesh.positions[0].x() += 1e-4;
      scene.meshes[0].item = update_mesh_item(scene.meshes[0].item, mesh);
      ++drawings;
    } while (renderer.pending() && drawings < 100);
    CHECK(drawings < 20);
  });
}

TEST_CASE("wire is sent when it is shown, and finished pictures know no budget") {
  with_renderer([](Renderer& renderer) {
    const MeshItemPtr item = make_mesh_item(large_mesh());
    Scene scene;
    scene.meshes.emplace_back(item);
    const RenderedPicture whole = render_picture(renderer, scene, camera_of(item), in_slices(), size);
    CHECK_FALSE(renderer.pending());
    CHECK(renderer.uploaded().bytes == bytes_of(*item));
    scene.meshes[0].style = MeshStyle::wire_only();
    render_picture(renderer, scene, camera_of(item), in_slices(), size);
    CHECK(renderer.uploaded().bytes == bytes_of(*item) + 4 * item->edges.size());
  });
}

TEST_CASE("two views of an item share what is on the graphics card, which goes with the item") {
  with_renderer([](Renderer& renderer) {
    Scene scene;
    scene.meshes.emplace_back(make_mesh_item(large_mesh()));
    const RenderOptions options = RenderOptions::interactive();
    draw_once(renderer, scene, camera_of(scene.meshes[0].item), options, size);
    const std::size_t before = renderer.uploaded().bytes;
    const Camera other = frame(scene.meshes[0].item->bounds, view_direction(NamedView::Top), size.aspect());
    draw_once(renderer, scene, other, options, size);
    CHECK(renderer.uploaded().bytes == before);
    scene.meshes[0].item = make_mesh_item(large_mesh());
    draw_once(renderer, scene, other, options, size);
    CHECK(renderer.uploaded().bytes == 2 * before);
  });
}

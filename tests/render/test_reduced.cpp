// SPDX-License-Identifier: GPL-3.0-or-later
// Large meshes with fewer triangles, for while the camera moves: it is the same shape, and nothing shows through.
#include <chrono>
#include <cmath>
#include <ctime>
#include <iostream>
#include <string>

#include <catch2/catch.hpp>

#include "croquis/render/mesh_item.h"
#include "croquis/render/renderer.h"
#include "render/picture_probe.h"
#include "support/meshes/mesh_shapes.h"
#include "support/random.h"

using namespace croquis;
using namespace croquis::render;
using croquis::test::pixel;
using croquis::test::with_renderer;

namespace {

constexpr std::size_t most_while_moving = 45'000;
constexpr PictureSize size{400, 300};

PolyMesh rough(PolyMesh mesh, double by) {
  test::Random random(5);
  for (Vec3& place : mesh.positions) place *= 1 + random.between(-by, by);
  return mesh;
}

/// A grid on each side of a cube: creases, flat sides.
PolyMesh fine_cube(Index steps) {
  PolyMesh mesh;
  for (int side = 0; side < 6; ++side) {
    PolyMesh part = test::translated(test::scaled(test::grid(steps, steps), 2.0 / steps), {-1, -1, 1});
    if (side < 4) part = test::rotated(part, side * M_PI / 2, Vec3::UnitX());
    if (side >= 4) part = test::rotated(part, (side == 4 ? 1 : -1) * M_PI / 2, Vec3::UnitY());
    mesh = side == 0 ? part : test::merged(mesh, part);
  }
  return mesh;
}

/// Three needles, thinner than any cell of the reduction, stuck through a ball.
PolyMesh needles() {
  PolyMesh mesh = test::uv_sphere(300, 200);
  for (int axis = 0; axis < 3; ++axis) {
    PolyMesh needle = test::uv_sphere(12, 2000);
    for (Vec3& place : needle.positions) {
      const Vec3 thin(0.02 * place.x(), 0.02 * place.y(), 1.8 * place.z());
      place[axis] = thin.z();
      place[(axis + 1) % 3] = thin.x();
      place[(axis + 2) % 3] = thin.y();
    }
    mesh = test::merged(mesh, needle);
  }
  return mesh;
}

struct Shape {
  std::string name;
  PolyMesh mesh;
};

RenderOptions quick(bool reduced) {
  RenderOptions options = test::flat_options();
  options.supersampling = 1;
  options.reduced = reduced;
  return options;
}

bool is_surface(const RenderedPicture& picture, int x, int y) {
  return x >= 0 && y >= 0 && x < picture.width && y < picture.height && pixel(picture, x, y).b < 240;
}

/// Every pixel within `reach` is of the surface.
bool is_inside(const RenderedPicture& picture, int x, int y, int reach) {
  for (int dy = -reach; dy <= reach; ++dy) {
    for (int dx = -reach; dx <= reach; ++dx) {
      if (!is_surface(picture, x + dx, y + dy)) return false;
    }
  }
  return true;
}

bool is_near(const RenderedPicture& picture, int x, int y, int reach) {
  for (int dy = -reach; dy <= reach; ++dy) {
    for (int dx = -reach; dx <= reach; ++dx) {
      if (is_surface(picture, x + dx, y + dy)) return true;
    }
  }
  return false;
}

}  // namespace

TEST_CASE("while the camera moves few triangles of a large mesh are drawn, and it keeps its outline without holes") {
  const Shape shape = GENERATE(Shape{"ball", test::uv_sphere(800, 200)}, Shape{"torus", test::torus(600, 260)},
                               Shape{"rough ball", rough(test::uv_sphere(700, 240), 0.004)},
                               Shape{"cube", fine_cube(170)}, Shape{"needles", needles()});
  INFO(shape.name);
  const MeshItemPtr item = make_mesh_item(shape.mesh);
  REQUIRE(item->triangles.size() / 3 > 100'000);
  REQUIRE(item->reduced);
  with_renderer([&](Renderer& renderer) {
    for (const NamedView view : {NamedView::Perspective, NamedView::Front, NamedView::Top}) {
      const Camera camera = frame(item->bounds, view_direction(view), 4.0 / 3);
      const RenderedPicture whole = test::draw_once(renderer, Scene{{item}, {}, {}}, camera, quick(false), size);
      CHECK(renderer.triangles_drawn() == item->triangles.size() / 3);
      const RenderedPicture fewer = test::draw_once(renderer, Scene{{item}, {}, {}}, camera, quick(true), size);
      CHECK(renderer.triangles_drawn() < most_while_moving);
      CHECK(renderer.triangles_drawn() > 10'000);
      int holes = 0, beyond = 0, missing = 0;
      for (int y = 0; y < size.height; ++y) {
        for (int x = 0; x < size.width; ++x) {
          if (is_inside(whole, x, y, 2) && !is_surface(fewer, x, y)) ++holes;
          if (is_surface(fewer, x, y) && !is_near(whole, x, y, 2)) ++beyond;
          if (is_surface(whole, x, y) && !is_near(fewer, x, y, 4)) ++missing;  // points become blunt
        }
      }
      CHECK(holes == 0);
      CHECK(beyond == 0);
      CHECK(missing == 0);
    }
  });
}

TEST_CASE("in the light a reduced surface looks as the whole one") {
  const Shape shape = GENERATE(Shape{"ball", test::uv_sphere(800, 200)}, Shape{"torus", test::torus(600, 260)},
                               Shape{"cube", fine_cube(170)});
  INFO(shape.name);
  const MeshItemPtr item = make_mesh_item(shape.mesh);
  with_renderer([&](Renderer& renderer) {
    const Camera camera = frame(item->bounds, view_direction(NamedView::Perspective), 4.0 / 3);
    RenderOptions options = RenderOptions::interactive();
    options.contours = false;
    const RenderedPicture whole = test::draw_once(renderer, Scene{{item}, {}, {}}, camera, options, size);
    options.reduced = true;
    const RenderedPicture fewer = test::draw_once(renderer, Scene{{item}, {}, {}}, camera, options, size);
    int different = 0;
    for (int y = 0; y < size.height; ++y) {
      for (int x = 0; x < size.width; ++x) {
        const int apart = test::brightness(pixel(whole, x, y)) - test::brightness(pixel(fewer, x, y));
        different += std::abs(apart) > 24 ? 1 : 0;
      }
    }
    CHECK(different < 0.01 * size.width * size.height);
  });
}

TEST_CASE("small meshes are always drawn whole") {
  const MeshItemPtr item = make_mesh_item(test::uv_sphere(100, 50));
  CHECK(!item->reduced);
  with_renderer([&](Renderer& renderer) {
    const Camera camera = frame(item->bounds, view_direction(NamedView::Front), 4.0 / 3);
    (void)test::draw_once(renderer, Scene{{item}, {}, {}}, camera, quick(true), size);
    CHECK(renderer.triangles_drawn() == item->triangles.size() / 3);
  });
}

TEST_CASE("an updated item is reduced as it is now, and highlighted faces are on the reduced surface") {
  PolyMesh mesh = test::uv_sphere(800, 200);
  const MeshItemPtr first = make_mesh_item(mesh);
  for (Vec3& place : mesh.positions) place.x() *= 2;
  const MeshItemPtr item = update_mesh_item(first, mesh);
  REQUIRE(item->reduced);
  CHECK(item->reduced->triangles.shared() == first->reduced->triangles.shared());
  std::vector<Index> front;
  for (Index face = 0; face < mesh.face_count(); ++face) {
    if (mesh.positions[mesh.face(face)[0]].x() > 0) front.push_back(face);
  }
  const Color red(255, 0, 0, 255);
  Scene scene{{item}, {}, {}};
  scene.highlights.push_back(make_face_highlight(item, front, red));
  REQUIRE(scene.highlights.front());
  with_renderer([&](Renderer& renderer) {
    const Camera camera = frame(item->bounds, view_direction(NamedView::Front), 4.0 / 3);
    const RenderedPicture picture = test::draw_once(renderer, scene, camera, quick(true), size);
    int wrong = 0;
    for (int y = 0; y < size.height; ++y) {
      for (int x = 0; x < size.width; ++x) {
        if (!is_inside(picture, x, y, 2) || std::abs(x - size.width / 2) < 8) continue;
        wrong += (pixel(picture, x, y) == red) == (x > size.width / 2) ? 0 : 1;
      }
    }
    CHECK(wrong == 0);
    CHECK(test::count_color(picture, red) > 4000);
  });
}

TEST_CASE("figures of pictures while the camera moves", "[.figures]") {
  const Shape shape = GENERATE(Shape{"torus of 800 quads", test::torus(40, 20)},
                               Shape{"torus of 311,000 quads", test::torus(1000, 311)},
                               Shape{"rough ball of 311,000 triangles", rough(test::uv_sphere(622, 251), 0.004)});
  const auto start = std::chrono::steady_clock::now();
  const MeshItemPtr item = make_mesh_item(shape.mesh);
  const auto seconds = [](auto since) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - since).count();
  };
  std::cout << shape.name << ": item in " << seconds(start) << " s\n";
  with_renderer([&](Renderer& renderer) {
    Camera camera = frame(item->bounds, view_direction(NamedView::Perspective), 4.0 / 3);
    for (const bool reduced : {false, true}) {
      RenderOptions options = RenderOptions::interactive();
      options.reduced = reduced;
      const Scene scene{{item}, {}, {}};
      (void)test::draw_once(renderer, scene, camera, options, {1000, 750});
      const auto before = std::chrono::steady_clock::now();
      const std::clock_t busy = std::clock();
      constexpr int pictures = 20;
      for (int k = 0; k < pictures; ++k) (void)test::draw_once(renderer, scene, camera, options, {1000, 750});
      std::cout << "  " << renderer.triangles_drawn() << " triangles: " << pictures / seconds(before)
                << " pictures a second, " << 1e3 * static_cast<double>(std::clock() - busy) / CLOCKS_PER_SEC / pictures
                << " ms of processor time each\n";
    }
  });
}

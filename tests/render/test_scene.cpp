// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <vector>

#include <catch2/catch.hpp>
#include <epoxy/gl.h>

#include "croquis/geometry/placement.h"
#include "render/picture_probe.h"
#include "support/meshes/mesh_shapes.h"

using namespace croquis;
using namespace croquis::render;
using namespace croquis::test;

namespace {

/// A host's framebuffer of 64 x 48 pixels, filled with magenta, bound for drawing and reading.
class HostFramebuffer {
 public:
  HostFramebuffer() {
    glGenFramebuffers(1, &framebuffer_);
    glGenRenderbuffers(1, &color_);
    glGenRenderbuffers(1, &depth_stencil_);
    glBindRenderbuffer(GL_RENDERBUFFER, color_);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, width, height);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, color_);
    glBindRenderbuffer(GL_RENDERBUFFER, depth_stencil_);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH24_STENCIL8, width, height);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_RENDERBUFFER, depth_stencil_);
    glClearColor(1, 0, 1, 1);
    glClearDepth(0.25);
    glClearStencil(7);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
  }
  ~HostFramebuffer() {
    glDeleteFramebuffers(1, &framebuffer_);
    glDeleteRenderbuffers(1, &color_);
    glDeleteRenderbuffers(1, &depth_stencil_);
  }
  HostFramebuffer(const HostFramebuffer&) = delete;
  HostFramebuffer& operator=(const HostFramebuffer&) = delete;

  GLuint name() const { return framebuffer_; }

  /// Rows from below.
  RenderedPicture read() const {
    RenderedPicture picture{width, height, std::vector<std::uint8_t>(4 * width * height)};
    glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, picture.rgba.data());
    return picture;
  }

  bool depth_and_stencil_untouched() const {
    std::vector<float> depths(width * height);
    std::vector<std::uint8_t> stencils(width * height);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, width, height, GL_DEPTH_COMPONENT, GL_FLOAT, depths.data());
    glReadPixels(0, 0, width, height, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, stencils.data());
    return std::all_of(depths.begin(), depths.end(), [](float depth) { return std::abs(depth - 0.25F) < 1e-6F; }) &&
           std::all_of(stencils.begin(), stencils.end(), [](int stencil) { return stencil == 7; });
  }

  static constexpr int width = 64, height = 48;

 private:
  GLuint framebuffer_ = 0, color_ = 0, depth_stencil_ = 0;
};

constexpr Color magenta = {255, 0, 255, 255};

/// Things of every kind that reach beyond any view.
Scene crowded_scene() {
  Scene scene;
  scene.meshes.emplace_back(make_mesh_item(test::scaled(test::uv_sphere(24, 12), 20)));
  const std::vector<glm::dvec3> places = {{-500, -20, 0}, {500, 30, 0}, {-500, 40, 0}};
  scene.lines.emplace_back(make_line_item(line_through(places), {5, {200, 30, 30, 255}, {9, 4, 0, 0}, {}}));
  scene.lines.emplace_back(make_line_item(line_through(places), {2, {0, 0, 0, 90}, {}, LineDepth::Tested}));
  std::vector<Mark> marks(3);
  marks[0].position = {16, 0, 0};
  marks[1].position = {-16, 0, 0};
  marks[2].position = {0, 24, 0};
  for (Mark& mark : marks) mark.size = 40;
  scene.marks.emplace_back(make_mark_item(marks));
  const PolyMesh grid = test::scaled(test::grid(9, 9), 40);
  const MeshItemPtr cage = make_mesh_item(grid);
  scene.meshes.emplace_back(cage, Emphasis{}, MeshStyle::cage({0, 90, 200, 255}));
  scene.highlights.push_back(make_face_highlight(cage, std::vector<Index>{0, 1, 9}, {255, 128, 16, 128}));
  scene.points.push_back(
      make_point_item(grid.positions, {31, {90, 0, 90, 255}, {}, PointShape::Disc, PointDepth::Surfaces}));
  return scene;
}

Camera camera_at(double x) {
  Camera camera;
  camera.eye = {x, 0, 100};
  camera.target = {x, 0, 0};
  camera.height = 48;
  return camera;
}

}  // namespace

TEST_CASE("two views share a framebuffer and nothing leaves its viewport, even under a host's scissor") {
  with_renderer([](Renderer& renderer) {
    const HostFramebuffer host;
    RenderOptions options = RenderOptions::interactive();
    options.axis_cross.shown = true;
    glEnable(GL_SCISSOR_TEST);
    glScissor(0, 0, 30, 48);
    renderer.draw(crowded_scene(), camera_at(0), options, {0, 0, 30, 48, {}});
    const RenderedPicture left = host.read();
    CHECK(count_color(left, magenta) == 34 * 48);
    renderer.draw(crowded_scene(), camera_at(8), options, {34, 4, 30, 44, {}});
    const RenderedPicture both = host.read();
    CHECK(count_color(both, magenta) == 64 * 48 - 30 * 48 - 30 * 44);
    int changed = 0;
    for (int x = 0; x < 34; ++x) {
      for (int y = 0; y < 48; ++y) changed += pixel(left, x, y) == pixel(both, x, y) ? 0 : 1;
    }
    CHECK(changed == 0);
    CHECK(glIsEnabled(GL_SCISSOR_TEST) == GL_TRUE);
  });
}

TEST_CASE("OpenGL's state is as the host left it") {
  with_renderer([](Renderer& renderer) {
    const HostFramebuffer host;
    glEnable(GL_BLEND);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_CULL_FACE);
    glBlendFuncSeparate(GL_DST_COLOR, GL_ZERO, GL_ONE, GL_DST_ALPHA);
    glBlendEquation(GL_MAX);
    glDepthFunc(GL_GREATER);
    glDepthMask(GL_FALSE);
    glColorMask(GL_TRUE, GL_FALSE, GL_TRUE, GL_TRUE);
    glClearColor(0.25F, 0.5F, 0.75F, 0);
    glStencilFunc(GL_LESS, 5, 0x3F);
    glStencilMask(0x0F);
    glScissor(1, 2, 3, 4);
    glViewport(5, 6, 7, 8);
    glActiveTexture(GL_TEXTURE3);
    RenderOptions options;
    options.grid.kind = GridKind::Dots;
    renderer.draw(crowded_scene(), camera_at(0), options, {0, 0, 64, 48, {}});

    const auto integer = [](GLenum name) {
      GLint values[4] = {};
      glGetIntegerv(name, values);
      return values[0];
    };
    CHECK(integer(GL_DRAW_FRAMEBUFFER_BINDING) == static_cast<GLint>(host.name()));
    CHECK(integer(GL_READ_FRAMEBUFFER_BINDING) == static_cast<GLint>(host.name()));
    for (const int name : {GL_BLEND, GL_DEPTH_TEST, GL_CULL_FACE})
      CHECK(glIsEnabled(static_cast<GLenum>(name)) == GL_TRUE);
    for (const int name : {GL_SCISSOR_TEST, GL_STENCIL_TEST, GL_POLYGON_OFFSET_FILL})
      CHECK(glIsEnabled(static_cast<GLenum>(name)) == GL_FALSE);
    CHECK(integer(GL_BLEND_SRC_RGB) == GL_DST_COLOR);
    CHECK(integer(GL_BLEND_DST_ALPHA) == GL_DST_ALPHA);
    CHECK(integer(GL_BLEND_EQUATION_RGB) == GL_MAX);
    CHECK(integer(GL_DEPTH_FUNC) == GL_GREATER);
    CHECK(integer(GL_DEPTH_WRITEMASK) == GL_FALSE);
    GLboolean mask[4] = {};
    glGetBooleanv(GL_COLOR_WRITEMASK, mask);
    CHECK(mask[1] == GL_FALSE);
    GLfloat clear[4] = {};
    glGetFloatv(GL_COLOR_CLEAR_VALUE, clear);
    CHECK(clear[2] == 0.75F);
    CHECK(integer(GL_STENCIL_FUNC) == GL_LESS);
    CHECK(integer(GL_STENCIL_REF) == 5);
    CHECK(integer(GL_STENCIL_WRITEMASK) == 0x0F);
    CHECK(integer(GL_SCISSOR_BOX) == 1);
    CHECK(integer(GL_VIEWPORT) == 5);
    CHECK(integer(GL_ACTIVE_TEXTURE) == GL_TEXTURE3);
    CHECK(integer(GL_CURRENT_PROGRAM) == 0);
    CHECK(integer(GL_VERTEX_ARRAY_BINDING) == 0);
    CHECK(host.depth_and_stencil_untouched());
    CHECK(glGetError() == GL_NO_ERROR);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  });
}

TEST_CASE("a host's framebuffer may have several samples per pixel") {
  with_renderer([](Renderer& renderer) {
    GLuint framebuffer = 0, color = 0;
    glGenFramebuffers(1, &framebuffer);
    glGenRenderbuffers(1, &color);
    glBindRenderbuffer(GL_RENDERBUFFER, color);
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, 4, GL_RGBA8, HostFramebuffer::width, HostFramebuffer::height);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, color);
    const PixelRect viewport{0, 0, HostFramebuffer::width, HostFramebuffer::height, {}};
    renderer.draw(crowded_scene(), camera_at(0), RenderOptions::interactive(), viewport);

    const HostFramebuffer resolved;
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer);
    glBlitFramebuffer(0, 0, viewport.width, viewport.height, 0, 0, viewport.width, viewport.height, GL_COLOR_BUFFER_BIT,
                      GL_NEAREST);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, resolved.name());
    const RenderedPicture several = resolved.read();
    renderer.draw(crowded_scene(), camera_at(0), RenderOptions::interactive(), viewport);
    CHECK(resolved.read().rgba == several.rgba);
    glDeleteFramebuffers(1, &framebuffer);
    glDeleteRenderbuffers(1, &color);
  });
}

TEST_CASE("the same scene gives the same pixels, whatever was drawn in between") {
  with_renderer([](Renderer& renderer) {
    const Scene scene = crowded_scene();
    RenderOptions options = GENERATE(RenderOptions(), RenderOptions::interactive(), RenderOptions::paper());
    const RenderedPicture first = render_picture(renderer, scene, camera_at(0), options, {200, 150});
    render_picture(renderer, scene, camera_at(9), RenderOptions::interactive(), {90, 200});
    render_picture(renderer, Scene{}, camera_at(9), options, {200, 150});
    CHECK(render_picture(renderer, scene, camera_at(0), options, {200, 150}).rgba == first.rgba);
  });
}

TEST_CASE("lines and dashes run on across the tiles of a large picture") {
  with_renderer([](Renderer& renderer) {
    Scene scene;
    const std::vector<glm::dvec3> places = {{0, 20.5, 0}, {1200, 20.5, 0}};
    scene.lines.emplace_back(make_line_item(line_through(places), {3, {0, 0, 0, 255}, {30, 10, 0, 0}, {}}));
    const RenderedPicture picture = pixel_picture(renderer, scene, {1200, 40});
    for (int x = 1000; x < 1050; ++x) {
      const int in_period = x % 40;
      if (in_period < 3 || in_period > 36 || std::abs(in_period - 30) < 3) continue;
      CHECK(ink_of_column(picture, x) == Approx(in_period < 30 ? 3 : 0).margin(0.05));
    }
  });
}

TEST_CASE("a moving picture shows what the settled one shows") {
  with_renderer([](Renderer& renderer) {
    Scene scene;
    scene.meshes.emplace_back(make_mesh_item(test::uv_sphere(64, 32)));
    const Camera camera = frame(points_of(scene), view_direction(NamedView::Perspective), 1);
    RenderOptions settled;
    settled.occlusion = false;
    const RenderedPicture a = render_picture(renderer, scene, camera, settled, {160, 160});
    const RenderedPicture b = render_picture(renderer, scene, camera, RenderOptions::interactive(), {160, 160});
    int different = 0;
    for (int x = 0; x < 160; ++x) {
      for (int y = 0; y < 160; ++y)
        different += std::abs(brightness(pixel(a, x, y)) - brightness(pixel(b, x, y))) > 6 ? 1 : 0;
    }
    // The outline alone, some two pixels wide.
    CHECK(different < 3 * M_PI * 160);
    const int dark = count_pixels(b, [](const Color& color) { return brightness(color) < 80; });
    CHECK(dark > 160);
  });
}

TEST_CASE("selected, hovered and stale surfaces look different without a new item") {
  with_renderer([](Renderer& renderer) {
    Scene scene;
    scene.meshes.emplace_back(make_mesh_item(test::scaled(test::grid(2, 2), 16)));
    const auto middle = [&](const Emphasis& emphasis) {
      scene.meshes[0].emphasis = emphasis;
      return pixel(pixel_picture(renderer, scene, {32, 32}), 16, 16);
    };
    const Color plain = middle({});
    CHECK(plain == palette_color(0));
    CHECK(middle({true, false, false}).r - middle({true, false, false}).b > plain.r - plain.b + 40);
    CHECK(middle({false, true, false}).b - middle({false, true, false}).r > plain.b - plain.r + 40);
    CHECK(brightness(middle({false, false, true})) > brightness(plain) + 20);
    CHECK(middle({}) == plain);
  });
}

TEST_CASE("the grid's lines stand at its steps and pass through the origin") {
  with_renderer([](Renderer& renderer) {
    RenderOptions options = flat_options();
    options.grid.kind = GridKind::Lines;
    options.grid.spacing = 20;
    options.grid.color = {0, 0, 0, 255};
    const PictureSize size{400, 200};
    const RenderedPicture picture = render_picture(renderer, Scene{}, pixel_camera(size), options, size);
    // A line on the border of two pixels darkens both by half; strong ones are every hundred.
    for (const int x : {100, 200, 300}) CHECK(ink(picture, x, 90) == Approx(0.5).margin(0.01));
    for (const int x : {20, 40, 60, 140, 360}) {
      CHECK(ink(picture, x, 90) > 0.05);
      CHECK(ink(picture, x, 90) < 0.4);
    }
    for (const int x : {10, 29, 75, 110}) CHECK(ink(picture, x, 90) == 0);
    Camera camera = pixel_camera(size);
    camera.projection = Projection::Perspective;
    CHECK(ink_of_all(render_picture(renderer, Scene{}, camera, options, size)) == 0);
  });
}

TEST_CASE("the axes in the corner point where the camera sees them") {
  with_renderer([](Renderer& renderer) {
    RenderOptions options = flat_options();
    options.axis_cross.shown = true;
    options.axis_cross.dashes = {};
    const auto color_at = [&](const ViewDirection& view, int x, int y) {
      const RenderedPicture picture = render_picture(renderer, Scene{}, frame(Bounds(), view, 1), options, {200, 200});
      CHECK(count_pixels(picture, [](const Color& color) { return color != Color(255, 255, 255, 255); }) < 600);
      return pixel(picture, x, y);
    };
    // The middle is 50 pixels from the left and the lower border, the axes are 34 pixels long.
    const auto& colors = options.axis_cross.colors;
    const ViewDirection front = view_direction(NamedView::Front), side = view_direction(NamedView::Side);
    CHECK(color_at(front, 75, 150) == colors[0]);
    CHECK(color_at(front, 50, 125) == colors[1]);
    CHECK(color_at(side, 50, 125) == colors[1]);
    CHECK(color_at(side, 25, 150) == colors[2]);
    options.axis_cross.axes = {{{1, 0, 0}, {0, 0, -1}, {0, 1, 0}}};  // z upwards
    CHECK(color_at(front, 75, 150) == colors[0]);
    CHECK(color_at(front, 50, 125) == colors[2]);
  });
}

TEST_CASE("a scene's box and points are those of all its items, and null items are left out") {
  Scene scene = crowded_scene();
  CHECK(bounds_of(scene).max.x == 500);
  CHECK(bounds_of(scene).min.y == -20);
  const std::size_t points = points_of(scene).size();
  scene.lines.emplace_back(nullptr);
  scene.meshes.emplace_back(nullptr);
  scene.marks.emplace_back(nullptr);
  CHECK(points_of(scene).size() == points);
  with_renderer([&](Renderer& renderer) {
    CHECK(render_picture(renderer, scene, camera_at(0), RenderOptions(), {20, 20}).width == 20);
  });
}

TEST_CASE("a placed item is drawn, and framed, as the moved mesh would be: faces, lines, marks and points") {
  const Affine3 map = Placement{{3, -2, 1}, {20, 40, 10}, {1.5, 1.5, 1.5}}.map();
  glm::dmat4 placement(1);
  for (int column = 0; column < 3; ++column) {
    for (int row = 0; row < 3; ++row) placement[column][row] = map.linear(row, column);
    placement[3][column] = map.offset(column);
  }
  const auto scene_of = [](const PolyMesh& mesh) {
    Scene scene;
    scene.meshes.emplace_back(make_mesh_item(mesh));
    const Vec3& a = mesh.positions.front();
    const Vec3& b = mesh.positions.back();
    const std::vector<glm::dvec3> ends = {{a.x(), a.y(), a.z()}, {b.x(), b.y(), b.z()}};
    scene.lines.emplace_back(make_line_item(line_through(ends), {5, {200, 30, 30, 255}, {9, 4, 0, 0}, {}}));
    std::vector<Mark> marks(1);
    marks[0].position = ends[0];
    scene.marks.emplace_back(make_mark_item(marks));
    scene.points.push_back(make_point_item(mesh.positions, {7, {90, 0, 90, 255}, {}, PointShape::Disc}));
    return scene;
  };
  const PolyMesh mesh = test::scaled(test::torus(16, 8), 8);
  const Scene moved = scene_of(transformed(mesh, map));
  Scene placed = scene_of(mesh);
  placed.meshes[0].placement = placed.lines[0].placement = placement;
  placed.marks[0].placement = placed.points[0].placement = placement;
  const std::vector<glm::dvec3> there = points_of(moved), here = points_of(placed);
  REQUIRE(there.size() == here.size());
  double apart = 0;
  for (std::size_t i = 0; i < here.size(); ++i) apart = std::max(apart, glm::length(there[i] - here[i]));
  CHECK(apart < 1e-4);
  const Bounds box = bounds_of(placed);
  for (const glm::dvec3& point : there) {
    CHECK(glm::all(glm::lessThan(box.min - 1e-4, point)));
    CHECK(glm::all(glm::lessThan(point, box.max + 1e-4)));
  }
  with_renderer([&](Renderer& renderer) {
    const PictureSize size{96, 72};
    const Camera camera = frame(there, view_direction(NamedView::Perspective), size.aspect());
    const RenderedPicture a = render_picture(renderer, moved, camera, {}, size);
    const RenderedPicture b = render_picture(renderer, placed, camera, {}, size);
    int differing = 0;
    for (std::size_t i = 0; i < a.rgba.size(); ++i) differing += std::abs(a.rgba[i] - b.rgba[i]) > 24 ? 1 : 0;
    CHECK(differing < 0.005 * static_cast<double>(a.rgba.size()));
  });
}

// SPDX-License-Identifier: GPL-3.0-or-later
// A viewer for meshes with GLFW: viewer [MESH] [--frames N] [--picture OUT.png]. The renderer knows nothing about
// windows: it draws into whatever context and framebuffer its host has made current.
#include <array>
#include <cmath>
#include <iostream>
#include <stdexcept>
#include <string>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "croquis/base/error.h"
#include "croquis/io/file.h"
#include "croquis/io/mesh_file.h"
#include "croquis/io/png.h"
#include "croquis/render/picture.h"
#include "navigation.h"

namespace {

using namespace croquis;

struct Arguments {
  std::string mesh;
  std::string picture;  ///< written at the end
  int frames = -1;      ///< drawn before the end; -1: until the window is closed
};

Arguments parse(int argc, char** argv) {
  Arguments arguments;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    const bool has_value = i + 1 < argc;
    if (word == "--frames" && has_value) {
      arguments.frames = std::stoi(argv[++i]);
    } else if (word == "--picture" && has_value) {
      arguments.picture = argv[++i];
    } else if (word.starts_with("--")) {
      throw std::runtime_error("usage: viewer [MESH] [--frames N] [--picture OUT.png]");
    } else {
      arguments.mesh = word;
    }
  }
  return arguments;
}

/// What is shown without a file: a torus.
PolyMesh torus() {
  constexpr Index around = 96, across = 48;
  PolyMesh mesh;
  for (Index i = 0; i < around; ++i) {
    for (Index j = 0; j < across; ++j) {
      const double a = 2 * M_PI * i / around, b = 2 * M_PI * j / across;
      const double radius = 1 + 0.4 * std::cos(b);
      mesh.positions.push_back({radius * std::cos(a), 0.4 * std::sin(b), -radius * std::sin(a)});
      const Index next = (i + 1) % around * across, above = (j + 1) % across;
      mesh.add_face(std::array<Index, 4>{i * across + j, next + j, next + above, i * across + above});
    }
  }
  return mesh;
}

PolyMesh load(const std::string& path) {
  if (path.empty()) return torus();
  const auto format = mesh_format_of(path);
  if (!format) throw std::runtime_error(path + " is none of OBJ, PLY, STL, OFF and GLB.");
  Progress progress;
  return read_mesh(read_file(path), *format, path, progress).mesh;
}

/// The quick look while a button is held, the careful one when nothing moves.
render::RenderOptions options_for(const Window& window, bool moving) {
  render::RenderOptions options = moving ? render::RenderOptions::interactive() : render::RenderOptions();
  options.axis_cross.shown = true;
  options.pixel_ratio = window.pixel_ratio();
  return options;
}

void save_picture(const std::string& path, render::Renderer& renderer, const render::Scene& scene,
                  const render::Camera& camera, const Window& window) {
  const glm::ivec2 size = window.framebuffer_size();
  const auto picture = render_picture(renderer, scene, camera, options_for(window, false), {size.x, size.y});
  OutputTransaction output;
  output.add(path, encode_png({picture.width, picture.height, picture.rgba}));
  output.commit();
}

void run(const Arguments& arguments) {
  render::Scene scene;
  scene.meshes.emplace_back(render::make_mesh_item(load(arguments.mesh)));
  const Window window({960, 640}, "Croquis viewer");
  render::Renderer renderer;
  Navigation navigation(window, points_of(scene));
  for (int drawn = 0; drawn != arguments.frames && glfwWindowShouldClose(window.handle()) == GLFW_FALSE;) {
    // A number of frames measures quick drawing: there is no hand whose events could be waited for.
    if (arguments.frames >= 0) {
      glfwPollEvents();
    } else if (!navigation.take_change()) {
      glfwWaitEvents();
      continue;
    }
    const glm::ivec2 size = window.framebuffer_size();
    const bool moving = navigation.moving() || arguments.frames >= 0;
    renderer.draw(scene, navigation.camera(), options_for(window, moving), {0, 0, size.x, size.y, {}});
    glfwSwapBuffers(window.handle());
    ++drawn;
  }
  if (!arguments.picture.empty()) save_picture(arguments.picture, renderer, scene, navigation.camera(), window);
}

}  // namespace

int main(int argc, char** argv) try {
  run(parse(argc, argv));
  return 0;
} catch (const std::exception& error) {
  std::cerr << error.what() << "\n";
  return 1;
}

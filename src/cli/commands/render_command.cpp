// SPDX-License-Identifier: GPL-3.0-or-later
#include <charconv>
#include <string>
#include <utility>

#include "cli/command.h"
#include "cli/files.h"
#include "croquis/base/error.h"
#include "croquis/base/parameter_list.h"
#include "croquis/io/png.h"
#include "croquis/render/offscreen_context.h"
#include "croquis/render/picture.h"

namespace croquis::cli {
namespace {

struct RenderSettings {
  render::PictureSize size = {800, 600};
  render::NamedView view = render::NamedView::Perspective;
  bool z_up = false;
  bool wire = false, zebra = false;
};

Error bad_size(const std::string& text) {
  return Error(refused_value(
      "size", text,
      "WIDTHxHEIGHT in pixels, each from 1 to " + std::to_string(render::max_picture_size) + ", such as 800x600"));
}

render::PictureSize parse_size(const std::string& text) {
  render::PictureSize size;
  const char* end = text.data() + text.size();
  const auto width = std::from_chars(text.data(), end, size.width);
  if (width.ec != std::errc{} || width.ptr == end || *width.ptr != 'x') throw bad_size(text);
  const auto height = std::from_chars(width.ptr + 1, end, size.height);
  if (height.ec != std::errc{} || height.ptr != end) throw bad_size(text);
  for (const int side : {size.width, size.height}) {
    if (side < 1 || side > render::max_picture_size) throw bad_size(text);
  }
  return size;
}

void list_render_parameters(RenderSettings& settings, ParameterList& list) {
  ParameterDescription size = text_parameter("size", "800x600", "Width and height of the picture.");
  size.unit = "pixels";
  list.add(std::move(size), [&](const ParameterValue& given) { settings.size = parse_size(to_text(given)); });
  list.choice("view", settings.view, {"front", "side", "top", "persp"}, "Where it is seen from.");
  list.choice("up", settings.z_up, {"y", "z"},
              "The model's axis that points up: z in solids of perspective drawings and in most scans.");
  list.flag("wire", settings.wire, "Draw the polygons' edges as well.");
  list.flag("zebra", settings.zebra, "Let the surface mirror black and white stripes, which show how smooth it is.");
}

/// The same look at a model whose z axis points up: its y axis points away from who looks at its front.
render::ViewDirection with_z_up(render::ViewDirection view) {
  const auto turned = [](const glm::dvec3& v) { return glm::dvec3(v.x, -v.z, v.y); };
  view.direction = turned(view.direction);
  view.up = turned(view.up);
  return view;
}

void run_render(const Invocation& invocation, CommandResult& result, Progress& progress) {
  require_png_output(invocation);
  const auto settings = settings_of(list_render_parameters, invocation.parameters);
  Progress reading = progress.step("read", 0.4);
  const PolyMesh mesh = read_input_mesh(invocation, false, result, reading);

  Progress drawing = progress.step("draw", 0.5);
  const render::OffscreenContext context;
  render::Renderer renderer;
  render::MeshItemOptions looks;
  looks.use_normal_channel = true;  // as the file has them, where it has any
  const std::vector<render::MeshItemPtr> items = {render::make_mesh_item(mesh, looks)};
  render::RenderOptions options;
  options.wire = settings.wire;
  if (settings.zebra) options.shading = render::Shading::Zebra;
  auto direction = render::view_direction(settings.view);
  if (settings.z_up) direction = with_z_up(direction);
  const render::Camera camera = render::frame(render::points_of(items), direction, settings.size.aspect());
  drawing.check();
  render::RenderedPicture picture = render::render_picture(renderer, items, camera, options, settings.size);

  Progress writing = progress.step("write", 0.1);
  stage_file(invocation.output, encode_png({picture.width, picture.height, std::move(picture.rgba)}), result);
  progress.report(1);
}

}  // namespace

Command render_command() {
  return {{.name = "render",
           .sentence = "Draws a picture of a mesh; needs no display.",
           .output = OutputNeed::Required,
           .parameters = parameters_of(list_render_parameters),
           .examples = {"croquis-cli render solid.obj -o solid.png",
                        "croquis-cli render solid.obj -o top.png --view top --size 1600x1200 --wire",
                        "croquis-cli render solid.obj -o stripes.png --zebra --up z"}},
          run_render};
}

}  // namespace croquis::cli

// SPDX-License-Identifier: GPL-3.0-or-later
// A picture without a window: 05_draw_picture OUT.png. The renderer draws into whatever context its host has made; here
// that is an offscreen one.
#include <array>
#include <iostream>

#include "croquis/base/error.h"
#include "croquis/io/file.h"
#include "croquis/io/png.h"
#include "croquis/render/offscreen_context.h"
#include "croquis/render/picture.h"

int main(int argc, char** argv) try {
  using namespace croquis;
  if (argc != 2) return 2;
  PolyMesh pyramid;
  pyramid.positions = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}, {0, 0, 1.5}};
  pyramid.add_face(std::array<Index, 4>{3, 2, 1, 0});
  for (Index side = 0; side < 4; ++side) pyramid.add_triangle(side, (side + 1) % 4, 4);

  const render::OffscreenContext context;
  render::Renderer renderer;
  const std::vector<render::MeshItemPtr> items = {render::make_mesh_item(pyramid)};
  const render::PictureSize size{400, 300};
  const render::Camera camera =
      render::frame(render::points_of(items), render::view_direction(render::NamedView::Perspective), size.aspect());
  const render::RenderedPicture picture = render::render_picture(renderer, items, camera, {}, size);

  OutputTransaction output;
  output.add(argv[1], encode_png({picture.width, picture.height, picture.rgba}));
  output.commit();
  return 0;
} catch (const croquis::Error& error) {
  std::cerr << error.what() << "\n";
  return 1;
}

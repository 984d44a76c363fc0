// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/render/render_options.h"

namespace croquis::render {

RenderOptions RenderOptions::interactive() {
  RenderOptions options;
  options.supersampling = 1;
  options.occlusion = false;
  return options;
}

RenderOptions RenderOptions::paper() {
  RenderOptions options;
  options.background_top = options.background_bottom = {252, 251, 248, 255};
  options.grid.kind = GridKind::Dots;
  return options;
}

}  // namespace croquis::render

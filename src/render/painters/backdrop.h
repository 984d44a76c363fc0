// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "croquis/render/render_options.h"
#include "croquis/render/scene.h"
#include "render/gl/shader_program.h"
#include "render/painters/drawing.h"
#include "render/scene/view_frame.h"

namespace croquis::render {

/// Sets what backdrop.frag reads; the program must be in use.
void set_backdrop(const ShaderProgram& program, const RenderOptions& options, const ViewFrame& view);

/// The axes' directions as lines with their letters, the farthest first, in pixels of the whole picture.
std::vector<Shown<LineItem>> axis_cross(const RenderOptions& options, const ViewFrame& view);

/// A frame whose model units are pixels of the whole picture.
OverlayFrame pixel_frame(const OverlayFrame& frame);

}  // namespace croquis::render

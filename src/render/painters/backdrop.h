// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "croquis/render/render_options.h"
#include "render/gl/shader_program.h"
#include "render/scene/view_frame.h"

namespace croquis::render {

/// Sets what backdrop.frag reads; the program must be in use.
void set_backdrop(const ShaderProgram& program, const RenderOptions& options, const ViewFrame& view);

}  // namespace croquis::render

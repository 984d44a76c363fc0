// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "croquis/render/scene.h"
#include "croquis/tools/mesh/mesh_pick.h"
#include "croquis/tools/pointer/view_frame.h"

namespace croquis::app {

/// The box being spanned. @param box pixels of the view
void add_box(const PickBox& box, const ViewFrame& frame, render::Scene& scene);

}  // namespace croquis::app

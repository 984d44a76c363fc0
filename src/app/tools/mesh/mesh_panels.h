// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

namespace croquis::app {

class MeshEditingTool;
class PanelDocks;
class Studio;

/// The panels of work on meshes, in their docks: sharp edges, crease sets, the last edit.
/// @return shows them as everything is now; given whether there is a mesh to be worked on
std::function<void(bool useful)> make_mesh_panels(MeshEditingTool& mesh, const Studio& studio, PanelDocks& docks);

}  // namespace croquis::app

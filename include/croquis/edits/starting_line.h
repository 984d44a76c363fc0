// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "croquis/edits/edit_line.h"

namespace croquis {

/// The line that people begin with when they choose an edit without numbers: its defaults, and where these do nothing
/// (EditDescription::start) a value that can be seen. One that the edit refuses is halved until it fits, ten times at
/// most.
/// @param topology of the mesh. @param target elements of the mesh, of a kind that the edit takes
EditLine starting_line(const PolyMesh& mesh, const MeshTopology& topology, const Edit& edit, EditTarget target);

}  // namespace croquis

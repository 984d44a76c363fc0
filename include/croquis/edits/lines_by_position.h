// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "croquis/base/progress.h"
#include "croquis/edits/edit_line.h"

namespace croquis {

/// The edits of one mesh as edits of another one: each line's elements become those of the other mesh, as the lines
/// before have made it, that are nearest to where its own were. Places are those of vertices, middles of edges and
/// means of faces' corners. Several that become one element count once. O(#elements of the meshes log of that) for each
/// line
/// @param before that the lines were made for
/// @throws Error as apply_edit, when a line doesn't fit; Cancelled
std::vector<EditLine> lines_by_position(PolyMesh before, PolyMesh now, std::span<const EditLine> lines,
                                        const EditRegistry& registry, Progress& progress);

}  // namespace croquis

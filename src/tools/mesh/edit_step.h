// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "croquis/edits/edit_line.h"
#include "croquis/workspace/chain_edit.h"

namespace croquis {

/// A computed mesh is edited by a step of edits after it: the lines are appended to the node when it is such a step
/// itself, else a new step gets them.
/// @param mesh what the node gives
/// @return the document, and the node that gives the edited mesh
/// @throws Error (E_STEP) when the registry has no operation that edits its input
AddedNode with_edit_lines(const Document& document, const Registry& registry, NodeId node, const PolyMesh& mesh,
                          const std::vector<EditLine>& lines);

}  // namespace croquis

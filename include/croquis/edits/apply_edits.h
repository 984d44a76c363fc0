// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "croquis/base/progress.h"
#include "croquis/edits/edit_line.h"

namespace croquis {

/// A mesh after several edits.
struct EditedMesh {
  PolyMesh mesh;
  std::vector<Index> vertex_source;  ///< #V: the vertex of the first mesh that each comes from; no_index for new ones
  std::vector<Index> face_source;    ///< #F: the face of the first mesh, likewise
  Findings warnings;                 ///< what edits couldn't keep (see MeshEdit::lost)
};

/// Applies one edit.
/// @param topology of the mesh
/// @throws Error (E_EDIT, naming the line; E_PARAMETER; what an edit throws)
MeshEdit apply_edit(const PolyMesh& mesh, const MeshTopology& topology, const EditLine& line,
                    const EditRegistry& registry);

/// Applies edits one after the other; each counts the elements of the mesh that the one before made.
/// @throws Error as apply_edit, Cancelled
EditedMesh apply_edits(PolyMesh mesh, std::span<const EditLine> lines, const EditRegistry& registry,
                       Progress& progress);

/// The same for a mesh that has been edited already: what comes from where counts from its first mesh on.
EditedMesh apply_edits(EditedMesh begun, std::span<const EditLine> lines, const EditRegistry& registry,
                       Progress& progress);

}  // namespace croquis

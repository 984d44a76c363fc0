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
MeshEdit apply_edit(const PolyMesh& mesh, const MeshTopology& topology, const EditLine& line);

/// Applies edits one after the other; each counts the elements of the mesh that the one before made.
/// @throws Error as apply_edit, Cancelled
EditedMesh apply_edits(PolyMesh mesh, std::span<const EditLine> lines, Progress& progress);

/// The same for a mesh that has been edited already: what comes from where counts from its first mesh on.
EditedMesh apply_edits(EditedMesh begun, std::span<const EditLine> lines, Progress& progress);

/// The edits of one mesh as edits of another one: each line's elements become those of the other mesh, as the lines
/// before have made it, that are nearest to where its own were. Places are those of vertices, middles of edges and
/// means of faces' corners. Several that become one element count once. O(#elements of the meshes log of that) for each
/// line
/// @param before that the lines were made for
/// @throws Error as apply_edit, when a line doesn't fit; Cancelled
std::vector<EditLine> lines_by_position(PolyMesh before, PolyMesh now, std::span<const EditLine> lines,
                                        Progress& progress);

/// The line that people begin with when they choose an edit without numbers: its defaults, and where these do nothing
/// (EditDescription::start) a value that can be seen. One that the edit refuses is halved until it fits, ten times at
/// most.
/// @param topology of the mesh. @param target elements of the mesh, of a kind that the edit takes
EditLine starting_line(const PolyMesh& mesh, const MeshTopology& topology, const Edit& edit, EditTarget target);

}  // namespace croquis

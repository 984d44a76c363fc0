// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "croquis/base/parameter.h"
#include "croquis/mesh_editing/mesh_edit.h"

/// The extension point beside operations: whatever changes a mesh at chosen elements is an Edit, and every host makes
/// its commands from the edit's own description.
namespace croquis {

/// What people begin with where the defaults of an edit do nothing.
struct EditStart {
  std::string parameter;  ///< a number
  double share = 0;       ///< its value, of the diagonal of the box around the elements
};

/// All that hosts know of an edit.
struct EditDescription {
  std::string id;     ///< "extrude": the first word of its line (see edit_line.h)
  std::string title;  ///< "Extrude"
  std::string sentence;
  std::vector<ComponentKind> kinds;  ///< of elements that it works on; one kind at a time
  std::vector<ParameterDescription> parameters;
  std::optional<EditStart> start = {};  ///< see starting_line
};

/// The elements that an edit works on.
struct EditTarget {
  ComponentKind kind = ComponentKind::Face;
  bool all = false;   ///< every element of the kind; `elements` is empty then
  Elements elements;  ///< in any order

  friend bool operator==(const EditTarget&, const EditTarget&) = default;
};

/// The elements of a mesh that an edit is applied to.
struct EditInput {
  const PolyMesh& mesh;
  const MeshTopology& topology;     ///< of the mesh
  ComponentKind kind;               ///< one that is described
  std::span<const Index> elements;  ///< sorted, each once, at least one
};

/// A pure function from a mesh to a mesh, and where everything in it comes from.
struct Edit {
  EditDescription description;
  /// @param parameters complete and within their ranges (see croquis::complete)
  /// @throws Error (E_INPUT, E_PARAMETER)
  std::function<MeshEdit(const EditInput&, const ParameterValues& parameters)> apply;
};

/// Every edit of Croquis.
const std::vector<Edit>& all_edits();

/// The edit of that id, or null.
const Edit* find_edit(std::string_view id);

}  // namespace croquis

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
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

/// A pure function from a mesh to a mesh, and where everything in it comes from.
class Edit {
 public:
  virtual ~Edit() = default;

  virtual EditDescription describe() const = 0;

  /// @param elements   sorted, each once, all of the mesh, at least one, of a kind that is described
  /// @param parameters complete and within their ranges (see croquis::complete)
  /// @throws Error (E_INPUT)
  virtual MeshEdit apply(const PolyMesh& mesh, const MeshTopology& topology, ComponentKind kind,
                         std::span<const Index> elements, const ParameterValues& parameters) const = 0;
};

/// The edits that a host offers.
class EditRegistry {
 public:
  /// @throws Error (Category::Internal) when the id is taken
  void add(std::unique_ptr<const Edit> edit);

  /// The edit of that id, or null.
  const Edit* find(std::string_view id) const;

  /// In the order they were added.
  const std::vector<std::unique_ptr<const Edit>>& edits() const { return edits_; }

 private:
  std::vector<std::unique_ptr<const Edit>> edits_;
};

/// Every edit of Croquis.
const EditRegistry& all_edits();

}  // namespace croquis

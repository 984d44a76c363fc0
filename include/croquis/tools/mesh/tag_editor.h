// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "croquis/mesh_editing/tag_edit.h"
#include "croquis/tools/mesh/mesh_editor.h"

namespace croquis {

/// The edits that change the sharpness of edges by so many levels, one for each value that comes out.
std::vector<EditLine> sharpening_lines(const PolyMesh& mesh, const MeshTopology& topology, const Elements& edges,
                                       double by);

/// Changes sharpness, pins and sets of a mesh, each one undo step. Commands give Continue when there was nothing to do.
class TagEditor {
 public:
  /// @param source, selector, editor, log outlive this
  TagEditor(EditableMesh& editable, MeshSelector& selector, MeshEditor& editor, CommandLog& log)
      : editable_(editable), selector_(selector), editor_(editor), log_(log) {}

  // ---- Sharpness and pins
  Verdict tag(double sharpness);  ///< selected edges (of faces: their edges); 0 untags
  Verdict untag() { return tag(0); }
  Verdict change_sharpness(double by);
  Verdict tag_edges(const Elements& edges, double sharpness);
  Verdict tag_sharper_than(double degrees, double sharpness = infinite_sharpness);
  std::size_t count_sharper_than(double degrees);  ///< what that would tag, for a live preview
  Verdict tag_boundary(double sharpness = infinite_sharpness);
  Verdict pin(bool pinned);  ///< selected vertices (of edges and faces: their vertices)

  // ---- Sets
  Verdict make_set(const std::string& name, double sharpness = infinite_sharpness);
  Verdict rename_set(const std::string& name, const std::string& new_name);
  Verdict set_set_sharpness(const std::string& name, double sharpness);
  Verdict select_set(const std::string& name);  ///< its edges, or its pins when it has none
  Verdict merge_sets(const std::string& into, const std::string& from);
  Verdict remove_set(const std::string& name, bool untag);

 private:
  Verdict tag_these(const Elements& edges, double sharpness, std::optional<recorded::Step> step);
  Verdict commit(const std::string& label, MeshTags tags, recorded::Step step);

  EditableMesh& editable_;
  MeshSelector& selector_;
  MeshEditor& editor_;
  CommandLog& log_;
};

}  // namespace croquis

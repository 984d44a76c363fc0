// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "croquis/edits/edit_line.h"
#include "croquis/mesh_editing/tag_edit.h"
#include "croquis/tools/mesh/mesh_selector.h"

namespace croquis {

/// What is selected after an edit.
enum class SelectAfter {
  AsBefore,
  Nothing,
  Results  ///< what the edit made, else what became of the elements it worked on; in Object mode nothing
};

/// Changes a mesh by edits, each one undo step. Commands give Continue when there was nothing to do.
class MeshEditor {
 public:
  /// @param source, selector, log outlive this
  MeshEditor(EditableMesh& editable, MeshSelector& selector, CommandLog& log)
      : editable_(editable), selector_(selector), log_(log) {}

  /// Applies any edit of all_edits() to the elements that its line names. The undo step is called by the edit's title
  /// ("Inset 2 faces"), what was made is selected, and an EditStep is recorded.
  /// @throws Error (E_EDIT, E_PARAMETER, what the edit throws); nothing has changed then
  Verdict apply(const EditLine& line);
  /// The same with a label, a recorded step and a selection of one's own.
  Verdict run(const EditLine& line, const std::string& label, std::optional<recorded::Step> step, SelectAfter after);
  /// Several lines of a computed mesh, one undo step; they keep all elements.
  Verdict run_lines(const std::vector<EditLine>& lines, const std::string& label, std::optional<recorded::Step> step);

  /// Whether elements of a kind that the edit takes are selected.
  bool fits_selection(const EditDescription& edit) const;
  /// Applies an edit to what is selected, with the values that people begin with (starting_line).
  Verdict begin(const std::string& edit);

  /// "Inset 2 faces": what apply() calls its undo step.
  std::string label_of(const EditLine& line) const;

  // ---- The last edit with other numbers
  /// What apply() or adjust() did, while it is the newest change of the history; else null.
  const EditLine* last() const;
  /// Takes the last edit back and applies it with other parameters, as one step of the history.
  /// @throws Error as apply; the edit stays as it was then
  Verdict adjust(ParameterValues parameters);

  // ---- Of what is selected
  Verdict move_selected(const Vec3& by);
  Verdict rotate_selected(const Vec3& axis, double degrees, std::optional<Vec3> pivot = std::nullopt);
  Verdict scale_selected(const Vec3& factors, std::optional<Vec3> pivot = std::nullopt);
  Verdict delete_selected();  ///< faces go; edges and vertices dissolve
  Verdict extrude(const Vec3& by);
  Verdict extrude_along_normal(double distance);

  Verdict cut_loop(Index edge, double at);  ///< @throws Error when there is no such edge

  // ---- The lines of these, for drags. The selection isn't empty
  EditLine move_line(const Vec3& by) const;
  EditLine rotate_line(const Vec3& axis, double degrees, const Vec3& about) const;
  EditLine scale_line(const Vec3& factors, const Vec3& about) const;

 private:
  struct LastEdit {
    EditLine line;
    NodeId from = 0;          ///< the node that it was applied to …
    NodeId node = 0;          ///< … and the one that gives the edited mesh, the same one for a source
    std::uint64_t state = 0;  ///< of the session after it
    bool applied = true;      ///< it changed something
  };

  EditLine line_of_selected(const std::string& edit, ParameterValues parameters) const;
  Verdict transform(const EditLine& line, const std::string& verb, recorded::Step step);
  AddedNode edited(const EditLine& line, PolyMesh mesh) const;
  Verdict commit(const EditLine& line, const std::string& label, MeshEdit edit, SelectAfter after);
  void keep_selection(const std::string& label, AddedNode edited);
  void select_results(const EditTarget& target, const MeshEdit& edit, const MeshTopology& before);

  EditableMesh& editable_;
  MeshSelector& selector_;
  CommandLog& log_;
  std::optional<LastEdit> last_;
  bool adjusting_ = false;
};

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

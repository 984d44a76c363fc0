// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "croquis/edits/edit_line.h"
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

  /// Does a step of mesh_steps() that needs no view, or the action "delete": faces go, edges and vertices dissolve.
  /// Without a pivot, that is the middle of what is selected. A Tag is of the selected edges (of faces: their edges), a
  /// sharpness of 0 untags; a Pin is of the selected vertices (of edges and faces: theirs).
  /// @throws Error (E_INPUT …) when the step doesn't fit the mesh
  Verdict take(const recorded::Step& step);

  /// Applies any edit of all_edits() to the elements that its line names. The undo step is called by the edit's title
  /// ("Inset 2 faces"), what was made is selected, and an EditStep is recorded.
  /// @throws Error (E_EDIT, E_PARAMETER, what the edit throws); nothing has changed then
  Verdict apply(const EditLine& line);

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

 private:
  struct LastEdit {
    EditLine line;
    NodeId from = 0;          ///< the node that it was applied to …
    NodeId node = 0;          ///< … and the one that gives the edited mesh, the same one for a source
    std::uint64_t state = 0;  ///< of the session after it
    bool applied = true;      ///< it changed something
  };

  Verdict run(const EditLine& line, const std::string& label, recorded::Step step, SelectAfter after);
  Verdict commit(const EditLine& line, const std::string& label, MeshEdit edit, SelectAfter after);
  void keep_selection(const std::string& label, AddedNode edited);
  void select_results(const EditTarget& target, const MeshEdit& edit, const MeshTopology& before);

  EditableMesh& editable_;
  MeshSelector& selector_;
  CommandLog& log_;
  std::optional<LastEdit> last_;
  bool adjusting_ = false;
};

/// The edit of what is selected, which isn't nothing, that a Move, Rotate or Scale comes to. @pre it has its pivot
EditLine transform_line(const MeshSelector& selector, const recorded::Step& step);

/// The edits that change the sharpness of edges by so many levels, one for each value that comes out.
std::vector<EditLine> sharpening_lines(const PolyMesh& mesh, const MeshTopology& topology, const Elements& edges,
                                       double by);

}  // namespace croquis

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

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
  MeshEditor(SourceMesh& source, MeshSelector& selector, CommandLog& log)
      : source_(source), selector_(selector), log_(log) {}

  /// Applies any edit of all_edits() to the elements that its line names. The undo step is called by the edit's title
  /// ("Inset 2 faces"), what was made is selected, and an EditStep is recorded.
  /// @throws Error (E_EDIT, E_PARAMETER, what the edit throws); nothing has changed then
  Verdict apply(const EditLine& line);
  /// The same with a label, a recorded step and a selection of one's own.
  Verdict run(const EditLine& line, const std::string& label, std::optional<recorded::Step> step, SelectAfter after);

  // ---- Of what is selected
  Verdict move_selected(const Vec3& by);
  Verdict rotate_selected(const Vec3& axis, double degrees, std::optional<Vec3> pivot = std::nullopt);
  Verdict scale_selected(const Vec3& factors, std::optional<Vec3> pivot = std::nullopt);
  Verdict delete_selected();  ///< faces go; edges and vertices dissolve
  Verdict extrude(const Vec3& by);
  Verdict extrude_along_normal(double distance);

  Verdict cut_loop(Index edge, double at);  ///< @throws Error when there is no such edge

 private:
  Verdict transform(const std::string& edit, const std::string& verb, ParameterValues parameters, recorded::Step step);
  Verdict commit(const EditTarget& target, const std::string& label, MeshEdit edit, SelectAfter after);
  void select_results(const EditTarget& target, const MeshEdit& edit, const MeshTopology& before);

  SourceMesh& source_;
  MeshSelector& selector_;
  CommandLog& log_;
};

}  // namespace croquis

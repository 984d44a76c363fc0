// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/tools/mesh/mesh_editor.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "croquis/base/error.h"
#include "croquis/edits/apply_edits.h"
#include "croquis/edits/starting_line.h"
#include "croquis/tools/recording/general_steps.h"
#include "tools/mesh/selection_edit.h"

namespace croquis {
namespace {

constexpr double greatest_rotation = 3600;  // degrees that the edit takes

bool same_mesh(const PolyMesh& a, const PolyMesh& b) {
  return a.positions == b.positions && a.face_offsets == b.face_offsets && a.corners == b.corners && a.tags == b.tags;
}

/// As edits read three numbers.
std::string vector_text(const Vec3& vector) {
  return to_text(ParameterValue(vector.x())) + ',' + to_text(ParameterValue(vector.y())) + ',' +
         to_text(ParameterValue(vector.z()));
}

}  // namespace

// ---- Any edit

std::string MeshEditor::label_of(const EditLine& line) const { return croquis::label_of(line, editable_.node_name()); }

Verdict MeshEditor::apply(const EditLine& line) {
  const NodeId from = editable_.node();
  const Verdict verdict =
      run(line, label_of(line), recorded::EditStep{editable_.node_name(), line, false}, SelectAfter::Results);
  if (verdict == Verdict::Commit) last_ = LastEdit{line, from, editable_.node(), editable_.session().state(), true};
  return verdict;
}

bool MeshEditor::fits_selection(const EditDescription& edit) const {
  return !selector_.selected().empty() && std::ranges::find(edit.kinds, selector_.kind()) != edit.kinds.end();
}

Verdict MeshEditor::begin(const std::string& id) {
  const Edit* edit = all_edits().find(id);
  const PreparedMesh* now = editable_.prepared();
  if (edit == nullptr || now == nullptr || !fits_selection(edit->describe())) return Verdict::Continue;
  return apply(
      starting_line(*now->mesh, *now->topology, *edit, {selector_.kind(), false, Elements(selector_.selected())}));
}

// ---- The last edit with other numbers

const EditLine* MeshEditor::last() const {
  if (adjusting_) return &last_->line;
  const bool newest = last_ && last_->node == editable_.node() && last_->state == editable_.session().state();
  return newest ? &last_->line : nullptr;
}

Verdict MeshEditor::adjust(ParameterValues parameters) {
  if (last() == nullptr || last_->line.parameters == parameters) return Verdict::Continue;
  log_.begin();
  Session& session = editable_.session();
  const LastEdit before = *last_;
  EditLine line = before.line;
  line.parameters = std::move(parameters);
  adjusting_ = true;  // listeners go on seeing the last edit, though it is taken back for a moment
  if (before.applied) session.undo();
  editable_.go_on_with(before.from);
  try {
    if (apply(line) != Verdict::Commit) last_ = LastEdit{line, before.from, before.from, session.state(), false};
  } catch (const Error&) {
    if (before.applied) session.redo();
    editable_.go_on_with(before.node);
    adjusting_ = false;
    throw;
  }
  adjusting_ = false;
  log_.done = recorded::EditStep{editable_.node_name(), std::move(line), true};
  return Verdict::Commit;
}

Verdict MeshEditor::run(const EditLine& line, const std::string& label, std::optional<recorded::Step> step,
                        SelectAfter after) {
  log_.begin();
  const PreparedMesh* now = editable_.prepared();
  if (now == nullptr) return Verdict::Continue;
  MeshEdit edit = apply_edit(*now->mesh, *now->topology, line, all_edits());
  log_.notes = std::move(edit.lost);
  if (same_mesh(*now->mesh, edit.mesh)) return Verdict::Continue;
  const Verdict verdict = commit(line, label, std::move(edit), after);
  if (verdict == Verdict::Commit) log_.done = std::move(step);
  return verdict;
}

Verdict MeshEditor::run_lines(const std::vector<EditLine>& lines, const std::string& label,
                              std::optional<recorded::Step> step) {
  log_.begin();
  if (lines.empty() || !editable_.mesh()) return Verdict::Continue;
  log_.notes.clear();
  keep_selection(label, editable_.with_lines(editable_.session().document(), lines));
  log_.done = std::move(step);
  return Verdict::Commit;
}

AddedNode MeshEditor::edited(const EditLine& line, PolyMesh mesh) const {
  if (editable_.is_computed()) return editable_.with_lines(editable_.session().document(), {line});
  return {editable_.with_mesh(std::move(mesh)), editable_.node()};
}

/// What is selected is so in the edited mesh as well.
void MeshEditor::keep_selection(const std::string& label, AddedNode edited) {
  Session& session = editable_.session();
  ComponentSelection selection = session.components();
  if (edited.node == editable_.node()) return session.edit(label, std::move(edited.document));
  if (selection.node == editable_.node()) selection.node = edited.node;
  editable_.go_on_with(edited.node);
  session.edit(label, std::move(edited.document), std::move(selection));
}

Verdict MeshEditor::commit(const EditLine& line, const std::string& label, MeshEdit edit, SelectAfter after) {
  Session& session = editable_.session();
  const std::uint64_t before = session.revision();
  const auto topology = editable_.topology();
  AddedNode result = edited(line, std::move(edit.mesh));
  const NodeId node = result.node;
  if (after == SelectAfter::AsBefore) {
    keep_selection(label, std::move(result));
  } else if (after == SelectAfter::Results && !edit.moved_faces.empty() && selector_.mode() == MeshMode::Face) {
    editable_.go_on_with(node);
    session.edit(label, std::move(result.document), {node, ComponentKind::Face, edit.moved_faces});
  } else {
    editable_.go_on_with(node);
    session.edit(label, std::move(result.document), {});
    if (after == SelectAfter::Results) select_results(line.target, edit, *topology);
  }
  return session.revision() == before ? Verdict::Continue : Verdict::Commit;
}

/// As part of the same undo step: selections aren't steps of their own.
void MeshEditor::select_results(const EditTarget& target, const MeshEdit& edit, const MeshTopology& before) {
  if (selector_.mode() == MeshMode::Object) return;
  const auto after = editable_.topology();
  ComponentSelection results{editable_.node(), target.kind, {}};
  if (!edit.new_edges.empty()) {
    results.kind = ComponentKind::Edge;
    results.elements = edges_of(*after, edit.new_edges);
  } else if (!edit.moved_faces.empty()) {
    results.kind = ComponentKind::Face;
    results.elements = edit.moved_faces;
  } else {
    const Elements elements = target.all ? all_elements(element_count(before, target.kind)) : target.elements;
    results.elements = carried(edit, before, *after, target.kind, elements);
  }
  selector_.set_mode(mode_of(results.kind));
  editable_.session().select_components(std::move(results));
}

// ---- Places

EditLine MeshEditor::line_of_selected(const std::string& edit, ParameterValues parameters) const {
  const bool whole = selector_.mode() == MeshMode::Object;
  EditLine line =
      edit_of(edit, whole ? ComponentKind::Vertex : selector_.kind(), selector_.selected(), std::move(parameters));
  line.target.all = whole;
  return line;
}

EditLine MeshEditor::move_line(const Vec3& by) const { return line_of_selected("move", {{"by", vector_text(by)}}); }

EditLine MeshEditor::rotate_line(const Vec3& axis, double degrees, const Vec3& about) const {
  const double taken = std::abs(degrees) > greatest_rotation ? std::remainder(degrees, 360) : degrees;
  return line_of_selected("rotate", {{"axis", vector_text(axis)}, {"degrees", taken}, {"about", vector_text(about)}});
}

EditLine MeshEditor::scale_line(const Vec3& factors, const Vec3& about) const {
  return line_of_selected("scale", {{"factors", vector_text(factors)}, {"about", vector_text(about)}});
}

Verdict MeshEditor::transform(const EditLine& line, const std::string& verb, recorded::Step step) {
  log_.begin();
  if (selector_.selected_vertices().empty()) return Verdict::Continue;
  const std::string label = selector_.counted(verb, selector_.kind(), selector_.selected().size());
  return run(line, label, std::move(step), SelectAfter::AsBefore);
}

Verdict MeshEditor::move_selected(const Vec3& by) {
  return transform(move_line(by), "Move", recorded::Move{editable_.node_name(), by});
}

Verdict MeshEditor::rotate_selected(const Vec3& axis, double degrees, std::optional<Vec3> pivot) {
  if (editable_.prepared() == nullptr || axis.isZero(0)) return Verdict::Continue;
  const Vec3 about = pivot ? *pivot : selector_.middle();
  return transform(rotate_line(axis, degrees, about), "Rotate",
                   recorded::Rotate{editable_.node_name(), axis, degrees, about});
}

Verdict MeshEditor::scale_selected(const Vec3& factors, std::optional<Vec3> pivot) {
  if (editable_.prepared() == nullptr) return Verdict::Continue;
  const Vec3 about = pivot ? *pivot : selector_.middle();
  return transform(scale_line(factors, about), "Scale", recorded::Scale{editable_.node_name(), factors, about});
}

// ---- Connectivity

Verdict MeshEditor::delete_selected() {
  const Elements chosen = selector_.selected();
  if (chosen.empty()) return Verdict::Continue;
  const ComponentKind kind = selector_.kind();
  const bool faces = kind == ComponentKind::Face;
  const std::string label = selector_.counted(faces ? "Delete" : "Dissolve", kind, chosen.size());
  const EditLine line = edit_of(faces ? "delete" : "dissolve", kind, chosen);
  return run(line, label, recorded::Action{"delete"}, SelectAfter::Nothing);
}

Verdict MeshEditor::extrude(const Vec3& by) {
  const Elements faces = selector_.selected();
  if (selector_.mode() != MeshMode::Face || faces.empty()) return Verdict::Continue;
  const std::string label = selector_.counted("Extrude", ComponentKind::Face, faces.size());
  const EditLine line = edit_of("extrude", ComponentKind::Face, faces, {{"by", vector_text(by)}});
  return run(line, label, recorded::Extrude{editable_.node_name(), by}, SelectAfter::Results);
}

Verdict MeshEditor::extrude_along_normal(double distance) {
  const PreparedMesh* now = editable_.prepared();
  if (now == nullptr || selector_.mode() != MeshMode::Face) return Verdict::Continue;
  return extrude(distance * mean_normal(*now->mesh, selector_.selected()));
}

Verdict MeshEditor::cut_loop(Index edge, double at) {
  const EditLine line = edit_of("loop-cut", ComponentKind::Edge, {edge}, {{"at", std::clamp(at, 0.0, 1.0)}});
  return run(line, "Cut a loop", recorded::LoopCut{editable_.node_name(), edge, at}, SelectAfter::Results);
}

}  // namespace croquis

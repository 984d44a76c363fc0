// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/tools/mesh/mesh_editor.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "croquis/edits/apply_edits.h"
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

Verdict MeshEditor::apply(const EditLine& line) {
  const Edit* edit = all_edits().find(line.edit);
  const std::string title = edit == nullptr ? line.edit : edit->describe().title;
  const EditTarget& target = line.target;
  const std::string what =
      target.all ? source_.node_name() : counted_elements(target.kind, sorted_unique(target.elements).size());
  return run(line, title + ' ' + what, recorded::EditStep{source_.node_name(), line}, SelectAfter::Results);
}

Verdict MeshEditor::run(const EditLine& line, const std::string& label, std::optional<recorded::Step> step,
                        SelectAfter after) {
  log_.begin();
  const PreparedMesh* now = source_.prepared();
  if (now == nullptr) return Verdict::Continue;
  MeshEdit edit = apply_edit(*now->mesh, *now->topology, line, all_edits());
  log_.notes = std::move(edit.lost);
  if (same_mesh(*now->mesh, edit.mesh)) return Verdict::Continue;
  const Verdict verdict = commit(line.target, label, std::move(edit), after);
  if (verdict == Verdict::Commit) log_.done = std::move(step);
  return verdict;
}

Verdict MeshEditor::commit(const EditTarget& target, const std::string& label, MeshEdit edit, SelectAfter after) {
  Session& session = source_.session();
  const std::uint64_t before = session.revision();
  const auto topology = source_.topology();
  Document edited = source_.with_mesh(std::move(edit.mesh));
  if (after == SelectAfter::AsBefore) {
    session.edit(label, std::move(edited));
  } else if (after == SelectAfter::Results && !edit.moved_faces.empty() && selector_.mode() == MeshMode::Face) {
    session.edit(label, std::move(edited), {source_.node(), ComponentKind::Face, edit.moved_faces});
  } else {
    session.edit(label, std::move(edited), {});
    if (after == SelectAfter::Results) select_results(target, edit, *topology);
  }
  return session.revision() == before ? Verdict::Continue : Verdict::Commit;
}

/// As part of the same undo step: selections aren't steps of their own.
void MeshEditor::select_results(const EditTarget& target, const MeshEdit& edit, const MeshTopology& before) {
  if (selector_.mode() == MeshMode::Object) return;
  const auto after = source_.topology();
  ComponentSelection results{source_.node(), target.kind, {}};
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
  source_.session().select_components(std::move(results));
}

// ---- Places

Verdict MeshEditor::transform(const std::string& edit, const std::string& verb, ParameterValues parameters,
                              recorded::Step step) {
  log_.begin();
  if (selector_.selected_vertices().empty()) return Verdict::Continue;
  const bool whole = selector_.mode() == MeshMode::Object;
  const ComponentKind kind = selector_.kind();
  const Elements& selected = selector_.selected();
  const std::string label = selector_.counted(verb, kind, selected.size());
  EditLine line = edit_of(edit, whole ? ComponentKind::Vertex : kind, selected, std::move(parameters));
  line.target.all = whole;
  return run(line, label, std::move(step), SelectAfter::AsBefore);
}

Verdict MeshEditor::move_selected(const Vec3& by) {
  return transform("move", "Move", {{"by", vector_text(by)}}, recorded::Move{source_.node_name(), by});
}

Verdict MeshEditor::rotate_selected(const Vec3& axis, double degrees, std::optional<Vec3> pivot) {
  if (source_.prepared() == nullptr || axis.isZero(0)) return Verdict::Continue;
  const Vec3 about = pivot ? *pivot : selector_.middle();
  const double taken = std::abs(degrees) > greatest_rotation ? std::remainder(degrees, 360) : degrees;
  return transform("rotate", "Rotate", {{"axis", vector_text(axis)}, {"degrees", taken}, {"about", vector_text(about)}},
                   recorded::Rotate{source_.node_name(), axis, degrees, about});
}

Verdict MeshEditor::scale_selected(const Vec3& factors, std::optional<Vec3> pivot) {
  if (source_.prepared() == nullptr) return Verdict::Continue;
  const Vec3 about = pivot ? *pivot : selector_.middle();
  return transform("scale", "Scale", {{"factors", vector_text(factors)}, {"about", vector_text(about)}},
                   recorded::Scale{source_.node_name(), factors, about});
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
  return run(line, label, recorded::Extrude{source_.node_name(), by}, SelectAfter::Results);
}

Verdict MeshEditor::extrude_along_normal(double distance) {
  const PreparedMesh* now = source_.prepared();
  if (now == nullptr || selector_.mode() != MeshMode::Face) return Verdict::Continue;
  return extrude(distance * mean_normal(*now->mesh, selector_.selected()));
}

Verdict MeshEditor::cut_loop(Index edge, double at) {
  const EditLine line = edit_of("loop-cut", ComponentKind::Edge, {edge}, {{"at", std::clamp(at, 0.0, 1.0)}});
  return run(line, "Cut a loop", recorded::LoopCut{source_.node_name(), edge, at}, SelectAfter::Results);
}

}  // namespace croquis

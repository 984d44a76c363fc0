// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/tools/mesh/mesh_editor.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "croquis/base/error.h"
#include "croquis/edits/apply_edits.h"
#include "croquis/tools/recording/general_steps.h"

namespace croquis {
namespace {

/// An edit of these elements.
EditLine edit_of(std::string edit, ComponentKind kind, Elements elements, ParameterValues parameters = {}) {
  EditLine line;
  line.edit = std::move(edit);
  line.target.kind = kind;
  line.target.elements = std::move(elements);
  line.parameters = std::move(parameters);
  return line;
}

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
  const Edit* edit = find_edit(id);
  const PreparedMesh* now = editable_.prepared();
  if (edit == nullptr || now == nullptr || !fits_selection(edit->description)) return Verdict::Continue;
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
  MeshEdit edit = apply_edit(*now->mesh, *now->topology, line);
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
    session.edit(label, std::move(result.document), ComponentSelection{node, ComponentKind::Face, edit.moved_faces});
  } else {
    editable_.go_on_with(node);
    session.edit(label, std::move(result.document), ComponentSelection{});
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

std::vector<EditLine> sharpening_lines(const PolyMesh& mesh, const MeshTopology& topology, const Elements& edges,
                                       double by) {
  const std::vector<double> before = edge_sharpness(mesh.tags, topology);
  const std::vector<double> after = edge_sharpness(with_sharpness_changed(mesh.tags, topology, edges, by), topology);
  std::map<double, Elements> by_value;
  for (const Index edge : edges) {
    if (after[edge] != before[edge]) by_value[std::min(after[edge], greatest_sharpness)].push_back(edge);
  }
  std::vector<EditLine> lines;
  for (auto& [value, own] : by_value) {
    lines.push_back(edit_of("sharpness", ComponentKind::Edge, std::move(own), {{"value", value}}));
  }
  return lines;
}

// ---- Sharpness and pins

Verdict TagEditor::tag_these(const Elements& edges, double sharpness, std::optional<recorded::Step> step) {
  if (edges.empty()) return Verdict::Continue;
  const std::string label = selector_.counted(sharpness > 0 ? "Sharpen" : "Smooth", ComponentKind::Edge, edges.size());
  // The edit takes finite numbers; from the greatest on all are infinite.
  const double value = std::clamp(sharpness, 0.0, greatest_sharpness);
  const EditLine line = edit_of("sharpness", ComponentKind::Edge, edges, {{"value", value}});
  return editor_.run(line, label, std::move(step), SelectAfter::AsBefore);
}

Verdict TagEditor::tag(double sharpness) {
  return tag_these(selector_.selected_edges(), sharpness,
                   recorded::Tag{editable_.node_name(), "selected", 0, sharpness, std::nullopt});
}

Verdict TagEditor::tag_edges(const Elements& edges, double sharpness) {
  return tag_these(edges, sharpness, std::nullopt);
}

Verdict TagEditor::tag_sharper_than(double degrees, double sharpness) {
  const PreparedMesh* now = editable_.prepared();
  if (now == nullptr) return Verdict::Continue;
  return tag_these(edges_sharper_than(*now->topology, *now->mesh, degrees), sharpness,
                   recorded::Tag{editable_.node_name(), "sharper-than", degrees, sharpness, std::nullopt});
}

std::size_t TagEditor::count_sharper_than(double degrees) {
  const PreparedMesh* now = editable_.prepared();
  return now == nullptr ? 0 : edges_sharper_than(*now->topology, *now->mesh, degrees).size();
}

Verdict TagEditor::tag_boundary(double sharpness) {
  const PreparedMesh* now = editable_.prepared();
  if (now == nullptr) return Verdict::Continue;
  return tag_these(boundary_edges(*now->topology), sharpness,
                   recorded::Tag{editable_.node_name(), "boundary", 0, sharpness, std::nullopt});
}

Verdict TagEditor::change_sharpness(double by) {
  const PreparedMesh* now = editable_.prepared();
  const Elements edges = selector_.selected_edges();
  if (now == nullptr || edges.empty()) return Verdict::Continue;
  const std::string label = selector_.counted("Sharpen", ComponentKind::Edge, edges.size());
  recorded::Tag step{editable_.node_name(), "selected", 0, std::nullopt, by};
  if (editable_.is_computed())
    return editor_.run_lines(sharpening_lines(*now->mesh, *now->topology, edges, by), label, std::move(step));
  return commit(label, with_sharpness_changed(now->mesh->tags, *now->topology, edges, by), std::move(step));
}

Verdict TagEditor::pin(bool pinned) {
  if (selector_.mode() == MeshMode::Object || selector_.selected_vertices().empty()) return Verdict::Continue;
  const Elements vertices = selector_.selected_vertices();
  const std::string label = selector_.counted(pinned ? "Pin" : "Unpin", ComponentKind::Vertex, vertices.size());
  const EditLine line = edit_of("pin", ComponentKind::Vertex, vertices, {{"pinned", pinned}});
  return editor_.run(line, label, recorded::Pin{editable_.node_name(), pinned}, SelectAfter::AsBefore);
}

// ---- Sets

Verdict TagEditor::commit(const std::string& label, MeshTags tags, recorded::Step step) {
  log_.begin();
  const auto now = editable_.mesh();
  if (!now || now->tags == tags) return Verdict::Continue;
  if (editable_.is_computed()) {
    throw Error(make_error(Category::Usage, "E_INPUT",
                           "Crease sets belong to meshes that aren't computed: freeze the step first"));
  }
  log_.notes.clear();
  PolyMesh edited = *now;
  edited.tags = std::move(tags);
  editable_.session().edit(label, editable_.with_mesh(std::move(edited)));
  log_.done = std::move(step);
  return Verdict::Commit;
}

Verdict TagEditor::make_set(const std::string& name, double sharpness) {
  const PreparedMesh* now = editable_.prepared();
  const MeshMode mode = selector_.mode();
  if (now == nullptr || mode == MeshMode::Object) return Verdict::Continue;
  const Elements vertices = mode == MeshMode::Vertex ? selector_.selected() : Elements{};
  const Elements edges = mode == MeshMode::Vertex ? Elements{} : selector_.selected_edges();
  return commit("Make the set " + name, with_set(now->mesh->tags, *now->topology, name, edges, vertices, sharpness),
                recorded::TagSet{editable_.node_name(), "make", name, "", sharpness});
}

Verdict TagEditor::rename_set(const std::string& name, const std::string& new_name) {
  const auto now = editable_.mesh();
  if (!now) return Verdict::Continue;
  return commit("Rename the set " + name, with_set_renamed(now->tags, name, new_name),
                recorded::TagSet{editable_.node_name(), "rename", name, new_name, std::nullopt});
}

Verdict TagEditor::set_set_sharpness(const std::string& name, double sharpness) {
  const auto now = editable_.mesh();
  if (!now) return Verdict::Continue;
  return commit("Sharpen the set " + name, with_set_sharpness(now->tags, name, sharpness),
                recorded::TagSet{editable_.node_name(), "sharpness", name, "", sharpness});
}

Verdict TagEditor::select_set(const std::string& name) {
  const PreparedMesh* now = editable_.prepared();
  if (now == nullptr) return Verdict::Continue;
  const CreaseSet* set = find_set(now->mesh->tags, name);
  if (set == nullptr) throw Error(make_error(Category::Usage, "E_INPUT", "There is no set \"" + name + "\""));
  const bool pins = set->edges.empty();
  return selector_.choose(pins ? ComponentKind::Vertex : ComponentKind::Edge,
                          pins ? set_vertices(*set, *now->topology) : set_edges(*set, *now->topology),
                          recorded::TagSet{editable_.node_name(), "select", name, "", std::nullopt});
}

Verdict TagEditor::merge_sets(const std::string& into, const std::string& from) {
  const auto now = editable_.mesh();
  if (!now) return Verdict::Continue;
  return commit("Merge the sets " + into + " and " + from, with_sets_merged(now->tags, into, from),
                recorded::TagSet{editable_.node_name(), "merge", into, from, std::nullopt});
}

Verdict TagEditor::remove_set(const std::string& name, bool untag) {
  const auto now = editable_.mesh();
  if (!now) return Verdict::Continue;
  return commit("Remove the set " + name, without_set(now->tags, name, untag),
                recorded::TagSet{editable_.node_name(), untag ? "untag" : "remove", name, "", std::nullopt});
}

}  // namespace croquis

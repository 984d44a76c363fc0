// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/tools/mesh/mesh_editor.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "croquis/base/error.h"
#include "croquis/edits/apply_edits.h"
#include "croquis/mesh_editing/tag_edit.h"
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

[[noreturn]] void refuse_step(const std::string& sentence) {
  throw Error(make_error(Category::Usage, "E_INPUT", sentence));
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

EditLine line_of_selected(const MeshSelector& selector, const std::string& edit, ParameterValues parameters) {
  const bool whole = selector.mode() == MeshMode::Object;
  EditLine line =
      edit_of(edit, whole ? ComponentKind::Vertex : selector.kind(), selector.selected(), std::move(parameters));
  line.target.all = whole;
  return line;
}

// ---- What steps come to

struct Command {
  recorded::Step step;               ///< as it is recorded
  std::string label;                 ///< of the undo step
  std::vector<EditLine> lines = {};  ///< one, or with tags any number
  SelectAfter after = SelectAfter::AsBefore;
  std::optional<MeshTags> tags = {};  ///< what a source gets instead; without lines, no computed mesh can have them
};

std::optional<Command> transform(recorded::Step step, const std::string& verb, MeshSelector& selector) {
  if (selector.selected_vertices().empty()) return std::nullopt;
  const std::string label = selector.counted(verb, selector.kind(), selector.selected().size());
  const EditLine line = transform_line(selector, step);
  return Command{std::move(step), label, {line}};
}

std::optional<Command> turn_or_scale(const recorded::Step& step, EditableMesh& editable, MeshSelector& selector) {
  if (editable.prepared() == nullptr) return std::nullopt;
  if (const auto* turn = step.as<recorded::Rotate>()) {
    if (turn->axis.isZero(0)) return std::nullopt;
    const Vec3 about = turn->pivot ? *turn->pivot : selector.middle();
    return transform(recorded::Rotate{editable.node_name(), turn->axis, turn->degrees, about}, "Rotate", selector);
  }
  const auto& scale = *step.as<recorded::Scale>();
  const Vec3 about = scale.pivot ? *scale.pivot : selector.middle();
  return transform(recorded::Scale{editable.node_name(), scale.factors, about}, "Scale", selector);
}

std::optional<Command> deletion(const MeshSelector& selector) {
  const Elements& chosen = selector.selected();
  if (chosen.empty()) return std::nullopt;
  const ComponentKind kind = selector.kind();
  const bool faces = kind == ComponentKind::Face;
  return Command{recorded::Action{"delete"},
                 selector.counted(faces ? "Delete" : "Dissolve", kind, chosen.size()),
                 {edit_of(faces ? "delete" : "dissolve", kind, chosen)},
                 SelectAfter::Nothing};
}

std::optional<Command> extrusion(const Vec3& by, const std::string& node, const MeshSelector& selector) {
  const Elements& faces = selector.selected();
  if (selector.mode() != MeshMode::Face || faces.empty()) return std::nullopt;
  return Command{recorded::Extrude{node, by},
                 selector.counted("Extrude", ComponentKind::Face, faces.size()),
                 {edit_of("extrude", ComponentKind::Face, faces, {{"by", vector_text(by)}})},
                 SelectAfter::Results};
}

std::optional<Command> pinning(bool pinned, const std::string& node, MeshSelector& selector) {
  if (selector.mode() == MeshMode::Object || selector.selected_vertices().empty()) return std::nullopt;
  const Elements& vertices = selector.selected_vertices();
  return Command{recorded::Pin{node, pinned},
                 selector.counted(pinned ? "Pin" : "Unpin", ComponentKind::Vertex, vertices.size()),
                 {edit_of("pin", ComponentKind::Vertex, vertices, {{"pinned", pinned}})}};
}

std::optional<Command> tagging(recorded::Tag step, EditableMesh& editable, MeshSelector& selector) {
  const PreparedMesh* now = editable.prepared();
  if (now == nullptr) refuse_step("\"" + step.node + "\" holds no mesh");
  const MeshTopology& topology = *now->topology;
  const MeshTags& tags = now->mesh->tags;
  const bool is_selected = step.change || step.edges == "selected";
  const Elements edges = is_selected                    ? selector.selected_edges()
                         : step.edges == "boundary"     ? boundary_edges(topology)
                         : step.edges == "sharper-than" ? edges_sharper_than(topology, *now->mesh, step.degrees)
                                                        : tagged_edges(tags, topology);
  if (edges.empty()) return std::nullopt;
  step.node = editable.node_name();
  if (step.change) {
    Command command{step, selector.counted("Sharpen", ComponentKind::Edge, edges.size())};
    command.tags = with_sharpness_changed(tags, topology, edges, *step.change);
    if (!editable.is_computed()) return command;
    command.lines = sharpening_lines(*now->mesh, topology, edges, *step.change);
    return command.lines.empty() ? std::nullopt : std::optional(command);
  }
  if (!step.sharpness) step.sharpness = infinite_sharpness;
  // The edit takes finite numbers; from the greatest on all are infinite.
  const double value = std::clamp(*step.sharpness, 0.0, greatest_sharpness);
  return Command{step,
                 selector.counted(*step.sharpness > 0 ? "Sharpen" : "Smooth", ComponentKind::Edge, edges.size()),
                 {edit_of("sharpness", ComponentKind::Edge, edges, {{"value", value}})}};
}

std::optional<Command> change_of_set(recorded::TagSet step, EditableMesh& editable, MeshSelector& selector) {
  const PreparedMesh* now = editable.prepared();
  if (now == nullptr) return std::nullopt;
  const MeshTags& tags = now->mesh->tags;
  const double sharpness = step.sharpness.value_or(infinite_sharpness);
  const auto command = [&](const std::string& label, MeshTags changed) {
    step.node = editable.node_name();
    return Command{step, label, {}, SelectAfter::AsBefore, std::move(changed)};
  };
  const std::string& name = step.name;
  if (step.how == "rename") return command("Rename the set " + name, with_set_renamed(tags, name, step.other));
  if (step.how == "sharpness") return command("Sharpen the set " + name, with_set_sharpness(tags, name, sharpness));
  if (step.how == "merge")
    return command("Merge the sets " + name + " and " + step.other, with_sets_merged(tags, name, step.other));
  if (step.how != "make") return command("Remove the set " + name, without_set(tags, name, step.how == "untag"));
  if (selector.mode() == MeshMode::Object) return std::nullopt;
  const bool pins = selector.mode() == MeshMode::Vertex;
  const Elements vertices = pins ? selector.selected() : Elements{};
  const Elements edges = pins ? Elements{} : selector.selected_edges();
  step.sharpness = sharpness;
  return command("Make the set " + name, with_set(tags, *now->topology, name, edges, vertices, sharpness));
}

/// Nothing when there is nothing to do.
std::optional<Command> command_of(const recorded::Step& step, EditableMesh& editable, MeshSelector& selector) {
  const std::string node = editable.node_name();
  if (const auto* move = step.as<recorded::Move>()) return transform(recorded::Move{node, move->by}, "Move", selector);
  if (step.as<recorded::Rotate>() || step.as<recorded::Scale>()) return turn_or_scale(step, editable, selector);
  if (const auto* lift = step.as<recorded::Extrude>()) return extrusion(lift->by, node, selector);
  if (const auto* tag = step.as<recorded::Tag>()) return tagging(*tag, editable, selector);
  if (const auto* pin = step.as<recorded::Pin>()) return pinning(pin->pinned, node, selector);
  if (const auto* set = step.as<recorded::TagSet>()) return change_of_set(*set, editable, selector);
  if (const auto* cut = step.as<recorded::LoopCut>()) {
    return Command{recorded::LoopCut{node, cut->edge, cut->at},
                   "Cut a loop",
                   {edit_of("loop-cut", ComponentKind::Edge, {cut->edge}, {{"at", std::clamp(cut->at, 0.0, 1.0)}})},
                   SelectAfter::Results};
  }
  if (const auto* action = step.as<recorded::Action>(); action && action->name == "delete") return deletion(selector);
  refuse_step("\"" + step.kind().verbs.front() + "\" is no step on a mesh");
}

Verdict take_pick(const recorded::Pick& step, EditableMesh& editable, MeshSelector& selector) {
  const auto topology = editable.topology();
  if (!topology) refuse_step("\"" + step.node + "\" holds no mesh");
  const ComponentKind kind = kind_of_singular(step.kind).value_or(ComponentKind::Edge);
  const std::size_t count = element_count(*topology, kind);
  for (const Index element : step.elements) {
    if (element >= count) refuse_step("The mesh has no " + step.kind + " " + std::to_string(element));
  }
  return selector.pick(kind, step.elements, pick_how(step.how));
}

/// The edges of a set, or its pins when it has none.
Verdict select_set(recorded::TagSet step, EditableMesh& editable, MeshSelector& selector) {
  const PreparedMesh* now = editable.prepared();
  if (now == nullptr) return Verdict::Continue;
  const CreaseSet* set = find_set(now->mesh->tags, step.name);
  if (set == nullptr) refuse_step("There is no set \"" + step.name + "\"");
  const bool pins = set->edges.empty();
  step.node = editable.node_name();
  return selector.choose(pins ? ComponentKind::Vertex : ComponentKind::Edge,
                         pins ? set_vertices(*set, *now->topology) : set_edges(*set, *now->topology), step);
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

Verdict MeshEditor::take(const recorded::Step& step) {
  if (const auto* pick = step.as<recorded::Pick>()) return take_pick(*pick, editable_, selector_);
  if (const auto* set = step.as<recorded::TagSet>(); set && set->how == "select")
    return select_set(*set, editable_, selector_);
  if (const auto* edit = step.as<recorded::EditStep>()) {
    if (!editable_.mesh()) refuse_step("\"" + edit->node + "\" holds no mesh");
    if (!edit->again) return apply(edit->line);
    const EditLine* now = last();
    if (now == nullptr || now->edit != edit->line.edit || !(now->target == edit->line.target))
      refuse_step("\"" + to_text(edit->line) + "\" isn't the last edit with other parameters");
    return adjust(edit->line.parameters);
  }
  const std::optional<Command> command = command_of(step, editable_, selector_);
  if (!command) return Verdict::Continue;
  if (!command->tags) return run(command->lines.front(), command->label, command->step, command->after);
  log_.begin();
  const auto now = editable_.mesh();
  if (!now || now->tags == *command->tags) return Verdict::Continue;
  AddedNode edited{{}, editable_.node()};
  if (!editable_.is_computed()) {
    PolyMesh mesh = *now;
    mesh.tags = *command->tags;
    edited.document = editable_.with_mesh(std::move(mesh));
  } else if (!command->lines.empty()) {
    edited = editable_.with_lines(editable_.session().document(), command->lines);
  } else {
    refuse_step("Crease sets belong to meshes that aren't computed: freeze the step first");
  }
  log_.notes.clear();
  keep_selection(command->label, std::move(edited));
  log_.done = command->step;
  return Verdict::Commit;
}

Verdict MeshEditor::run(const EditLine& line, const std::string& label, recorded::Step step, SelectAfter after) {
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
  AddedNode result = editable_.is_computed() ? editable_.with_lines(session.document(), {line})
                                             : AddedNode{editable_.with_mesh(std::move(edit.mesh)), editable_.node()};
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

// ---- Lines

EditLine transform_line(const MeshSelector& selector, const recorded::Step& step) {
  if (const auto* move = step.as<recorded::Move>())
    return line_of_selected(selector, "move", {{"by", vector_text(move->by)}});
  if (const auto* turn = step.as<recorded::Rotate>()) {
    const bool is_far = std::abs(turn->degrees) > greatest_rotation;
    const double taken = is_far ? std::remainder(turn->degrees, 360) : turn->degrees;
    return line_of_selected(
        selector, "rotate",
        {{"axis", vector_text(turn->axis)}, {"degrees", taken}, {"about", vector_text(*turn->pivot)}});
  }
  const auto& scale = *step.as<recorded::Scale>();
  return line_of_selected(selector, "scale",
                          {{"factors", vector_text(scale.factors)}, {"about", vector_text(*scale.pivot)}});
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

}  // namespace croquis

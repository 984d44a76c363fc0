// SPDX-License-Identifier: GPL-3.0-or-later
#include <functional>
#include <map>

#include "croquis/base/error.h"
#include "croquis/tools/mesh/mesh_tool.h"

namespace croquis {
namespace {

using StepReplays = std::map<const recorded::StepKind*, std::function<Verdict(MeshTool&, const recorded::Step&)>>;

[[noreturn]] void refuse_step(const std::string& sentence) {
  throw Error(make_error(Category::Usage, "E_INPUT", sentence));
}

ComponentKind kind_of(const std::string& name) {
  if (name == "vertex") return ComponentKind::Vertex;
  return name == "face" ? ComponentKind::Face : ComponentKind::Edge;
}

PickHow how_of(const std::string& name) {
  static const std::map<std::string, PickHow> hows = {{"replace", PickHow::Replace},     {"add", PickHow::Add},
                                                      {"remove", PickHow::Remove},       {"toggle", PickHow::Toggle},
                                                      {"loop", PickHow::Loop},           {"ring", PickHow::Ring},
                                                      {"path", PickHow::Path},           {"chain", PickHow::Chain},
                                                      {"connected", PickHow::Connected}, {"all", PickHow::All}};
  const auto found = hows.find(name);
  return found == hows.end() ? PickHow::Replace : found->second;
}

Verdict replay_pick(MeshTool& tool, const recorded::Pick& step) {
  const auto topology = tool.editable().topology();
  if (!topology) refuse_step("\"" + step.node + "\" holds no mesh");
  const std::size_t count = element_count(*topology, kind_of(step.kind));
  for (const Index element : step.elements) {
    if (element >= count) refuse_step("The mesh has no " + step.kind + " " + std::to_string(element));
  }
  return tool.selection().pick(kind_of(step.kind), step.elements, how_of(step.how));
}

Verdict replay_edit(MeshTool& tool, const recorded::EditStep& step) {
  if (!tool.editable().mesh()) refuse_step("\"" + step.node + "\" holds no mesh");
  if (!step.again) return tool.edits().apply(step.line);
  const EditLine* last = tool.edits().last();
  if (last == nullptr || last->edit != step.line.edit || !(last->target == step.line.target)) {
    refuse_step("\"" + to_text(step.line) + "\" isn't the last edit with other parameters");
  }
  return tool.edits().adjust(step.line.parameters);
}

Verdict replay_move(MeshTool& tool, const recorded::Move& step) { return tool.edits().move_selected(step.by); }

Verdict replay_rotate(MeshTool& tool, const recorded::Rotate& step) {
  return tool.edits().rotate_selected(step.axis, step.degrees, step.pivot);
}

Verdict replay_scale(MeshTool& tool, const recorded::Scale& step) {
  return tool.edits().scale_selected(step.factors, step.pivot);
}

Verdict replay_extrude(MeshTool& tool, const recorded::Extrude& step) { return tool.edits().extrude(step.by); }

Verdict replay_loop_cut(MeshTool& tool, const recorded::LoopCut& step) {
  return tool.edits().cut_loop(step.edge, step.at);
}

Verdict replay_tag(MeshTool& tool, const recorded::Tag& step) {
  const PreparedMesh* now = tool.editable().prepared();
  if (now == nullptr) refuse_step("\"" + step.node + "\" holds no mesh");
  TagEditor& tags = tool.tags();
  if (step.change) return tags.change_sharpness(*step.change);
  const double sharpness = step.sharpness.value_or(infinite_sharpness);
  if (step.edges == "boundary") return tags.tag_boundary(sharpness);
  if (step.edges == "sharper-than") return tags.tag_sharper_than(step.degrees, sharpness);
  if (step.edges == "tagged") return tags.tag_edges(tagged_edges(now->mesh->tags, *now->topology), sharpness);
  return tags.tag(sharpness);
}

Verdict replay_pin(MeshTool& tool, const recorded::Pin& step) { return tool.tags().pin(step.pinned); }

Verdict replay_tag_set(MeshTool& tool, const recorded::TagSet& step) {
  TagEditor& tags = tool.tags();
  const double sharpness = step.sharpness.value_or(infinite_sharpness);
  if (step.how == "rename") return tags.rename_set(step.name, step.other);
  if (step.how == "sharpness") return tags.set_set_sharpness(step.name, sharpness);
  if (step.how == "select") return tags.select_set(step.name);
  if (step.how == "merge") return tags.merge_sets(step.name, step.other);
  if (step.how == "remove" || step.how == "untag") return tags.remove_set(step.name, step.how == "untag");
  return tags.make_set(step.name, sharpness);
}

template <typename T>
void add_replay(StepReplays& replays, Verdict (*replay)(MeshTool&, const T&)) {
  replays[&recorded::step_kind<T>()] = [replay](MeshTool& tool, const recorded::Step& step) {
    return replay(tool, *step.as<T>());
  };
}

const StepReplays& step_replays() {
  static const StepReplays replays = [] {
    StepReplays made;
    add_replay(made, replay_pick);
    add_replay(made, replay_edit);
    add_replay(made, replay_move);
    add_replay(made, replay_rotate);
    add_replay(made, replay_scale);
    add_replay(made, replay_extrude);
    add_replay(made, replay_loop_cut);
    add_replay(made, replay_tag);
    add_replay(made, replay_pin);
    add_replay(made, replay_tag_set);
    return made;
  }();
  return replays;
}

}  // namespace

Verdict MeshTool::replay(const recorded::Step& step) {
  const auto found = step_replays().find(&step.kind());
  if (found == step_replays().end()) refuse_step("\"" + step.kind().verbs.front() + "\" is no step on a mesh");
  return found->second(*this, step);
}

}  // namespace croquis

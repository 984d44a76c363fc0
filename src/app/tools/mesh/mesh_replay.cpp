// SPDX-License-Identifier: GPL-3.0-or-later
// Recorded steps of work on meshes.
#include "app/replay/replay_lookup.h"
#include "app/tools/mesh/mesh_editing_tool.h"
#include "croquis/tools/mesh/mesh_steps.h"
#include "croquis/tools/recording/general_steps.h"

namespace croquis::app {
namespace {

/// The node that a step of that kind names; nothing for other kinds.
template <class T>
std::optional<std::string> node_in(const recorded::Step& step) {
  const T* own = step.as<T>();
  return own == nullptr ? std::nullopt : std::optional(own->node);
}

template <class... Kinds>
struct StepList {
  static std::vector<const recorded::StepKind*> kinds() { return {&recorded::step_kind<Kinds>()...}; }

  static std::optional<std::string> node_of(const recorded::Step& step) {
    std::optional<std::string> node;
    ((node = node ? node : node_in<Kinds>(step)), ...);
    return node;
  }
};

/// The object of that name, else the one with such a node in its chain.
const WorkObject& object_with_node(const Studio& studio, const std::string& name) {
  for (const auto& node : studio.session().document().nodes()) {
    const WorkObject* object = node->name == name ? studio.object(node->id) : nullptr;
    if (object != nullptr && object->node != node->id && !object->begins_with_mesh) return *object;
  }
  return object_named(studio, name);
}

/// Steps that need no view.
using CommandSteps =
    StepList<recorded::Pick, recorded::Move, recorded::Rotate, recorded::Scale, recorded::Tag, recorded::Pin,
             recorded::TagSet, recorded::Extrude, recorded::LoopCut, recorded::EditStep>;

}  // namespace

std::vector<const recorded::StepKind*> MeshEditingTool::steps() const {
  auto kinds = CommandSteps::kinds();
  kinds.insert(kinds.end(), {&recorded::step_kind<recorded::ModelDrag>(), &recorded::step_kind<recorded::Click>(),
                             &recorded::step_kind<recorded::Box>()});
  return kinds;
}

bool MeshEditingTool::replay(const recorded::Step& step) {
  if (const auto* drag = step.as<recorded::ModelDrag>()) {
    mesh_.replay(view_of(drag->view), drag->from, drag->to, modifiers_of(drag->modifiers), 1);
  } else if (const auto* click = step.as<recorded::Click>(); click != nullptr && click->place) {
    mesh_.replay(view_of(click->view), *click->place, *click->place, modifiers_of(click->modifiers), click->clicks);
  } else if (const auto* box = step.as<recorded::Box>(); box != nullptr && box->from_place && box->to_place) {
    mesh_.replay(view_of(box->view), *box->from_place, *box->to_place, modifiers_of(box->modifiers), 1);
  } else if (const auto node = CommandSteps::node_of(step)) {
    replay_on_mesh(*node, step);
  } else {
    return false;
  }
  return true;
}

void MeshEditingTool::replay_on_mesh(const std::string& node, const recorded::Step& step) {
  if (const auto* pick = step.as<recorded::Pick>()) {
    const MeshMode mode = mode_of(kind_of_singular(pick->kind).value_or(ComponentKind::Edge));
    if (mesh_.tool().selection().mode() != mode) set_mesh_mode(mode);
  }
  if (!node.empty()) studio().set_active(object_with_node(studio(), node).node);
  if (const auto* edit = step.as<recorded::EditStep>(); edit != nullptr && studio().active()->cage == 0) {
    set_mesh_mode(mode_of(edit->line.target.kind));  // begins the work on a computed mesh
  }
  mesh_.follow();
  const MeshMode before = mesh_.tool().selection().mode();
  mesh_.tool().replay(step);
  mesh_.follow();
  const MeshMode after = mesh_.tool().selection().mode();
  if (after != before) mesh_.set_mode(after);  // the window's buttons follow
  show_last_edit();
}

}  // namespace croquis::app

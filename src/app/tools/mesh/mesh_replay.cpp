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
  static std::vector<const recorded::StepKind*> kinds() { return {&Kinds::step_kind()...}; }

  static std::optional<std::string> node_of(const recorded::Step& step) {
    std::optional<std::string> node;
    ((node = node ? node : node_in<Kinds>(step)), ...);
    return node;
  }
};

/// Steps that need no view.
using CommandSteps =
    StepList<recorded::Pick, recorded::Move, recorded::Rotate, recorded::Scale, recorded::Tag, recorded::Pin,
             recorded::TagSet, recorded::Extrude, recorded::LoopCut, recorded::EditStep>;

}  // namespace

std::vector<const recorded::StepKind*> MeshEditingTool::steps() const {
  auto kinds = CommandSteps::kinds();
  kinds.insert(kinds.end(),
               {&recorded::ModelDrag::step_kind(), &recorded::Click::step_kind(), &recorded::Box::step_kind()});
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
    if (mesh_.tool().selection().mode() != mode) mesh_.set_mode(mode);
  }
  if (!node.empty()) studio().set_active(object_named(studio(), node).node);
  mesh_.follow();
  const MeshMode before = mesh_.tool().selection().mode();
  mesh_.tool().replay(step);
  mesh_.follow();
  const MeshMode after = mesh_.tool().selection().mode();
  if (after != before) mesh_.set_mode(after);  // the window's buttons follow
}

}  // namespace croquis::app

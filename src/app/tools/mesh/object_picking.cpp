// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tools/mesh/object_picking.h"

#include <string>
#include <utility>

#include "croquis/tools/recording/general_steps.h"

namespace croquis::app {
namespace {

constexpr double drag_pixels = 4;  // a press that moves less is a click
const std::vector<std::string> view_names{"front", "perspective", "top", "side", "comparison"};

/// As clicks on elements do: plain replaces, Shift toggles, Ctrl takes away, both add.
void choose_objects(Studio& studio, const std::vector<NodeId>& picked, const Modifiers& modifiers) {
  const std::vector<NodeId> nodes = with_groups(studio, picked);
  Selection selection = modifiers.shift || modifiers.ctrl ? studio.session().selection() : Selection();
  for (const NodeId node : nodes) {
    const auto is_it = [&](const SelectedItem& item) {
      const WorkObject* object = item.part.empty() ? studio.object(item.node) : nullptr;
      return object != nullptr && object->node == node;
    };
    const bool was_picked = std::erase_if(selection, is_it) > 0;
    const bool stays = modifiers.ctrl ? modifiers.shift : !was_picked || !modifiers.shift;
    if (stays) selection.push_back({node, ""});
  }
  if (!nodes.empty() && !modifiers.ctrl) studio.set_active(nodes.front());
  studio.session().select(std::move(selection));
}

}  // namespace

std::optional<recorded::Step> ObjectPicking::handle(const MeshEvent& event, int view) {
  const bool begins = event.kind == PenStep::Kind::Begin;
  if (begins) press_ = event.pixel;
  const bool was_moving = mover_.active();
  if (was_moving || begins) {
    const bool has_moved = mover_.handle(event) == Verdict::Commit;
    if (was_moving && !mover_.active()) press_.reset();
    if (has_moved) return *mover_.done();
    if (was_moving || mover_.active()) return std::nullopt;
  }
  if (event.kind == PenStep::Kind::Sample) {
    if ((event.pixel - *press_).norm() > drag_pixels || box_) box_ = PickBox::spanned(*press_, event.pixel);
    return std::nullopt;
  }
  if (begins) return std::nullopt;
  std::optional<recorded::Step> done;
  if (event.kind == PenStep::Kind::End) done = finish(event, view);
  press_.reset();
  box_.reset();
  return done;
}

std::optional<recorded::Step> ObjectPicking::finish(const MeshEvent& event, int view) {
  if (box_) {
    choose_objects(studio_, ObjectPicker::in_box(studio_.objects(), event.frame, *box_), event.modifiers);
    return std::nullopt;
  }
  const ObjectPicker::Hit hit = picker_.at(studio_.objects(), event.frame, event.pixel);
  choose_objects(studio_, hit.node == 0 ? std::vector<NodeId>{} : std::vector<NodeId>{hit.node}, event.modifiers);
  recorded::Click click;
  click.view = view_names.at(static_cast<std::size_t>(view));
  click.place = hit.node == 0 ? event.frame.unproject(event.pixel, 0) : hit.place;
  if (event.modifiers.shift) click.modifiers.emplace_back("shift");
  if (event.modifiers.ctrl) click.modifiers.emplace_back("ctrl");
  return click;
}

}  // namespace croquis::app

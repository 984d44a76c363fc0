// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/tools/objects/object_mover.h"

#include <array>
#include <limits>
#include <string>
#include <utility>

#include "croquis/workspace/computed.h"
#include "croquis/workspace/object_names.h"

namespace croquis {
namespace {

constexpr ManipulatorSnap snap_with_ctrl{0, 15, 0.1};

std::string verb_of(ManipulatorKind kind) {
  if (kind == ManipulatorKind::Rotate) return "Rotate ";
  return kind == ManipulatorKind::Scale ? "Scale " : "Move ";
}

/// The objects that a drag moves: picked ones that are seen.
std::vector<const WorkObject*> seen_and_picked(const Workspace& workspace) {
  std::vector<const WorkObject*> objects;
  for (const NodeId node : picked(workspace)) {
    const WorkObject* object = workspace.object(node);
    if (object->visible && workspace.own_bounds(*object)) objects.push_back(object);
  }
  return objects;
}

}  // namespace

void ObjectMover::set_kind(ManipulatorKind kind) {
  give_up();
  kind_ = kind;
  hovered_ = ManipulatorHandle::None;
}

std::optional<Manipulator> ObjectMover::manipulator() const {
  if (kind_ == ManipulatorKind::None) return std::nullopt;
  if (drag_) return drag_->moved();
  const auto objects = seen_and_picked(workspace_);
  if (objects.empty()) return std::nullopt;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Vec3 low = Vec3::Constant(infinity);
  Vec3 high = -low;
  for (const WorkObject* object : objects) {
    const std::array<Vec3, 2> box = *placed_bounds(workspace_, *object);
    low = low.cwiseMin(box[0]);
    high = high.cwiseMax(box[1]);
  }
  Manipulator now;
  now.kind = kind_;
  now.pivot = (low + high) / 2;
  const bool own_axes = kind_ == ManipulatorKind::Scale && objects.size() == 1;
  if (own_axes) now.axes = rotation_matrix(objects.front()->placement.rotation);
  return now;
}

ManipulatorPicture ObjectMover::manipulator_picture(const ViewFrame& frame) const {
  const auto now = manipulator();
  return now ? picture(*now, frame, hovered_, drag_ ? drag_->handle() : ManipulatorHandle::None) : ManipulatorPicture{};
}

bool ObjectMover::hover(const Vec2& pixel, const ViewFrame& frame) {
  if (active() || !pixel.allFinite()) return false;
  const auto now = manipulator();
  const ManipulatorHandle before = std::exchange(hovered_, now ? handle_at(*now, frame, pixel) : ManipulatorHandle());
  return before != hovered_;
}

bool ObjectMover::leave() {
  return !active() && std::exchange(hovered_, ManipulatorHandle::None) != ManipulatorHandle::None;
}

Verdict ObjectMover::handle(const MeshEvent& event) {
  if (event.kind == PenStep::Kind::Cancel) return give_up();
  if (event.kind == PenStep::Kind::Begin) {
    give_up();
    const auto now = event.pixel.allFinite() ? manipulator() : std::nullopt;
    const ManipulatorHandle hit = now ? handle_at(*now, event.frame, event.pixel) : ManipulatorHandle::None;
    if (hit == ManipulatorHandle::None) return Verdict::Continue;
    start_ = event;
    begun_ = workspace_.session().document();
    moved_.clear();
    for (const WorkObject* object : seen_and_picked(workspace_)) moved_.push_back({object->node, object->placement});
    drag_.emplace(*now, hit, event.pixel);
    return Verdict::Continue;
  }
  if (!drag_) return Verdict::Continue;
  if (drag_of_session_.interrupted()) return give_up();
  if (event.pixel.allFinite()) drag_to(event.pixel);
  return event.kind == PenStep::Kind::End ? finish() : Verdict::Continue;
}

std::vector<PlacedObject> ObjectMover::moved_by(const Eigen::Affine3d& map) const {
  std::vector<PlacedObject> placed = moved_;
  for (PlacedObject& each : placed) each.placement = moved(each.placement, {map.linear(), map.translation()});
  return placed;
}

void ObjectMover::drag_to(const Vec2& pixel) {
  if (!drag_of_session_.begun()) {
    if (pixel == start_.pixel) return;
    const bool alone = moved_.size() == 1;
    drag_of_session_.begin(verb_of(kind_) + (alone ? readable_name(workspace_.object(moved_.front().node)->name)
                                                   : std::to_string(moved_.size()) + " objects"));
  }
  const auto& motion = drag_->to(start_.frame, pixel, start_.modifiers.ctrl ? snap_with_ctrl : ManipulatorSnap{});
  const std::vector<PlacedObject> placed = moved_by(motion.map);
  for (const PlacedObject& each : placed) {
    if (!is_valid(each.placement)) return;  // beyond what places can be
  }
  drag_of_session_.to(with_objects_placed(workspace_, begun_, placed));
}

Verdict ObjectMover::finish() {
  const bool dragged = drag_of_session_.begun();
  drag_.reset();
  if (!dragged) return Verdict::Continue;
  drag_of_session_.end();
  done_ = recorded::Place();
  for (const PlacedObject& each : moved_) {
    const WorkObject* object = workspace_.object(each.node);
    done_->nodes.push_back(object->name);
    done_->places.push_back(object->placement);
  }
  return Verdict::Commit;
}

Verdict ObjectMover::give_up() {
  if (!drag_) return Verdict::Continue;
  drag_.reset();
  drag_of_session_.cancel();
  return Verdict::Revert;
}

}  // namespace croquis

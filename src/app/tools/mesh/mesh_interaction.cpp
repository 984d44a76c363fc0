// SPDX-License-Identifier: GPL-3.0-or-later
// What pen and mouse do to objects and elements, and what is drawn of that.

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/panels/number_box.h"
#include "app/tools/mesh/mesh_editing_tool.h"
#include "app/views/own_space.h"
#include "app/views/viewport.h"
#include "croquis/base/error.h"
#include "croquis/tools/recording/general_steps.h"

namespace croquis::app {
namespace {

constexpr double drag_pixels = 4;  // a press that moves less is a click
const std::vector<std::string> view_names{"front", "perspective", "top", "side", "comparison"};

QString sentence_of(const Findings& findings) {
  QString text;
  for (const Finding& finding : findings) {
    const QString sentence = QString::fromStdString(finding.message);
    text += (text.isEmpty() ? "" : " ") + (sentence.endsWith('.') ? sentence : sentence + ".");
  }
  return text;
}

/// What a drag of a handle has done, as it stands at the pointer.
QString motion_text(const ManipulatorMotion& motion, MeshHandles handles) {
  const auto all = [](const Vec3& vector) {
    return MeshEditingTool::tr("x %1  y %2  z %3")
        .arg(number_words(vector.x()), number_words(vector.y()), number_words(vector.z()));
  };
  if (handles == MeshHandles::Rotate) return number_words(motion.degrees) + QStringLiteral("°");
  if (handles == MeshHandles::Move) return number_words(motion.by.norm()) + "   " + all(motion.by);
  const bool is_even = motion.factors.isApprox(Vec3::Constant(motion.factors.x()));
  return is_even ? QStringLiteral("× ") + number_words(motion.factors.x())
                 : QStringLiteral("×   ") + all(motion.factors);
}

QString sharpness_text(double sharpness) {
  return std::isinf(sharpness) ? QStringLiteral("∞") : number_words(sharpness);
}

}  // namespace

void MeshEditingTool::act(const std::function<Verdict(MeshTool&)>& work) {
  try {
    finish(work(tool_));
  } catch (const Error& error) {
    emit told(sentence_of(error.findings()));
  }
  follow();
}

void MeshEditingTool::finish(Verdict verdict) {
  if (verdict != Verdict::Commit) return;
  if (tool_.done()) emit committed(*tool_.done());
  emit told(sentence_of(tool_.notes()));
}

void MeshEditingTool::hide_cage(bool hidden) {
  cage_hidden_ = hidden && tool_.selection().mode() != MeshMode::Object;
  follow();
}

void MeshEditingTool::enter_mesh_mode(MeshMode mode) {
  cage_hidden_ = false;
  studio().set_edits_elements(mode != MeshMode::Object);
  tool_.selection().set_mode(mode);
  follow();
  emit state_changed();
}

void MeshEditingTool::set_handles(MeshHandles handles) {
  tool_.set_handles(handles);
  mover_.set_kind(handles == MeshHandles::Move     ? ManipulatorKind::Move
                  : handles == MeshHandles::Rotate ? ManipulatorKind::Rotate
                  : handles == MeshHandles::Scale  ? ManipulatorKind::Scale
                                                   : ManipulatorKind::None);
  follow();
  emit state_changed();
}

void MeshEditingTool::take(const PointerEvent& event) {
  if (event.action == PointerEvent::Action::Leave) return leave();
  for (const PenStep& step : pen_.handle(event)) feed(step);
  if (!pen_.down()) hover(event);
}

void MeshEditingTool::leave() {
  hovered_value_.reset();
  const bool left_handle = mover_.leave();
  if (!tool_.leave() && !left_handle) return;
  follow_hover();
  emit changed();
}

void MeshEditingTool::follow_hover() {
  overlay_.follow_hover(tool_, host().viewport().objects().cage_item(tool_.editable().node()));
}

bool MeshEditingTool::abandon() {
  if (pen_.down()) {
    for (const PenStep& step : pen_.cancel()) feed(step);
    return true;
  }
  if (!tool_.loop_cut_armed()) return false;
  tool_.arm_loop_cut(false);
  follow();
  return true;
}

/// Elements lie in the space of their object, objects in the model's.
ViewFrame MeshEditingTool::frame_in(int view) const {
  return picks_objects() && !tool_.loop_cut_armed() ? host().viewport().frame_of(view)
                                                    : host().viewport().own_frame_of(view);
}

void MeshEditingTool::feed(const PenStep& step) {
  MeshEvent event;
  event.kind = step.kind;
  event.pixel = step.sample.position;
  event.modifiers = step.modifiers;
  event.frame = frame_in(step.view);
  event.time = step.sample.time;
  feed(event, step.view);
}

void MeshEditingTool::feed(const MeshEvent& event, int view) {
  gesture_view_ = view;
  try {
    finish(tool_.handle(event));
  } catch (const Error& error) {
    emit told(sentence_of(error.findings()));
  }
  const bool left_to_us = tool_.selection().mode() == MeshMode::Object && !tool_.active();
  if (object_press_ || (left_to_us && event.kind == PenStep::Kind::Begin)) feed_object(event, view);
  hovered_value_.reset();
  if (motion() != nullptr) hovered_value_ = {view, event.pixel, motion_text(*motion(), tool_.handles())};
  follow_hover();
  emit changed();
}

void MeshEditingTool::feed_object(const MeshEvent& event, int view) {
  if (event.kind == PenStep::Kind::Begin) object_press_ = event.pixel;
  const bool was_moving = mover_.active();
  if (was_moving || event.kind == PenStep::Kind::Begin) {
    if (mover_.handle(event) == Verdict::Commit) emit committed(*mover_.done());
    if (was_moving && !mover_.active()) object_press_.reset();
    if (was_moving || mover_.active()) return;
  }
  switch (event.kind) {
    case PenStep::Kind::Begin: break;
    case PenStep::Kind::Sample:
      if ((event.pixel - *object_press_).norm() > drag_pixels || object_box_) {
        object_box_ = PickBox::spanned(*object_press_, event.pixel);
      }
      break;
    case PenStep::Kind::End: {
      if (object_box_) {
        choose_objects(ObjectPicker::in_box(studio().objects(), event.frame, *object_box_), event.modifiers);
      } else {
        const ObjectPicker::Hit hit = objects_.at(studio().objects(), event.frame, event.pixel);
        choose_objects(hit.node == 0 ? std::vector<NodeId>{} : std::vector<NodeId>{hit.node}, event.modifiers);
        recorded::Click click;
        click.view = view_names.at(static_cast<std::size_t>(view));
        click.place = hit.node == 0 ? event.frame.unproject(event.pixel, 0) : hit.place;
        if (event.modifiers.shift) click.modifiers.emplace_back("shift");
        if (event.modifiers.ctrl) click.modifiers.emplace_back("ctrl");
        emit committed(click);
      }
      [[fallthrough]];
    }
    case PenStep::Kind::Cancel:
      object_press_.reset();
      object_box_.reset();
      break;
  }
}

/// As clicks on elements do: plain replaces, Shift toggles, Ctrl takes away, both add.
void MeshEditingTool::choose_objects(std::vector<NodeId> nodes, const Modifiers& modifiers) {
  nodes = with_groups(studio(), nodes);
  Selection selection = modifiers.shift || modifiers.ctrl ? studio().session().selection() : Selection();
  for (const NodeId node : nodes) {
    const auto is_it = [&](const SelectedItem& item) {
      const WorkObject* object = item.part.empty() ? studio().object(item.node) : nullptr;
      return object != nullptr && object->node == node;
    };
    const bool was_picked = std::erase_if(selection, is_it) > 0;
    const bool stays = modifiers.ctrl ? modifiers.shift : !was_picked || !modifiers.shift;
    if (stays) selection.push_back({node, ""});
  }
  if (!nodes.empty() && !modifiers.ctrl) studio().set_active(nodes.front());
  studio().session().select(std::move(selection));
}

void MeshEditingTool::replay_drag(int view, const Vec3& from, const Vec3& to, const Modifiers& modifiers, int clicks) {
  MeshEvent event;
  event.frame = frame_in(view);
  event.modifiers = modifiers;
  const auto start = event.frame.project(from);
  const auto end = event.frame.project(to);
  if (!start || !end) return;
  for (int click = 0; click < clicks; ++click) {
    event.time = 0.01 * click;
    event.kind = PenStep::Kind::Begin;
    event.pixel = start->pixel;
    feed(event, view);
    constexpr int moves = 4;
    event.kind = PenStep::Kind::Sample;
    for (int k = 1; k <= moves && from != to; ++k) {
      event.pixel = start->pixel + (end->pixel - start->pixel) * k / moves;
      feed(event, view);
    }
    event.kind = PenStep::Kind::End;
    event.pixel = end->pixel;
    feed(event, view);
  }
}

const ManipulatorMotion* MeshEditingTool::motion() const {
  const auto& of_elements = tool_.preview().motion;
  return of_elements ? &*of_elements : mover_.motion();
}

void MeshEditingTool::hover(const PointerEvent& event) {
  hovered_value_.reset();
  gesture_view_ = event.view;
  const bool on_handle = picks_objects() && mover_.hover(event.position, frame_in(event.view));
  const bool moved = tool_.hover(event.position, frame_in(event.view));
  if (tool_.preview().hovered_sharpness) {
    hovered_value_ = {event.view, event.position, sharpness_text(*tool_.preview().hovered_sharpness)};
  }
  if (moved) follow_hover();
  if (moved || on_handle || hovered_value_) emit changed();
}

QString MeshEditingTool::help() const {
  const WorkObject* object = studio().active();
  const QString offer = object == nullptr ? QString() : host().offer_for(*object);
  const MeshPreview& preview = tool_.preview();
  if (motion() != nullptr)
    return tr("%1 · Ctrl at the beginning snaps · Escape gives it up").arg(motion_text(*motion(), tool_.handles()));
  if (preview.sharpness_change) {
    return tr("Sharpness %1%2: drag sideways")
        .arg(*preview.sharpness_change < 0 ? "" : "+")
        .arg(*preview.sharpness_change, 0, 'f', 2);
  }
  if (tool_.loop_cut_armed()) return tr("Click an edge: the loop is cut there · Escape gives it up");
  const bool selected = !studio().session().components().empty();
  switch (tool_.selection().mode()) {
    case MeshMode::Object:
      if (!offer.isEmpty()) return offer;
      if (mover_.manipulator()) return tr("Drag a handle · Ctrl snaps · Shift picks several · Ctrl+D duplicates");
      return tr(
          "O finds its holes · 3 makes it smooth · F9 vertices, F10 edges, F11 faces · Alt+drag rotates the view");
    case MeshMode::Edge:
      if (selected) return tr("H makes them sharp, Shift+H smooth · right button: the menu · W moves · Ctrl+Z undoes");
      return tr("Click an edge, double click its loop · drag a box · Shift adds, Ctrl takes away");
    case MeshMode::Vertex:
      if (selected) return tr("W moves, E rotates, R scales · P pins, Shift+P lets go · Delete dissolves");
      return tr("Click a vertex or drag a box · Shift adds, Ctrl takes away");
    case MeshMode::Face:
      if (selected) return tr("Shift+E extrudes · W moves, E rotates, R scales · Delete removes");
      return tr("Click a face, double click all that is connected · Shift adds, Ctrl takes away");
  }
  return {};
}

void MeshEditingTool::follow() {
  const WorkObject* object = studio().active();
  const NodeId cage = object == nullptr ? 0 : object->cage;
  if (tool_.editable().node() != cage && !tool_.active()) tool_.set_node(cage);
  overlay_.follow(tool_, studio().session().components(), object, host().viewport().objects().cage_item(cage),
                  !cage_hidden_);
  emit changed();
}

void MeshEditingTool::add_to(render::Scene& scene, int view) {
  const bool with_handles = works_in(view);
  const WorkObject* object = studio().active();
  const ViewFrame own_frame = host().viewport().own_frame_of(view);
  {
    const PlacedPart own(scene, object == nullptr ? Affine3() : object->placement.map());
    overlay_.add_to(scene, view != ComparisonView);
    if (with_handles) add_handles(tool_.manipulator_picture(own_frame), scene);
  }
  if (!with_handles) return;
  const ViewFrame frame = host().viewport().frame_of(view);
  if (picks_objects()) add_handles(mover_.manipulator_picture(frame), scene);
  const std::optional<PickBox>& box = object_box_ ? object_box_ : tool_.preview().box;
  if (box && view == gesture_view_) add_box(*box, frame, scene);
}

}  // namespace croquis::app

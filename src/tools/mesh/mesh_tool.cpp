// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/tools/mesh/mesh_tool.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "croquis/base/error.h"

namespace croquis {
namespace {

constexpr double sharpness_step = 0.1;  // levels: a pointer isn't more exact

bool is_manipulating(MeshHandles handles) {
  return handles == MeshHandles::Move || handles == MeshHandles::Rotate || handles == MeshHandles::Scale;
}

ManipulatorKind manipulator_kind(MeshHandles handles) {
  if (handles == MeshHandles::Move) return ManipulatorKind::Move;
  return handles == MeshHandles::Rotate ? ManipulatorKind::Rotate : ManipulatorKind::Scale;
}

PickHow how_of(const Modifiers& modifiers) {
  if (modifiers.shift) return modifiers.ctrl ? PickHow::Add : PickHow::Toggle;
  return modifiers.ctrl ? PickHow::Remove : PickHow::Replace;
}

bool same_hover(const std::optional<PickedElement>& a, const std::optional<PickedElement>& b) {
  return a.has_value() == b.has_value() && (!a || (a->element == b->element && a->parameter == b->parameter));
}

[[noreturn]] void refuse_step(const std::string& sentence) {
  throw Error(make_error(Category::Usage, "E_INPUT", sentence));
}

Verdict replay_pick(MeshTool& tool, const recorded::Pick& step) {
  const auto topology = tool.editable().topology();
  if (!topology) refuse_step("\"" + step.node + "\" holds no mesh");
  const ComponentKind kind = kind_of_singular(step.kind).value_or(ComponentKind::Edge);
  const std::size_t count = element_count(*topology, kind);
  for (const Index element : step.elements) {
    if (element >= count) refuse_step("The mesh has no " + step.kind + " " + std::to_string(element));
  }
  return tool.selection().pick(kind, step.elements, pick_how(step.how));
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

Verdict replay_tag_set(TagEditor& tags, const recorded::TagSet& step) {
  const double sharpness = step.sharpness.value_or(infinite_sharpness);
  if (step.how == "rename") return tags.rename_set(step.name, step.other);
  if (step.how == "sharpness") return tags.set_set_sharpness(step.name, sharpness);
  if (step.how == "select") return tags.select_set(step.name);
  if (step.how == "merge") return tags.merge_sets(step.name, step.other);
  if (step.how == "remove" || step.how == "untag") return tags.remove_set(step.name, step.how == "untag");
  return tags.make_set(step.name, sharpness);
}

}  // namespace

MeshTool::MeshTool(Session& session, MeshToolOptions options) : MeshTool(session, nullptr, options) {}

MeshTool::MeshTool(Workspace& workspace, MeshToolOptions options)
    : MeshTool(workspace.session(), &workspace, options) {}

MeshTool::MeshTool(Session& session, Workspace* workspace, MeshToolOptions options)
    : session_(session),
      options_(options),
      log_{[this] { give_up(); }, {}, {}},
      editable_(session, workspace),
      selector_(editable_, log_, [this](bool changes) { leave_mode(changes); }),
      editor_(editable_, selector_, log_),
      tag_editor_(editable_, selector_, editor_, log_),
      session_drag_(session) {}

void MeshTool::set_node(NodeId node) {
  if (node == editable_.node()) return;
  give_up();
  leave();
  last_click_.reset();
  editable_.set_node(node);
}

void MeshTool::leave_mode(bool changes) {
  arm_loop_cut(false);
  if (!changes) return;
  preview_ = {};
  anchor_ = anchor_before_ = no_index;
  last_click_.reset();
}

void MeshTool::set_handles(MeshHandles handles) {
  give_up();
  handles_ = handles;
  preview_.hovered_handle = ManipulatorHandle::None;
}

void MeshTool::arm_loop_cut(bool armed) {
  give_up();
  loop_cut_armed_ = armed;
  preview_.cut.reset();
}

// ---- Hovering

bool MeshTool::hover(const Vec2& pixel, const ViewFrame& frame) {
  if (active() || !pixel.allFinite()) return false;
  const auto hovered_before = preview_.hovered;
  const ManipulatorHandle handle_before = preview_.hovered_handle;
  preview_.hovered.reset();
  preview_.hovered_sharpness.reset();
  preview_.hovered_handle = ManipulatorHandle::None;
  preview_.cut.reset();
  PreparedMesh* ready = editable_.prepared_if_ready();
  if (const auto now = loop_cut_armed_ ? std::nullopt : manipulator())
    preview_.hovered_handle = handle_at(*now, frame, pixel);
  const bool picks = loop_cut_armed_ || selector_.mode() != MeshMode::Object;
  if (ready != nullptr && picks && preview_.hovered_handle == ManipulatorHandle::None)
    hover_element(*ready, pixel, frame);
  return handle_before != preview_.hovered_handle || !same_hover(hovered_before, preview_.hovered);
}

void MeshTool::hover_element(PreparedMesh& now, const Vec2& pixel, const ViewFrame& frame) {
  const ComponentKind wanted = loop_cut_armed_ ? ComponentKind::Edge : selector_.kind();
  preview_.hovered = now.picker.at(frame, pixel, wanted, options_.pick);
  if (!preview_.hovered || wanted != ComponentKind::Edge) return;
  const Index element = preview_.hovered->element;
  const double sharpness = editable_.edge_sharpness()[element];
  if (sharpness > 0) preview_.hovered_sharpness = sharpness;
  if (loop_cut_armed_) preview_.cut = loop_cut_preview(*now.mesh, *now.topology, element, preview_.hovered->parameter);
}

bool MeshTool::leave() {
  if (active()) return false;
  const bool had = preview_.hovered || preview_.hovered_handle != ManipulatorHandle::None;
  preview_ = {};
  return had;
}

// ---- The manipulator

std::optional<Manipulator> MeshTool::manipulator() {
  if (!is_manipulating(handles_) || selector_.mode() == MeshMode::Object) return std::nullopt;
  if (gesture_ == Gesture::Handle && drag_) return drag_->moved();
  if (!editable_.ready() || selector_.selected_vertices().empty()) return std::nullopt;
  Manipulator now;
  now.kind = manipulator_kind(handles_);
  now.pivot = selector_.middle();
  now.pixels = options_.manipulator_pixels;
  return now;
}

ManipulatorPicture MeshTool::manipulator_picture(const ViewFrame& frame) {
  const auto now = loop_cut_armed_ ? std::nullopt : manipulator();
  return now ? picture(*now, frame, preview_.hovered_handle, preview_.active_handle) : ManipulatorPicture{};
}

// ---- Gestures

Verdict MeshTool::handle(const MeshEvent& event) {
  if (event.kind == PenStep::Kind::Cancel) return give_up();
  if (event.kind == PenStep::Kind::Begin) return event.pixel.allFinite() ? begin(event) : give_up();
  if (gesture_ == Gesture::None) return Verdict::Continue;
  if (session_drag_.interrupted()) return give_up();
  if (event.pixel.allFinite() && event.pixel != last_) go_on(event);
  return event.kind == PenStep::Kind::End ? finish(event) : Verdict::Continue;
}

Verdict MeshTool::begin(const MeshEvent& event) {
  give_up();
  if (editable_.prepared() == nullptr) return Verdict::Continue;
  start_ = event;
  last_ = event.pixel;
  press(event);
  return Verdict::Continue;
}

void MeshTool::press(const MeshEvent& event) {
  log_.notes.clear();
  may_sharpen_ = false;
  if (loop_cut_armed_) {
    gesture_ = Gesture::Press;
    return;
  }
  if (const auto now = manipulator()) {
    const ManipulatorHandle hit = handle_at(*now, event.frame, event.pixel);
    if (hit != ManipulatorHandle::None) {
      gesture_ = Gesture::Handle;
      preview_.active_handle = hit;
      drag_.emplace(*now, hit, event.pixel);
      return;
    }
  }
  if (selector_.mode() == MeshMode::Object) return;
  gesture_ = Gesture::Press;
  if (handles_ != MeshHandles::Sharpen || selector_.mode() != MeshMode::Edge || selector_.selected().empty()) return;
  const auto under = editable_.prepared()->picker.at(event.frame, event.pixel, ComponentKind::Edge, options_.pick);
  may_sharpen_ = event.modifiers.shift || (under && std::binary_search(selector_.selected().begin(),
                                                                       selector_.selected().end(), under->element));
}

void MeshTool::go_on(const MeshEvent& event) {
  last_ = event.pixel;
  if (gesture_ == Gesture::Press && !loop_cut_armed_ && (last_ - start_.pixel).norm() > options_.drag_pixels) {
    gesture_ = may_sharpen_ ? Gesture::Sharpen : Gesture::Box;
    preview_.hovered.reset();
  }
  if (gesture_ == Gesture::Box) preview_.box = PickBox::spanned(start_.pixel, last_);
  if (gesture_ == Gesture::Handle) drag_handle(last_);
  if (gesture_ == Gesture::Sharpen) drag_sharpness(last_);
}

Verdict MeshTool::finish(const MeshEvent& event) {
  switch (gesture_) {
    case Gesture::Press: return loop_cut_armed_ ? cut_hovered(event) : click();
    case Gesture::Box: return finish_box();
    case Gesture::Handle: return finish_handle();
    case Gesture::Sharpen: return finish_sharpness();
    case Gesture::None: break;
  }
  return Verdict::Continue;
}

Verdict MeshTool::give_up() {
  if (gesture_ == Gesture::None) return Verdict::Continue;
  const bool goes_back = session_drag_.begun() && !session_drag_.interrupted();
  const NodeId before = begun_.node;
  end_gesture();
  if (goes_back) editable_.go_on_with(before);
  session_drag_.cancel();
  return Verdict::Revert;
}

void MeshTool::end_gesture() {
  gesture_ = Gesture::None;
  preview_ = {};
  drag_.reset();
  original_.reset();
  begun_ = {};
  dragged_.clear();
}

// ---- Drags

void MeshTool::start_drag() {
  original_ = editable_.mesh();
  begun_ = {session_.document(), editable_.node()};
  const bool sharpens = gesture_ == Gesture::Sharpen;
  dragged_ = sharpens ? selector_.selected() : selector_.selected_vertices();
  const std::string verb = sharpens                          ? "Sharpen"
                           : handles_ == MeshHandles::Move   ? "Move"
                           : handles_ == MeshHandles::Rotate ? "Rotate"
                                                             : "Scale";
  session_drag_.begin(selector_.counted(verb, selector_.kind(), selector_.selected().size()));
}

void MeshTool::drag_handle(const Vec2& pixel) {
  const ManipulatorMotion& motion =
      drag_->to(start_.frame, pixel, start_.modifiers.ctrl ? options_.snap : ManipulatorSnap{});
  if (!session_drag_.begun()) start_drag();
  preview_.motion = motion;
  if (editable_.is_computed()) return drag_lines(lines_of(motion));
  drag_to({editable_.with_mesh(transformed(*original_, dragged_, motion.map)), editable_.node()});
}

void MeshTool::drag_to(AddedNode edited) {
  const NodeId before = editable_.node();
  ComponentSelection selection = session_.components();
  session_drag_.to(std::move(edited.document));
  if (edited.node == before) return;
  if (selection.node == before) selection.node = edited.node;
  editable_.go_on_with(edited.node);
  session_drag_.select(std::move(selection));
}

/// Each time these lines take the place of those that the drag had before. A drag that came back to where it began is
/// no edit.
void MeshTool::drag_lines(const std::vector<EditLine>& lines) {
  const NodeId now = editable_.node();
  editable_.go_on_with(begun_.node);
  AddedNode edited = begun_;
  try {
    if (!lines.empty()) edited = editable_.with_lines(begun_.document, lines);
  } catch (const Error&) {
    editable_.go_on_with(now);
    throw;
  }
  editable_.go_on_with(now);
  drag_to(std::move(edited));
}

/// None for a motion that moves nothing.
std::vector<EditLine> MeshTool::lines_of(const ManipulatorMotion& motion) const {
  const Vec3 pivot = drag_->moved().pivot - motion.by;
  if (motion.map.matrix() == Eigen::Affine3d::Identity().matrix()) return {};
  if (handles_ == MeshHandles::Move) return {editor_.move_line(motion.by)};
  if (handles_ == MeshHandles::Scale) return {editor_.scale_line(motion.factors, pivot)};
  return {editor_.rotate_line(motion.axis, motion.degrees, pivot)};
}

void MeshTool::drag_sharpness(const Vec2& pixel) {
  if (!session_drag_.begun()) start_drag();
  const double levels = (pixel.x() - start_.pixel.x()) / options_.pixels_per_level;
  preview_.sharpness_change = std::round(levels / sharpness_step) * sharpness_step;
  if (editable_.is_computed()) {
    return drag_lines(sharpening_lines(*original_, *editable_.topology(), dragged_, *preview_.sharpness_change));
  }
  PolyMesh sharpened = *original_;
  sharpened.tags = with_sharpness_changed(original_->tags, *editable_.topology(), dragged_, *preview_.sharpness_change);
  drag_to({editable_.with_mesh(std::move(sharpened)), editable_.node()});
}

std::optional<recorded::Step> MeshTool::recorded_motion(const ManipulatorMotion& motion, const Vec3& pivot) const {
  if (handles_ == MeshHandles::Move) return recorded::Move{editable_.node_name(), motion.by};
  if (handles_ == MeshHandles::Scale) return recorded::Scale{editable_.node_name(), motion.factors, pivot};
  if (motion.axis.isZero(0)) return std::nullopt;
  return recorded::Rotate{editable_.node_name(), motion.axis, motion.degrees, pivot};
}

Verdict MeshTool::finish_handle() {
  const ManipulatorMotion motion = drag_->motion();
  // The drag turns and scales about where it began.
  const Vec3 pivot = drag_->moved().pivot - motion.by;
  end_gesture();
  if (!session_drag_.begun()) return Verdict::Continue;
  log_.done = recorded_motion(motion, pivot);
  session_drag_.end();
  return log_.done ? Verdict::Commit : Verdict::Revert;
}

Verdict MeshTool::finish_sharpness() {
  const double change = preview_.sharpness_change.value_or(0);
  end_gesture();
  log_.done = recorded::Tag{editable_.node_name(), "selected", 0, std::nullopt, change};
  session_drag_.end();
  return Verdict::Commit;
}

Verdict MeshTool::finish_box() {
  const PickBox box = PickBox::spanned(start_.pixel, last_);
  const Modifiers modifiers = start_.modifiers;
  const ViewFrame frame = start_.frame;
  end_gesture();
  PreparedMesh* now = editable_.prepared();
  if (now == nullptr) return Verdict::Revert;
  return selector_.pick(selector_.kind(), now->picker.in_box(frame, box, selector_.kind(), options_.pick.through),
                        how_of(modifiers));
}

Verdict MeshTool::cut_hovered(const MeshEvent& event) {
  end_gesture();
  PreparedMesh* now = editable_.prepared();
  if (now == nullptr) return Verdict::Revert;
  const auto under = now->picker.at(start_.frame, event.pixel, ComponentKind::Edge, options_.pick);
  if (!under) return Verdict::Revert;
  loop_cut_armed_ = false;
  return editor_.cut_loop(under->element, under->parameter);
}

// ---- Clicks

Verdict MeshTool::click() {
  const MeshEvent at = start_;
  end_gesture();
  const bool again = last_click_ && at.time - last_click_->time <= options_.double_click_seconds &&
                     (at.pixel - last_click_->pixel).norm() <= options_.drag_pixels;
  last_click_ = again ? std::nullopt : std::optional(at);
  PreparedMesh* now = editable_.prepared();
  if (now == nullptr) return Verdict::Revert;
  const auto under = now->picker.at(at.frame, at.pixel, selector_.kind(), options_.pick);
  const PickHow how = how_of(at.modifiers);
  if (!under) return how == PickHow::Replace ? selector_.select_none() : Verdict::Continue;
  forget_other_anchors();
  if (again) return click_again(under->element);
  anchor_before_ = std::exchange(anchor_, under->element);
  return selector_.pick(selector_.kind(), {under->element}, how);
}

/// Those of another connectivity.
void MeshTool::forget_other_anchors() {
  if (std::exchange(anchors_connectivity_, editable_.connectivity()) == editable_.connectivity()) return;
  anchor_ = anchor_before_ = no_index;
}

Verdict MeshTool::click_again(Index element) {
  const ComponentKind kind = selector_.kind();
  const PickHow whole = kind == ComponentKind::Edge ? PickHow::Loop : PickHow::Connected;
  if (start_.modifiers.ctrl && !start_.modifiers.shift)
    return selector_.pick(kind, selector_.expanded(kind, element, whole), PickHow::Remove);
  const bool goes_on = start_.modifiers.shift && anchor_before_ < element_count(*editable_.topology(), kind) &&
                       anchor_before_ != element;
  if (goes_on && !selector_.path(kind, anchor_before_, element).empty())
    return selector_.pick(kind, {anchor_before_, element}, PickHow::Path);
  return selector_.pick(kind, {element}, whole);
}

// ---- Recordings

Verdict MeshTool::replay(const recorded::Step& step) {
  MeshEditor& editor = edits();
  if (const auto* pick = step.as<recorded::Pick>()) return replay_pick(*this, *pick);
  if (const auto* edit = step.as<recorded::EditStep>()) return replay_edit(*this, *edit);
  if (const auto* move = step.as<recorded::Move>()) return editor.move_selected(move->by);
  if (const auto* turn = step.as<recorded::Rotate>())
    return editor.rotate_selected(turn->axis, turn->degrees, turn->pivot);
  if (const auto* scale = step.as<recorded::Scale>()) return editor.scale_selected(scale->factors, scale->pivot);
  if (const auto* extrusion = step.as<recorded::Extrude>()) return editor.extrude(extrusion->by);
  if (const auto* cut = step.as<recorded::LoopCut>()) return editor.cut_loop(cut->edge, cut->at);
  if (const auto* tag = step.as<recorded::Tag>()) return replay_tag(*this, *tag);
  if (const auto* pin = step.as<recorded::Pin>()) return tags().pin(pin->pinned);
  if (const auto* set = step.as<recorded::TagSet>()) return replay_tag_set(tags(), *set);
  refuse_step("\"" + step.kind().verbs.front() + "\" is no step on a mesh");
}

}  // namespace croquis

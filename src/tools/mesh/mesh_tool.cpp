// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/tools/mesh/mesh_tool.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "croquis/base/error.h"
#include "croquis/mesh_editing/tag_edit.h"

namespace croquis {

/// A gesture under way.
struct MeshGesture {
  enum class Kind { Press, Box, Handle, Sharpen };

  Kind kind = Kind::Press;
  MeshEvent start;                           ///< that began the gesture
  Vec2 last = Vec2::Zero();                  ///< where the pointer is
  bool may_sharpen = false;                  ///< the press was meant for the sharpness if it moves
  std::optional<ManipulatorDrag> handle;     ///< of a handle
  std::shared_ptr<const PolyMesh> original;  ///< Handle, Sharpen: before the drag …
  AddedNode begun;                           ///< … with the document and the node worked on
  Elements dragged;                          ///< vertices, or edges of Sharpen
};

namespace {

constexpr double sharpness_step = 0.1;  // levels: a pointer isn't more exact

PickHow how_of(const Modifiers& modifiers) {
  if (modifiers.shift) return modifiers.ctrl ? PickHow::Add : PickHow::Toggle;
  return modifiers.ctrl ? PickHow::Remove : PickHow::Replace;
}

bool same_hover(const std::optional<PickedElement>& a, const std::optional<PickedElement>& b) {
  return a.has_value() == b.has_value() && (!a || (a->element == b->element && a->parameter == b->parameter));
}

/// What a drag of a handle comes to; nothing for a turn about no axis. It turns and scales about where it began.
std::optional<recorded::Step> step_of(MeshHandles handles, const ManipulatorDrag& drag, const std::string& node) {
  const ManipulatorMotion& motion = drag.motion();
  const Vec3 pivot = drag.moved().pivot - motion.by;
  if (handles == MeshHandles::Move) return recorded::Move{node, motion.by};
  if (handles == MeshHandles::Scale) return recorded::Scale{node, motion.factors, pivot};
  if (motion.axis.isZero(0)) return std::nullopt;
  return recorded::Rotate{node, motion.axis, motion.degrees, pivot};
}

/// None for a motion that moves nothing.
std::vector<EditLine> lines_of(MeshHandles handles, const ManipulatorDrag& drag, const MeshSelector& selector) {
  const auto step = step_of(handles, drag, {});
  if (!step || drag.motion().map.matrix() == Eigen::Affine3d::Identity().matrix()) return {};
  return {transform_line(selector, *step)};
}

/// The document with lines of edits after the node where a drag began. None: the drag came back to where it began,
/// which is no edit.
AddedNode with_drag(EditableMesh& editable, const AddedNode& begun, const std::vector<EditLine>& lines) {
  if (lines.empty()) return begun;
  const NodeId now = editable.node();
  editable.go_on_with(begun.node);
  try {
    AddedNode edited = editable.with_lines(begun.document, lines);
    editable.go_on_with(now);
    return edited;
  } catch (const Error&) {
    editable.go_on_with(now);
    throw;
  }
}

/// What is selected goes on to the node that gives the edited mesh.
void drag_to(SessionDrag& drag, EditableMesh& editable, AddedNode edited) {
  const NodeId before = editable.node();
  ComponentSelection selection = editable.session().components();
  drag.to(std::move(edited.document));
  if (edited.node == before) return;
  if (selection.node == before) selection.node = edited.node;
  editable.go_on_with(edited.node);
  drag.select(std::move(selection));
}

/// @param anchor the element that was clicked before, or none
Verdict click_again(MeshTool& tool, Index element, Index anchor, const Modifiers& modifiers) {
  MeshSelector& selector = tool.selection();
  const ComponentKind kind = selector.kind();
  const PickHow whole = kind == ComponentKind::Edge ? PickHow::Loop : PickHow::Connected;
  if (modifiers.ctrl && !modifiers.shift)
    return selector.pick(kind, selector.expanded(kind, element, whole), PickHow::Remove);
  const bool goes_on =
      modifiers.shift && anchor < element_count(*tool.editable().topology(), kind) && anchor != element;
  if (goes_on && !selector.path(kind, anchor, element).empty())
    return selector.pick(kind, {anchor, element}, PickHow::Path);
  return selector.pick(kind, {element}, whole);
}

Verdict click(MeshTool& tool, const MeshEvent& at, const MeshToolOptions& options, MeshClicks& clicks) {
  const bool again = clicks.last && at.time - clicks.last->time <= options.double_click_seconds &&
                     (at.pixel - clicks.last->pixel).norm() <= options.drag_pixels;
  clicks.last = again ? std::nullopt : std::optional(at);
  MeshSelector& selector = tool.selection();
  const auto under = tool.editable().prepared()->picker.at(at.frame, at.pixel, selector.kind(), options.pick);
  const PickHow how = how_of(at.modifiers);
  if (!under) return how == PickHow::Replace ? selector.select_none() : Verdict::Continue;
  // Numbers of another connectivity mean nothing any more.
  const std::uint64_t connectivity = tool.editable().connectivity();
  if (std::exchange(clicks.connectivity, connectivity) != connectivity) clicks.anchor = clicks.anchor_before = no_index;
  if (again) return click_again(tool, under->element, clicks.anchor_before, at.modifiers);
  clicks.anchor_before = std::exchange(clicks.anchor, under->element);
  return selector.pick(selector.kind(), {under->element}, how);
}

/// What a drag has made of the document. @param change levels of sharpness
AddedNode edited_by(const MeshGesture& now, MeshTool& tool, double change) {
  EditableMesh& editable = tool.editable();
  const PolyMesh& before = *now.original;
  if (editable.is_computed()) {
    return with_drag(editable, now.begun,
                     now.handle ? lines_of(tool.handles(), *now.handle, tool.selection())
                                : sharpening_lines(before, *editable.topology(), now.dragged, change));
  }
  PolyMesh edited = now.handle ? transformed(before, now.dragged, now.handle->motion().map) : before;
  if (!now.handle) edited.tags = with_sharpness_changed(before.tags, *editable.topology(), now.dragged, change);
  return {editable.with_mesh(std::move(edited)), editable.node()};
}

}  // namespace

ManipulatorKind manipulator_kind(MeshHandles handles) {
  if (handles == MeshHandles::Move) return ManipulatorKind::Move;
  if (handles == MeshHandles::Rotate) return ManipulatorKind::Rotate;
  return handles == MeshHandles::Scale ? ManipulatorKind::Scale : ManipulatorKind::None;
}

MeshTool::MeshTool(Session& session, Workspace* workspace, MeshToolOptions options)
    : session_(session),
      options_(options),
      log_{[this] { give_up(); }, {}, {}},
      editable_(session, workspace),
      selector_(editable_, log_,
                [this](bool changes) {
                  arm_loop_cut(false);
                  if (!changes) return;
                  preview_ = {};
                  clicks_ = {};
                }),
      editor_(editable_, selector_, log_),
      drag_(session) {}

MeshTool::~MeshTool() = default;

void MeshTool::set_node(NodeId node) {
  if (node == editable_.node()) return;
  give_up();
  leave();
  clicks_.last.reset();
  editable_.set_node(node);
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
  const MeshPreview before = std::exchange(preview_, {});
  PreparedMesh* ready = editable_.prepared_if_ready();
  if (const auto now = loop_cut_armed_ ? std::nullopt : manipulator())
    preview_.hovered_handle = handle_at(*now, frame, pixel);
  const bool picks = loop_cut_armed_ || selector_.mode() != MeshMode::Object;
  if (ready != nullptr && picks && preview_.hovered_handle == ManipulatorHandle::None) {
    const ComponentKind wanted = loop_cut_armed_ ? ComponentKind::Edge : selector_.kind();
    preview_.hovered = ready->picker.at(frame, pixel, wanted, options_.pick);
    if (preview_.hovered && wanted == ComponentKind::Edge) {
      const auto& [edge, place, distance, at] = *preview_.hovered;
      const double sharpness = editable_.edge_sharpness()[edge];
      if (sharpness > 0) preview_.hovered_sharpness = sharpness;
      if (loop_cut_armed_) preview_.cut = loop_cut_preview(*ready->mesh, *ready->topology, edge, at);
    }
  }
  return before.hovered_handle != preview_.hovered_handle || !same_hover(before.hovered, preview_.hovered);
}

bool MeshTool::leave() {
  if (active()) return false;
  const bool had = preview_.hovered || preview_.hovered_handle != ManipulatorHandle::None;
  preview_ = {};
  return had;
}

// ---- The manipulator

std::optional<Manipulator> MeshTool::manipulator() {
  const ManipulatorKind kind = manipulator_kind(handles_);
  if (kind == ManipulatorKind::None || selector_.mode() == MeshMode::Object) return std::nullopt;
  if (active() && gesture_->handle) return gesture_->handle->moved();
  if (!editable_.ready() || selector_.selected_vertices().empty()) return std::nullopt;
  Manipulator now;
  now.kind = kind;
  now.pivot = selector_.middle();
  now.pixels = options_.manipulator_pixels;
  return now;
}

ManipulatorPicture manipulator_picture(MeshTool& tool, const ViewFrame& frame) {
  const auto now = tool.loop_cut_armed() ? std::nullopt : tool.manipulator();
  const MeshPreview& preview = tool.preview();
  return now ? picture(*now, frame, preview.hovered_handle, preview.active_handle) : ManipulatorPicture{};
}

// ---- Gestures

Verdict MeshTool::handle(const MeshEvent& event) {
  const bool is_finite = event.pixel.allFinite();
  const bool begins = event.kind == PenStep::Kind::Begin;
  if (event.kind == PenStep::Kind::Cancel || (begins && !is_finite)) return give_up();
  if (begins) {
    give_up();
    begin(event);
    return Verdict::Continue;
  }
  if (!active()) return Verdict::Continue;
  if (drag_.interrupted()) return give_up();
  MeshGesture& now = *gesture_;
  if (is_finite && event.pixel != now.last) {
    now.last = event.pixel;
    const bool is_far = (now.last - now.start.pixel).norm() > options_.drag_pixels;
    if (now.kind == MeshGesture::Kind::Press && !loop_cut_armed_ && is_far) {
      now.kind = now.may_sharpen ? MeshGesture::Kind::Sharpen : MeshGesture::Kind::Box;
      preview_.hovered.reset();
    }
    if (now.kind == MeshGesture::Kind::Box) preview_.box = PickBox::spanned(now.start.pixel, now.last);
    if (now.kind == MeshGesture::Kind::Handle || now.kind == MeshGesture::Kind::Sharpen) drag();
  }
  return event.kind == PenStep::Kind::End ? finish() : Verdict::Continue;
}

void MeshTool::begin(const MeshEvent& event) {
  PreparedMesh* ready = editable_.prepared();
  if (ready == nullptr) return;
  log_.notes.clear();
  const auto handles = loop_cut_armed_ ? std::nullopt : manipulator();
  const ManipulatorHandle hit = handles ? handle_at(*handles, event.frame, event.pixel) : ManipulatorHandle::None;
  const bool holds = hit != ManipulatorHandle::None;
  if (!holds && !loop_cut_armed_ && selector_.mode() == MeshMode::Object) return;
  gesture_ = std::make_unique<MeshGesture>();
  gesture_->start = event;
  gesture_->last = event.pixel;
  if (holds) {
    gesture_->kind = MeshGesture::Kind::Handle;
    gesture_->handle.emplace(*handles, hit, event.pixel);
    preview_.active_handle = hit;
  }
  const bool sharpens = handles_ == MeshHandles::Sharpen && selector_.mode() == MeshMode::Edge;
  if (!sharpens || loop_cut_armed_ || selector_.selected().empty()) return;
  const auto under = ready->picker.at(event.frame, event.pixel, ComponentKind::Edge, options_.pick);
  gesture_->may_sharpen =
      event.modifiers.shift || (under && std::ranges::binary_search(selector_.selected(), under->element));
}

void MeshTool::drag() {
  MeshGesture& now = *gesture_;
  if (now.handle) {
    const ManipulatorSnap snap = now.start.modifiers.ctrl ? options_.snap : ManipulatorSnap{};
    preview_.motion = now.handle->to(now.start.frame, now.last, snap);
  } else {
    const double levels = (now.last.x() - now.start.pixel.x()) / options_.pixels_per_level;
    preview_.sharpness_change = std::round(levels / sharpness_step) * sharpness_step;
  }
  if (!drag_.begun()) {
    now.original = editable_.mesh();
    now.begun = {session_.document(), editable_.node()};
    now.dragged = now.handle ? selector_.selected_vertices() : selector_.selected();
    constexpr std::array verbs{"Select", "Move", "Rotate", "Scale", "Sharpen"};  // in the order of MeshHandles
    const char* verb = verbs[static_cast<std::size_t>(handles_)];
    drag_.begin(selector_.counted(verb, selector_.kind(), selector_.selected().size()));
  }
  drag_to(drag_, editable_, edited_by(now, *this, preview_.sharpness_change.value_or(0)));
}

Verdict MeshTool::finish() {
  const std::unique_ptr<const MeshGesture> gesture = std::exchange(gesture_, nullptr);
  const MeshPreview preview = std::exchange(preview_, {});
  if (gesture->original) {
    const std::string node = editable_.node_name();
    log_.done = recorded::Tag{node, "selected", 0, std::nullopt, preview.sharpness_change};
    if (gesture->handle) log_.done = step_of(handles_, *gesture->handle, node);
    drag_.end();
    return log_.done ? Verdict::Commit : Verdict::Revert;
  }
  if (gesture->handle) return Verdict::Continue;
  PreparedMesh* ready = editable_.prepared();
  if (ready == nullptr) return Verdict::Revert;
  const MeshEvent& start = gesture->start;
  if (gesture->kind == MeshGesture::Kind::Box) {
    const PickBox box = PickBox::spanned(start.pixel, gesture->last);
    const ComponentKind kind = selector_.kind();
    return selector_.pick(kind, ready->picker.in_box(start.frame, box, kind, options_.pick.through),
                          how_of(start.modifiers));
  }
  if (!loop_cut_armed_) return click(*this, start, options_, clicks_);
  const auto under = ready->picker.at(start.frame, gesture->last, ComponentKind::Edge, options_.pick);
  if (!under) return Verdict::Revert;
  loop_cut_armed_ = false;
  return take(recorded::LoopCut{.edge = under->element, .at = under->parameter});
}

Verdict MeshTool::give_up() {
  if (!active()) return Verdict::Continue;
  const bool goes_back = drag_.begun() && !drag_.interrupted();
  const NodeId before = gesture_->begun.node;
  gesture_.reset();
  preview_ = {};
  if (goes_back) editable_.go_on_with(before);
  drag_.cancel();
  return Verdict::Revert;
}

}  // namespace croquis

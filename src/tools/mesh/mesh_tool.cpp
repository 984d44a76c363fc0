// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/tools/mesh/mesh_tool.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "tools/mesh/mesh_tool_cache.h"

namespace croquis {
namespace {

constexpr std::size_t most_faces_at_once = 50'000;  // their neighbourhoods take about 10 ms
constexpr double sharpness_step = 0.1;              // levels: a pointer isn't more exact

bool same_connectivity(const PolyMesh& a, const PolyMesh& b) {
  return a.vertex_count() == b.vertex_count() && a.face_offsets == b.face_offsets && a.corners == b.corners;
}

bool is_manipulating(MeshHandles handles) {
  return handles == MeshHandles::Move || handles == MeshHandles::Rotate || handles == MeshHandles::Scale;
}

ManipulatorKind manipulator_kind(MeshHandles handles) {
  if (handles == MeshHandles::Move) return ManipulatorKind::Move;
  return handles == MeshHandles::Rotate ? ManipulatorKind::Rotate : ManipulatorKind::Scale;
}

MeshTool::How how_of(const Modifiers& modifiers) {
  if (modifiers.shift) return modifiers.ctrl ? MeshTool::How::Add : MeshTool::How::Toggle;
  return modifiers.ctrl ? MeshTool::How::Remove : MeshTool::How::Replace;
}

bool same_hover(const std::optional<PickedElement>& a, const std::optional<PickedElement>& b) {
  return a.has_value() == b.has_value() && (!a || (a->element == b->element && a->parameter == b->parameter));
}

}  // namespace

MeshTool::MeshTool(Session& session, MeshToolOptions options) : session_(session), options_(options) {}
MeshTool::~MeshTool() = default;

// ---- What it works on

void MeshTool::set_node(NodeId node) {
  if (node == node_) return;
  give_up();
  leave();
  node_ = node;
  coming_ = {};
  cache_.reset();
  kept_ = {};
  last_click_.reset();
  anchor_ = anchor_before_ = no_index;
  at_hand();
}

std::shared_ptr<const PolyMesh> MeshTool::mesh() const { return source_mesh(session_.document(), node_); }

MeshTool::Cache* MeshTool::fresh() {
  auto now = mesh();
  if (coming_.valid()) cache_ = coming_.get();
  if (!now) {
    cache_.reset();
  } else if (cache_ && cache_->mesh == now) {
    // As it was.
  } else if (cache_ && same_connectivity(*cache_->mesh, *now)) {
    cache_->mesh = now;
    cache_->picker.move_to(std::move(now));
  } else {
    cache_ = std::make_unique<Cache>(std::move(now));
    kept_ = {};
    anchor_ = anchor_before_ = no_index;
  }
  return cache_.get();
}

MeshTool::Cache* MeshTool::at_hand() {
  const auto now = mesh();
  const bool small = !now || now->face_count() < most_faces_at_once;
  if (small || (cache_ && (cache_->mesh == now || same_connectivity(*cache_->mesh, *now)))) return fresh();
  if (!coming_.valid()) {
    cache_.reset();
    kept_ = {};
    coming_ = std::async(std::launch::async, [now] {
      auto cache = std::make_unique<Cache>(now);
      cache->picker.prepare();
      return cache;
    });
  }
  if (coming_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return nullptr;
  cache_ = coming_.get();
  // The mesh may have changed meanwhile.
  return cache_->mesh == now || same_connectivity(*cache_->mesh, *now) ? fresh() : nullptr;
}

std::shared_ptr<const MeshTopology> MeshTool::topology() {
  const Cache* cache = fresh();
  return cache == nullptr ? nullptr : cache->topology;
}

MeshPicker* MeshTool::picker() {
  Cache* cache = fresh();
  return cache == nullptr ? nullptr : &cache->picker;
}

const std::vector<double>& MeshTool::edge_sharpness() {
  static const std::vector<double> none;
  Cache* cache = fresh();
  if (cache == nullptr) return none;
  if (cache->sharpness_of != cache->mesh->tags) {
    cache->sharpness = croquis::edge_sharpness(cache->mesh->tags, *cache->topology);
    cache->sharpness_of = cache->mesh->tags;
  }
  return cache->sharpness;
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
  Cache* cache = at_hand();
  if (const auto now = loop_cut_armed_ ? std::nullopt : manipulator())
    preview_.hovered_handle = handle_at(*now, frame, pixel);
  const bool picks = loop_cut_armed_ || mode_ != MeshMode::Object;
  if (cache != nullptr && picks && preview_.hovered_handle == ManipulatorHandle::None) {
    const ComponentKind wanted = loop_cut_armed_ ? ComponentKind::Edge : kind();
    preview_.hovered = cache->picker.at(frame, pixel, wanted, options_.pick);
    if (preview_.hovered && wanted == ComponentKind::Edge) {
      const double sharpness = edge_sharpness()[preview_.hovered->element];
      if (sharpness > 0) preview_.hovered_sharpness = sharpness;
    }
    if (preview_.hovered && loop_cut_armed_) {
      preview_.cut =
          loop_cut_preview(*cache->mesh, *cache->topology, preview_.hovered->element, preview_.hovered->parameter);
    }
  }
  return handle_before != preview_.hovered_handle || !same_hover(hovered_before, preview_.hovered);
}

bool MeshTool::leave() {
  if (active()) return false;
  const bool had = preview_.hovered || preview_.hovered_handle != ManipulatorHandle::None;
  preview_ = {};
  return had;
}

// ---- The manipulator

std::optional<Manipulator> MeshTool::manipulator() {
  if (!is_manipulating(handles_)) return std::nullopt;
  if (gesture_ == Gesture::Handle && drag_) return drag_->moved();
  if (at_hand() == nullptr || selected_vertices().empty()) return std::nullopt;
  Manipulator now;
  now.kind = manipulator_kind(handles_);
  now.pivot = middle();
  now.pixels = options_.manipulator_pixels;
  return now;
}

ManipulatorPicture MeshTool::manipulator_picture(const ViewFrame& frame) {
  const auto now = loop_cut_armed_ ? std::nullopt : manipulator();
  return now ? picture(*now, frame, preview_.hovered_handle, preview_.active_handle) : ManipulatorPicture{};
}

Vec3 MeshTool::middle() {
  const PolyMesh& now = *fresh()->mesh;
  const Elements& vertices = selected_vertices();
  if (vertices.empty()) return Vec3::Zero();
  Vec3 low = now.positions[vertices.front()];
  Vec3 high = low;
  for (const Index vertex : vertices) {
    low = low.cwiseMin(now.positions[vertex]);
    high = high.cwiseMax(now.positions[vertex]);
  }
  return (low + high) / 2;
}

// ---- Gestures

Verdict MeshTool::handle(const MeshEvent& event) {
  if (event.kind == PenStep::Kind::Cancel) return give_up();
  if (event.kind == PenStep::Kind::Begin) return event.pixel.allFinite() ? begin(event) : give_up();
  if (gesture_ == Gesture::None) return Verdict::Continue;
  if (interrupted()) {
    end_gesture();
    return Verdict::Revert;
  }
  if (event.pixel.allFinite() && event.pixel != last_) go_on(event);
  return event.kind == PenStep::Kind::End ? finish(event) : Verdict::Continue;
}

Verdict MeshTool::begin(const MeshEvent& event) {
  give_up();
  if (fresh() == nullptr) return Verdict::Continue;
  start_ = event;
  last_ = event.pixel;
  press(event);
  return Verdict::Continue;
}

void MeshTool::press(const MeshEvent& event) {
  notes_.clear();
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
  if (mode_ == MeshMode::Object) return;
  gesture_ = Gesture::Press;
  if (handles_ != MeshHandles::Sharpen || mode_ != MeshMode::Edge || selected().empty()) return;
  const auto under = cache_->picker.at(event.frame, event.pixel, ComponentKind::Edge, options_.pick);
  may_sharpen_ =
      event.modifiers.shift || (under && std::binary_search(selected().begin(), selected().end(), under->element));
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
  const bool dragging = dragging_ && !interrupted();
  end_gesture();
  if (dragging) session_.cancel_drag();
  return Verdict::Revert;
}

void MeshTool::end_gesture() {
  gesture_ = Gesture::None;
  preview_ = {};
  drag_.reset();
  original_.reset();
  dragged_.clear();
  dragging_ = false;
}

/// Something else changed the session while a drag was under way, which ended it.
bool MeshTool::interrupted() const { return dragging_ && session_.revision() != drag_revision_; }

// ---- Drags

void MeshTool::start_drag() {
  original_ = mesh();
  const bool sharpens = gesture_ == Gesture::Sharpen;
  dragged_ = sharpens ? selected() : selected_vertices();
  const std::string verb = sharpens                          ? "Sharpen"
                           : handles_ == MeshHandles::Move   ? "Move"
                           : handles_ == MeshHandles::Rotate ? "Rotate"
                                                             : "Scale";
  session_.begin_drag(counted(verb, kind(), selected().size()));
  dragging_ = true;
  drag_revision_ = session_.revision();
}

void MeshTool::drag_handle(const Vec2& pixel) {
  const ManipulatorMotion& motion =
      drag_->to(start_.frame, pixel, start_.modifiers.ctrl ? options_.snap : ManipulatorSnap{});
  if (!dragging_) start_drag();
  preview_.motion = motion;
  PolyMesh moved = transformed(*original_, dragged_, motion.map);
  drag_revision_ = session_.revision() + 1;  // what listeners see while they are notified
  session_.drag(with_mesh(std::move(moved)));
  drag_revision_ = session_.revision();
}

void MeshTool::drag_sharpness(const Vec2& pixel) {
  if (!dragging_) start_drag();
  const double levels = (pixel.x() - start_.pixel.x()) / options_.pixels_per_level;
  preview_.sharpness_change = std::round(levels / sharpness_step) * sharpness_step;
  PolyMesh sharpened = *original_;
  sharpened.tags = with_sharpness_changed(original_->tags, *cache_->topology, dragged_, *preview_.sharpness_change);
  drag_revision_ = session_.revision() + 1;
  session_.drag(with_mesh(std::move(sharpened)));
  drag_revision_ = session_.revision();
}

std::optional<recorded::Step> MeshTool::recorded_motion(const ManipulatorMotion& motion, const Vec3& pivot) const {
  if (handles_ == MeshHandles::Move) return recorded::Move{node_name(), motion.by};
  if (handles_ == MeshHandles::Scale) return recorded::Scale{node_name(), motion.factors, pivot};
  if (motion.axis.isZero(0)) return std::nullopt;
  return recorded::Rotate{node_name(), motion.axis, motion.degrees, pivot};
}

Verdict MeshTool::finish_handle() {
  const bool dragged = dragging_;
  const ManipulatorMotion motion = drag_->motion();
  // The drag turns and scales about where it began.
  const Vec3 pivot = drag_->moved().pivot - motion.by;
  end_gesture();
  if (!dragged) return Verdict::Continue;
  done_ = recorded_motion(motion, pivot);
  session_.end_drag();
  return done_ ? Verdict::Commit : Verdict::Revert;
}

Verdict MeshTool::finish_sharpness() {
  const double change = preview_.sharpness_change.value_or(0);
  end_gesture();
  done_ = recorded::Tag{node_name(), "selected", 0, std::nullopt, change};
  session_.end_drag();
  return Verdict::Commit;
}

Verdict MeshTool::finish_box() {
  const PickBox box = PickBox::spanned(start_.pixel, last_);
  const Modifiers modifiers = start_.modifiers;
  const ViewFrame frame = start_.frame;
  end_gesture();
  Cache* cache = fresh();
  if (cache == nullptr) return Verdict::Revert;
  return pick(kind(), cache->picker.in_box(frame, box, kind(), options_.pick.through), how_of(modifiers));
}

Verdict MeshTool::cut_hovered(const MeshEvent& event) {
  end_gesture();
  Cache* cache = fresh();
  if (cache == nullptr) return Verdict::Revert;
  const auto under = cache->picker.at(start_.frame, event.pixel, ComponentKind::Edge, options_.pick);
  if (!under) return Verdict::Revert;
  loop_cut_armed_ = false;
  return cut_loop(under->element, under->parameter);
}

// ---- Clicks

Verdict MeshTool::click() {
  const MeshEvent at = start_;
  end_gesture();
  const bool again = last_click_ && at.time - last_click_->time <= options_.double_click_seconds &&
                     (at.pixel - last_click_->pixel).norm() <= options_.drag_pixels;
  last_click_ = again ? std::nullopt : std::optional(at);
  Cache* cache = fresh();
  if (cache == nullptr) return Verdict::Revert;
  const auto under = cache->picker.at(at.frame, at.pixel, kind(), options_.pick);
  const How how = how_of(at.modifiers);
  if (!under) return how == How::Replace ? select_none() : Verdict::Continue;
  if (again) return click_again(under->element);
  anchor_before_ = std::exchange(anchor_, under->element);
  return pick(kind(), {under->element}, how);
}

Verdict MeshTool::click_again(Index element) {
  const How whole = kind() == ComponentKind::Edge ? How::Loop : How::Connected;
  if (start_.modifiers.ctrl && !start_.modifiers.shift)
    return pick(kind(), expanded(kind(), element, whole), How::Remove);
  const bool goes_on =
      start_.modifiers.shift && anchor_before_ < element_count(*cache_->topology, kind()) && anchor_before_ != element;
  if (goes_on && !path(kind(), anchor_before_, element).empty())
    return pick(kind(), {anchor_before_, element}, How::Path);
  return pick(kind(), {element}, whole);
}

}  // namespace croquis

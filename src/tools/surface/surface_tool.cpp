// SPDX-License-Identifier: GPL-3.0-or-later
// What gestures do. How strokes become curves stands in surface_drawing.cpp, what drags do in surface_drags.cpp, the
// commands in surface_commands.cpp.
#include "croquis/tools/surface/surface_tool.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "tools/surface/surface_words.h"

namespace croquis {
namespace {

bool is_finite(const SurfaceEvent& event) { return event.pointer.pixel.allFinite(); }

/// Adds elements that aren't there, takes away those that are.
void toggle(NetworkElements& elements, NetworkElement kind, const std::string& id) {
  if (std::erase(elements.of(kind), id) == 0) elements.of(kind).push_back(id);
}

}  // namespace

SurfaceTool::SurfaceTool(Session& session, SurfaceToolOptions options)
    : session_(session), options_(std::move(options)), drag_(session) {}

void SurfaceTool::set_mode(SurfaceMode mode) {
  give_up();
  leave();
  mode_ = mode;
}

void SurfaceTool::set_chosen_plane(const SpacePlane& plane) {
  chosen_ = plane;
  plane_ = SurfacePlane::Chosen;
}

// ---- Hovering

bool SurfaceTool::hover(const Vec2& pixel, const ViewFrame& frame) {
  if (active() || !pixel.allFinite()) return false;
  const SurfacePreview before = std::exchange(preview_, {});
  if (mode_ == SurfaceMode::Draw) {
    preview_.snap = snap_at(frame, pixel);
  } else if (mode_ == SurfaceMode::Patch) {
    preview_.loop = loop_at(frame, pixel);
  } else {
    preview_.hovered = pick(frame, pixel);
  }
  if (!preview_.snap && !preview_.hovered && mode_ != SurfaceMode::Patch) preview_.hit = hit_at(frame, pixel);
  const auto snap_place = [](const SurfacePreview& one) {
    return one.snap ? std::optional(one.snap->place) : std::nullopt;
  };
  const auto loop_sides = [](const SurfacePreview& one) {
    return one.loop ? one.loop->loop.sides : std::vector<AttributeSide>();
  };
  const auto hit_point = [](const SurfacePreview& one) {
    return one.hit ? std::optional(one.hit->point) : std::nullopt;
  };
  return snap_place(before) != snap_place(preview_) || before.hovered != preview_.hovered ||
         loop_sides(before) != loop_sides(preview_) || hit_point(before) != hit_point(preview_);
}

bool SurfaceTool::leave() {
  if (active()) return false;
  const bool had = preview_.snap || preview_.hovered || preview_.hit || preview_.loop;
  preview_ = {};
  return had;
}

std::optional<SurfaceHit> SurfaceTool::hit_at(const ViewFrame& frame, const Vec2& pixel) const {
  return sight_ ? sight_->patch_under(frame.ray(pixel)) : std::nullopt;
}

std::optional<LoopAround> SurfaceTool::loop_at(const ViewFrame& frame, const Vec2& pixel) const {
  const auto now = network();
  if (!now) return std::nullopt;
  return find_loop_around(*now, viewed_curves(*now, frame), pixel, {tolerance_of(*now), 12});
}

std::optional<PickedPlace> SurfaceTool::pick(const ViewFrame& frame, const Vec2& pixel) const {
  const auto now = network();
  if (!now) return std::nullopt;
  const double reach = options_.pick_pixels;
  if (auto point = nearest_point_attribute(*now, frame, pixel, reach)) return point;
  if (mode_ == SurfaceMode::Point) return std::nullopt;
  if (auto handle = nearest_handle(*now, selected().curves, frame, pixel, reach)) return handle;
  if (auto node = nearest_node(*now, frame, pixel, reach)) return node;
  return nearest_curve(*now, frame, pixel, reach);
}

// ---- Events

Verdict SurfaceTool::handle(const SurfaceEvent& event) {
  if (event.pointer.kind == PenStep::Kind::Cancel) return give_up();
  if (event.pointer.kind == PenStep::Kind::Begin) return is_finite(event) ? begin(event) : give_up();
  if (gesture_ == Gesture::None) return Verdict::Continue;
  if (drag_.interrupted()) return give_up();
  if (is_finite(event)) go_on(event);
  return event.pointer.kind == PenStep::Kind::End ? finish() : Verdict::Continue;
}

Verdict SurfaceTool::begin(const SurfaceEvent& event) {
  give_up();
  notes_.clear();
  preview_ = {};
  start_ = event;
  last_ = event.pointer.pixel;
  if (mode_ == SurfaceMode::Draw) {
    gesture_ = Gesture::Draw;
    from_ = snap_at(event.pointer.frame, last_);
    add_sample(last_);
    preview_stroke();
  } else {
    press();
  }
  return Verdict::Continue;
}

void SurfaceTool::go_on(const SurfaceEvent& event) {
  const bool moved = event.pointer.pixel != last_;
  last_ = event.pointer.pixel;
  if (gesture_ == Gesture::Draw) {
    if (moved) add_sample(last_);
    preview_stroke();
    return;
  }
  if (gesture_ == Gesture::Press && (last_ - start_.pointer.pixel).norm() > options_.drag_pixels) start_drag();
  if (gesture_ == Gesture::Box) preview_.box = PickBox::spanned(start_.pointer.pixel, last_);
  if (drag_.begun()) drag_to();
}

Verdict SurfaceTool::finish() {
  switch (gesture_) {
    case Gesture::None: return Verdict::Continue;
    case Gesture::Draw: return finish_stroke();
    case Gesture::Press: return finish_click();
    case Gesture::Box: return finish_box();
    default: return finish_drag();
  }
}

Verdict SurfaceTool::give_up() {
  if (gesture_ == Gesture::None) return Verdict::Continue;
  end_gesture();
  drag_.cancel();
  return Verdict::Revert;
}

void SurfaceTool::end_gesture() {
  gesture_ = Gesture::None;
  preview_ = {};
  samples_.clear();
  from_.reset();
  original_.reset();
  partners_.reset();
}

// ---- Selecting

void SurfaceTool::press() {
  gesture_ = Gesture::Press;
  const ViewFrame& frame = start_.pointer.frame;
  picked_.reset();
  tip_.reset();
  hit_.reset();
  on_ring_ = false;
  if (mode_ == SurfaceMode::Patch) return;
  picked_ = pick(frame, last_);
  const bool is_handle = picked_ && (picked_->control || picked_->kind == NetworkElement::Point);
  if (!is_handle && mode_ == SurfaceMode::Select) tip_ = slope_at(frame, last_);
  on_ring_ = !is_handle && !tip_ && ring_at(frame, last_);
  if (!picked_ && !tip_ && !on_ring_) hit_ = hit_at(frame, last_);
}

Verdict SurfaceTool::finish_click() {
  const bool pulls = mode_ == SurfaceMode::Point && hit_ && !picked_;
  if (mode_ == SurfaceMode::Patch) return click_in_loop();
  if (pulls) {
    const NewPoint point{hit_->face, hit_->point, hit_->fan, {}, {}};
    end_gesture();
    return put_point(point);
  }
  NetworkElements elements = start_.pointer.modifiers.shift ? selected() : NetworkElements();
  if (picked_ && !picked_->control) {
    toggle(elements, picked_->kind, picked_->id);
  } else if (picked_ || tip_ || on_ring_) {
    elements = selected();  // a handle was only touched
  } else if (hit_) {
    toggle(elements, NetworkElement::Face, hit_->face);
  }
  end_gesture();
  return choose(elements);
}

Verdict SurfaceTool::finish_box() {
  const PickBox box = PickBox::spanned(start_.pointer.pixel, last_);
  NetworkElements elements = start_.pointer.modifiers.shift ? selected() : NetworkElements();
  const ViewFrame frame = start_.pointer.frame;
  end_gesture();
  const auto now = network();
  const NetworkElements found = now ? elements_in_box(*now, frame, box) : NetworkElements();
  for (const NetworkElement kind : {NetworkElement::Node, NetworkElement::Curve, NetworkElement::Point}) {
    for (const std::string& id : found.of(kind)) {
      if (!elements.has(kind, id)) elements.of(kind).push_back(id);
    }
  }
  return choose(elements);
}

Verdict SurfaceTool::click_in_loop() {
  const auto around = loop_at(start_.pointer.frame, start_.pointer.pixel);
  const auto now = network();
  end_gesture();
  if (!around) {
    notes_ = {make_warning(Category::Geometry, "E_OPEN_LOOP",
                           "No closed loop of 2 to 12 curves goes around this place: close the gaps, or select the "
                           "curves of the loop.")};
    return Verdict::Revert;
  }
  if (around->face) return choose(one_element(NetworkElement::Face, now->faces[*around->face].id));
  std::vector<std::string> curves;
  for (const AttributeSide& side : around->loop.sides) curves.push_back(now->curves[side.curve].id);
  return fill_loop(curves);
}

}  // namespace croquis

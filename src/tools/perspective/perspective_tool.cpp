// SPDX-License-Identifier: GPL-3.0-or-later
// What gestures do. The commands stand in perspective_commands.cpp.
#include "croquis/tools/perspective/perspective_tool.h"

#include <algorithm>
#include <utility>

#include "croquis/tools/perspective/axis_guess.h"
#include "croquis/tools/perspective/pen_strokes.h"
#include "croquis/tools/perspective/perspective_steps.h"
#include "croquis/tools/strokes/stroke_source.h"
#include "tools/perspective/perspective_labels.h"

namespace croquis {
namespace {

Vec2 sheet_place(const Vec2& sketch) { return {sketch.x(), -sketch.y()}; }

bool has_id(const std::vector<std::string>& ids, const std::string& id) {
  return std::ranges::find(ids, id) != ids.end();
}

}  // namespace

PerspectiveTool::PerspectiveTool(Session& session, PerspectiveToolOptions options)
    : session_(session), options_(std::move(options)), drag_(session) {}

void PerspectiveTool::set_mode(PerspectiveMode mode) {
  give_up();
  mode_ = mode;
}

void PerspectiveTool::set_group(std::optional<StrokeGroup> group) {
  group_ = group;
  if (group && !is_parallel(*group)) last_plane_ = *group;
  if (gesture_ == Gesture::Draw) preview_stroke();
}

Verdict PerspectiveTool::handle(const SketchEvent& event) {
  const bool finite = event.sample.position.allFinite() && event.units_per_pixel > 0;
  if (event.kind == PenStep::Kind::Cancel) return give_up();
  if (event.kind == PenStep::Kind::Begin) return finite ? begin(event) : give_up();
  if (gesture_ == Gesture::None) return Verdict::Continue;
  if (drag_.interrupted()) return give_up();
  if (event.kind == PenStep::Kind::End) return finish();
  if (finite) go_on(event);
  return Verdict::Continue;
}

Verdict PerspectiveTool::begin(const SketchEvent& event) {
  give_up();
  start_ = event;
  from_ = last_ = sheet_place(event.sample.position);
  path_ = {from_};
  if (event.erases || mode_ == PerspectiveMode::Erase) {
    gesture_ = Gesture::Erase;
  } else if (mode_ == PerspectiveMode::Draw) {
    gesture_ = Gesture::Draw;
    preview_.ink = {event.sample};
  } else {
    press();
  }
  return Verdict::Continue;
}

void PerspectiveTool::go_on(const SketchEvent& event) {
  const Vec2 before = std::exchange(last_, sheet_place(event.sample.position));
  if (gesture_ == Gesture::Draw) {
    path_.push_back(last_);
    preview_.ink.push_back(event.sample);
    preview_stroke();
  }
  if (gesture_ == Gesture::Erase) {
    path_.push_back(last_);
    const auto now = drawing();
    const double radius = options_.eraser_pixels * start_.units_per_pixel;
    for (std::string& id : now ? strokes_touched(*now, before, last_, radius) : std::vector<std::string>()) {
      if (!has_id(preview_.erased, id)) preview_.erased.push_back(std::move(id));
    }
  }
  const double moved = (last_ - from_).norm();
  if (gesture_ == Gesture::Press && moved > options_.drag_pixels * start_.units_per_pixel) start_drag();
  if (gesture_ == Gesture::Box) preview_.box = PickBox::spanned(from_, last_);
  if (gesture_ == Gesture::Point || gesture_ == Gesture::Strokes || gesture_ == Gesture::Aim) drag_to();
}

Verdict PerspectiveTool::finish() {
  switch (gesture_) {
    case Gesture::Draw: {
      const std::vector<Vec2> path = std::move(path_);
      end_gesture();
      return draw(path, start_.units_per_pixel, group_, role_);
    }
    case Gesture::Erase: {
      const std::vector<Vec2> path = std::move(path_);
      end_gesture();
      return erase(path, start_.units_per_pixel);
    }
    case Gesture::Press: return finish_click();
    case Gesture::Box: return finish_box();
    case Gesture::Point:
    case Gesture::Strokes:
    case Gesture::Aim: return finish_drag();
    case Gesture::None: break;
  }
  return Verdict::Continue;
}

Verdict PerspectiveTool::give_up() {
  if (gesture_ == Gesture::None) return Verdict::Continue;
  end_gesture();
  drag_.cancel();
  return Verdict::Revert;
}

void PerspectiveTool::end_gesture() {
  gesture_ = Gesture::None;
  preview_ = {};
  path_.clear();
  original_.reset();
}

/// The group that the stroke under way will have, and the vertex that it would end at.
void PerspectiveTool::preview_stroke() {
  const PerspectiveDrawing now = drawing_or_empty();
  preview_.snap.reset();
  if (role_ == StrokeRole::Edge) {
    const auto end = nearest_end(now, last_, options_.snap_pixels * start_.units_per_pixel);
    if (end) preview_.snap = place_of(now, *end);
  }
  const auto axis = group_ ? group_ : guess_axis(now, solved_.get(), from_, last_);
  preview_.group = axis.value_or(last_plane_);
}

// ---- Selecting and dragging

std::optional<PickedPoint> PerspectiveTool::point_at(const Vec2& place, double units_per_pixel) const {
  const auto now = drawing();
  if (!now) return std::nullopt;
  return nearest_point(*now, selected(), place, options_.pick_pixels * units_per_pixel);
}

std::optional<int> PerspectiveTool::vanishing_point_at(const Vec2& place, double units_per_pixel) const {
  const auto now = drawing();
  if (!now) return std::nullopt;
  const auto points = seen_vanishing_points(*now, solved_.get());
  for (int axis = 0; axis < 3; ++axis) {
    const auto& point = points[static_cast<std::size_t>(axis)];
    if (!point || point->z() == 0) continue;
    if ((point->head<2>() / point->z() - place).norm() <= options_.pick_pixels * units_per_pixel) return axis;
  }
  return std::nullopt;
}

void PerspectiveTool::press() {
  gesture_ = Gesture::Press;
  const double unit = start_.units_per_pixel;
  const auto now = drawing();
  point_ = point_at(from_, unit);
  axis_ = point_ ? std::nullopt : vanishing_point_at(from_, unit);
  picked_ = now ? nearest_stroke(*now, from_, options_.pick_pixels * unit) : std::nullopt;
}

void PerspectiveTool::start_drag() {
  if (!point_ && !axis_ && !picked_) {
    gesture_ = Gesture::Box;
    return;
  }
  gesture_ = point_ ? Gesture::Point : axis_ ? Gesture::Aim : Gesture::Strokes;
  if (gesture_ == Gesture::Strokes && !has_id(selected(), *picked_)) {
    std::vector<std::string> ids = start_.modifiers.shift ? selected() : std::vector<std::string>{};
    ids.push_back(*picked_);
    select(ids);
  }
  original_ = drawing();
  drag_.begin(gesture_ == Gesture::Aim     ? "Drag a vanishing point"
              : gesture_ == Gesture::Point ? "Drag a point of " + stroke_name(point_->stroke)
                                           : named_label("Move", selected()));
}

/// How far the pointer has gone; of an end that comes near another vertex, the way to that.
Vec2 PerspectiveTool::snapped_way() const {
  const Vec2 way = last_ - from_;
  const PerspectiveStroke* stroke = point_ ? find_stroke(*original_, point_->stroke) : nullptr;
  if (stroke == nullptr || !has_vertices(*stroke)) return way;
  const std::size_t count = points_of(*stroke).size();
  if (point_->point != 0 && point_->point + 1 != count) return way;
  const DrawnEnd end{static_cast<std::size_t>(stroke - original_->strokes.data()), point_->point != 0};
  const Vec2 place = place_of(*original_, end);
  const double reach = options_.pick_pixels * start_.units_per_pixel;
  const auto other = nearest_other_end(*original_, end, place + way, reach, start_.modifiers.ctrl);
  return other ? Vec2(place_of(*original_, *other) - place) : way;
}

PerspectiveDrawing PerspectiveTool::dragged() const {
  PerspectiveDrawing edited = *original_;
  if (gesture_ == Gesture::Aim) {
    aim_lines(edited, *axis_, last_);
  } else if (gesture_ == Gesture::Point) {
    drag_point(edited, point_->stroke, point_->point, snapped_way(), start_.modifiers.ctrl);
  } else {
    move_strokes(edited, selected(), last_ - from_);
  }
  return edited;
}

void PerspectiveTool::drag_to() { drag_.to(with_drawing(dragged())); }

Verdict PerspectiveTool::finish_drag() {
  if (gesture_ == Gesture::Aim) {
    done_ = recorded::SheetAim{*axis_, last_};
  } else if (gesture_ == Gesture::Point) {
    done_ = recorded::SheetDrag{point_->stroke, point_->point, snapped_way(), start_.modifiers.ctrl};
  } else {
    done_ = recorded::SheetDrag{*picked_, {}, last_ - from_, false};
  }
  end_gesture();
  drag_.end();
  return Verdict::Commit;
}

Verdict PerspectiveTool::finish_click() {
  const auto id = picked_;
  const bool shift = start_.modifiers.shift;
  end_gesture();
  const auto now = drawing();
  if (!id && now && solved_) {
    if (const auto face = face_at(*now, solved_->faces, from_)) {
      select(solved_->faces[*face]);
      return Verdict::Continue;
    }
  }
  std::vector<std::string> ids = shift ? selected() : std::vector<std::string>{};
  if (id && shift && has_id(ids, *id)) {
    std::erase(ids, *id);
  } else if (id) {
    ids.push_back(*id);
  }
  select(ids);
  return Verdict::Continue;
}

Verdict PerspectiveTool::finish_box() {
  const PickBox box = PickBox::spanned(from_, last_);
  std::vector<std::string> ids = start_.modifiers.shift ? selected() : std::vector<std::string>{};
  end_gesture();
  if (const auto now = drawing()) {
    for (std::string& id : strokes_in_box(*now, box)) ids.push_back(std::move(id));
  }
  select(ids);
  return Verdict::Continue;
}

std::vector<std::string> PerspectiveTool::selected() const {
  const auto now = drawing();
  return now ? selected_ids(session_, node(), now->strokes) : std::vector<std::string>();
}

void PerspectiveTool::select(const std::vector<std::string>& ids) { select_ids(session_, node(), ids); }

}  // namespace croquis

// SPDX-License-Identifier: GPL-3.0-or-later
// What gestures lead to. What steps make of a drawing stands in sheet_edit.cpp.
#include "croquis/tools/perspective/perspective_tool.h"

#include <algorithm>
#include <utility>

#include "croquis/tools/perspective/axis_guess.h"
#include "croquis/tools/perspective/perspective_steps.h"
#include "croquis/tools/strokes/stroke_source.h"
#include "tools/perspective/sheet_edit.h"

namespace croquis {

/// A gesture under way, and what lay under its beginning.
struct SheetGesture {
  enum class Kind { Draw, Erase, Press, Box, Point, Strokes, Aim };

  Kind kind = SheetGesture::Kind::Press;
  SketchEvent start;                                   ///< that began it
  Vec2 from = Vec2::Zero();                            ///< where, px of the sheet
  Vec2 last = Vec2::Zero();                            ///< where the pointer is, px of the sheet
  std::vector<Vec2> path;                              ///< Draw, Erase
  std::optional<std::string> picked;                   ///< stroke under the press
  std::optional<PickedPoint> point;                    ///< of a selected stroke, under the press
  std::optional<int> axis;                             ///< whose vanishing point is under the press
  std::shared_ptr<const PerspectiveDrawing> original;  ///< before the drag; null: nothing is dragged
  std::optional<recorded::Step> step;                  ///< what the drag does by now

  PickBox box() const { return PickBox::spanned(from, last); }
};

namespace {

Vec2 sheet_place(const Vec2& sketch) { return {sketch.x(), -sketch.y()}; }

/// The axis whose vanishing point lies there.
std::optional<int> vanishing_point_at(const PerspectiveDrawing& drawing, const SolvedDrawing* solved, const Vec2& place,
                                      double reach) {
  const auto points = seen_vanishing_points(drawing, solved);
  for (int axis = 0; axis < 3; ++axis) {
    const auto& point = points[static_cast<std::size_t>(axis)];
    if (!point || point->z() == 0) continue;
    if ((point->head<2>() / point->z() - place).norm() <= reach) return axis;
  }
  return std::nullopt;
}

/// How far the pointer has gone; of an end that comes near another vertex, the way to that.
Vec2 snapped_way(const SheetGesture& gesture, double reach) {
  const Vec2 way = gesture.last - gesture.from;
  const PickedPoint& point = *gesture.point;
  const PerspectiveStroke* stroke = find_stroke(*gesture.original, point.stroke);
  if (stroke == nullptr || !has_vertices(*stroke)) return way;
  if (point.point != 0 && point.point + 1 != points_of(*stroke).size()) return way;
  const DrawnEnd end{static_cast<std::size_t>(stroke - gesture.original->strokes.data()), point.point != 0};
  const Vec2 place = place_of(*gesture.original, end);
  const auto other = nearest_other_end(*gesture.original, end, place + way, reach, gesture.start.modifiers.ctrl);
  return other ? Vec2(place_of(*gesture.original, *other) - place) : way;
}

/// @param reach px of the sheet: a dragged end goes to a vertex within
recorded::Step dragged_step(const SheetGesture& gesture, double reach) {
  if (gesture.kind == SheetGesture::Kind::Aim) return recorded::SheetAim{*gesture.axis, gesture.last};
  if (gesture.kind == SheetGesture::Kind::Strokes)
    return recorded::SheetDrag{*gesture.picked, {}, gesture.last - gesture.from, false};
  return recorded::SheetDrag{gesture.point->stroke, gesture.point->point, snapped_way(gesture, reach),
                             gesture.start.modifiers.ctrl};
}

/// What a click or a box has selected. @param before what was: Shift adds to it, or takes away
std::vector<std::string> chosen_by(const SheetGesture& gesture, const std::vector<std::string>& before,
                                   const PerspectiveDrawing* drawing, const SolvedDrawing* solved) {
  std::vector<std::string> ids = gesture.start.modifiers.shift ? before : std::vector<std::string>();
  if (gesture.kind == SheetGesture::Kind::Box) {
    for (std::string& id : drawing ? strokes_in_box(*drawing, gesture.box()) : std::vector<std::string>())
      ids.push_back(std::move(id));
    return ids;
  }
  if (!gesture.picked && drawing && solved) {
    if (const auto face = face_at(*drawing, solved->faces, gesture.from)) return solved->faces[*face];
  }
  if (gesture.picked && std::erase(ids, *gesture.picked) == 0) ids.push_back(*gesture.picked);
  return ids;
}

PerspectiveDrawing or_empty(const std::shared_ptr<const PerspectiveDrawing>& drawing,
                            const PerspectiveToolOptions& options) {
  return drawing ? *drawing : empty_sheet(options.sheet);
}

/// @param node of the drawing; 0: it becomes a new one
Document with_drawing(const Document& document, NodeId node, PerspectiveDrawing drawing,
                      const PerspectiveToolOptions& options) {
  if (node == 0) return add_perspective_drawing(document, std::move(drawing), options);
  Node edited = *document.find(node);
  edited.source = std::make_shared<const PerspectiveDrawing>(std::move(drawing));
  return document.with(std::move(edited));
}

}  // namespace

Affine3 upright_placement() {
  Affine3 placement;
  placement.linear << 1, 0, 0, 0, 0, 1, 0, -1, 0;
  return placement;
}

Document add_perspective_drawing(const Document& document, PerspectiveDrawing drawing,
                                 const PerspectiveToolOptions& options) {
  Node operation;
  operation.transform = upright_placement();
  return with_stroke_source(document, std::make_shared<const PerspectiveDrawing>(std::move(drawing)), options,
                            std::move(operation));
}

PerspectiveDrawing empty_sheet(const Vec2& size) {
  PerspectiveDrawing drawing;
  drawing.image_size = size;
  return drawing;
}

PerspectiveTool::PerspectiveTool(Session& session, PerspectiveToolOptions options)
    : session_(session), options_(std::move(options)), drag_(session) {}

PerspectiveTool::~PerspectiveTool() = default;

void PerspectiveTool::set_mode(PerspectiveMode mode) {
  give_up();
  mode_ = mode;
}

void PerspectiveTool::set_group(std::optional<StrokeGroup> group) {
  group_ = group;
  if (group && !is_parallel(*group)) last_plane_ = *group;
  if (gesture_ && gesture_->kind == SheetGesture::Kind::Draw) preview_stroke();
}

// ---- The document

NodeId PerspectiveTool::node() const { return source_node<PerspectiveDrawing>(session_.document(), node_); }

std::shared_ptr<const PerspectiveDrawing> PerspectiveTool::drawing() const {
  return source_of<PerspectiveDrawing>(session_.document().find(node()));
}

NodeId PerspectiveTool::operation_node() const { return operation_on(session_.document(), node(), options_.port); }

SheetContext PerspectiveTool::context() const { return {solved_.get(), last_plane_, selected(), options_}; }

Verdict PerspectiveTool::take(const recorded::Step& step) {
  give_up();
  const auto* stroke = step.as<recorded::SheetStroke>();
  const Node* operation = session_.document().find(operation_node());
  if (auto edit = edited_by(operation == nullptr ? Node() : *operation, step)) {
    if (operation == nullptr) refuse_input("Nothing is made of the drawing; add the step that makes a solid of it.");
    if (!edit->changed) return Verdict::Continue;
    done_ = step;
    session_.edit(edit->label, session_.document().with(std::move(edit->operation)));
    return Verdict::Commit;
  }
  if (!drawing() && stroke == nullptr) refuse_input("There is no drawing in perspective; begin one first.");
  auto edit = edited_by(or_empty(drawing(), options_), step, context());
  if (!edit) refuse_input("This step is none of the perspective tool.");
  if (!edit->changed) return stroke == nullptr ? Verdict::Continue : Verdict::Revert;
  done_ = edit->recorded.value_or(step);
  session_.edit(edit->label, with_drawing(session_.document(), node(), std::move(edit->drawing), options_));
  return Verdict::Commit;
}

bool PerspectiveTool::is_chosen(const std::string& list, const std::string& item) const {
  return contains(items_in(session_.document().find(operation_node()), list), item);
}

std::vector<std::string> PerspectiveTool::selected() const {
  const auto now = drawing();
  return now ? selected_ids(session_, node(), now->strokes) : std::vector<std::string>();
}

void PerspectiveTool::select(const std::vector<std::string>& ids) { select_ids(session_, node(), ids); }

// ---- Gestures

Verdict PerspectiveTool::handle(const SketchEvent& event) {
  const bool finite = event.sample.position.allFinite() && event.units_per_pixel > 0;
  const bool begins = event.kind == PenStep::Kind::Begin;
  if (event.kind == PenStep::Kind::Cancel || (begins && !finite)) return give_up();
  if (begins) {
    give_up();
    begin(event);
    return Verdict::Continue;
  }
  if (!gesture_) return Verdict::Continue;
  if (drag_.interrupted()) return give_up();
  if (event.kind == PenStep::Kind::End) return finish();
  if (finite) go_on(event);
  return Verdict::Continue;
}

Verdict PerspectiveTool::give_up() {
  if (!gesture_) return Verdict::Continue;
  gesture_.reset();
  preview_ = {};
  drag_.cancel();
  return Verdict::Revert;
}

void PerspectiveTool::begin(const SketchEvent& event) {
  gesture_ = std::make_unique<SheetGesture>();
  SheetGesture& now = *gesture_;
  now.start = event;
  now.from = now.last = sheet_place(event.sample.position);
  now.path = {now.from};
  if (event.erases || mode_ == PerspectiveMode::Erase) {
    now.kind = SheetGesture::Kind::Erase;
  } else if (mode_ == PerspectiveMode::Draw) {
    now.kind = SheetGesture::Kind::Draw;
    preview_.ink = {event.sample};
  } else if (const auto drawn = drawing()) {
    const double reach = options_.pick_pixels * event.units_per_pixel;
    now.point = nearest_point(*drawn, selected(), now.from, reach);
    if (!now.point) now.axis = vanishing_point_at(*drawn, solved_.get(), now.from, reach);
    now.picked = nearest_stroke(*drawn, now.from, reach);
  }
}

void PerspectiveTool::go_on(const SketchEvent& event) {
  SheetGesture& now = *gesture_;
  const double unit = now.start.units_per_pixel;
  const Vec2 before = std::exchange(now.last, sheet_place(event.sample.position));
  if (now.kind == SheetGesture::Kind::Draw || now.kind == SheetGesture::Kind::Erase) now.path.push_back(now.last);
  if (now.kind == SheetGesture::Kind::Draw) {
    preview_.ink.push_back(event.sample);
    preview_stroke();
  }
  if (const auto drawn = now.kind == SheetGesture::Kind::Erase ? drawing() : nullptr) {
    for (std::string& id : strokes_touched(*drawn, before, now.last, options_.eraser_pixels * unit)) {
      if (!contains(preview_.erased, id)) preview_.erased.push_back(std::move(id));
    }
  }
  if (now.kind == SheetGesture::Kind::Press && (now.last - now.from).norm() > options_.drag_pixels * unit) start_drag();
  if (now.kind == SheetGesture::Kind::Box) preview_.box = now.box();
  if (!now.original) return;
  preview_.moved = now.last - now.from;
  now.step = dragged_step(now, options_.pick_pixels * unit);
  SheetEdit edit = *edited_by(*now.original, *now.step, context());
  if (!drag_.begun()) drag_.begin(edit.label);
  drag_.to(with_drawing(session_.document(), node(), std::move(edit.drawing), options_));
}

void PerspectiveTool::start_drag() {
  SheetGesture& now = *gesture_;
  now.kind = now.point    ? SheetGesture::Kind::Point
             : now.axis   ? SheetGesture::Kind::Aim
             : now.picked ? SheetGesture::Kind::Strokes
                          : SheetGesture::Kind::Box;
  if (now.kind == SheetGesture::Kind::Box) return;
  if (now.kind == SheetGesture::Kind::Strokes && !contains(selected(), *now.picked)) {
    std::vector<std::string> ids = now.start.modifiers.shift ? selected() : std::vector<std::string>{};
    ids.push_back(*now.picked);
    select(ids);
  }
  now.original = drawing();
}

/// The group that the stroke under way will have, and the vertex that it would end at.
void PerspectiveTool::preview_stroke() {
  const PerspectiveDrawing now = or_empty(drawing(), options_);
  preview_.snap.reset();
  if (role_ == StrokeRole::Edge) {
    const double reach = options_.snap_pixels * gesture_->start.units_per_pixel;
    if (const auto end = nearest_end(now, gesture_->last, reach)) preview_.snap = place_of(now, *end);
  }
  const auto axis = group_ ? group_ : guess_axis(now, solved_.get(), gesture_->from, gesture_->last);
  preview_.group = axis.value_or(last_plane_);
}

Verdict PerspectiveTool::finish() {
  const std::unique_ptr<const SheetGesture> gesture = std::exchange(gesture_, nullptr);
  preview_ = {};
  const double unit = gesture->start.units_per_pixel;
  if (gesture->kind == SheetGesture::Kind::Draw)
    return take(recorded::SheetStroke{gesture->path, group_, role_, false, unit, {}});
  if (gesture->kind == SheetGesture::Kind::Erase)
    return take(recorded::SheetStroke{gesture->path, {}, StrokeRole::Edge, true, unit, {}});
  if (gesture->original) {
    done_ = gesture->step;
    drag_.end();
    return Verdict::Commit;
  }
  const auto now = drawing();
  select(chosen_by(*gesture, selected(), now.get(), solved_.get()));
  return Verdict::Continue;
}

}  // namespace croquis

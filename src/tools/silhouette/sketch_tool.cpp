// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/tools/silhouette/sketch_tool.h"

#include <algorithm>
#include <utility>

#include "croquis/base/error.h"
#include "croquis/tools/recording/general_steps.h"
#include "croquis/tools/silhouette/stroke_erasing.h"
#include "croquis/tools/silhouette/stroke_setting.h"
#include "croquis/tools/strokes/stroke_source.h"
#include "tools/silhouette/redraw.h"

/// How the sketch tool's undo steps are called.

namespace croquis {
namespace {

std::string named(const std::string& id) { return id.starts_with("stroke ") ? id : "stroke " + id; }

/// "Move stroke 3", "Move stroke outline", "Erase 2 strokes".
std::string strokes_label(const std::string& verb, const std::vector<std::string>& ids) {
  return verb + ' ' + (ids.size() == 1 ? named(ids.front()) : std::to_string(ids.size()) + " strokes");
}

/// "Drag a point of stroke 2".
std::string point_label(const std::string& id) { return "Drag a point of " + named(id); }

/// "Make stroke 2 a hole", "Bring stroke 1 in front of stroke 2", "Set thickness of stroke 1".
std::string setting_label(const recorded::StrokeReading& setting) {
  const std::string stroke = named(setting.stroke);
  if (setting.in_front_of) return "Bring " + stroke + " in front of " + named(*setting.in_front_of);
  if (setting.kind == silhouette::StrokeKind::Visible) return "Find what " + stroke + " is";
  if (setting.kind) return "Make " + stroke + " a " + silhouette::to_string(*setting.kind);
  return "Set thickness of " + stroke;
}

std::vector<std::string> modifier_names(const Modifiers& modifiers) {
  std::vector<std::string> names;
  if (modifiers.shift) names.emplace_back("shift");
  if (modifiers.ctrl) names.emplace_back("ctrl");
  return names;
}

std::string device_name(const SketchEvent& event) {
  if (event.erases) return "eraser";
  return is_pen(event.device) ? "pen" : "mouse";
}

bool same_samples(const std::vector<StrokeSample>& a, const std::vector<StrokeSample>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const auto& x, const auto& y) { return x.position == y.position; });
}

double extent(const std::vector<StrokeSample>& samples) {
  double largest = 0;
  for (const StrokeSample& sample : samples)
    largest = std::max(largest, (sample.position - samples.front().position).norm());
  return largest;
}

}  // namespace

SketchTool::SketchTool(Session& session, SketchToolOptions options)
    : session_(session), options_(std::move(options)), drag_(session) {}

void SketchTool::set_mode(SketchMode mode) {
  give_up();
  mode_ = mode;
}

Verdict SketchTool::handle(const SketchEvent& event) {
  const bool finite = event.sample.position.allFinite() && event.units_per_pixel > 0;
  if (event.kind == PenStep::Kind::Cancel) return give_up();
  if (event.kind == PenStep::Kind::Begin) return finite ? begin(event) : give_up();
  if (gesture_ == Gesture::None) return Verdict::Continue;
  if (drag_.interrupted()) return give_up();
  if (event.kind == PenStep::Kind::End) return finish(event);
  return finite ? go_on(event) : Verdict::Continue;
}

Verdict SketchTool::begin(const SketchEvent& event) {
  give_up();
  start_ = event;
  last_ = event.sample.position;
  if (event.erases || mode_ == SketchMode::Erase) {
    gesture_ = Gesture::Erase;
    go_on(event);
  } else if (mode_ == SketchMode::Draw) {
    gesture_ = Gesture::Draw;
    preview_.ink = {event.sample};
    preview_.behind = event.right || event.modifiers.shift;
  } else {
    press(event);
  }
  return Verdict::Continue;
}

Verdict SketchTool::go_on(const SketchEvent& event) {
  const Vec2 place = event.sample.position;
  if (gesture_ == Gesture::Draw) preview_.ink.push_back(event.sample);
  if (gesture_ == Gesture::Erase) {
    // Only the newest step of the path is tried: the rest was when it came.
    const auto now = drawing();
    const std::vector<Vec2> step{last_, place};
    for (auto& piece : now ? erased_pieces(*now, step, eraser_radius()) : std::vector<std::vector<Vec2>>())
      preview_.erased.push_back(std::move(piece));
    preview_.eraser.push_back(place);
  }
  last_ = place;
  const double moved = (place - start_.sample.position).norm();
  if (gesture_ == Gesture::Press && moved > options_.drag_pixels * start_.units_per_pixel) start_drag();
  if (gesture_ == Gesture::Anchor || gesture_ == Gesture::Strokes) drag_to(place);
  if (gesture_ == Gesture::Box) preview_.box = PickBox::spanned(start_.sample.position, place);
  return Verdict::Continue;
}

Verdict SketchTool::finish(const SketchEvent&) {
  switch (gesture_) {
    case Gesture::Draw: return finish_drawing();
    case Gesture::Erase: return finish_erasing();
    case Gesture::Press: return finish_click();
    case Gesture::Box: return finish_box();
    case Gesture::Anchor:
    case Gesture::Strokes: return finish_drag();
    case Gesture::Setting:
    case Gesture::None: break;
  }
  return Verdict::Continue;
}

Verdict SketchTool::give_up() {
  if (gesture_ == Gesture::None) return Verdict::Continue;
  end_gesture();
  drag_.cancel();
  return Verdict::Revert;
}

void SketchTool::end_gesture() {
  gesture_ = Gesture::None;
  preview_ = {};
  original_.reset();
}

// ---- Drawing and erasing

Verdict SketchTool::finish_drawing() {
  const std::vector<StrokeSample> ink = std::move(preview_.ink);
  const bool behind = preview_.behind;
  end_gesture();
  // A tap is no stroke: it would only be reported as too short.
  if (extent(ink) <= options_.drag_pixels * start_.units_per_pixel) return Verdict::Revert;
  const auto before = drawing();
  DrawOptions options;
  options.units_per_pixel = start_.units_per_pixel;
  options.redraws = !start_.modifiers.ctrl;
  options.behind = behind;
  DrawingEdit edit = draw_stroke(before ? *before : Drawing{}, ink, options);
  const std::string label =
      edit.added.empty() ? strokes_label("Redraw", edit.changed) : strokes_label("Draw", edit.added);
  recorded::StrokeDrawn drawn{"sketch", ink, device_name(start_), start_.units_per_pixel, behind};
  for (StrokeSample& sample : drawn.points) sample.time -= ink.front().time;
  done_ = std::move(drawn);
  session_.edit(label, with_drawing(std::move(edit.drawing)));
  return Verdict::Commit;
}

Verdict SketchTool::finish_erasing() {
  const std::vector<Vec2> path = std::move(preview_.eraser);
  const bool touched = !preview_.erased.empty();
  end_gesture();
  const auto before = drawing();
  if (!before || !touched) return Verdict::Revert;
  DrawingEdit edit = erase_along(*before, path, eraser_radius());
  if (!edit.any()) return Verdict::Revert;
  recorded::StrokeDrawn drawn{"sketch", {}, device_name(start_), start_.units_per_pixel};
  for (const Vec2& place : path) drawn.points.push_back({place, 1, Vec2::Zero(), 0});
  done_ = std::move(drawn);
  const std::string label =
      edit.changed.empty() ? strokes_label("Erase", edit.removed) : strokes_label("Erase part of", edit.changed);
  session_.edit(label, without_strokes(std::move(edit)));
  return Verdict::Commit;
}

Verdict SketchTool::delete_selected() {
  give_up();
  const auto before = drawing();
  if (!before) return Verdict::Continue;
  DrawingEdit edit = remove_strokes(*before, selected());
  if (!edit.any()) return Verdict::Continue;
  done_ = recorded::Action{"delete"};
  const std::string label = strokes_label("Delete", edit.removed);
  session_.edit(label, without_strokes(std::move(edit)));
  return Verdict::Commit;
}

// ---- Selecting and dragging

void SketchTool::press(const SketchEvent& event) {
  gesture_ = Gesture::Press;
  picked_.clear();
  anchor_.reset();
  original_ = drawing();
  if (!original_) return;
  PickReach reach = options_.reach;
  reach.units_per_pixel = event.units_per_pixel;
  for (const std::string& id : selected()) {
    const StrokeFit* selected_fit = fit(id);
    if (selected_fit == nullptr) continue;
    anchor_ = nearest_anchor(selected_fit->anchors, event.sample.position, reach);
    if (!anchor_) continue;
    picked_ = id;
    held_fit_ = *selected_fit;
    return;
  }
  if (const auto picked = nearest_stroke(*original_, event.sample.position, reach)) picked_ = picked->id;
}

void SketchTool::start_drag() {
  if (picked_.empty()) {
    gesture_ = Gesture::Box;
    return;
  }
  if (!anchor_ && !contains(selected(), picked_)) {
    std::vector<std::string> ids = start_.modifiers.shift ? selected() : std::vector<std::string>{};
    ids.push_back(picked_);
    select_strokes(ids);
  }
  gesture_ = anchor_ ? Gesture::Anchor : Gesture::Strokes;
  preview_.held_stroke = picked_;
  preview_.held_anchor = anchor_;
  drag_.begin(anchor_ ? point_label(picked_) : strokes_label("Move", selected()));
}

void SketchTool::drag_to(const Vec2& place) {
  const Vec2 by = place - start_.sample.position;
  DrawingEdit edit =
      anchor_ ? drag_anchor(*original_, picked_, held_fit_, *anchor_, by) : move_strokes(*original_, selected(), by);
  drag_.to(with_drawing(std::move(edit.drawing)));
}

Verdict SketchTool::finish_drag() {
  done_ = recorded::Drag{picked_, anchor_, last_ - start_.sample.position};
  end_gesture();
  drag_.end();
  return Verdict::Commit;
}

Verdict SketchTool::finish_click() {
  const std::string id = picked_;
  end_gesture();
  const bool shift = start_.modifiers.shift;
  std::vector<std::string> ids = shift ? selected() : std::vector<std::string>{};
  if (shift && contains(ids, id)) {
    std::erase(ids, id);
  } else if (!id.empty()) {
    ids.push_back(id);
  }
  done_ = recorded::Click{"sketch", start_.sample.position, modifier_names(start_.modifiers)};
  select_strokes(ids);
  return Verdict::Commit;
}

Verdict SketchTool::finish_box() {
  const PickBox box = PickBox::spanned(start_.sample.position, last_);
  end_gesture();
  const auto now = drawing();
  std::vector<std::string> ids = start_.modifiers.shift ? selected() : std::vector<std::string>{};
  if (now) {
    for (std::string& id : strokes_in_box(*now, box)) ids.push_back(std::move(id));
  }
  done_ = recorded::Box{"sketch", start_.sample.position, last_, modifier_names(start_.modifiers)};
  select_strokes(ids);
  return Verdict::Commit;
}

void SketchTool::select_all() {
  const auto now = drawing();
  std::vector<std::string> ids;
  if (now) {
    for (const Stroke& stroke : now->strokes) ids.push_back(stroke.id);
  }
  select_strokes(ids);
}

Verdict SketchTool::drag(const std::string& stroke, std::optional<std::size_t> anchor, const Vec2& by) {
  give_up();
  const auto before = drawing();
  const StrokeFit* stroke_fit = fit(stroke);
  if (!before || stroke_fit == nullptr) {
    throw Error(make_error(Category::Usage, "E_INPUT",
                           "The drawing has no stroke \"" + stroke + "\"; choose one of those it has.",
                           {{SubjectKind::Stroke, stroke, {}, {}, {}}}));
  }
  std::vector<std::string> ids = selected();
  if (!contains(ids, stroke)) ids = {stroke};
  DrawingEdit edit = anchor ? drag_anchor(*before, stroke, *stroke_fit, *anchor, by) : move_strokes(*before, ids, by);
  done_ = recorded::Drag{stroke, anchor, by};
  session_.edit(anchor ? point_label(stroke) : strokes_label("Move", ids), with_drawing(std::move(edit.drawing)));
  return Verdict::Commit;
}

Verdict SketchTool::set(const recorded::StrokeReading& setting, bool dragging) {
  const bool goes_on = gesture_ == Gesture::Setting;
  if (!goes_on) give_up();
  if (goes_on && drag_.interrupted()) return give_up();
  const auto before = drawing();
  const Drawing none;
  const Drawing& now = before ? *before : none;
  const std::string& id = setting.stroke;
  DrawingEdit edit = setting.kind          ? set_kind(now, id, *setting.kind)
                     : setting.in_front_of ? set_in_front(now, id, *setting.in_front_of)
                                           : set_thickness(now, id, setting.thickness.value_or(1));
  if (dragging && !goes_on) drag_.begin(setting_label(setting));
  if (dragging || goes_on)
    drag_.to(with_drawing(std::move(edit.drawing)));
  else
    session_.edit(setting_label(setting), with_drawing(std::move(edit.drawing)));
  gesture_ = dragging ? Gesture::Setting : Gesture::None;
  if (dragging) return Verdict::Continue;
  if (goes_on) drag_.end();
  done_ = setting;
  return Verdict::Commit;
}

// ---- The document

NodeId SketchTool::node() const { return source_node<Drawing>(session_.document(), node_); }

std::shared_ptr<const Drawing> SketchTool::drawing() const {
  return source_of<Drawing>(session_.document().find(node()));
}

Document SketchTool::with_drawing(Drawing drawing) const {
  const Document& document = session_.document();
  const Value value = std::make_shared<const Drawing>(std::move(drawing));
  if (const Node* old = document.find(node())) {
    Node edited = *old;
    edited.source = value;
    return document.with(std::move(edited));
  }
  return add_drawing(document, value, options_);
}

Document SketchTool::without_strokes(DrawingEdit edit) const {
  const auto drawing = std::make_shared<const Drawing>(edit.drawing);
  Document document = with_drawing(std::move(edit.drawing));
  if (!options_.follow_removal || edit.removed.empty()) return document;
  for (const auto& made : session_.document().nodes()) {
    const auto input = made->inputs.find(options_.port);
    if (made->operation != options_.operation || input == made->inputs.end() || input->second.node != node()) continue;
    Node following = *made;
    following.parameters = options_.follow_removal(std::move(following.parameters), *drawing);
    document = document.with(std::move(following));
  }
  return document;
}

Document add_drawing(const Document& document, Value drawing, const SketchToolOptions& options) {
  Node operation;
  operation.parameters = options.parameters;
  return with_stroke_source(document, std::move(drawing), options, std::move(operation));
}

std::vector<std::string> SketchTool::selected() const {
  const auto now = drawing();
  return now ? selected_ids(session_, node(), now->strokes) : std::vector<std::string>();
}

void SketchTool::select_strokes(const std::vector<std::string>& ids) { select_ids(session_, node(), ids); }

const StrokeFit* SketchTool::fit(const std::string& id) {
  const auto now = drawing();
  const Stroke* stroke = now ? find_stroke(*now, id) : nullptr;
  if (stroke == nullptr || stroke->samples.empty()) return nullptr;
  KeptFit& kept = fits_[id];
  if (gesture_ == Gesture::Anchor && id == picked_ && !drag_.interrupted()) {
    kept = {{}, held_fit_};
    kept.fit.anchors[*anchor_].position += last_ - start_.sample.position;
  } else if (!same_samples(kept.samples, stroke->samples)) {
    kept = {stroke->samples, fit_in_drawing(*now, *stroke)};
  }
  return &kept.fit;
}

}  // namespace croquis

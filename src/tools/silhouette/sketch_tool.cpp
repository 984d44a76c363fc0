// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/tools/silhouette/sketch_tool.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "croquis/base/error.h"
#include "croquis/tools/recording/general_steps.h"
#include "croquis/tools/silhouette/stroke_erasing.h"
#include "croquis/tools/silhouette/stroke_setting.h"
#include "croquis/tools/strokes/stroke_source.h"
#include "tools/silhouette/mirror_strokes.h"
#include "tools/silhouette/redraw.h"

namespace croquis {

/// A gesture under way, and what lay under its beginning.
struct SketchGesture {
  enum class Kind { Draw, Erase, Press, Box, Anchor, Strokes, Setting };

  Kind kind = Kind::Press;
  SketchEvent start = {};                        ///< that began it
  Vec2 last = Vec2::Zero();                      ///< where the pointer is
  std::string picked = {};                       ///< stroke under the press, empty for none
  std::optional<std::size_t> anchor = {};        ///< of `picked`, under the press
  std::shared_ptr<const Drawing> original = {};  ///< before the drag
  StrokeFit held_fit = {};                       ///< of `picked` before the drag

  Vec2 way() const { return last - start.sample.position; }
  PickBox box() const { return PickBox::spanned(start.sample.position, last); }
};

/// What a gesture or a step makes of the drawing.
struct SketchChange {
  DrawingEdit edit;
  std::string label;  ///< of the undo step
  recorded::Step step;
};

namespace {

// How undo steps are called.

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
  if (setting.title)
    return setting.title->empty() ? "Take the name off " + stroke : "Rename a part to " + *setting.title;
  if (setting.far_copy == true) return "Make a far copy of " + stroke;
  if (setting.far_copy) return "Take away the far copy of " + stroke;
  if (setting.over) return "Swap strands of " + stroke;
  if (setting.mirror) return (setting.mirror->empty() ? "End the symmetry of " : "Mirror ") + stroke;
  if (setting.fill) return "Set colour of " + stroke;
  if (setting.kind) return "Make " + stroke + " a " + silhouette::to_string(*setting.kind);
  return "Set thickness of " + stroke;
}

DrawingEdit setting_edit(const Drawing& drawing, const recorded::StrokeReading& setting) {
  const std::string& id = setting.stroke;
  if (setting.kind) return set_kind(drawing, id, *setting.kind);
  if (setting.in_front_of) return set_in_front(drawing, id, *setting.in_front_of);
  if (setting.title) return set_title(drawing, id, *setting.title);
  if (setting.far_copy) return set_far_copy(drawing, id, *setting.far_copy);
  if (setting.over) return set_over(drawing, id, *setting.over);
  if (setting.mirror) return set_mirror(drawing, id, *setting.mirror);
  if (setting.fill) return set_fill(drawing, id, *setting.fill);
  return set_thickness(drawing, id, setting.thickness.value_or(1));
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

[[noreturn]] void refuse_stroke(const std::string& id) {
  throw Error(make_error(Category::Usage, "E_INPUT",
                         "The drawing has no stroke \"" + id + "\"; choose one of those it has.",
                         {{SubjectKind::Stroke, id, {}, {}, {}}}));
}

/// What lies under the beginning of a gesture that selects: an anchor of a selected stroke, else a stroke.
void pick(SketchGesture& now, SketchTool& tool, PickReach reach) {
  const Vec2& place = now.start.sample.position;
  reach.units_per_pixel = now.start.units_per_pixel;
  now.original = tool.drawing();
  if (!now.original) return;
  for (const std::string& id : tool.selected()) {
    const StrokeFit* selected_fit = tool.fit(id);
    if (selected_fit == nullptr) continue;
    now.anchor = nearest_anchor(selected_fit->anchors, place, reach);
    if (!now.anchor) continue;
    now.picked = id;
    now.held_fit = *selected_fit;
    return;
  }
  if (const auto picked = nearest_stroke(*now.original, place, reach)) now.picked = picked->id;
}

std::optional<SketchChange> drawn_stroke(const SketchEvent& start, const SketchPreview& drawn,
                                         const std::shared_ptr<const Drawing>& before, double drag_pixels) {
  // A tap is no stroke: it would only be reported as too short.
  if (extent(drawn.ink) <= drag_pixels * start.units_per_pixel) return std::nullopt;
  DrawOptions options;
  options.units_per_pixel = start.units_per_pixel;
  options.redraws = !start.modifiers.ctrl;
  options.behind = drawn.behind;
  options.tube = drawn.tube;
  options.mirror = drawn.mirror;
  DrawingEdit edit = draw_stroke(before ? *before : Drawing{}, drawn.ink, options);
  const std::string label =
      edit.added.empty() ? strokes_label("Redraw", edit.changed) : strokes_label("Draw", edit.added);
  recorded::StrokeDrawn step{"sketch",     drawn.ink,  device_name(start), start.units_per_pixel,
                             drawn.behind, drawn.tube, drawn.mirror};
  for (StrokeSample& sample : step.points) sample.time -= drawn.ink.front().time;
  return SketchChange{std::move(edit), label, std::move(step)};
}

std::optional<SketchChange> erased_strokes(const SketchEvent& start, const SketchPreview& drawn,
                                           const std::shared_ptr<const Drawing>& before, double eraser_pixels) {
  if (!before || drawn.erased.empty()) return std::nullopt;
  DrawingEdit edit = erase_along(*before, drawn.eraser, eraser_pixels * start.units_per_pixel);
  if (!edit.any()) return std::nullopt;
  recorded::StrokeDrawn step{"sketch", {}, device_name(start), start.units_per_pixel};
  for (const Vec2& place : drawn.eraser) step.points.push_back({place, 1, Vec2::Zero(), 0});
  const std::string label =
      edit.changed.empty() ? strokes_label("Erase", edit.removed) : strokes_label("Erase part of", edit.changed);
  return SketchChange{std::move(edit), label, std::move(step)};
}

/// The document with what an edit has made of the drawing, on both sides where it is symmetric; what is made of the
/// drawing follows strokes that go.
/// @param node of the drawing; 0: it becomes a new one
/// @param original what the edit began with: of a drag, the drawing before it
Document with_edit(const Document& before, NodeId node, const Drawing& original, DrawingEdit edit,
                   const SketchToolOptions& options) {
  edit = on_both_sides(original, std::move(edit));
  const Node* old = before.find(node);
  const Value drawing = std::make_shared<const Drawing>(edit.drawing);
  if (old == nullptr) return add_drawing(before, drawing, options);
  Node edited = *old;
  edited.source = drawing;
  Document document = before.with(std::move(edited));
  if (!options.follow_removal || edit.removed.empty()) return document;
  for (const auto& made : before.nodes()) {
    const auto input = made->inputs.find(options.port);
    if (made->operation != options.operation || input == made->inputs.end() || input->second.node != node) continue;
    Node following = *made;
    following.parameters = options.follow_removal(std::move(following.parameters), edit.drawing);
    document = document.with(std::move(following));
  }
  return document;
}

}  // namespace

SketchTool::SketchTool(Session& session, SketchToolOptions options)
    : session_(session), options_(std::move(options)), drag_(session) {}

SketchTool::~SketchTool() = default;

void SketchTool::set_mode(SketchMode mode) {
  give_up();
  mode_ = mode;
}

// ---- Gestures

Verdict SketchTool::handle(const SketchEvent& event) {
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

Verdict SketchTool::give_up() {
  if (!gesture_) return Verdict::Continue;
  gesture_.reset();
  preview_ = {};
  drag_.cancel();
  return Verdict::Revert;
}

void SketchTool::begin(const SketchEvent& event) {
  gesture_ = std::make_unique<SketchGesture>();
  SketchGesture& now = *gesture_;
  now.start = event;
  now.last = event.sample.position;
  if (event.erases || mode_ == SketchMode::Erase) {
    now.kind = SketchGesture::Kind::Erase;
    return go_on(event);
  }
  if (mode_ == SketchMode::Draw) {
    now.kind = SketchGesture::Kind::Draw;
    preview_.ink = {event.sample};
    preview_.behind = event.right || event.modifiers.shift;
    preview_.tube = options_.tube;
    preview_.mirror = options_.mirror;
    return;
  }
  pick(now, *this, options_.reach);
}

void SketchTool::go_on(const SketchEvent& event) {
  SketchGesture& now = *gesture_;
  const double unit = now.start.units_per_pixel;
  const Vec2 before = std::exchange(now.last, event.sample.position);
  if (now.kind == SketchGesture::Kind::Draw) preview_.ink.push_back(event.sample);
  if (now.kind == SketchGesture::Kind::Erase) {
    // Only the newest step of the path is tried: the rest was when it came.
    const auto drawn = drawing();
    const std::vector<Vec2> step{before, now.last};
    for (auto& piece :
         drawn ? erased_pieces(*drawn, step, options_.eraser_pixels * unit) : std::vector<std::vector<Vec2>>())
      preview_.erased.push_back(std::move(piece));
    preview_.eraser.push_back(now.last);
  }
  if (now.kind == SketchGesture::Kind::Press && now.way().norm() > options_.drag_pixels * unit) start_drag();
  if (now.kind == SketchGesture::Kind::Box) preview_.box = now.box();
  if (now.kind != SketchGesture::Kind::Anchor && now.kind != SketchGesture::Kind::Strokes) return;
  preview_.moved = now.way();
  DrawingEdit edit = now.anchor ? drag_anchor(*now.original, now.picked, now.held_fit, *now.anchor, now.way())
                                : move_strokes(*now.original, selected(), now.way());
  drag_.to(with_edit(session_.document(), node(), *now.original, std::move(edit), options_));
}

void SketchTool::start_drag() {
  SketchGesture& now = *gesture_;
  now.kind = now.picked.empty() ? SketchGesture::Kind::Box
             : now.anchor       ? SketchGesture::Kind::Anchor
                                : SketchGesture::Kind::Strokes;
  if (now.kind == SketchGesture::Kind::Box) return;
  if (!now.anchor && !contains(selected(), now.picked)) {
    std::vector<std::string> ids = now.start.modifiers.shift ? selected() : std::vector<std::string>{};
    ids.push_back(now.picked);
    select_ids(session_, node(), ids);
  }
  preview_.held_stroke = now.picked;
  preview_.held_anchor = now.anchor;
  drag_.begin(now.anchor ? point_label(now.picked) : strokes_label("Move", selected()));
}

Verdict SketchTool::finish() {
  if (gesture_->kind == SketchGesture::Kind::Setting) return Verdict::Continue;
  const std::unique_ptr<const SketchGesture> gesture = std::exchange(gesture_, nullptr);
  const SketchPreview drawn = std::exchange(preview_, {});
  if (gesture->kind == SketchGesture::Kind::Draw)
    return commit(drawn_stroke(gesture->start, drawn, drawing(), options_.drag_pixels));
  if (gesture->kind == SketchGesture::Kind::Erase)
    return commit(erased_strokes(gesture->start, drawn, drawing(), options_.eraser_pixels));
  if (drag_.begun()) {
    done_ = recorded::Drag{gesture->picked, gesture->anchor, gesture->way()};
    drag_.end();
    return Verdict::Commit;
  }
  const Vec2& from = gesture->start.sample.position;
  const std::vector<std::string> modifiers = modifier_names(gesture->start.modifiers);
  std::vector<std::string> ids = gesture->start.modifiers.shift ? selected() : std::vector<std::string>{};
  if (gesture->kind == SketchGesture::Kind::Box) {
    const auto now = drawing();
    for (std::string& id : now ? strokes_in_box(*now, gesture->box()) : std::vector<std::string>())
      ids.push_back(std::move(id));
    done_ = recorded::Box{"sketch", from, gesture->last, modifiers};
  } else {
    if (!gesture->picked.empty() && std::erase(ids, gesture->picked) == 0) ids.push_back(gesture->picked);
    done_ = recorded::Click{"sketch", from, modifiers};
  }
  select_ids(session_, node(), ids);
  return Verdict::Commit;
}

/// Nothing could be made of the drawing: what had begun is given up.
Verdict SketchTool::commit(std::optional<SketchChange> change) {
  if (!change) return Verdict::Revert;
  done_ = std::move(change->step);
  const Drawing before = drawing() ? *drawing() : Drawing{};
  session_.edit(change->label, with_edit(session_.document(), node(), before, std::move(change->edit), options_));
  return Verdict::Commit;
}

// ---- Commands

Verdict SketchTool::delete_selected() {
  give_up();
  const auto before = drawing();
  if (!before) return Verdict::Continue;
  DrawingEdit edit = remove_strokes(*before, selected());
  if (!edit.any()) return Verdict::Continue;
  const std::string label = strokes_label("Delete", edit.removed);
  return commit(SketchChange{std::move(edit), label, recorded::Action{"delete"}});
}

void SketchTool::select_all() {
  std::vector<std::string> ids;
  if (const auto now = drawing()) std::ranges::transform(now->strokes, std::back_inserter(ids), &Stroke::id);
  select_ids(session_, node(), ids);
}

Verdict SketchTool::drag(const std::string& stroke, std::optional<std::size_t> anchor, const Vec2& by) {
  give_up();
  const auto before = drawing();
  const StrokeFit* stroke_fit = fit(stroke);
  if (!before || stroke_fit == nullptr) refuse_stroke(stroke);
  std::vector<std::string> ids = selected();
  if (!contains(ids, stroke)) ids = {stroke};
  DrawingEdit edit = anchor ? drag_anchor(*before, stroke, *stroke_fit, *anchor, by) : move_strokes(*before, ids, by);
  return commit(SketchChange{std::move(edit), anchor ? point_label(stroke) : strokes_label("Move", ids),
                             recorded::Drag{stroke, anchor, by}});
}

Verdict SketchTool::set(const recorded::StrokeReading& setting, bool dragging) {
  const bool goes_on = gesture_ && gesture_->kind == SketchGesture::Kind::Setting;
  if (!goes_on) give_up();
  if (goes_on && drag_.interrupted()) return give_up();
  const auto before = drawing();
  const Drawing none;
  const Drawing& now = before ? *before : none;
  DrawingEdit edit = setting_edit(now, setting);
  if (!dragging && !goes_on) return commit(SketchChange{std::move(edit), setting_label(setting), setting});
  if (!goes_on) drag_.begin(setting_label(setting));
  drag_.to(with_edit(session_.document(), node(), now, std::move(edit), options_));
  gesture_ = dragging ? std::make_unique<SketchGesture>(SketchGesture{SketchGesture::Kind::Setting, {}, {}}) : nullptr;
  if (dragging) return Verdict::Continue;
  drag_.end();
  done_ = setting;
  return Verdict::Commit;
}

// ---- The document

NodeId SketchTool::node() const { return source_node<Drawing>(session_.document(), node_); }

std::shared_ptr<const Drawing> SketchTool::drawing() const {
  return source_of<Drawing>(session_.document().find(node()));
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

const StrokeFit* SketchTool::fit(const std::string& id) {
  const auto now = drawing();
  const Stroke* stroke = now ? find_stroke(*now, id) : nullptr;
  if (stroke == nullptr || stroke->samples.empty()) return nullptr;
  KeptFit& kept = fits_[id];
  const bool is_held = gesture_ && gesture_->kind == SketchGesture::Kind::Anchor && id == gesture_->picked;
  if (is_held && !drag_.interrupted()) {
    kept = {{}, gesture_->held_fit};
    kept.fit.anchors[*gesture_->anchor].position += gesture_->way();
  } else if (!same_samples(kept.samples, stroke->samples)) {
    kept = {stroke->samples, fit_in_drawing(*now, *stroke)};
  }
  return &kept.fit;
}

void read_as(Session& session, NodeId node, const recorded::ReadingChosen& reading) {
  const auto drawing = source_of<Drawing>(session.document().find(node));
  if (!drawing) refuse_stroke(reading.says.empty() ? "" : reading.says.front().front());
  session.edit("Choose a reading", with_edit(session.document(), node, *drawing, set_data(*drawing, reading.says), {}));
}

}  // namespace croquis

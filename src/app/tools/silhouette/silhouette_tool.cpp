// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tools/silhouette/silhouette_tool.h"

#include <QAction>
#include <QActionGroup>
#include <QColorDialog>
#include <QMenu>
#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include "app/replay/replays.h"
#include "app/tools/action_rows.h"
#include "app/tools/scene_parts.h"
#include "app/tools/silhouette/sketch_actions.h"
#include "app/views/own_space.h"
#include "app/views/render_color.h"
#include "app/window/theme.h"
#include "croquis/base/text.h"
#include "croquis/operators/inflate_result.h"
#include "croquis/silhouette/stroke_data.h"
#include "croquis/tools/recording/general_steps.h"
#include "croquis/tools/silhouette/sketch_steps.h"
#include "croquis/tools/silhouette/stroke_edit.h"
#include "croquis/tools/silhouette/stroke_setting.h"

namespace croquis::app {
namespace {

constexpr double stroke_reach = 8;  // logical pixels
constexpr double hint_height = 60;  // above the view's lower border

SketchMode sketch_mode(const QString& mode) {
  if (mode == "draw" || mode == "tube") return SketchMode::Draw;
  return mode == "erase" ? SketchMode::Erase : SketchMode::Select;
}

StrokeSample sample_at(const Vec2& place) {
  StrokeSample sample;
  sample.position = place;
  return sample;
}

template <class Item, class Test>
std::size_t count_of(const std::vector<Item>& items, const Test& test) {
  return static_cast<std::size_t>(std::ranges::count_if(items, test));
}

std::size_t held_pairs(const InflateResult& inflated, silhouette::Hold hold) {
  return count_of(inflated.attached, [hold](const silhouette::SolidAttachment& pair) { return pair.hold == hold; });
}

/// The result of the solid that the object's second node is, or null.
std::shared_ptr<const Evaluation> solid_in(const Studio& studio, const WorkObject& object) {
  return object.chain.size() < 2 ? nullptr : studio.result(object.chain[1]);
}

QString joined(const std::vector<std::string>& texts) {
  QStringList list;
  for (const std::string& text : texts) list << shown_name(text);
  return list.join(", ");
}

ObjectRow row_of(const Body& body) {
  const auto count = body.strokes.size();
  const QString info =
      count == 1 ? SilhouetteTool::tr("1 stroke") : SilhouetteTool::tr("%1 strokes").arg(qulonglong(count));
  return {body.name, info, joined(body.strokes), body.strokes};
}

/// What replays can ask of sketches.
void add_counts(Replays& replays, Studio& studio, const SketchTool& tool) {
  replays.on<recorded::ReadingChosen>(
      [&](const recorded::ReadingChosen& step) { read_as(studio.session(), tool.node(), step); });
  // The sketch's solid counts as the bodies that it has.
  replays.counts["objects"] = [&studio](const std::string&) {
    std::size_t count = 0;
    for (const WorkObject& object : studio.objects()) {
      const InflateResult* inflated = result_of<InflateResult>(object.result.get());
      const std::size_t bodies = inflated == nullptr || object.result->failed ? 0 : inflated->objects.size();
      count += object.node == studio.solid_node() ? bodies : object.visible;
    }
    return count;
  };
  replays.counts["strokes"] = [&studio](const std::string&) { return studio.drawing().strokes.size(); };
  replays.counts["strokes-behind"] = [&studio](const std::string&) {
    return count_of(studio.drawing().strokes,
                    [](const Stroke& stroke) { return stroke.data.contains(silhouette::behind_key); });
  };
  const auto add = [&](const char* name, const auto& count) {
    replays.counts[name] = [&studio, count](const std::string&) {
      const auto result = studio.result();
      const InflateResult* inflated = result_of<InflateResult>(result.get());
      return inflated == nullptr || result->failed ? 0 : count(*inflated);
    };
  };
  add("inner-holes", [](const InflateResult& inflated) {
    return count_of(inflated.nested, [](const NestedStroke& nested) { return nested.hole; });
  });
  add("inner-parts", [](const InflateResult& inflated) {
    return count_of(inflated.nested, [](const NestedStroke& nested) { return !nested.hole; });
  });
  const auto add_kinds = [&](const char* name, std::vector<silhouette::StrokeKind> kinds) {
    add(name, [kinds = std::move(kinds)](const InflateResult& inflated) {
      return count_of(inflated.kinds, [&](const auto& read) { return std::ranges::count(kinds, read.second) > 0; });
    });
  };
  add_kinds("details", {silhouette::StrokeKind::Detail, silhouette::StrokeKind::Scribble});
  add_kinds("tubes", {silhouette::StrokeKind::Tube});
  add_kinds("left-out", {silhouette::StrokeKind::Ignored});
  add("crossings-in-view", [](const InflateResult& inflated) { return inflated.crossings_in_view.size(); });
  add("joined-pairs", [](const InflateResult& inflated) { return held_pairs(inflated, silhouette::Hold::Joined); });
  add("resting-pairs", [](const InflateResult& inflated) { return held_pairs(inflated, silhouette::Hold::Resting); });
}

/// On solids as they were drawn, by object: what is refined or cut after that has another surface.
std::map<NodeId, render::LineItemPtr> lines_on_solids(const Studio& studio) {
  const render::LineStyle style{ink_width, to_color(colors::ink), {}, render::LineDepth::Tested};
  std::map<NodeId, render::LineItemPtr> items;
  for (const WorkObject& object : studio.objects()) {
    if (!object.result || result_of<InflateResult>(object.result.get()) == nullptr) continue;
    const auto lines = object.result->outputs.find("lines");
    if (lines == object.result->outputs.end()) continue;
    if (auto item = lines_of(lines->second.get<PolyMesh>(), style)) items[object.node] = std::move(item);
  }
  return items;
}

/// The bodies of a sketch's solid, and strokes that belong to none. @param rename gives a stroke's body a title
std::vector<ObjectRow> rows_of(const Studio& studio, const WorkObject& object, NodeId node,
                               const std::function<void(const std::string&, const std::string&)>& rename) {
  const auto drawing =
      node == object.chain.front() ? source_of<Drawing>(studio.session().document().find(node)) : nullptr;
  std::vector<ObjectRow> rows;
  if (!drawing) return rows;
  const auto result = solid_in(studio, object);
  const InflateResult* inflated = result_of<InflateResult>(result.get());
  std::map<std::string, silhouette::StrokeKind> kinds;
  if (inflated != nullptr) kinds.insert(inflated->kinds.begin(), inflated->kinds.end());
  std::set<std::string> used;
  for (const Body& body : bodies_of(*drawing, result.get())) {
    rows.push_back(row_of(body));
    rows.back().rename = [rename, stroke = body.strokes.front()](const std::string& title) { rename(stroke, title); };
    used.insert(body.strokes.begin(), body.strokes.end());
  }
  std::map<QString, int> counts;
  for (const Stroke& stroke : drawing->strokes) {
    if (used.contains(stroke.id)) continue;
    const auto kind = kinds.find(stroke.id);
    const bool on_surface = kind != kinds.end() && kind->second != silhouette::StrokeKind::Ignored;
    const QString word = kind == kinds.end() ? SilhouetteTool::tr("Line") : word_of(kind->second);
    rows.push_back(
        {QObject::tr("%1 %2").arg(word).arg(++counts[word]), {}, shown_name(stroke.id), {stroke.id}, on_surface});
  }
  return rows;
}

/// The radius of a tube that is drawn now, sketch units. @param share of the view's diagonal
double tube_radius(double share, Viewport& viewport) {
  const ViewPane& pane = viewport.pane(SketchView);
  return share * pane.sketch_frame().units_per_pixel * std::hypot(pane.rect.width(), pane.rect.height());
}

/// The name of the body that a finding is about; none where there is only one.
QString body_of(const Studio& studio, const NodeFinding& found) {
  const WorkObject* object = studio.object(found.node);
  const auto drawing =
      object == nullptr ? nullptr : source_of<Drawing>(studio.session().document().find(object->chain.front()));
  if (!drawing) return {};
  const std::vector<Body> bodies = bodies_of(*drawing, solid_in(studio, *object).get());
  if (bodies.size() < 2 && studio.objects().size() < 2) return {};
  const Body* body = body_with(bodies, strokes_of(found.finding));
  return body == nullptr ? QString() : body->name;
}

/// The strip of other readings, which changes the tool's drawing.
ReadingStrip* make_readings(ToolHost& host, const SketchTool& tool, SilhouetteTool& owner) {
  auto* strip = new ReadingStrip(host);
  QObject::connect(strip, &ReadingStrip::size_changed, &owner, [&owner] { emit owner.changed(SketchView); });
  QObject::connect(strip, &ReadingStrip::chosen, &owner, [&](const recorded::ReadingChosen& reading) {
    read_as(host.studio().session(), tool.node(), reading);
    emit owner.committed(reading);
  });
  return strip;
}

/// Where there is no solid, Tab goes to the next field as it does everywhere.
void offer_readings(ToolHost& host, ReadingStrip& strip, bool has_view, ToolKeys& keys) {
  const Studio& studio = host.studio();
  const bool has_solid = has_view && studio.solid_node() != 0 && !studio.drawing().strokes.empty();
  host.action("readings")->setEnabled(has_solid);
  keys.pressed.erase(Qt::Key_Tab);
  if (has_solid) keys.pressed[Qt::Key_Tab] = [&strip] { strip.open(); };
}

QString help_of(SketchMode mode, bool has_strokes, bool tubes) {
  const auto tr = [](const char* text) { return SilhouetteTool::tr(text); };
  if (tubes)
    return tr("Draw the middle line of a tube, it may cross itself: pressure makes it thicker · D draws outlines");
  if (mode == SketchMode::Select)
    return tr("Drag a square to reshape the line, drag a line to move it, Shift adds · Delete removes · D draws");
  if (mode == SketchMode::Erase) return tr("Drag over lines to cut pieces out of them · D draws");
  if (!has_strokes) return tr("Draw a closed outline with the pen or the mouse");
  return tr(
      "Draw: a line stops where it passes behind another · the right button draws behind · Q selects · Ctrl+Z undoes");
}

}  // namespace

SilhouetteTool::SilhouetteTool(ToolHost& host)
    : Tool(host, "Drawing"),
      tool_(host.studio().session(), host.studio().tool_options()),
      chips_(host.studio(), tool_, host.viewport()),
      readings_(make_readings(host, tool_, *this)),
      hint_(make_chip_label(host.viewport(), hint_style)) {
  host.viewport().objects().set_painter(paint_of_bodies);
  hint_->setObjectName("hint");
  hint_->setText(tr("Trace me: one closed line becomes a solid"));
  connect(&chips_, &SketchChips::committed, this, &Tool::committed);
}

void SilhouetteTool::make_actions(ActionList& actions) {
  add_sketch_actions(host(), tool_, chips_, *readings_, tube_share_, actions);
  connect(host().action("symmetric-drawing"), &QAction::triggered, this, [this] { follow(Change::Document); });
}

void SilhouetteTool::refresh() {
  const bool mesh = studio().active() != nullptr && studio().active()->cage != 0;
  offer_readings(host(), *readings_, has_view(SketchView), keys);
  enable_sketch_actions(host(), tool_, has_view(SketchView));
  host().action("erase")->setEnabled(studio().network_node() == 0 && (!studio().drawing().strokes.empty() || !mesh));
}

void SilhouetteTool::set_mode(const QString& mode) {
  Tool::set_mode(mode);
  tool_.set_mode(sketch_mode(mode));
  PenOptions options = input_.options();
  options.right_draws = tool_.mode() == SketchMode::Draw;
  input_.set_options(options);
  studio().hold_results(inking());
  scene_.show_hovered(std::nullopt, studio().drawing());
  scene_.show_drawing(studio(), tool_);
  emit changed(SketchView);
  if (draws() && studio().network_node() == 0) show_sketch_view(host().viewport());
}

/// The sketch view shows sketches unless it is the sheet of a drawing in perspective, or a view of a network.
ViewUse SilhouetteTool::use_of(int view) const {
  const bool is_here = has_view(view);
  const bool is_paper = is_here && (scene_.has_strokes() || !has_cage(studio()));
  const bool is_sketched = scene_.has_strokes() || scene_.invites();
  return {.works = is_here && (draws() || (mode_ == select_mode && is_paper)),
          .bounds = is_here && scene_.has_strokes() ? scene_.bounds(false) : render::Bounds(),
          .cursor = draws() ? Qt::CrossCursor : Qt::ArrowCursor,
          .every_move = true,
          .paper = is_paper,
          .title = is_here && is_sketched ? tr("Sketch") : QString()};
}

void SilhouetteTool::add_all_to(Selection& selection) const {
  for (const Stroke& stroke : studio().drawing().strokes) selection.push_back({studio().drawing_node(), stroke.id});
}

bool SilhouetteTool::command(EditCommand command) {
  if (command != EditCommand::Delete || tool_.selected().empty()) return false;
  host().record(recorded::Action{"delete"});
  return tool_.delete_selected() == Verdict::Commit;
}

bool SilhouetteTool::show(const Target& target) {
  const Document& document = studio().session().document();
  Selection selection;
  if (const auto* step = std::get_if<const Node*>(&target)) {
    if (!works_on(studio(), **step, ValueType::Drawing)) return false;
    if (!draws() && mode_ != select_mode) host().set_mode(first_mode);
    show_sketch_view(host().viewport());
    return true;
  }
  if (const auto* found = std::get_if<NodeFinding>(&target)) {
    if (found->node != studio().solid_node()) return false;
    for (const std::string& stroke : strokes_of(found->finding)) selection.push_back({studio().drawing_node(), stroke});
  } else if (const auto* chosen = std::get_if<ChosenParts>(&target)) {
    if (!source_of<Drawing>(document.find(chosen->node))) return false;
    for (const std::string& stroke : chosen->parts) selection.push_back({chosen->node, stroke});
  } else {
    return false;
  }
  studio().session().select(std::move(selection));
  return true;
}

ToolWords SilhouetteTool::words() const {
  return {.help = help_of(tool_.mode(), scene_.has_strokes(), mode_ == "tube"), .tooltip = under_pointer_};
}

void SilhouetteTool::adjust(ObjectScenes::Wanted& wanted, int view) const {
  if (!has_view(view)) return;
  wanted.only_with_cage = true;
  wanted.nothing = !studio().drawing().plane.is_default();  // it shows the sketch's own plane then
}

void SilhouetteTool::add_to(render::Scene& scene, int view) {
  if (!has_view(view)) {
    for (const WorkObject& object : studio().objects()) {
      const auto lines = lines_.find(object.node);
      if (lines == lines_.end() || !object.visible) continue;
      const PlacedPart part(scene, object.placement.map());
      scene.lines.emplace_back(lines->second);
    }
    return;
  }
  scene_.add_to(scene);
}

ToolState SilhouetteTool::state() const {
  if (inking()) return {.ink = Ink{SketchView, &tool_.preview().ink, tool_.preview().behind}};
  const auto& moved = tool_.preview().moved;
  return {.busy = readings_->busy(), .beside_pointer = moved ? way_text(*moved, studio()) : QString()};
}

void SilhouetteTool::place_chips(ChipPlaces& places) {
  const ViewPane& pane = places.layout().pane(SketchView);
  if (scene_.invites() && has_view(SketchView) && pane.visible() && !down()) {
    hint_->adjustSize();
    places.put(*hint_, QPointF(pane.rect.center().x() - hint_->width() / 2.0, pane.rect.bottom() - hint_height));
  } else {
    hint_->hide();
  }
  chips_.place(places, has_view(SketchView) && !down());
  readings_->place(pane, has_view(SketchView) && !down());
}

void SilhouetteTool::follow(Change change) {
  if (change != Change::Document && change != Change::Result) return;
  if (change == Change::Document) {
    if (!down()) tool_.set_node(studio().drawing_node());
    scene_.show_preview(tool_.preview());
  } else {
    scene_.show_result(studio());
    lines_ = lines_on_solids(studio());
  }
  scene_.show_drawing(studio(), tool_);
  emit changed(SketchView);
  chips_.follow();
}

// ---- The pen

void SilhouetteTool::feed(const std::vector<PenStep>& steps) {
  tool_.options().tube = mode_ == "tube" ? std::optional(tube_radius(tube_share_, host().viewport())) : std::nullopt;
  for (const PenStep& step : steps) feed(to_sketch(step, frame()));
  show_gesture();
}

void SilhouetteTool::feed(const SketchEvent& event) {
  if (tool_.handle(event) == Verdict::Commit && tool_.done()) emit committed(*tool_.done());
}

void SilhouetteTool::show_gesture() {
  // Nothing else changes under the pen: what is computed meanwhile is shown when the stroke has ended.
  studio().hold_results(inking());
  if (inking()) return emit changed(ink_alone);
  scene_.show_hovered(std::nullopt, studio().drawing());
  scene_.show_preview(tool_.preview());
  emit changed(SketchView);
}

void SilhouetteTool::hover(const PointerEvent& event) {
  if (event.action == PointerEvent::Action::Leave) return;
  under_pointer_ = sentences_at(scene_.finding_marks(), frame_of(host().views(), SketchView), event.position);
  if (tool_.mode() == SketchMode::Draw) return;
  const auto found =
      nearest_stroke(studio().drawing(), frame().to_sketch(event.position), {stroke_reach, frame().units_per_pixel});
  scene_.show_hovered(found ? std::optional(found->id) : std::nullopt, studio().drawing());
  emit changed(SketchView);
}

void SilhouetteTool::replay_gesture(const std::vector<StrokeSample>& samples, bool erases, const Modifiers& modifiers,
                                    double scale) {
  SketchEvent event;
  event.erases = erases;
  event.modifiers = modifiers;
  event.units_per_pixel = scale > 0 ? scale : frame().units_per_pixel;
  event.kind = PenStep::Kind::Begin;
  for (const StrokeSample& sample : samples) {
    event.sample = sample;
    feed(event);
    event.kind = PenStep::Kind::Sample;
  }
  event.kind = PenStep::Kind::End;
  feed(event);
  show_gesture();
}

// ---- Recordings

void SilhouetteTool::make_replays(Replays& replays) {
  replays.on<recorded::StrokeDrawn>([this](const recorded::StrokeDrawn& stroke) {
    if (!host().shows_views()) host().start_with();
    std::tie(tool_.options().tube, tool_.options().mirror) = std::tie(stroke.tube, stroke.mirror);
    replay_gesture(stroke.points, stroke.device == "eraser", {.shift = stroke.behind}, stroke.scale);
  });
  replays.on<recorded::StrokeReading>([this](const recorded::StrokeReading& step) { tool_.set(step); });
  replays.on<recorded::Drag>([this](const recorded::Drag& drag) { tool_.drag(drag.stroke, drag.anchor, drag.by); });
  replays.on<recorded::Click>([this](const recorded::Click& click) {
    if (!click.place) replay_gesture({sample_at(click.at)}, false, modifiers_of(click.modifiers), 0);
    return !click.place;
  });
  replays.on<recorded::Box>([this](const recorded::Box& box) {
    if (box.from_place) return false;
    replay_gesture({sample_at(box.from), sample_at((box.from + box.to) / 2), sample_at(box.to)}, false,
                   modifiers_of(box.modifiers), 0);
    return true;
  });
  add_counts(replays, studio(), tool_);
}

std::vector<ObjectRow> SilhouetteTool::rows(const WorkObject& object, NodeId node) {
  return rows_of(studio(), object, node,
                 [this, sketch = object.node](const std::string& stroke, const std::string& title) {
                   studio().set_active(sketch);
                   chips_.set({.stroke = stroke, .title = title});
                 });
}

QString SilhouetteTool::owner_of(const NodeFinding& found) const { return body_of(studio(), found); }

}  // namespace croquis::app

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tools/perspective/perspective_drawing_tool.h"

#include <QDockWidget>
#include <QScrollArea>
#include <algorithm>
#include <utility>

#include "app/views/viewport.h"
#include "app/window/panel_docks.h"
#include "croquis/tools/perspective/axis_guess.h"

namespace croquis::app {
namespace {

constexpr int sheet_panel_width = 330;
constexpr double framed_share = 0.4;      // of the sheet, at least, where strokes are looked at
constexpr double sheet_share = 0.66;      // of the views' width: the sheet, with its margin, gets more than half of it
constexpr double sheet_stroke_reach = 9;  // logical pixels
constexpr double guide_reach = 14;

PerspectiveMode sheet_mode(const QString& mode) {
  if (mode == "draw") return PerspectiveMode::Draw;
  return mode == "erase" ? PerspectiveMode::Erase : PerspectiveMode::Select;
}

std::shared_ptr<const SolvedDrawing> solved_by(const PerspectiveResult& result) {
  auto solved = std::make_shared<SolvedDrawing>();
  solved->camera = result.camera;
  solved->vanishing_points = result.vanishing_points;
  solved->network = result.network;
  for (const PerspectiveFace& face : result.faces) solved->faces.push_back(face.strokes.front());
  solved->open_strokes = result.open_strokes;
  return solved;
}

Vec2 to_sheet(const SketchFrame& frame, const Vec2& pixel) {
  const Vec2 place = frame.to_sketch(pixel);
  return {place.x(), -place.y()};
}

QString help_of(const Sheet& sheet) {
  const auto tr = [](const char* text) { return PerspectiveDrawingTool::tr(text); };
  if (sheet.picks == SheetPick::Point) return tr("Click the corner whose coordinates are known · Escape stops");
  if (sheet.picks == SheetPick::Length) return tr("Click the stroke whose length is known · Escape stops");
  if (sheet.entry->isVisible())
    return tr("Type a number, if you like with mm, cm, m or in · Enter takes it · Escape stops");
  if (sheet.proposal) return tr("Enter adds the mirrored strokes · Escape leaves them out");
  switch (sheet.tool.mode()) {
    case PerspectiveMode::Select:
      return tr(
          "Drag an end, a handle or a vanishing point · 1–6 give a group · Shift adds · Delete removes · D draws");
    case PerspectiveMode::Erase: return tr("Drag over strokes to erase them · D draws");
    case PerspectiveMode::Draw: break;
  }
  if (sheet.tool.role() == StrokeRole::Construction)
    return tr("Draw lines towards the vanishing points · 1 2 3 choose x y z, 0 by direction · E draws edges");
  return tr("Draw edges: 1 2 3 along x y z, 4 5 6 in planes, 0 by direction · C draws construction lines · Q selects");
}

/// A click beside any stroke chooses no length: the next one may.
void take_pick(Sheet& sheet, const Vec2& at, double reach) {
  if (sheet.picks == SheetPick::Point) {
    const auto end = nearest_end(sheet.drawing(), at, reach);
    pick(sheet, SheetPick::None);
    ask_point(sheet, end ? place_of(sheet.drawing(), *end) : at);
  } else if (const auto stroke = nearest_stroke(sheet.drawing(), at, reach)) {
    pick(sheet, SheetPick::None);
    ask_length(sheet, *stroke);
  }
}

}  // namespace

PerspectiveDrawingTool::PerspectiveDrawingTool(ToolHost& host)
    : Tool(host, "Drawings in perspective"), sheet_(*this, host), chips_(sheet_) {
  connect(sheet_.entry, &PenEntry::finished, this, &Tool::state_changed);
  connect(&chips_.alternatives(), &AlternativeChips::hovered_changed, this, [this] { emit changed(); });
  connect(&host.views(), &Views::look_through_changed, this, &Tool::state_changed);
}

void PerspectiveDrawingTool::make_panels(PanelDocks& docks) {
  panel_ = make_perspective_panel(sheet_);
  dock_ = docks.add(tr("Perspective"), scrolled(panel_), "perspective");
  docks.tabify("attributes", dock_);
  docks.set_useful(dock_, false);
  docks_ = &docks;
}

void PerspectiveDrawingTool::refresh() {
  refresh_sheet_actions(sheet_);
  docks_->show_tool_panel(dock_, sheet_.is_there(), sheet_panel_width);
  if (sheet_.is_there()) panel_->follow();
}

void PerspectiveDrawingTool::set_mode(const QString& mode) {
  Tool::set_mode(mode);
  sheet_.tool.set_mode(sheet_mode(mode));
  studio().hold_results(false);
  show_guides(std::nullopt);
  show_gesture();
  if (!sheet_.is_there()) return;
  follow_document();
  if (draws()) show_sketch_view(host().viewport());
}

// ---- How it stands

ViewUse PerspectiveDrawingTool::use_of(int view) const {
  ViewUse use{.cursor = draws() || sheet_.picks != SheetPick::None ? Qt::CrossCursor : Qt::ArrowCursor,
              .every_move = true};
  if (!has_view(view)) return use;
  use.works = draws() || mode_ == select_mode;
  use.bounds = sheet_.scene.bounds();
  use.paper = true;
  use.title = tr("Perspective drawing");
  if (use.works) {
    use.menu = {"group-z",      "group-normal-x", "group-x", "group-normal-z",
                "construction", "group-normal-y", "group-y", "group-auto"};
  }
  return use;
}

ToolWords PerspectiveDrawingTool::words() const {
  ToolWords words{.help = help_of(sheet_), .tooltip = under_pointer_};
  if (sheet_.is_there() && sheet_.result() != nullptr)
    words.status = solid_state(sheet_.drawing(), *sheet_.result(), sheet_.findings()).sentence;
  return words;
}

ToolState PerspectiveDrawingTool::state() const {
  const PerspectivePreview& preview = sheet_.tool.preview();
  if (inking()) return {.ink = Ink{SketchView, &preview.ink}};
  return {.beside_pointer = preview.moved ? axes_text(*preview.moved) + QStringLiteral(" px") : QString()};
}

// ---- The pointer

void PerspectiveDrawingTool::take(const PointerEvent& event) {
  const SketchFrame frame = host().viewport().pane(SketchView).sketch_frame();
  if (sheet_.picks != SheetPick::None && event.action == PointerEvent::Action::Press && event.buttons.left)
    return take_pick(sheet_, to_sheet(frame, event.position), 2 * sheet_stroke_reach * frame.units_per_pixel);
  Tool::take(event);
}

bool PerspectiveDrawingTool::abandon() {
  if (sheet_.picks != SheetPick::None) {
    pick(sheet_, SheetPick::None);
    return true;
  }
  if (Tool::abandon()) return true;
  if (!sheet_.proposal) return false;
  propose_mirror(sheet_, false);
  return true;
}

void PerspectiveDrawingTool::feed(const std::vector<PenStep>& steps) {
  for (const PenStep& step : steps) {
    const SketchFrame frame = host().viewport().pane(SketchView).sketch_frame();
    const Verdict verdict = sheet_.tool.handle(to_sketch(step, frame));
    if (sheet_.tool.done()) sheet_.record(verdict);
  }
  // Nothing else changes under the pen: what is computed meanwhile is shown when the stroke has ended.
  studio().hold_results(inking());
  if (inking()) return emit changed(ink_alone);
  show_gesture();
}

void PerspectiveDrawingTool::hover(const PointerEvent& event) {
  if (event.action == PointerEvent::Action::Leave) {
    show_guides(std::nullopt);
    return show_change();
  }
  under_pointer_ = sentences_at(sheet_.scene.marks(), frame_of(host().views(), SketchView), event.position);
  const SketchFrame frame = host().viewport().pane(SketchView).sketch_frame();
  const Vec2 at = to_sheet(frame, event.position);
  const PerspectiveDrawing& drawing = sheet_.drawing();
  if (sheet_.tool.mode() == PerspectiveMode::Draw) {
    const auto end = nearest_end(drawing, at, guide_reach * frame.units_per_pixel);
    show_guides(end ? place_of(drawing, *end) : at);
  } else {
    sheet_.scene.show_hovered(drawing, nearest_stroke(drawing, at, sheet_stroke_reach * frame.units_per_pixel));
  }
  show_change();
}

void PerspectiveDrawingTool::show_change() {
  emit changed(SketchView);
  if (sheet_.looks_through()) emit changed(PerspectiveView);
}

void PerspectiveDrawingTool::show_gesture() {
  sheet_.scene.show_hovered(sheet_.drawing(), std::nullopt);
  sheet_.scene.show_preview(sheet_.drawing(), sheet_.tool.preview());
  show_change();
}

void PerspectiveDrawingTool::show_guides(const std::optional<Vec2>& from) {
  sheet_.scene.show_guides(sheet_.drawing(), seen_vanishing_points(sheet_.drawing(), sheet_.tool.solved()), from);
}

void PerspectiveDrawingTool::add_all_to(Selection& selection) const {
  for (const PerspectiveStroke& stroke : sheet_.drawing().strokes)
    selection.push_back({studio().sheet_node(), stroke.id});
}

bool PerspectiveDrawingTool::command(EditCommand command) {
  if (command == EditCommand::Accept && sheet_.proposal) {
    complete_mirrored(sheet_);
    return true;
  }
  if (command != EditCommand::Delete || !sheet_.is_there()) return false;
  return sheet_.take(recorded::SheetDelete{sheet_.tool.selected()});
}

bool PerspectiveDrawingTool::show(const Target& target) {
  if (const auto* step = std::get_if<const Node*>(&target)) {
    if (!works_on(studio(), **step, ValueType::PerspectiveDrawing)) return false;
    if (!draws() && mode_ != select_mode) host().set_mode(select_mode);
    show_sketch_view(host().viewport());
    return true;
  }
  const auto* found = std::get_if<NodeFinding>(&target);
  if (found == nullptr || !sheet_.is_there() || found->node != sheet_.tool.operation_node()) return false;
  look_at_strokes(sheet_, strokes_of(found->finding));
  return true;
}

// ---- The views

void PerspectiveDrawingTool::adjust(ObjectScenes::Wanted& wanted, int view) const {
  if (has_view(view)) wanted.nothing = true;
}

void PerspectiveDrawingTool::add_to(render::Scene& scene, int view) {
  if (has_view(view)) {
    const double unit = host().viewport().pane(SketchView).sketch_frame().units_per_pixel;
    sheet_.scene.add_to(scene, sheet_.drawing(), unit);
  }
  chips_.alternatives().add_to(scene, has_view(view));
  const auto camera = view == PerspectiveView && sheet_.looks_through() ? looked_through(host().views()) : std::nullopt;
  if (!camera || sheet_.overlay == 0) return;
  const auto place = [&](const Vec2& sheet) { return camera->before_the_eye(sheet); };
  for (const render::LineItemPtr& item : stroke_items(sheet_.drawing(), place, sheet_.overlay))
    scene.lines.emplace_back(item);
}

/// Strokes are looked at with what is around them.
std::optional<SelectionFrame> PerspectiveDrawingTool::selection_frame(int view) const {
  render::Bounds bounds;
  for (const std::string& id : has_view(view) ? sheet_.tool.selected() : std::vector<std::string>()) {
    const PerspectiveStroke* stroke = find_stroke(sheet_.drawing(), id);
    if (stroke == nullptr || !is_drawable(*stroke)) continue;
    for (const Vec2& place : traced(stroke->pieces, stroke->straight)) bounds.add(on_sketch_plane(place));
  }
  const Vec2 around = framed_share * sheet_.drawing().image_size;
  return frame_around(bounds, glm::dvec3(around.x(), around.y(), 0));
}

void PerspectiveDrawingTool::place_chips(ChipPlaces& places) { chips_.place(places, sheet_.is_there() && !inking()); }

// ---- The flow

void PerspectiveDrawingTool::follow(Change change) {
  if (change == Change::Result) follow_result();
  if (change != Change::Document) return;
  const NodeId now = studio().sheet_node();
  if (std::exchange(shown_node_, now) != now) {
    host().views().layout.suggest_share(now == 0 ? even_share : sheet_share);
    // A drawing that is opened is seen through its own eye.
    if (now != 0) look_through(host().views(), now);
  }
  follow_document();
}

void PerspectiveDrawingTool::follow_document() {
  if (!down()) sheet_.tool.set_node(studio().sheet_node());
  if (!sheet_.is_there()) return;
  const PerspectiveDrawing& drawing = sheet_.drawing();
  sheet_.scene.show_drawing(drawing, sheet_.tool.selected(), sheet_.tool.mode() == PerspectiveMode::Select);
  sheet_.scene.show_preview(drawing, sheet_.tool.preview());
  propose_mirror(sheet_, false);
  follow_result();
}

void PerspectiveDrawingTool::follow_result() {
  if (!sheet_.is_there()) return;
  const NodeId node = sheet_.tool.operation_node();
  sheet_.shown = node == 0 ? nullptr : studio().result(node);
  const PerspectiveResult* found = sheet_.result();
  sheet_.tool.set_solved(found == nullptr ? nullptr : solved_by(*found));
  sheet_.scene.show_result(sheet_.drawing(), found, sheet_.findings());
  show_change();
}

}  // namespace croquis::app

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tools/perspective/perspective_drawing_tool.h"

#include <QAction>
#include <QDockWidget>
#include <QKeyEvent>
#include <QScrollArea>
#include <algorithm>
#include <utility>

#include "app/panels/finding_elements.h"
#include "app/replay/replays.h"
#include "app/tools/perspective/perspective_panel.h"
#include "app/views/viewport.h"
#include "app/window/panel_docks.h"
#include "croquis/tools/perspective/perspective_steps.h"
#include "croquis/tools/recording/general_steps.h"
#include "croquis/workspace/chain.h"

namespace croquis::app {
namespace {

constexpr int entry_width = 150;  // logical pixels
constexpr QPoint beside_pen(14, 12);
constexpr const char* entry_style =
    "QLineEdit { background: white; color: #1c1c1e; border: 2px solid %1; border-radius: 5px; padding: 3px 6px }";

constexpr double framed_share = 0.4;  // of the sheet, at least, where strokes are looked at
constexpr double sheet_share = 0.66;  // of the views' width: the sheet, with its margin, gets more than half of it

PerspectiveMode sheet_mode(const QString& mode) {
  if (mode == "draw") return PerspectiveMode::Draw;
  return mode == "erase" ? PerspectiveMode::Erase : PerspectiveMode::Select;
}

const PerspectiveResult& required_result(const SheetInteraction& sheet) {
  if (sheet.result() == nullptr) refuse_replay("Nothing was found in the drawing yet");
  return *sheet.result();
}

/// What replays can ask of a drawing.
void add_counts(Replays& replays, const SheetInteraction& sheet) {
  const auto add = [&](const char* name, auto count) {
    replays.counts[name] = [&sheet, count](const std::string&) {
      return static_cast<std::size_t>(count(required_result(sheet)));
    };
  };
  replays.counts["perspective-strokes"] = [&sheet](const std::string&) { return sheet.drawing().strokes.size(); };
  add("perspective-faces", [](const PerspectiveResult& result) { return result.faces.size(); });
  add("perspective-open", [](const PerspectiveResult& result) { return result.open_strokes.size(); });
  add("perspective-closed", [](const PerspectiveResult& result) { return result.closed; });
  add("perspective-mode", [](const PerspectiveResult& result) { return result.mode; });
  add("perspective-fixes", [](const PerspectiveResult& result) { return result.fixes.size(); });
  replays.ranges["perspective-residual"] = [&sheet](const std::string&) {
    std::pair<double, double> range(1e300, 0);
    for (const PerspectiveStrokeResult& stroke : required_result(sheet).strokes) {
      if (!stroke.residual) continue;
      range.first = std::min(range.first, *stroke.residual);
      range.second = std::max(range.second, *stroke.residual);
    }
    return range;
  };
}

}  // namespace

PenEntry::PenEntry(QWidget* views) : QLineEdit(views) {
  setObjectName("perspective-entry");
  setFixedWidth(entry_width);
  hide();
}

void PenEntry::ask(const QPointF& at, const QString& title, const QString& text, Take take) {
  take_ = std::move(take);
  setPlaceholderText(title);
  setToolTip(title);
  setAccessibleName(title);
  setText(text);
  show_wrong(false);
  adjustSize();
  const QRect room = parentWidget()->rect();
  const QPoint wanted = at.toPoint() + beside_pen;
  move(std::clamp(wanted.x(), 0, std::max(0, room.width() - width())),
       std::clamp(wanted.y(), 0, std::max(0, room.height() - height())));
  show();
  raise();
  setFocus(Qt::OtherFocusReason);
  selectAll();
}

void PenEntry::show_wrong(bool wrong) { setStyleSheet(QString(entry_style).arg(wrong ? "#d63c34" : "#f28c28")); }

/// No key is a menu's shortcut while something is typed.
bool PenEntry::event(QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride) {
    event->accept();
    return true;
  }
  return QLineEdit::event(event);
}

void PenEntry::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape) return close_entry();
  if (event->key() != Qt::Key_Return && event->key() != Qt::Key_Enter) {
    show_wrong(false);
    return QLineEdit::keyPressEvent(event);
  }
  if (take_ && !take_(text())) return show_wrong(true);
  close_entry();
}

void PenEntry::focusOutEvent(QFocusEvent* event) {
  QLineEdit::focusOutEvent(event);
  if (isVisible()) close_entry();
}

void PenEntry::close_entry() {
  take_ = nullptr;
  hide();
  parentWidget()->setFocus(Qt::OtherFocusReason);
  emit finished();
}

PerspectiveDrawingTool::PerspectiveDrawingTool(ToolHost& host)
    : Tool(host, "Drawings in perspective"),
      sheet_(host.studio(), host.viewport().pane(SketchView)),
      chips_(sheet_, &host.viewport()),
      entry_(new PenEntry(&host.viewport())) {
  connect(&sheet_, &SheetInteraction::changed, this, [this] {
    emit changed_in(SketchView);
    if (looks_through()) emit changed_in(PerspectiveView);
  });
  connect(&sheet_, &SheetInteraction::inked, this, &Tool::inked);
  connect(&sheet_, &SheetInteraction::committed, this, &Tool::committed);
  connect(&sheet_, &SheetInteraction::state_changed, this, [this] {
    refresh();
    emit state_changed();
  });
  connect(&sheet_, &SheetInteraction::point_picked, this, &PerspectiveDrawingTool::ask_point);
  connect(&sheet_, &SheetInteraction::length_picked, this, &PerspectiveDrawingTool::ask_length);
  connect(entry_, &PenEntry::finished, this, &Tool::state_changed);
  connect(&chips_.alternatives(), &AlternativeChips::hovered_changed, this, &Tool::changed);
  connect(&chips_.alternatives(), &AlternativeChips::wanted, this, &PerspectiveDrawingTool::take_alternative);
  connect(&chips_, &PerspectiveChips::fix_wanted, this, &PerspectiveDrawingTool::apply_fix);
  connect(&chips_, &PerspectiveChips::mirror_wanted, this, &PerspectiveDrawingTool::complete_mirrored);
  connect(&chips_, &PerspectiveChips::strokes_wanted, this, &PerspectiveDrawingTool::look_at_strokes);
  connect(&chips_, &PerspectiveChips::look_through_wanted, this, &PerspectiveDrawingTool::set_looking_through);
  connect(&host.viewport(), &Viewport::look_through_changed, this, &Tool::state_changed);
}

void PerspectiveDrawingTool::make_panels(PanelDocks& docks) {
  PerspectivePanelHost needs;
  needs.action = [this](const QString& name) { return host().action(name); };
  needs.take = [this](const recorded::Step& step) { do_and_record(step); };
  needs.set_parameter = [this](const std::string& name, const ParameterValue& value) { set_parameter(name, value); };
  needs.choose = [this](const std::string& stroke) {
    if (mode() != select_mode) host().set_mode(select_mode);
    sheet_.tool().select({stroke});
  };
  needs.overlay = [this](double opacity) {
    overlay_ = opacity;
    emit changed_in(PerspectiveView);
  };
  panel_ = make_perspective_panel(sheet_, needs);
  dock_ = docks.add(tr("Perspective"), scrolled(panel_), "perspective");
  docks.set_useful(dock_, false);
  docks_ = &docks;
}

bool PerspectiveDrawingTool::do_and_record(const recorded::Step& step) {
  const bool done = sheet_.tool().take(step) == Verdict::Commit;
  if (done) emit committed(*sheet_.tool().done());
  return done;
}

void PerspectiveDrawingTool::set_mode(const QString& mode) {
  Tool::set_mode(mode);
  sheet_.set_mode(sheet_mode(mode));
  if (studio().sheet_node() == 0) return;
  sheet_.follow_document();
  Viewport& views = host().viewport();
  if (draws() && !views.pane(SketchView).visible()) views.arrange(Arrangement::SketchAndSolid);
}

bool PerspectiveDrawingTool::works_in(int view) const { return has_view(view) && (draws() || mode() == select_mode); }

ViewUse PerspectiveDrawingTool::use_of(int view) const {
  const bool aims = draws() || sheet_.picks() != SheetInteraction::Pick::None;
  return {aims ? Qt::CrossCursor : Qt::ArrowCursor, true, has_view(view),
          has_view(view) ? tr("Perspective drawing") : QString()};
}

bool PerspectiveDrawingTool::abandon() {
  if (sheet_.abandon()) return true;
  if (!sheet_.proposal()) return false;
  sheet_.propose_mirror(false);
  return true;
}

void PerspectiveDrawingTool::add_all_to(Selection& selection) const {
  for (const PerspectiveStroke& stroke : sheet_.drawing().strokes)
    selection.push_back({studio().sheet_node(), stroke.id});
}

bool PerspectiveDrawingTool::command(EditCommand command) {
  if (command == EditCommand::Accept && sheet_.proposal()) {
    complete_mirrored();
    return true;
  }
  if (command != EditCommand::Delete || studio().sheet_node() == 0) return false;
  return do_and_record(recorded::SheetDelete{sheet_.tool().selected()});
}

bool PerspectiveDrawingTool::open_step(const Node& step) {
  const OperationDescription* operation = studio().description(step.operation);
  const PortDescription* input = operation == nullptr ? nullptr : main_input(*operation);
  const bool is_sheet = source_of<PerspectiveDrawing>(&step) != nullptr;
  if (!is_sheet && (input == nullptr || input->type != ValueType::PerspectiveDrawing)) return false;
  if (!draws() && mode() != select_mode) host().set_mode(select_mode);
  Viewport& views = host().viewport();
  if (!views.pane(SketchView).visible()) views.arrange(Arrangement::SketchAndSolid);
  return true;
}

QString PerspectiveDrawingTool::help() const {
  if (sheet_.picks() == SheetInteraction::Pick::Point)
    return tr("Click the corner whose coordinates are known · Escape stops");
  if (sheet_.picks() == SheetInteraction::Pick::Length)
    return tr("Click the stroke whose length is known · Escape stops");
  if (entry_->isVisible()) return tr("Type a number, if you like with mm, cm, m or in · Enter takes it · Escape stops");
  if (sheet_.proposal()) return tr("Enter adds the mirrored strokes · Escape leaves them out");
  switch (sheet_.tool().mode()) {
    case PerspectiveMode::Select:
      return tr(
          "Drag an end, a handle or a vanishing point · 1–6 give a group · Shift adds · Delete removes · D draws");
    case PerspectiveMode::Erase: return tr("Drag over strokes to erase them · D draws");
    case PerspectiveMode::Draw: break;
  }
  if (sheet_.tool().role() == StrokeRole::Construction)
    return tr("Draw lines towards the vanishing points · 1 2 3 choose x y z, 0 by direction · E draws edges");
  return tr("Draw edges: 1 2 3 along x y z, 4 5 6 in planes, 0 by direction · C draws construction lines · Q selects");
}

void PerspectiveDrawingTool::adjust(ObjectScenes::Wanted& wanted, int view) const {
  if (has_view(view)) wanted.nothing = true;
}

void PerspectiveDrawingTool::add_to(render::Scene& scene, int view) {
  if (has_view(view)) {
    const render::Scene sheet = sheet_.scene();
    scene.lines.insert(scene.lines.end(), sheet.lines.begin(), sheet.lines.end());
    scene.marks.insert(scene.marks.end(), sheet.marks.begin(), sheet.marks.end());
  }
  add_alternative_to(scene, view);
  const auto camera = view == PerspectiveView && looks_through() ? host().viewport().looked_through() : std::nullopt;
  if (!camera || overlay_ == 0) return;
  const auto place = [&](const Vec2& sheet) { return camera->before_the_eye(sheet); };
  for (const render::LineItemPtr& item : stroke_items(sheet_.drawing(), place, overlay_))
    scene.lines.emplace_back(item);
}

std::optional<Ink> PerspectiveDrawingTool::ink() const {
  if (!sheet_.inking()) return std::nullopt;
  return Ink{SketchView, &sheet_.ink()};
}

render::Bounds PerspectiveDrawingTool::bounds_in(int view) const {
  return has_view(view) ? sheet_.bounds() : render::Bounds();
}

// ---- Looking through

bool PerspectiveDrawingTool::looks_through() const {
  const NodeId sheet = studio().sheet_node();
  return sheet != 0 && host().viewport().look_through_node() == sheet && sheet_.result() != nullptr;
}

void PerspectiveDrawingTool::set_looking_through(bool on) {
  host().viewport().look_through(on ? studio().sheet_node() : 0);
}

void PerspectiveDrawingTool::place_chips(ChipPlaces& places) {
  chips_.place(places, studio().sheet_node() != 0 && !sheet_.inking(), looks_through());
}

// ---- The flow

void PerspectiveDrawingTool::follow(Change change) {
  if (change == Change::Result) sheet_.follow_result();
  if (change != Change::Document) return;
  const NodeId now = studio().sheet_node();
  if (std::exchange(shown_node_, now) != now) {
    host().viewport().suggest_share(now == 0 ? even_share : sheet_share);
    // A drawing that is opened is seen through its own eye.
    if (now != 0) host().viewport().look_through(now);
  }
  sheet_.follow_document();
}

bool PerspectiveDrawingTool::show_finding(const NodeFinding& found) {
  if (studio().sheet_node() == 0 || found.node != sheet_.tool().operation_node()) return false;
  look_at_strokes(strokes_of(found.finding));
  return true;
}

void PerspectiveDrawingTool::look_at_strokes(const std::vector<std::string>& strokes) {
  if (strokes.empty()) return;
  if (mode() != select_mode) host().set_mode(select_mode);
  sheet_.tool().select(strokes);
  if (has_view(SketchView)) host().viewport().frame_selection_in(SketchView);
}

/// Strokes are looked at with what is around them.
std::optional<SelectionFrame> PerspectiveDrawingTool::selection_frame(int view) const {
  const std::vector<std::string> ids = sheet_.tool().selected();
  if (!has_view(view) || ids.empty()) return std::nullopt;
  SelectionFrame frame;
  for (const std::string& id : ids) {
    const PerspectiveStroke* stroke = find_stroke(sheet_.drawing(), id);
    if (stroke == nullptr || !is_drawable(*stroke)) continue;
    for (const Vec2& place : traced(stroke->pieces, stroke->straight)) frame.bounds.add(on_sketch_plane(place));
  }
  if (frame.bounds.empty()) return std::nullopt;
  const glm::dvec3 middle = frame.bounds.center();
  const Vec2 around = framed_share * sheet_.drawing().image_size / 2;
  frame.bounds.add(middle - glm::dvec3(around.x(), around.y(), 0));
  frame.bounds.add(middle + glm::dvec3(around.x(), around.y(), 0));
  return frame;
}

QString PerspectiveDrawingTool::status() const {
  if (studio().sheet_node() == 0 || sheet_.result() == nullptr) return {};
  return solid_state(sheet_.drawing(), *sheet_.result(), sheet_.findings()).sentence;
}

// Recorded steps of perspective drawings, and what replays can expect of them.

void PerspectiveDrawingTool::make_replays(Replays& replays) {
  for (const recorded::StepKind* kind : recorded::perspective_steps().kinds()) {
    replays.plays[kind].push_back([this](const recorded::Step& step) {
      if (studio().sheet_node() == 0) host().action("new-perspective")->trigger();  // the first one begins a drawing
      sheet_.tool().take(step);
      return true;
    });
  }
  add_counts(replays, sheet_);
}

}  // namespace croquis::app

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tools/perspective/sheet.h"

#include <QKeyEvent>
#include <algorithm>
#include <utility>

#include "app/replay/replays.h"
#include "app/tools/perspective/perspective_chips.h"
#include "app/views/viewport.h"
#include "croquis/tools/perspective/perspective_steps.h"

namespace croquis::app {
namespace {

constexpr int entry_width = 150;  // logical pixels
constexpr QPoint beside_pen(14, 12);
constexpr const char* entry_style =
    "QLineEdit { background: white; color: #1c1c1e; border: 2px solid %1; border-radius: 5px; padding: 3px 6px }";

const PerspectiveResult& required_result(const Sheet& sheet) {
  if (sheet.result() == nullptr) refuse_replay("Nothing was found in the drawing yet");
  return *sheet.result();
}

void add_counts(Replays& replays, const Sheet& sheet) {
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
  const QRect views = parentWidget()->rect();
  const QPoint wanted = at.toPoint() + beside_pen;
  move(std::clamp(wanted.x(), 0, std::max(0, views.width() - width())),
       std::clamp(wanted.y(), 0, std::max(0, views.height() - height())));
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

Sheet::Sheet(Tool& tool_of_window, ToolHost& window)
    : owner(tool_of_window),
      host(window),
      tool(window.studio().session(), window.studio().sheet_options()),
      entry(new PenEntry(&window.viewport())) {}

const PerspectiveDrawing& Sheet::drawing() const {
  static const PerspectiveDrawing none;
  const auto drawing =
      source_of<PerspectiveDrawing>(host.studio().session().document().find(host.studio().sheet_node()));
  return drawing ? *drawing : none;
}

bool Sheet::record(Verdict verdict) const {
  if (verdict == Verdict::Commit) emit owner.committed(*tool.done());
  return verdict == Verdict::Commit;
}

bool Sheet::selects() const { return host.views().mode == select_mode; }

bool Sheet::looks_through() const {
  return is_there() && host.views().through == host.studio().sheet_node() && result() != nullptr;
}

void pick(Sheet& sheet, SheetPick wanted) {
  sheet.picks = wanted;
  sheet.owner.refresh();
  emit sheet.owner.state_changed();
}

void look_at_strokes(Sheet& sheet, const std::vector<std::string>& strokes) {
  if (strokes.empty()) return;
  if (!sheet.selects()) sheet.host.set_mode(select_mode);
  sheet.tool.select(strokes);
  if (sheet.is_there()) frame_selection_in(sheet.host.views(), SketchView);
}

void look_through(Sheet& sheet, bool on) {
  look_through(sheet.host.views(), on ? sheet.host.studio().sheet_node() : 0);
}

void apply_fix(Sheet& sheet) {
  if (sheet.result() == nullptr || sheet.result()->fixes.empty()) return;
  const ProposedFix fix = sheet.result()->fixes.front();
  StrokeSetting setting;
  setting.group = fix.group;
  sheet.host.attempt([&] { sheet.take(recorded::SheetSetting{{fix.stroke}, setting}); });
}

void propose_mirror(Sheet& sheet, bool wanted) {
  sheet.proposal.reset();
  if (wanted && sheet.tool.solved() != nullptr)
    sheet.proposal = croquis::propose_mirror(sheet.drawing(), *sheet.tool.solved());
  sheet.scene.show_proposed(sheet.proposal ? sheet.proposal->strokes : std::vector<PerspectiveStroke>());
  emit sheet.owner.changed(SketchView);
}

void complete_mirrored(Sheet& sheet) {
  if (!sheet.proposal) return;
  const MirrorPlane plane = sheet.proposal->plane;
  sheet.host.attempt([&] { sheet.take(recorded::SheetMirror{plane, {}}); });
}

void add_sheet_replays(Replays& replays, Sheet& sheet) {
  for (const recorded::StepKind* kind : recorded::perspective_steps().kinds()) {
    replays.plays[kind].push_back([&sheet](const recorded::Step& step) {
      if (!sheet.is_there()) sheet.host.action("new-perspective")->trigger();  // the first one begins a drawing
      sheet.tool.take(step);
      return true;
    });
  }
  add_counts(replays, sheet);
}

}  // namespace croquis::app

// SPDX-License-Identifier: GPL-3.0-or-later
// Actions of drawings in perspective: what menus, keys and buttons do.
#include <QActionGroup>
#include <QPainter>
#include <QPixmap>
#include <algorithm>
#include <array>

#include "app/panels/number_box.h"
#include "app/tools/action_rows.h"
#include "app/tools/perspective/sheet.h"
#include "app/views/marking_menu.h"
#include "app/views/viewport.h"
#include "app/window/theme.h"
#include "croquis/tools/perspective/sheet_units.h"

namespace croquis::app {
namespace {

constexpr std::array<const char*, 6> group_actions{"group-x",        "group-y",        "group-z",
                                                   "group-normal-x", "group-normal-y", "group-normal-z"};

QIcon group_icon(StrokeGroup group) {
  QPixmap picture(16, 16);
  picture.fill(Qt::transparent);
  QPainter painter(&picture);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setBrush(group_color(group));
  painter.setPen(QPen(colors::guide, 1));  // differs from light and dark menus
  if (is_parallel(group))
    painter.drawEllipse(2, 2, 12, 12);
  else
    painter.drawRect(2, 2, 12, 12);
  return picture;
}

std::string face_of(const std::vector<std::string>& strokes) {
  std::string face;
  for (const std::string& stroke : strokes) face += (face.empty() ? "" : "+") + stroke;
  return face;
}

QString number(double value) { return number_words(value, 6); }

QString with_unit(const QString& title, const std::string& unit) {
  return unit.empty() ? title : title + " (" + QString::fromStdString(unit) + ")";
}

void set_selected(Sheet& sheet, const StrokeSetting& setting) {
  sheet.take(recorded::SheetSetting{sheet.tool.selected(), setting});
}

const PerspectiveStroke* first_selected(const Sheet& sheet) {
  const std::vector<std::string> ids = sheet.tool.selected();
  return ids.empty() ? nullptr : find_stroke(sheet.drawing(), ids.front());
}

/// Of what is drawn next, or of what is selected.
void choose_group(Sheet& sheet, std::optional<StrokeGroup> group) {
  if (group && sheet.selects() && !sheet.tool.selected().empty()) {
    StrokeSetting setting;
    setting.group = group;
    set_selected(sheet, setting);
  } else {
    sheet.tool.set_group(group);
  }
  sheet.owner.refresh();
  emit sheet.owner.state_changed();
}

/// The same for edges and construction lines.
void choose_role(Sheet& sheet, StrokeRole role) {
  sheet.tool.set_role(role);
  StrokeSetting setting;
  setting.role = role;
  if (sheet.selects() && !sheet.tool.selected().empty()) set_selected(sheet, setting);
  emit sheet.owner.state_changed();
}

void hide_or_show(Sheet& sheet) {
  const PerspectiveStroke* first = first_selected(sheet);
  StrokeSetting setting;
  setting.set(&PerspectiveStroke::hidden, first == nullptr || !first->hidden);
  set_selected(sheet, setting);
}

void tie_or_untie(Sheet& sheet) {
  const PerspectiveStroke* first = first_selected(sheet);
  StrokeSetting setting;
  setting.set(&PerspectiveStroke::link, first == nullptr || !first->link);
  setting.role = StrokeRole::Construction;
  set_selected(sheet, setting);
}

template <EndLock Lock>
void lock_ends(Sheet& sheet) {
  StrokeSetting setting;
  setting.set(&PerspectiveStroke::start_lock, Lock);
  setting.set(&PerspectiveStroke::end_lock, Lock);
  set_selected(sheet, setting);
}

void toggle_sharp(Sheet& sheet) {
  for (const std::string& id : sheet.tool.selected())
    sheet.take(recorded::SheetChoice{"sharp", id, !sheet.tool.is_chosen("sharp", id)});
}

/// Puts the face between the selected strokes on a list of the operation, or takes it off.
void toggle_face(Sheet& sheet, const std::string& list) {
  const std::string face = face_of(sheet.tool.selected());
  sheet.take(recorded::SheetChoice{list, face, !sheet.tool.is_chosen(list, face)});
}

/// Of the stroke that is selected, else of the one that is clicked next.
void begin_known_length(Sheet& sheet) {
  const std::vector<std::string> ids = sheet.tool.selected();
  ids.size() == 1 ? ask_length(sheet, ids.front()) : pick(sheet, SheetPick::Length);
}

void propose_or_complete_mirror(Sheet& sheet) {
  if (sheet.proposal) return complete_mirrored(sheet);
  propose_mirror(sheet, true);
  if (!sheet.proposal) sheet.host.say(QObject::tr("No half is found that a mirror would complete"));
  emit sheet.owner.state_changed();
}

void begin_new(ToolHost& host) {
  const PerspectiveToolOptions options = host.studio().sheet_options();
  if (!host.start_with(add_perspective_drawing(Document(), empty_sheet(options.sheet), options))) return;
  host.views().layout.arrange(Arrangement::SketchAndSolid);
  frame_all(host.views());
}

void add_group_actions(Sheet& sheet, ActionList& actions, QMenu* menu) {
  auto* choice = new QActionGroup(menu);
  const auto add_group = [&](const QString& name, std::optional<StrokeGroup> group) {
    QAction* action = actions.add(
        menu, name, group ? group_title(*group) : QObject::tr("By where it points"), {},
        [&sheet, group] { choose_group(sheet, group); }, Recorded::ByItself);
    action->setCheckable(true);
    action->setIconText(group ? group_words(*group) : QObject::tr("Auto"));
    if (group) action->setIcon(group_icon(*group));
    set_sector_color(*action, group ? group_color(*group) : QColor(70, 74, 82));
    choice->addAction(action);
  };
  add_group("group-auto", std::nullopt);
  for (std::size_t i = 0; i < group_actions.size(); ++i) add_group(group_actions[i], static_cast<StrokeGroup>(i));
  const auto take_role = [&sheet](bool on) { choose_role(sheet, on ? StrokeRole::Construction : StrokeRole::Edge); };
  QAction* construction =
      add_toggle(actions, menu, "construction", QObject::tr("Construction lines"), {}, take_role, Recorded::ByItself);
  construction->setIconText(QObject::tr("Guides"));
  set_sector_color(*construction, QColor(150, 156, 166));
}

/// Actions of what is selected.
std::vector<ActionRow> stroke_actions(Sheet& sheet) {
  const auto tr = [](const char* text) { return QObject::tr(text); };
  const auto run = [&sheet](auto work) { return [&sheet, work] { sheet.host.attempt([&] { work(sheet); }); }; };
  return {{},
          {"stroke-hidden", tr("Hidden edge"), {}, run(hide_or_show)},
          {"stroke-link", tr("Link pieces by a construction line"), {}, run(tie_or_untie)},
          {"ends-smooth", tr("Ends go on smoothly"), {}, run(lock_ends<EndLock::Smooth>)},
          {"ends-corner", tr("Ends are corners"), {}, run(lock_ends<EndLock::Corner>)},
          {"ends-free", tr("Ends as they are drawn"), {}, run(lock_ends<EndLock::None>)},
          {"edge-sharp", tr("Sharp edge between faces"), {}, run(toggle_sharp)},
          {},
          {"known-point",
           tr("Known point: click it and type its coordinates"),
           {},
           [&sheet] { sheet.host.attempt([&] { pick(sheet, SheetPick::Point); }); }},
          {"known-length", tr("Known length of a stroke"), {}, run(begin_known_length)},
          {},
          {"add-face",
           tr("Add the face between the selected strokes"),
           {},
           [&sheet] { sheet.host.attempt([&] { toggle_face(sheet, "faces"); }); }},
          {"forbid-face",
           tr("No face between the selected strokes"),
           {},
           [&sheet] { sheet.host.attempt([&] { toggle_face(sheet, "no-faces"); }); }},
          {"perspective-fix", tr("Make the first proposed fix"), {}, run(apply_fix)},
          {"mirror", tr("Complete by mirror"), {}, run(propose_or_complete_mirror)},
          {}};
}

/// Over the sheet.
void add_keys(Sheet& sheet, ToolKeys& keys) {
  keys.marking_menu = Qt::Key_G;
  const auto set_construction = [&sheet](bool on) {
    QAction* construction = sheet.host.action("construction");
    if (construction->isChecked() != on) construction->trigger();
  };
  keys.pressed[Qt::Key_C] = [set_construction] { set_construction(true); };
  keys.pressed[Qt::Key_E] = [set_construction] { set_construction(false); };
  keys.pressed[Qt::Key_K] = [&sheet] { sheet.host.action("known-point")->trigger(); };
  keys.pressed[Qt::Key_L] = [&sheet] { sheet.host.action("known-length")->trigger(); };
  keys.pressed[Qt::Key_0] = [&sheet] { choose_group(sheet, std::nullopt); };
  for (int i = 0; i < static_cast<int>(group_actions.size()); ++i)
    keys.pressed[Qt::Key_1 + i] = [&sheet, i] { choose_group(sheet, static_cast<StrokeGroup>(i)); };
}

}  // namespace

void add_sheet_actions(Sheet& sheet, ActionList& actions, ToolKeys& keys) {
  QMenu* file = actions.menu(MenuId::File);
  QAction* fresh = actions.add(file, "new-perspective", QObject::tr("New perspective drawing"), {},
                               [&sheet] { begin_new(sheet.host); });
  file->insertAction(actions.find("open"), fresh);
  QMenu* menu = actions.menu(MenuId::Perspective);
  add_group_actions(sheet, actions, menu);
  add_rows(actions, menu, stroke_actions(sheet));
  add_toggle(actions, menu, "look-through", QObject::tr("Look through the drawing"), {QKeySequence("V")},
             [&sheet](bool on) { look_through(sheet, on); });
  add_keys(sheet, keys);
}

void refresh_sheet_actions(const Sheet& sheet) {
  ToolHost& host = sheet.host;
  const bool here = sheet.is_there();
  const bool any = here && !sheet.tool.selected().empty();
  const PerspectiveResult* result = here ? sheet.result() : nullptr;
  const auto enable = [&host](const QString& name, bool on) { host.action(name)->setEnabled(on); };
  for (const char* name : group_actions) enable(name, here);
  for (const char* name : {"group-auto", "construction", "known-point"}) enable(name, here);
  enable("known-length", here && !sheet.drawing().strokes.empty());
  for (const char* name : {"stroke-hidden", "stroke-link", "ends-smooth", "ends-corner", "ends-free", "edge-sharp",
                           "add-face", "forbid-face"})
    enable(name, any);
  enable("perspective-fix", result != nullptr && !result->fixes.empty());
  enable("mirror", result != nullptr);
  enable("look-through", result != nullptr);
  host.action("look-through")->setChecked(sheet.looks_through());
  host.action("construction")->setChecked(sheet.tool.role() == StrokeRole::Construction);
  const auto& group = sheet.tool.group();
  host.action(group ? group_actions[static_cast<std::size_t>(*group)] : "group-auto")->setChecked(true);
}

QPointF widget_place(const Sheet& sheet, const Vec2& at) {
  return sketch_to_widget(sheet.host.views(), {at.x(), -at.y()});
}

void ask_point(Sheet& sheet, const Vec2& at) {
  const auto& known = sheet.drawing().known_point;
  const Vec3 point = known ? known->point : Vec3(Vec3::Zero());
  const QString text = number(point.x()) + ' ' + number(point.y()) + ' ' + number(point.z());
  const QString title = with_unit(QObject::tr("x y z"), sheet.drawing().unit);
  sheet.entry->ask(widget_place(sheet, at), title, text, [&sheet, at](const QString& typed) {
    const auto read = read_point(typed.toStdString(), sheet.drawing().unit);
    if (!read) return false;
    return sheet.host.attempt([&] { sheet.take(recorded::SheetPoint{KnownPoint{at, *read}}); });
  });
  emit sheet.owner.state_changed();
}

/// An empty field forgets the length.
void ask_length(Sheet& sheet, const std::string& stroke) {
  const PerspectiveStroke* drawn = find_stroke(sheet.drawing(), stroke);
  if (drawn == nullptr) return;
  sheet.tool.select({stroke});
  QString text;
  for (const KnownLength& known : sheet.drawing().known_lengths) {
    if (known.stroke == stroke) text = number(known.length);
  }
  const QString title =
      with_unit(QObject::tr("Length of %1").arg(QString::fromStdString(stroke)), sheet.drawing().unit);
  sheet.entry->ask(widget_place(sheet, middle_of_stroke(*drawn)), title, text, [&sheet, stroke](const QString& typed) {
    const auto read = read_length(typed.toStdString(), sheet.drawing().unit);
    if (!read && !typed.trimmed().isEmpty()) return false;
    return sheet.host.attempt([&] { sheet.take(recorded::SheetLength{stroke, read}); });
  });
  emit sheet.owner.state_changed();
}

}  // namespace croquis::app

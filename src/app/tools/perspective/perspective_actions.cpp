// SPDX-License-Identifier: GPL-3.0-or-later
// Actions of the perspective tool: what menus, keys and buttons do.
#include <QAction>
#include <QActionGroup>
#include <QMenu>
#include <QPainter>
#include <QPixmap>
#include <algorithm>
#include <array>

#include "app/tools/perspective/group_looks.h"
#include "app/tools/perspective/perspective_drawing_tool.h"
#include "app/tools/perspective/perspective_panel.h"
#include "app/views/marking_menu.h"
#include "app/views/viewport.h"
#include "app/window/action_list.h"
#include "app/window/panel_docks.h"

namespace croquis::app {
namespace {

constexpr std::array<const char*, 6> group_actions{"group-x",        "group-y",        "group-z",
                                                   "group-normal-x", "group-normal-y", "group-normal-z"};

constexpr int panel_width = 330;

QIcon group_icon(StrokeGroup group) {
  QPixmap picture(16, 16);
  picture.fill(Qt::transparent);
  QPainter painter(&picture);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setBrush(group_color(group));
  painter.setPen(QPen(QColor(20, 20, 22), 1));
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

}  // namespace

void PerspectiveDrawingTool::make_actions(ActionList& actions) {
  QMenu* file = actions.menu(tr("&File"));
  QAction* fresh = actions.add(file, "new-perspective", tr("New &perspective drawing"), {}, [this] { begin_new(); });
  file->insertAction(actions.find("open"), fresh);
  make_group_actions(actions);
  make_stroke_actions(actions);
}

void PerspectiveDrawingTool::make_group_actions(ActionList& actions) {
  QMenu* menu = actions.menu(tr("&Perspective"));
  auto* choice = new QActionGroup(menu);
  const auto add_group = [&](const QString& name, std::optional<StrokeGroup> group) {
    QAction* action = actions.add(
        menu, name, group ? group_title(*group) : tr("By where it points"), {}, [this, group] { choose_group(group); },
        Recorded::ByItself);
    action->setCheckable(true);
    action->setIconText(group ? group_words(*group) : tr("Auto"));
    if (group) action->setIcon(group_icon(*group));
    set_sector_color(*action, group ? group_color(*group) : QColor(70, 74, 82));
    choice->addAction(action);
  };
  add_group("group-auto", std::nullopt);
  for (std::size_t i = 0; i < group_actions.size(); ++i) add_group(group_actions[i], static_cast<StrokeGroup>(i));
  QAction* construction = actions.add(
      menu, "construction", tr("&Construction lines"), {},
      [this] {
        const bool on = host().action("construction")->isChecked();
        sheet_.tool().set_role(on ? StrokeRole::Construction : StrokeRole::Edge);
        const std::vector<std::string> ids = sheet_.tool().selected();
        StrokeSetting setting;
        setting.role = sheet_.tool().role();
        if (mode() == select_mode && !ids.empty()) do_and_record(sheet_.tool().set(ids, setting));
        emit state_changed();
      },
      Recorded::ByItself);
  construction->setCheckable(true);
  construction->setIconText(tr("Guides"));
  set_sector_color(*construction, QColor(150, 156, 166));
}

void PerspectiveDrawingTool::make_stroke_actions(ActionList& actions) {
  QMenu* menu = actions.menu(tr("&Perspective"));
  menu->addSeparator();
  const auto add = [&](const QString& name, const QString& text, std::function<void()> work) {
    actions.add(
        menu, name, text, {}, [this, work = std::move(work)] { host().attempt(work); }, Recorded::ByItself);
  };
  const auto set_selected = [this](const StrokeSetting& setting) {
    do_and_record(sheet_.tool().set(sheet_.tool().selected(), setting));
  };
  add("stroke-hidden", tr("&Hidden edge, or seen again"), [this, set_selected] {
    const std::vector<std::string> ids = sheet_.tool().selected();
    const PerspectiveStroke* first = ids.empty() ? nullptr : find_stroke(sheet_.drawing(), ids.front());
    StrokeSetting setting;
    setting.hidden = first == nullptr || !first->hidden;
    set_selected(setting);
  });
  add("stroke-link", tr("&Tie pieces together by a construction line, or no more"), [this, set_selected] {
    const std::vector<std::string> ids = sheet_.tool().selected();
    const PerspectiveStroke* first = ids.empty() ? nullptr : find_stroke(sheet_.drawing(), ids.front());
    StrokeSetting setting;
    setting.link = first == nullptr || !first->link;
    setting.role = StrokeRole::Construction;
    set_selected(setting);
  });
  const auto add_lock = [&](const QString& name, const QString& text, EndLock lock) {
    add(name, text, [lock, set_selected] {
      StrokeSetting setting;
      setting.start_lock = setting.end_lock = lock;
      set_selected(setting);
    });
  };
  add_lock("ends-smooth", tr("Ends go on &smoothly"), EndLock::Smooth);
  add_lock("ends-corner", tr("Ends are &corners"), EndLock::Corner);
  add_lock("ends-free", tr("Ends as they are &drawn"), EndLock::None);
  add("edge-sharp", tr("Faces meet &sharply there, or smoothly again"), [this] { toggle_sharp(); });
  menu->addSeparator();
  add("known-point", tr("&Known point: click it and type its coordinates"),
      [this] { sheet_.pick(SheetInteraction::Pick::Point); });
  add("known-length", tr("Known &length of a stroke"), [this] { begin_known_length(); });
  menu->addSeparator();
  add("add-face", tr("&Add the face between the selected strokes"), [this] { set_face(true); });
  add("forbid-face", tr("&No face between the selected strokes"), [this] { set_face(false); });
  add("perspective-fix", tr("Make the first proposed &fix"), [this] { apply_fix(); });
  add("mirror", tr("Complete by &mirror"), [this] {
    if (sheet_.proposal()) return complete_mirrored();
    sheet_.propose_mirror(true);
    if (!sheet_.proposal()) host().tell(tr("No half is found that a mirror would complete"));
    emit state_changed();
  });
  menu->addSeparator();
  QAction* through = actions.add(menu, "look-through", tr("&Look through the drawing"), {QKeySequence("V")},
                                 [this] { set_looking_through(host().action("look-through")->isChecked()); });
  through->setCheckable(true);
}

void PerspectiveDrawingTool::begin_new() {
  const PerspectiveToolOptions options = studio().sheet_options();
  if (!host().start_with(add_perspective_drawing(Document(), empty_sheet(options.sheet), options))) return;
  host().viewport().arrange(Arrangement::SketchAndSolid);
  host().viewport().frame_all();
}

void PerspectiveDrawingTool::refresh() {
  const bool here = studio().sheet_node() != 0;
  const bool any = here && !sheet_.tool().selected().empty();
  const PerspectiveResult* result = here ? sheet_.result() : nullptr;
  const auto enable = [this](const QString& name, bool on) { host().action(name)->setEnabled(on); };
  enable("group-auto", here);
  for (const char* name : group_actions) enable(name, here);
  enable("construction", here);
  enable("known-point", here);
  enable("known-length", here && !sheet_.drawing().strokes.empty());
  for (const char* name : {"stroke-hidden", "stroke-link", "ends-smooth", "ends-corner", "ends-free", "edge-sharp",
                           "add-face", "forbid-face"})
    enable(name, any);
  enable("perspective-fix", result != nullptr && !result->fixes.empty());
  enable("mirror", result != nullptr);
  enable("look-through", result != nullptr);
  host().action("look-through")->setChecked(looks_through());
  host().action("construction")->setChecked(sheet_.tool().role() == StrokeRole::Construction);
  const auto& group = sheet_.tool().group();
  host().action(group ? group_actions[static_cast<std::size_t>(*group)] : "group-auto")->setChecked(true);
  docks_->set_useful(dock_, here);
  if (!here) return;
  docks_->give_room_once(dock_, panel_width);
  panel_->follow();
}

QStringList PerspectiveDrawingTool::marking_menu(int view) const {
  if (!works_in(view)) return {};
  return {"group-z",      "group-normal-x", "group-x", "group-normal-z",
          "construction", "group-normal-y", "group-y", "group-auto"};
}

int PerspectiveDrawingTool::marking_key() const { return Qt::Key_G; }

bool PerspectiveDrawingTool::takes_key(int key) const {
  constexpr std::array letters{Qt::Key_C, Qt::Key_E, Qt::Key_K, Qt::Key_L};
  return (key >= Qt::Key_0 && key <= Qt::Key_6) || std::ranges::find(letters, key) != letters.end();
}

void PerspectiveDrawingTool::press_key(int key) {
  if (key == Qt::Key_C || key == Qt::Key_E) {
    QAction* construction = host().action("construction");
    if (construction->isChecked() != (key == Qt::Key_C)) construction->trigger();
    return;
  }
  if (key == Qt::Key_K) return host().action("known-point")->trigger();
  if (key == Qt::Key_L) return host().action("known-length")->trigger();
  if (key == Qt::Key_0) return choose_group(std::nullopt);
  choose_group(static_cast<StrokeGroup>(key - Qt::Key_1));
}

/// Of what is drawn next, or of what is selected.
void PerspectiveDrawingTool::choose_group(std::optional<StrokeGroup> group) {
  const std::vector<std::string> ids = sheet_.tool().selected();
  if (group && mode() == select_mode && !ids.empty()) {
    StrokeSetting setting;
    setting.group = group;
    do_and_record(sheet_.tool().set(ids, setting));
  } else {
    sheet_.tool().set_group(group);
  }
  refresh();
  emit state_changed();
}

void PerspectiveDrawingTool::apply_fix() {
  const PerspectiveResult* result = sheet_.result();
  if (result == nullptr || result->fixes.empty()) return;
  const ProposedFix fix = result->fixes.front();
  StrokeSetting setting;
  setting.group = fix.group;
  host().attempt([&] { do_and_record(sheet_.tool().set({fix.stroke}, setting)); });
}

void PerspectiveDrawingTool::toggle_sharp() {
  for (const std::string& id : sheet_.tool().selected())
    do_and_record(sheet_.tool().choose("sharp", id, !sheet_.tool().is_chosen("sharp", id)));
}

void PerspectiveDrawingTool::set_face(bool add) {
  const std::string face = face_of(sheet_.tool().selected());
  const std::string list = add ? "faces" : "no-faces";
  do_and_record(sheet_.tool().choose(list, face, !sheet_.tool().is_chosen(list, face)));
}

void PerspectiveDrawingTool::complete_mirrored() {
  if (!sheet_.proposal()) return;
  const MirrorPlane plane = sheet_.proposal()->plane;
  host().attempt([&] { do_and_record(sheet_.tool().complete_mirrored(plane)); });
}

bool PerspectiveDrawingTool::accept() {
  if (!sheet_.proposal()) return false;
  complete_mirrored();
  return true;
}

}  // namespace croquis::app

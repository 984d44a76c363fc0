// SPDX-License-Identifier: GPL-3.0-or-later
#include <QAction>
#include <QActionGroup>
#include <QMenu>
#include <QPainter>
#include <QPixmap>
#include <algorithm>
#include <array>

#include "app/panels/number_box.h"
#include "app/tools/perspective/perspective_chips.h"
#include "app/tools/perspective/perspective_drawing_tool.h"
#include "app/tools/perspective/perspective_panel.h"
#include "app/tools/perspective/sheet_scene.h"
#include "app/views/marking_menu.h"
#include "app/views/render_color.h"
#include "app/views/viewport.h"
#include "app/window/action_list.h"
#include "app/window/panel_docks.h"
#include "croquis/tools/perspective/sheet_units.h"
#include "croquis/tools/recording/general_steps.h"

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

QString number(double value) { return number_words(value, 6); }

QString with_unit(const QString& title, const std::string& unit) {
  return unit.empty() ? title : title + " (" + QString::fromStdString(unit) + ")";
}

}  // namespace

// Actions of the perspective tool: what menus, keys and buttons do.

void PerspectiveDrawingTool::make_actions(ActionList& actions) {
  QMenu* file = actions.menu(tr("&File"));
  QAction* fresh = actions.add(file, "new-perspective", tr("New &perspective drawing"), {}, [this] { begin_new(); });
  file->insertAction(actions.find("open"), fresh);
  make_group_actions(actions);
  make_stroke_actions(actions);
  make_keys();
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
        if (mode() == select_mode && !ids.empty()) do_and_record(recorded::SheetSetting{ids, setting});
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
    do_and_record(recorded::SheetSetting{sheet_.tool().selected(), setting});
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

/// Over the sheet.
void PerspectiveDrawingTool::make_keys() {
  set_marking_key(Qt::Key_G);
  const auto set_construction = [this](bool on) {
    QAction* construction = host().action("construction");
    if (construction->isChecked() != on) construction->trigger();
  };
  set_key(Qt::Key_C, [set_construction] { set_construction(true); });
  set_key(Qt::Key_E, [set_construction] { set_construction(false); });
  set_key(Qt::Key_K, [this] { host().action("known-point")->trigger(); });
  set_key(Qt::Key_L, [this] { host().action("known-length")->trigger(); });
  set_key(Qt::Key_0, [this] { choose_group(std::nullopt); });
  for (int i = 0; i < static_cast<int>(group_actions.size()); ++i)
    set_key(static_cast<int>(Qt::Key_1) + i, [this, i] { choose_group(static_cast<StrokeGroup>(i)); });
}

/// Of what is drawn next, or of what is selected.
void PerspectiveDrawingTool::choose_group(std::optional<StrokeGroup> group) {
  const std::vector<std::string> ids = sheet_.tool().selected();
  if (group && mode() == select_mode && !ids.empty()) {
    StrokeSetting setting;
    setting.group = group;
    do_and_record(recorded::SheetSetting{ids, setting});
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
  host().attempt([&] { do_and_record(recorded::SheetSetting{{fix.stroke}, setting}); });
}

void PerspectiveDrawingTool::toggle_sharp() {
  for (const std::string& id : sheet_.tool().selected())
    do_and_record(recorded::SheetChoice{"sharp", id, !sheet_.tool().is_chosen("sharp", id)});
}

void PerspectiveDrawingTool::set_face(bool add) {
  const std::string face = face_of(sheet_.tool().selected());
  const std::string list = add ? "faces" : "no-faces";
  do_and_record(recorded::SheetChoice{list, face, !sheet_.tool().is_chosen(list, face)});
}

void PerspectiveDrawingTool::complete_mirrored() {
  if (!sheet_.proposal()) return;
  const MirrorPlane plane = sheet_.proposal()->plane;
  host().attempt([&] { do_and_record(recorded::SheetMirror{plane, {}}); });
}

// What people say to the perspective tool: known coordinates and lengths at the pen, sets of faces, parameters.

QPointF PerspectiveDrawingTool::widget_place(const Vec2& sheet) const {
  return host().viewport().sketch_to_widget({sheet.x(), -sheet.y()});
}

void PerspectiveDrawingTool::ask_point(const Vec2& at) {
  const auto& known = sheet_.drawing().known_point;
  const Vec3 point = known ? known->point : Vec3(Vec3::Zero());
  const QString text = number(point.x()) + ' ' + number(point.y()) + ' ' + number(point.z());
  entry_->ask(widget_place(at), with_unit(tr("x y z"), sheet_.drawing().unit), text, [this, at](const QString& typed) {
    const auto read = read_point(typed.toStdString(), sheet_.drawing().unit);
    if (!read) return false;
    return host().attempt([&] { do_and_record(recorded::SheetPoint{KnownPoint{at, *read}}); });
  });
  emit state_changed();
}

/// An empty field forgets the length.
void PerspectiveDrawingTool::ask_length(const std::string& stroke) {
  const PerspectiveStroke* drawn = find_stroke(sheet_.drawing(), stroke);
  if (drawn == nullptr) return;
  sheet_.tool().select({stroke});
  QString text;
  for (const KnownLength& known : sheet_.drawing().known_lengths) {
    if (known.stroke == stroke) text = number(known.length);
  }
  const QString title = with_unit(tr("Length of %1").arg(QString::fromStdString(stroke)), sheet_.drawing().unit);
  entry_->ask(widget_place(middle_of_stroke(*drawn)), title, text, [this, stroke](const QString& typed) {
    const auto read = read_length(typed.toStdString(), sheet_.drawing().unit);
    if (!read && !typed.trimmed().isEmpty()) return false;
    return host().attempt([&] { do_and_record(recorded::SheetLength{stroke, read}); });
  });
  emit state_changed();
}

/// Of the stroke that is selected, else of the one that is clicked next.
void PerspectiveDrawingTool::begin_known_length() {
  const std::vector<std::string> ids = sheet_.tool().selected();
  if (ids.size() == 1) return ask_length(ids.front());
  sheet_.pick(SheetInteraction::Pick::Length);
}

void PerspectiveDrawingTool::add_alternative_to(render::Scene& scene, int view) const {
  const auto& hovered = chips_.alternatives().hovered();
  const PerspectiveResult* result = sheet_.result();
  if (!hovered || result == nullptr || *hovered >= result->alternatives.size()) return;
  const FaceDifference difference = difference_of(*result, result->alternatives[*hovered]);
  const auto on_sheet = [&](const Vec3& point) { return on_sketch_plane(result->camera.project(point)); };
  const Node* node = studio().session().document().find(sheet_.tool().operation_node());
  const WorkObject* object = studio().active();
  const Affine3 stands = object == nullptr ? Affine3() : object->placement.map();
  const Affine3 placement = node == nullptr ? Affine3() : composed(stands, node->transform);
  const auto in_space = [&](const Vec3& point) { return to_glm(placement(point)); };
  const FromSpace place = has_view(view) ? FromSpace(on_sheet) : FromSpace(in_space);
  for (const render::LineItemPtr& item : difference_items(*result, difference, place)) scene.lines.emplace_back(item);
}

void PerspectiveDrawingTool::take_alternative(std::size_t alternative) {
  const PerspectiveResult* result = sheet_.result();
  if (result == nullptr || alternative >= result->alternatives.size()) return;
  const FaceDifference difference = difference_of(*result, result->alternatives[alternative]);
  host().attempt([&] {
    do_and_record(recorded::SheetFaces{names_of(difference.added), names_of(difference.removed)});
  });
}

/// Of the operation; one undo step, recorded.
void PerspectiveDrawingTool::set_parameter(const std::string& name, const ParameterValue& value) {
  const NodeId node = sheet_.tool().operation_node();
  if (node == 0) return;
  studio().set_parameter(node, name, value, false);
  const Node* edited = studio().session().document().find(node);
  if (edited != nullptr) host().record(recorded::Set{edited->name, name, value});
}

}  // namespace croquis::app

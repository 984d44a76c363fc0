// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tools/holes/hole_filling_tool.h"

#include <QAction>
#include <QDockWidget>
#include <QLocale>
#include <QMenu>
#include <QScrollArea>
#include <QScrollBar>
#include <algorithm>
#include <set>
#include <utility>

#include "app/panels/finding_elements.h"
#include "app/replay/replays.h"
#include "app/tools/holes/hole_panel.h"
#include "app/tools/holes/hole_plan.h"
#include "app/tools/holes/hole_table.h"
#include "app/views/own_space.h"
#include "app/views/viewport.h"
#include "app/window/action_list.h"
#include "app/window/panel_docks.h"
#include "croquis/render/value_color.h"
#include "croquis/tools/holes/hole_steps.h"
#include "croquis/tools/recording/general_steps.h"

namespace croquis::app {
namespace {

/// Which holes each patch closes.
std::map<std::int32_t, std::vector<Index>> holes_of_patches(const WorkObject& object) {
  std::map<std::int32_t, std::vector<Index>> holes;
  for (const HoleRow& row : hole_rows(object.result.get())) {
    if (row.patch && row.state == FillAction::Fill) holes[static_cast<std::int32_t>(*row.patch)].push_back(row.id);
  }
  return holes;
}

constexpr int wanted_width = 480;  // of the panel, pixels

/// Those that are open or failed.
std::size_t count_open_holes(const WorkObject& object) {
  const auto rows = hole_rows(object.result.get());
  return static_cast<std::size_t>(
      std::ranges::count_if(rows, [](const HoleRow& row) { return row.state != FillAction::Fill; }));
}

std::size_t count_patches(const WorkObject& object) {
  std::set<Index> numbers;
  for (const HoleRow& row : hole_rows(object.result.get())) {
    if (row.patch && row.state == FillAction::Fill) numbers.insert(*row.patch);
  }
  return numbers.size();
}

/// The colours of patches with their confidence. As scales stand: much above.
Legend* make_confidence_legend(QWidget* views) {
  std::vector<Legend::Row> rows;
  for (const render::ValueSample& sample : render::value_legend()) {
    const QColor color(sample.color.r, sample.color.g, sample.color.b);
    rows.push_back({QString::fromStdString(sample.label), [color](QPainter& painter, int y) {
                      painter.fillRect(QRect(10, y, 22, Legend::row_height), color);
                    }});
  }
  std::ranges::reverse(rows);
  return new Legend(views, "confidence-legend", HoleFillingTool::tr("Confidence"),
                    HoleFillingTool::tr("Colours of patches by confidence"), std::move(rows));
}

}  // namespace

HoleFillingTool::HoleFillingTool(ToolHost& host)
    : Tool(host, "Meshes"),
      holes_(
          host.studio(), host.viewport().objects(),
          [this](int view) { return this->host().viewport().own_frame_of(view); }, nullptr),
      pins_(&host.viewport()),
      legend_(make_confidence_legend(&host.viewport())) {
  host.studio().face_sets().set_holes(holes_of_patches);
  connect(&holes_, &HoleInteraction::changed, this, &Tool::changed);
  connect(&holes_, &HoleInteraction::committed, this, &Tool::committed);
  connect(&holes_, &HoleInteraction::holes_changed, this, &Tool::state_changed);
  connect(&holes_, &HoleInteraction::told, this, &Tool::told);
}

QAction* HoleFillingTool::add(ActionList& actions, QMenu* menu, const QString& name, const QString& text,
                              const QList<QKeySequence>& keys, std::function<void(HoleInteraction&)> work,
                              bool records_itself) {
  QAction* action = actions.add(
      menu, name, text, keys, [this, work = std::move(work)] { work(holes_); },
      records_itself ? Recorded::ByItself : Recorded::AsAction);
  actions_ << action;
  return action;
}

void HoleFillingTool::make_actions(ActionList& actions) {
  QMenu* menu = actions.menu(tr("S&can"));
  QAction* tool = actions.add_mode(menu, "holes", tr("&Holes"), "O", [this] { start(); });
  tool->setToolTip(tr("Holes of a scan: list, preview, fill (O)"));
  menu->addSeparator();
  // Enter comes from the views and the list alone: lines of text need it themselves.
  add(actions, menu, "fill-selected", tr("&Fill selected") + "\t" + tr("Enter"), {},
      [](HoleInteraction& holes) { holes.fill_selected(); });
  add(actions, menu, "reopen-selected", tr("&Reopen selected") + "\t" + tr("Del"), {},
      [](HoleInteraction& holes) { holes.reopen_selected(); });
  add(actions, menu, "bridge-holes", tr("&Bridge selected rims"), {QKeySequence("B")},
      [](HoleInteraction& holes) { holes.bridge_selected(); });
  menu->addSeparator();
  add(actions, menu, "fill-inner", tr("Fill all &inner"), {QKeySequence("Shift+F")},
      [](HoleInteraction& holes) { holes.fill_all("inner"); });
  add(actions, menu, "fill-all-but-largest", tr("Fill all but the &largest"), {QKeySequence("Ctrl+Shift+F")},
      [](HoleInteraction& holes) { holes.fill_all("all-but-largest"); });
  add(actions, menu, "fill-all", tr("Fill &all, borders too"), {},
      [](HoleInteraction& holes) { holes.fill_all("all"); });
  add(actions, menu, "reopen-all", tr("Reopen all"), {}, [](HoleInteraction& holes) { holes.fill_all("none"); });
  menu->addSeparator();
  add(actions, menu, "clear-handles", tr("&Clear handles of patches"), {},
      [](HoleInteraction& holes) { holes.clear_handles(); });
  for (const auto& [way, text] : {std::pair{"auto", tr("Method: &automatic")},
                                  {"rbf", tr("Method: &continue the surface")},
                                  {"smooth", tr("Method: continue its &slope")},
                                  {"flat", tr("Method: fla&t")}}) {
    add(
        actions, menu, QString("way-") + way, text, {},
        [name = std::string(way)](HoleInteraction& holes) { holes.set_way({.fairness = name}); }, true);
  }
  menu->addSeparator();
  menu->addAction(actions.find("freeze"));
  QAction* tint = actions.add(menu, "tint-patches", tr("Patches by c&onfidence"), {QKeySequence("T")}, [this] {
    tinted_ = host().action("tint-patches")->isChecked();
    show_patch_look();
  });
  tint->setCheckable(true);
  // What was filled is hidden once it is frozen.
  connect(actions.find("freeze"), &QAction::triggered, this, [this] {
    if (holes_.active() && filling_node(studio()) == nullptr) host().set_mode(select_mode);
  });
}

void HoleFillingTool::make_panels(PanelDocks& panels) {
  panels_ = &panels;
  panel_ = new HolePanel(studio(), holes_, [this](const QString& name) { return host().action(name); });
  QScrollArea* scroll = scrolled(panel_);
  scroll->setMinimumWidth(panel_->minimumSizeHint().width() + scroll->verticalScrollBar()->sizeHint().width());
  dock_ = panels.add(tr("Holes"), scroll, "holes");
  panels.tabify("attributes", dock_);
  panels.set_useful(dock_, false);
  connect(panel_, &HolePanel::frame_wanted, this, &HoleFillingTool::frame_holes);
  connect(&panel_->table(), &HoleTable::accepted, host().action("fill-selected"), &QAction::trigger);
}

void HoleFillingTool::start() {
  if (host().attempt([this] { start_filling(studio()); })) host().set_mode("holes");
  host().refresh();
}

void HoleFillingTool::set_mode(const QString& mode) {
  Tool::set_mode(mode);
  holes_.set_active(mode == "holes");
  show_patch_look();
}

void HoleFillingTool::show_patch_look() {
  host().viewport().objects().set_patch_look(tinted_           ? PatchLook::Confidence
                                             : holes_.active() ? PatchLook::Distinct
                                                               : PatchLook::Plain);
}

void HoleFillingTool::take(const PointerEvent& event) {
  if (event.action == PointerEvent::Action::Leave) return holes_.leave();
  holes_.take(event);
}

QString HoleFillingTool::offer(const WorkObject&) const {
  if (filling_node(studio()) == nullptr) return {};
  return tr("O goes back to its holes: there patches are dragged · F9 vertices, F10 edges, F11 faces of the scan");
}

bool HoleFillingTool::command(EditCommand command) {
  if (command == EditCommand::Cancel) holes_.cancel();
  if (!holes_.active()) return false;
  switch (command) {
    case EditCommand::SelectAll: holes_.select_all(); break;
    case EditCommand::SelectNone: {
      Selection selection = studio().session().selection();
      std::erase_if(selection, [](const SelectedItem& item) { return !item.part.empty(); });
      studio().session().select(std::move(selection));
      holes_.select({});
      break;
    }
    case EditCommand::Delete:
      host().record(recorded::Action{"delete"});
      holes_.reopen_selected();
      break;
    case EditCommand::Accept: host().action("fill-selected")->trigger(); break;
    case EditCommand::Cancel: break;
  }
  return true;
}

void HoleFillingTool::follow(Change change) {
  if (change == Change::Document || change == Change::Result) holes_.follow();
}

void HoleFillingTool::adjust(ObjectScenes::Wanted& wanted, int) const {
  if (holes_.active()) wanted.outlines = false;
}

std::optional<SelectionFrame> HoleFillingTool::selection_frame(int) const {
  if (holes_.selection_bounds().empty()) return std::nullopt;
  const WorkObject* object = studio().active();
  const Affine3 to_model = object == nullptr ? Affine3() : object->placement.map();
  std::optional<Vec3> facing = holes_.selection_facing();
  if (facing) facing = (to_model.linear * *facing).normalized();
  return SelectionFrame{render::placed(holes_.selection_bounds(), matrix_of(to_model)), facing, true};
}

void HoleFillingTool::place_chips(ChipPlaces& places) {
  places.put_legend(*legend_, tinted_ && holes_.active());
  HolePinView::Pins pins;
  const PaneLayout& layout = places.layout();
  for (const int view : holes_.active() ? layout.shown() : std::vector<int>()) {
    if (host().viewport().tool_in(view) == this) pins.push_back({layout.pane(view).rect, holes_.pins(view)});
  }
  pins_.show_pins(std::move(pins), holes_);
}

void HoleFillingTool::frame_holes() {
  host().record(recorded::Action{"frame-selection"});
  host().viewport().frame_selection();
}

void HoleFillingTool::chosen_by_name(const std::vector<const FaceSet*>& sets) {
  std::vector<Index> holes;
  for (const FaceSet* set : sets) holes.insert(holes.end(), set->holes.begin(), set->holes.end());
  if (holes_.active() && !holes.empty()) holes_.select(holes);
}

/// One row for all patches, and in it one for each.
std::vector<ObjectRow> HoleFillingTool::rows(const WorkObject& object, NodeId node) const {
  std::vector<ObjectRow> rows;
  if (node != object.node) return rows;
  for (const FaceSet& set : studio().face_sets().of(object)) {
    const auto count = qulonglong(set.faces.size());
    const QString info = count == 1 ? tr("1 face") : tr("%1 faces").arg(QLocale().toString(count));
    const ObjectRow row{QString::fromStdString(set.name),
                        info,
                        tr("Click to select these faces; F frames them"),
                        {set.name},
                        true,
                        false,
                        {}};
    (rows.empty() ? rows : rows.front().rows).push_back(row);
  }
  return rows;
}

bool HoleFillingTool::choose_parts(NodeId node, const std::vector<std::string>& parts) {
  const WorkObject* object = studio().object(node);
  if (object == nullptr || studio().face_sets().of(*object).empty()) return false;
  host().record(recorded::FaceSetChoice{object->name, parts});
  host().select_face_sets(node, parts);
  return true;
}

bool HoleFillingTool::show_finding(const NodeFinding& found) {
  const std::vector<Index> holes = holes_of(found.finding);
  const Node* node = studio().session().document().find(found.node);
  if (holes.empty() || node == nullptr || node->operation != filling_operation) return false;
  studio().set_active(found.node);
  if (!holes_.active()) host().action("holes")->trigger();
  holes_.select(holes);
  frame_holes();
  return true;
}

bool HoleFillingTool::open_step(const Node& step) {
  if (step.operation != filling_operation) return false;
  if (!holes_.active()) host().action("holes")->trigger();
  return true;
}

void HoleFillingTool::refresh() {
  const bool working = holes_.active() && filling_node(studio()) != nullptr;
  const auto& selected = holes_.selected();
  for (QAction* action : actions_) action->setEnabled(working);
  const auto any = [&](auto&& holds) {
    return working && std::any_of(selected.begin(), selected.end(), [&](Index hole) {
             const HoleRow* row = holes_.row(hole);
             return row == nullptr || holds(*row);
           });
  };
  host().action("fill-selected")->setEnabled(working && holes_.can_fill_selected());
  host().action("reopen-selected")->setEnabled(any([](const HoleRow& row) { return row.state != FillAction::Leave; }));
  for (const auto& [name, select] : {std::pair{"fill-inner", "inner"},
                                     {"fill-all-but-largest", "all-but-largest"},
                                     {"fill-all", "all"},
                                     {"reopen-all", "none"}}) {
    host().action(name)->setEnabled(working && holes_.can_fill_all(select));
  }
  host().action("clear-handles")->setEnabled(working && !holes_.tool().handles().empty());
  host().action("bridge-holes")->setEnabled(working && selected.size() > 1);
  host().action("holes")->setEnabled(can_fill(studio()));
  if (working) host().action("delete")->setEnabled(!selected.empty());
  follow_dock(working);
}

void HoleFillingTool::follow_dock(bool working) {
  const bool was_shown = !dock_->isHidden();
  panels_->set_useful(dock_, working);
  const bool appears = !was_shown && !dock_->isHidden();
  if (appears) dock_->raise();
  if (appears) panels_->give_room_once(dock_, wanted_width);
  panel_->follow();
}

// Recorded steps of work on holes, and what replays can expect of them.

void HoleFillingTool::make_replays(Replays& replays) {
  const auto play = [this](const auto& step) {
    if (!step.node.empty()) studio().set_active(object_named(studio(), step.node).node);
    if (!holes_.active()) refuse_replay("No holes are being worked on: the action \"holes\" opens them");
    host().wait_until_settled();  // their numbers are known once they have been found
    holes_.replay(step);
  };
  replays.on<recorded::HoleChoice>(play);
  replays.on<recorded::HoleWay>(play);
  replays.on<recorded::HolePoint>(play);
  replays.counts["holes"] = [this](const std::string& node) { return count_open_holes(object_named(studio(), node)); };
  replays.counts["patches"] = [this](const std::string& node) { return count_patches(object_named(studio(), node)); };
  replays.counts["selected"] = [this](const std::string&) {
    return holes_.active() ? holes_.selected().size() : studio().session().components().elements.size();
  };
}

}  // namespace croquis::app

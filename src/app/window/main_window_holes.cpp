// SPDX-License-Identifier: GPL-3.0-or-later
// What the window does with holes of scans: the tool, its panel, menu and keys.
#include <QAction>
#include <QActionGroup>
#include <QDockWidget>
#include <QMenu>
#include <QMenuBar>
#include <QScrollArea>
#include <QScrollBar>
#include <QToolBar>
#include <algorithm>
#include <utility>

#include "app/panels/finding_elements.h"
#include "app/tools/holes/filling.h"
#include "app/tools/holes/hole_panel.h"
#include "app/tools/holes/hole_table.h"
#include "app/views/viewport.h"
#include "app/window/main_window.h"
#include "app/window/panel_docks.h"
#include "croquis/tools/recording/general_steps.h"

namespace croquis::app {

QAction* MainWindow::add_hole_action(QMenu* menu, const QString& name, const QString& text,
                                     const QList<QKeySequence>& keys, std::function<void(HoleInteraction&)> work,
                                     bool tells_itself) {
  QAction* action = add_action(
      menu, name, text, keys, [this, work = std::move(work)] { work(viewport_->holes()); },
      tells_itself ? Recorded::ByItself : Recorded::AsAction);
  hole_actions_ << action;
  return action;
}

void MainWindow::make_hole_actions() {
  QMenu* menu = menuBar()->addMenu(tr("S&can"));
  QAction* tool = add_action(menu, "holes", tr("&Holes"), {QKeySequence("O")}, [this] {
    if (attempt([this] { start_filling(studio_); })) viewport_->set_tool(ToolKind::Holes);
    update_panels();
  });
  tool->setCheckable(true);
  tool->setToolTip(tr("Holes of a scan: list, preview, fill (O)"));
  tool_actions_[ToolKind::Draw]->actionGroup()->addAction(tool);
  tool_actions_[ToolKind::Holes] = tool;
  findChild<QToolBar*>("tools")->addAction(tool);
  menu->addSeparator();
  // Enter comes from the views and the list alone: lines of text need it themselves.
  add_hole_action(menu, "fill-selected", tr("&Fill selected") + "\t" + tr("Enter"), {},
                  [](HoleInteraction& holes) { holes.fill_selected(); });
  add_hole_action(menu, "reopen-selected", tr("&Reopen selected") + "\t" + tr("Del"), {},
                  [](HoleInteraction& holes) { holes.reopen_selected(); });
  add_hole_action(menu, "bridge-holes", tr("&Bridge selected rims"), {QKeySequence("B")},
                  [](HoleInteraction& holes) { holes.bridge_selected(); });
  menu->addSeparator();
  add_hole_action(menu, "fill-inner", tr("Fill all &inner"), {QKeySequence("Shift+F")},
                  [](HoleInteraction& holes) { holes.fill_all("inner"); });
  add_hole_action(menu, "fill-all-but-largest", tr("Fill all but the &largest"), {QKeySequence("Ctrl+Shift+F")},
                  [](HoleInteraction& holes) { holes.fill_all("all-but-largest"); });
  add_hole_action(menu, "fill-all", tr("Fill &all, borders too"), {},
                  [](HoleInteraction& holes) { holes.fill_all("all"); });
  add_hole_action(menu, "reopen-all", tr("Reopen all"), {}, [](HoleInteraction& holes) { holes.fill_all("none"); });
  menu->addSeparator();
  add_hole_action(menu, "clear-handles", tr("&Clear handles of patches"), {},
                  [](HoleInteraction& holes) { holes.clear_handles(); });
  for (const auto& [way, text] : {std::pair{"auto", tr("Method: &automatic")},
                                  {"rbf", tr("Method: &continue the surface")},
                                  {"smooth", tr("Method: continue its &slope")},
                                  {"flat", tr("Method: fla&t")}}) {
    add_hole_action(
        menu, QString("way-") + way, text, {},
        [name = std::string(way)](HoleInteraction& holes) { holes.set_fairness(name); }, true);
  }
  menu->addSeparator();
  menu->addAction(action("freeze"));
  QAction* tint = add_action(menu, "tint-patches", tr("Patches by c&onfidence"), {QKeySequence("T")},
                             [this] { viewport_->set_tinted(action("tint-patches")->isChecked()); });
  tint->setCheckable(true);
}

void MainWindow::make_hole_dock() {
  holes_panel_ = new HolePanel(
      studio_, viewport_->holes(), [this](const QString& name) { return action(name); }, this);
  // A small window scrolls it.
  auto* scroll = new QScrollArea(this);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setWidget(holes_panel_);
  scroll->setMinimumWidth(holes_panel_->minimumSizeHint().width() + scroll->verticalScrollBar()->sizeHint().width());
  holes_dock_ = panels_->add(tr("Holes"), scroll, "holes");
  tabifyDockWidget(docks_[1], holes_dock_);
  panels_->set_useful(holes_dock_, false);
  connect(holes_panel_, &HolePanel::frame_wanted, this, [this] { frame_holes(); });
  connect(&holes_panel_->table(), &HoleTable::accepted, action("fill-selected"), &QAction::trigger);
  connect(viewport_, &Viewport::accept_wanted, action("fill-selected"), &QAction::trigger);
  connect(&viewport_->holes(), &HoleInteraction::holes_changed, this, &MainWindow::update_panels);
  connect(&viewport_->holes(), &HoleInteraction::told, this, &MainWindow::tell);
}

void MainWindow::frame_holes() {
  record(recorded::Action{"frame-selection"});
  viewport_->frame_selection();
}

void MainWindow::update_hole_actions() {
  const bool working = viewport_->holes().active() && filling_node(studio_) != nullptr;
  const auto& selected = viewport_->holes().selected();
  for (QAction* action : hole_actions_) action->setEnabled(working);
  const auto any = [&](auto&& holds) {
    return working && std::any_of(selected.begin(), selected.end(), [&](Index hole) {
             const HoleRow* row = viewport_->holes().row(hole);
             return row == nullptr || holds(*row);
           });
  };
  action("fill-selected")->setEnabled(working && viewport_->holes().can_fill_selected());
  action("reopen-selected")->setEnabled(any([](const HoleRow& row) { return row.state != HoleState::Open; }));
  for (const auto& [name, select] : {std::pair{"fill-inner", "inner"},
                                     {"fill-all-but-largest", "all-but-largest"},
                                     {"fill-all", "all"},
                                     {"reopen-all", "none"}}) {
    action(name)->setEnabled(working && viewport_->holes().can_fill_all(select));
  }
  action("clear-handles")->setEnabled(working && !viewport_->holes().tool().handles().empty());
  action("bridge-holes")->setEnabled(working && selected.size() > 1);
  action("holes")->setEnabled(can_fill(studio_));
  if (working) action("delete")->setEnabled(!selected.empty());
  const bool was_shown = !holes_dock_->isHidden();
  panels_->set_useful(holes_dock_, working);
  if (!was_shown && !holes_dock_->isHidden()) holes_dock_->raise();
  if (!was_shown && !holes_dock_->isHidden() && !std::exchange(holes_sized_, true)) {
    // The first time: people's own sizes are kept.
    resizeDocks({holes_dock_}, {480}, Qt::Horizontal);
    resizeDocks({docks_[0], holes_dock_, docks_[2], docks_[3]}, {70, 600, 80, 90}, Qt::Vertical);
  }
  holes_panel_->follow();
}

bool MainWindow::show_hole_finding(const NodeFinding& found) {
  const std::vector<Index> holes = holes_of(found.finding);
  const Node* node = studio_.session().document().find(found.node);
  if (holes.empty() || node == nullptr || node->operation != "fill") return false;
  studio_.set_active(found.node);
  if (!viewport_->holes().active()) action("holes")->trigger();
  viewport_->holes().select(holes);
  frame_holes();
  return true;
}

}  // namespace croquis::app

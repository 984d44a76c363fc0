// SPDX-License-Identifier: GPL-3.0-or-later
// The panels of the window, and what they show of the studio.
#include <QAction>
#include <QDockWidget>
#include <QMenu>
#include <QMenuBar>
#include <QScrollArea>
#include <QVBoxLayout>
#include <algorithm>
#include <cstring>
#include <ranges>

#include "app/panels/attribute_panel.h"
#include "app/panels/finding_elements.h"
#include "app/panels/lists.h"
#include "app/panels/object_names.h"
#include "app/panels/panel.h"
#include "app/studio/studio.h"
#include "app/views/viewport.h"
#include "app/window/help_line.h"
#include "app/window/main_window.h"
#include "app/window/panel_docks.h"
#include "croquis/base/error.h"
#include "croquis/tools/recording/general_steps.h"

namespace croquis::app {

void MainWindow::make_docks() {
  panels_ = new PanelDocks(*this);
  objects_ = new ObjectList([this](const WorkObject& object, NodeId node) { return rows_of(object, node); }, this);
  attributes_ = new AttributePanel(this);
  findings_ = new FindingsList(this);
  history_ = new HistoryList(this);
  auto* fields = new QWidget(this);
  auto* column = new QVBoxLayout(fields);
  placement_ = new PlacementFields(fields);
  column->setContentsMargins({});
  column->setSpacing(0);
  column->addWidget(placement_);
  column->addWidget(attributes_, 1);
  docks_ = {panels_->add(tr("Objects"), objects_, "objects"),
            panels_->add(tr("Attributes"), scrolled(fields), "attributes"),
            panels_->add(tr("Findings"), findings_, "findings"), panels_->add(tr("History"), history_, "history")};
}

void MainWindow::make_window_actions() {
  QMenu* menu = actions_->menu(tr("&Window"));
  for (QDockWidget* dock : panels_->all()) {
    const QString name = "panel-" + dock->objectName().chopped(static_cast<int>(strlen("-dock")));
    QAction* shown = actions_->add(menu, name, dock->windowTitle(), {},
                                   [this, dock, name] { panels_->set_wanted(dock, action(name)->isChecked()); });
    shown->setCheckable(true);
    shown->setChecked(true);
    connect(panels_, &PanelDocks::wanted_changed, shown, [dock, shown](const QDockWidget* changed, bool wanted) {
      if (changed == dock) shown->setChecked(wanted);
    });
  }
  menu->addSeparator();
  actions_->add(menu, "reset-layout", tr("&Reset layout"), {}, [this] { reset_layout(); });
}

QMenu* MainWindow::createPopupMenu() {
  auto* menu = new QMenu(this);
  for (QAction* shown : actions()) {
    if (shown->objectName().startsWith("panel-")) menu->addAction(shown);
  }
  return menu;
}

void MainWindow::connect_panels() {
  connect(attributes_, &AttributePanel::parameter_edited, this,
          [this](NodeId node, const std::string& parameter, const ParameterValue& value, bool dragging) {
            studio_.set_parameter(node, parameter, value, dragging);
            const Node* edited = studio_.session().document().find(node);
            if (!dragging && edited != nullptr) record(recorded::Set{edited->name, parameter, value});
          });
  connect(placement_, &PlacementFields::placed, this, [this](NodeId node, const Placement& placement) {
    const WorkObject* object = studio_.object(node);
    if (object == nullptr) return;
    const recorded::Place step{{object->name}, {placement}};
    if (attempt([&] { place_objects(studio_, {{node, placement}}); })) record(step);
  });
  connect(objects_, &ObjectList::objects_chosen, this,
          [this](const std::vector<NodeId>& nodes) { choose_nodes(with_groups(studio_, nodes)); });
  connect(objects_, &ObjectList::step_chosen, this, &MainWindow::choose_step);
  connect(objects_, &ObjectList::parts_chosen, this, [this](NodeId node, const std::vector<std::string>& parts) {
    attempt([&] {
      std::ranges::any_of(tools_, [&](const auto& tool) { return tool->show(ChosenParts{node, parts}); });
    });
  });
  connect(objects_, &ObjectList::step_enabled, this, [this](NodeId step, bool enabled) {
    attempt([&] { enable_step(studio_, step, enabled); });
    update_panels();
  });
  connect(objects_, &ObjectList::menu_wanted, this,
          [this](NodeId, bool step, const QPoint& at) { step_actions_->show_menu(step, at); });
  connect(objects_, &ObjectList::renamed, this,
          [this](NodeId node, const std::string& name) { rename_object(studio_, node, name); });
  connect(objects_, &ObjectList::shown, this,
          [this](const std::vector<NodeId>& objects, bool visible) { show_objects(studio_, objects, visible); });
  connect(objects_, &ObjectList::group_renamed, this,
          [this](const std::string& group, const std::string& name) { rename_group(studio_, group, name); });
  connect(findings_, &FindingsList::finding_chosen, this, &MainWindow::show_finding);
  connect(findings_, &FindingsList::fix_chosen, this, [this](const NodeFinding& found, QAction* fix) {
    choose_step(found.node);
    fix->trigger();
  });
  connect(history_, &HistoryList::step_chosen, this, &MainWindow::go_to_step);
}

void MainWindow::update_panels() {
  const Session& session = studio_.session();
  const WorkObject* object = studio_.active();
  const Node* operation = active_operation(studio_);
  attributes_->show_node(operation, operation == nullptr ? nullptr : studio_.description(operation->operation));
  placement_->follow(studio_);
  objects_->show_objects(studio_);
  step_actions_->refresh();
  show_findings();
  history_->show_history(session.undo_labels(), session.redo_labels());
  help_->show_status(status());
  action("undo")->setEnabled(session.can_undo());
  action("redo")->setEnabled(session.can_redo());
  const bool has_selection = std::ranges::any_of(tools_, [](const auto& tool) { return tool->state().has_selection; });
  action("delete")->setEnabled(!session.selection().empty() || has_selection);
  const bool shown = object != nullptr && object->shown() != nullptr;
  for (const char* name : {"export-solid", "export-visible", "export-all"}) action(name)->setEnabled(shown);
  action("export-step")->setEnabled(exact_solid(studio_) != nullptr);
  action("export-picture")->setEnabled(shown);
  for (const OperationDescription* exported : result_exports(studio_))
    action(export_action(*exported))->setEnabled(can_export(studio_, *exported));
  actions_->show_mode(viewport_->mode());
  show_cameras();
  for (const auto& tool : tools_) tool->refresh();
  setWindowModified(session.modified());
  update_help();
}

QString MainWindow::status() const {
  for (const auto& tool : tools_) {
    if (const QString status = tool->words().status; !status.isEmpty()) return status;
  }
  return {};
}

/// Those of the files first: what they lack is missing everywhere else.
void MainWindow::show_findings() {
  std::vector<NodeFinding> all;
  for (const Finding& finding : files_.warnings()) all.push_back({0, finding});
  for (const NodeFinding& found : findings_of(studio_)) all.push_back(found);
  findings_->show_findings(
      all, [this](const NodeFinding& found) { return owner_of(found); },
      [this](const NodeFinding& found) { return step_actions_->fixes_of(found); });
}

void MainWindow::select_nodes(const std::vector<NodeId>& nodes) {
  Selection selection;
  for (const NodeId node : nodes) selection.push_back({node, ""});
  if (!nodes.empty()) {
    const WorkObject* object = studio_.object(nodes.front());
    studio_.set_active(object == nullptr ? nodes.front() : object->node);
  }
  studio_.session().select(std::move(selection));
}

void MainWindow::choose_nodes(const std::vector<NodeId>& nodes) {
  recorded::NodeChoice step;
  for (const NodeId id : nodes) {
    if (const Node* node = studio_.session().document().find(id)) step.nodes.push_back(node->name);
  }
  select_nodes(nodes);
  if (!step.nodes.empty()) record(step);
}

void MainWindow::choose_step(NodeId step) {
  choose_nodes({step});
  const Node* node = studio_.session().document().find(step);
  if (node == nullptr) return;
  // The special ones come last in the list.
  for (const auto& tool : tools_ | std::views::reverse) {
    if (tool->show(node)) return;
  }
}

std::vector<ObjectRow> MainWindow::rows_of(const WorkObject& object, NodeId node) const {
  std::vector<ObjectRow> rows;
  for (const auto& tool : tools_) {
    for (ObjectRow& row : tool->rows(object, node)) rows.push_back(std::move(row));
  }
  return rows;
}

QString MainWindow::owner_of(const NodeFinding& found) const {
  const WorkObject* object = studio_.object(found.node);
  if (object == nullptr) return {};
  for (const auto& tool : tools_) {
    if (const QString owner = tool->owner_of(found); !owner.isEmpty()) return owner;
  }
  return studio_.objects().size() < 2 ? QString() : shown_name(*object);
}

void MainWindow::select_face_sets(NodeId node, const std::vector<std::string>& names) {
  const WorkObject* object = studio_.object(node);
  if (object == nullptr) return;
  const std::vector<FaceSet>& sets = studio_.face_sets().of(*object);
  Selection selection;
  std::vector<const FaceSet*> chosen;
  for (const std::string& name : names) {
    const auto set = std::ranges::find(sets, name, &FaceSet::name);
    if (set == sets.end()) {
      throw Error(
          make_error(Category::Usage, "E_INPUT", "There are no faces named \"" + name + "\" in " + object->name));
    }
    selection.push_back({object->node, name});
    chosen.push_back(&*set);
  }
  const bool is_source = object->is_source();
  studio_.set_active(object->node);
  studio_.session().select(std::move(selection));
  for (const auto& tool : tools_) tool->show(chosen);
  if (!is_source) return viewport_->redraw_all();
  pick(ComponentKind::Face, studio_.face_sets().selected(*studio_.active(), studio_.session().selection()));
}

void MainWindow::show_finding(const NodeFinding& found) {
  if (found.node == 0) return show_opening_report(files_.path(), files_.warnings());
  for (auto tool = tools_.rbegin(); tool != tools_.rend(); ++tool) {
    if ((*tool)->show(found)) return;
  }
}

void MainWindow::say(const QString& sentence) { help_->say(sentence); }

void MainWindow::go_to_step(int steps) {
  Session& session = studio_.session();
  while (static_cast<int>(session.undo_labels().size()) > steps && session.can_undo()) session.undo();
  while (static_cast<int>(session.undo_labels().size()) < steps && session.can_redo()) session.redo();
}

}  // namespace croquis::app

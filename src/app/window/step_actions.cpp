// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/step_actions.h"

#include <QAction>
#include <QMenu>
#include <algorithm>
#include <utility>

#include "app/studio/content.h"
#include "app/views/viewport.h"
#include "app/window/language.h"
#include "croquis/document/connectivity.h"
#include "croquis/workspace/chain.h"
#include "croquis/workspace/chain_edit.h"

namespace croquis::app {
namespace {

bool holds(const std::vector<const OperationDescription*>& operations, const std::string& id) {
  return std::ranges::any_of(operations, [&](const auto* operation) { return operation->id == id; });
}

/// Rows of one menu that act on the step that is selected.
struct StepRows {
  ToolHost& host;
  ActionList& actions;
  QMenu* menu;

  QAction* add(const QString& name, const QString& text, const QString& key,
               std::function<void(Studio&, NodeId)> work) const {
    const QList<QKeySequence> keys = key.isEmpty() ? QList<QKeySequence>() : QList<QKeySequence>{QKeySequence(key)};
    return actions.add(menu, name, text, keys, [&host = host, work = std::move(work)] {
      host.attempt([&] { work(host.studio(), active_step(host.studio())); });
      host.refresh();
    });
  }
};

/// The operations that can be added.
QMenu* added_steps(ToolHost& host) { return host.viewport().window()->findChild<QMenu*>("added-steps"); }

QString adding_action(const std::string& operation) { return "add-step-" + QString::fromStdString(operation); }

void add_operations(ToolHost& host, ActionList& actions, QMenu* menu) {
  QMenu* added = menu->addMenu(QObject::tr("Add step"));
  added->setObjectName("added-steps");
  const StepRows rows{host, actions, added};
  for (const OperationDescription& description : host.studio().registry().descriptions()) {
    const PortDescription* output = main_output(description);
    if (output == nullptr || output->type != ValueType::Mesh) continue;  // what it gives has no place in a chain
    rows.add(adding_action(description.id), shown_text(description.title), {},
             [id = description.id](Studio& studio, NodeId step) {
               add_step(studio, step, id, first_parameters(studio, id));
             })
        ->setToolTip(shown_text(description.sentence));
  }
}

}  // namespace

void add_step_actions(ToolHost& host, ActionList& actions) {
  QMenu* menu = actions.menu(MenuId::Modify);
  add_operations(host, actions, menu);
  menu->addSeparator();
  const StepRows rows{host, actions, menu};
  rows.add("step-on", QObject::tr("Enable step"), {},
           [](Studio& studio, NodeId step) {
             const Node* node = studio.session().document().find(step);
             enable_step(studio, step, node != nullptr && !node->enabled);
           })
      ->setCheckable(true);
  rows.add("step-earlier", QObject::tr("Move step down"), "Ctrl+Shift+Down",
           [](Studio& studio, NodeId step) { move_step(studio, step, -1); });
  rows.add("step-later", QObject::tr("Move step up"), "Ctrl+Shift+Up",
           [](Studio& studio, NodeId step) { move_step(studio, step, 1); });
  rows.add("duplicate-step", QObject::tr("Duplicate step"), {}, copy_step);
  rows.add("freeze-step", QObject::tr("Freeze step"), {}, freeze_step);
  rows.add("reapply-step", QObject::tr("Apply to the new mesh by number"), {}, reapply_step);
  rows.add("reapply-step-by-position", QObject::tr("Apply to the new mesh"), {}, reapply_step_by_position);
  rows.add("delete-step", QObject::tr("Delete step"), "Ctrl+Shift+Backspace", remove_step);
}

void add_object_actions(ToolHost& host, ActionList& actions, QMenu* menu) {
  const StepRows rows{host, actions, menu};
  rows.add("duplicate-object", QObject::tr("Duplicate object"), "Ctrl+D",
           [](Studio& studio, NodeId) { copy_objects(studio, picked_or_active(studio)); });
  rows.add("delete-object", QObject::tr("Delete object"), {},
           [](Studio& studio, NodeId) { remove_objects(studio, picked_or_active(studio)); });
  rows.add("group", QObject::tr("Group"), "Ctrl+G",
           [](Studio& studio, NodeId) { group_objects(studio, picked(studio)); });
  rows.add("ungroup", QObject::tr("Ungroup"), "Ctrl+Shift+G",
           [](Studio& studio, NodeId) { ungroup_objects(studio, picked(studio)); });
}

void add_visibility_actions(ToolHost& host, ActionList& actions, QMenu* menu) {
  const StepRows rows{host, actions, menu};
  rows.add("hide", QObject::tr("Hide"), "Ctrl+H",
           [](Studio& studio, NodeId) { show_objects(studio, picked(studio), false); });
  rows.add("show-all", QObject::tr("Show all"), "Ctrl+Shift+H", [](Studio& studio, NodeId) {
    std::vector<NodeId> all;
    for (const WorkObject& object : studio.objects()) all.push_back(object.node);
    show_objects(studio, all, true);
  });
  rows.add("isolate", QObject::tr("Isolate selection"), "Ctrl+1",
           [](Studio& studio, NodeId) {
             studio.isolate(!studio.isolated().empty() ? std::vector<NodeId>() : picked(studio));
           })
      ->setCheckable(true);
}

void enable_step_actions(ToolHost& host) {
  const Studio& studio = host.studio();
  const auto enable = [&](const QString& name, bool enabled) { host.action(name)->setEnabled(enabled); };
  const NodeId step = active_step(studio);
  const WorkObject* object = studio.active();
  const Node* node = active_operation(studio);
  const auto fitting = operations_on(studio, step);
  for (const OperationDescription& operation : studio.registry().descriptions()) {
    if (QAction* action = host.action(adding_action(operation.id))) action->setEnabled(holds(fitting, operation.id));
  }
  added_steps(host)->setEnabled(!fitting.empty());
  const std::vector<NodeId> chain = object == nullptr ? std::vector<NodeId>() : object->chain;
  const auto place = std::ranges::find(chain, step);
  const bool in_chain = node != nullptr && place != chain.end();
  const bool has_earlier = in_chain && place - chain.begin() > 1;
  const bool has_later = in_chain && std::next(place) != chain.end();
  for (const char* name : {"duplicate-step", "freeze-step", "delete-step"}) enable(name, node != nullptr);
  enable("step-on", node != nullptr && can_be_off(studio.session().document(), studio.registry(), step));
  const StepState state = node == nullptr ? StepState::Source : step_at(studio, step).state;
  const bool attention = state == StepState::NeedsAttention;
  const bool old = attention || state == StepState::Held || state == StepState::Stale;
  host.action("freeze-step")->setText(old ? QObject::tr("Keep the shape") : QObject::tr("Freeze step"));
  enable("reapply-step", attention);
  enable("reapply-step-by-position", attention);
  enable("step-earlier", has_earlier);
  enable("step-later", has_later);
  host.action("step-on")->setChecked(node != nullptr && node->enabled);
  enable("duplicate-object", object != nullptr);
  enable("delete-object", object != nullptr);
  const std::vector<NodeId> chosen = picked(studio);
  enable("group", chosen.size() > 1 && !picks_elements(host));
  enable("ungroup", std::ranges::any_of(chosen, [&](NodeId each) { return !studio.object(each)->group.empty(); }));
  enable("hide", std::ranges::any_of(chosen, [&](NodeId each) { return studio.object(each)->visible; }));
  enable("show-all", std::ranges::any_of(studio.objects(), [](const WorkObject& each) { return !each.visible; }));
  enable("isolate", !studio.isolated().empty() || !chosen.empty());
  host.action("isolate")->setChecked(!studio.isolated().empty());
}

std::vector<QAction*> fixes_of(const ToolHost& host, const NodeFinding& found) {
  if (found.finding.code != connectivity_code) return {};
  return {host.action("reapply-step-by-position"), host.action("freeze-step")};
}

void show_step_menu(ToolHost& host, bool step, const QPoint& at) {
  QMenu menu;
  menu.addMenu(added_steps(host));
  menu.addSeparator();
  QStringList names =
      step ? QStringList{"step-on", "step-earlier", "step-later", "duplicate-step", "freeze-step", "delete-step"}
           : QStringList{"duplicate-object", "group", "ungroup", "hide", "isolate", "delete-object"};
  if (step && host.action("reapply-step")->isEnabled()) {
    names = QStringList{"reapply-step-by-position", "freeze-step", "reapply-step"} + names;
    names.removeDuplicates();
  }
  for (const QString& name : names) menu.addAction(host.action(name));
  menu.exec(at);
}

}  // namespace croquis::app

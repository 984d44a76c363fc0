// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/step_actions.h"

#include <QAction>
#include <algorithm>
#include <utility>

#include "app/studio/content.h"
#include "croquis/document/connectivity.h"
#include "croquis/workspace/chain.h"
#include "croquis/workspace/chain_edit.h"

namespace croquis::app {
namespace {

bool holds(const std::vector<const OperationDescription*>& operations, const std::string& id) {
  return std::ranges::any_of(operations, [&](const auto* operation) { return operation->id == id; });
}

}  // namespace

StepActions::StepActions(ToolHost& host, ActionList& actions) : host_(host) {
  QMenu* menu = actions.menu(QObject::tr("&Object"));
  add_operations(actions, menu);
  menu->addSeparator();
  add(actions, menu, "step-on", QObject::tr("&Enable step"), {}, [](Studio& studio, NodeId step) {
    const Node* node = studio.session().document().find(step);
    enable_step(studio, step, node != nullptr && !node->enabled);
  });
  actions.find("step-on")->setCheckable(true);
  add(actions, menu, "step-earlier", QObject::tr("Move step d&own"), "Ctrl+Shift+Down",
      [](Studio& studio, NodeId step) { move_step(studio, step, -1); });
  add(actions, menu, "step-later", QObject::tr("&Move step up"), "Ctrl+Shift+Up",
      [](Studio& studio, NodeId step) { move_step(studio, step, 1); });
  add(actions, menu, "duplicate-step", QObject::tr("D&uplicate step"), {}, copy_step);
  add(actions, menu, "freeze-step", QObject::tr("Free&ze step"), {}, freeze_step);
  add(actions, menu, "reapply-step", QObject::tr("Apply to the new mesh by &number"), {}, reapply_step);
  add(actions, menu, "reapply-step-by-position", QObject::tr("&Apply to the new mesh"), {}, reapply_step_by_position);
  add(actions, menu, "delete-step", QObject::tr("Delete &step"), "Ctrl+Shift+Backspace", remove_step);
  menu->addSeparator();
  add(actions, menu, "duplicate-object", QObject::tr("&Duplicate object"), "Ctrl+D",
      [](Studio& studio, NodeId) { copy_objects(studio, picked_or_active(studio)); });
  add(actions, menu, "delete-object", QObject::tr("Delete o&bject"), {},
      [](Studio& studio, NodeId) { remove_objects(studio, picked_or_active(studio)); });
  add(actions, menu, "group", QObject::tr("&Group"), {},
      [](Studio& studio, NodeId) { group_objects(studio, picked(studio)); });
  add(actions, menu, "ungroup", QObject::tr("U&ngroup"), "Ctrl+Shift+G",
      [](Studio& studio, NodeId) { ungroup_objects(studio, picked(studio)); });
  add(actions, menu, "hide", QObject::tr("&Hide"), "Ctrl+H",
      [](Studio& studio, NodeId) { show_objects(studio, picked(studio), false); });
  add(actions, menu, "show-all", QObject::tr("Sho&w all"), "Ctrl+Shift+H", [](Studio& studio, NodeId) {
    std::vector<NodeId> all;
    for (const WorkObject& object : studio.objects()) all.push_back(object.node);
    show_objects(studio, all, true);
  });
  add(actions, menu, "isolate", QObject::tr("&Isolate selection"), "Ctrl+1", [](Studio& studio, NodeId) {
    studio.isolate(!studio.isolated().empty() ? std::vector<NodeId>() : picked(studio));
  });
  actions.find("isolate")->setCheckable(true);
}

void StepActions::add(ActionList& actions, QMenu* menu, const QString& name, const QString& text, const QString& key,
                      std::function<void(Studio&, NodeId)> work) {
  const QList<QKeySequence> keys = key.isEmpty() ? QList<QKeySequence>() : QList<QKeySequence>{QKeySequence(key)};
  actions.add(menu, name, text, keys, [this, work = std::move(work)] {
    host_.attempt([&] { work(host_.studio(), active_step(host_.studio())); });
    host_.refresh();
  });
}

void StepActions::add_operations(ActionList& actions, QMenu* menu) {
  added_ = menu->addMenu(QObject::tr("&Add step"));
  for (const OperationDescription& description : host_.studio().registry().descriptions()) {
    const PortDescription* output = main_output(description);
    if (output == nullptr || output->type != ValueType::Mesh) continue;  // what it gives has no place in a chain
    const QString name = "add-step-" + QString::fromStdString(description.id);
    add(actions, added_, name, QString::fromStdString(description.title), {},
        [id = description.id](Studio& studio, NodeId step) {
          add_step(studio, step, id, first_parameters(studio, id));
        });
    operations_[description.id] = actions.find(name);
    operations_[description.id]->setToolTip(QString::fromStdString(description.sentence));
  }
}

void StepActions::enable(const QString& name, bool enabled) { host_.action(name)->setEnabled(enabled); }

void StepActions::refresh() {
  const Studio& studio = host_.studio();
  const NodeId step = active_step(studio);
  const WorkObject* object = studio.active();
  const Node* node = active_operation(studio);
  const auto fitting = operations_on(studio, step);
  for (const auto& [id, action] : operations_) action->setEnabled(holds(fitting, id));
  added_->setEnabled(!fitting.empty());
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
  host_.action("freeze-step")->setText(old ? QObject::tr("&Keep the shape") : QObject::tr("Free&ze step"));
  enable("reapply-step", attention);
  enable("reapply-step-by-position", attention);
  enable("step-earlier", has_earlier);
  enable("step-later", has_later);
  host_.action("step-on")->setChecked(node != nullptr && node->enabled);
  enable("duplicate-object", object != nullptr);
  enable("delete-object", object != nullptr);
  const std::vector<NodeId> chosen = picked(studio);
  enable("group", chosen.size() > 1 && !host_.picks_elements());
  // Of elements the same key makes a crease set.
  host_.action("group")->setShortcut(host_.picks_elements() ? QKeySequence() : QKeySequence("Ctrl+G"));
  enable("ungroup", std::ranges::any_of(chosen, [&](NodeId each) { return !studio.object(each)->group.empty(); }));
  enable("hide", std::ranges::any_of(chosen, [&](NodeId each) { return studio.object(each)->visible; }));
  enable("show-all", std::ranges::any_of(studio.objects(), [](const WorkObject& each) { return !each.visible; }));
  enable("isolate", !studio.isolated().empty() || !chosen.empty());
  host_.action("isolate")->setChecked(!studio.isolated().empty());
}

std::vector<QAction*> StepActions::fixes_of(const NodeFinding& found) const {
  if (found.finding.code != connectivity_code) return {};
  return {host_.action("reapply-step-by-position"), host_.action("freeze-step")};
}

void StepActions::show_menu(bool step, const QPoint& at) {
  QMenu menu;
  menu.addMenu(added_);
  menu.addSeparator();
  QStringList names =
      step ? QStringList{"step-on", "step-earlier", "step-later", "duplicate-step", "freeze-step", "delete-step"}
           : QStringList{"duplicate-object", "group", "ungroup", "hide", "isolate", "delete-object"};
  if (step && host_.action("reapply-step")->isEnabled()) {
    names = QStringList{"reapply-step-by-position", "freeze-step", "reapply-step"} + names;
    names.removeDuplicates();
  }
  for (const QString& name : names) menu.addAction(host_.action(name));
  menu.exec(at);
}

}  // namespace croquis::app

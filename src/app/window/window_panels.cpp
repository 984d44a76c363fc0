// SPDX-License-Identifier: GPL-3.0-or-later
// The menus of the window beside File, and its panels.
#include <QAction>
#include <QActionGroup>
#include <QDockWidget>
#include <QLabel>
#include <QMenu>
#include <QScrollArea>
#include <QVBoxLayout>
#include <algorithm>
#include <cstring>
#include <utility>

#include "app/files/mesh_export.h"
#include "app/panels/attribute_panel.h"
#include "app/panels/lists.h"
#include "app/panels/object_names.h"
#include "app/panels/panel.h"
#include "app/views/viewport.h"
#include "app/window/command_palette.h"
#include "app/window/help_line.h"
#include "app/window/help_pages.h"
#include "app/window/main_window.h"
#include "app/window/panel_docks.h"
#include "app/window/preferences.h"
#include "app/window/step_actions.h"
#include "app/window/theme.h"
#include "croquis/base/error.h"
#include "croquis/tools/recording/general_steps.h"

namespace croquis::app {
namespace {

constexpr int most_cameras = 9;  // in the menu

/// What can be done without what is open, or whatever it is; all else belongs to the views.
bool needs_no_document(const QString& action) {
  return action == "new" || action.startsWith("new-") || action == "open" || action == "import" ||
         action == "start-page" || action == "quit" || action == "palette" || action == "preferences" ||
         action == "reset-layout" || action.startsWith("help");
}

bool asks_for_file(const QString& action) {
  return action == "open" || action == "import" || action.startsWith("save") ||
         (action.startsWith("export") && !action.startsWith("export-unit"));
}

QString camera_action(int place) { return QString("camera-%1").arg(place + 1); }

/// The tools with few modes of their own come last: their turn is first. @return false: it is no tool's
bool ask_tools(MainWindow& window, EditCommand command) {
  const auto& tools = window.tools();
  return std::any_of(tools.rbegin(), tools.rend(), [&](const auto& tool) { return tool->command(command); });
}

void select_all(MainWindow& window) {
  const auto& tools = window.tools();
  if (std::ranges::any_of(tools, [](const auto& tool) { return tool->command(EditCommand::SelectAll); })) return;
  Selection selection;
  for (const auto& tool : tools) tool->add_all_to(selection);
  for (const WorkObject& object : window.studio().objects()) {
    if (object.cage != 0 && object.visible) selection.push_back({object.node, ""});
  }
  window.studio().session().select(std::move(selection));
}

void delete_selection(MainWindow& window) {
  if (!ask_tools(window, EditCommand::Delete)) {
    window.record(recorded::Action{"delete"});
    remove_objects(window.studio(), picked(window.studio()));
  }
  window.refresh();
}

void select_none(MainWindow& window) {
  if (abandon(window.views())) return;
  window.viewport().marking_menu().dismiss();
  if (!ask_tools(window, EditCommand::SelectNone)) window.studio().session().select({});
}

void look_through_camera(MainWindow& window, int place) {
  Views& views = window.views();
  const std::vector<SceneCamera> cameras = scene_cameras(window.studio());
  const NodeId node = place < static_cast<int>(cameras.size()) ? cameras[static_cast<std::size_t>(place)].node : 0;
  look_through(views, views.through == node ? 0 : node);
  if (node != 0 && !views.layout.pane(PerspectiveView).visible()) views.layout.show_alone(PerspectiveView);
  window.refresh();
}

void add_edit_menu(MainWindow& window) {
  QMenu* menu = window.parts().actions->menu(MenuId::Edit);
  const auto add = [&](const char* name, const QString& text, const QList<QKeySequence>& keys, auto work,
                       Recorded recorded = Recorded::AsAction) {
    window.parts().actions->add(
        menu, name, text, keys, [&window, work] { work(window); }, recorded);
  };
  const auto undo = [](MainWindow& of) { of.studio().session().undo(); };
  const auto redo = [](MainWindow& of) { of.studio().session().redo(); };
  add("undo", QObject::tr("Undo"), {QKeySequence("Ctrl+Z"), QKeySequence("Z")}, undo);
  add("redo", QObject::tr("Redo"), {QKeySequence("Ctrl+Shift+Z"), QKeySequence("Ctrl+Y"), QKeySequence("Shift+Z")},
      redo);
  menu->addSeparator();
  add("delete", QObject::tr("Delete"), {QKeySequence::Delete, QKeySequence(Qt::Key_Backspace)}, delete_selection,
      Recorded::ByItself);
  add_object_actions(window, *window.parts().actions, menu);
  menu->addSeparator();
  add(
      "palette", QObject::tr("Search commands…"), {QKeySequence("F3"), QKeySequence("Ctrl+Shift+P")},
      [](MainWindow& of) { show_palette(of, all_commands(of)); }, Recorded::ByItself);
  add("preferences", QObject::tr("Preferences…"), {QKeySequence("Ctrl+,")}, show_preferences, Recorded::ByItself);
}

void add_select_menu(MainWindow& window) {
  ActionList& actions = *window.parts().actions;
  QMenu* menu = actions.menu(MenuId::Select);
  actions.add(menu, "select-all", QObject::tr("All"), {QKeySequence::SelectAll}, [&window] { select_all(window); });
  actions.add(menu, "deselect", QObject::tr("None"), {QKeySequence("Escape")}, [&window] { select_none(window); });
  menu->addSeparator();
}

void add_view_menu(MainWindow& window) {
  ActionList& actions = *window.parts().actions;
  Views* views = &window.views();
  QMenu* menu = actions.menu(MenuId::View);
  const auto add = [&](const QString& name, const QString& text, const QString& key, std::function<void()> work) {
    return actions.add(menu, name, text, key.isEmpty() ? QList<QKeySequence>() : QList{QKeySequence(key)},
                       std::move(work));
  };
  add("frame-all", QObject::tr("Frame all"), "A", [views] { frame_all(*views); });
  add("frame-selection", QObject::tr("Frame selection"), "F", [views] { frame_selection(*views); });
  add("layout", QObject::tr("Maximise view"), "Space", [views] { toggle_layout(*views); });
  add("two-views", QObject::tr("Sketch and perspective"), "Ctrl+Space",
      [views] { views->layout.arrange(Arrangement::SketchAndSolid); });
  add("four-views", QObject::tr("Four views"), "Shift+Space", [views] { views->layout.arrange(Arrangement::Four); });
  add("perspective-alone", QObject::tr("Perspective alone"), {},
      [views] { views->layout.show_alone(PerspectiveView); });
  add("front-alone", QObject::tr("Front alone"), {}, [views] { views->layout.show_alone(SketchView); });
  add("top-alone", QObject::tr("Top alone"), {}, [views] { views->layout.show_alone(TopView); });
  add("side-alone", QObject::tr("Side alone"), {}, [views] { views->layout.show_alone(SideView); });
  for (int place = 0; place < most_cameras; ++place) {
    QAction* camera = add(camera_action(place), {}, {}, [&window, place] { look_through_camera(window, place); });
    camera->setCheckable(true);
    camera->setVisible(false);
  }
  menu->addSeparator();
  auto* shading = new QActionGroup(&window);
  const auto add_shading = [&](const QString& name, const QString& text, const QString& key, MeshLook look) {
    QAction* action = add(name, text, key, [views, look] {
      views->look = look;
      emit views->changed();
    });
    action->setCheckable(true);
    action->setChecked(look == MeshLook::Shaded);
    shading->addAction(action);
  };
  add_shading("wire", QObject::tr("Wire"), "4", MeshLook::Wire);
  add_shading("shaded", QObject::tr("Shaded"), "5", MeshLook::Shaded);
  add_shading("shaded-wire", QObject::tr("Shaded, with wire"), "6", MeshLook::ShadedWire);
  add("flat", QObject::tr("Flat shading"), "Shift+5", [views, &window] {
    views->objects.set_flat(window.action("flat")->isChecked());
  })->setCheckable(true);
  add("zebra", QObject::tr("Zebra stripes"), "Shift+6", [views, &window] {
    views->zebra = window.action("zebra")->isChecked();
    emit views->changed();
  })->setCheckable(true);
  menu->addSeparator();
  add_visibility_actions(window, actions, menu);
}

void choose_nodes(MainWindow& window, const std::vector<NodeId>& nodes) {
  recorded::NodeChoice step;
  for (const NodeId id : nodes) {
    if (const Node* node = window.studio().session().document().find(id)) step.nodes.push_back(node->name);
  }
  select_nodes(window.studio(), nodes);
  if (!step.nodes.empty()) window.record(step);
}

/// The tools with few modes of their own come last in the list: their turn is first.
void show_in_tools(MainWindow& window, const Target& target) {
  const auto& tools = window.tools();
  std::any_of(tools.rbegin(), tools.rend(), [&](const auto& tool) { return tool->show(target); });
}

void choose_step(MainWindow& window, NodeId step) {
  choose_nodes(window, {step});
  if (const Node* node = window.studio().session().document().find(step)) show_in_tools(window, node);
}

std::vector<ObjectRow> rows_of(MainWindow& window, const WorkObject& object, NodeId node) {
  std::vector<ObjectRow> rows;
  for (const auto& tool : window.tools()) {
    for (ObjectRow& row : tool->rows(object, node)) rows.push_back(std::move(row));
  }
  return rows;
}

/// The object that a finding is about, where there are several; else empty.
QString owner_of(MainWindow& window, const NodeFinding& found) {
  const Studio& studio = window.studio();
  const WorkObject* object = studio.object(found.node);
  if (object == nullptr) return {};
  for (const auto& tool : window.tools()) {
    if (const QString owner = tool->owner_of(found); !owner.isEmpty()) return owner;
  }
  return studio.objects().size() < 2 ? QString() : shown_name(*object);
}

void take_attributes(MainWindow& window, AttributePanel* attributes, PlacementFields* placement) {
  Studio& studio = window.studio();
  QObject::connect(
      attributes, &AttributePanel::parameter_edited, &window,
      [&window, &studio](NodeId node, const std::string& parameter, const ParameterValue& value, bool dragging) {
        studio.set_parameter(node, parameter, value, dragging);
        const Node* edited = studio.session().document().find(node);
        if (!dragging && edited != nullptr) window.record(recorded::Set{edited->name, parameter, value});
      });
  QObject::connect(placement, &PlacementFields::placed, &window,
                   [&window, &studio](NodeId node, const Placement& place) {
                     const WorkObject* object = studio.object(node);
                     if (object == nullptr) return;
                     const recorded::Place step{{object->name}, {place}};
                     if (window.attempt([&] { place_objects(studio, {{node, place}}); })) window.record(step);
                   });
}

void take_objects(MainWindow& window, ObjectList* list) {
  Studio& studio = window.studio();
  const auto take = [&](auto signal, auto work) { QObject::connect(list, signal, &window, work); };
  take(&ObjectList::objects_chosen,
       [&window, &studio](const std::vector<NodeId>& nodes) { choose_nodes(window, with_groups(studio, nodes)); });
  take(&ObjectList::step_chosen, [&window](NodeId step) { choose_step(window, step); });
  take(&ObjectList::parts_chosen, [&window](NodeId node, const std::vector<std::string>& parts) {
    window.attempt([&] {
      std::ranges::any_of(window.tools(), [&](const auto& tool) { return tool->show(ChosenParts{node, parts}); });
    });
  });
  take(&ObjectList::step_enabled, [&window, &studio](NodeId step, bool enabled) {
    window.attempt([&] { enable_step(studio, step, enabled); });
    window.refresh();
  });
  take(&ObjectList::menu_wanted, [&window](NodeId, bool step, const QPoint& at) { show_step_menu(window, step, at); });
  take(&ObjectList::renamed, [&studio](NodeId node, const std::string& name) { rename_object(studio, node, name); });
  take(&ObjectList::shown,
       [&studio](const std::vector<NodeId>& objects, bool visible) { show_objects(studio, objects, visible); });
  take(&ObjectList::group_renamed,
       [&studio](const std::string& group, const std::string& name) { rename_group(studio, group, name); });
}

void take_findings(MainWindow& window, FindingsList* findings) {
  QObject::connect(findings, &FindingsList::finding_chosen, &window,
                   [&window](const NodeFinding& found) { show_finding(window, found); });
  QObject::connect(findings, &FindingsList::fix_chosen, &window, [&window](const NodeFinding& found, QAction* fix) {
    choose_step(window, found.node);
    fix->trigger();
  });
}

void show_lists(MainWindow& window, ObjectList* objects, FindingsList* findings) {
  const Studio& studio = window.studio();
  objects->show_objects(studio);
  enable_step_actions(window);
  // Those of the files first: what they lack is missing everywhere else.
  std::vector<NodeFinding> all;
  for (const Finding& finding : window.files().warnings()) all.push_back({0, finding});
  for (const NodeFinding& found : findings_of(studio)) all.push_back(found);
  const bool were_none = findings->count() == 0;
  findings->show_findings(
      all, [&](const NodeFinding& found) { return owner_of(window, found); },
      [&](const NodeFinding& found) { return fixes_of(window, found); });
  // They share one place: what is wrong comes to the front when it begins, and leaves it when all is well.
  if (were_none != (findings->count() == 0)) window.parts().docks->find(were_none ? "findings" : "history")->raise();
  QString status;
  for (const auto& tool : window.tools()) {
    if (status.isEmpty()) status = tool->words().status;
  }
  window.parts().help->show_status(status);
}

void add_window_menu(MainWindow& window) {
  ActionList& actions = *window.parts().actions;
  PanelDocks* docks = window.parts().docks;
  QMenu* menu = actions.menu(MenuId::Window);
  for (QDockWidget* dock : docks->all()) {
    const QString name = "panel-" + dock->objectName().chopped(static_cast<int>(strlen("-dock")));
    QAction* shown = actions.add(menu, name, dock->windowTitle(), {}, [&window, docks, dock, name] {
      docks->set_wanted(dock, window.action(name)->isChecked());
    });
    shown->setCheckable(true);
    shown->setChecked(true);
    QObject::connect(docks, &PanelDocks::wanted_changed, shown, [dock, shown](const QDockWidget* changed, bool wanted) {
      if (changed == dock) shown->setChecked(wanted);
    });
  }
  menu->addSeparator();
  actions.add(menu, "reset-layout", QObject::tr("Restore default layout"), {},
              [&window, first = window.saveState()] { reset_layout(window, first); });
}

/// Nothing acts on a document that the start page hides.
void gate_document_actions(MainWindow& window) {
  // Actions that have no group of their own get one: a group that is off leaves each action's own state alone.
  auto* others = new QActionGroup(&window);
  others->setExclusionPolicy(QActionGroup::ExclusionPolicy::None);
  for (QAction* action : window.actions()) {
    if (action->actionGroup() == nullptr && !needs_no_document(action->objectName())) others->addAction(action);
  }
}

}  // namespace

void add_actions(MainWindow& window) {
  WindowParts& parts = window.parts();
  parts.actions = std::make_unique<ActionList>(window, [&window](const QString& name, Recorded recorded) {
    // Those that ask for a file are recorded with its name, once it is known.
    if (recorded == Recorded::AsAction && !asks_for_file(name)) window.record(recorded::Action{name.toStdString()});
    window.parts().stalls.note(name);
    window.parts().help->clear();
  });
  parts.actions->bar("tools", QObject::tr("Tools"));
  add_file_menu(window);
  add_edit_menu(window);
  add_select_menu(window);
  add_step_actions(window, *parts.actions);
  add_view_menu(window);
}

void add_last_menus(MainWindow& window) {
  add_window_menu(window);
  add_help_menu(window);
  gate_document_actions(window);
  apply_preferences(window);
}

void enable_actions(MainWindow& window) {
  const Studio& studio = window.studio();
  const Session& session = studio.session();
  const WorkObject* object = studio.active();
  const auto enable = [&](const QString& name, bool enabled) { window.action(name)->setEnabled(enabled); };
  const auto has_selection = [](const auto& tool) { return tool->state().has_selection; };
  enable("undo", session.can_undo());
  enable("redo", session.can_redo());
  enable("delete", !session.selection().empty() || std::ranges::any_of(window.tools(), has_selection));
  const bool shown = object != nullptr && object->shown() != nullptr;
  for (const char* name : {"export-solid", "export-visible", "export-all", "export-picture"}) enable(name, shown);
  enable("export-step", exact_solid(studio) != nullptr);
  for (const OperationDescription* exported : result_exports(studio))
    enable("export-" + QString::fromStdString(exported->id), can_export(studio, *exported));
  window.parts().actions->show_mode(window.views().mode);
  show_cameras(window);
}

void show_cameras(MainWindow& window) {
  const std::vector<SceneCamera> cameras = scene_cameras(window.studio());
  for (int place = 0; place < most_cameras; ++place) {
    QAction* entry = window.action(camera_action(place));
    const bool there = place < static_cast<int>(cameras.size());
    entry->setVisible(there);
    if (!there) continue;
    const SceneCamera& camera = cameras[static_cast<std::size_t>(place)];
    entry->setText(QObject::tr("Camera of %1").arg(camera.name));
    entry->setChecked(window.views().through == camera.node);
  }
}

std::function<void()> add_panels(MainWindow& window) {
  PanelDocks* docks = window.parts().docks = new PanelDocks(window);
  const auto rows = [&window](const WorkObject& object, NodeId node) { return rows_of(window, object, node); };
  auto* objects = new ObjectList(rows, &window);
  auto* attributes = new AttributePanel(&window);
  auto* findings = new FindingsList(&window);
  auto* fields = new QWidget(&window);
  auto* column = new QVBoxLayout(fields);
  auto* placement = new PlacementFields(fields);
  column->setContentsMargins({});
  column->setSpacing(0);
  auto* hint = new QLabel(QObject::tr("Numbers of what is selected can be changed here."), fields);
  hint->setObjectName("attributes-hint");
  hint->setWordWrap(true);
  hint->setContentsMargins(6, 6, 6, 6);
  set_tone(*hint, QStringLiteral("faint"));
  column->addWidget(hint);
  column->addWidget(placement);
  column->addWidget(attributes, 1);
  docks->add(QObject::tr("Objects"), objects, "objects");
  docks->add(QObject::tr("Attributes"), scrolled(fields), "attributes");
  docks->add(QObject::tr("Findings"), findings, "findings");
  take_attributes(window, attributes, placement);
  take_objects(window, objects);
  take_findings(window, findings);
  return [&window, objects, attributes, findings, placement, hint] {
    const Studio& studio = window.studio();
    hint->setVisible(studio.active() == nullptr);
    attributes->show_node(studio, active_operation(studio));
    placement->follow(studio);
    show_lists(window, objects, findings);
  };
}

void select_nodes(Studio& studio, const std::vector<NodeId>& nodes) {
  Selection selection;
  for (const NodeId node : nodes) selection.push_back({node, ""});
  if (!nodes.empty()) {
    const WorkObject* object = studio.object(nodes.front());
    studio.set_active(object == nullptr ? nodes.front() : object->node);
  }
  studio.session().select(std::move(selection));
}

void show_parameter(MainWindow& window, NodeId step, const std::string& parameter) {
  choose_step(window, step);
  window.refresh();
  QDockWidget* dock = window.parts().docks->find("attributes");
  window.parts().docks->set_wanted(dock, true);
  dock->raise();
  dock->findChild<AttributePanel*>()->show_parameter(parameter);
}

void show_finding(MainWindow& window, const NodeFinding& found) {
  if (found.node == 0) return show_opening_report(window, window.files().path(), window.files().warnings());
  show_in_tools(window, found);
}

}  // namespace croquis::app

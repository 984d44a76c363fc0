// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tools/mesh/mesh_editing_tool.h"

#include <QAction>
#include <QDockWidget>
#include <QLabel>
#include <QPushButton>
#include <QToolBar>
#include <algorithm>

#include "app/panels/finding_elements.h"
#include "app/studio/own_space.h"
#include "app/tools/mesh/crease_set_panel.h"
#include "app/tools/mesh/edit_panel.h"
#include "app/tools/mesh/tag_panel.h"
#include "app/views/viewport.h"
#include "app/window/panel_docks.h"
#include "croquis/workspace/chain.h"

namespace croquis::app {
namespace {

constexpr const char* value_style =
    "background: #2b2d31; color: #f2f3f5; border: 1px solid #609ce6; border-radius: 5px; padding: 1px 6px;"
    " font-size: 12px";
constexpr QPointF value_offset(14, -24);

/// The modes that are about meshes, with what a drag does in them.
const std::map<QString, MeshHandles> mesh_modes{{select_mode, MeshHandles::Select},
                                                {"move", MeshHandles::Move},
                                                {"rotate", MeshHandles::Rotate},
                                                {"scale", MeshHandles::Scale},
                                                {"sharpen", MeshHandles::Sharpen}};

}  // namespace

MeshEditingTool::MeshEditingTool(ToolHost& host)
    : Tool(host),
      mesh_(host.studio(), host.viewport(), nullptr),
      scale_(host.studio()),
      legend_(new SharpnessLegend(&host.viewport())),
      value_(make_chip_label(host.viewport(), value_style)) {
  value_->setObjectName("edge-value");
  connect(&mesh_, &MeshInteraction::changed, this, &Tool::changed);
  connect(&mesh_, &MeshInteraction::committed, this, &Tool::committed);
  connect(&mesh_, &MeshInteraction::committed, this, &MeshEditingTool::show_last_edit);
  connect(&mesh_, &MeshInteraction::mode_changed, this, &Tool::state_changed);
  connect(&mesh_, &MeshInteraction::told, this, &Tool::told);
}

void MeshEditingTool::make_panels(PanelDocks& panels) {
  panels_ = &panels;
  for (const char* name : {"show-cage", "show-both", "show-smooth"}) {
    const QAction* view = host().action(name);
    connect(view, &QAction::triggered, this, [this, view] { mesh_.hide_cage(view->objectName() == "show-smooth"); });
  }
  tags_ = new TagPanel(mesh_, nullptr);
  sets_ = new CreaseSetPanel(mesh_, nullptr);
  edges_dock_ = panels.add_column(tr("Sharp edges"), tags_, "edges");
  sets_dock_ = panels.add(tr("Crease sets"), sets_, "sets");
  // Below the attributes, in one place.
  panels.split_below("attributes", edges_dock_);
  panels.tabify("edges", sets_dock_);
  edges_dock_->raise();
  last_edit_ = new EditPanel(mesh_, nullptr);
  last_edit_dock_ = panels.add_column(tr("Last edit"), last_edit_, "last-edit");
}

/// A single object that comes from a drawing needs no picking: a plain drag rotates the view then.
bool MeshEditingTool::works() const {
  const std::size_t enough = mode() == select_mode ? 2 : 1;
  return mesh_modes.contains(mode()) && (studio().has_cage() || studio().objects().size() >= enough);
}

/// Objects aren't moved on the sheets that they are drawn on.
bool MeshEditingTool::works_in(int view) const {
  return works() && (studio().has_cage() || !host().viewport().is_drawn_on(view));
}

void MeshEditingTool::take(const PointerEvent& event) {
  if (event.action == PointerEvent::Action::Leave) return mesh_.leave();
  mesh_.take(event);
}

void MeshEditingTool::set_mode(const QString& mode) {
  Tool::set_mode(mode);
  const auto handles = mesh_modes.find(mode);
  studio().set_edits_elements(handles != mesh_modes.end() && mesh_.tool().selection().mode() != MeshMode::Object);
  mesh_.set_handles(handles == mesh_modes.end() ? MeshHandles::Select : handles->second);
}

void MeshEditingTool::set_mesh_mode(MeshMode mode) {
  if (!mesh_modes.contains(this->mode())) host().set_mode(select_mode);
  mesh_.set_mode(mode);
}

/// Elements of meshes, and the cage of a step that another tool's panels are about.
bool MeshEditingTool::open_step(const Node& step) {
  const OperationDescription* operation = studio().description(step.operation);
  const PortDescription* input = operation == nullptr ? nullptr : main_input(*operation);
  const bool has_elements = mesh_in(step) != nullptr || (input != nullptr && input->type == ValueType::Mesh);
  if (has_elements && !mesh_modes.contains(mode())) host().set_mode(select_mode);
  return has_elements;
}

QString MeshEditingTool::help() const {
  const WorkObject* object = studio().active();
  return mesh_.help(object == nullptr ? QString() : host().offer_for(*object));
}

// ---- Keys of the Edit menu

bool MeshEditingTool::select_all() {
  if (!picks_elements()) return false;
  mesh_.act([](MeshTool& tool) { return tool.selection().select_all(); });
  return true;
}

bool MeshEditingTool::select_none() {
  mesh_.act([](MeshTool& tool) { return tool.selection().select_none(); });
  return false;  // objects are deselected, too
}

bool MeshEditingTool::delete_selection() {
  if (!picks_elements()) return false;
  mesh_.act([](MeshTool& tool) { return tool.edits().delete_selected(); });
  return true;
}

bool MeshEditingTool::has_selection() const { return !studio().session().components().empty(); }

bool MeshEditingTool::pick(ComponentKind kind, const std::vector<Index>& elements) {
  if (elements.empty()) return false;
  mesh_.follow();
  set_mesh_mode(mode_of(kind));
  mesh_.follow();
  mesh_.act([&](MeshTool& tool) { return tool.selection().pick(kind, elements); });
  return true;
}

bool MeshEditingTool::show_finding(const NodeFinding& found) {
  studio().set_active(found.node);
  mesh_.follow();
  MeshTool& tool = mesh_.tool();
  if (!tool.editable().mesh()) return false;
  const FoundElements elements = elements_of(found.finding, *tool.editable().topology());
  if (!pick(elements.kind, elements.elements)) return false;
  host().viewport().frame_selection();
  return true;
}

// ---- The eye

void MeshEditingTool::adjust(ObjectScenes::Wanted& wanted, int) const {
  if (!picks_elements()) return;
  wanted.edited = mesh_.tool().editable().node();
  wanted.edited_cage = !mesh_.cage_hidden();
}

void MeshEditingTool::add_to(render::Scene& scene, int view) { mesh_.add_to(scene, view, works_in(view)); }

std::optional<SelectionFrame> MeshEditingTool::selection_frame(int) const {
  if (mesh_.overlay().selection_bounds().empty()) return std::nullopt;
  if (mesh_.picks_objects()) return std::nullopt;
  const render::Bounds& bounds = mesh_.overlay().selection_bounds();
  return SelectionFrame{render::placed(bounds, matrix_of(studio().active()->placement.map())), std::nullopt, false};
}

void MeshEditingTool::place_chips(ChipPlaces& places) {
  places.put_legend(*legend_, mesh_.overlay().shows_tags());
  const auto& value = mesh_.hovered_value();
  if (!value) return value_->hide();
  value_->setText(value->text);
  value_->adjustSize();
  const QPointF in_view(value->pixel.x(), value->pixel.y());
  places.put(*value_, places.layout().pane(value->view).rect.topLeft() + in_view + value_offset);
}

void MeshEditingTool::show_last_edit() {
  last_edit_->follow();
  panels_->set_useful(last_edit_dock_, last_edit_->useful());
}

void MeshEditingTool::refresh() {
  const WorkObject* object = studio().active();
  const bool mesh = object != nullptr && object->cage != 0;
  for (QAction* action : mesh_actions_) action->setEnabled(mesh);
  // Objects are grouped by the same key.
  host().action("crease-set")->setEnabled(mesh && picks_elements());
  host().action("crease-set")->setShortcut(picks_elements() ? QKeySequence("Ctrl+G") : QKeySequence());
  // Picking elements begins the work on a computed mesh.
  for (const auto& [mode, action] : mode_actions_) action->setEnabled(object != nullptr && object->editable != 0);
  const auto shown = mode_actions_.find(mesh_.tool().selection().mode());
  if (shown != mode_actions_.end()) shown->second->setChecked(true);
  const Tool* at_work = host().viewport().tool_in(PerspectiveView);
  const bool useful = mesh && (at_work == nullptr || at_work == this);
  bar_->setVisible(useful && host().shows_views());
  for (const char* name : {"move", "rotate", "scale"}) host().action(name)->setEnabled(object != nullptr);
  host().action("sharpen")->setEnabled(mesh);
  tags_->follow(studio().session().components());
  for (const auto& [action, edit] : edit_actions_)
    action->setEnabled(mesh && mesh_.tool().edits().fits_selection(edit));
  sets_->follow();
  show_last_edit();
  panels_->set_useful(edges_dock_, useful);
  panels_->set_useful(sets_dock_, useful);
  follow_scale();
}

}  // namespace croquis::app

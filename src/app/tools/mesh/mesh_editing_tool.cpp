// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tools/mesh/mesh_editing_tool.h"

#include <QAction>
#include <QDockWidget>
#include <QLabel>
#include <QPushButton>
#include <QToolBar>
#include <algorithm>

#include "app/panels/finding_elements.h"
#include "app/replay/replays.h"
#include "app/tools/mesh/mesh_panels.h"
#include "app/views/own_space.h"
#include "app/views/viewport.h"
#include "app/window/panel_docks.h"
#include "croquis/render/sharpness_color.h"
#include "croquis/tools/mesh/mesh_steps.h"
#include "croquis/tools/recording/general_steps.h"
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

/// The object of that name, else the one with such a node in its chain.
const WorkObject& object_with_node(const Studio& studio, const std::string& name) {
  for (const auto& node : studio.session().document().nodes()) {
    const WorkObject* object = node->name == name ? studio.object(node->id) : nullptr;
    if (object != nullptr && object->node != node->id && !object->begins_with_mesh) return *object;
  }
  return object_named(studio, name);
}

/// The colours of tagged edges with what they mean.
Legend* make_sharpness_legend(QWidget* views) {
  std::vector<Legend::Row> rows;
  for (const render::SharpnessSample& sample : render::sharpness_legend()) {
    const QPen pen(QColor(sample.color.r, sample.color.g, sample.color.b), render::sharpness_width(sample.sharpness),
                   Qt::SolidLine, Qt::RoundCap);
    rows.push_back({QString::fromStdString(sample.label), [pen](QPainter& painter, int y) {
                      painter.setPen(pen);
                      const double middle = y + Legend::row_height / 2.0;
                      painter.drawLine(QPointF(10, middle), QPointF(32, middle));
                    }});
  }
  return new Legend(views, "sharpness-legend", MeshEditingTool::tr("Sharpness"),
                    MeshEditingTool::tr("Colours of tagged edges by sharpness"), std::move(rows));
}

}  // namespace

MeshEditingTool::MeshEditingTool(ToolHost& host)
    : Tool(host, "Meshes"),
      tool_(host.studio()),
      mover_(host.studio()),
      legend_(make_sharpness_legend(&host.viewport())),
      value_(make_chip_label(host.viewport(), value_style)) {
  value_->setObjectName("edge-value");
  connect(this, &Tool::committed, this, &MeshEditingTool::show_last_edit);
}

void MeshEditingTool::make_panels(PanelDocks& panels) {
  panels_ = &panels;
  for (const char* name : {"show-cage", "show-both", "show-smooth"}) {
    const QAction* view = host().action(name);
    connect(view, &QAction::triggered, this, [this, view] { hide_cage(view->objectName() == "show-smooth"); });
  }
  tags_ = new TagPanel(*this, nullptr);
  sets_ = new CreaseSetPanel(*this, nullptr);
  edges_dock_ = panels.add_column(tr("Sharp edges"), tags_, "edges");
  sets_dock_ = panels.add(tr("Crease sets"), sets_, "sets");
  // Below the attributes, in one place.
  panels.split_below("attributes", edges_dock_);
  panels.tabify("edges", sets_dock_);
  edges_dock_->raise();
  last_edit_ = new EditPanel(*this, nullptr);
  last_edit_dock_ = panels.add_column(tr("Last edit"), last_edit_, "last-edit");
}

/// A single object that comes from a drawing needs no picking: a plain drag rotates the view then.
bool MeshEditingTool::works() const {
  const std::size_t enough = mode() == select_mode ? 2 : 1;
  return mesh_modes.contains(mode()) && (has_cage(studio()) || studio().objects().size() >= enough);
}

/// Objects aren't moved on the sheets that they are drawn on.
bool MeshEditingTool::works_in(int view) const {
  return works() && (has_cage(studio()) || !host().viewport().is_drawn_on(view));
}

void MeshEditingTool::set_mode(const QString& mode) {
  Tool::set_mode(mode);
  const auto handles = mesh_modes.find(mode);
  studio().set_edits_elements(handles != mesh_modes.end() && tool_.selection().mode() != MeshMode::Object);
  set_handles(handles == mesh_modes.end() ? MeshHandles::Select : handles->second);
}

void MeshEditingTool::set_mesh_mode(MeshMode mode) {
  if (!mesh_modes.contains(this->mode())) host().set_mode(select_mode);
  enter_mesh_mode(mode);
}

/// Elements of meshes, and the cage of a step that another tool's panels are about.
bool MeshEditingTool::open_step(const Node& step) {
  const OperationDescription* operation = studio().description(step.operation);
  const PortDescription* input = operation == nullptr ? nullptr : main_input(*operation);
  const bool has_elements = mesh_in(step) != nullptr || (input != nullptr && input->type == ValueType::Mesh);
  if (has_elements && !mesh_modes.contains(mode())) host().set_mode(select_mode);
  return has_elements;
}

// ---- Keys of the Edit menu

bool MeshEditingTool::command(EditCommand command) {
  if (command == EditCommand::SelectNone) {
    act([](MeshTool& tool) { return tool.selection().select_none(); });
    return false;  // objects are deselected, too
  }
  const bool selects = command == EditCommand::SelectAll;
  if (!picks_elements() || !(selects || command == EditCommand::Delete)) return false;
  act([=](MeshTool& tool) { return selects ? tool.selection().select_all() : tool.edits().delete_selected(); });
  return true;
}

bool MeshEditingTool::has_selection() const { return !studio().session().components().empty(); }

bool MeshEditingTool::pick(ComponentKind kind, const std::vector<Index>& elements) {
  if (elements.empty()) return false;
  follow();
  set_mesh_mode(mode_of(kind));
  follow();
  act([&](MeshTool& tool) { return tool.selection().pick(kind, elements); });
  return true;
}

bool MeshEditingTool::show_finding(const NodeFinding& found) {
  studio().set_active(found.node);
  follow();
  if (!tool_.editable().mesh()) return false;
  const FoundElements elements = elements_of(found.finding, *tool_.editable().topology());
  if (!pick(elements.kind, elements.elements)) return false;
  host().viewport().frame_selection();
  return true;
}

// ---- The eye

void MeshEditingTool::adjust(ObjectScenes::Wanted& wanted, int) const {
  if (!picks_elements()) return;
  wanted.edited = tool_.editable().node();
  wanted.edited_cage = !cage_hidden_;
}

std::optional<SelectionFrame> MeshEditingTool::selection_frame(int) const {
  if (overlay_.selection_bounds().empty()) return std::nullopt;
  if (picks_objects()) return std::nullopt;
  const render::Bounds& bounds = overlay_.selection_bounds();
  return SelectionFrame{render::placed(bounds, matrix_of(studio().active()->placement.map())), std::nullopt, false};
}

void MeshEditingTool::place_chips(ChipPlaces& places) {
  places.put_legend(*legend_, overlay_.shows_tags());
  const auto& value = hovered_value_;
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
  const auto shown = mode_actions_.find(tool_.selection().mode());
  if (shown != mode_actions_.end()) shown->second->setChecked(true);
  const Tool* at_work = host().viewport().tool_in(PerspectiveView);
  const bool useful = mesh && (at_work == nullptr || at_work == this);
  bar_->setVisible(useful && host().shows_views());
  for (const char* name : {"move", "rotate", "scale"}) host().action(name)->setEnabled(object != nullptr);
  host().action("sharpen")->setEnabled(mesh);
  tags_->follow(studio().session().components());
  for (const auto& [action, edit] : edit_actions_) action->setEnabled(mesh && tool_.edits().fits_selection(edit));
  sets_->follow();
  show_last_edit();
  panels_->set_useful(edges_dock_, useful);
  panels_->set_useful(sets_dock_, useful);
  follow_scale();
}

// Recorded steps of work on meshes.

/// Steps that need no view.
template <class... Commands>
void MeshEditingTool::replay_commands(Replays& replays) {
  (replays.on<Commands>([this](const Commands& step) { replay_on_mesh(step.node, step); }), ...);
}

void MeshEditingTool::make_replays(Replays& replays) {
  replays.on<recorded::ModelDrag>([this](const recorded::ModelDrag& drag) {
    replay_drag(view_of(drag.view), drag.from, drag.to, modifiers_of(drag.modifiers), 1);
  });
  replays.on<recorded::Click>([this](const recorded::Click& click) {
    if (click.place)
      replay_drag(view_of(click.view), *click.place, *click.place, modifiers_of(click.modifiers), click.clicks);
    return click.place.has_value();
  });
  replays.on<recorded::Box>([this](const recorded::Box& box) {
    const bool is_in_space = box.from_place && box.to_place;
    if (is_in_space) replay_drag(view_of(box.view), *box.from_place, *box.to_place, modifiers_of(box.modifiers), 1);
    return is_in_space;
  });
  replay_commands<recorded::Pick, recorded::Move, recorded::Rotate, recorded::Scale, recorded::Tag, recorded::Pin,
                  recorded::TagSet, recorded::Extrude, recorded::LoopCut, recorded::EditStep>(replays);
}

void MeshEditingTool::replay_on_mesh(const std::string& node, const recorded::Step& step) {
  if (const auto* pick = step.as<recorded::Pick>()) {
    const MeshMode mode = mode_of(kind_of_singular(pick->kind).value_or(ComponentKind::Edge));
    if (tool_.selection().mode() != mode) set_mesh_mode(mode);
  }
  if (!node.empty()) studio().set_active(object_with_node(studio(), node).node);
  if (const auto* edit = step.as<recorded::EditStep>(); edit != nullptr && studio().active()->cage == 0) {
    set_mesh_mode(mode_of(edit->line.target.kind));  // begins the work on a computed mesh
  }
  follow();
  const MeshMode before = tool_.selection().mode();
  tool_.replay(step);
  follow();
  const MeshMode after = tool_.selection().mode();
  if (after != before) enter_mesh_mode(after);  // the window's buttons follow
  show_last_edit();
}

}  // namespace croquis::app

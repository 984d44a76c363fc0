// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tools/holes/hole_filling_tool.h"

#include <QAction>
#include <QDockWidget>
#include <QLocale>
#include <QMenu>
#include <QScrollArea>
#include <QScrollBar>
#include <algorithm>
#include <utility>

#include "app/replay/replays.h"
#include "app/tools/action_rows.h"
#include "app/tools/holes/hole_table.h"
#include "app/views/own_space.h"
#include "app/views/viewport.h"
#include "app/window/action_list.h"
#include "app/window/language.h"
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

QString help_of(const ScanHoles& holes) {
  const auto tr = [](const char* text) { return HoleFillingTool::tr(text); };
  if (holes.node() == nullptr) return tr("O looks for the holes of this mesh");
  if (holes.tool.preview().pull)
    return tr("The patch goes through here · Shift moves it in and out · Escape gives it up");
  if (holes.rows.empty()) return holes.shown ? tr("This mesh has no holes") : tr("Looking for holes …");
  if (holes.selected().empty()) {
    return tr("Click a hole to see its patch, double click to fill it · drag a box · Shift+F fills all inner ones");
  }
  if (!open_of_selected(holes).empty()) {
    return tr("Enter fills what is previewed · drag the patch to shape it · F frames · Shift adds, Ctrl takes away");
  }
  if (holes_in_state(holes, holes.selected(), FillAction::Failed).size() == holes.selected().size()) {
    return tr("No method gave a valid patch here: try another method, a bulge or trimming · Delete leaves it open");
  }
  return tr("Delete opens it again · drag the patch to shape it · F frames · Ctrl+Z undoes");
}

/// The colours of patches with their confidence. As scales stand: much above.
Legend* make_confidence_legend(QWidget* views) {
  std::vector<Legend::Row> rows;
  for (const render::ValueSample& sample : render::value_legend()) {
    const QColor color(sample.color.r, sample.color.g, sample.color.b);
    rows.push_back({sample.label, [color](QPainter& painter, int y) {
                      painter.fillRect(QRect(10, y, 22, Legend::row_height), color);
                    }});
  }
  std::ranges::reverse(rows);
  return new Legend(views, "confidence-legend", QT_TR_NOOP("Confidence"),
                    HoleFillingTool::tr("Colours of patches by confidence"), std::move(rows));
}

/// By the sign of the volume that its faces see from the middle.
bool is_inside_out(const PolyMesh& mesh) {
  Vec3 middle = Vec3::Zero();
  for (const Vec3& place : mesh.positions) middle += place / static_cast<double>(mesh.vertex_count());
  double volume = 0;
  for (std::size_t face = 0; face < mesh.face_count(); ++face) {
    const auto corners = mesh.face(face);
    const Vec3 first = mesh.positions[corners[0]] - middle;
    for (std::size_t k = 2; k < corners.size(); ++k) {
      const Vec3 second = mesh.positions[corners[k - 1]] - middle, third = mesh.positions[corners[k]] - middle;
      volume += first.dot(second.cross(third));
    }
  }
  return volume < 0;
}

/// Where what is selected looks to, out of the scan; nothing where that isn't one direction.
std::optional<Vec3> facing_of_selected(const ScanHoles& holes) {
  constexpr double one_direction = 0.7;  // length of the mean
  const auto scan = holes.scan();
  if (!scan || holes.selected().empty()) return std::nullopt;
  Vec3 sum = Vec3::Zero();
  for (const Index hole : holes.selected()) {
    if (const HoleRow* found = holes.row(hole)) sum += found->normal;
  }
  if (sum.norm() < one_direction * static_cast<double>(holes.selected().size())) return std::nullopt;
  return (is_inside_out(*scan) ? -1 : 1) * sum.normalized();
}

/// One row for all patches, and in it one for each.
std::vector<ObjectRow> rows_of_patches(const std::vector<FaceSet>& sets) {
  const auto tr = [](const char* text) { return HoleFillingTool::tr(text); };
  std::vector<ObjectRow> rows;
  for (const FaceSet& set : sets) {
    const auto count = qulonglong(set.faces.size());
    const QString info = count == 1 ? tr("1 face") : tr("%1 faces").arg(QLocale().toString(count));
    const QString tip = tr("Click to select these faces; F frames them");
    const ObjectRow row{capitalized(localized(set.name)), info, tip, {set.name}, true, false};
    (rows.empty() ? rows : rows.front().rows).push_back(row);
  }
  return rows;
}

}  // namespace

HoleFillingTool::HoleFillingTool(ToolHost& host)
    : Tool(host, "Meshes"),
      holes_(*this, host),
      pins_(&host.viewport()),
      legend_(make_confidence_legend(&host.viewport())) {
  host.studio().face_sets().set_holes(holes_of_patches);
  drags_leave_views_ = true;
}

void HoleFillingTool::make_actions(ActionList& actions) {
  QAction* tool = actions.add_mode(actions.menu(MenuId::Mesh), "holes", tr("Fill holes"), "O", [this] {
    if (host().attempt([this] { start_filling(studio()); })) host().set_mode("holes");
    host().refresh();
  });
  tool->setToolTip(tr("Holes of a scan: list, preview, fill (O)"));
  actions_ = add_hole_actions(holes_, actions, actions.menu(MenuId::Holes));
  add_toggle(actions, actions.menu(MenuId::View), "tint-patches", tr("Patches by confidence"), {QKeySequence("T")},
             [this](bool on) {
               holes_.tinted = on;
               show_patch_look();
             });
  // What was filled is hidden once it is frozen.
  connect(actions.find("freeze"), &QAction::triggered, this, [this] {
    if (holes_.active && holes_.node() == nullptr) host().set_mode(select_mode);
  });
}

void HoleFillingTool::make_panels(PanelDocks& panels) {
  panels_ = &panels;
  panel_ = make_hole_panel(holes_);
  QScrollArea* scroll = scrolled(panel_);
  scroll->setMinimumWidth(panel_->minimumSizeHint().width() + scroll->verticalScrollBar()->sizeHint().width());
  dock_ = panels.add(tr("Holes"), scroll, "holes");
  panels.tabify("attributes", dock_);
  panels.set_useful(dock_, false);
}

void HoleFillingTool::refresh() {
  refresh_hole_actions(holes_, actions_);
  panels_->show_tool_panel(dock_, holes_.works(), wanted_width);
  panel_->follow();
}

void HoleFillingTool::set_mode(const QString& mode) {
  Tool::set_mode(mode);
  const bool was_active = std::exchange(holes_.active, mode == "holes");
  if (holes_.active != was_active) holes_.follow_selection();
  show_patch_look();
}

void HoleFillingTool::follow(Change change) {
  if (change == Change::Document || change == Change::Result) holes_.follow();
}

void HoleFillingTool::open() {
  if (!holes_.active) host().action("holes")->trigger();
}

void HoleFillingTool::show_patch_look() {
  host().viewport().objects().set_patch_look(holes_.tinted   ? PatchLook::Confidence
                                             : holes_.active ? PatchLook::Distinct
                                                             : PatchLook::Plain);
}

// ---- How it stands

ToolWords HoleFillingTool::words() const { return {help_of(holes_)}; }

ToolState HoleFillingTool::state() const {
  return {.has_selection = holes_.active && !holes_.selected().empty(), .busy = holes_.active && holes_.preview.busy()};
}

QString HoleFillingTool::offer() const {
  if (holes_.node() == nullptr) return {};
  return tr("O goes back to its holes: there patches are dragged · F9 vertices, F10 edges, F11 faces of the scan");
}

// ---- The pointer

void HoleFillingTool::feed(const std::vector<PenStep>& steps) {
  for (const PenStep& step : steps) {
    gesture_view_ = step.view;
    const ViewFrame frame = own_frame_of(host().views(), step.view);
    take_gesture(holes_, {step.kind, step.sample.position, step.modifiers, frame, step.sample.time});
  }
  show_hover();
}

void HoleFillingTool::hover(const PointerEvent& event) {
  const bool leaves = event.action == PointerEvent::Action::Leave;
  if (!leaves) gesture_view_ = event.view;
  const ViewFrame frame = own_frame_of(host().views(), event.view);
  if (leaves ? holes_.tool.leave() : holes_.tool.hover(event.position, frame)) show_hover();
}

void HoleFillingTool::show_hover() {
  holes_.overlay.follow_hover(holes_.tool);
  emit changed();
}

bool HoleFillingTool::command(EditCommand command) {
  if (command == EditCommand::Cancel) cancel_remeshing(holes_);
  if (!holes_.active) return false;
  switch (command) {
    case EditCommand::SelectAll: {
      std::vector<Index> all;
      for (const HoleRow& row : holes_.rows) all.push_back(row.id);
      holes_.select(std::move(all));
      break;
    }
    case EditCommand::SelectNone: {
      Selection selection = studio().session().selection();
      std::erase_if(selection, [](const SelectedItem& item) { return !item.part.empty(); });
      studio().session().select(std::move(selection));
      holes_.select({});
      break;
    }
    case EditCommand::Delete:
      host().record(recorded::Action{"delete"});
      reopen_selected(holes_);
      break;
    case EditCommand::Accept: host().action("fill-selected")->trigger(); break;
    case EditCommand::Cancel: break;
  }
  return true;
}

bool HoleFillingTool::show(const Target& target) {
  if (const auto* step = std::get_if<const Node*>(&target)) {
    if ((*step)->operation != filling_operation) return false;
    open();
  } else if (const auto* found = std::get_if<NodeFinding>(&target)) {
    const std::vector<Index> holes = holes_of(found->finding);
    const Node* node = studio().session().document().find(found->node);
    if (holes.empty() || node == nullptr || node->operation != filling_operation) return false;
    studio().set_active(found->node);
    open();
    holes_.select(holes);
    frame_holes(holes_);
  } else if (const auto* chosen = std::get_if<ChosenParts>(&target)) {
    const WorkObject* object = studio().object(chosen->node);
    if (object == nullptr || studio().face_sets().of(*object).empty()) return false;
    host().record(recorded::FaceSetChoice{object->name, chosen->parts});
    select_face_sets(host(), chosen->node, chosen->parts);
  } else if (const auto* sets = std::get_if<ChosenFaceSets>(&target)) {
    std::vector<Index> holes;
    for (const FaceSet* set : *sets) holes.insert(holes.end(), set->holes.begin(), set->holes.end());
    if (holes_.active && !holes.empty()) holes_.select(holes);
  } else {
    return false;
  }
  return true;
}

// ---- The views

void HoleFillingTool::adjust(ObjectScenes::Wanted& wanted, int) const {
  if (holes_.active) wanted.outlines = false;
}

void HoleFillingTool::add_to(render::Scene& scene, int view) {
  const WorkObject* object = studio().active();
  if (!holes_.active || object == nullptr) return;
  const PlacedPart part(scene, object->placement.map());
  if (holes_.preview.item()) {
    scene.meshes.emplace_back(holes_.preview.item(), render::Emphasis{}, render::MeshStyle::translucent());
  }
  holes_.overlay.add_to(scene);
  const auto& box = holes_.tool.preview().box;
  if (box && view == gesture_view_) add_box(*box, own_frame_of(host().views(), view), scene);
}

std::optional<SelectionFrame> HoleFillingTool::selection_frame(int) const {
  const render::Bounds bounds = HoleOverlay::bounds_of(holes_.tool, holes_.selected());
  if (bounds.empty()) return std::nullopt;
  const WorkObject* object = studio().active();
  const Affine3 to_model = object == nullptr ? Affine3() : object->placement.map();
  std::optional<Vec3> facing = facing_of_selected(holes_);
  if (facing) facing = (to_model.linear * *facing).normalized();
  return SelectionFrame{render::placed(bounds, matrix_of(to_model)), facing, true};
}

void HoleFillingTool::place_chips(ChipPlaces& places) {
  places.put_legend(*legend_, holes_.tinted && holes_.active);
  HolePinView::Pins pins;
  const PaneLayout& layout = places.layout();
  for (const int view : holes_.active ? layout.shown() : std::vector<int>()) {
    const Views& views = host().views();
    if (tool_in(views, view) == this)
      pins.push_back({layout.pane(view).rect, holes_.tool.pins(own_frame_of(views, view))});
  }
  pins_.show_pins(std::move(pins), holes_);
}

std::vector<ObjectRow> HoleFillingTool::rows(const WorkObject& object, NodeId node) {
  return node == object.node ? rows_of_patches(studio().face_sets().of(object)) : std::vector<ObjectRow>();
}

// ---- Recorded steps of work on holes, and what replays can expect of them

void HoleFillingTool::make_replays(Replays& replays) {
  const auto play = [this](const auto& step) {
    if (!step.node.empty()) studio().set_active(object_named(studio(), step.node).node);
    if (!holes_.active) refuse_replay("No holes are being worked on: the action \"holes\" opens them");
    host().wait_until_settled();  // their numbers are known once they have been found
    replay(holes_, step);
  };
  replays.on_each<recorded::HoleChoice, recorded::HoleWay, recorded::HolePoint>(play);
  replays.counts["holes"] = [this](const std::string& node) { return count_open_holes(object_named(studio(), node)); };
  replays.counts["patches"] = [this](const std::string& node) {
    return holes_of_patches(object_named(studio(), node)).size();
  };
  replays.counts["selected"] = [this](const std::string&) {
    return holes_.active ? holes_.selected().size() : studio().session().components().elements.size();
  };
}

}  // namespace croquis::app

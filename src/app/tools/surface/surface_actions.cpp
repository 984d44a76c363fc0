// SPDX-License-Identifier: GPL-3.0-or-later
// Actions of the surface tool: what menus, keys and buttons do.
#include <QAction>
#include <QActionGroup>
#include <QDockWidget>
#include <QMenu>
#include <algorithm>
#include <array>
#include <map>

#include "app/tools/surface/domain_panel.h"
#include "app/tools/surface/surface_drawing_tool.h"
#include "app/tools/surface/surface_panel.h"
#include "app/views/viewport.h"
#include "app/window/action_list.h"
#include "app/window/panel_docks.h"

namespace croquis::app {
namespace {

constexpr int surface_panel_width = 330;
constexpr std::array<const char*, 3> own_modes{"patch", "surface-point", "inner-curve"};
constexpr std::array<const char*, 3> plane_actions{"plane-ground", "plane-view", "plane-selected"};
constexpr std::array<const char*, 3> mirror_actions{"mirror-network", "mirror-network-y", "mirror-network-z"};

QString taking_action(const OperationDescription& operation) {
  return "curves-by-" + QString::fromStdString(operation.id);
}

SymmetryPlane plane_across(int axis) { return {Vec3::Zero(), Vec3::Unit(axis)}; }

/// The face that a selected curve divides, and the curve; none where there is no such face.
std::optional<std::pair<std::string, std::string>> divided_face(const AttributeNetwork& network,
                                                                const NetworkElements& selected) {
  if (selected.curves.size() != 1) return std::nullopt;
  const Index curve = find_element(network, NetworkElement::Curve, selected.curves.front());
  if (curve == no_index || !faces_along(network, curve).empty()) return std::nullopt;
  for (Index face = 0; face < network.faces.size(); ++face) {
    if (can_split_face(network, face, curve, tolerance_of(network)))
      return std::pair{network.faces[face].id, network.curves[curve].id};
  }
  return std::nullopt;
}

}  // namespace

void SurfaceDrawingTool::make_actions(ActionList& actions) {
  QMenu* file = actions.menu(tr("&File"));
  QAction* fresh = actions.add(file, "new-surface", tr("New s&urface"), {}, [this] { begin_new(); });
  file->insertAction(actions.find("open"), fresh);
  make_mode_actions(actions);
  make_element_actions(actions);
  make_view_actions(actions);
  make_source_actions(actions);
  for (const auto& [key, name] : {std::pair{Qt::Key_P, "patch"},
                                  {Qt::Key_T, "surface-point"},
                                  {Qt::Key_I, "inner-curve"},
                                  {Qt::Key_U, "compare-uniform"},
                                  {Qt::Key_S, "toggle-join"},
                                  {Qt::Key_J, "normal-jump"}})
    set_key(key, [action = host().action(name)] { action->trigger(); });
}

void SurfaceDrawingTool::make_mode_actions(ActionList& actions) {
  QMenu* menu = actions.menu(tr("&Tool"));
  const auto add_mode = [&](const QString& mode, const QString& text, const QString& tip) {
    QAction* action = actions.add_mode(menu, mode, text, {}, [this, mode] { host().set_mode(mode); });
    action->setToolTip(tip);
    action->setVisible(false);
  };
  add_mode("patch", tr("&Patch"), tr("A click inside a loop of curves makes a patch (P)"));
  add_mode("surface-point", tr("P&oint on a patch"), tr("A click on a patch and a drag pull it (T)"));
  add_mode("inner-curve", tr("&Inner curve"), tr("A curve drawn on a patch pulls it (I)"));
}

void SurfaceDrawingTool::make_element_actions(ActionList& actions) {
  QMenu* menu = actions.menu(tr("Sur&face"));
  const auto add = [&](const QString& name, const QString& text, const QString& icon_text, std::function<void()> work) {
    QAction* action = actions.add(
        menu, name, text, {}, [this, work = std::move(work)] { host().attempt(work); }, Recorded::ByItself);
    action->setIconText(icon_text);
    action->setToolTip(action->text().remove('&'));
  };
  add("fill-loop", tr("&Patch of the selected curves, or of the closed loop") + "\t" + tr("Enter"), tr("Patch"),
      [this] {
        const std::vector<std::string> loop = chips_.offered();
        network_.act(recorded::SurfacePatch{loop.empty() ? network_.tool().selected().curves : loop});
      });
  add("toggle-join", tr("&Smooth, or crease again") + "\t" + tr("S"), tr("Smooth"),
      [this] { network_.act(other_join(network_.network(), network_.tool().selected().curves)); });
  add("split-element", tr("S&plit the selected curve, or the patch that it divides"), tr("Split"),
      [this] { split_selected(); });
  add("merge-patches", tr("&Merge the two patches beside the selected curve"), tr("Merge"), [this] {
    const std::string curve = network_.tool().selected().curves.front();
    network_.act(recorded::SurfaceMerge{curve});
  });
  add("turn-patches", tr("&Turn the selected patches round"), tr("Turn"), [this] {
    const std::vector<std::string> faces = network_.tool().selected().faces;
    network_.act(recorded::SurfaceFaceSetting{faces, {}, true});
  });
  add("automatic-slope", tr("Slopes along the selected curve &automatic"), tr("Automatic"), [this] {
    for (const SlopeTip& slope : network_.tool().slopes())
      if (!slope.automatic) network_.act(recorded::SurfaceSlope{slope.side, {}});
  });
  menu->addSeparator();
  const std::array<QString, 3> axes{tr("x"), tr("y"), tr("z")};
  for (int axis = 0; axis < 3; ++axis) {
    const auto place = static_cast<std::size_t>(axis);
    add(mirror_actions[place], tr("Mirror &across %1 = 0").arg(axes[place]), tr("Mirror"),
        [this, axis] { network_.act(recorded::SurfaceMirror{plane_across(axis)}); });
  }
  add("symmetric-edit", tr("S&ymmetric editing"), tr("Symmetric"), [this] { toggle_symmetry(); });
  actions.find("symmetric-edit")->setCheckable(true);
}

void SurfaceDrawingTool::make_view_actions(ActionList& actions) {
  QMenu* menu = actions.menu(tr("Sur&face"));
  menu->addSeparator();
  QMenu* planes = menu->addMenu(tr("&Draw on"));
  auto* choice = new QActionGroup(planes);
  const auto add_plane = [&](std::size_t place, const QString& text, std::function<void()> work) {
    QAction* action = actions.add(planes, plane_actions[place], text, {}, std::move(work));
    action->setCheckable(true);
    choice->addAction(action);
  };
  add_plane(0, tr("the &ground"), [this] { network_.tool().settings().plane = SurfacePlane::Ground; });
  add_plane(1, tr("a plane across the &view"), [this] { network_.tool().settings().plane = SurfacePlane::View; });
  add_plane(2, tr("a plane through what is &selected"), [this] { draw_through_selected(); });
  actions.find("plane-ground")->setChecked(true);
  menu->addSeparator();
  QAction* compare = actions.add(menu, "compare-uniform", tr("&Uniform domain for comparison") + "\t" + tr("U"), {},
                                 [this] { ghost_.set_on(host().action("compare-uniform")->isChecked()); });
  compare->setCheckable(true);
  compare->setIconText(tr("Uniform (U)"));
  QAction* jumps = actions.add(menu, "normal-jump", tr("An&gles along smooth curves") + "\t" + tr("J"), {},
                               [this] { network_.show_jumps(host().action("normal-jump")->isChecked()); });
  jumps->setCheckable(true);
}

/// From whatever the active object is made of: strokes, edges.
void SurfaceDrawingTool::make_source_actions(ActionList& actions) {
  QMenu* menu = actions.menu(tr("Sur&face"))->addMenu(tr("Take &curves"));
  for (const OperationDescription* operation : taking_.ways()) {
    QAction* action = actions.add(menu, taking_action(*operation), QString::fromStdString(operation->title), {},
                                  [this, id = operation->id] { taking_.take(id); });
    action->setToolTip(QString::fromStdString(operation->sentence));
  }
}

void SurfaceDrawingTool::begin_new() {
  const SurfaceToolOptions options = studio().network_options();
  if (!host().start_with(studio().with_network(Document(), {}, options))) return;
  show_in_space();
}

void SurfaceDrawingTool::split_selected() {
  const NetworkElements selected = network_.tool().selected();
  if (const auto divided = divided_face(network_.network(), selected)) {
    network_.act(recorded::SurfaceSplit{divided->second, {}, divided->first});
  } else if (selected.curves.size() == 1) {
    network_.act(recorded::SurfaceSplit{selected.curves.front(), 0.5, {}});
  }
}

/// Across the perspective view, at the middle of what is selected.
void SurfaceDrawingTool::draw_through_selected() {
  const auto frame = selection_frame(PerspectiveView);
  if (!frame) return;
  const glm::dvec3 middle = frame->bounds.center();
  const Vec3 place = inverse_of(network_.to_world())(Vec3(middle.x, middle.y, middle.z));
  network_.tool().settings().chosen = view_plane(network_.frame_of(PerspectiveView), place);
  network_.tool().settings().plane = SurfacePlane::Chosen;
  host().set_mode("draw");
}

/// The plane of the axes that the network is symmetric about already, else x = 0.
SymmetryPlane SurfaceDrawingTool::mirror_plane() const {
  for (int axis = 0; axis < 3; ++axis) {
    const SymmetryPlane plane = plane_across(axis);
    if (find_partners(network_.network(), plane, tolerance_of(network_.network())).any()) return plane;
  }
  return plane_across(0);
}

void SurfaceDrawingTool::toggle_symmetry() {
  const bool on = !network_.tool().symmetry().has_value();
  const auto plane = on ? std::optional(mirror_plane()) : std::optional<SymmetryPlane>();
  network_.act(recorded::SurfaceSymmetry{plane});
}

void SurfaceDrawingTool::refresh() {
  const bool here = is_there();
  const NetworkElements selected = here ? network_.tool().selected() : NetworkElements();
  const AttributeNetwork& network = network_.network();
  const Index curve =
      selected.curves.size() == 1 ? find_element(network, NetworkElement::Curve, selected.curves.front()) : no_index;
  const auto enable = [this](const QString& name, bool on) { host().action(name)->setEnabled(on); };
  for (const char* mode : own_modes) {
    host().action(mode)->setVisible(here);
    enable(mode, here);
  }
  for (const char* plane : plane_actions) enable(plane, here);
  for (const char* mirrored : mirror_actions) enable(mirrored, here && !network.curves.empty());
  enable("plane-selected", !selected.empty());
  chips_.follow();
  enable("fill-loop", selected.curves.size() > 1 || (here && !chips_.offered().empty()));
  enable("toggle-join", !selected.curves.empty());
  enable("split-element", curve != no_index);
  enable("merge-patches", curve != no_index && can_merge_faces(network, curve));
  enable("turn-patches", !selected.faces.empty());
  enable("automatic-slope", curve != no_index);
  enable("symmetric-edit", here);
  enable("compare-uniform", here && !network.faces.empty());
  enable("normal-jump", here && !network.faces.empty());
  host().action("symmetric-edit")->setChecked(here && network_.tool().symmetry().has_value());
  host().action("compare-uniform")->setChecked(ghost_.on());
  host().action("normal-jump")->setChecked(network_.shows_jumps());
  host().action(plane_actions[static_cast<std::size_t>(network_.tool().settings().plane)])->setChecked(true);
  for (const OperationDescription* operation : taking_.ways())
    enable(taking_action(*operation), taking_.can_take(*operation));
  if (docks_ == nullptr) return;
  docks_->set_useful(dock_, here);
  docks_->set_useful(domain_dock_, here);
  if (here) docks_->give_room_once(dock_, surface_panel_width);
  follow_panels();
}

QStringList SurfaceDrawingTool::marking_menu(int view) const {
  if (!works_in(view)) return {};
  return {"fill-loop",     "toggle-join",    "surface-point", "split-element",
          "merge-patches", "symmetric-edit", "draw",          "select"};
}

}  // namespace croquis::app

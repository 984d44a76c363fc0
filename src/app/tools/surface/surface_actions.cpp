// SPDX-License-Identifier: GPL-3.0-or-later
// Actions of the surface tool: what menus, keys and buttons do.
#include <QActionGroup>
#include <algorithm>
#include <array>

#include "app/files/mesh_export.h"
#include "app/tools/action_rows.h"
#include "app/tools/surface/surface_drawing_tool.h"
#include "app/views/viewport.h"
#include "app/window/language.h"

namespace croquis::app {
namespace {

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

void split_selected(DrawnNetwork& network) {
  const NetworkElements selected = network.tool.selected();
  if (const auto divided = divided_face(network.network(), selected)) {
    network.act(recorded::SurfaceSplit{divided->second, {}, divided->first});
  } else if (selected.curves.size() == 1) {
    network.act(recorded::SurfaceSplit{selected.curves.front(), 0.5, {}});
  }
}

/// Across the perspective view, at the middle of what is selected.
void draw_through_selected(DrawnNetwork& network) {
  const render::Bounds bounds = bounds_of_selected(network);
  if (!network.is_there() || bounds.empty()) return;
  const glm::dvec3 middle = bounds.center();
  const Vec3 place = inverse_of(network.to_world())(Vec3(middle.x, middle.y, middle.z));
  network.tool.settings().chosen = view_plane(network.frame_of(PerspectiveView), place);
  network.tool.settings().plane = SurfacePlane::Chosen;
  network.host.set_mode("draw");
}

/// The plane of the axes that the network is symmetric about already, else x = 0.
SymmetryPlane mirror_plane(const AttributeNetwork& network) {
  for (int axis = 0; axis < 3; ++axis) {
    const SymmetryPlane plane = plane_across(axis);
    if (find_partners(network, plane, tolerance_of(network)).any()) return plane;
  }
  return plane_across(0);
}

void toggle_symmetry(DrawnNetwork& network) {
  const bool on = !network.tool.symmetry().has_value();
  const auto plane = on ? std::optional(mirror_plane(network.network())) : std::optional<SymmetryPlane>();
  network.act(recorded::SurfaceSymmetry{plane});
}

void fill_loop(DrawnNetwork& network) {
  network.act(recorded::SurfacePatch{network.offered.empty() ? network.tool.selected().curves : network.offered});
}

void merge_patches(DrawnNetwork& network) {
  network.act(recorded::SurfaceMerge{network.tool.selected().curves.front()});
}

void turn_patches(DrawnNetwork& network) {
  network.act(recorded::SurfaceFaceSetting{network.tool.selected().faces, {}, true});
}

void make_slopes_automatic(DrawnNetwork& network) {
  for (const SlopeTip& slope : slopes_of(network.tool))
    if (!slope.automatic) network.act(recorded::SurfaceSlope{slope.side, {}});
}

template <int Axis>
void mirror_across(DrawnNetwork& network) {
  network.act(recorded::SurfaceMirror{plane_across(Axis)});
}

/// What is done to elements.
std::vector<ActionRow> element_actions(DrawnNetwork& network) {
  const auto tr = [](const char* text) { return QObject::tr(text); };
  const QString mirror = tr("Mirror across %1 = 0");
  const auto run = [&network](auto work) { return [&network, work] { network.host.attempt([&] { work(network); }); }; };
  return {{"fill-loop",
           tr("Patch of the selected curves, or of the closed loop") + "\t" + tr("Enter"),
           {},
           run(fill_loop),
           tr("Patch")},
          {"toggle-join",
           tr("Smooth, or crease again") + "\t" + tr("S"),
           {},
           run([](DrawnNetwork& drawn) { drawn.act(other_join(drawn.network(), drawn.tool.selected().curves)); }),
           tr("Smooth")},
          {"split-element",
           tr("Split the selected curve, or the patch that it divides"),
           {},
           run(split_selected),
           tr("Split")},
          {"merge-patches", tr("Merge the two patches beside the selected curve"), {}, run(merge_patches), tr("Merge")},
          {"turn-patches", tr("Turn the selected patches round"), {}, run(turn_patches), tr("Turn")},
          {"automatic-slope",
           tr("Slopes along the selected curve automatic"),
           {},
           run(make_slopes_automatic),
           tr("Automatic")},
          {},
          {mirror_actions[0], mirror.arg(tr("x")), {}, run(mirror_across<0>), tr("Mirror")},
          {mirror_actions[1], mirror.arg(tr("y")), {}, run(mirror_across<1>), tr("Mirror")},
          {mirror_actions[2], mirror.arg(tr("z")), {}, run(mirror_across<2>), tr("Mirror")},
          {"symmetric-edit", tr("Symmetric editing"), {}, run(toggle_symmetry), tr("Symmetric")},
          {}};
}

void add_mode_actions(ToolHost& host, ActionList& actions) {
  const auto add = [&](const QString& mode, const QString& text, const QString& tip) {
    QAction* action = add_mode(host, actions, MenuId::Surface, mode, text);
    action->setToolTip(tip);
    action->setVisible(false);
  };
  add("patch", QObject::tr("Patch"), QObject::tr("A click inside a loop of curves makes a patch (P)"));
  add("surface-point", QObject::tr("Point on a patch"), QObject::tr("A click on a patch and a drag pull it (T)"));
  add("inner-curve", QObject::tr("Inner curve"), QObject::tr("A curve drawn on a patch pulls it (I)"));
}

void add_plane_actions(DrawnNetwork& network, ActionList& actions, QMenu* planes) {
  auto* choice = new QActionGroup(planes);
  const auto add_plane = [&](std::size_t place, const QString& text, std::function<void()> work) {
    QAction* action = actions.add(planes, plane_actions[place], text, {}, std::move(work));
    action->setCheckable(true);
    choice->addAction(action);
  };
  add_plane(0, QObject::tr("the ground"), [&network] { network.tool.settings().plane = SurfacePlane::Ground; });
  add_plane(1, QObject::tr("a plane across the view"),
            [&network] { network.tool.settings().plane = SurfacePlane::View; });
  add_plane(2, QObject::tr("a plane through what is selected"), [&network] { draw_through_selected(network); });
  actions.find("plane-ground")->setChecked(true);
}

}  // namespace

void add_surface_actions(DrawnNetwork& network, UniformGhost& ghost, CurveTaking& taking, ActionList& actions,
                         ToolKeys& keys) {
  const auto tr = [](const char* text) { return QObject::tr(text); };
  add_mode_actions(network.host, actions);
  QMenu* menu = actions.menu(MenuId::Surface);
  menu->addSeparator();
  for (QAction* action : add_rows(actions, menu, element_actions(network))) action->setToolTip(action->text());
  actions.find("symmetric-edit")->setCheckable(true);
  add_plane_actions(network, actions, menu->addMenu(tr("Draw on")));
  menu->addSeparator();
  add_toggle(actions, menu, "compare-uniform", tr("Uniform domain for comparison") + "\t" + tr("U"), {},
             [&ghost](bool on) { ghost.set_on(on); })
      ->setIconText(tr("Uniform (U)"));
  add_toggle(actions, menu, "normal-jump", tr("Angles along smooth curves") + "\t" + tr("J"), {},
             [&network](bool on) { network.show_jumps(on); });
  // From whatever the active object is made of: strokes, edges.
  QMenu* sources = actions.menu(MenuId::Create)->addMenu(tr("Surface from"));
  for (const OperationDescription* operation : result_exports(network.host.studio())) {
    QAction* action = actions.add(sources, taking_action(*operation), shown_text(operation->title), {},
                                  [&taking, id = operation->id] { taking.take(id); });
    action->setToolTip(shown_text(operation->sentence));
  }
  for (const auto& [key, name] : {std::pair{Qt::Key_P, "patch"},
                                  {Qt::Key_T, "surface-point"},
                                  {Qt::Key_I, "inner-curve"},
                                  {Qt::Key_U, "compare-uniform"},
                                  {Qt::Key_S, "toggle-join"},
                                  {Qt::Key_J, "normal-jump"}})
    keys.pressed[key] = [action = actions.find(name)] { action->trigger(); };
}

void refresh_surface_actions(const DrawnNetwork& drawn, const UniformGhost& ghost, const CurveTaking& taking) {
  ToolHost& host = drawn.host;
  const bool here = drawn.is_there();
  const NetworkElements selected = here ? drawn.tool.selected() : NetworkElements();
  const AttributeNetwork& network = drawn.network();
  const Index curve =
      selected.curves.size() == 1 ? find_element(network, NetworkElement::Curve, selected.curves.front()) : no_index;
  const auto enable = [&host](const QString& name, bool on) { host.action(name)->setEnabled(on); };
  for (const char* mode : own_modes) {
    host.action(mode)->setVisible(here);
    enable(mode, here);
  }
  for (const char* plane : plane_actions) enable(plane, here);
  for (const char* mirrored : mirror_actions) enable(mirrored, here && !network.curves.empty());
  enable("plane-selected", !selected.empty());
  enable("fill-loop", selected.curves.size() > 1 || (here && !drawn.offered.empty()));
  enable("toggle-join", !selected.curves.empty());
  enable("split-element", curve != no_index);
  enable("merge-patches", curve != no_index && can_merge_faces(network, curve));
  enable("turn-patches", !selected.faces.empty());
  enable("automatic-slope", curve != no_index);
  enable("symmetric-edit", here);
  enable("compare-uniform", here && !network.faces.empty());
  enable("normal-jump", here && !network.faces.empty());
  host.action("symmetric-edit")->setChecked(here && drawn.tool.symmetry().has_value());
  host.action("compare-uniform")->setChecked(ghost.on());
  host.action("normal-jump")->setChecked(drawn.jumps);
  host.action(plane_actions[static_cast<std::size_t>(drawn.tool.settings().plane)])->setChecked(true);
  for (const OperationDescription* operation : result_exports(host.studio()))
    enable(taking_action(*operation), taking.can_take(*operation));
}

}  // namespace croquis::app

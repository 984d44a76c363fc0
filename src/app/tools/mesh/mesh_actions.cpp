// SPDX-License-Identifier: GPL-3.0-or-later
// The menus, keys and buttons of work on meshes.
#include "app/tools/mesh/mesh_actions.h"

#include <QActionGroup>
#include <QPushButton>
#include <QToolBar>
#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "app/replay/replays.h"
#include "app/tools/action_rows.h"
#include "app/tools/mesh/mesh_editing_tool.h"
#include "app/views/viewport.h"
#include "app/window/language.h"
#include "croquis/base/error.h"
#include "croquis/mesh_editing/tag_edit.h"
#include "croquis/tools/mesh/mesh_steps.h"
#include "croquis/tools/recording/general_steps.h"

namespace croquis::app {
namespace {

constexpr double extrusion_share = 0.1;  // of the mesh's diagonal

/// A first step that can be seen; the manipulator goes on from there.
double extrusion_distance(const PolyMesh& mesh) {
  const BoundingBox box = bounds_of(mesh);
  return box ? extrusion_share * ((*box)[1] - (*box)[0]).norm() : 0;
}

/// Edits with actions of their own, which set their numbers by hand.
const std::set<std::string> own_actions{"move",   "rotate",   "scale",     "extrude", "loop-cut",
                                        "delete", "dissolve", "sharpness", "pin"};

const std::map<std::string, const char*> edit_keys{{"inset", "I"}};

QString menu_text(const char* text) { return QObject::tr(text); }

QList<QKeySequence> shortcuts(const char* first, const char* second = nullptr) {
  QList<QKeySequence> keys{QKeySequence(first)};
  if (second != nullptr) keys << QKeySequence(second);
  return keys;
}

std::vector<ActionRow> conversions(MeshEditingTool& mesh) {
  const auto to = [&mesh](MeshMode mode) {
    return [&mesh, mode] { mesh.act([mode](MeshTool& tool) { return tool.selection().convert_to(mode); }); };
  };
  return {{},
          {"to-vertices", menu_text("Selection to vertices"), shortcuts("Ctrl+F9"), to(MeshMode::Vertex)},
          {"to-edges", menu_text("Selection to edges"), shortcuts("Ctrl+F10"), to(MeshMode::Edge)},
          {"to-faces", menu_text("Selection to faces"), shortcuts("Ctrl+F11"), to(MeshMode::Face)},
          {}};
}

std::vector<ActionRow> selections(MeshEditingTool& mesh) {
  const auto by = [&mesh](Reselect how) {
    return [&mesh, how] { mesh.act([how](MeshTool& tool) { return tool.selection().reselect(how); }); };
  };
  return {{"grow", menu_text("Grow"), shortcuts(">", "Ctrl++"), by(Reselect::Grow)},
          {"shrink", menu_text("Shrink"), shortcuts("<", "Ctrl+-"), by(Reselect::Shrink)},
          {"invert", menu_text("Invert"), shortcuts("Ctrl+I"), by(Reselect::Invert)},
          {},
          {"select-loop", menu_text("Edge loop"), shortcuts("Shift+L"), by(Reselect::Loop)},
          {"select-ring", menu_text("Edge ring"), shortcuts("Shift+R"), by(Reselect::Ring)},
          {"select-between", menu_text("Shortest path between two"), shortcuts("Shift+V"), by(Reselect::Between)},
          {"select-connected", menu_text("All that is connected"), shortcuts("Shift+K"), by(Reselect::Connected)},
          {"select-chain", menu_text("Chain of sharp edges"), shortcuts("Shift+C"), by(Reselect::Chain)},
          {"select-tagged", menu_text("All sharp edges"), shortcuts("Shift+T"), by(Reselect::Tagged)},
          {"select-boundary", menu_text("Boundary"), shortcuts("Shift+B"), by(Reselect::Boundary)},
          {}};
}

/// The first ones have buttons.
constexpr int tag_buttons = 4;

std::vector<ActionRow> taggings(MeshEditingTool& mesh) {
  const auto run = [&mesh](const recorded::Step& step) { return [&mesh, step] { take_step(mesh, step); }; };
  const double sharp = infinite_sharpness;
  return {
      {"sharp", menu_text("Sharp"), shortcuts("H"), run(recorded::Tag{.sharpness = sharp})},
      {"smooth", menu_text("Smooth"), shortcuts("Shift+H"), run(recorded::Tag{.sharpness = 0})},
      {"pin", menu_text("Pin"), shortcuts("P"), run(recorded::Pin{})},
      {"unpin", menu_text("Unpin"), shortcuts("Shift+P"), run(recorded::Pin{.pinned = false})},
      {"sharp-boundary", menu_text("Sharp boundary"), {}, run(recorded::Tag{.edges = "boundary", .sharpness = sharp})},
      {"sharper", menu_text("Sharper by a half"), shortcuts("Ctrl+Up"), run(recorded::Tag{.change = 0.5})},
      {"softer", menu_text("Softer by a half"), shortcuts("Ctrl+Down"), run(recorded::Tag{.change = -0.5})},
      {"crease-set", menu_text("Crease set of the selection"), shortcuts("Ctrl+G"),
       [&mesh] { make_crease_set(mesh); }}};
}

/// What the actions are made from, and where they go.
struct Making {
  MeshEditingTool& tool;
  ToolHost& host;
  ActionList& actions;
  MeshActions made = {};
};

/// The tool reports what it did, and that is recorded: elements stay the same where menus change.
QList<QAction*> add(Making& making, QMenu* menu, const std::vector<ActionRow>& rows) {
  const QList<QAction*> added = add_rows(making.actions, menu, rows);
  making.made.of_mesh << added;
  return added;
}

void add_tip(QAction* action) { action->setToolTip(action->text() + " (" + action->shortcut().toString() + ")"); }

void add_handles(Making& making) {
  making.actions.menu(MenuId::Modify)->addSeparator();
  add_mode(making.host, making.actions, MenuId::Modify, "move", menu_text("Move"), "W");
  add_mode(making.host, making.actions, MenuId::Modify, "rotate", menu_text("Rotate"), "E");
  add_mode(making.host, making.actions, MenuId::Modify, "scale", menu_text("Scale"), "R");
  add_mode(making.host, making.actions, MenuId::Mesh, "sharpen", menu_text("Change sharpness"), "S");
  making.actions.menu(MenuId::Mesh)->addSeparator();
}

void add_modes(Making& making, QMenu* menu) {
  auto* modes = new QActionGroup(making.made.bar);
  const auto add_picking = [&](const QString& name, const QString& text, const QString& key, MeshMode mode) {
    QAction* action = making.actions.add(menu, name, text, {QKeySequence(key)},
                                         [&tool = making.tool, mode] { tool.set_mesh_mode(mode); });
    action->setCheckable(true);
    add_tip(action);
    modes->addAction(action);
    making.made.modes[mode] = action;
    making.made.bar->addAction(action);
  };
  add_picking("object-mode", menu_text("Objects"), "F8", MeshMode::Object);
  add_picking("vertex-mode", menu_text("Vertices"), "F9", MeshMode::Vertex);
  add_picking("edge-mode", menu_text("Edges"), "F10", MeshMode::Edge);
  add_picking("face-mode", menu_text("Faces"), "F11", MeshMode::Face);
}

void add_selections(Making& making, QMenu* menu) {
  add(making, menu, selections(making.tool));
  making.made.of_mesh << add_toggle(making.actions, menu, "select-through", menu_text("Select through"),
                                    shortcuts("Ctrl+T"),
                                    [&tool = making.tool](bool on) { tool.tool().set_pick_through(on); });
}

/// From the edits' own descriptions: a new edit needs no line here.
void add_edits(Making& making, QMenu* menu) {
  for (const Edit& edit : all_edits()) {
    const EditDescription& description = edit.description;
    if (own_actions.contains(description.id)) continue;
    QList<QKeySequence> keys;
    if (const auto key = edit_keys.find(description.id); key != edit_keys.end()) keys << QKeySequence(key->second);
    const auto work = [&tool = making.tool, id = description.id] {
      tool.act([&](MeshTool& mesh) { return mesh.edits().begin(id); });
    };
    QAction* action = making.actions.add(menu, QString::fromStdString("edit-" + description.id),
                                         shown_text(description.title), keys, work, Recorded::ByItself);
    action->setToolTip(shown_text(description.sentence));
    making.made.edits.emplace_back(action, description);
  }
}

void add_shapes(Making& making, QMenu* menu) {
  const auto extrude = [&tool = making.tool, &host = making.host] {
    tool.act([&host](MeshTool& mesh) {
      const PreparedMesh* now = mesh.editable().prepared();
      if (now == nullptr || mesh.selection().mode() != MeshMode::Face) return Verdict::Continue;
      const Vec3 normal = mean_normal(*now->mesh, mesh.selection().selected());
      const Verdict verdict = mesh.take(recorded::Extrude{.by = extrusion_distance(*now->mesh) * normal});
      if (verdict == Verdict::Commit) host.set_mode("move");
      return verdict;
    });
  };
  add(making, menu, {{"extrude", menu_text("Extrude faces"), shortcuts("Shift+E"), extrude}});
  making.made.of_mesh << making.actions.add(menu, "loop-cut", menu_text("Loop cut"), {QKeySequence("K")},
                                            [&tool = making.tool] {
                                              tool.tool().arm_loop_cut(true);
                                              tool.follow();
                                              emit tool.state_changed();
                                            });
  add_edits(making, menu);
}

/// The object of that name, else the one with such a node in its chain.
const WorkObject& object_with_node(const Studio& studio, const std::string& name) {
  for (const auto& node : studio.session().document().nodes()) {
    const WorkObject* object = node->name == name ? studio.object(node->id) : nullptr;
    if (object != nullptr && object->node != node->id && !object->begins_with_mesh) return *object;
  }
  return object_named(studio, name);
}

/// A click or drag between places of the model, as a recording has it. @param clicks 2 for a double click
void play_drag(MeshEditingTool& mesh, const std::string& view_name, const Vec3& from, const Vec3& to,
               const std::vector<std::string>& modifiers, int clicks = 1) {
  const int view = view_of(view_name);
  MeshEvent event;
  event.frame = mesh.frame_in(view);
  event.modifiers = modifiers_of(modifiers);
  const auto start = event.frame.project(from);
  const auto end = event.frame.project(to);
  if (!start || !end) return;
  for (int click = 0; click < clicks; ++click) {
    event.time = 0.01 * click;
    event.kind = PenStep::Kind::Begin;
    event.pixel = start->pixel;
    mesh.handle(event, view);
    constexpr int moves = 4;
    event.kind = PenStep::Kind::Sample;
    for (int k = 1; k <= moves && from != to; ++k) {
      event.pixel = start->pixel + (end->pixel - start->pixel) * k / moves;
      mesh.handle(event, view);
    }
    event.kind = PenStep::Kind::End;
    event.pixel = end->pixel;
    mesh.handle(event, view);
  }
}

void play_on_mesh(MeshEditingTool& mesh, Studio& studio, const std::string& node, const recorded::Step& step) {
  MeshTool& tool = mesh.tool();
  if (const auto* pick = step.as<recorded::Pick>()) {
    const MeshMode mode = mode_of(kind_of_singular(pick->kind).value_or(ComponentKind::Edge));
    if (tool.selection().mode() != mode) mesh.set_mesh_mode(mode);
  }
  if (!node.empty()) studio.set_active(object_with_node(studio, node).node);
  if (const auto* edit = step.as<recorded::EditStep>(); edit != nullptr && studio.active()->cage == 0) {
    mesh.set_mesh_mode(mode_of(edit->line.target.kind));  // begins the work on a computed mesh
  }
  mesh.follow();
  const MeshMode before = tool.selection().mode();
  tool.take(step);
  mesh.follow();
  const MeshMode after = tool.selection().mode();
  if (after != before) mesh.enter_mesh_mode(after);  // the window's buttons follow
  mesh.refresh();
}

constexpr double far_off = 10;  // times larger or smaller

/// "300" or "12.5": as many figures as are worth reading.
QString times(double factor) { return QString::number(factor, 'f', factor < 100 ? 1 : 0); }

Eigen::AlignedBox3d box_of(const Studio& studio, const WorkObject& object) {
  const BoundingBox box = placed_bounds(studio, object);
  return box ? Eigen::AlignedBox3d((*box)[0], (*box)[1]) : Eigen::AlignedBox3d();
}

Eigen::AlignedBox3d box_of_rest(const Studio& studio, const WorkObject& object) {
  Eigen::AlignedBox3d rest;
  for (const WorkObject& other : studio.objects()) {
    const bool is_seen = other.node != object.node && other.visible && other.shown();
    if (is_seen) rest.extend(box_of(studio, other));
  }
  for (const Stroke& stroke : studio.drawing().strokes) {
    for (const StrokeSample& sample : stroke.samples) rest.extend(Vec3(sample.position.x(), sample.position.y(), 0));
  }
  return rest;
}

/// The factor that gives the active object the diagonal of all the rest that is seen; none where it is alone or comes
/// from a drawing. Files don't name their units: a mesh in metres is a dot in a sketch.
std::optional<double> scale_factor(const Studio& studio) {
  const WorkObject* object = studio.active();
  if (object == nullptr || !object->visible || !object->begins_with_mesh) return std::nullopt;
  const Eigen::AlignedBox3d rest = box_of_rest(studio, *object);
  const Eigen::AlignedBox3d own = box_of(studio, *object);
  if (rest.isEmpty() || own.isEmpty()) return std::nullopt;
  const double factor = rest.diagonal().norm() / own.diagonal().norm();
  if (!std::isnormal(factor)) return std::nullopt;
  return factor;
}

/// Where the sizes differ so much that one is a dot beside the other; else empty.
QString scale_sentence(const Studio& studio) {
  const auto by = scale_factor(studio);
  if (!by || std::max(*by, 1 / *by) < far_off) return {};
  const QString name = QString::fromStdString(studio.active()->name);
  return *by > 1 ? QObject::tr("%1 is %2 times smaller than the rest").arg(name, times(*by))
                 : QObject::tr("%1 is %2 times larger than the rest").arg(name, times(1 / *by));
}

/// @throws Error (E_EMPTY)
void scale_to_scene(Studio& studio) {
  const auto by = scale_factor(studio);
  if (!by) {
    throw Error(make_error(Category::Usage, "E_EMPTY",
                           "There is nothing to scale to: select a mesh while another object is visible"));
  }
  const WorkObject object = *studio.active();
  const Eigen::AlignedBox3d rest = box_of_rest(studio, object);
  const Vec3 middle = box_of(studio, object).center();
  const Vec3 goal = rest.contains(middle) ? middle : Vec3(rest.center());
  const Affine3 map{*by * Eigen::Matrix3d::Identity(), goal - *by * middle};
  studio.session().edit(
      "Scale " + object.name + " to the scene",
      with_objects_placed(studio, studio.session().document(), {{object.node, moved(object.placement, map)}}));
}

}  // namespace

void take_step(MeshEditingTool& tool, const recorded::Step& step) {
  tool.act([&](MeshTool& mesh) { return mesh.editable().mesh() ? mesh.take(step) : Verdict::Continue; });
}

void make_crease_set(MeshEditingTool& tool) {
  if (const auto mesh = tool.tool().editable().mesh())
    take_step(tool, recorded::TagSet{.name = new_set_name(mesh->tags)});
}

void refresh_mesh_actions(const MeshActions& made, MeshTool& tool, ToolHost& host, bool picks_elements) {
  const WorkObject* object = host.studio().active();
  const bool mesh = object != nullptr && object->cage != 0;
  for (QAction* action : made.of_mesh) action->setEnabled(mesh);
  // Objects are grouped by the same key.
  host.action("crease-set")->setEnabled(mesh && picks_elements);
  // Picking elements begins the work on a computed mesh.
  for (const auto& [mode, action] : made.modes) action->setEnabled(object != nullptr && object->editable != 0);
  made.modes.at(tool.selection().mode())->setChecked(true);
  for (const char* name : {"move", "rotate", "scale"}) host.action(name)->setEnabled(object != nullptr);
  host.action("sharpen")->setEnabled(mesh);
  for (const auto& [action, edit] : made.edits) action->setEnabled(mesh && tool.edits().fits_selection(edit));
  made.scale->follow();
}

MeshActions make_mesh_actions(MeshEditingTool& tool, ToolHost& host, ActionList& actions) {
  Making making{tool, host, actions};
  add_handles(making);
  making.made.bar = actions.bar("mesh-tools", menu_text("Mesh"));
  add_modes(making, actions.menu(MenuId::Select));
  add(making, actions.menu(MenuId::Select), conversions(making.tool));
  add_selections(making, actions.menu(MenuId::Select));
  QMenu* menu = actions.menu(MenuId::Mesh);
  add_shapes(making, menu);
  making.made.scale = std::make_unique<ScaleOffer>(host, actions, actions.menu(MenuId::Modify));
  menu->addSeparator();
  making.made.bar->addSeparator();
  for (QAction* action : add(making, menu, taggings(making.tool)).first(tag_buttons)) {
    add_tip(action);
    making.made.bar->addAction(action);
  }
  return std::move(making.made);
}

void add_mesh_replays(Replays& replays, MeshEditingTool& mesh, Studio& studio) {
  replays.on<recorded::ModelDrag>(
      [&mesh](const recorded::ModelDrag& drag) { play_drag(mesh, drag.view, drag.from, drag.to, drag.modifiers); });
  replays.on<recorded::Click>([&mesh](const recorded::Click& click) {
    if (click.place) play_drag(mesh, click.view, *click.place, *click.place, click.modifiers, click.clicks);
    return click.place.has_value();
  });
  replays.on<recorded::Box>([&mesh](const recorded::Box& box) {
    const bool is_in_space = box.from_place && box.to_place;
    if (is_in_space) play_drag(mesh, box.view, *box.from_place, *box.to_place, box.modifiers);
    return is_in_space;
  });
  // Those that need no view.
  const auto play = [&mesh, &studio](const auto& step) { play_on_mesh(mesh, studio, step.node, step); };
  replays.on_each<recorded::Pick, recorded::Move, recorded::Rotate, recorded::Scale, recorded::Tag, recorded::Pin,
                  recorded::TagSet, recorded::Extrude, recorded::LoopCut, recorded::EditStep>(play);
}

ScaleOffer::ScaleOffer(ToolHost& host, ActionList& actions, QMenu* menu)
    : host_(host), button_(new QPushButton(&host.viewport())) {
  actions.add(menu, "scale-to-scene", QObject::tr("Scale to the scene"), {}, [&host] {
    if (host.attempt([&host] { scale_to_scene(host.studio()); })) frame_all(host.views());
  });
  button_->setObjectName("scale-offer");
  button_->setFocusPolicy(Qt::NoFocus);  // keys belong to the views
  button_->setToolTip(QObject::tr("Gives it the size of everything else; undo takes it back"));
  QObject::connect(button_, &QPushButton::clicked, host.action("scale-to-scene"), &QAction::trigger);
  host.add_status_widget(*button_);
  button_->hide();
}

void ScaleOffer::offer() {
  const WorkObject* object = host_.studio().active();
  offered_ = object == nullptr ? 0 : object->node;
  offered_at_ = host_.studio().session().undo_labels().size();
  follow();
}

void ScaleOffer::follow() {
  const Studio& studio = host_.studio();
  const WorkObject* object = studio.active();
  const bool offered = object != nullptr && object->node == offered_ &&
                       studio.session().undo_labels().size() == offered_at_ && host_.shows_views();
  const QString sentence = offered ? scale_sentence(studio) : QString();
  button_->setText(QObject::tr("%1: scale to the scene").arg(sentence));
  button_->setVisible(!sentence.isEmpty());
  host_.action("scale-to-scene")->setEnabled(scale_factor(studio).has_value());
}

}  // namespace croquis::app

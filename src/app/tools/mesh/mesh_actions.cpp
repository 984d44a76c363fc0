// SPDX-License-Identifier: GPL-3.0-or-later
// The menus, keys and buttons of work on meshes.
#include <QAction>
#include <QActionGroup>
#include <QMenu>
#include <QPushButton>
#include <QToolBar>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <utility>

#include <Eigen/Geometry>

#include "app/tools/mesh/mesh_editing_tool.h"
#include "app/views/viewport.h"
#include "app/window/action_list.h"
#include "croquis/base/error.h"

namespace croquis::app {
namespace {

constexpr double extrusion_share = 0.1;  // of the mesh's diagonal

/// A first step that can be seen; the manipulator goes on from there.
double extrusion_distance(MeshTool& tool) {
  const auto mesh = tool.editable().mesh();
  if (!mesh || mesh->positions.empty()) return 0;
  Vec3 low = mesh->positions.front();
  Vec3 high = low;
  for (const Vec3& place : mesh->positions) {
    low = low.cwiseMin(place);
    high = high.cwiseMax(place);
  }
  return extrusion_share * (high - low).norm();
}

/// Edits with actions of their own, which set their numbers by hand.
const std::set<std::string> own_actions{"move",   "rotate",   "scale",     "extrude", "loop-cut",
                                        "delete", "dissolve", "sharpness", "pin"};

const std::map<std::string, const char*> edit_keys{{"inset", "I"}};

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
  if (!by || (*by<far_off&& * by> 1 / far_off)) return {};
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

QAction* MeshEditingTool::add(ActionList& actions, QMenu* menu, const QString& name, const QString& text,
                              const QList<QKeySequence>& keys, std::function<Verdict(MeshTool&)> work) {
  // The tool reports what it did, and that is recorded: elements stay the same where menus change.
  QAction* action = actions.add(
      menu, name, text, keys, [this, work = std::move(work)] { act(work); }, Recorded::ByItself);
  mesh_actions_ << action;
  return action;
}

void MeshEditingTool::make_actions(ActionList& actions) {
  make_handle_actions(actions);
  bar_ = actions.bar("mesh-tools", tr("Mesh"));
  QMenu* menu = actions.menu(tr("&Mesh"));
  make_mode_actions(actions, menu);
  make_selection_actions(actions, menu);
  make_shape_actions(actions, menu);
  make_scale_actions(actions, menu);
  make_tag_actions(actions, menu);
}

void MeshEditingTool::make_handle_actions(ActionList& actions) {
  QMenu* menu = actions.menu(tr("&Tool"));
  const auto add_mode = [&](const QString& mode, const QString& text, const QString& key) {
    actions.add_mode(menu, mode, text, key, [this, mode] { host().set_mode(mode); });
  };
  add_mode("move", tr("&Move"), "W");
  add_mode("rotate", tr("&Turn"), "E");
  add_mode("scale", tr("S&cale"), "R");
  add_mode("sharpen", tr("Change s&harpness"), "S");
}

void MeshEditingTool::make_mode_actions(ActionList& actions, QMenu* menu) {
  auto* modes = new QActionGroup(bar_);
  const auto add_mode = [&](const QString& name, const QString& text, const QString& key, MeshMode mode) {
    QAction* action = actions.add(menu, name, text, {QKeySequence(key)}, [this, mode] { set_mesh_mode(mode); });
    action->setCheckable(true);
    action->setToolTip(action->text().remove('&') + " (" + key + ")");
    modes->addAction(action);
    mode_actions_[mode] = action;
    bar_->addAction(action);
  };
  add_mode("object-mode", tr("&Objects"), "F8", MeshMode::Object);
  add_mode("vertex-mode", tr("&Vertices"), "F9", MeshMode::Vertex);
  add_mode("edge-mode", tr("&Edges"), "F10", MeshMode::Edge);
  add_mode("face-mode", tr("&Faces"), "F11", MeshMode::Face);
  menu->addSeparator();
  const auto add_conversion = [&](const QString& name, const QString& text, const QString& key, MeshMode mode) {
    add(actions, menu, name, text, {QKeySequence(key)},
        [mode](MeshTool& tool) { return tool.selection().convert_to(mode); });
  };
  add_conversion("to-vertices", tr("Selection to vertices"), "Ctrl+F9", MeshMode::Vertex);
  add_conversion("to-edges", tr("Selection to edges"), "Ctrl+F10", MeshMode::Edge);
  add_conversion("to-faces", tr("Selection to faces"), "Ctrl+F11", MeshMode::Face);
  menu->addSeparator();
}

void MeshEditingTool::make_selection_actions(ActionList& actions, QMenu* menu) {
  QMenu* selection = menu->addMenu(tr("&Select"));
  const auto add = [&](const QString& name, const QString& text, const QList<QKeySequence>& keys, Reselect how) {
    this->add(actions, selection, name, text, keys, [how](MeshTool& tool) { return tool.selection().reselect(how); });
  };
  add("grow", tr("&Grow"), {QKeySequence(">"), QKeySequence("Ctrl++")}, Reselect::Grow);
  add("shrink", tr("S&hrink"), {QKeySequence("<"), QKeySequence("Ctrl+-")}, Reselect::Shrink);
  add("invert", tr("&Invert"), {QKeySequence("Ctrl+I")}, Reselect::Invert);
  selection->addSeparator();
  add("select-loop", tr("Edge &loop"), {QKeySequence("Shift+L")}, Reselect::Loop);
  add("select-ring", tr("Edge &ring"), {QKeySequence("Shift+R")}, Reselect::Ring);
  add("select-between", tr("&Shortest path between two"), {QKeySequence("Shift+V")}, Reselect::Between);
  add("select-connected", tr("All that is &connected"), {QKeySequence("Shift+K")}, Reselect::Connected);
  add("select-chain", tr("C&hain of sharp edges"), {QKeySequence("Shift+C")}, Reselect::Chain);
  add("select-tagged", tr("All sharp &edges"), {QKeySequence("Shift+T")}, Reselect::Tagged);
  add("select-boundary", tr("&Boundary"), {QKeySequence("Shift+B")}, Reselect::Boundary);
  selection->addSeparator();
  QAction* through = actions.add(selection, "select-through", tr("Select t&hrough"), {QKeySequence("Ctrl+T")},
                                 [this] { tool_.set_pick_through(host().action("select-through")->isChecked()); });
  through->setCheckable(true);
  mesh_actions_ << through;
}

void MeshEditingTool::make_shape_actions(ActionList& actions, QMenu* menu) {
  add(actions, menu, "extrude", tr("E&xtrude faces"), {QKeySequence("Shift+E")}, [this](MeshTool& tool) {
    const Verdict verdict = tool.edits().extrude_along_normal(extrusion_distance(tool));
    if (verdict == Verdict::Commit) host().set_mode("move");
    return verdict;
  });
  actions.add(menu, "loop-cut", tr("&Loop cut"), {QKeySequence("K")}, [this] {
    tool_.arm_loop_cut(true);
    follow();
    emit state_changed();
  });
  mesh_actions_ << host().action("loop-cut");
  make_edit_actions(actions, menu->addMenu(tr("Edit ele&ments")));
}

/// From the edits' own descriptions: a new edit needs no line here.
void MeshEditingTool::make_edit_actions(ActionList& actions, QMenu* menu) {
  for (const Edit& edit : all_edits()) {
    const EditDescription& description = edit.description;
    if (own_actions.contains(description.id)) continue;
    QList<QKeySequence> keys;
    if (const auto key = edit_keys.find(description.id); key != edit_keys.end()) keys << QKeySequence(key->second);
    QAction* action = actions.add(
        menu, QString::fromStdString("edit-" + description.id), QString::fromStdString(description.title), keys,
        [this, id = description.id] { act([&](MeshTool& tool) { return tool.edits().begin(id); }); },
        Recorded::ByItself);
    action->setToolTip(QString::fromStdString(description.sentence));
    edit_actions_.push_back({action, description});
  }
}

void MeshEditingTool::make_scale_actions(ActionList& actions, QMenu* menu) {
  actions.add(menu, "scale-to-scene", tr("Scale t&o the scene"), {}, [this] {
    if (host().attempt([this] { scale_to_scene(studio()); })) host().viewport().frame_all();
  });
  scale_offer_ = new QPushButton(&host().viewport());
  scale_offer_->setObjectName("scale-offer");
  scale_offer_->setFocusPolicy(Qt::NoFocus);  // keys belong to the views
  scale_offer_->setToolTip(tr("Gives it the size of everything else; undo takes it back"));
  connect(scale_offer_, &QPushButton::clicked, host().action("scale-to-scene"), &QAction::trigger);
  host().add_status_widget(*scale_offer_);
  scale_offer_->hide();
}

void MeshEditingTool::offer_scale() {
  const WorkObject* object = studio().active();
  scale_offered_ = object == nullptr ? 0 : object->node;
  scale_offered_at_ = studio().session().undo_labels().size();
  follow_scale();
}

void MeshEditingTool::follow_scale() {
  const WorkObject* object = studio().active();
  const bool offered = object != nullptr && object->node == scale_offered_ &&
                       studio().session().undo_labels().size() == scale_offered_at_ && host().shows_views();
  const QString sentence = offered ? scale_sentence(studio()) : QString();
  scale_offer_->setText(tr("%1: scale to the scene").arg(sentence));
  scale_offer_->setVisible(!sentence.isEmpty());
  host().action("scale-to-scene")->setEnabled(scale_factor(studio()).has_value());
}

void MeshEditingTool::make_tag_actions(ActionList& actions, QMenu* menu) {
  menu->addSeparator();
  const auto add = [&](const QString& name, const QString& text, const QString& key,
                       std::function<Verdict(MeshTool&)> work) {
    QAction* action = this->add(actions, menu, name, text, {QKeySequence(key)}, std::move(work));
    action->setToolTip(action->text().remove('&') + " (" + key + ")");
    bar_->addAction(action);
  };
  bar_->addSeparator();
  add("sharp", tr("S&harp"), "H", [](MeshTool& tool) { return tool.tags().tag(infinite_sharpness); });
  add("smooth", tr("S&mooth"), "Shift+H", [](MeshTool& tool) { return tool.tags().untag(); });
  add("pin", tr("&Pin"), "P", [](MeshTool& tool) { return tool.tags().pin(true); });
  add("unpin", tr("&Unpin"), "Shift+P", [](MeshTool& tool) { return tool.tags().pin(false); });
  this->add(actions, menu, "sharp-boundary", tr("Sharp &boundary"), {},
            [](MeshTool& tool) { return tool.tags().tag_boundary(); });
  this->add(actions, menu, "sharper", tr("Sharper by a half"), {QKeySequence("Ctrl+Up")},
            [](MeshTool& tool) { return tool.tags().change_sharpness(0.5); });
  this->add(actions, menu, "softer", tr("Softer by a half"), {QKeySequence("Ctrl+Down")},
            [](MeshTool& tool) { return tool.tags().change_sharpness(-0.5); });
  this->add(actions, menu, "crease-set", tr("Crease &set of the selection"), {}, [](MeshTool& tool) {
    const auto mesh = tool.editable().mesh();
    return mesh ? tool.tags().make_set(new_set_name(mesh->tags)) : Verdict::Continue;
  });
}

QStringList MeshEditingTool::marking_menu(int) const {
  return {"vertex-mode", "edge-mode", "sharp", "pin", "object-mode", "unpin", "smooth", "face-mode"};
}

}  // namespace croquis::app

// SPDX-License-Identifier: GPL-3.0-or-later
// What the window does with meshes: their elements, tags and subdivision, by menu, key and marking menu.
#include <QAction>
#include <QActionGroup>
#include <QMenu>
#include <QMenuBar>
#include <QPushButton>
#include <QStatusBar>
#include <QToolBar>
#include <utility>

#include "app/tools/subdivision/smoothing.h"
#include "app/views/viewport.h"
#include "app/window/main_window.h"

namespace croquis::app {
namespace {

constexpr double extrusion_share = 0.1;  // of the mesh's diagonal

/// A first step that can be seen; the manipulator goes on from there.
double extrusion_distance(MeshTool& tool) {
  const auto mesh = tool.source().mesh();
  if (!mesh || mesh->positions.empty()) return 0;
  Vec3 low = mesh->positions.front();
  Vec3 high = low;
  for (const Vec3& place : mesh->positions) {
    low = low.cwiseMin(place);
    high = high.cwiseMax(place);
  }
  return extrusion_share * (high - low).norm();
}

}  // namespace

QAction* MainWindow::add_mesh_action(QMenu* menu, const QString& name, const QString& text,
                                     const QList<QKeySequence>& keys, std::function<Verdict(MeshTool&)> work) {
  // The tool reports what it did, and that is recorded: elements stay the same where menus change.
  QAction* action = add_action(
      menu, name, text, keys, [this, work = std::move(work)] { viewport_->mesh().act(work); }, Recorded::ByItself);
  mesh_actions_ << action;
  return action;
}

void MainWindow::make_mesh_actions() {
  make_mode_actions();
  make_selection_actions();
  make_shape_actions();
  make_scale_actions();
  make_tag_actions();
  make_smoothing_actions();
  make_marking_menu();
}

void MainWindow::make_mode_actions() {
  QMenu* menu = menuBar()->addMenu(tr("&Mesh"));
  mesh_menu_ = menu;
  auto* modes = new QActionGroup(this);
  const auto add_mode = [&](const QString& name, const QString& text, const QString& key, MeshMode mode) {
    QAction* action = add_action(menu, name, text, {QKeySequence(key)}, [this, mode] { set_mesh_mode(mode); });
    action->setCheckable(true);
    action->setToolTip(action->text().remove('&') + " (" + key + ")");
    modes->addAction(action);
    mesh_actions_ << action;
    mode_actions_[mode] = action;
    mesh_bar_->addAction(action);
  };
  add_mode("object-mode", tr("&Objects"), "F8", MeshMode::Object);
  add_mode("vertex-mode", tr("&Vertices"), "F9", MeshMode::Vertex);
  add_mode("edge-mode", tr("&Edges"), "F10", MeshMode::Edge);
  add_mode("face-mode", tr("&Faces"), "F11", MeshMode::Face);
  menu->addSeparator();
  const auto add_conversion = [&](const QString& name, const QString& text, const QString& key, MeshMode mode) {
    add_mesh_action(menu, name, text, {QKeySequence(key)},
                    [mode](MeshTool& tool) { return tool.selection().convert_to(mode); });
  };
  add_conversion("to-vertices", tr("Selection to vertices"), "Ctrl+F9", MeshMode::Vertex);
  add_conversion("to-edges", tr("Selection to edges"), "Ctrl+F10", MeshMode::Edge);
  add_conversion("to-faces", tr("Selection to faces"), "Ctrl+F11", MeshMode::Face);
  menu->addSeparator();
}

void MainWindow::set_mesh_mode(MeshMode mode) {
  const ToolKind kind = viewport_->tool_kind();
  if (kind == ToolKind::Draw || kind == ToolKind::Erase) viewport_->set_tool(ToolKind::Select);
  viewport_->mesh().set_mode(mode);
}

void MainWindow::make_selection_actions() {
  QMenu* menu = mesh_menu_->addMenu(tr("&Select"));
  const auto add = [&](const QString& name, const QString& text, const QList<QKeySequence>& keys,
                       Verdict (MeshSelector::*work)()) {
    add_mesh_action(menu, name, text, keys, [work](MeshTool& tool) { return (tool.selection().*work)(); });
  };
  add("grow", tr("&Grow"), {QKeySequence(">"), QKeySequence("Ctrl++")}, &MeshSelector::grow_selection);
  add("shrink", tr("S&hrink"), {QKeySequence("<"), QKeySequence("Ctrl+-")}, &MeshSelector::shrink_selection);
  add("invert", tr("&Invert"), {QKeySequence("Ctrl+I")}, &MeshSelector::invert_selection);
  menu->addSeparator();
  add("select-loop", tr("Edge &loop"), {QKeySequence("Shift+L")}, &MeshSelector::select_loop);
  add("select-ring", tr("Edge &ring"), {QKeySequence("Shift+R")}, &MeshSelector::select_ring);
  add("select-between", tr("&Shortest path between two"), {QKeySequence("Shift+V")}, &MeshSelector::select_between);
  add("select-connected", tr("All that is &connected"), {QKeySequence("Shift+K")}, &MeshSelector::select_connected);
  add("select-chain", tr("C&hain of sharp edges"), {QKeySequence("Shift+C")}, &MeshSelector::select_chain);
  add("select-tagged", tr("All sharp &edges"), {QKeySequence("Shift+T")}, &MeshSelector::select_tagged);
  add("select-boundary", tr("&Boundary"), {QKeySequence("Shift+B")}, &MeshSelector::select_boundary);
  menu->addSeparator();
  QAction* through = add_action(menu, "select-through", tr("Select t&hrough"), {QKeySequence("Ctrl+T")}, [this] {
    viewport_->mesh().tool().set_pick_through(action("select-through")->isChecked());
  });
  through->setCheckable(true);
  mesh_actions_ << through;
}

void MainWindow::make_shape_actions() {
  add_mesh_action(mesh_menu_, "extrude", tr("E&xtrude faces"), {QKeySequence("Shift+E")}, [this](MeshTool& tool) {
    const Verdict verdict = tool.edits().extrude_along_normal(extrusion_distance(tool));
    if (verdict == Verdict::Commit) viewport_->set_tool(ToolKind::Move);
    return verdict;
  });
  add_action(mesh_menu_, "loop-cut", tr("&Loop cut"), {QKeySequence("K")}, [this] {
    viewport_->mesh().tool().arm_loop_cut(true);
    viewport_->mesh().follow();
    update_help();
  });
  mesh_actions_ << action("loop-cut");
}

void MainWindow::make_scale_actions() {
  add_action(mesh_menu_, "scale-to-scene", tr("Scale t&o the scene"), {}, [this] {
    if (attempt([this] { scale_.apply(); })) viewport_->frame_all();
  });
  scale_offer_ = new QPushButton(this);
  scale_offer_->setObjectName("scale-offer");
  scale_offer_->setFocusPolicy(Qt::NoFocus);  // keys belong to the views
  scale_offer_->setToolTip(tr("Gives it the size of everything else; undo takes it back"));
  connect(scale_offer_, &QPushButton::clicked, action("scale-to-scene"), &QAction::trigger);
  statusBar()->addPermanentWidget(scale_offer_);
  scale_offer_->hide();
}

void MainWindow::offer_scale() {
  const StudioObject* object = studio_.active();
  scale_offered_ = object == nullptr ? 0 : object->node;
  scale_offered_at_ = studio_.session().undo_labels().size();
  follow_scale();
}

void MainWindow::follow_scale() {
  const StudioObject* object = studio_.active();
  const bool offered = object != nullptr && object->node == scale_offered_ &&
                       studio_.session().undo_labels().size() == scale_offered_at_ && !shows_start_page();
  const QString sentence = offered ? scale_.sentence() : QString();
  scale_offer_->setText(tr("%1: scale to the scene").arg(sentence));
  scale_offer_->setVisible(!sentence.isEmpty());
  action("scale-to-scene")->setEnabled(scale_.factor().has_value());
}

void MainWindow::make_tag_actions() {
  mesh_menu_->addSeparator();
  const auto add = [&](const QString& name, const QString& text, const QString& key,
                       std::function<Verdict(MeshTool&)> work) {
    QAction* action = add_mesh_action(mesh_menu_, name, text, {QKeySequence(key)}, std::move(work));
    action->setToolTip(action->text().remove('&') + " (" + key + ")");
    mesh_bar_->addAction(action);
  };
  mesh_bar_->addSeparator();
  add("sharp", tr("S&harp"), "H", [](MeshTool& tool) { return tool.tags().tag(infinite_sharpness); });
  add("smooth", tr("S&mooth"), "Shift+H", [](MeshTool& tool) { return tool.tags().untag(); });
  add("pin", tr("&Pin"), "P", [](MeshTool& tool) { return tool.tags().pin(true); });
  add("unpin", tr("&Unpin"), "Shift+P", [](MeshTool& tool) { return tool.tags().pin(false); });
  add_mesh_action(mesh_menu_, "sharp-boundary", tr("Sharp &boundary"), {},
                  [](MeshTool& tool) { return tool.tags().tag_boundary(); });
  add_mesh_action(mesh_menu_, "sharper", tr("Sharper by a half"), {QKeySequence("Ctrl+Up")},
                  [](MeshTool& tool) { return tool.tags().change_sharpness(0.5); });
  add_mesh_action(mesh_menu_, "softer", tr("Softer by a half"), {QKeySequence("Ctrl+Down")},
                  [](MeshTool& tool) { return tool.tags().change_sharpness(-0.5); });
  add_mesh_action(mesh_menu_, "new-set", tr("Crease &set of the selection"), {QKeySequence("Ctrl+G")},
                  [](MeshTool& tool) {
                    const auto mesh = tool.source().mesh();
                    return mesh ? tool.tags().make_set(new_set_name(mesh->tags)) : Verdict::Continue;
                  });
}

void MainWindow::make_smoothing_actions() {
  QMenu* menu = menuBar()->addMenu(tr("&Subdivision"));
  const auto add_view = [&](const QString& name, const QString& text, const QString& key, SmoothView view) {
    mesh_actions_ << add_action(menu, name, text, {QKeySequence(key)}, [this, view] {
      show_smooth(studio_, view);
      update_panels();
    });
  };
  add_view("show-cage", tr("&Cage"), "1", SmoothView::Cage);
  add_view("show-both", tr("Cage and smooth &surface"), "2", SmoothView::Both);
  add_view("show-smooth", tr("&Smooth surface"), "3", SmoothView::Smooth);
  menu->addSeparator();
  mesh_actions_ << add_action(menu, "finer", tr("&Finer"), {QKeySequence(Qt::Key_PageUp)},
                              [this] { change_level(studio_, 1); });
  mesh_actions_ << add_action(menu, "coarser", tr("C&oarser"), {QKeySequence(Qt::Key_PageDown)},
                              [this] { change_level(studio_, -1); });
  menu->addSeparator();
  const OperationDescription* operation = studio_.description("subdivide");
  QMenu* schemes = menu->addMenu(tr("Sc&heme"));
  QMenu* compared = new QMenu(tr("Compare &with"), menu);
  for (const ParameterDescription& parameter :
       operation == nullptr ? std::vector<ParameterDescription>() : operation->parameters) {
    if (parameter.name != "scheme" && parameter.name != "preset") continue;
    for (const std::string& choice : parameter.choices) {
      const QString text = QString::fromStdString(choice);
      mesh_actions_ << add_action(schemes, QString::fromStdString(parameter.name) + "-" + text, text, {},
                                  [this, name = parameter.name, choice] { set_smoothing(studio_, name, choice); });
      mesh_actions_ << add_action(compared, "compare-" + text, text, {}, [this, name = parameter.name, choice] {
        viewport_->comparison().choose(name, choice);
        action("compare")->setChecked(true);
        viewport_->compare(true);
      });
    }
    schemes->addSeparator();
    compared->addSeparator();
  }
  QAction* compare = add_action(menu, "compare", tr("Side by side with another scheme"), {QKeySequence("L")},
                                [this] { viewport_->compare(action("compare")->isChecked()); });
  compare->setCheckable(true);
  mesh_actions_ << compare;
  menu->addMenu(compared);
  menu->addSeparator();
  const auto add_keep = [&](const QString& name, const QString& text, KeptShape kept) {
    mesh_actions_ << add_action(menu, name, text, {},
                                [this, kept] { attempt([&] { show_message(keep_selected_faces(studio_, kept)); }); });
  };
  add_keep("keep-shape", tr("&Keep the shape of the selected faces"), KeptShape::Faces);
  add_keep("keep-outline", tr("Keep their &outline"), KeptShape::Outline);
  mesh_actions_ << add_action(menu, "freeze", tr("F&reeze as a mesh of its own"), {}, [this] {
    if (!attempt([this] { freeze_level(studio_); })) return;
    if (viewport_->holes().active()) viewport_->set_tool(ToolKind::Select);
  });
}

void MainWindow::make_marking_menu() {
  // Clockwise from above.
  const QStringList names{"vertex-mode", "edge-mode", "sharp", "pin", "object-mode", "unpin", "smooth", "face-mode"};
  for (int place = 0; place < names.size(); ++place) {
    viewport_->marking_menu().set_action(static_cast<std::size_t>(place), action(names[place]));
  }
}

void MainWindow::update_mesh_actions() {
  const StudioObject* object = studio_.active();
  const bool mesh = object != nullptr && object->cage != 0;
  for (QAction* action : mesh_actions_) action->setEnabled(mesh);
  const auto mode = mode_actions_.find(viewport_->mesh().tool().selection().mode());
  if (mode != mode_actions_.end()) mode->second->setChecked(true);
  const auto tool = tool_actions_.find(viewport_->tool_kind());
  if (tool != tool_actions_.end()) tool->second->setChecked(true);
  mesh_bar_->setVisible(mesh && !shows_start_page() && !viewport_->holes().active());
  action("erase")->setEnabled(!studio_.drawing().strokes.empty() || !mesh);
  for (const char* name : {"move", "rotate", "scale", "sharpen"}) action(name)->setEnabled(mesh);
  follow_scale();
}

}  // namespace croquis::app

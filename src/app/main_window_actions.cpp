// SPDX-License-Identifier: GPL-3.0-or-later
// Actions, menus, tools and docks of the window, and the questions that they ask.
#include <QAction>
#include <QActionGroup>
#include <QDockWidget>
#include <QFileDialog>
#include <QFileInfo>
#include <QMenuBar>
#include <QMessageBox>
#include <QScrollArea>
#include <QToolBar>
#include <utility>

#include "app/attribute_panel.h"
#include "app/icons.h"
#include "app/lists.h"
#include "app/main_window.h"
#include "app/viewport.h"
#include "croquis/base/error.h"

namespace croquis::app {
namespace {

const QString open_filter = QObject::tr("Croquis (*.croq *.svg *.obj *.ply *.stl *.off);;All files (*)");
const QString project_filter = QObject::tr("Project (*.croq)");
const QString mesh_filter = QObject::tr("OBJ (*.obj);;STL (*.stl);;PLY (*.ply);;GLB (*.glb);;OFF (*.off)");

bool asks_for_file(const QString& action) {
  return action == "open" || action.startsWith("save") || action.startsWith("export");
}

}  // namespace

QAction* MainWindow::action(const QString& name) const { return findChild<QAction*>(name); }

QAction* MainWindow::add_action(QMenu* menu, const QString& name, const QString& text, const QList<QKeySequence>& keys,
                                std::function<void()> work) {
  auto* action = new QAction(text, this);
  action->setObjectName(name);
  action->setShortcuts(keys);
  action->setIcon(action_icon(name));
  connect(action, &QAction::triggered, this, [this, name, work = std::move(work)] {
    // Those that ask for a file are recorded with its name, once it is known.
    if (!asks_for_file(name)) record(recorded::Action{name.toStdString()});
    work();
  });
  menu->addAction(action);
  addAction(action);
  return action;
}

void MainWindow::make_actions() {
  make_file_actions();
  make_edit_actions();
  make_view_actions();
  make_tool_actions();
}

void MainWindow::make_file_actions() {
  QMenu* menu = menuBar()->addMenu(tr("&File"));
  add_action(menu, "new", tr("&New sketch"), {QKeySequence::New}, [this] { start_sketch(); });
  add_action(menu, "open", tr("&Open…"), {QKeySequence::Open}, [this] { ask_open(); });
  add_action(menu, "start-page", tr("S&tart page"), {QKeySequence("Ctrl+Home")}, [this] { show_start_page(); });
  menu->addSeparator();
  add_action(menu, "save", tr("&Save"), {QKeySequence::Save}, [this] { ask_save(); });
  add_action(menu, "save-as", tr("Save &as…"), {QKeySequence::SaveAs}, [this] {
    const QString path = QFileDialog::getSaveFileName(this, tr("Save project"), files_.path(), project_filter);
    if (!path.isEmpty()) save_to(path);
  });
  menu->addSeparator();
  add_action(menu, "export-solid", tr("&Export solid…"), {QKeySequence("Ctrl+E")}, [this] { ask_export_solid(); });
  add_action(menu, "export-picture", tr("Export &picture…"), {QKeySequence("Ctrl+Shift+E")},
             [this] { ask_export_picture(); });
  add_action(menu, "export-drawing", tr("Export &drawing…"), {}, [this] {
    const QString path = QFileDialog::getSaveFileName(this, tr("Export drawing"), {}, tr("SVG (*.svg)"));
    if (!path.isEmpty()) attempt([&] { files_.export_drawing(path); });
  });
  menu->addSeparator();
  add_action(menu, "quit", tr("&Quit"), {QKeySequence::Quit}, [this] { close(); });
}

void MainWindow::make_edit_actions() {
  QMenu* menu = menuBar()->addMenu(tr("&Edit"));
  add_action(menu, "undo", tr("&Undo"), {QKeySequence("Ctrl+Z"), QKeySequence("Z")},
             [this] { studio_.session().undo(); });
  add_action(menu, "redo", tr("&Redo"), {QKeySequence("Ctrl+Shift+Z"), QKeySequence("Ctrl+Y"), QKeySequence("Shift+Z")},
             [this] { studio_.session().redo(); });
  menu->addSeparator();
  add_action(menu, "join-limbs", tr("&Join limbs"), {QKeySequence("J")}, [this] { viewport_->join_all(); });
  add_action(menu, "delete", tr("&Delete"), {QKeySequence::Delete, QKeySequence(Qt::Key_Backspace)},
             [this] { viewport_->delete_selection(); });
  add_action(menu, "select-all", tr("Select &all"), {QKeySequence::SelectAll}, [this] {
    std::vector<std::string> strokes;
    for (const Stroke& stroke : studio_.drawing().strokes) strokes.push_back(stroke.id);
    select_strokes(strokes);
  });
  add_action(menu, "deselect", tr("Select &none"), {QKeySequence("Escape")}, [this] {
    if (!viewport_->abandon()) select_strokes({});
  });
}

void MainWindow::make_view_actions() {
  QMenu* menu = menuBar()->addMenu(tr("&View"));
  add_action(menu, "frame-all", tr("Frame &all"), {QKeySequence("A")}, [this] { viewport_->frame_all(); });
  add_action(menu, "frame-selection", tr("&Frame selection"), {QKeySequence("F")},
             [this] { viewport_->frame_selection(); });
  add_action(menu, "layout", tr("One view / both"), {QKeySequence("Space")}, [this] { viewport_->toggle_layout(); });
  menu->addSeparator();
  auto* shading = new QActionGroup(this);
  const auto add_shading = [&](const QString& name, const QString& text, const QString& key, MeshLook look) {
    QAction* action = add_action(menu, name, text, {QKeySequence(key)}, [this, look] { viewport_->set_look(look); });
    action->setCheckable(true);
    action->setChecked(look == MeshLook::Shaded);
    shading->addAction(action);
  };
  add_shading("wire", tr("&Wire"), "4", MeshLook::Wire);
  add_shading("shaded", tr("&Shaded"), "5", MeshLook::Shaded);
  add_shading("shaded-wire", tr("Shaded, with w&ire"), "6", MeshLook::ShadedWire);
}

void MainWindow::make_tool_actions() {
  QMenu* menu = menuBar()->addMenu(tr("&Tool"));
  auto* bar = new QToolBar(tr("Tools"), this);
  bar->setObjectName("tools");
  bar->setMovable(false);
  bar->setIconSize({28, 28});
  addToolBar(Qt::LeftToolBarArea, bar);
  auto* tools = new QActionGroup(this);
  const auto add_tool = [&](const QString& name, const QString& text, const QString& key, SketchMode mode) {
    QAction* action = add_action(menu, name, text, {QKeySequence(key)}, [this, mode] { viewport_->set_mode(mode); });
    action->setCheckable(true);
    action->setToolTip(text + " (" + key + ")");
    action->setChecked(mode == SketchMode::Draw);
    tools->addAction(action);
    bar->addAction(action);
  };
  add_tool("draw", tr("&Draw"), "D", SketchMode::Draw);
  add_tool("select", tr("&Select and move"), "Q", SketchMode::Select);
  add_tool("erase", tr("&Erase"), "X", SketchMode::Erase);
}

void MainWindow::make_docks() {
  const auto add_dock = [this](const QString& title, QWidget* content, const QString& name) {
    auto* dock = new QDockWidget(title, this);
    dock->setObjectName(name);
    dock->setFeatures(QDockWidget::DockWidgetMovable);
    dock->setWidget(content);
    addDockWidget(Qt::RightDockWidgetArea, dock);
    return dock;
  };
  objects_ = new ObjectList(this);
  attributes_ = new AttributePanel(this);
  findings_ = new FindingsList(this);
  history_ = new HistoryList(this);
  auto* scroll = new QScrollArea(this);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setWidget(attributes_);
  docks_ = {add_dock(tr("Objects"), objects_, "objects-dock"), add_dock(tr("Attributes"), scroll, "attributes-dock"),
            add_dock(tr("Findings"), findings_, "findings-dock"), add_dock(tr("History"), history_, "history-dock")};
}

void MainWindow::ask_open() {
  const QString path = QFileDialog::getOpenFileName(this, tr("Open"), {}, open_filter);
  if (!path.isEmpty()) open(path);
}

bool MainWindow::ask_save() {
  QString path = files_.path();
  if (path.isEmpty()) path = QFileDialog::getSaveFileName(this, tr("Save project"), {}, project_filter);
  return !path.isEmpty() && save_to(path);
}

bool MainWindow::save_to(const QString& path) {
  const QString named = QFileInfo(path).suffix().isEmpty() ? path + ".croq" : path;
  if (!attempt([&] { files_.save(named); })) return false;
  record(recorded::File{"save", QFileInfo(named).absoluteFilePath().toStdString()});
  return true;
}

bool MainWindow::may_discard() {
  if (!studio_.session().modified()) return true;
  QMessageBox question(QMessageBox::Question, tr("Croquis"), tr("Save the changes to this sketch?"),
                       QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, this);
  question.setObjectName("save-question");
  switch (question.exec()) {
    case QMessageBox::Save: return ask_save();
    case QMessageBox::Discard: return true;
    default: return false;
  }
}

void MainWindow::ask_export_solid() {
  const QString path = QFileDialog::getSaveFileName(this, tr("Export solid"), {}, mesh_filter);
  if (!path.isEmpty()) attempt([&] { files_.export_solid(path); });
}

void MainWindow::ask_export_picture() {
  const QString path = QFileDialog::getSaveFileName(this, tr("Export picture"), {}, tr("PNG (*.png)"));
  if (!path.isEmpty()) attempt([&] { export_picture(path); });
}

}  // namespace croquis::app

// SPDX-License-Identifier: GPL-3.0-or-later
// Actions, menus, tools and docks of the window, and their questions.
#include <QAction>
#include <QActionGroup>
#include <QApplication>
#include <QDir>
#include <QDockWidget>
#include <QFileDialog>
#include <QFileInfo>
#include <QMenuBar>
#include <QMessageBox>
#include <QProgressDialog>
#include <QPushButton>
#include <QScrollArea>
#include <QToolBar>
#include <atomic>
#include <chrono>
#include <future>
#include <utility>

#include "app/files/file_reader.h"
#include "app/panels/object_names.h"
#include "app/views/render_color.h"
#include "app/views/viewport.h"
#include "app/window/help_line.h"
#include "app/window/icons.h"
#include "app/window/main_window.h"
#include "croquis/base/error.h"
#include "croquis/io/mesh_file.h"
#include "croquis/tools/perspective/sheet_units.h"
#include "croquis/tools/recording/general_steps.h"

namespace croquis::app {
namespace {

const QString project_filter = QObject::tr("Project (*.croq)");

/// "OBJ (*.obj);;PLY (*.ply)" …
QString mesh_filter() {
  QStringList kinds;
  for (const MeshFormat format : mesh_formats()) {
    kinds << QString("%1 (*%2)").arg(to_string(format), QString::fromStdString(extension_of(format)));
  }
  return kinds.join(";;");
}

QString import_filter() {
  QStringList endings;
  for (const MeshFormat format : mesh_formats()) endings << '*' + QString::fromStdString(extension_of(format));
  for (const QString& ending : picture_endings()) endings << '*' + ending;
  return QObject::tr("Meshes and pictures (%1)").arg(endings.join(' '));
}

/// What can be done without what is open, or whatever it is; all else belongs to the views.
bool needs_no_document(const QString& action) {
  return action == "new" || action.startsWith("new-") || action == "open" || action == "import" ||
         action == "start-page" || action == "quit" || action == "reset-layout" || action.startsWith("help");
}

constexpr int most_cameras = 9;  // in the menu

QString camera_action(int place) { return QString("camera-%1").arg(place + 1); }

bool asks_for_file(const QString& action) {
  return action == "open" || action == "import" || action.startsWith("save") ||
         (action.startsWith("export") && !action.startsWith("export-unit"));
}

}  // namespace

QString MainWindow::export_action(const OperationDescription& operation) {
  return "export-" + QString::fromStdString(operation.id);
}

QAction* MainWindow::action(const QString& name) const { return actions_->find(name); }

/// Nothing acts on a document that the start page hides. Actions that have no group of their own get one: a group that
/// is off leaves each action's own state alone.
void MainWindow::gate_document_actions() {
  auto* others = new QActionGroup(this);
  others->setExclusionPolicy(QActionGroup::ExclusionPolicy::None);
  for (QAction* action : actions()) {
    if (action->actionGroup() == nullptr && !needs_no_document(action->objectName())) others->addAction(action);
  }
}

void MainWindow::make_actions() {
  actions_ = std::make_unique<ActionList>(*this, [this](const QString& name, Recorded recorded) {
    // Those that ask for a file are recorded with its name, once it is known.
    if (recorded == Recorded::AsAction && !asks_for_file(name)) record(recorded::Action{name.toStdString()});
    help_->clear();
  });
  actions_->bar("tools", tr("Tools"));
  make_file_actions();
  make_edit_actions();
  step_actions_ = std::make_unique<StepActions>(*this, *actions_);
  make_view_actions();
  actions_->menu(tr("&Tool"));
}

void MainWindow::make_file_actions() {
  QMenu* menu = actions_->menu(tr("&File"));
  actions_->add(menu, "new", tr("&New sketch"), {QKeySequence::New}, [this] { start_sketch(); });
  actions_->add(menu, "open", tr("&Open…"), {QKeySequence::Open}, [this] { ask_open(); });
  actions_->add(menu, "import", tr("&Import…"), {QKeySequence("Ctrl+Shift+O")},
                [this] { import(QFileDialog::getOpenFileNames(this, tr("Import"), folder_, import_filter())); });
  actions_->add(menu, "start-page", tr("S&tart page"), {QKeySequence("Ctrl+Home")}, [this] { show_start_page(); });
  menu->addSeparator();
  actions_->add(menu, "save", tr("&Save"), {QKeySequence::Save}, [this] { ask_save(); });
  actions_->add(menu, "save-as", tr("Save &as…"), {QKeySequence::SaveAs}, [this] {
    const QString path = QFileDialog::getSaveFileName(this, tr("Save project"), files_.path(), project_filter);
    if (!path.isEmpty()) save_to(path);
  });
  menu->addSeparator();
  make_mesh_exports(menu);
  actions_->add(menu, "export-step", tr("Export S&TEP…"), {}, [this] { ask_export_step(); });
  actions_->add(menu, "export-picture", tr("Export &picture…"), {QKeySequence("Ctrl+Shift+E")},
                [this] { ask_export_picture(); });
  actions_->add(menu, "export-drawing", tr("Export &drawing…"), {}, [this] { ask_export_drawing(); });
  for (const OperationDescription* operation : result_exports(studio_)) {
    const QString title = QString::fromStdString(operation->title);
    actions_->add(menu, export_action(*operation), tr("Export %1…").arg(title.toLower()), {},
                  [this, operation] { ask_export_result(*operation); });
    action(export_action(*operation))->setToolTip(QString::fromStdString(operation->sentence));
  }
  menu->addSeparator();
  actions_->add(menu, "quit", tr("&Quit"), {QKeySequence::Quit}, [this] { close(); });
}

void MainWindow::make_mesh_exports(QMenu* menu) {
  using Objects = MeshExport::Objects;
  actions_->add(menu, "export-solid", tr("&Export mesh…"), {QKeySequence("Ctrl+E")},
                [this] { ask_export_meshes(Objects::Picked); });
  actions_->add(menu, "export-visible", tr("Export &visible…"), {}, [this] { ask_export_meshes(Objects::Visible); });
  actions_->add(menu, "export-all", tr("Export a&ll…"), {}, [this] { ask_export_meshes(Objects::All); });
  action("export-solid")->setToolTip(tr("The selected objects as one file"));
  QMenu* units = menu->addMenu(tr("&Unit of exported meshes"));
  auto* group = new QActionGroup(this);
  const auto add = [&](const std::string& unit, const QString& text) {
    QAction* chosen = actions_->add(units, "export-unit-" + QString::fromStdString(unit.empty() ? "own" : unit), text,
                                    {}, [this, unit] { export_unit_ = unit; });
    chosen->setCheckable(true);
    chosen->setChecked(unit.empty());
    group->addAction(chosen);
  };
  add({}, tr("As in the document"));
  for (const std::string& unit : length_units()) add(unit, QString::fromStdString(unit));
}

void MainWindow::make_edit_actions() {
  QMenu* menu = actions_->menu(tr("&Edit"));
  actions_->add(menu, "undo", tr("&Undo"), {QKeySequence("Ctrl+Z"), QKeySequence("Z")},
                [this] { studio_.session().undo(); });
  actions_->add(menu, "redo", tr("&Redo"),
                {QKeySequence("Ctrl+Shift+Z"), QKeySequence("Ctrl+Y"), QKeySequence("Shift+Z")},
                [this] { studio_.session().redo(); });
  menu->addSeparator();
  actions_->add(
      menu, "delete", tr("&Delete"), {QKeySequence::Delete, QKeySequence(Qt::Key_Backspace)},
      [this] {
        delete_selection();
        update_panels();
      },
      Recorded::ByItself);
  actions_->add(menu, "select-all", tr("Select &all"), {QKeySequence::SelectAll}, [this] { select_all(); });
  actions_->add(menu, "deselect", tr("Select &none"), {QKeySequence("Escape")}, [this] { select_none(); });
}

void MainWindow::select_all() {
  if (std::ranges::any_of(tools_, [](const auto& tool) { return tool->command(EditCommand::SelectAll); })) return;
  Selection selection;
  for (const auto& tool : tools_) tool->add_all_to(selection);
  for (const WorkObject& object : studio_.objects()) {
    if (object.cage != 0 && object.visible) selection.push_back({object.node, ""});
  }
  studio_.session().select(std::move(selection));
}

void MainWindow::delete_selection() {
  // The tools with few modes of their own come last: their turn is first.
  for (auto tool = tools_.rbegin(); tool != tools_.rend(); ++tool) {
    if ((*tool)->command(EditCommand::Delete)) return;
  }
  record(recorded::Action{"delete"});
  remove_objects(studio_, picked(studio_));
}

void MainWindow::select_none() {
  if (viewport_->abandon()) return;
  viewport_->marking_menu().dismiss();
  for (auto tool = tools_.rbegin(); tool != tools_.rend(); ++tool) {
    if ((*tool)->command(EditCommand::SelectNone)) return;
  }
  studio_.session().select({});
}

void MainWindow::make_view_actions() {
  QMenu* menu = actions_->menu(tr("&View"));
  actions_->add(menu, "frame-all", tr("Frame &all"), {QKeySequence("A")}, [this] { viewport_->frame_all(); });
  actions_->add(menu, "frame-selection", tr("&Frame selection"), {QKeySequence("F")},
                [this] { viewport_->frame_selection(); });
  actions_->add(menu, "layout", tr("&Maximise view"), {QKeySequence("Space")}, [this] { viewport_->toggle_layout(); });
  actions_->add(menu, "two-views", tr("S&ketch and perspective"), {QKeySequence("Ctrl+Space")},
                [this] { viewport_->arrange(Arrangement::SketchAndSolid); });
  actions_->add(menu, "four-views", tr("&Four views"), {QKeySequence("Shift+Space")},
                [this] { viewport_->arrange(Arrangement::Four); });
  const auto add_alone = [&](const QString& name, const QString& text, int view) {
    actions_->add(menu, name, text, {}, [this, view] { viewport_->show_alone(view); });
  };
  add_alone("perspective-alone", tr("&Perspective alone"), PerspectiveView);
  add_alone("front-alone", tr("Fr&ont alone"), SketchView);
  add_alone("top-alone", tr("&Top alone"), TopView);
  add_alone("side-alone", tr("Si&de alone"), SideView);
  for (int place = 0; place < most_cameras; ++place) {
    QAction* camera = actions_->add(menu, camera_action(place), {}, {}, [this, place] { look_through_camera(place); });
    camera->setCheckable(true);
    camera->setVisible(false);
  }
  menu->addSeparator();
  auto* shading = new QActionGroup(this);
  const auto add_shading = [&](const QString& name, const QString& text, const QString& key, MeshLook look) {
    QAction* action = actions_->add(menu, name, text, {QKeySequence(key)}, [this, look] { viewport_->set_look(look); });
    action->setCheckable(true);
    action->setChecked(look == MeshLook::Shaded);
    shading->addAction(action);
  };
  add_shading("wire", tr("&Wire"), "4", MeshLook::Wire);
  add_shading("shaded", tr("&Shaded"), "5", MeshLook::Shaded);
  add_shading("shaded-wire", tr("Shaded, with w&ire"), "6", MeshLook::ShadedWire);
  QAction* flat = actions_->add(menu, "flat", tr("Fl&at shading"), {QKeySequence("Shift+5")},
                                [this] { viewport_->set_flat(action("flat")->isChecked()); });
  flat->setCheckable(true);
  QAction* zebra = actions_->add(menu, "zebra", tr("&Zebra stripes"), {QKeySequence("Shift+6")},
                                 [this] { viewport_->set_zebra(action("zebra")->isChecked()); });
  zebra->setCheckable(true);
}

/// The cameras of the scene, in the order of their objects, beside the other views.
void MainWindow::show_cameras() {
  const std::vector<SceneCamera> cameras = scene_cameras(studio_);
  for (int place = 0; place < most_cameras; ++place) {
    QAction* entry = action(camera_action(place));
    const bool there = place < static_cast<int>(cameras.size());
    entry->setVisible(there);
    if (!there) continue;
    const SceneCamera& camera = cameras[static_cast<std::size_t>(place)];
    entry->setText(tr("Camera of %1").arg(camera.name));
    entry->setChecked(viewport_->look_through_node() == camera.node);
  }
}

void MainWindow::look_through_camera(int place) {
  const std::vector<SceneCamera> cameras = scene_cameras(studio_);
  const NodeId node = place < static_cast<int>(cameras.size()) ? cameras[static_cast<std::size_t>(place)].node : 0;
  viewport_->look_through(viewport_->look_through_node() == node ? 0 : node);
  if (node != 0 && !viewport_->pane(PerspectiveView).visible()) viewport_->show_alone(PerspectiveView);
  update_panels();
}

void MainWindow::ask_open() {
  begin_open(QFileDialog::getOpenFileNames(this, tr("Open"), folder_, FileReader::dialog_filter()));
}

void MainWindow::begin_open(const QStringList& paths) {
  if (paths.isEmpty()) return;
  bool replaces = false;
  const bool is_mesh = mesh_format_of(paths.front().toStdString()).has_value();
  if (is_mesh && !unattended_ && !studio_.objects().empty()) {
    const auto answer = ask_replace(paths);
    if (!answer) return;
    replaces = *answer;
  }
  const auto use = unattended_ ? std::optional(PictureUse::Backdrop) : ask_picture_use(paths, *this);
  if (!use) return;
  // What is added to what is open must be seen.
  if (!replaces && !FileReader::replaces_document(paths.front())) leave_start_page();
  for (const QString& path : paths) {
    const bool takes_place = std::exchange(replaces, false);
    if ((takes_place || FileReader::replaces_document(path)) && !may_discard()) return;
    files_.begin_open(path, takes_place, *use);
  }
}

/// Whether meshes take the place of what is open, or are added; nothing: neither.
std::optional<bool> MainWindow::ask_replace(const QStringList& paths) {
  const QString what = paths.size() == 1 ? QFileInfo(paths.front()).fileName() : tr("%1 meshes").arg(paths.size());
  QMessageBox question(QMessageBox::Question, tr("Croquis"),
                       tr("Open %1 in place of what is open, or add it?").arg(what), QMessageBox::Cancel, this);
  question.setObjectName("open-question");
  const QPushButton* replace = question.addButton(tr("&Replace"), QMessageBox::AcceptRole);
  QPushButton* add = question.addButton(tr("&Add"), QMessageBox::AcceptRole);
  question.setDefaultButton(add);
  question.exec();
  if (question.clickedButton() == replace) return true;
  return question.clickedButton() == add ? std::optional(false) : std::nullopt;
}

void MainWindow::import(const QStringList& paths) {
  const auto use = unattended_ ? std::optional(PictureUse::Backdrop) : ask_picture_use(paths, *this);
  if (paths.isEmpty() || !use) return;
  leave_start_page();
  for (const QString& path : paths) files_.begin_open(path, false, *use);
}

bool MainWindow::ask_save() {
  QString path = files_.path();
  // A damaged project is never overwritten: lost parts may still be read from it.
  if (path.isEmpty() || files_.is_damaged(path)) {
    const QString rescue = files_.rescue_path();
    const QString name = QString::fromStdString(document_name(studio_)) + ".croq";
    path = QFileDialog::getSaveFileName(this, tr("Save project"), rescue.isEmpty() ? proposed_path(name) : rescue,
                                        project_filter);
  }
  return !path.isEmpty() && save_to(path);
}

/// Asks before a project is overwritten that is open elsewhere or was saved by others.
bool MainWindow::may_replace(const QString& path) {
  if (unattended_) return true;
  QString reason;
  if (files_.is_open_elsewhere(path)) {
    reason = tr("%1 is open in another window of Croquis. Saving here replaces what is saved there.");
  } else if (files_.has_changed(path)) {
    reason = tr("%1 was saved by another window or program after it was opened here. Saving here replaces that.");
  }
  if (reason.isEmpty()) return true;
  QMessageBox question(QMessageBox::Warning, tr("Croquis"), reason.arg(QFileInfo(path).fileName()),
                       QMessageBox::Save | QMessageBox::Cancel, this);
  question.setObjectName("replace-question");
  question.setDefaultButton(QMessageBox::Cancel);
  return question.exec() == QMessageBox::Save;
}

bool MainWindow::save_to(const QString& path) {
  const QString named = QFileInfo(path).suffix().isEmpty() ? path + ".croq" : path;
  if (!may_replace(named)) return false;
  QString aside;
  if (!attempt([&] { aside = files_.save(named); })) return false;
  record(recorded::File{"save", QFileInfo(named).absoluteFilePath().toStdString()});
  folder_ = QFileInfo(named).absolutePath();
  const QString saved = tr("%1 has been saved").arg(QFileInfo(named).fileName());
  say(aside.isEmpty() ? saved : tr("%1; the damaged one is kept as %2").arg(saved, QFileInfo(aside).fileName()));
  update_panels();
  return true;
}

QString MainWindow::proposed_path(const QString& file) const {
  return folder_.isEmpty() ? file : QDir(folder_).filePath(file);
}

bool MainWindow::may_discard() {
  if (unattended_ || !studio_.session().modified()) return true;
  const QString name = files_.file_name();
  const QString text = name.isEmpty() ? tr("Save what was made here?") : tr("Save the changes to %1?").arg(name);
  QMessageBox question(QMessageBox::Question, tr("Croquis"), text,
                       QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, this);
  question.setObjectName("save-question");
  switch (question.exec()) {
    case QMessageBox::Save: return ask_save();
    case QMessageBox::Discard: return true;
    default: return false;
  }
}

void MainWindow::ask_export_meshes(MeshExport::Objects objects) {
  // Of the formats, PLY alone keeps which faces are patches, and how far to trust them.
  const WorkObject* object = studio_.active();
  const bool alone = objects == MeshExport::Objects::Picked && picked_or_active(studio_).size() == 1;
  const bool is_filled =
      alone && object != nullptr && object->mesh && object->mesh->channel("patch_id", Domain::Face) != nullptr;
  const QString project = QFileInfo(files_.file_name()).completeBaseName();
  const QString name = alone || project.isEmpty() ? QString::fromStdString(document_name(studio_)) : project;
  QString filter = is_filled ? QStringLiteral("PLY (*.ply)") : QStringLiteral("OBJ (*.obj)");
  const QString proposed = is_filled ? tr("%1 filled.ply").arg(name) : name + ".obj";
  QString path = QFileDialog::getSaveFileName(this, tr("Export mesh"), proposed_path(proposed), mesh_filter(), &filter);
  if (path.isEmpty()) return;
  const QString suffix = filter.section("*", 1).section(")", 0, 0);
  if (QFileInfo(path).suffix().isEmpty() && !QFileInfo::exists(path + suffix)) path += suffix;
  const MeshExport wanted{objects, export_unit_};
  attempt([&] {
    const auto check = checked_for_export(wanted);
    if (!check) return;
    const QString unit = QString::fromStdString(wanted.unit.empty() ? studio_.unit() : wanted.unit);
    say_written(path, export_solid(studio_, path, wanted), summary_of(check->figures, unit));
  });
}

/// Asks before a mesh is written that isn't closed or crosses itself; none: it isn't to be written.
std::optional<ExportCheck> MainWindow::checked_for_export(const MeshExport& wanted) {
  const std::shared_ptr<const PolyMesh> mesh = exported_mesh(studio_, wanted);
  QProgressDialog waiting(tr("Looking at the mesh …"), tr("Cancel"), 0, 0, this);
  waiting.setWindowModality(Qt::WindowModal);
  std::atomic<bool> cancelled = false;
  connect(&waiting, &QProgressDialog::canceled, this, [&] { cancelled = true; });
  auto checking = std::async(std::launch::async, [&] {
    Progress progress({}, &cancelled);
    return check_export(*mesh, progress);
  });
  while (checking.wait_for(std::chrono::milliseconds(10)) != std::future_status::ready) {
    waiting.setValue(0);  // shows the dialog after a while
    QApplication::processEvents();
  }
  waiting.reset();
  ExportCheck check = checking.get();
  if (!check.doubt || unattended_) return check;
  QMessageBox question(QMessageBox::Warning, tr("Export mesh"), QString::fromStdString(check.doubt->message),
                       QMessageBox::Cancel, this);
  question.setObjectName("export-question");
  QPushButton* show = question.addButton(tr("&Show"), QMessageBox::RejectRole);
  question.setDefaultButton(show);
  const QPushButton* anyway = question.addButton(tr("&Export anyway"), QMessageBox::AcceptRole);
  question.exec();
  if (question.clickedButton() == show) show_doubt(check, wanted);
  return question.clickedButton() == anyway ? std::optional(check) : std::nullopt;
}

/// Picks the elements where the mesh can be edited, else shows where they are.
void MainWindow::show_doubt(const ExportCheck& check, const MeshExport& wanted) {
  const WorkObject* object = studio_.active();
  const bool is_editable = object != nullptr && object->cage_mesh != nullptr && object->cage_mesh == object->shown();
  if (is_editable && object->cage_mesh->corners == exported_mesh(studio_, wanted)->corners)
    return show_finding({object->node, *check.doubt});
  render::Bounds bounds;
  for (const Vec3& corner : {check.where.min(), check.where.max()}) {
    const Vec3 place = corner / export_scale(studio_, wanted);
    bounds.add(to_glm(place));
  }
  viewport_->pane(PerspectiveView).frame(bounds);
  viewport_->redraw_all();
}

/// A file that people name for what is worked on; empty where they don't. @param ending that it has unless they give
/// one
QString MainWindow::asked_path(const QString& title, const QString& ending, const QString& filter) {
  const QString proposed = QString::fromStdString(document_name(studio_)) + ending;
  const QString path = QFileDialog::getSaveFileName(this, title, proposed_path(proposed), filter);
  return path.isEmpty() || !QFileInfo(path).suffix().isEmpty() ? path : path + ending;
}

void MainWindow::ask_export_result(const OperationDescription& operation) {
  const QString title = tr("Export %1").arg(QString::fromStdString(operation.title).toLower());
  const QString path = asked_path(title, ".json", tr("JSON (*.json)"));
  if (!path.isEmpty()) attempt([&] { say_written(path, export_result(studio_, operation, path)); });
}

void MainWindow::ask_export_step() {
  if (const std::string why = why_no_step(); !why.empty()) return say(QString::fromStdString(why));
  const QString path = asked_path(tr("Export STEP"), ".step", tr("STEP (*.step *.stp)"));
  if (!path.isEmpty()) attempt([&] { export_step(studio_, path, files_.step_export()); });
}

void MainWindow::ask_export_picture() {
  const QString path = asked_path(tr("Export picture"), ".png", tr("PNG (*.png)"));
  if (path.isEmpty()) return;
  attempt([&] {
    export_picture(path);
    say_written(path);
  });
}

void MainWindow::ask_export_drawing() {
  const bool network = studio_.network_node() != 0;
  const QString path = asked_path(tr("Export drawing"), network ? ".json" : ".svg",
                                  network ? tr("Network of curves (*.json)") : tr("SVG (*.svg)"));
  if (path.isEmpty()) return;
  attempt([&] {
    export_drawing(studio_, path);
    say_written(path);
  });
}

/// What was written, and what the format can't hold.
void MainWindow::say_written(const QString& path, const Findings& lost, const QString& summary) {
  folder_ = QFileInfo(path).absolutePath();
  const QString written = tr("Saved %1").arg(QFileInfo(path).fileName()) + (summary.isEmpty() ? "" : ": " + summary);
  if (lost.empty()) return help_->say_written(path, written);
  help_->say_written(path, written + ". " + QString::fromStdString(lost.front().message), HelpLine::Tone::Warning);
}

}  // namespace croquis::app

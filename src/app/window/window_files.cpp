// SPDX-License-Identifier: GPL-3.0-or-later
// What the window does with files, and what it asks about them.
#include <QAction>
#include <QActionGroup>
#include <QApplication>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QMenu>
#include <QMessageBox>
#include <QProgressDialog>
#include <QPushButton>
#include <QSettings>
#include <algorithm>
#include <atomic>
#include <chrono>
#include <future>
#include <utility>

#include "app/files/file_reader.h"
#include "app/files/mesh_export.h"
#include "app/panels/object_names.h"
#include "app/views/render_color.h"
#include "app/views/viewport.h"
#include "app/window/help_line.h"
#include "app/window/language.h"
#include "app/window/main_window.h"
#include "croquis/base/error.h"
#include "croquis/io/mesh_file.h"
#include "croquis/tools/perspective/sheet_units.h"
#include "croquis/tools/recording/general_steps.h"
#include "croquis/workspace/computed.h"
#include "croquis/workspace/object_commands.h"

namespace croquis::app {
namespace {

QString project_filter() { return QObject::tr("Project (*.croq)"); }

/// "OBJ (*.obj);;PLY (*.ply)" …
QString mesh_filter() {
  QStringList kinds;
  for (const MeshFormat format : mesh_formats()) {
    kinds << QString("%1 (*%2)").arg(to_string(format), QString::fromStdString(extension_of(format)));
  }
  return kinds.join(";;");
}

/// Where people last opened or wrote something.
QString proposed_path(const WindowParts& parts, const QString& file) {
  return parts.folder.isEmpty() ? file : QDir(parts.folder).filePath(file);
}

/// What becomes of the pictures among the files; nothing: they aren't wanted.
std::optional<PictureUse> use_of_pictures(MainWindow& window, const QStringList& paths) {
  return window.parts().unattended ? PictureUse::Backdrop : ask_picture_use(paths, window);
}

void ask_import(MainWindow& window) {
  QStringList endings;
  for (const MeshFormat format : mesh_formats()) endings << '*' + QString::fromStdString(extension_of(format));
  for (const QString& ending : picture_endings()) endings << '*' + ending;
  const QString filter = QObject::tr("Meshes and pictures (%1)").arg(endings.join(' '));
  import_files(window, QFileDialog::getOpenFileNames(&window, QObject::tr("Import"), window.parts().folder, filter));
}

/// Whether meshes take the place of what is open, or are added; nothing: neither.
std::optional<bool> ask_replace(MainWindow& window, const QStringList& paths) {
  const bool is_mesh = mesh_format_of(paths.front().toStdString()).has_value();
  if (!is_mesh || window.parts().unattended || window.studio().objects().empty()) return false;
  const QString what =
      paths.size() == 1 ? QFileInfo(paths.front()).fileName() : QObject::tr("%1 meshes").arg(paths.size());
  return ask_which(window, "open-question", QObject::tr("Open %1 in place of what is open, or add it?").arg(what),
                   QObject::tr("Replace"), QObject::tr("Add"));
}

/// Asks before a project is overwritten that is open elsewhere or was saved by others.
bool may_replace(MainWindow& window, const QString& path) {
  if (window.parts().unattended) return true;
  QString reason;
  if (window.files().is_open_elsewhere(path)) {
    reason = QObject::tr("%1 is open in another window of Croquis. Saving here replaces what is saved there.");
  } else if (window.files().has_changed(path)) {
    reason =
        QObject::tr("%1 was saved by another window or program after it was opened here. Saving here replaces that.");
  }
  if (reason.isEmpty()) return true;
  QMessageBox question(QMessageBox::Warning, QObject::tr("Croquis"), reason.arg(QFileInfo(path).fileName()),
                       QMessageBox::Save | QMessageBox::Cancel, &window);
  question.setObjectName("replace-question");
  question.setDefaultButton(QMessageBox::Cancel);
  return question.exec() == QMessageBox::Save;
}

bool save_to(MainWindow& window, const QString& path) {
  const QString named = QFileInfo(path).suffix().isEmpty() ? path + ".croq" : path;
  if (path.isEmpty() || !may_replace(window, named)) return false;
  QString aside;
  if (!window.attempt([&] { aside = window.files().save(named); })) return false;
  window.record(recorded::File{"save", QFileInfo(named).absoluteFilePath().toStdString()});
  window.parts().folder = QFileInfo(named).absolutePath();
  const QString saved = QObject::tr("%1 has been saved").arg(QFileInfo(named).fileName());
  const QString damaged = QFileInfo(aside).fileName();
  window.say(aside.isEmpty() ? saved : QObject::tr("%1; the damaged one is kept as %2").arg(saved, damaged));
  window.refresh();
  return true;
}

bool ask_save_as(MainWindow& window, const QString& proposed) {
  return save_to(window,
                 QFileDialog::getSaveFileName(&window, QObject::tr("Save project"), proposed, project_filter()));
}

bool ask_save(MainWindow& window) {
  const ProjectFiles& files = window.files();
  // A damaged project is never overwritten: lost parts may still be read from it.
  if (!files.path().isEmpty() && !files.is_damaged(files.path())) return save_to(window, files.path());
  const QString rescue = files.rescue_path();
  const QString name = QString::fromStdString(document_name(window.studio())) + ".croq";
  return ask_save_as(window, rescue.isEmpty() ? proposed_path(window.parts(), name) : rescue);
}

/// Of what has no file yet, it is asked where to save.
void save_increment(MainWindow& window) {
  const QString& path = window.files().path();
  path.isEmpty() ? ask_save(window) : save_to(window, next_increment(path));
}

/// What was written, and what the format can't hold.
void say_written(WindowParts& parts, const QString& path, const Findings& lost = {}, const QString& summary = {}) {
  parts.folder = QFileInfo(path).absolutePath();
  const QString written =
      QObject::tr("Saved %1").arg(QFileInfo(path).fileName()) + (summary.isEmpty() ? "" : ": " + summary);
  if (lost.empty()) return parts.help->say_written(path, written);
  const QString what = localized(lost.front().message);
  parts.help->say_written(path, written + ". " + what, HelpLine::Tone::Warning);
}

/// Picks the elements where the mesh can be edited, else shows where they are.
void show_doubt(MainWindow& window, const ExportCheck& check, const MeshExport& wanted) {
  const Studio& studio = window.studio();
  const WorkObject* object = studio.active();
  const bool is_editable = object != nullptr && object->cage_mesh != nullptr && object->cage_mesh == object->shown();
  if (is_editable && object->cage_mesh->corners == exported_mesh(studio, wanted)->corners)
    return show_finding(window, {object->node, *check.doubt});
  render::Bounds bounds;
  for (const Vec3& corner : {check.where.min(), check.where.max()}) {
    const Vec3 place = corner / export_scale(studio, wanted);
    bounds.add(to_glm(place));
  }
  window.viewport().pane(PerspectiveView).frame(bounds);
  emit window.views().changed();
}

/// Surfaces from curves have borders.
bool is_surface(const Studio& studio, const MeshExport& wanted) {
  return wanted.objects == MeshExport::Objects::Picked &&
         std::ranges::all_of(picked_or_active(studio), [&](NodeId node) {
           const WorkObject* object = studio.object(node);
           return object != nullptr && has_value_along(studio, *object, ValueType::AttributeNetwork);
         });
}

/// Asks before a mesh is written that isn't closed or crosses itself; none: it isn't to be written.
std::optional<ExportCheck> checked_for_export(MainWindow& window, const MeshExport& wanted) {
  const std::shared_ptr<const PolyMesh> mesh = exported_mesh(window.studio(), wanted);
  QProgressDialog waiting(QObject::tr("Looking at the mesh …"), QObject::tr("Cancel"), 0, 0, &window);
  waiting.setWindowModality(Qt::WindowModal);
  std::atomic<bool> cancelled = false;
  QObject::connect(&waiting, &QProgressDialog::canceled, &window, [&] { cancelled = true; });
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
  const bool is_expected = check.doubt && check.doubt->code == "W_OPEN" && is_surface(window.studio(), wanted);
  if (!check.doubt || is_expected || window.parts().unattended) return check;
  QMessageBox question(QMessageBox::Warning, QObject::tr("Export mesh"), localized(check.doubt->message),
                       QMessageBox::Cancel, &window);
  question.setObjectName("export-question");
  QPushButton* show = question.addButton(QObject::tr("Show"), QMessageBox::RejectRole);
  question.setDefaultButton(show);
  const QPushButton* anyway = question.addButton(QObject::tr("Export anyway"), QMessageBox::AcceptRole);
  question.exec();
  if (question.clickedButton() == show) show_doubt(window, check, wanted);
  return question.clickedButton() == anyway ? std::optional(check) : std::nullopt;
}

void ask_export_meshes(MainWindow& window, MeshExport::Objects objects) {
  WindowParts& parts = window.parts();
  const Studio& studio = parts.studio;
  // Of the formats, PLY alone keeps which faces are patches, and how far to trust them.
  const WorkObject* object = studio.active();
  const bool alone = objects == MeshExport::Objects::Picked && picked_or_active(studio).size() == 1;
  const bool is_filled =
      alone && object != nullptr && object->mesh && object->mesh->channel("patch_id", Domain::Face) != nullptr;
  const QString project = QFileInfo(parts.files.file_name()).completeBaseName();
  const QString name = alone || project.isEmpty() ? QString::fromStdString(document_name(studio)) : project;
  constexpr const char* kept_format = "export-format";
  QString filter = is_filled ? QStringLiteral("PLY (*.ply)")
                             : QSettings().value(kept_format, QStringLiteral("OBJ (*.obj)")).toString();
  const auto ending_of = [](const QString& kind) { return kind.section("*", 1).section(")", 0, 0); };
  const QString proposed =
      proposed_path(parts, is_filled ? QObject::tr("%1 filled.ply").arg(name) : name + ending_of(filter));
  QString path = QFileDialog::getSaveFileName(&window, QObject::tr("Export mesh"), proposed, mesh_filter(), &filter);
  if (path.isEmpty()) return;
  const QString suffix = ending_of(filter);
  // Another format chosen under the proposed name changes its ending.
  if (const QFileInfo file(path); file.suffix().isEmpty() || file.fileName() == QFileInfo(proposed).fileName()) {
    const QString ending = file.dir().filePath(file.completeBaseName() + suffix);
    if (!QFileInfo::exists(ending)) path = ending;
  }
  for (const QString& kind : mesh_filter().split(";;")) {
    if (!is_filled && path.endsWith(ending_of(kind), Qt::CaseInsensitive)) QSettings().setValue(kept_format, kind);
  }
  const MeshExport wanted{objects, parts.export_unit};
  window.attempt([&] {
    const auto check = checked_for_export(window, wanted);
    if (!check) return;
    const QString unit = QString::fromStdString(wanted.unit.empty() ? studio.unit() : wanted.unit);
    say_written(parts, path, export_solid(studio, path, wanted), summary_of(check->figures, unit));
  });
}

/// Asks for a file for what is worked on, and writes it. @param ending that it has unless people give one
void ask_export(MainWindow& window, const QString& title, const QString& ending, const QString& filter,
                const std::function<void(const QString& path)>& write) {
  const QString proposed = QString::fromStdString(document_name(window.studio())) + ending;
  QString path = QFileDialog::getSaveFileName(&window, title, proposed_path(window.parts(), proposed), filter);
  if (path.isEmpty()) return;
  if (QFileInfo(path).suffix().isEmpty()) path += ending;
  window.attempt([&] { write(path); });
}

void ask_export_step(MainWindow& window) {
  if (const std::string why = why_no_step(); !why.empty()) return window.say(localized(why));
  ask_export(window, QObject::tr("Export STEP"), ".step", QObject::tr("STEP (*.step *.stp)"),
             [&](const QString& path) { export_step(window.studio(), path, window.files().step_export()); });
}

void ask_export_picture(MainWindow& window) {
  ask_export(window, QObject::tr("Export picture"), ".png", QObject::tr("PNG (*.png)"), [&](const QString& path) {
    export_picture(window.parts().pictures, window.views(), path);
    say_written(window.parts(), path);
  });
}

void ask_export_drawing(MainWindow& window) {
  const bool network = window.studio().network_node() != 0;
  ask_export(window, QObject::tr("Export drawing"), network ? ".json" : ".svg",
             network ? QObject::tr("Network of curves (*.json)") : QObject::tr("SVG (*.svg)"),
             [&](const QString& path) {
               export_drawing(window.studio(), path);
               say_written(window.parts(), path);
             });
}

void ask_export_result(MainWindow& window, const OperationDescription& operation) {
  const QString title = QObject::tr("Export %1").arg(shown_text(operation.title).toLower());
  ask_export(window, title, ".json", QObject::tr("JSON (*.json)"), [&](const QString& path) {
    say_written(window.parts(), path, export_result(window.studio(), operation, path));
  });
}

void add_exports(MainWindow& window, QMenu* menu) {
  using Objects = MeshExport::Objects;
  WindowParts& parts = window.parts();
  ActionList& actions = *parts.actions;
  const auto add_meshes = [&](const char* name, const QString& text, const QList<QKeySequence>& keys, Objects objects) {
    return actions.add(menu, name, text, keys, [&window, objects] { ask_export_meshes(window, objects); });
  };
  add_meshes("export-solid", QObject::tr("Export mesh…"), {QKeySequence("Ctrl+E")}, Objects::Picked)
      ->setToolTip(QObject::tr("The selected objects as one file"));
  add_meshes("export-visible", QObject::tr("Export visible…"), {}, Objects::Visible);
  add_meshes("export-all", QObject::tr("Export all…"), {}, Objects::All);
  QMenu* units = menu->addMenu(QObject::tr("Unit of exported meshes"));
  auto* group = new QActionGroup(&window);
  const auto add_unit = [&](const std::string& unit, const QString& text) {
    QAction* chosen = actions.add(units, "export-unit-" + QString::fromStdString(unit.empty() ? "own" : unit), text, {},
                                  [&parts, unit] { parts.export_unit = unit; });
    chosen->setCheckable(true);
    chosen->setChecked(unit.empty());
    group->addAction(chosen);
  };
  add_unit({}, QObject::tr("As in the document"));
  for (const std::string& unit : length_units()) add_unit(unit, QString::fromStdString(unit));
  actions.add(menu, "export-step", QObject::tr("Export STEP…"), {}, [&window] { ask_export_step(window); });
  actions.add(menu, "export-picture", QObject::tr("Export picture…"), {QKeySequence("Ctrl+Shift+E")},
              [&window] { ask_export_picture(window); });
  actions.add(menu, "export-drawing", QObject::tr("Export drawing…"), {}, [&window] { ask_export_drawing(window); });
  for (const OperationDescription* operation : result_exports(parts.studio)) {
    const QString title = shown_text(operation->title).toLower();
    actions
        .add(menu, "export-" + QString::fromStdString(operation->id), QObject::tr("Export %1…").arg(title), {},
             [&window, operation] { ask_export_result(window, *operation); })
        ->setToolTip(shown_text(operation->sentence));
  }
}

/// They are looked up when the menu opens: files come and go.
void add_recent_files(MainWindow& window, QMenu* menu) {
  QMenu* recent = menu->addMenu(QObject::tr("Open recent"));
  recent->setObjectName("recent");
  recent->setToolTipsVisible(true);
  QObject::connect(recent, &QMenu::aboutToShow, &window, [&window, recent] {
    recent->clear();
    for (const QString& path : recent_files()) {
      QAction* entry = recent->addAction(QFileInfo(path).fileName().replace('&', "&&"));
      entry->setToolTip(path);
      QObject::connect(entry, &QAction::triggered, &window, [&window, path] { begin_open(window, {path}); });
    }
    if (recent->isEmpty()) recent->addAction(QObject::tr("Nothing was opened yet"))->setEnabled(false);
  });
}

void take_opened(MainWindow& window, const QString& path, const Findings& warnings) {
  const ProjectFiles& files = window.files();
  window.record(recorded::File{
      "open", QFileInfo(path).absoluteFilePath().toStdString(), files.has_replaced(), {}, {}, files.has_traced()});
  window.parts().folder = QFileInfo(path).absolutePath();
  show_opened(window);
  report_opening(window, path, warnings);
  for (const auto& tool : window.tools()) tool->follow(Change::Opened);
}

}  // namespace

void add_file_menu(MainWindow& window) {
  QMenu* menu = window.parts().actions->menu(MenuId::File);
  const auto add = [&](const char* name, const QString& text, const QKeySequence& key, auto work) {
    window.parts().actions->add(menu, name, text, {key}, [&window, work] { work(window); });
  };
  add("new", QObject::tr("New sketch"), QKeySequence::New, [](MainWindow& of) { of.start_with(); });
  add("open", QObject::tr("Open…"), QKeySequence::Open, ask_open);
  add_recent_files(window, menu);
  add("import", QObject::tr("Import…"), QKeySequence("Ctrl+Shift+O"), ask_import);
  add("start-page", QObject::tr("Start page"), QKeySequence("Ctrl+Home"), show_start_page);
  menu->addSeparator();
  add("save", QObject::tr("Save"), QKeySequence::Save, ask_save);
  add("save-as", QObject::tr("Save as…"), QKeySequence::SaveAs,
      [](MainWindow& of) { ask_save_as(of, of.files().path()); });
  add("save-increment", QObject::tr("Save increment"), QKeySequence("Ctrl+Alt+S"), save_increment);
  menu->addSeparator();
  add_exports(window, menu);
  menu->addSeparator();
  add("quit", QObject::tr("Quit"), QKeySequence::Quit, [](MainWindow& of) { of.close(); });
}

void follow_files(MainWindow& window) {
  WindowParts& parts = window.parts();
  ProjectFiles* files = &parts.files;
  const auto show_title = [&window, files] {
    const QString name = files->file_name();
    window.setWindowTitle((name.isEmpty() ? QObject::tr("Untitled") : name) + "[*] — Croquis");
  };
  show_title();
  const auto report = [&window](const QString& path, const Findings& findings) {
    if (findings.empty()) return window.say(QObject::tr("Cancelled."));
    report_opening(window, path, findings);
  };
  const StepExport* step = &files->step_export();
  QObject::connect(files, &ProjectFiles::path_changed, &window, show_title);
  QObject::connect(&files->keeper(), &WorkKeeper::failed, &window, &MainWindow::say);
  QObject::connect(step, &StepExport::finished, &window, [&parts](const QString& path) { say_written(parts, path); });
  QObject::connect(step, &StepExport::failed, &window, [report](const Findings& findings) { report({}, findings); });
  QObject::connect(files, &ProjectFiles::opened, &window,
                   [&window](const QString& path, const Findings& warnings) { take_opened(window, path, warnings); });
  QObject::connect(files, &ProjectFiles::open_failed, &window, report);
  files->keeper().set_items([views = parts.viewport] { return views->objects().surfaces(); });
}

void ask_open(MainWindow& window) {
  begin_open(window, QFileDialog::getOpenFileNames(&window, QObject::tr("Open"), window.parts().folder,
                                                   FileReader::dialog_filter()));
}

void begin_open(MainWindow& window, const QStringList& paths) {
  if (paths.isEmpty()) return;
  const auto answer = ask_replace(window, paths);
  const auto use = answer ? use_of_pictures(window, paths) : std::nullopt;
  if (!use) return;
  bool replaces = *answer;
  // What is added to what is open must be seen.
  if (!replaces && !FileReader::replaces_document(paths.front())) leave_start_page(window);
  for (const QString& path : paths) {
    const bool takes_place = std::exchange(replaces, false);
    if ((takes_place || FileReader::replaces_document(path)) && !may_discard(window)) return;
    window.files().begin_open(path, takes_place, *use);
  }
}

void import_files(MainWindow& window, const QStringList& paths) {
  const auto use = use_of_pictures(window, paths);
  if (paths.isEmpty() || !use) return;
  leave_start_page(window);
  for (const QString& path : paths) window.files().begin_open(path, false, *use);
}

bool may_discard(MainWindow& window) {
  if (window.parts().unattended || !window.studio().session().modified()) return true;
  const QString name = window.files().file_name();
  const QString text =
      name.isEmpty() ? QObject::tr("Save what was made here?") : QObject::tr("Save the changes to %1?").arg(name);
  QMessageBox question(QMessageBox::Question, QObject::tr("Croquis"), text,
                       QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, &window);
  question.setObjectName("save-question");
  switch (question.exec()) {
    case QMessageBox::Save: return ask_save(window);
    case QMessageBox::Discard: return true;
    default: return false;
  }
}

void show_findings(WindowParts& parts, const Findings& findings, const QString& path) {
  const bool error = has_errors(findings);
  if (error) parts.last_findings = findings;
  const QStringList all = sentences_of(findings, path);
  const QString more =
      all.size() > 1 ? QObject::tr(" And %1 more: see the panel Findings.").arg(all.size() - 1) : QString();
  parts.help->say(all.value(0) + more, error ? HelpLine::Tone::Error : HelpLine::Tone::Warning, all.join('\n'));
}

void report_opening(MainWindow& window, const QString& path, const Findings& findings) {
  WindowParts& parts = window.parts();
  parts.help->clear();
  if (findings.empty()) return;
  show_findings(parts, findings, path);
  if (!parts.unattended && parts.files.is_damaged(path)) show_opening_report(window, path, findings);
}

void show_opening_report(MainWindow& window, const QString& path, const Findings& findings) {
  for (OpeningReport* earlier : window.findChildren<OpeningReport*>()) earlier->close();
  auto* report = new OpeningReport(path, findings, &window);
  QObject::connect(report, &OpeningReport::version_wanted, &window,
                   [&window](const QString& version) { begin_open(window, {version}); });
  report->open();
}

}  // namespace croquis::app

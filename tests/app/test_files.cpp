// SPDX-License-Identifier: GPL-3.0-or-later
#include <QAction>
#include <QApplication>
#include <QDesktopServices>
#include <QDir>
#include <QFile>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMessageBox>
#include <QProcess>
#include <QPushButton>
#include <QSettings>
#include <QTextBrowser>
#include <QTimer>
#include <QToolButton>
#include <functional>

#include <catch2/catch.hpp>

#include "app/dialogs.h"
#include "app/files/file_reader.h"
#include "app/hole_scans.h"
#include "app/panels/lists.h"
#include "app/studio_fixture.h"
#include "croquis/base/error.h"
#include "croquis/document/content_hash.h"
#include "croquis/io/mesh_file.h"
#include "croquis/io/project_file.h"
#include "support/meshes/mesh_shapes.h"
#include "support/sketches/sketch_gallery.h"

using namespace croquis;
using namespace croquis::test;

namespace {

QByteArray bytes_of(const QString& path) {
  QFile file(path);
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

void write_file(const QString& path, const QByteArray& bytes) {
  QFile file(path);
  REQUIRE(file.open(QIODevice::WriteOnly));
  file.write(bytes);
}

Findings warnings_of(const QString& project) {
  Progress progress;
  try {
    return load_project(project.toStdString(), progress).warnings;
  } catch (const Error&) {
    return {};
  }
}

constexpr int version_count = 4;

/// A project of rings round each other with three earlier versions, one ring less each. @return its path
QString save_versions(StudioFixture& hand) {
  const QString project = hand.folder() + "/rings.croq";
  for (int version = 1; version <= version_count; ++version) {
    draw_ring(hand, 40 * version);
    hand.window().files().save(project);
  }
  REQUIRE(hand.studio().drawing().strokes.size() == version_count);
  return project;
}

/// Spoils stored contents so that something is lost and something can still be read.
void damage(const QString& project) {
  const QByteArray whole = bytes_of(project);
  for (int part = 1; part < 60; ++part) {
    QByteArray spoilt = whole;
    for (qsizetype i = whole.size() * part / 60; i < std::min(whole.size(), whole.size() * part / 60 + 700); ++i) {
      spoilt[i] = static_cast<char>(spoilt[i] ^ 0x5a);
    }
    write_file(project, spoilt);
    if (warnings_of(project).size() >= 2) return;
  }
  FAIL("no damage leaves a part");
}

/// The report of what was wrong with a file, or null.
QDialog* report_of_opening(StudioFixture& hand) {
  QDialog* found = nullptr;
  for (auto* dialog : hand.window().findChildren<QDialog*>("opening-report")) {
    if (dialog->isVisible()) found = dialog;
  }
  return found;
}

}  // namespace

TEST_CASE("a damaged project opens with every finding and with its earlier versions", "[files]") {
  StudioFixture hand;
  const QString project = save_versions(hand);
  damage(project);
  const Findings found = warnings_of(project);
  REQUIRE(hand.window().open(project));
  CHECK(!label(hand, "message").isEmpty());
  QDialog* report = report_of_opening(hand);
  REQUIRE(report != nullptr);
  const auto* list = report->findChild<QListWidget*>("opening-findings");
  REQUIRE(list->count() == static_cast<int>(found.size()));
  for (const QListWidgetItem* row : rows_of(*list)) {
    CHECK(row->text().contains("rings.croq"));
    CHECK(!row->text().contains(hand.folder()));
  }
  CHECK(hand.window().findChild<app::FindingsList*>("findings")->count() >= list->count());
  for (int version = 1; version <= 3; ++version) {
    CHECK(report->findChild<QPushButton*>("version-" + QString::number(version)) != nullptr);
  }
  report->findChild<QPushButton*>("version-1")->click();
  REQUIRE(hand.wait_for([&] { return hand.window().windowTitle().startsWith("rings.croq~1"); }));
  CHECK(hand.studio().drawing().strokes.size() == version_count - 1);
  CHECK(!hand.studio().session().modified());
}

TEST_CASE("a damaged project is never written over", "[files]") {
  StudioFixture hand;
  const QString project = save_versions(hand);
  std::vector<QByteArray> versions;
  for (int version = 1; version <= 3; ++version) versions.push_back(bytes_of(project + "~" + QString::number(version)));
  damage(project);
  const QByteArray damaged = bytes_of(project);
  REQUIRE(hand.window().open(project));
  draw_ring(hand, 20);

  // Saving asks for another name.
  QString proposed;
  in_dialog<QFileDialog>([&](QFileDialog& dialog) {
    proposed = dialog.selectedFiles().value(0);
    dialog.reject();
  });
  hand.act("save");
  CHECK(proposed.endsWith("rings rescued.croq"));
  CHECK(bytes_of(project) == damaged);

  // Its own name, insisted upon, keeps it beside, and every earlier version where it was.
  hand.window().files().save(project);
  CHECK(bytes_of(project + "~damaged") == damaged);
  for (int version = 1; version <= 3; ++version) {
    CHECK(bytes_of(project + "~" + QString::number(version)) == versions[static_cast<std::size_t>(version - 1)]);
  }
  CHECK(warnings_of(project).empty());
  CHECK(!hand.window().files().is_damaged(project));
}

TEST_CASE("a project of which nothing can be read says so, offers what there is, and leaves what was open", "[files]") {
  StudioFixture hand;
  const QString project = save_versions(hand);
  QByteArray half = bytes_of(project);
  half.truncate(120);
  write_file(project, half);
  const ContentHash before = content_hash(hand.studio().session().document());
  CHECK(!hand.window().open(project));
  CHECK(content_hash(hand.studio().session().document()) == before);
  QDialog* report = report_of_opening(hand);
  REQUIRE(report != nullptr);
  CHECK(report->findChild<QLabel*>("opening-headline")->text().contains("can't be opened"));
  CHECK(report->findChild<QPushButton*>("version-3") != nullptr);
}

TEST_CASE("a project that lost its beginning or everything offers its versions, and is kept", "[files]") {
  const auto make = GENERATE(
      +[](qsizetype) { return QByteArray(); }, +[](qsizetype size) { return QByteArray(size, '\0'); });
  StudioFixture hand;
  const QString project = save_versions(hand);
  const QByteArray lost = make(bytes_of(project).size());
  write_file(project, lost);
  CHECK(!hand.window().open(project));
  QDialog* report = report_of_opening(hand);
  REQUIRE(report != nullptr);
  CHECK(report->findChild<QPushButton*>("version-3") != nullptr);
  report->findChild<QPushButton*>("version-1")->click();
  REQUIRE(hand.wait_for([&] { return hand.window().windowTitle().startsWith("rings.croq~1"); }));
  hand.window().files().save(project);
  CHECK(bytes_of(project + "~damaged") == lost);
  CHECK(warnings_of(project).empty());
}

TEST_CASE("an unattended run says what a damaged project lost, and asks nothing", "[files]") {
  StudioFixture hand;
  const QString project = save_versions(hand);
  damage(project);
  QProcess studio;
  studio.start(CROQUIS_STUDIO, {project, "--screenshot", hand.folder() + "/window.png"});
  REQUIRE(studio.waitForFinished(60'000));
  CHECK(studio.exitCode() == 0);
  const QString errors = studio.readAllStandardError();
  CHECK(errors.count("W_PROJECT_DAMAGED") == static_cast<int>(warnings_of(project).size()));
}

TEST_CASE("dialogs list exactly the files that can be opened", "[files]") {
  StudioFixture hand;
  const QString filter = app::FileReader::dialog_filter();
  Progress progress;
  for (const MeshFormat format : mesh_formats()) {
    const QString ending = QString::fromStdString(extension_of(format));
    const QString file = hand.folder() + "/cube" + ending;
    const std::string bytes = write_mesh(cube(), format, {}, progress).bytes;
    write_file(file, QByteArray::fromStdString(bytes));
    bool read = true;
    try {
      app::FileReader::read_now(file, progress);
    } catch (const Error&) {
      read = false;
    }
    INFO(ending.toStdString());
    CHECK(read == filter.contains("*" + ending));
  }
  CHECK(filter.contains("*.croq"));
  CHECK(filter.contains("*.svg"));
  CHECK(!filter.contains("(*)"));
}

TEST_CASE("meshes that are only looked at are no unsaved work", "[files]") {
  StudioFixture hand;
  hand.open_cage("bolt");
  hand.open_cage("mug");
  CHECK(!hand.studio().session().modified());
  hand.crash_and_restart();
  CHECK(hand.window().files().recoverable().empty());
  hand.window().open(CROQUIS_SOURCE_DIR "/examples/data/bolt.obj");
  hand.settle();
  hand.act("show-smooth");
  CHECK(hand.studio().session().modified());
  hand.crash_and_restart();
  CHECK(hand.window().files().recoverable().size() == 1);
}

TEST_CASE("a mesh opened into unsaved work leaves it unsaved, and a crash loses neither", "[files]") {
  StudioFixture hand;
  draw_ring(hand, 60);
  hand.settle();
  hand.open_cage("bolt");
  CHECK(hand.studio().session().modified());
  const ContentHash both = content_hash(hand.studio().session().document());
  hand.crash_and_restart();
  const auto offers = hand.window().files().recoverable();
  REQUIRE(offers.size() == 1);
  hand.window().files().recover(offers.front());
  CHECK(content_hash(hand.studio().session().document()) == both);
}

TEST_CASE("what was saved is nothing to recover, what came after it is", "[files]") {
  StudioFixture hand;
  const QString project = save_versions(hand);
  hand.crash_and_restart();
  CHECK(hand.window().files().recoverable().empty());
  hand.window().open(project);
  draw_ring(hand, 20);
  const ContentHash drawn = content_hash(hand.studio().session().document());
  hand.crash_and_restart();
  const auto offers = hand.window().files().recoverable();
  REQUIRE(offers.size() == 1);
  CHECK(offers.front().project == project);
  hand.window().files().recover(offers.front());
  CHECK(content_hash(hand.studio().session().document()) == drawn);
}

TEST_CASE("a project that is open in another window is reported, and saving over it asks", "[files]") {
  StudioFixture hand;
  const QString project = save_versions(hand);
  auto other = std::make_unique<app::MainWindow>(hand.folder() + "/state");
  other->show();
  REQUIRE(other->open(project));
  const Findings& warnings = other->files().warnings();
  REQUIRE(warnings.size() == 1);
  CHECK(warnings.front().code == "W_PROJECT_OPEN");
  CHECK(other->findChild<QLabel*>("message")->text().contains("rings.croq"));
  const QByteArray before = bytes_of(project);
  in_dialog<QMessageBox>([](QMessageBox& question) { question.button(QMessageBox::Cancel)->click(); });
  other->studio().load(Document());
  other->action("save")->trigger();
  CHECK(bytes_of(project) == before);
  in_dialog<QMessageBox>([](QMessageBox& question) { question.button(QMessageBox::Save)->click(); });
  other->action("save")->trigger();
  const QByteArray saved = bytes_of(project);
  CHECK(saved != before);
  // The first one was asked nothing yet, and doesn't replace what the second one saved without asking either.
  draw_ring(hand, 20);
  bool asked = false;
  in_dialog<QMessageBox>([&](QMessageBox& question) {
    asked = question.objectName() == "replace-question";
    question.button(QMessageBox::Cancel)->click();
  });
  hand.act("save");
  CHECK(asked);
  CHECK(bytes_of(project) == saved);
  in_dialog<QMessageBox>([](QMessageBox& question) { question.button(QMessageBox::Save)->click(); });
  hand.act("save");
  const QByteArray replaced = bytes_of(project);
  CHECK(replaced != saved);
  hand.act("save");  // its own file: nothing to ask
  CHECK(!hand.window().files().has_changed(project));
  // Once the first one has something else open, nobody is in the way.
  hand.window().start_with();
  CHECK(!other->files().is_open_elsewhere(project));
}

TEST_CASE("what is exported is named with its place, and its folder can be opened", "[files]") {
  StudioFixture hand;
  hand.draw(snake_sketch());
  hand.settle();
  const QTextBrowser opened;  // has a slot that takes an address
  QDesktopServices::setUrlHandler("file", const_cast<QTextBrowser*>(&opened), "setSource");
  for (const auto& [action, file] :
       {std::pair{"export-picture", "snake.png"}, {"export-drawing", "snake.svg"}, {"export-solid", "snake.obj"}}) {
    INFO(action);
    const QString path = hand.folder() + "/" + file;
    in_dialog<QFileDialog>([&](QFileDialog& dialog) {
      dialog.findChild<QLineEdit*>()->setText(path);
      QMetaObject::invokeMethod(&dialog, "accept");
    });
    hand.act(action);
    CHECK(QFile::exists(path));
    CHECK(label(hand, "message").contains(QString(file)));
    auto* folder = hand.window().findChild<QToolButton*>("open-folder");
    REQUIRE(folder->isVisible());
    folder->click();
    CHECK(opened.source().toLocalFile() == hand.folder());
    hand.drag_pixels({300, 300}, {300, 300}, Qt::RightButton, Qt::AltModifier);
    CHECK(!folder->isVisible());
  }
  QDesktopServices::unsetUrlHandler("file");
}

TEST_CASE("the next export proposes the last format, and another one changes the ending of the proposed name",
          "[files]") {
  StudioFixture hand;
  hand.draw(snake_sketch());
  hand.settle();
  const auto export_with = [&](const std::function<void(QFileDialog&)>& choose) {
    in_dialog<QFileDialog>([&](QFileDialog& dialog) {
      choose(dialog);
      QMetaObject::invokeMethod(&dialog, "accept");
    });
    hand.act("export-solid");
  };
  export_with([&](QFileDialog& dialog) { dialog.findChild<QLineEdit*>()->setText(hand.folder() + "/first.stl"); });
  CHECK(QFile::exists(hand.folder() + "/first.stl"));
  QString proposed, format;
  export_with([&](QFileDialog& dialog) {
    proposed = QFileInfo(dialog.selectedFiles().value(0)).fileName();
    format = dialog.selectedNameFilter();
    dialog.selectNameFilter("PLY (*.ply)");
  });
  CHECK(format == "STL (*.stl)");
  CHECK(proposed.endsWith(".stl"));
  CHECK(QFile::exists(hand.folder() + "/" + QFileInfo(proposed).completeBaseName() + ".ply"));
  CHECK(!QFile::exists(hand.folder() + "/" + proposed));
  QSettings().remove("export-format");
}

TEST_CASE("an open mesh is exported after a question, a surface from curves without", "[files]") {
  for (const auto& [file, asks] : {std::pair{"surface/tri_point.json", 0}, {"pumpkin_scan.ply", 1}}) {
    StudioFixture hand;
    REQUIRE(hand.window().open(QString(CROQUIS_SOURCE_DIR "/examples/data/") + file));
    hand.settle();
    int asked = 0;
    QTimer answers;
    QObject::connect(&answers, &QTimer::timeout, [&] {
      auto* question = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
      if (question == nullptr) return;
      ++asked;
      question->reject();
    });
    answers.start(20);
    const QString path = hand.folder() + "/mesh.stl";
    in_dialog<QFileDialog>([&](QFileDialog& dialog) {
      dialog.findChild<QLineEdit*>()->setText(path);
      QMetaObject::invokeMethod(&dialog, "accept");
    });
    hand.act("export-solid");
    INFO(file);
    CHECK(asked == asks);
    CHECK(QFile::exists(path) == (asks == 0));
  }
  QSettings().remove("export-format");
}

TEST_CASE("increments are saved under the next free number, and what has no file yet is asked for one", "[files]") {
  StudioFixture hand;
  const auto file = [&](const char* name) { return hand.folder() + "/" + name; };
  draw_ring(hand, 20);
  QString proposed;
  in_dialog<QFileDialog>([&](QFileDialog& dialog) {
    proposed = dialog.selectedFiles().value(0);
    dialog.reject();
  });
  hand.act("save-increment");
  CHECK(proposed.endsWith("Sketch.croq"));
  CHECK(hand.window().files().path().isEmpty());

  // Of the percent signs none is a place for the number.
  hand.window().files().save(file("ring %1.croq"));
  write_file(file("ring %1_002.croq"), "of somebody else");
  std::vector<QByteArray> saved{bytes_of(file("ring %1.croq"))};
  for (const char* name : {"ring %1_001.croq", "ring %1_003.croq", "ring %1_004.croq"}) {
    draw_ring(hand, 30.0 + 20.0 * static_cast<double>(saved.size()));
    hand.act("save-increment");
    CHECK(hand.window().files().path() == file(name));
    CHECK(hand.window().windowTitle().contains(name));
    CHECK(!hand.studio().session().modified());
    for (const QByteArray& earlier : saved) CHECK(bytes_of(file(name)) != earlier);
    saved.push_back(bytes_of(file(name)));
  }
  CHECK(bytes_of(file("ring %1.croq")) == saved[0]);
  CHECK(bytes_of(file("ring %1_001.croq")) == saved[1]);
  CHECK(bytes_of(file("ring %1_002.croq")) == "of somebody else");
  CHECK(bytes_of(file("ring %1_003.croq")) == saved[2]);
  CHECK(QDir(hand.folder()).entryList({"*.croq*"}).size() == 5);

  // A name's own number goes on, as wide as it is.
  hand.window().files().save(file("door_9.croq"));
  hand.act("save-increment");
  CHECK(hand.window().files().path() == file("door_10.croq"));
  CHECK(warnings_of(file("door_10.croq")).empty());
}

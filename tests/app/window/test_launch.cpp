// SPDX-License-Identifier: GPL-3.0-or-later
#include <QFile>
#include <QImage>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTemporaryDir>
#include <QThread>
#include <cmath>
#include <filesystem>
#include <variant>
#include <vector>

#include <catch2/catch.hpp>

#include "croquis/io/recovery.h"

namespace {

struct Finished {
  int exit_code = -1;
  QString errors;
  QString output;
};

/// The real program; the display is that of the tests.
Finished studio(const QStringList& arguments) {
  QProcess process;
  process.start(CROQUIS_STUDIO, arguments);
  process.waitForFinished(60'000);
  return {process.exitCode(), process.readAllStandardError(), process.readAllStandardOutput()};
}

QString sketch(const char* name) { return QString(CROQUIS_SOURCE_DIR "/examples/data/") + name; }

void write(const QString& path, const QByteArray& text) {
  QFile file(path);
  REQUIRE(file.open(QIODevice::WriteOnly));
  file.write(text);
}

}  // namespace

TEST_CASE("help and version need no window, wrong options are refused", "[launch]") {
  CHECK(studio({"--help"}).output.contains("--replay"));
  CHECK(studio({"--help"}).exit_code == 0);
  CHECK(studio({"--version"}).output.startsWith("croquis "));
  CHECK(studio({"--no-such-thing"}).exit_code == 2);
  CHECK(studio({"--new", "sculpture"}).exit_code == 2);
}

TEST_CASE("a picture of an opened sketch is taken when its solid is finished", "[launch]") {
  const QTemporaryDir folder;
  const QString picture = folder.filePath("window.png");
  const Finished done = studio({sketch("trefoil.svg"), "--screenshot", picture, "--software-gl"});
  INFO(done.errors.toStdString());
  CHECK(done.exit_code == 0);
  const QImage image(picture);
  CHECK(image.width() >= 1000);
  // Clay is seen: warm light pixels in the right half.
  int clay = 0;
  for (int y = 0; y < image.height(); y += 4) {
    for (int x = image.width() / 3; x < image.width(); x += 4) {
      const QColor c = image.pixelColor(x, y);
      clay += c.red() > c.blue() + 14 && c.lightness() > 100;
    }
  }
  CHECK(clay > 500);
}

TEST_CASE("an empty surface is shown from the command line, and a network of curves opens with its patches",
          "[launch]") {
  const QTemporaryDir folder;
  const QString picture = folder.filePath("window.png");
  CHECK(studio({"--new", "surface", "--screenshot", picture, "--software-gl"}).exit_code == 0);
  CHECK(QImage(picture).width() >= 1000);
  const Finished done = studio({sketch("surface/car_crashed.json"), "--screenshot", picture, "--software-gl"});
  INFO(done.errors.toStdString());
  CHECK(done.exit_code == 0);
}

TEST_CASE("a killed studio leaves its work to the next one", "[launch]") {
  const QTemporaryDir folder;
  write(folder.filePath("draw.jsonl"), "{\"do\":\"open\",\"file\":\"" + sketch("chain.svg").toUtf8() +
                                           "\"}\n{\"do\":\"wait\",\"for\":\"solid\"}\n"
                                           "{\"do\":\"action\",\"name\":\"select-all\"}\n"
                                           "{\"do\":\"action\",\"name\":\"delete\"}\n"
                                           "{\"do\":\"action\",\"name\":\"undo\"}\n"
                                           "{\"do\":\"screenshot\",\"file\":\"" +
                                           folder.filePath("done.png").toUtf8() + "\"}\n");
  QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
  environment.insert("XDG_STATE_HOME", folder.path());
  QProcess process;
  process.setProcessEnvironment(environment);
  process.start(CROQUIS_STUDIO, {"--replay", folder.filePath("draw.jsonl"), "--stay"});
  const std::filesystem::path state = folder.filePath("croquis").toStdString();
  for (int tries = 0; tries < 150 && !QFile::exists(folder.filePath("done.png")); ++tries) QThread::msleep(100);
  // Two seconds of edits may be lost at most: by then the last one must be on the disk, of a busy machine a little
  // later.
  QThread::msleep(3500);
  process.kill();
  process.waitForFinished(5000);
  const std::vector<croquis::RecoverableWork> left = croquis::find_recoverable(state);
  REQUIRE(left.size() == 1);
  croquis::Progress progress;
  const croquis::Document document = croquis::recover(left.front().file, progress).document;
  REQUIRE(document.nodes().size() == 2);
  const auto drawing = document.nodes().front()->source->as<croquis::Drawing>();
  CHECK(drawing->strokes.size() == 16);
}

TEST_CASE("files that can't be opened end an unattended run with their code", "[launch]") {
  const QTemporaryDir folder;
  const QString picture = folder.filePath("window.png");
  const Finished missing = studio({folder.filePath("no.svg"), "--screenshot", picture});
  CHECK(missing.exit_code == 3);
  CHECK(missing.errors.contains("no.svg"));
  write(folder.filePath("bad.svg"), "<svg><path d='M 0 0 L nan");
  CHECK(studio({folder.filePath("bad.svg"), "--screenshot", picture}).exit_code == 3);
  CHECK(!QFile::exists(picture));
}

TEST_CASE("a replay draws, waits, expects and saves; a failed expectation names its line", "[launch]") {
  const QTemporaryDir folder;
  const QByteArray ring = [] {
    QByteArray points;
    for (int k = 0; k <= 40; ++k) {
      const double angle = 2 * 3.14159265358979 * k / 40;
      if (k > 0) points += ",";
      points += QString("[%1,%2,0.5,%3]").arg(100 * std::cos(angle)).arg(100 * std::sin(angle)).arg(k * 0.01).toUtf8();
    }
    return points;
  }();
  const QByteArray draw = "{\"do\":\"stroke\",\"view\":\"sketch\",\"points\":[" + ring + "],\"device\":\"pen\"}\n";
  const QString saved = folder.filePath("ball.croq");
  write(folder.filePath("ball.jsonl"),
        draw + "{\"do\":\"wait\",\"for\":\"solid\"}\n" + "{\"do\":\"expect\",\"what\":\"objects\",\"count\":1}\n" +
            "{\"do\":\"action\",\"name\":\"undo\"}\n" + "{\"do\":\"expect\",\"what\":\"strokes\",\"count\":0}\n" +
            "{\"do\":\"action\",\"name\":\"redo\"}\n" + "{\"do\":\"save\",\"file\":\"" + saved.toUtf8() + "\"}\n");
  const Finished done = studio({"--replay", folder.filePath("ball.jsonl")});
  INFO(done.errors.toStdString());
  CHECK(done.exit_code == 0);
  CHECK(QFile::exists(saved));

  write(folder.filePath("wrong.jsonl"), draw + "{\"do\":\"expect\",\"what\":\"objects\",\"count\":5}\n");
  const Finished wrong = studio({"--replay", folder.filePath("wrong.jsonl")});
  CHECK(wrong.exit_code == 4);
  CHECK(wrong.errors.contains("Line 2"));
  write(folder.filePath("broken.jsonl"), "{\"do\":\"dance\"}\n");
  CHECK(studio({"--replay", folder.filePath("broken.jsonl")}).exit_code == 3);
}

TEST_CASE("a report of the start says when the window, a view and the pen were there, one after the other",
          "[launch]") {
  for (const QStringList& what : {QStringList(), {sketch("trefoil.svg")}, {"--new", "perspective"}}) {
    const Finished done = studio(QStringList{"--startup-report", "--software-gl"} + what);
    INFO(done.errors.toStdString() << done.output.toStdString());
    CHECK(done.exit_code == 0);
    const QJsonObject report = QJsonDocument::fromJson(done.output.toUtf8()).object();
    CHECK(report.size() == 3);
    double before = 1;
    for (const char* key : {"window_ms", "view_ms", "ready_ms"}) {
      REQUIRE(report[key].isDouble());
      CHECK(report[key].toDouble() >= before);
      before = report[key].toDouble();
    }
  }
  CHECK(studio({"--startup-report", "no-such-file.svg"}).exit_code == 3);
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/file_reader.h"

#include <QFile>
#include <QFileInfo>
#include <QMetaObject>
#include <utility>

#include "app/files/picture_reader.h"
#include "app/panels/word_list.h"
#include "croquis/base/error.h"
#include "croquis/io/attribute_network_file.h"
#include "croquis/io/file.h"
#include "croquis/io/mesh_file.h"
#include "croquis/io/perspective_drawing_file.h"
#include "croquis/io/project_file.h"
#include "croquis/io/svg_drawing.h"

namespace croquis::app {
namespace {

std::string local_name(const QString& path) { return QFile::encodeName(path).toStdString(); }

bool is_sketch(const QString& path) { return QFileInfo(path).suffix().toLower() == "svg"; }

/// Drawings in perspective say that they are.
bool is_perspective_drawing(const std::string& bytes) { return bytes.find("urn:croquis:perspective:") != bytes.npos; }

bool has_ending(const QString& path, const char* ending) { return QFileInfo(path).suffix().toLower() == ending; }

/// Other JSON files are cameras. Drawings and networks name their format at the beginning.
bool is_json_drawing(const QString& path) {
  constexpr qint64 looked_at = 4096;  // bytes
  QFile file(path);
  if (!has_ending(path, "json") || !file.open(QIODevice::ReadOnly)) return false;
  const QByteArray beginning = file.read(looked_at);
  return beginning.contains("croquis-perspective/") || beginning.contains("croquis-abs/");
}

ReadFile sheet_of(const QString& path, PerspectiveReadResult read) {
  return {path, std::make_shared<const PerspectiveDrawing>(std::move(read.drawing)), std::move(read.warnings)};
}

/// A drawing, a network of curves or a camera.
ReadFile read_json_file(const QString& path, const std::string& bytes, const std::string& file) {
  if (bytes.find("croquis-perspective/") != bytes.npos) return sheet_of(path, read_perspective_json(bytes, file));
  if (bytes.find("croquis-abs/") != bytes.npos) {
    AttributeNetworkReadResult read = read_attribute_network(bytes, file);
    return {path, std::make_shared<const AttributeNetwork>(std::move(read.network)), std::move(read.warnings)};
  }
  return {path, read_camera_file(bytes, file), {}};
}

ReadFile read_drawing(const QString& path, const std::string& bytes, FileReader::PlainDrawing plain,
                      Progress& progress) {
  const std::string file = local_name(path);
  if (plain == FileReader::PlainDrawing::Perspective || is_perspective_drawing(bytes))
    return sheet_of(path, read_perspective_svg(bytes, file, progress));
  DrawingReadResult read = read_svg_drawing(bytes, file, progress);
  return {path, std::make_shared<const Drawing>(std::move(read.drawing)), std::move(read.warnings)};
}

ReadFile read_picture_file(const QString& path, std::string bytes, const std::string& file, PictureUse use,
                           Progress& progress) {
  if (use == PictureUse::Backdrop)
    return {path, std::make_shared<const PictureFile>(read_picture(std::move(bytes), file)), {}};
  return {path, std::make_shared<const Drawing>(traced_picture(std::move(bytes), file, progress)), {}, {}, true};
}

/// ".croq, .svg, .obj or .off".
std::string readable_endings() {
  std::vector<std::string> endings{".croq", ".svg", ".json", ".fspy"};
  for (const MeshFormat format : mesh_formats()) endings.push_back(extension_of(format));
  for (const QString& ending : picture_endings()) endings.push_back(ending.toStdString());
  return either_of(endings);
}

}  // namespace

FileReader::FileReader() { thread_.setMaxThreadCount(1); }

FileReader::~FileReader() {
  *cancelled_ = true;
  thread_.waitForDone();
}

bool FileReader::replaces_document(const QString& path) {
  return is_project_name(local_name(path)) || is_sketch(path) || is_json_drawing(path);
}

QString FileReader::dialog_filter() {
  QStringList endings{"*.croq", "*.svg", "*.json", "*.fspy"};
  QStringList kinds{tr("Projects (*.croq)"), tr("Earlier versions of projects (*.croq~*)"),
                    tr("Drawings and networks of curves (*.svg *.json)"), tr("Cameras (*.fspy *.json)")};
  for (const MeshFormat format : mesh_formats()) {
    const QString ending = "*" + QString::fromStdString(extension_of(format));
    endings << ending;
    kinds << QString("%1 (%2)").arg(to_string(format), ending);
  }
  QStringList pictures;
  for (const QString& ending : picture_endings()) pictures << "*" + ending;
  kinds << tr("Pictures (%1)").arg(pictures.join(' '));
  kinds.prepend(tr("Projects, drawings, meshes and pictures (%1)").arg((endings + pictures).join(' ')));
  return kinds.join(";;");
}

ReadFile FileReader::read_now(const QString& path, Progress& progress, PlainDrawing plain, PictureUse use) {
  const std::string file = local_name(path);
  if (is_project_name(file)) {
    ProjectFile project = load_project(file, progress);
    return {path, std::move(project.document), std::move(project.warnings), std::move(project.kept.results)};
  }
  std::string bytes = read_file(file);
  if (const auto format = mesh_format_of(file)) {
    MeshReadResult read = read_mesh(bytes, *format, file, progress);
    return {path, std::make_shared<const PolyMesh>(std::move(read.mesh)), std::move(read.warnings)};
  }
  if (is_picture_name(path)) return read_picture_file(path, std::move(bytes), file, use, progress);
  if (is_sketch(path)) return read_drawing(path, bytes, plain, progress);
  if (has_ending(path, "json")) return read_json_file(path, bytes, file);
  if (has_ending(path, "fspy")) return {path, read_camera_file(bytes, file), {}};
  throw Error(make_error(Category::Malformed, "E_FORMAT",
                         "\"" + file + "\" is no project, drawing, mesh or picture: open " + readable_endings()));
}

void FileReader::read(const QString& path, PlainDrawing plain, PictureUse use) {
  if (open_++ == 0) {
    *cancelled_ = false;
    emit busy_changed(true);
  }
  thread_.start([this, path, plain, use, cancelled = cancelled_] {
    Progress progress([this](double fraction, const std::string& step) { tell_progress(fraction, step); },
                      cancelled.get());
    std::shared_ptr<const ReadFile> file;
    Findings findings;
    try {
      progress.check();
      file = std::make_shared<const ReadFile>(read_now(path, progress, plain, use));
      progress.check();
    } catch (const Error& error) {
      findings = error.findings();
    } catch (const Cancelled&) {
      file.reset();
    } catch (const std::bad_alloc&) {
      findings = {make_error(Category::Limit, "E_MEMORY",
                             tr("\"%1\" doesn't fit into this machine's memory").arg(path).toStdString())};
    }
    QMetaObject::invokeMethod(
        this, [this, path, file, findings] { take(path, file, findings); }, Qt::QueuedConnection);
  });
}

void FileReader::tell_progress(double fraction, const std::string& step) {
  // One at a time: readers report far more often than a window can show.
  if (progress_posted_.exchange(true)) return;
  QMetaObject::invokeMethod(
      this,
      [this, fraction, text = QString::fromStdString(step)] {
        progress_posted_ = false;
        if (busy()) emit progress_changed(fraction, text);
      },
      Qt::QueuedConnection);
}

void FileReader::cancel() { *cancelled_ = true; }

void FileReader::take(const QString& path, std::shared_ptr<const ReadFile> file, const Findings& findings) {
  --open_;
  if (file)
    emit finished(*file);
  else
    emit failed(path, findings);
  if (open_ == 0) emit busy_changed(false);
}

}  // namespace croquis::app

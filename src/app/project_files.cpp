// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/project_files.h"

#include <QEventLoop>
#include <QFileInfo>
#include <QSettings>
#include <algorithm>
#include <utility>

#include "app/gallery.h"
#include "app/smoothing.h"
#include "croquis/base/error.h"
#include "croquis/io/file.h"
#include "croquis/io/mesh_file.h"
#include "croquis/io/project_file.h"
#include "croquis/io/svg_drawing.h"
#include "croquis/io/svg_writer.h"

namespace croquis::app {
namespace {

constexpr int autosave_delay_ms = 300;
constexpr int thumbnail_pause_ms = 10'000;       // pictures cost more than commits
constexpr std::size_t most_triangles = 300'000;  // a picture of more, made by the way, would be felt
constexpr int recent_count = 8;
constexpr QSize thumbnail_size(320, 240);
const QString recent_key = QStringLiteral("recent");

std::string local(const QString& path) { return QFile::encodeName(path).toStdString(); }

QImage image_of(const std::vector<std::uint8_t>& png) {
  return QImage::fromData(png.data(), static_cast<int>(png.size()), "PNG");
}

}  // namespace

ProjectFiles::ProjectFiles(Studio& studio, OffscreenPictures& pictures, const QString& state_folder)
    : studio_(studio), pictures_(pictures), state_folder_(state_folder) {
  disk_.setMaxThreadCount(1);
  autosave_timer_.setSingleShot(true);
  connect(&reader_, &FileReader::finished, this, &ProjectFiles::take);
  connect(&reader_, &FileReader::failed, this, &ProjectFiles::open_failed);
  connect(&autosave_timer_, &QTimer::timeout, this, &ProjectFiles::autosave);
  connect(&studio_, &Studio::changed, this, [this] {
    if (!same_nodes(studio_.session().document(), autosaved_) && !autosave_timer_.isActive()) {
      autosave_timer_.start(autosave_delay_ms);
    }
  });
  connect(&studio_, &Studio::busy_changed, this, [this](bool busy) {
    if (!busy && !has_thumbnail_) autosave_timer_.start(autosave_delay_ms);
  });
}

ProjectFiles::~ProjectFiles() { disk_.waitForDone(); }

void ProjectFiles::start_sketch() {
  studio_.start_empty();
  set_path({});
}

void ProjectFiles::start_sample(const QString& name) {
  Value sample = load_sample(name);
  if (auto* drawing = std::get_if<std::shared_ptr<const Drawing>>(&sample)) {
    studio_.start_with(**drawing);
  } else {
    auto mesh = std::get<std::shared_ptr<const PolyMesh>>(sample);
    if (kind_of_sample(name) == SampleKind::Scan) {
      studio_.load(Document());
      studio_.add_mesh(name.toStdString(), std::move(mesh));
    } else {
      studio_.load(smoothed_document(studio_, name.toStdString(), std::move(mesh)));
    }
  }
  set_path({});
}

void ProjectFiles::open(const QString& path) {
  QEventLoop waiting;
  bool failed = false;
  Findings findings;
  const auto done = connect(this, &ProjectFiles::opened, &waiting, [&](const QString& opened) {
    if (opened == path) waiting.quit();
  });
  const auto stopped =
      connect(this, &ProjectFiles::open_failed, &waiting, [&](const QString& refused, const Findings& reasons) {
        if (refused != path) return;
        failed = true;
        findings = reasons;
        waiting.quit();
      });
  begin_open(path);
  waiting.exec();
  disconnect(done);
  disconnect(stopped);
  if (!failed) return;
  if (findings.empty()) throw Cancelled();
  throw Error(std::move(findings));
}

void ProjectFiles::take(const ReadFile& file) {
  if (const auto* mesh = std::get_if<std::shared_ptr<const PolyMesh>>(&file.content)) {
    studio_.add_mesh(QFileInfo(file.path).completeBaseName().toStdString(), *mesh);
  } else if (const auto* document = std::get_if<Document>(&file.content)) {
    studio_.load(*document);
    set_path(file.path);
  } else {
    studio_.start_with(*std::get<std::shared_ptr<const Drawing>>(file.content));
    set_path({});
  }
  remember(file.path);
  emit opened(file.path);
}

void ProjectFiles::save(const QString& path) {
  Progress progress;
  ProjectFile project;
  project.document = studio_.session().document();
  project.thumbnail_png = thumbnail();
  save_project(local(path), project, progress);
  studio_.session().mark_saved();
  set_path(path);
  remember(path);
  autosave_now();
}

Findings ProjectFiles::export_solid(const QString& path) const {
  const StudioObject* object = studio_.active();
  const auto format = mesh_format_of(local(path));
  if (!format) {
    throw Error(make_error(Category::Usage, "E_FORMAT",
                           "\"" + local(path) + "\" names no mesh format: use .obj, .ply, .stl, .off or .glb"));
  }
  const auto mesh = object == nullptr ? nullptr : object->shown();
  const bool computed = mesh && mesh != object->cage_mesh;
  if (!mesh || (computed && (object->result->failed || object->quality != Quality::Final))) {
    throw Error(make_error(Category::Geometry, "E_EMPTY", "There is no finished mesh to export yet"));
  }
  Progress progress;
  MeshWriteResult written = write_mesh(*mesh, *format, {}, progress);
  OutputTransaction files;
  files.add(local(path), std::move(written.bytes));
  files.commit();
  return written.warnings;
}

void ProjectFiles::export_drawing(const QString& path) const {
  OutputTransaction files;
  files.add(local(path), write_svg_drawing(studio_.drawing()));
  files.commit();
}

QStringList ProjectFiles::recent() const {
  QStringList existing;
  for (const QString& path : QSettings().value(recent_key).toStringList()) {
    if (QFileInfo::exists(path)) existing << path;
  }
  return existing;
}

std::vector<RecoveryOffer> ProjectFiles::recoverable() const {
  std::vector<RecoveryOffer> offers;
  for (const RecoverableWork& work : find_recoverable(local(state_folder_))) {
    offers.push_back({QString::fromStdString(work.file.string()), QString::fromStdString(work.project_path),
                      QString::fromStdString(work.time), image_of(work.thumbnail_png)});
  }
  return offers;
}

void ProjectFiles::recover(const RecoveryOffer& offer) {
  Progress progress;
  studio_.load(croquis::recover(local(offer.file), progress).document, true);
  set_path(offer.project);
  autosave_now();
  croquis::discard(local(offer.file));
}

void ProjectFiles::discard(const RecoveryOffer& offer) { croquis::discard(local(offer.file)); }

void ProjectFiles::close_cleanly() {
  autosave_timer_.stop();
  disk_.waitForDone();
  if (working_copy_) working_copy_->close_cleanly();
  working_copy_.reset();
  autosaved_ = Document();
  has_thumbnail_ = false;
}

void ProjectFiles::autosave_now() {
  autosave();
  disk_.waitForDone();
}

void ProjectFiles::autosave() {
  autosave_timer_.stop();
  const Document& document = studio_.session().document();
  const bool wants_picture = !drawn_slowly() && items_ && studio_.settled() && !items_().empty() &&
                             (!has_thumbnail_ || since_thumbnail_.hasExpired(thumbnail_pause_ms));
  if (same_nodes(document, autosaved_) && !(wants_picture && !has_thumbnail_)) return;
  autosaved_ = document;
  std::vector<std::uint8_t> picture;
  if (wants_picture) {
    picture = thumbnail();
    has_thumbnail_ = !picture.empty();
    since_thumbnail_.start();
  }
  disk_.start([this, document, path = local(path_), folder = local(state_folder_), picture = std::move(picture)] {
    try {
      if (!working_copy_) working_copy_ = std::make_unique<WorkingCopy>(WorkingCopy::create(folder));
      working_copy_->commit(document, path, picture);
    } catch (const Error& error) {
      emit autosave_failed(tr("Your work is not being backed up: %1.").arg(error.what()));
    }
  });
}

bool ProjectFiles::drawn_slowly() const {
  std::size_t triangles = 0;
  for (const render::MeshItemPtr& item : items_ ? items_() : std::vector<render::MeshItemPtr>()) {
    triangles += item->triangles.size() / 3;
  }
  return triangles > most_triangles;
}

void ProjectFiles::set_path(const QString& path) {
  path_ = path;
  emit path_changed(path);
}

void ProjectFiles::remember(const QString& path) {
  QStringList paths = QSettings().value(recent_key).toStringList();
  const QString full = QFileInfo(path).absoluteFilePath();
  paths.removeAll(full);
  paths.prepend(full);
  QSettings().setValue(recent_key, QStringList(paths.mid(0, recent_count)));
}

std::vector<std::uint8_t> ProjectFiles::thumbnail() const {
  const auto items = items_ ? items_() : std::vector<render::MeshItemPtr>();
  if (items.empty()) return {};
  try {
    return png_bytes(pictures_.draw(items, render::NamedView::Perspective, thumbnail_size));
  } catch (const Error&) {
    return {};  // a project without a picture is a project
  }
}

}  // namespace croquis::app

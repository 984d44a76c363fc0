// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/project_files.h"

#include <QFileInfo>
#include <QSettings>
#include <algorithm>
#include <utility>

#include "app/gallery.h"
#include "croquis/base/error.h"
#include "croquis/io/file.h"
#include "croquis/io/mesh_file.h"
#include "croquis/io/project_file.h"
#include "croquis/io/svg_drawing.h"
#include "croquis/io/svg_writer.h"

namespace croquis::app {
namespace {

constexpr int autosave_delay_ms = 300;
constexpr int thumbnail_pause_ms = 10'000;  // pictures cost more than commits
constexpr int recent_count = 8;
constexpr QSize thumbnail_size(320, 240);
const QString recent_key = QStringLiteral("recent");

std::string local(const QString& path) { return QFile::encodeName(path).toStdString(); }

Document document_of(std::shared_ptr<const PolyMesh> mesh, const QString& name) {
  Node node;
  node.name = name.toStdString();
  node.source = std::move(mesh);
  return Document().with(std::move(node));
}

QImage image_of(const std::vector<std::uint8_t>& png) {
  return QImage::fromData(png.data(), static_cast<int>(png.size()), "PNG");
}

std::vector<render::MeshItemPtr> solid_items(const Studio& studio) {
  std::vector<render::MeshItemPtr> items;
  if (const auto solid = studio.solid()) items.push_back(render::make_mesh_item(*solid));
  return items;
}

}  // namespace

ProjectFiles::ProjectFiles(Studio& studio, OffscreenPictures& pictures, const QString& state_folder)
    : studio_(studio), pictures_(pictures), state_folder_(state_folder) {
  disk_.setMaxThreadCount(1);
  autosave_timer_.setSingleShot(true);
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

void ProjectFiles::start_gallery_sketch(const QString& name) {
  studio_.start_with(load_gallery_sketch(name));
  set_path({});
}

void ProjectFiles::open(const QString& path) {
  Progress progress;
  const std::string file = local(path);
  const QString suffix = QFileInfo(path).suffix().toLower();
  if (suffix == "croq") {
    studio_.load(load_project(file, progress).document);
    set_path(path);
    remember(path);
    return;
  }
  const std::string bytes = read_file(file);
  if (const auto format = mesh_format_of(file)) {
    MeshReadResult read = read_mesh(bytes, *format, file, progress);
    studio_.load(document_of(std::make_shared<const PolyMesh>(std::move(read.mesh)), QFileInfo(path).baseName()));
  } else if (suffix == "svg") {
    studio_.start_with(read_svg_drawing(bytes, file, progress).drawing);
  } else {
    throw Error(
        make_error(Category::Malformed, "E_FORMAT",
                   "\"" + file + "\" is no project, sketch or mesh: open .croq, .svg, .obj, .ply, .stl or .off"));
  }
  set_path({});
  remember(path);
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
  const auto solid = studio_.solid();
  const auto format = mesh_format_of(local(path));
  if (!format) {
    throw Error(make_error(Category::Usage, "E_FORMAT",
                           "\"" + local(path) + "\" names no mesh format: use .obj, .ply, .stl, .off or .glb"));
  }
  if (!solid || studio_.result()->failed || studio_.result_quality() != Quality::Final) {
    throw Error(make_error(Category::Geometry, "E_EMPTY", "There is no finished solid to export yet"));
  }
  Progress progress;
  MeshWriteResult written = write_mesh(*solid, *format, {}, progress);
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
  const bool wants_picture =
      studio_.solid() && studio_.settled() && (!has_thumbnail_ || since_thumbnail_.hasExpired(thumbnail_pause_ms));
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
  const auto items = solid_items(studio_);
  if (items.empty()) return {};
  try {
    return png_bytes(pictures_.draw(items, render::NamedView::Perspective, thumbnail_size));
  } catch (const Error&) {
    return {};  // a project without a picture is a project
  }
}

}  // namespace croquis::app

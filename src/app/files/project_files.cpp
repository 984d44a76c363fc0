// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/project_files.h"

#include <QDir>
#include <QEventLoop>
#include <QFileInfo>
#include <QRegularExpression>
#include <QSettings>
#include <algorithm>
#include <array>

#include "app/start/gallery.h"
#include "app/studio/content.h"
#include "croquis/base/error.h"
#include "croquis/io/project_file.h"
#include "croquis/io/recovery.h"

namespace croquis::app {
namespace {

constexpr int recent_count = 8;
const QString recent_key = QStringLiteral("recent");

QString whole_path(const QString& path) {
  const QFileInfo file(path);
  const QString canonical = file.canonicalFilePath();
  return canonical.isEmpty() && !path.isEmpty() ? file.absoluteFilePath() : canonical;
}

Finding open_elsewhere(const QString& path) {
  const std::string name = QFileInfo(path).fileName().toStdString();
  return make_warning(Category::Io, "W_PROJECT_OPEN",
                      "\"" + name +
                          "\" is open in another window of Croquis, too: whoever saves last replaces what the other "
                          "saved, so close one of them or save under another name",
                      {{SubjectKind::File, name, local_name(path), {}, {}}});
}

std::pair<QDateTime, qint64> time_and_size(const QString& path) {
  const QFileInfo file(path);
  return {file.lastModified(), file.size()};
}

bool name_damage(const Findings& findings) {
  // A project without its first bytes isn't recognised by the reader.
  constexpr std::array damages = {"W_PROJECT_DAMAGED", "E_PROJECT_DAMAGED", "E_PROJECT_FORMAT", "E_EMPTY"};
  return std::ranges::any_of(
      findings, [&](const Finding& finding) { return std::ranges::find(damages, finding.code) != damages.end(); });
}

QImage image_of(const std::vector<std::uint8_t>& png) {
  return QImage::fromData(png.data(), static_cast<int>(png.size()), "PNG");
}

/// First among the recent files.
void remember(const QString& path) {
  QStringList paths = QSettings().value(recent_key).toStringList();
  const QString full = QFileInfo(path).absoluteFilePath();
  paths.removeAll(full);
  paths.prepend(full);
  QSettings().setValue(recent_key, QStringList(paths.mid(0, recent_count)));
}

/// What takes the place of what is open: a project, a drawing or a network.
void take_whole(Studio& studio, const ReadFile& file) {
  const std::string name = QFileInfo(file.path).completeBaseName().toStdString();
  if (const auto* document = std::get_if<Document>(&file.content)) {
    studio.load(*document, false, {file.kept.results, {}, file.kept.versions});
  } else if (const auto* sheet = std::get_if<std::shared_ptr<const PerspectiveDrawing>>(&file.content)) {
    start_with(studio, **sheet, name);
  } else if (const auto* network = std::get_if<std::shared_ptr<const AttributeNetwork>>(&file.content)) {
    start_with(studio, **network, name);
  } else {
    start_with(studio, *std::get<std::shared_ptr<const Drawing>>(file.content));
  }
}

}  // namespace

ProjectFiles::ProjectFiles(Studio& studio, OffscreenPictures& pictures, const QString& state_folder)
    : studio_(studio), keeper_(studio, pictures, state_folder), state_folder_(state_folder) {
  connect(&reader_, &FileReader::finished, this, &ProjectFiles::take);
  connect(&reader_, &FileReader::failed, this, [this](const QString& path, const Findings& findings) {
    replacing_.remove(path);
    note_damage(path, findings);
    emit open_failed(path, findings);
  });
  connect(&studio_, &Studio::loaded, this, [this] { warnings_.clear(); });
}

QString ProjectFiles::file_name() const { return QFileInfo(path_.isEmpty() ? earlier_version_ : path_).fileName(); }

bool ProjectFiles::is_damaged(const QString& path) const { return damaged_.contains(whole_path(path)); }

QString ProjectFiles::rescue_path() const {
  if (is_damaged(path_)) {
    const QFileInfo file(path_);
    return file.dir().filePath(tr("%1 rescued.croq").arg(file.completeBaseName()));
  }
  const auto project = project_of_backup(local_name(earlier_version_));
  return project ? QString::fromStdString(project->string()) : QString();
}

void ProjectFiles::note_damage(const QString& path, const Findings& findings) {
  const bool project = path.endsWith(".croq", Qt::CaseInsensitive) || project_of_backup(local_name(path));
  if (project && name_damage(findings)) damaged_.insert(whole_path(path));
}

bool ProjectFiles::is_open_elsewhere(const QString& path) {
  const bool own = whole_path(path) == whole_path(path_);
  if (own && lock_) return false;
  try {
    auto lock = ProjectLock::take(local_name(state_folder_), local_name(path));
    if (!lock) return true;
    if (own) lock_ = std::move(lock);
  } catch (const Error&) {
    // A state folder that can't be written is reported when work is kept there.
  }
  return false;
}

bool ProjectFiles::has_changed(const QString& path) const {
  return whole_path(path) == whole_path(path_) && QFileInfo::exists(path) && time_and_size(path) != known_file_;
}

void ProjectFiles::start_sketch() {
  studio_.load(Document());
  set_path({});
}

void ProjectFiles::start_sample(const QString& name) {
  Value sample = load_sample(name);
  if (const auto drawing = sample.as<Drawing>()) {
    start_with(studio_, *drawing);
  } else if (const auto network = sample.as<AttributeNetwork>()) {
    start_with(studio_, *network, name.toStdString());
  } else {
    auto mesh = sample.as<PolyMesh>();
    if (kind_of_sample(name) == SampleKind::Scan) {
      studio_.load(Document());
      add_source(studio_, name.toStdString(), std::move(mesh));
    } else {
      start_with(studio_, name.toStdString(), std::move(mesh), first_step_of_sample(name));
    }
  }
  set_path({});
}

void ProjectFiles::begin_open(const QString& path, bool replaces, PictureUse use) {
  if (replaces) replacing_.insert(path);
  using Plain = FileReader::PlainDrawing;
  reader_.read(path, studio_.sheet_node() != 0 ? Plain::Perspective : Plain::Sketch, use);
}

void ProjectFiles::take(const ReadFile& file) {
  const auto* mesh = std::get_if<std::shared_ptr<const PolyMesh>>(&file.content);
  has_replaced_ = replacing_.remove(file.path) && mesh != nullptr;
  if (has_replaced_) start_sketch();
  has_traced_ = file.is_traced;
  if (mesh != nullptr) {
    // Files that were only looked at have no changes to save.
    const bool looked_at = path_.isEmpty() && !keeper_.touched();
    add_source(studio_, QFileInfo(file.path).completeBaseName().toStdString(), *mesh);
    if (looked_at) {
      studio_.session().mark_saved();
      keeper_.forget();
    }
  } else if (const auto* picture = std::get_if<std::shared_ptr<const PictureFile>>(&file.content)) {
    add_picture(studio_, *picture);
  } else if (const auto* camera = std::get_if<CameraFile>(&file.content)) {
    state_camera(studio_, camera->camera);
  } else if (file.is_traced) {
    add_traced(studio_, std::get<std::shared_ptr<const Drawing>>(file.content));
  } else {
    take_whole(studio_, file);
    // An earlier version of a project is looked at, and saved under a name that the user chooses.
    const bool project = std::holds_alternative<Document>(file.content);
    const bool earlier = project && project_of_backup(local_name(file.path));
    set_path(project && !earlier ? file.path : QString(), earlier ? file.path : QString());
  }
  note_damage(file.path, file.warnings);
  Findings warnings = file.warnings;
  if (file.path == path_ && is_open_elsewhere(path_)) warnings.push_back(open_elsewhere(path_));
  warnings_.add(warnings, studio_.session().document());
  if (!project_of_backup(local_name(file.path))) remember(file.path);
  emit opened(file.path, warnings);
}

QString ProjectFiles::save(const QString& path) {
  Progress progress;
  ProjectFile project;
  project.document = studio_.session().document();
  project.thumbnail_png = keeper_.thumbnail();
  project.kept = {kept_results(studio_), {}, studio_.session().versions.list()};
  QString aside;
  if (is_damaged(path) && QFileInfo::exists(path)) {
    aside = QString::fromStdString(put_damaged_project_aside(local_name(path)).string());
  }
  try {
    save_project(local_name(path), project, progress);
  } catch (const Error&) {
    if (!aside.isEmpty()) QFile::rename(aside, path);
    throw;
  }
  damaged_.remove(whole_path(path));
  warnings_.clear();
  set_path(path);
  remember(path);
  keeper_.forget();
  studio_.session().mark_saved();
  return aside;
}

std::vector<RecoveryOffer> ProjectFiles::recoverable() const {
  std::vector<RecoveryOffer> offers;
  for (const RecoverableWork& work : find_recoverable(local_name(state_folder_))) {
    offers.push_back({QString::fromStdString(work.file.string()), QString::fromStdString(work.project_path),
                      QDateTime::fromString(QString::fromStdString(work.time), Qt::ISODate),
                      image_of(work.thumbnail_png)});
  }
  return offers;
}

void ProjectFiles::recover(const RecoveryOffer& offer) {
  Progress progress;
  ProjectFile work = croquis::recover(local_name(offer.file), progress);
  studio_.load(std::move(work.document), true, std::move(work.kept));
  set_path(offer.project);
  warnings_.add(work.warnings, studio_.session().document());
  keeper_.save_now();
  croquis::discard(local_name(offer.file));
}

void ProjectFiles::set_path(const QString& path, const QString& earlier_version) {
  if (whole_path(path) != whole_path(path_)) lock_.reset();
  path_ = path;
  earlier_version_ = earlier_version;
  keeper_.set_project(path);
  known_file_ = time_and_size(path);
  if (!path.isEmpty()) is_open_elsewhere(path);  // takes the lock
  emit path_changed(path);
}

void open_now(ProjectFiles& files, const QString& path, bool replaces, PictureUse use) {
  QEventLoop waiting;
  bool failed = false;
  Findings findings;
  const auto done = QObject::connect(&files, &ProjectFiles::opened, &waiting, [&](const QString& opened) {
    if (opened == path) waiting.quit();
  });
  const auto stopped = QObject::connect(&files, &ProjectFiles::open_failed, &waiting,
                                        [&](const QString& refused, const Findings& reasons) {
                                          if (refused != path) return;
                                          failed = true;
                                          findings = reasons;
                                          waiting.quit();
                                        });
  files.begin_open(path, replaces, use);
  waiting.exec();
  QObject::disconnect(done);
  QObject::disconnect(stopped);
  if (!failed) return;
  if (findings.empty()) throw Cancelled();
  throw Error(std::move(findings));
}

QStringList recent_files() {
  QStringList existing;
  for (const QString& path : QSettings().value(recent_key).toStringList()) {
    if (QFileInfo::exists(path)) existing << path;
  }
  return existing;
}

QString next_increment(const QString& path) {
  static const QRegularExpression numbered(QStringLiteral("^(.*)_([0-9]{1,9})$"));
  const QFileInfo file(path);
  const QString name = file.completeBaseName();
  const QRegularExpressionMatch found = numbered.match(name);
  const QString stem = found.hasMatch() ? found.captured(1) : name;
  const auto digits = found.hasMatch() ? static_cast<int>(found.capturedLength(2)) : 3;
  QFileInfo next;
  qlonglong number = found.captured(2).toLongLong();
  do {
    next.setFile(file.dir(), stem + '_' + QString::number(++number).rightJustified(digits, '0') + ".croq");
  } while (next.exists() || next.isSymLink());
  return next.filePath();
}

void discard(const RecoveryOffer& offer) { croquis::discard(local_name(offer.file)); }

}  // namespace croquis::app

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/project_files.h"

#include <QDir>
#include <QEventLoop>
#include <QFileInfo>
#include <QSettings>
#include <algorithm>
#include <array>

#include "app/start/gallery.h"
#include "croquis/base/error.h"
#include "croquis/io/attribute_network_file.h"
#include "croquis/io/file.h"
#include "croquis/io/mesh_file.h"
#include "croquis/io/perspective_drawing_file.h"
#include "croquis/io/project_file.h"
#include "croquis/io/svg_drawing.h"
#include "croquis/io/svg_writer.h"
#include "croquis/workspace/chain.h"

namespace croquis::app {
namespace {

constexpr int autosave_delay_ms = 300;
constexpr int thumbnail_pause_ms = 10'000;  // pictures cost more than commits
constexpr int recent_count = 8;
constexpr std::size_t most_kept_steps = 50;  // that undo leads back to after a crash
constexpr QSize thumbnail_size(320, 240);
const QString recent_key = QStringLiteral("recent");

std::string local(const QString& path) { return QFile::encodeName(path).toStdString(); }

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
                      {{SubjectKind::File, name, local(path), {}, {}}});
}

std::pair<QDateTime, qint64> time_and_size(const QString& path) {
  const QFileInfo file(path);
  return {file.lastModified(), file.size()};
}

std::string writable_endings() {
  std::vector<std::string> endings;
  for (const MeshFormat format : mesh_formats()) endings.push_back(extension_of(format));
  return either_of(endings);
}

QImage image_of(const std::vector<std::uint8_t>& png) {
  return QImage::fromData(png.data(), static_cast<int>(png.size()), "PNG");
}

}  // namespace

ProjectFiles::ProjectFiles(Studio& studio, OffscreenPictures& pictures, const QString& state_folder)
    : studio_(studio), pictures_(pictures), state_folder_(state_folder) {
  disk_.setMaxThreadCount(1);
  autosave_timer_.setSingleShot(true);
  connect(&reader_, &FileReader::finished, this, &ProjectFiles::take);
  connect(&reader_, &FileReader::failed, this, [this](const QString& path, const Findings& findings) {
    replacing_.remove(path);
    note_damage(path, findings);
    emit open_failed(path, findings);
  });
  connect(&autosave_timer_, &QTimer::timeout, this, &ProjectFiles::autosave);
  connect(&studio_, &Studio::loaded, this, [this] {
    forget_work();
    warnings_.clear();
  });
  connect(&studio_, &Studio::changed, this, &ProjectFiles::follow_session);
  connect(&studio_, &Studio::busy_changed, this, [this](bool busy) {
    if (!busy) autosave_timer_.start(autosave_delay_ms);
  });
}

ProjectFiles::~ProjectFiles() { disk_.waitForDone(); }

QString ProjectFiles::file_name() const { return QFileInfo(path_.isEmpty() ? earlier_version_ : path_).fileName(); }

bool ProjectFiles::is_damaged(const QString& path) const { return damaged_.contains(whole_path(path)); }

QString ProjectFiles::rescue_path() const {
  if (is_damaged(path_)) {
    const QFileInfo file(path_);
    return file.dir().filePath(tr("%1 rescued.croq").arg(file.completeBaseName()));
  }
  const auto project = project_of_backup(local(earlier_version_));
  return project ? QString::fromStdString(project->string()) : QString();
}

void ProjectFiles::note_damage(const QString& path, const Findings& findings) {
  // A project without its first bytes isn't recognised by the reader.
  constexpr std::array damages = {"W_PROJECT_DAMAGED", "E_PROJECT_DAMAGED", "E_PROJECT_FORMAT", "E_EMPTY"};
  const bool damaged = std::ranges::any_of(
      findings, [&](const Finding& finding) { return std::ranges::find(damages, finding.code) != damages.end(); });
  const bool project = path.endsWith(".croq", Qt::CaseInsensitive) || project_of_backup(local(path));
  if (damaged && project) damaged_.insert(whole_path(path));
}

bool ProjectFiles::is_open_elsewhere(const QString& path) {
  const bool own = whole_path(path) == whole_path(path_);
  if (own && lock_) return false;
  try {
    auto lock = ProjectLock::take(local(state_folder_), local(path));
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

void ProjectFiles::follow_session() {
  const Session& session = studio_.session();
  touched_ = touched_ || session.modified();
  if (!touched_ || same_nodes(session.document(), autosaved_) || autosave_timer_.isActive()) return;
  autosave_timer_.start(autosave_delay_ms);
}

/// What is open needs no working copy: it is saved, or not wanted.
void ProjectFiles::forget_work() {
  autosave_timer_.stop();
  touched_ = false;
  autosaved_ = Document();
  autosaved_results_.clear();
  has_thumbnail_ = false;
  disk_.start([this] {
    if (working_copy_) working_copy_->close_cleanly();
    working_copy_.reset();
  });
}

void ProjectFiles::start_sketch() {
  studio_.start_empty();
  earlier_version_.clear();
  set_path({});
}

void ProjectFiles::start_sample(const QString& name) {
  Value sample = load_sample(name);
  earlier_version_.clear();
  if (const auto drawing = sample.as<Drawing>()) {
    studio_.start_with(*drawing);
  } else if (const auto network = sample.as<AttributeNetwork>()) {
    studio_.start_with(*network, name.toStdString());
  } else {
    auto mesh = sample.as<PolyMesh>();
    if (kind_of_sample(name) == SampleKind::Scan) {
      studio_.load(Document());
      studio_.add_mesh(name.toStdString(), std::move(mesh));
    } else {
      studio_.start_with(name.toStdString(), std::move(mesh), first_step_of_sample(name));
    }
  }
  set_path({});
}

void ProjectFiles::begin_open(const QString& path, bool replaces, PictureUse use) {
  if (replaces) replacing_.insert(path);
  using Plain = FileReader::PlainDrawing;
  reader_.read(path, studio_.sheet_node() != 0 ? Plain::Perspective : Plain::Sketch, use);
}

void ProjectFiles::open(const QString& path, bool replaces, PictureUse use) {
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
  begin_open(path, replaces, use);
  waiting.exec();
  disconnect(done);
  disconnect(stopped);
  if (!failed) return;
  if (findings.empty()) throw Cancelled();
  throw Error(std::move(findings));
}

void ProjectFiles::take(const ReadFile& file) {
  const auto* mesh = std::get_if<std::shared_ptr<const PolyMesh>>(&file.content);
  has_replaced_ = replacing_.remove(file.path) && mesh != nullptr;
  if (has_replaced_) start_sketch();
  has_traced_ = file.is_traced;
  if (mesh != nullptr) {
    // Files that were only looked at have no changes to save.
    const bool looked_at = path_.isEmpty() && !touched_;
    studio_.add_mesh(QFileInfo(file.path).completeBaseName().toStdString(), *mesh);
    if (looked_at) {
      studio_.session().mark_saved();
      forget_work();
    }
  } else if (const auto* picture = std::get_if<std::shared_ptr<const PictureFile>>(&file.content)) {
    studio_.add_picture(*picture);
  } else if (const auto* camera = std::get_if<CameraFile>(&file.content)) {
    studio_.state_camera(camera->camera);
  } else if (const auto* document = std::get_if<Document>(&file.content)) {
    take_project(file.path, *document, file.kept);
  } else if (const auto* sheet = std::get_if<std::shared_ptr<const PerspectiveDrawing>>(&file.content)) {
    studio_.start_with(**sheet, QFileInfo(file.path).completeBaseName().toStdString());
    earlier_version_.clear();
    set_path({});
  } else if (const auto* network = std::get_if<std::shared_ptr<const AttributeNetwork>>(&file.content)) {
    studio_.start_with(**network, QFileInfo(file.path).completeBaseName().toStdString());
    earlier_version_.clear();
    set_path({});
  } else if (file.is_traced) {
    studio_.add_traced(std::get<std::shared_ptr<const Drawing>>(file.content));
  } else {
    studio_.start_with(*std::get<std::shared_ptr<const Drawing>>(file.content));
    earlier_version_.clear();
    set_path({});
  }
  note_damage(file.path, file.warnings);
  Findings warnings = file.warnings;
  if (file.path == path_ && is_open_elsewhere(path_)) warnings.push_back(open_elsewhere(path_));
  warnings_.add(warnings, studio_.session().document());
  if (!project_of_backup(local(file.path))) remember(file.path);
  emit opened(file.path, warnings);
}

/// An earlier version is looked at, and saved under a name that the user chooses.
void ProjectFiles::take_project(const QString& path, const Document& document, const KeptResults& kept) {
  studio_.load(document, false, {kept, {}});
  const bool earlier = project_of_backup(local(path)).has_value();
  earlier_version_ = earlier ? path : QString();
  set_path(earlier ? QString() : path);
}

QString ProjectFiles::save(const QString& path) {
  Progress progress;
  ProjectFile project;
  project.document = studio_.session().document();
  project.thumbnail_png = thumbnail_of(shown_items());
  project.kept.results = studio_.kept_results();
  QString aside;
  if (is_damaged(path) && QFileInfo::exists(path)) {
    aside = QString::fromStdString(put_damaged_project_aside(local(path)).string());
  }
  try {
    save_project(local(path), project, progress);
  } catch (const Error&) {
    if (!aside.isEmpty()) QFile::rename(aside, path);
    throw;
  }
  damaged_.remove(whole_path(path));
  earlier_version_.clear();
  warnings_.clear();
  set_path(path);
  remember(path);
  forget_work();
  studio_.session().mark_saved();
  return aside;
}

Findings ProjectFiles::export_solid(const QString& path, const MeshExport& wanted) const {
  const auto format = mesh_format_of(local(path));
  if (!format) {
    throw Error(make_error(Category::Usage, "E_FORMAT",
                           "\"" + local(path) + "\" names no mesh format: use " + writable_endings()));
  }
  const std::vector<NamedMesh> meshes = meshes_of(wanted);
  Progress progress;
  MeshWriteOptions options;
  const WorkObject* object = studio_.active();
  if (meshes.size() == 1 && object->shown() == meshes.front().mesh) options.camera = camera_of(*object);
  if (meshes.size() == 1) options.name = meshes.front().name;
  MeshWriteResult written = write_mesh(joined(meshes), *format, options, progress);
  OutputTransaction files;
  files.add(local(path), std::move(written.bytes));
  files.commit();
  return written.warnings;
}

/// The camera that the object was drawn for.
std::optional<Camera> ProjectFiles::camera_of(const WorkObject& object) const {
  const auto camera = studio_.value_along(object, ValueType::Camera).as<Camera>();
  if (camera == nullptr) return std::nullopt;
  return *camera;
}

std::vector<const OperationDescription*> ProjectFiles::exports() const {
  std::vector<const OperationDescription*> found;
  for (const OperationDescription& operation : studio_.registry().descriptions()) {
    const PortDescription* output = main_output(operation);
    if (output != nullptr && output->type == ValueType::AttributeNetwork) found.push_back(&operation);
  }
  return found;
}

bool ProjectFiles::can_export(const OperationDescription& operation) const {
  const WorkObject* object = studio_.active();
  const PortDescription* input = main_input(operation);
  return object != nullptr && input != nullptr && studio_.value_along(*object, input->type).has_content();
}

Findings ProjectFiles::export_result(const OperationDescription& operation, const QString& path) const {
  const WorkObject* object = studio_.active();
  const PortDescription& input = *main_input(operation);
  const Value value = object == nullptr ? Value() : studio_.value_along(*object, input.type);
  if (!value.has_content()) {
    throw Error(make_error(Category::Geometry, "E_EMPTY",
                           "There is no finished " + std::string(to_string(input.type)) + " to export yet"));
  }
  Progress progress;
  Context context{progress};
  const OperationResult made = run(*studio_.registry().find(operation.id), {{input.name, value}}, {}, context);
  OutputTransaction files;
  files.add(local(path),
            write_attribute_network(made.outputs.at(main_output(operation)->name).get<AttributeNetwork>()));
  files.commit();
  return made.warnings;
}

std::shared_ptr<const Brep> ProjectFiles::exact_solid() const {
  const WorkObject* object = studio_.active();
  if (object == nullptr || !object->result || object->result->failed || object->result->stale) return nullptr;
  if (object->result->quality != Quality::Final) return nullptr;
  for (const auto& [name, value] : object->result->outputs) {
    const auto solid = value.as<Brep>();
    if (!solid || solid->faces.empty()) continue;
    return value.transformed(object->placement.map()).as<Brep>();
  }
  return nullptr;
}

void ProjectFiles::export_step(const QString& path) {
  const std::shared_ptr<const Brep> solid = exact_solid();
  if (!solid) {
    throw Error(make_error(Category::Geometry, "E_EMPTY",
                           "There is no finished solid of a drawing in perspective to export yet"));
  }
  StepOptions options;
  options.name = QFileInfo(path).completeBaseName().toStdString();
  const NodeId first = studio_.active()->chain.front();
  const auto sheet = source_of<PerspectiveDrawing>(studio_.session().document().find(first));
  if (sheet) options.unit = length_unit_named(sheet->unit).value_or(LengthUnit::Millimetre);
  step_export_.start(solid, std::move(options), path);
}

void ProjectFiles::export_drawing(const QString& path) const {
  OutputTransaction files;
  const Document& document = studio_.session().document();
  const auto sheet = source_of<PerspectiveDrawing>(document.find(studio_.sheet_node()));
  const auto network = source_of<AttributeNetwork>(document.find(studio_.network_node()));
  files.add(local(path), network ? write_attribute_network(*network)
                         : sheet ? write_perspective_svg(*sheet)
                                 : write_svg_drawing(studio_.drawing()));
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
                      QDateTime::fromString(QString::fromStdString(work.time), Qt::ISODate),
                      image_of(work.thumbnail_png)});
  }
  return offers;
}

void ProjectFiles::recover(const RecoveryOffer& offer) {
  Progress progress;
  ProjectFile work = croquis::recover(local(offer.file), progress);
  studio_.load(std::move(work.document), true, std::move(work.kept));
  earlier_version_.clear();
  set_path(offer.project);
  warnings_.add(work.warnings, studio_.session().document());
  autosave_now();
  croquis::discard(local(offer.file));
}

void ProjectFiles::discard(const RecoveryOffer& offer) { croquis::discard(local(offer.file)); }

void ProjectFiles::discard_all() {
  for (const RecoverableWork& work : find_recoverable(local(state_folder_))) croquis::discard(work.file);
}

void ProjectFiles::close_cleanly() {
  forget_work();
  disk_.waitForDone();
}

void ProjectFiles::autosave_now() {
  autosave();
  disk_.waitForDone();
}

void ProjectFiles::autosave() {
  autosave_timer_.stop();
  if (!touched_) return;
  const Document& document = studio_.session().document();
  const auto items = studio_.settled() ? shown_items() : std::vector<render::Shown<render::MeshItem>>();
  const bool wants_picture = !items.empty() && (!has_thumbnail_ || since_thumbnail_.hasExpired(thumbnail_pause_ms));
  KeptWork kept{studio_.kept_results(), studio_.session().past(most_kept_steps)};
  const bool same = same_nodes(document, autosaved_) && kept.results == autosaved_results_;
  if (same && !(wants_picture && !has_thumbnail_)) return;
  autosaved_ = document;
  autosaved_results_ = kept.results;
  if (wants_picture) {
    has_thumbnail_ = true;
    since_thumbnail_.start();
  }
  disk_.start([this, document, path = local(path_), folder = local(state_folder_), kept = std::move(kept),
               items = wants_picture ? items : std::vector<render::Shown<render::MeshItem>>()] {
    try {
      if (!working_copy_) working_copy_ = std::make_unique<WorkingCopy>(WorkingCopy::create(folder));
      working_copy_->commit(document, path, {}, kept);
      if (!items.empty())
        working_copy_->commit(document, path, thumbnail_of(items), kept);  // later: pictures take longer
    } catch (const Error& error) {
      emit autosave_failed(tr("Your work is not being backed up: %1.").arg(error.what()));
    }
  });
}

std::vector<render::Shown<render::MeshItem>> ProjectFiles::shown_items() const {
  return items_ ? items_() : std::vector<render::Shown<render::MeshItem>>();
}

void ProjectFiles::set_path(const QString& path) {
  if (whole_path(path) != whole_path(path_)) lock_.reset();
  path_ = path;
  known_file_ = time_and_size(path);
  if (!path.isEmpty()) is_open_elsewhere(path);  // takes the lock
  emit path_changed(path);
}

void ProjectFiles::remember(const QString& path) {
  QStringList paths = QSettings().value(recent_key).toStringList();
  const QString full = QFileInfo(path).absoluteFilePath();
  paths.removeAll(full);
  paths.prepend(full);
  QSettings().setValue(recent_key, QStringList(paths.mid(0, recent_count)));
}

std::vector<std::uint8_t> ProjectFiles::thumbnail_of(const std::vector<render::Shown<render::MeshItem>>& items) const {
  if (items.empty()) return {};
  try {
    return png_bytes(pictures_.draw_small(items, render::NamedView::Perspective, thumbnail_size));
  } catch (const Error&) {
    return {};  // a project without a picture is a project
  }
}

}  // namespace croquis::app

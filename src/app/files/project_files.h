// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDateTime>
#include <QElapsedTimer>
#include <QObject>
#include <QSet>
#include <QStringList>
#include <QThreadPool>
#include <QTimer>
#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "app/files/file_reader.h"
#include "app/files/mesh_export.h"
#include "app/start/start_page.h"
#include "app/studio/studio.h"
#include "app/views/offscreen_pictures.h"
#include "croquis/geometry/camera.h"
#include "croquis/geometry/joined_meshes.h"
#include "croquis/io/project_lock.h"
#include "croquis/io/recovery.h"
#include "croquis/workspace/read_findings.h"

namespace croquis::app {

/// Which meshes go into a file.
struct MeshExport {
  enum class Objects { Picked, Visible, All };  ///< Picked: the active one where none is

  Objects objects = Objects::Picked;
  std::string unit = {};  ///< "mm", "cm", "m" or "in" that lengths of the file have; empty: those of the document
};

/// Everything between the studio and files: projects, sketches, exports, recent files, and the working copy that
/// survives a crash. Asks nothing and shows nothing; failures are thrown as Error.
class ProjectFiles : public QObject {
  Q_OBJECT

 public:
  /// @param state_folder where working copies lie
  ProjectFiles(Studio& studio, OffscreenPictures& pictures, const QString& state_folder);
  ~ProjectFiles() override;

  /// Of the project that is open; empty for one that was never saved.
  const QString& path() const { return path_; }

  /// The file's name; of an earlier version that was opened, its own; empty for what came from no project.
  QString file_name() const;

  /// What was wrong with the files that the open document came from, without what was said of strokes that were changed
  /// since; W_PROJECT_OPEN when others have it open, too.
  Findings warnings() const { return warnings_.in(studio_.session().document()); }

  /// A project that was found damaged is never overwritten: saving there keeps it beside the new one.
  bool is_damaged(const QString& path) const;

  /// Where to save instead of over a damaged project, or what was opened from an earlier version; else empty.
  QString rescue_path() const;

  /// Another window or process has that project open.
  bool is_open_elsewhere(const QString& path);

  /// The open project's file isn't what was read or written here last: another window or program saved it since.
  bool has_changed(const QString& path) const;

  void start_sketch();
  /// A sketch or cage that ships inside the program.
  void start_sample(const QString& name);

  /// Begins to open a project (.croq), a sketch (.svg) or a mesh; `opened` or `open_failed` follows. Meshes are added
  /// to what is open, or take its place; so are pictures, or drawings of their lines.
  /// SVG files that don't say what they are are read as what is being worked on: a sketch, or a drawing in perspective.
  void begin_open(const QString& path, bool replaces = false, PictureUse use = PictureUse::Backdrop);

  /// The same, and waits, keeping the window alive. @throws Error, Cancelled
  void open(const QString& path, bool replaces = false, PictureUse use = PictureUse::Backdrop);

  /// The mesh that was opened last took the place of what was open.
  bool has_replaced() const { return has_replaced_; }

  /// Of the picture that was opened last the lines were traced.
  bool has_traced() const { return has_traced_; }

  /// What reads them.
  FileReader& reader() { return reader_; }
  const FileReader& reader() const { return reader_; }

  /// Where pictures of what is shown come from: items made ready anyway.
  void set_items(std::function<std::vector<render::Shown<render::MeshItem>>()> items) { items_ = std::move(items); }

  /// Keeps up to three older versions beside the file; a damaged one under a name of its own.
  /// @return where the damaged one is now, or nothing
  QString save(const QString& path);

  /// The surfaces of these objects as they are shown, where they stand, by their names.
  /// @throws Error (E_EMPTY) where one isn't finished, or there is none
  std::vector<NamedMesh> meshes_of(const MeshExport& wanted) const;

  /// These surfaces as one mesh; a single one that stays as it is is that mesh itself.
  std::shared_ptr<const PolyMesh> exported_mesh(const MeshExport& wanted) const;

  /// By how much coordinates are multiplied on the way out, for the unit.
  double export_scale(const MeshExport& wanted) const;

  /// These surfaces as one file, in the format of the name's extension.
  /// @return what the format can't hold
  Findings export_solid(const QString& path, const MeshExport& wanted = {}) const;

  /// The operations whose results are files of their own and stand in no view.
  std::vector<const OperationDescription*> exports() const;

  /// What one of these makes of a value of the active object's chain: its attribute network, say.
  /// @return what the operation warns of
  Findings export_result(const OperationDescription& operation, const QString& path) const;

  /// Whether there is such a value, computed to the end.
  bool can_export(const OperationDescription& operation) const;

  /// The active object's faces as they are, of solids made from a drawing in perspective; null while it isn't finished,
  /// and of other objects.
  std::shared_ptr<const Brep> exact_solid() const;

  /// Begins to write it as STEP, in the drawing's unit; step_export() tells the end.
  /// @throws Error (E_EMPTY) without one
  void export_step(const QString& path);
  StepExport& step_export() { return step_export_; }
  const StepExport& step_export() const { return step_export_; }

  /// The drawing as SVG.
  void export_drawing(const QString& path) const;

  QStringList recent() const;

  /// Work that a crash left behind.
  std::vector<RecoveryOffer> recoverable() const;
  void recover(const RecoveryOffer& offer);
  void discard(const RecoveryOffer& offer);

  /// Discards all of it. What can't be removed stays in the list.
  void discard_all();

  /// The program ends normally: nothing to recover.
  void close_cleanly();

  /// The working copy is up to date when this returns.
  void autosave_now();

 signals:
  void path_changed(const QString& path);
  void opened(const QString& path, const croquis::Findings& warnings);
  void open_failed(const QString& path, const croquis::Findings& findings);

  /// The working copy can't be written; the work in the window is whole.
  void autosave_failed(const QString& sentence);

 private:
  std::optional<Camera> camera_of(const WorkObject& object) const;
  void take(const ReadFile& file);
  void take_project(const QString& path, const Document& document, const KeptResults& kept);
  void note_damage(const QString& path, const Findings& findings);
  void follow_session();
  void forget_work();
  void autosave();
  std::vector<render::Shown<render::MeshItem>> shown_items() const;
  void set_path(const QString& path);
  void remember(const QString& path);
  std::vector<std::uint8_t> thumbnail_of(const std::vector<render::Shown<render::MeshItem>>& items) const;

  Studio& studio_;
  FileReader reader_;
  StepExport step_export_;
  OffscreenPictures& pictures_;
  std::function<std::vector<render::Shown<render::MeshItem>>()> items_;
  QString state_folder_;
  QString path_;
  std::pair<QDateTime, qint64> known_file_;  ///< time and size of the project's file when it was read or written here
  QString earlier_version_;                  ///< that was opened instead of the project
  std::optional<ProjectLock> lock_;          ///< of the project that is open, unless others have it
  ReadFindings warnings_;
  QSet<QString> replacing_;  ///< meshes under way that take the place of what is open
  bool has_replaced_ = false;
  bool has_traced_ = false;
  QSet<QString> damaged_;  ///< projects found so, by whole path
  bool touched_ = false;   ///< what is open was worked on since it was opened or saved
  QTimer autosave_timer_;
  QElapsedTimer since_thumbnail_;
  KeptResults autosaved_results_;
  Document autosaved_;
  bool has_thumbnail_ = false;                 ///< the working copy shows its solid
  std::unique_ptr<WorkingCopy> working_copy_;  ///< the disk's thread's while that one is busy
  QThreadPool disk_;  ///< one thread: commits wait for the disk, and pictures; the window doesn't
};

}  // namespace croquis::app

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDateTime>
#include <QObject>
#include <QSet>
#include <QStringList>
#include <optional>
#include <utility>
#include <vector>

#include "app/files/file_reader.h"
#include "app/files/mesh_export.h"
#include "app/files/work_keeper.h"
#include "app/start/start_page.h"
#include "app/studio/studio.h"
#include "croquis/io/project_lock.h"
#include "croquis/workspace/read_findings.h"

namespace croquis::app {

/// Everything between the studio and the files that are open: projects, sketches, recent files, and what a crash left
/// behind. Asks nothing and shows nothing; failures are thrown as Error.
class ProjectFiles : public QObject {
  Q_OBJECT

 public:
  /// @param state_folder where working copies lie
  ProjectFiles(Studio& studio, OffscreenPictures& pictures, const QString& state_folder);

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

  /// The mesh that was opened last took the place of what was open.
  bool has_replaced() const { return has_replaced_; }

  /// Of the picture that was opened last the lines were traced.
  bool has_traced() const { return has_traced_; }

  /// What reads them.
  FileReader& reader() { return reader_; }

  /// What keeps the working copy.
  WorkKeeper& keeper() { return keeper_; }

  /// Keeps up to three older versions beside the file; a damaged one under a name of its own.
  /// @return where the damaged one is now, or nothing
  QString save(const QString& path);

  /// What writes STEP files.
  StepExport& step_export() { return step_export_; }

  /// Work that a crash left behind.
  std::vector<RecoveryOffer> recoverable() const;
  void recover(const RecoveryOffer& offer);

 signals:
  void path_changed(const QString& path);
  void opened(const QString& path, const croquis::Findings& warnings);
  void open_failed(const QString& path, const croquis::Findings& findings);

 private:
  void take(const ReadFile& file);
  void note_damage(const QString& path, const Findings& findings);
  void set_path(const QString& path, const QString& earlier_version = {});

  Studio& studio_;
  FileReader reader_;
  StepExport step_export_;
  WorkKeeper keeper_;
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
};

/// Opens a file as ProjectFiles::begin_open does, and waits, keeping the window alive. @throws Error, Cancelled
void open_now(ProjectFiles& files, const QString& path, bool replaces = false, PictureUse use = PictureUse::Backdrop);

/// Files that were opened or saved and are still there, the last one first.
QStringList recent_files();

/// The project's name with the next number that no file has: of name.croq name_001.croq, of name_007.croq
/// name_008.croq.
QString next_increment(const QString& path);

/// Removes work that a crash left behind. @throws Error where it can't be removed: then it stays in the list
void discard(const RecoveryOffer& offer);

}  // namespace croquis::app

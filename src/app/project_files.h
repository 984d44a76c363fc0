// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QStringList>
#include <QThreadPool>
#include <QTimer>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "app/file_reader.h"
#include "app/offscreen_pictures.h"
#include "app/start_page.h"
#include "app/studio.h"
#include "croquis/io/recovery.h"

namespace croquis::app {

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

  void start_sketch();
  /// A sketch or cage that ships inside the program.
  void start_sample(const QString& name);

  /// Begins to open a project (.croq), a sketch (.svg) or a mesh; `opened` or `open_failed` follows. Meshes are added
  /// to what is open.
  void begin_open(const QString& path) { reader_.read(path); }

  /// The same, and waits, keeping the window alive. @throws Error, Cancelled
  void open(const QString& path);

  /// What reads them.
  FileReader& reader() { return reader_; }
  const FileReader& reader() const { return reader_; }

  /// Where pictures of what is shown come from: items made ready anyway.
  void set_items(std::function<std::vector<render::MeshItemPtr>()> items) { items_ = std::move(items); }

  /// Keeps up to three older versions beside the file.
  void save(const QString& path);

  /// The active object's surface as it is shown, in the format that the name tells.
  /// @return what the format can't hold
  Findings export_solid(const QString& path) const;

  /// The drawing as SVG.
  void export_drawing(const QString& path) const;

  QStringList recent() const;

  /// Work that a crash left behind.
  std::vector<RecoveryOffer> recoverable() const;
  void recover(const RecoveryOffer& offer);
  void discard(const RecoveryOffer& offer);

  /// The program ends as people wanted: nothing to recover.
  void close_cleanly();

  /// The working copy is up to date when this returns.
  void autosave_now();

 signals:
  void path_changed(const QString& path);
  void opened(const QString& path);
  void open_failed(const QString& path, const croquis::Findings& findings);

  /// The working copy can't be written; the work in the window is whole.
  void autosave_failed(const QString& sentence);

 private:
  void take(const ReadFile& file);
  void autosave();
  bool drawn_slowly() const;
  void set_path(const QString& path);
  void remember(const QString& path);
  std::vector<std::uint8_t> thumbnail() const;

  Studio& studio_;
  FileReader reader_;
  OffscreenPictures& pictures_;
  std::function<std::vector<render::MeshItemPtr>()> items_;
  QString state_folder_;
  QString path_;
  QTimer autosave_timer_;
  QElapsedTimer since_thumbnail_;
  Document autosaved_;
  bool has_thumbnail_ = false;                 ///< the working copy shows its solid
  std::unique_ptr<WorkingCopy> working_copy_;  ///< the disk's thread's while that one is busy
  QThreadPool disk_;                           ///< one thread: commits wait for the disk, the window doesn't
};

}  // namespace croquis::app

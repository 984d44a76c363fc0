// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QString>
#include <QThreadPool>
#include <QTimer>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "app/studio/studio.h"
#include "app/views/offscreen_pictures.h"
#include "croquis/io/recovery.h"

namespace croquis::app {

/// Keeps a working copy of what is open on the disk, which survives a crash. Lives in the window's thread.
class WorkKeeper : public QObject {
  Q_OBJECT

 public:
  /// @param state_folder where working copies lie
  WorkKeeper(Studio& studio, OffscreenPictures& pictures, const QString& state_folder);
  ~WorkKeeper() override;

  /// Where pictures of what is shown come from: items made ready anyway.
  void set_items(std::function<std::vector<render::Shown<render::MeshItem>>()> items) { items_ = std::move(items); }

  /// The file of what is open; empty for one that was never saved.
  void set_project(const QString& path) { project_ = path; }

  /// What is open was worked on since it was opened or saved.
  bool touched() const { return touched_; }

  /// A small picture of what is shown, as PNG; empty without one.
  std::vector<std::uint8_t> thumbnail() const { return thumbnail_of(shown_items()); }

  /// What is open needs no working copy: it is saved, or not wanted.
  void forget();

  /// The program ends normally: nothing to recover.
  void close_cleanly();

  /// The working copy is up to date when this returns.
  void save_now();

 signals:
  /// The working copy can't be written; the work in the window is whole.
  void failed(const QString& sentence);

 private:
  void follow_session();
  void save();
  std::vector<render::Shown<render::MeshItem>> shown_items() const;
  std::vector<std::uint8_t> thumbnail_of(const std::vector<render::Shown<render::MeshItem>>& items) const;

  Studio& studio_;
  OffscreenPictures& pictures_;
  std::function<std::vector<render::Shown<render::MeshItem>>()> items_;
  QString state_folder_;
  QString project_;
  bool touched_ = false;
  QTimer timer_;
  QElapsedTimer since_thumbnail_;
  KeptResults saved_results_;
  Document saved_;
  std::uint64_t saved_versions_ = 0;           ///< Versions::state
  bool has_thumbnail_ = false;                 ///< the working copy shows its solid
  std::unique_ptr<WorkingCopy> working_copy_;  ///< the disk's thread's while that one is busy
  QThreadPool disk_;  ///< one thread: commits wait for the disk, and pictures; the window doesn't
};

}  // namespace croquis::app

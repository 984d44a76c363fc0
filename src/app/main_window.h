// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFile>
#include <QMainWindow>
#include <functional>
#include <memory>

#include "app/offscreen_pictures.h"
#include "app/project_files.h"
#include "app/studio.h"
#include "croquis/tools/recording.h"

class QLabel;
class QProgressBar;
class QPushButton;
class QStackedWidget;

namespace croquis::app {

class AttributePanel;
class FindingsList;
class GalleryThumbnails;
class HistoryList;
class ObjectList;
class StartPage;
class Viewport;

/// The studio's window: views in the middle, tools left, panels right, the next action in words below.
class MainWindow : public QMainWindow {
  Q_OBJECT

 public:
  /// @param state_folder where working copies lie
  explicit MainWindow(const QString& state_folder);
  ~MainWindow() override;

  Studio& studio() { return studio_; }
  Viewport& viewport() { return *viewport_; }
  ProjectFiles& files() { return files_; }

  /// Leaves the start page with an empty sketch and the pen ready.
  void start_sketch();

  /// Opens a file and leaves the start page; says in the window why it can't.
  bool open(const QString& path);

  /// The action of that name, or null: what menus, keys and replays share.
  QAction* action(const QString& name) const;

  /// Runs something that may throw; shows its findings in a bar over the views.
  bool attempt(const std::function<void()>& work);

  /// Appends everything that is done from now on to a recording (docs/replays.md).
  /// @throws Error (E_WRITE)
  void record_to(const QString& path);

  /// Of the last attempt that failed.
  const Findings& last_findings() const { return last_findings_; }

  bool shows_start_page() const;

  /// Nothing that the window shows is still being made.
  bool settled() const;

  /// Leaves the start page for the document as it is.
  void show_views();

  /// @throws Error
  void export_picture(const QString& path);

 protected:
  void closeEvent(QCloseEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;
  void moveEvent(QMoveEvent* event) override;

 private:
  void make_actions();
  void make_file_actions();
  void make_edit_actions();
  void make_view_actions();
  void make_tool_actions();
  QAction* add_action(QMenu* menu, const QString& name, const QString& text, const QList<QKeySequence>& keys,
                      std::function<void()> work);
  void make_docks();
  void make_help_line();
  void connect_studio();
  void update_panels();
  void update_title();
  void update_help();
  void show_start_page();
  void ask_open();
  bool ask_save();
  bool save_to(const QString& path);
  bool may_discard();
  void ask_export_solid();
  void ask_export_picture();
  void select_strokes(const std::vector<std::string>& strokes);
  void go_to_step(int steps);

  OffscreenPictures pictures_;
  Studio studio_;
  ProjectFiles files_;
  QStackedWidget* pages_ = nullptr;
  StartPage* start_page_ = nullptr;
  Viewport* viewport_ = nullptr;
  AttributePanel* attributes_ = nullptr;
  ObjectList* objects_ = nullptr;
  FindingsList* findings_ = nullptr;
  HistoryList* history_ = nullptr;
  GalleryThumbnails* thumbnails_ = nullptr;
  void record(const recorded::Step& step);

  std::unique_ptr<QFile> recording_;
  std::unique_ptr<recorded::Recorder> recorder_;
  QList<QDockWidget*> docks_;
  bool docks_sized_ = false;  ///< people's own sizes are kept
  Findings last_findings_;
  QLabel* help_ = nullptr;
  QLabel* message_ = nullptr;
  QProgressBar* progress_ = nullptr;
  QPushButton* cancel_ = nullptr;
};

}  // namespace croquis::app

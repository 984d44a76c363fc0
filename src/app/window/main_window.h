// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMainWindow>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/files/project_files.h"
#include "app/studio/studio.h"
#include "app/tools/tool.h"
#include "app/views/offscreen_pictures.h"
#include "app/window/action_list.h"
#include "app/window/stalls.h"
#include "croquis/base/error.h"
#include "croquis/tools/recording/recording.h"

class QStackedWidget;

namespace croquis::app {

class GalleryThumbnails;
class HelpLine;
class PanelDocks;
class StartPage;
class Viewport;

/// What the window consists of. Its pages, panels, menus and questions about files are functions of it.
struct WindowParts {
  /// @param state_folder where working copies lie
  explicit WindowParts(const QString& state_folder) : files(studio, pictures, state_folder) {}

  StallWatch stalls;
  OffscreenPictures pictures;
  Studio studio;
  ProjectFiles files;
  QStackedWidget* pages = nullptr;  ///< the start page, and the views
  StartPage* start_page = nullptr;
  Viewport* viewport = nullptr;
  GalleryThumbnails* thumbnails = nullptr;
  HelpLine* help = nullptr;
  PanelDocks* docks = nullptr;
  std::function<void()> show_panels;  ///< lets the panels follow the studio
  std::unique_ptr<ActionList> actions;
  std::vector<std::unique_ptr<Tool>> tools;
  std::optional<recorded::Recorder> recorder;
  std::deque<recorded::Step> steps;  ///< the newest ones of what was done since a document was opened
  Findings last_findings;            ///< the last errors that were shown
  bool unattended = false;           ///< changes are discarded without a question
  std::string export_unit;           ///< of exported meshes; empty: as in the document
  QString folder;                    ///< that people last opened a file of, or wrote one to
  bool has_shown_views = false;      ///< there is a document behind the start page
  QByteArray views_layout;           ///< QMainWindow::saveState when the views were last left
  bool panels_sized = false;         ///< people's own sizes are kept
  bool keeps_layout = false;         ///< for the next time
};

/// The studio's window: views in the middle, tools left, panels right, the next action in words below.
class MainWindow : public QMainWindow, public ToolHost {
  Q_OBJECT

 public:
  /// @param state_folder where working copies lie
  explicit MainWindow(const QString& state_folder);
  ~MainWindow() override;

  WindowParts& parts() { return parts_; }
  Studio& studio() override { return parts_.studio; }
  Viewport& viewport() override { return *parts_.viewport; }
  OffscreenPictures& pictures() override { return parts_.pictures; }
  ProjectFiles& files() { return parts_.files; }
  const std::vector<std::unique_ptr<Tool>>& tools() const override { return parts_.tools; }

  /// The tool of that type.
  template <class T>
  T& tool() {
    for (const auto& tool : tools()) {
      if (auto* wanted = qobject_cast<T*>(tool.get())) return *wanted;
    }
    throw Error(make_error(Category::Internal, "E_INTERNAL", "The window has no such tool."));
  }

  QAction* action(const QString& name) const override { return parts_.actions->find(name); }
  bool attempt(const std::function<void()>& work) override;
  void say(const QString& sentence) override;
  void show_message(const Findings& findings) override;
  void wait_until_settled() override;
  void open_file(const QString& path) override { parts_.files.begin_open(path); }
  bool start_with(Document document = {}) override;
  void record(const recorded::Step& step) override;
  void refresh() override;

  /// Opens a file, waits for it and leaves the start page; shows in the window why it can't.
  bool open(const QString& path);

  /// Appends everything that is done from now on to a recording (docs/replays.md).
  /// @throws Error (E_WRITE)
  void record_to(const QString& path);

  /// Changes are discarded without a question (replays).
  void set_unattended() { parts_.unattended = true; }

  /// Of the last attempt that failed.
  const Findings& last_findings() const { return parts_.last_findings; }

  /// Nothing that the window shows is still being made.
  bool settled();

 signals:
  /// Something was done that recordings have, or would have.
  void step_recorded(const croquis::recorded::Step& step);

 protected:
  bool event(QEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;
  QMenu* createPopupMenu() override;

 private:
  WindowParts parts_;
};

// ---- The start page and the views, which share the middle of the window

/// What is open stays behind it; where it is shown already, the views come back.
void show_start_page(MainWindow& window);

/// What was open is as it was, the views included.
void leave_start_page(MainWindow& window);

/// Leaves the start page for the document as it is.
void show_views(MainWindow& window);

/// The same for a document that was just opened: the current tool is always one that works on it.
void show_opened(MainWindow& window);

/// Size, panels and views as they were when the window was last closed; from now on they are kept.
void remember_layout(MainWindow& window);

/// As it was at first. @param first QMainWindow::saveState of then
void reset_layout(MainWindow& window, const QByteArray& first);

// ---- Menus and panels

/// The list of actions, with the menus in front of those of the tools.
void add_actions(MainWindow& window);
void add_file_menu(MainWindow& window);

/// The menus behind those of the tools. After all panels have been added.
void add_last_menus(MainWindow& window);

/// What can be done now.
void enable_actions(MainWindow& window);

/// The cameras of the scene, in the order of their objects, beside the other views.
void show_cameras(MainWindow& window);

/// Adds the panels for objects, attributes and findings. @return lets them show what there is now
std::function<void()> add_panels(MainWindow& window);

/// Selects objects, or steps of their chains.
void select_nodes(Studio& studio, const std::vector<NodeId>& nodes);

/// Selects a step of a chain and puts the keyboard into the field of one of its parameters.
void show_parameter(MainWindow& window, NodeId step, const std::string& parameter);

/// Shows what a finding is about, in the views or in a report of its own.
void show_finding(MainWindow& window, const NodeFinding& found);

/// Below the views, the first one in full. @param path of the file that they are about
void show_findings(WindowParts& parts, const Findings& findings, const QString& path = {});

// ---- Files

/// What was opened is shown and recorded, and what failed is said.
void follow_files(MainWindow& window);

void ask_open(MainWindow& window);

/// Begins to open files, one after the other: the window goes on working. Where meshes would be added to what is open
/// it asks whether to; of pictures it asks what becomes of them.
void begin_open(MainWindow& window, const QStringList& paths);

/// Begins to add meshes and pictures to what is open.
void import_files(MainWindow& window, const QStringList& paths);

/// Asks whether changes are to be saved, and saves them. @return false: what is open has to stay
bool may_discard(MainWindow& window);

/// All findings about a file are shown; what a damaged project lost, and where earlier versions are, in full.
void report_opening(MainWindow& window, const QString& path, const Findings& findings);
void show_opening_report(MainWindow& window, const QString& path, const Findings& findings);

}  // namespace croquis::app

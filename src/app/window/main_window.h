// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QFile>
#include <QMainWindow>
#include <QPointer>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/files/mesh_export.h"
#include "app/files/project_files.h"
#include "app/studio/studio.h"
#include "app/tools/tool.h"
#include "app/views/offscreen_pictures.h"
#include "app/window/action_list.h"
#include "app/window/step_actions.h"
#include "croquis/base/error.h"
#include "croquis/tools/recording/recording.h"

class QProgressBar;
class QPushButton;
class QStackedWidget;

namespace croquis::app {

class AttributePanel;
class FindingsList;
class GalleryThumbnails;
class HelpLine;
class HistoryList;
class ObjectList;
class OpeningReport;
class PanelDocks;
class PlacementFields;
class StartPage;
class Viewport;

/// The studio's window: views in the middle, tools left, panels right, the next action in words below.
class MainWindow : public QMainWindow, public ToolHost {
  Q_OBJECT

 public:
  /// @param state_folder where working copies lie
  explicit MainWindow(const QString& state_folder);
  ~MainWindow() override;

  Studio& studio() override { return studio_; }
  Viewport& viewport() override { return *viewport_; }
  const std::vector<std::unique_ptr<Tool>>& tools() const { return tools_; }

  /// The tool of that type.
  template <class T>
  T& tool() {
    for (const auto& tool : tools_) {
      if (auto* wanted = qobject_cast<T*>(tool.get())) return *wanted;
    }
    throw Error(make_error(Category::Internal, "E_INTERNAL", "The window has no such tool."));
  }
  ProjectFiles& files() { return files_; }

  /// Leaves the start page with an empty sketch and the pen ready.
  void start_sketch() override;
  bool start_with(Document document) override;
  void open_file(const QString& path) override { files_.begin_open(path); }

  void wait_until_settled() override;

  /// Opens a file, waits for it and leaves the start page; shows in the window why it can't.
  bool open(const QString& path);

  /// Begins to open files, one after the other: the window goes on working. Where meshes would be added to what is open
  /// it asks whether to; of pictures it asks what becomes of them.
  void begin_open(const QStringList& paths);

  /// Begins to add meshes and pictures to what is open.
  void import(const QStringList& paths);

  /// The action of that name, or null: what menus, keys and replays share.
  QAction* action(const QString& name) const override;

  /// Runs something that may throw; shows its findings in a bar over the views.
  bool attempt(const std::function<void()>& work) override;

  /// Appends everything that is done from now on to a recording (docs/replays.md).
  /// @throws Error (E_WRITE)
  void record_to(const QString& path);

  /// Changes are discarded without a question (replays).
  void set_unattended() { unattended_ = true; }

  /// Of the last attempt that failed.
  const Findings& last_findings() const { return last_findings_; }

  bool shows_start_page() const;
  bool shows_views() const override { return !shows_start_page(); }

  void set_mode(const QString& mode) override;
  void add_status_widget(QWidget& widget) override;
  bool pick(ComponentKind kind, const std::vector<Index>& elements) override;
  bool picks_elements() const override;
  void say(const QString& sentence) override;
  void show_message(const Findings& findings) override { show_message(findings, {}); }
  void record(const recorded::Step& step) override;
  void refresh() override { update_panels(); }
  QString offer() const override;

  /// Nothing that the window shows is still being made.
  bool settled() const;

  /// Selects faces by the names of their sets; of a mesh that isn't computed also one by one, to be worked on.
  /// @throws Error (E_INPUT) when the object has no such set
  void select_face_sets(NodeId node, const std::vector<std::string>& names) override;

  /// Selects objects, or steps of their chains.
  void select_nodes(const std::vector<NodeId>& nodes);

  /// Leaves the start page for the document as it is.
  void show_views();

  /// Size, panels and views as they were when the window was last closed; from now on they are kept.
  void remember_layout();

  /// @throws Error
  void export_picture(const QString& path);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void closeEvent(QCloseEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;
  void moveEvent(QMoveEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  QMenu* createPopupMenu() override;

 private:
  void make_actions();
  void make_file_actions();
  void make_mesh_exports(QMenu* menu);
  void make_edit_actions();
  void make_view_actions();
  void make_tools();
  void make_window_actions();
  void make_help_actions();
  QString diagnostics();
  void gate_document_actions();
  void make_docks();
  void connect_files();
  void connect_start_page();
  void connect_panels();
  void connect_viewport();
  void make_help_line();
  void connect_studio();
  void show_message(const Findings& findings, const QString& path);  ///< the first one, below the views
  void show_findings();
  void report_opening(const QString& path, const Findings& findings);
  void show_opening_report(const QString& path, const Findings& findings);
  QString status() const;
  void update_panels();
  void stop_computing();
  void update_title();
  void update_help();
  void show_start_page();
  void leave_start_page();
  void enter_views();
  void size_panels();
  void place_bars();
  void hold_usable_tool();
  void reset_layout();
  void keep_window_layout();
  void show_cameras();
  void look_through_camera(int place);
  void ask_open();
  std::optional<bool> ask_replace(const QStringList& paths);
  bool ask_save();
  bool save_to(const QString& path);
  bool may_discard();
  bool may_replace(const QString& path);
  QString proposed_path(const QString& file) const;  ///< where people last opened or wrote something
  void ask_export_meshes(MeshExport::Objects objects);
  std::optional<ExportCheck> checked_for_export(const MeshExport& wanted);
  void show_doubt(const ExportCheck& check, const MeshExport& wanted);
  static QString export_action(const OperationDescription& operation);
  QString asked_path(const QString& title, const QString& ending, const QString& filter);
  void ask_export_result(const OperationDescription& operation);
  void ask_export_step();
  void ask_export_picture();
  void ask_export_drawing();
  void say_written(const QString& path, const Findings& lost = {}, const QString& summary = {});
  void select_all();
  void delete_selection();
  void select_none();
  void choose_nodes(const std::vector<NodeId>& nodes);
  void choose_step(NodeId step);
  std::vector<ObjectRow> rows_of(const WorkObject& object, NodeId node) const;
  QString owner_of(const NodeFinding& found) const;  ///< the object it is about, where there are several; else empty
  void show_finding(const NodeFinding& finding);
  void show_progress(bool busy);
  void go_to_step(int steps);

  OffscreenPictures pictures_;
  Studio studio_;
  ProjectFiles files_;
  QStackedWidget* pages_ = nullptr;
  std::unique_ptr<ActionList> actions_;
  std::unique_ptr<StepActions> step_actions_;
  StartPage* start_page_ = nullptr;
  Viewport* viewport_ = nullptr;
  std::vector<std::unique_ptr<Tool>> tools_;
  AttributePanel* attributes_ = nullptr;
  PlacementFields* placement_ = nullptr;
  ObjectList* objects_ = nullptr;
  FindingsList* findings_ = nullptr;
  HistoryList* history_ = nullptr;
  GalleryThumbnails* thumbnails_ = nullptr;
  std::unique_ptr<QFile> recording_;
  std::unique_ptr<recorded::Recorder> recorder_;
  QList<QDockWidget*> docks_;
  bool unattended_ = false;
  bool docks_sized_ = false;  ///< people's own sizes are kept
  bool remembers_layout_ = false;
  bool has_shown_views_ = false;  ///< there is a document behind the start page
  QByteArray first_layout_;       ///< of the panels, for resetting
  QByteArray views_layout_;       ///< of the panels, when the views were last left
  PanelDocks* panels_ = nullptr;
  QPointer<OpeningReport> report_;
  Findings last_findings_;
  std::string export_unit_;  ///< of exported meshes; empty: as in the document
  QString folder_;           ///< that people last opened a file of, or wrote one to
  HelpLine* help_ = nullptr;
  QProgressBar* progress_ = nullptr;
  QElapsedTimer since_progress_;  ///< was last shown
  QPushButton* cancel_ = nullptr;
};

}  // namespace croquis::app

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFile>
#include <QMainWindow>
#include <QPointer>
#include <functional>
#include <map>
#include <memory>

#include "app/files/project_files.h"
#include "app/studio/scene_scale.h"
#include "app/studio/studio.h"
#include "app/views/offscreen_pictures.h"
#include "croquis/tools/mesh/mesh_tool.h"
#include "croquis/tools/recording/recording.h"

class QProgressBar;
class QPushButton;
class QStackedWidget;

namespace croquis::app {

class AttributePanel;
class ChainTable;
class CreaseSetPanel;
class FindingsList;
class GalleryThumbnails;
class HelpLine;
class HistoryList;
class HoleInteraction;
class HolePanel;
class ObjectList;
class OpeningReport;
class PanelDocks;
class StartPage;
class TagPanel;
class Viewport;
enum class ToolKind;

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

  /// Opens a file, waits for it and leaves the start page; shows in the window why it can't.
  bool open(const QString& path);

  /// Begins to open files, one after the other: the window goes on working. Meshes are added to what is open.
  void begin_open(const QStringList& paths);

  /// The action of that name, or null: what menus, keys and replays share.
  QAction* action(const QString& name) const;

  /// Runs something that may throw; shows its findings in a bar over the views.
  bool attempt(const std::function<void()>& work);

  /// Appends everything that is done from now on to a recording (docs/replays.md).
  /// @throws Error (E_WRITE)
  void record_to(const QString& path);

  /// Changes are discarded without a question (replays).
  void set_unattended() { unattended_ = true; }

  /// Of the last attempt that failed.
  const Findings& last_findings() const { return last_findings_; }

  bool shows_start_page() const;

  /// Nothing that the window shows is still being made.
  bool settled() const;

  /// Selects faces by the names of their sets; of a mesh that isn't computed also one by one, to be worked on.
  /// @throws Error (E_INPUT) when the object has no such set
  void select_face_sets(NodeId node, const std::vector<std::string>& names);

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
  /// Who writes an action into recordings.
  enum class Recorded {
    AsAction,  ///< by its name
    ByItself   ///< by the code that acts: with a file's name, with elements
  };

  void make_actions();
  void make_file_actions();
  void make_edit_actions();
  void make_view_actions();
  void make_tool_actions();
  QAction* add_action(QMenu* menu, const QString& name, const QString& text, const QList<QKeySequence>& keys,
                      std::function<void()> work, Recorded recorded = Recorded::AsAction);
  void make_mesh_actions();
  void make_mode_actions();
  void make_selection_actions();
  void make_shape_actions();
  void make_tag_actions();
  void make_scale_actions();
  void offer_scale();  ///< beside the help line, where what has been added is far larger or smaller than the rest
  void follow_scale();
  void make_smoothing_actions();
  void make_marking_menu();
  QAction* add_mesh_action(QMenu* menu, const QString& name, const QString& text, const QList<QKeySequence>& keys,
                           std::function<Verdict(MeshTool&)> work);
  void set_mesh_mode(MeshMode mode);
  void update_mesh_actions();
  void make_window_actions();
  void gate_document_actions();
  void make_hole_actions();
  void make_hole_dock();
  QAction* add_hole_action(QMenu* menu, const QString& name, const QString& text, const QList<QKeySequence>& keys,
                           std::function<void(HoleInteraction&)> work, bool tells_itself = false);
  void update_hole_actions();
  void frame_holes();
  bool show_hole_finding(const NodeFinding& finding);  ///< @return whether it is about holes
  void tell(const QString& sentence);                  ///< below the views
  void make_docks();
  void connect_files();
  void connect_start_page();
  void connect_panels();
  void connect_viewport();
  void make_help_line();
  void connect_studio();
  void show_message(const Findings& findings, const QString& path = {});  ///< the first one, below the views
  void show_findings();
  void report_opening(const QString& path, const Findings& findings);
  void show_opening_report(const QString& path, const Findings& findings);
  void update_panels();
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
  void ask_open();
  bool ask_save();
  bool save_to(const QString& path);
  bool may_discard();
  bool may_replace(const QString& path);
  QString proposed_path(const QString& file) const;  ///< where people last opened or wrote something
  void ask_export_solid();
  void ask_export_picture();
  void ask_export_drawing();
  void tell_written(const QString& path, const Findings& lost = {});
  void select_all();
  void delete_selection();
  void select_none();
  void select_strokes(const std::vector<std::string>& strokes);
  void select_objects(const std::vector<NodeId>& nodes);
  void show_finding(const NodeFinding& finding);
  void select_chain(int chain);
  void show_progress(bool busy);
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
  TagPanel* tags_ = nullptr;
  ChainTable* chains_ = nullptr;
  CreaseSetPanel* sets_ = nullptr;
  GalleryThumbnails* thumbnails_ = nullptr;
  SceneScale scale_ = SceneScale(studio_);
  QPushButton* scale_offer_ = nullptr;
  std::size_t scale_offered_at_ = 0;  ///< steps of the history when it was; another step takes the offer back
  NodeId scale_offered_ = 0;          ///< the object that was added
  QMenu* mesh_menu_ = nullptr;
  QToolBar* mesh_bar_ = nullptr;
  QList<QAction*> mesh_actions_;  ///< that need a mesh to work on
  std::map<MeshMode, QAction*> mode_actions_;
  std::map<ToolKind, QAction*> tool_actions_;
  void record(const recorded::Step& step);

  std::unique_ptr<QFile> recording_;
  std::unique_ptr<recorded::Recorder> recorder_;
  QList<QDockWidget*> docks_;
  QDockWidget* edges_dock_ = nullptr;  ///< of meshes alone
  QDockWidget* sets_dock_ = nullptr;
  QDockWidget* holes_dock_ = nullptr;  ///< while holes are worked on
  HolePanel* holes_panel_ = nullptr;
  QList<QAction*> hole_actions_;  ///< that need holes to work on
  bool unattended_ = false;
  bool docks_sized_ = false;  ///< people's own sizes are kept
  bool holes_sized_ = false;
  bool remembers_layout_ = false;
  bool has_shown_views_ = false;  ///< there is a document behind the start page
  QByteArray first_layout_;       ///< of the panels, for resetting
  QByteArray views_layout_;       ///< of the panels, when the views were last left
  PanelDocks* panels_ = nullptr;
  QPointer<OpeningReport> report_;
  Findings last_findings_;
  QString folder_;  ///< that people last opened a file of, or wrote one to
  HelpLine* help_ = nullptr;
  QProgressBar* progress_ = nullptr;
  QPushButton* cancel_ = nullptr;
};

}  // namespace croquis::app

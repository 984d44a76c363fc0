// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QString>
#include <QStringList>
#include <QTimer>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "app/panels/finding_elements.h"
#include "app/panels/object_names.h"
#include "app/replay/replays.h"
#include "app/studio/studio.h"
#include "app/views/object_scenes.h"
#include "app/views/view_chips.h"
#include "app/views/view_pane.h"
#include "croquis/geometry/component_kind.h"
#include "croquis/render/scene.h"
#include "croquis/tools/pointer/pen.h"
#include "croquis/tools/pointer/pointer_event.h"
#include "croquis/tools/recording/recording.h"
#include "croquis/tools/recording/step.h"

class QAction;
class QWidget;

namespace croquis::app {

class OffscreenPictures;
class Tool;
class Viewport;
class Views;

/// The window, as its tools know it.
class ToolHost {
 public:
  virtual ~ToolHost() = default;

  virtual Studio& studio() = 0;
  virtual Viewport& viewport() = 0;
  virtual OffscreenPictures& pictures() = 0;

  /// What they show.
  Views& views();

  /// In the order of their menus and buttons.
  virtual const std::vector<std::unique_ptr<Tool>>& tools() const = 0;

  /// The action of that name, or null: what menus, keys and replays share.
  virtual QAction* action(const QString& name) const = 0;

  /// Runs something that may throw; shows its findings below the views.
  virtual bool attempt(const std::function<void()>& work) = 0;

  virtual void say(const QString& sentence) = 0;  ///< below the views; empty: nothing more
  virtual void show_message(const Findings& findings) = 0;

  /// Waits until what is shown is finished, as replays do. @throws Error (E_LIMIT)
  virtual void wait_until_settled() = 0;

  /// Begins to open a file as File > Open does.
  virtual void open_file(const QString& path) = 0;

  /// Another document in the views, where people don't keep theirs; an empty sketch where none is given.
  /// @return false: they do
  virtual bool start_with(Document document = {}) = 0;

  /// Appends a step to the recording, when one is made.
  virtual void record(const recorded::Step& step) = 0;

  /// Panels, actions and the help line show what is there now.
  virtual void refresh() = 0;

  /// What the pointer does: the id of a tool's mode.
  void set_mode(const QString& mode);

  /// The views are there, not the start page.
  bool shows_views();

  /// Beside the help line.
  void add_status_widget(QWidget& widget);
};

/// Selects elements of the active object's mesh, in the mode for them. @return false where no tool can
bool pick(const ToolHost& host, ComponentKind kind, const std::vector<Index>& elements);

/// What the pointer picks are elements of a mesh, not objects.
bool picks_elements(const ToolHost& host);

/// Selects faces by the names of their sets; of a mesh that isn't computed also one by one, to be worked on.
/// @throws Error (E_INPUT) when the object has no such set
void select_face_sets(ToolHost& host, NodeId node, const std::vector<std::string>& names);

/// What the tools offer for the active object, in words and keys; of the first that offers something.
QString offer(const ToolHost& host);

class ActionList;
class PanelDocks;

/// The mode in which the pointer selects. Every tool with something to select knows it.
inline const QString select_mode = QStringLiteral("select");
/// The mode that the studio starts with.
inline const QString first_mode = QStringLiteral("draw");

/// A pen stroke under way, which is drawn without delay, and its view.
struct Ink {
  int view = 0;
  const std::vector<StrokeSample>* samples = nullptr;
  bool pale = false;  ///< it will lie behind what is drawn
};

/// What a view is to show of what is selected.
struct SelectionFrame {
  render::Bounds bounds;
  std::optional<Vec3> facing;  ///< unit; the view turns to look at it from the front
  bool stays = true;           ///< the view isn't framed by itself any more
};

/// What keys and menus ask of the tools: the Edit menu, Enter, and Cancel once computing was stopped.
enum class EditCommand { SelectAll, SelectNone, Delete, Accept, Cancel };

/// What tools follow: another document or selection, results, surfaces that have been made ready, a file that was
/// opened.
enum class Change { Document, Result, Scenes, Opened };

/// What a view is for a tool.
struct ViewUse {
  bool works = false;          ///< pointer events of the view are for this tool; of several, for the first one
  bool on_drawings = true;     ///< also where a tool has something of its own
  QStringList menu = {};       ///< names of the actions around the pointer, clockwise from above; none: no marking menu
  render::Bounds bounds = {};  ///< of what the tool adds to a view that is its own
  Qt::CursorShape cursor = Qt::ArrowCursor;
  bool every_move = false;  ///< the tool takes moves that came late, too
  bool paper = false;       ///< drawn as a sheet of paper
  QString title = {};
};

/// What a tool says to people.
struct ToolWords {
  QString help = {};     ///< the next action, in words and keys
  QString tooltip = {};  ///< about what is under the pointer
  QString status = {};   ///< about the active object, at the end of the help line
};

/// Where the pointer is, in the pixels of its view.
struct PointerPlace {
  int view = 0;
  Vec2 pixel = Vec2::Zero();
};

/// How a tool stands.
struct ToolState {
  bool has_selection = false;
  bool picks_elements = false;  ///< what the pointer picks are elements of a mesh
  bool busy = false;            ///< something that it shows is still being made
  std::optional<Ink> ink = {};
  QString beside_pointer = {};  ///< what a drag has done, or the number of what is there
};

/// Parts of a node, as the list of objects names them.
struct ChosenParts {
  NodeId node = 0;
  std::vector<std::string> parts;
};

/// Faces of the active object that were selected by the names of their sets.
using ChosenFaceSets = std::vector<const FaceSet*>;

/// What was chosen elsewhere, in a list or by another tool, and is to be shown: a step of a chain, which is selected
/// and whose tool opens; what a finding is about; elements; parts; sets of faces.
using Target = std::variant<const Node*, NodeFinding, PickedElements, ChosenParts, ChosenFaceSets>;

/// Keys over the views of a tool, before they are a menu's shortcuts: Qt::Key, without modifiers.
struct ToolKeys {
  std::map<int, std::function<void()>> pressed = {};
  int marking_menu = 0;  ///< opens the marking menu while it is held, over a view that has one; 0: none
};

/// All views, as Tool::changed names them, and none of them: the ink over them alone.
constexpr int every_view = -1;
constexpr int ink_alone = -2;

/// A way of working, with all that the window has of it: nothing else in the window knows it by name. One folder in
/// app/tools and one line in all_tools.cpp each. Everything has a default: a tool says what it has.
class Tool : public QObject {
  Q_OBJECT

 public:
  const QString help_topic;  ///< the heading of the manual that is about it; none for the help in general
  ToolKeys keys;
  PointerPlace pointer;

  explicit Tool(ToolHost& host, const QString& about = {});

  /// Its menus, keys and buttons. Called once, in the order of the tools.
  virtual void make_actions(ActionList&) {}
  virtual void make_panels(PanelDocks&) {}

  /// What replays can do with it, clicks and boxes too, and what they can ask of it. Called once.
  virtual void make_replays(Replays&) {}

  /// After the document, a result, the selection or a mode has changed: which actions are enabled and checked, what
  /// panels show.
  virtual void refresh() {}

  virtual void set_mode(const QString& mode) { mode_ = mode; }
  virtual void follow(Change) {}

  // ---- How it stands
  virtual ViewUse use_of(int) const { return {}; }  ///< also of a view that it doesn't work in
  virtual ToolWords words() const { return {}; }
  virtual ToolState state() const { return {}; }
  virtual QString offer() const { return {}; }  ///< what it could do with the active object

  // ---- The pointer
  virtual void take(const PointerEvent& event);  ///< its place in pixels of its view
  bool down() const { return input_.down(); }    ///< a gesture is under way
  virtual bool abandon();                        ///< gives it up. @return false when there was none

  virtual bool command(EditCommand) { return false; }  ///< @return false: it isn't this tool's
  virtual void add_all_to(Selection&) const {}         ///< what Select all selects beside meshes

  /// @return false: it isn't this tool's. @throws Error
  virtual bool show(const Target&) { return false; }

  // ---- The views
  virtual void adjust(ObjectScenes::Wanted&, int) const {}  ///< which surfaces a view shows
  virtual void add_to(render::Scene&, int) {}
  virtual std::optional<SelectionFrame> selection_frame(int) const { return std::nullopt; }
  virtual void place_chips(ChipPlaces&) {}

  // ---- The lists
  /// What the list of objects shows below a node of an object's chain.
  virtual std::vector<ObjectRow> rows(const WorkObject&, NodeId) { return {}; }

  /// Which part of an object a finding is about; empty where that isn't known or goes without saying.
  virtual QString owner_of(const NodeFinding&) const { return {}; }

 signals:
  void changed(int view = every_view);  ///< what is drawn over the views, or over one
  void state_changed();                 ///< what help, actions or panels show
  void committed(const croquis::recorded::Step& step);

 protected:
  virtual void feed(const std::vector<PenStep>&) {}  ///< what one event became; never empty
  virtual void hover(const PointerEvent&) {}         ///< no gesture is under way, or the pointer leaves the view

  ToolHost& host() const { return host_; }
  Studio& studio() const { return host_.studio(); }

  QString mode_ = first_mode;
  PenInput input_;
  bool drags_leave_views_ = false;  ///< a gesture goes on where the pointer leaves the views

 private:
  ToolHost& host_;
  QTimer watch_;  ///< of a stroke under way: a pen may vanish without an event
  double last_time_ = 0;
  QElapsedTimer since_event_;
};

/// Whether a step is a source of that type, or an operation that works on it.
bool works_on(const Studio& studio, const Node& step, ValueType type);

/// Shows the sketch view, if it isn't shown, beside the perspective view.
void show_sketch_view(Viewport& views);

/// What is selected with what is around it; nothing for an empty box. @param around the least size of what is shown
std::optional<SelectionFrame> frame_around(render::Bounds selected, const glm::dvec3& around);

/// Three or two numbers as "x 1  y 2  z 3".
QString axes_text(Eigen::Ref<const Eigen::VectorXd> vector);
/// How far a drag has come, in the document's unit, and its parts along the axes.
QString way_text(Eigen::Ref<const Eigen::VectorXd> by, const Studio& studio);

/// Sentences of findings, one after the other, each with its full stop.
QString sentences_of(const Findings& findings);

/// The tools of a window, in the order of their menus and buttons; an event goes to the first that works in its view.
std::vector<std::unique_ptr<Tool>> all_tools(ToolHost& host);

}  // namespace croquis::app

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <QStringList>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "app/panels/object_names.h"
#include "app/replay/replays.h"
#include "app/studio/studio.h"
#include "app/views/object_scenes.h"
#include "app/views/view_chips.h"
#include "app/views/view_pane.h"
#include "croquis/geometry/component_kind.h"
#include "croquis/render/scene.h"
#include "croquis/tools/pointer/pointer_event.h"
#include "croquis/tools/recording/recording.h"
#include "croquis/tools/recording/step.h"

class QAction;
class QWidget;

namespace croquis::app {

class Viewport;

/// The window, as its tools know it.
class ToolHost {
 public:
  virtual ~ToolHost() = default;

  virtual Studio& studio() = 0;
  virtual Viewport& viewport() = 0;

  /// The action of that name, or null: what menus, keys and replays share.
  virtual QAction* action(const QString& name) const = 0;

  /// What the pointer does: the id of a tool's mode.
  virtual void set_mode(const QString& mode) = 0;

  /// Runs something that may throw; shows its findings below the views.
  virtual bool attempt(const std::function<void()>& work) = 0;

  /// The views are there, not the start page.
  virtual bool shows_views() const = 0;

  /// Beside the help line.
  virtual void add_status_widget(QWidget& widget) = 0;

  /// Selects elements of the active object's mesh, in the mode for them. @return false where no tool can
  virtual bool pick(ComponentKind kind, const std::vector<Index>& elements) = 0;

  /// What the pointer picks are elements of a mesh, not objects.
  virtual bool picks_elements() const = 0;

  /// Selects faces by the names of their sets. @throws Error (E_INPUT) when the object has no such set
  virtual void select_face_sets(NodeId node, const std::vector<std::string>& names) = 0;

  virtual void tell(const QString& sentence) = 0;
  virtual void show_message(const Findings& findings) = 0;

  /// Waits until what is shown is finished, as replays do. @throws Error (E_LIMIT)
  virtual void wait_until_settled() = 0;

  /// An empty sketch in the views.
  virtual void start_sketch() = 0;

  /// Begins to open a file as File > Open does.
  virtual void open_file(const QString& path) = 0;

  /// Another document in the views, where people don't keep theirs. @return false: they do
  virtual bool start_with(Document document) = 0;

  /// Appends a step to the recording, when one is made.
  virtual void record(const recorded::Step& step) = 0;

  /// Panels, actions and the help line show what is there now.
  virtual void refresh() = 0;

  /// What the tools offer for an object that is selected, in words and keys; of the first that offers something.
  virtual QString offer_for(const WorkObject& object) const = 0;
};

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

/// What a view is while a tool has it.
struct ViewUse {
  Qt::CursorShape cursor = Qt::ArrowCursor;
  bool every_move = false;  ///< the tool takes moves that came late, too
  bool paper = false;       ///< drawn as a sheet of paper
  QString title = {};
};

/// A way of working, with all that the window has of it: nothing else in the window knows it by name. One folder in
/// app/tools and one line in all_tools.cpp each. Everything has a default: a tool says what it has.
class Tool : public QObject {
  Q_OBJECT

 public:
  /// @param help_topic the heading of the manual that is about it; none for the help in general
  explicit Tool(ToolHost& host, QString help_topic = {}) : host_(host), help_topic_(std::move(help_topic)) {}

  const QString& help_topic() const { return help_topic_; }

  // ---- What people can do

  /// Its menus, keys and buttons. Called once, in the order of the tools.
  virtual void make_actions(ActionList&) {}
  virtual void make_panels(PanelDocks&) {}

  /// After the document, a result, the selection or a mode has changed: which actions are enabled and checked, what
  /// panels show.
  virtual void refresh() {}

  /// Names of the actions around the pointer, clockwise from above; none: no marking menu in that view.
  virtual QStringList marking_menu(int) const { return {}; }

  // ---- The hand

  virtual void set_mode(const QString& mode) { mode_ = mode; }

  /// Pointer events of that view are for this tool; of several, for the first one.
  virtual bool works_in(int) const { return false; }
  virtual void take(const PointerEvent&) {}                      ///< its place in pixels of its view
  virtual bool down() const { return false; }                    ///< a gesture is under way
  virtual bool abandon() { return false; }                       ///< gives it up. @return false when there was none
  virtual QString help() const { return {}; }                    ///< the next action, in words and keys
  virtual QString offer(const WorkObject&) const { return {}; }  ///< what it could do with a selected object
  virtual QString tooltip() const { return {}; }                 ///< about what is under the pointer

  virtual bool command(EditCommand) { return false; }  ///< @return false: it isn't this tool's
  virtual bool has_selection() const { return false; }
  virtual void add_all_to(Selection&) const {}  ///< what Select all selects beside meshes
  virtual bool pick(ComponentKind, const std::vector<Index>&) { return false; }  ///< see ToolHost::pick
  virtual bool picks_elements() const { return false; }  ///< what the pointer picks are elements of a mesh

  /// A key over one of its views, before it is a menu's shortcut. @param key Qt::Key, without modifiers
  bool takes_key(int key) const { return keys_.contains(key); }
  void press_key(int key) { keys_.at(key)(); }

  /// The key that opens the marking menu while it is held, over a view that has one; 0: none.
  int marking_key() const { return marking_key_; }

  // ---- The eye

  virtual void adjust(ObjectScenes::Wanted&, int) const {}  ///< which surfaces a view shows
  virtual void add_to(render::Scene&, int) {}
  virtual std::optional<Ink> ink() const { return std::nullopt; }
  virtual render::Bounds bounds_in(int) const { return {}; }  ///< of what it adds to a view that is its own
  virtual std::optional<SelectionFrame> selection_frame(int) const { return std::nullopt; }
  virtual ViewUse use_of(int) const { return {}; }  ///< also of a view that it doesn't work in
  virtual void place_chips(ChipPlaces&) {}
  virtual bool busy() const { return false; }  ///< something that it shows is still being made

  // ---- The flow

  virtual void follow(Change) {}

  /// A step of a chain was chosen, and is selected: the tool that works on such steps opens. @return false: another one
  virtual bool open_step(const Node&) { return false; }

  /// Faces of the active object were selected by the names of their sets.
  virtual void chosen_by_name(const std::vector<const FaceSet*>&) {}

  /// About the active object, at the end of the help line.
  virtual QString status() const { return {}; }

  // ---- The lists

  /// What the list of objects shows below a node of an object's chain.
  virtual std::vector<ObjectRow> rows(const WorkObject&, NodeId) const { return {}; }

  /// Rows with these parts of a node were chosen. @return false: they aren't this tool's. @throws Error
  virtual bool choose_parts(NodeId, const std::vector<std::string>&) { return false; }

  /// Which part of an object a finding is about; empty where that isn't known or needs no telling.
  virtual QString owner_of(const NodeFinding&) const { return {}; }

  // ---- The memory

  /// What replays can do with it, clicks and boxes too, and what they can ask of it. Called once.
  virtual void make_replays(Replays&) {}

  /// Shows what a finding is about. @return false: it isn't this tool's
  virtual bool show_finding(const NodeFinding&) { return false; }

 signals:
  void changed();  ///< what is drawn over the views
  void changed_in(int view);
  void inked();          ///< nothing but the ink
  void state_changed();  ///< what help, actions or panels show
  void committed(const croquis::recorded::Step& step);
  void told(const QString& sentence);

 protected:
  ToolHost& host() const { return host_; }
  Studio& studio() const { return host_.studio(); }
  const QString& mode() const { return mode_; }
  void set_key(int key, std::function<void()> work) { keys_[key] = std::move(work); }
  void set_marking_key(int key) { marking_key_ = key; }

 private:
  ToolHost& host_;
  QString help_topic_;
  std::map<int, std::function<void()>> keys_;
  int marking_key_ = 0;
  QString mode_ = first_mode;
};

/// The tools of a window, in the order of their menus and buttons; an event goes to the first that works in its view.
std::vector<std::unique_ptr<Tool>> all_tools(ToolHost& host);

}  // namespace croquis::app

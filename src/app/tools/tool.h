// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <QStringList>
#include <memory>
#include <optional>
#include <vector>

#include "app/panels/object_row.h"
#include "app/replay/expectations.h"
#include "app/tools/tool_host.h"
#include "app/views/chip_places.h"
#include "app/views/object_scenes.h"
#include "app/views/view_pane.h"
#include "croquis/render/scene.h"
#include "croquis/tools/pointer/pointer_event.h"
#include "croquis/tools/recording/step.h"

namespace croquis::app {

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

/// A way of working, with all that the window has of it: nothing else in the window knows it by name. One folder in
/// app/tools and one line in all_tools.cpp each. Everything has a default: a tool says what it has.
class Tool : public QObject {
  Q_OBJECT

 public:
  explicit Tool(ToolHost& host) : host_(host) {}

  // ---- What people can do

  /// Its menus, keys and buttons. Called once, in the order of the tools.
  virtual void make_actions(ActionList&) {}
  virtual void make_panels(PanelDocks&) {}

  /// After the document, a result, the selection or a mode has changed: which actions are enabled and checked, what
  /// panels show.
  virtual void refresh() {}

  /// Names of the actions around the pointer, clockwise from above; none: no marking menu in that view.
  virtual QStringList marking_menu(int) const { return {}; }

  /// The key that opens the marking menu while it is held, over a view that has one; 0: none.
  virtual int marking_key() const { return 0; }

  // ---- The hand

  virtual void set_mode(const QString& mode) { mode_ = mode; }

  /// Pointer events of that view are for this tool; of several, for the first one.
  virtual bool works_in(int) const { return false; }
  virtual void take(const PointerEvent&) {}                      ///< its place in pixels of its view
  virtual bool needs_every_move() const { return false; }        ///< also those that came late
  virtual bool down() const { return false; }                    ///< a gesture is under way
  virtual bool abandon() { return false; }                       ///< gives it up. @return false when there was none
  virtual QString help() const { return {}; }                    ///< the next action, in words and keys
  virtual QString help_topic() const { return {}; }              ///< the heading of the manual that is about it
  virtual QString offer(const WorkObject&) const { return {}; }  ///< what it could do with a selected object
  virtual QString tooltip() const { return {}; }                 ///< about what is under the pointer
  virtual Qt::CursorShape cursor(int) const { return Qt::ArrowCursor; }

  // What keys of the Edit menu do while this tool works. @return false: it isn't this tool's
  virtual bool select_all() { return false; }
  virtual bool select_none() { return false; }
  virtual bool delete_selection() { return false; }
  virtual bool has_selection() const { return false; }
  virtual void add_all_to(Selection&) const {}  ///< what Select all selects beside meshes
  virtual bool pick(ComponentKind, const std::vector<Index>&) { return false; }  ///< see ToolHost::pick
  virtual bool picks_elements() const { return false; }  ///< what the pointer picks are elements of a mesh
  virtual bool accept() { return false; }                ///< Enter

  /// A key over one of its views, before it is a menu's shortcut. @param key Qt::Key, without modifiers
  virtual bool takes_key(int) const { return false; }
  virtual void press_key(int) {}
  virtual void cancel() {}  ///< after computing was stopped

  // ---- The eye

  virtual void adjust(ObjectScenes::Wanted&, int) const {}  ///< which surfaces a view shows
  virtual void add_to(render::Scene&, int) {}
  virtual std::optional<Ink> ink() const { return std::nullopt; }
  virtual bool is_paper(int) const { return false; }          ///< the view is drawn as a sheet of paper
  virtual render::Bounds bounds_in(int) const { return {}; }  ///< of what it adds to a view that is its own
  virtual std::optional<SelectionFrame> selection_frame(int) const { return std::nullopt; }
  virtual QString view_title(int) const { return {}; }
  virtual void place_chips(ChipPlaces&) {}
  virtual bool busy() const { return false; }  ///< something that it shows is still being made

  // ---- The flow

  virtual void follow_document() {}  ///< or the selection
  virtual void follow_result() {}
  virtual void follow_scenes() {}  ///< surfaces have been made ready
  virtual void opened() {}         ///< a file was opened

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

  /// The kinds of recorded steps that it plays, clicks and boxes too.
  virtual std::vector<const recorded::StepKind*> steps() const { return {}; }

  /// Does a step of one of these kinds. @return false: another tool's. @throws Error (E_REPLAY, E_INPUT …)
  virtual bool replay(const recorded::Step&) { return false; }

  /// As how many objects `expect` counts one; nothing: as one while it is visible.
  virtual std::optional<std::size_t> parts_of(const WorkObject&) const { return std::nullopt; }

  /// What `expect` can ask of it.
  virtual Expectations expectations() { return {}; }

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

 private:
  ToolHost& host_;
  QString mode_ = first_mode;
};

}  // namespace croquis::app

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/tools/background_job.h"
#include "app/tools/holes/hole_overlay.h"
#include "app/tools/holes/hole_plan.h"
#include "app/tools/tool.h"
#include "croquis/tools/holes/hole_steps.h"
#include "croquis/tools/holes/hole_tool.h"
#include "croquis/tools/mesh/mesh_pick.h"

class QMenu;

namespace croquis::app {

class Panel;

/// The holes of the active object as its `fill` operation has found them, with what is selected and previewed. Actions,
/// panel and views are functions of it; all that these change are parameters of the operation.
struct ScanHoles {
  ScanHoles(Tool& tool_of_window, ToolHost& window);

  Studio& studio() const { return host.studio(); }
  const Node* node() const { return filling_node(host.studio()); }  ///< the operation; null where there is none
  bool works() const { return active && node() != nullptr; }

  const std::vector<Index>& selected() const { return tool.selected(); }
  const HoleRow* row(Index hole) const;
  std::vector<Index> filled() const;
  std::shared_ptr<const PolyMesh> scan() const;  ///< whose holes the rows are; null before the first result

  void select(std::vector<Index> holes);

  /// Shows what is there after the document, a result or the selection has changed.
  void follow();
  void follow_selection();

  /// Runs something that may throw; says why it did.
  void attempt(const std::function<void()>& work);

  /// One step of the history, or a part of a drag.
  void edit(const std::string& label, const ParameterValues& values, bool drags);

  Tool& owner;
  ToolHost& host;
  bool active = false;  ///< else nothing of it is shown or computed
  bool tinted = false;  ///< patches by their confidence
  HoleTool tool;
  HoleOverlay overlay;
  PatchPreview preview;
  std::vector<HoleRow> rows;
  std::shared_ptr<const Evaluation> shown;  ///< the result that the rows describe
  NodeId shown_node = 0;
  std::optional<HolePlan> pulled;  ///< before the pull under way
  bool dragging = false;           ///< the session's drag has begun

  // Which holes the scan itself hides in a view.
  std::shared_ptr<const PolyMesh> sight_scan;
  std::shared_ptr<MeshPicker> sight;  ///< of that scan; null until it is made on another thread
  BackgroundJob sight_job;

 private:
  void take_result(const Node* operation);
  void follow_sight();
  void show_patches();
  void show_handles();
};

/// Of these holes those in that state.
std::vector<Index> holes_in_state(const ScanHoles& holes, std::vector<Index> some, FillAction state);

/// Those that a filling of the selected ones would close, with the islands that belong to them.
std::vector<Index> open_of_selected(const ScanHoles& holes);

/// Open holes that aren't borders, up to that diameter.
std::vector<Index> open_up_to(const ScanHoles& holes, double diameter);

// What becomes of holes; each is one step of the history.

void fill_up_to(ScanHoles& holes, double diameter);  ///< what is filled already stays
void reopen_selected(ScanHoles& holes);

// How patches are made: of the selected holes, of all when none is selected.

struct PatchMethod {
  std::string fairness, kernel;
  double bulge = 0;
  int trim_rim = 0;
};
PatchMethod method_of_selected(const ScanHoles& holes);

/// What isn't given stays.
void set_method(ScanHoles& holes, recorded::HoleWay change, bool drags = false);

/// "preset" and "mode": of all holes, what is scanned, and whether patches close it or the model is remeshed.
std::string text_parameter(const ScanHoles& holes, const std::string& name);
void set_preset(ScanHoles& holes, const std::string& preset);
void set_mode(ScanHoles& holes, const std::string& mode);

/// After computing was stopped: a remeshing that was asked for is given up, and all is as it was before.
void cancel_remeshing(ScanHoles& holes);

/// A gesture's steps, and recorded ones. @throws Error
void take_gesture(ScanHoles& holes, const MeshEvent& event);
void replay(ScanHoles& holes, const recorded::Step& step);
void replay(ScanHoles& holes, const recorded::HoleWay& step);

/// The actions of menus and keys that need holes to work on; and whether each is enabled now.
QList<QAction*> add_hole_actions(ScanHoles& holes, ActionList& actions, QMenu* menu);
void refresh_hole_actions(const ScanHoles& holes, const QList<QAction*>& actions);

/// The holes, what can be done with them and how patches are made.
Panel* make_hole_panel(ScanHoles& holes);

/// Frames what is selected, recorded.
void frame_holes(ScanHoles& holes);

}  // namespace croquis::app

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QThreadPool>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/tools/holes/hole_overlay.h"
#include "app/tools/holes/hole_plan.h"
#include "app/views/object_scenes.h"
#include "croquis/tools/holes/hole_pins.h"
#include "croquis/tools/holes/hole_tool.h"
#include "croquis/tools/mesh/mesh_pick.h"
#include "croquis/tools/pointer/pen.h"

namespace croquis::app {

/// Finds which holes a scan itself hides in a view. What that needs is made on another thread.
class HoleSightMaker : public QObject {
  Q_OBJECT

 public:
  explicit HoleSightMaker(QObject* parent);
  ~HoleSightMaker() override;

  /// Null: nothing hides anything.
  void follow(const std::shared_ptr<const PolyMesh>& scan);

  /// Empty before it is ready.
  HoleSight sight() const;

 signals:
  void changed();

 private:
  std::shared_ptr<const PolyMesh> scan_;
  std::shared_ptr<MeshPicker> picker_;
  QThreadPool thread_;
};

/// Work on the holes of the active object: picks, fills, reopens, bridges and shapes them, by view, list and menu.
/// All that it changes is a parameter of the object's `fill` operation.
class HoleInteraction : public QObject {
  Q_OBJECT

 public:
  /// @param frame_of how tools see the model in a view
  HoleInteraction(Studio& studio, ObjectScenes& scenes, std::function<ViewFrame(int)> frame_of, QObject* parent);

  /// While it isn't active nothing of it is shown or computed.
  bool active() const { return active_; }
  void set_active(bool active);

  HoleTool& tool() { return tool_; }
  const std::vector<HoleRow>& rows() const { return rows_; }
  const HoleRow* row(Index hole) const;
  std::shared_ptr<const PolyMesh> scan() const;  ///< whose holes rows() are; null before the first result
  const std::vector<Index>& selected() const { return tool_.selected(); }
  const std::vector<Index>& hovered() const { return tool_.preview().hovered.holes; }
  const PatchPreview& preview() const { return preview_; }
  bool busy() const { return active_ && preview_.busy(); }

  // ---- Selection
  void select(std::vector<Index> holes);
  void select_all();
  void select_by_size(double diameter);
  std::vector<Index> open_up_to(double diameter) const;  ///< open holes that aren't borders, up to that diameter

  // ---- What becomes of holes; each is one step of the history
  void fill_selected();
  bool can_fill_selected() const;  ///< one is open, or belongs to a bridge that couldn't be made
  /// @param select one of the parameter's choices; of "inner", nothing that is filled is opened
  void fill_all(const std::string& select);
  bool can_fill_all(const std::string& select) const;  ///< it would change something, or that isn't known yet
  void fill_up_to(double diameter);                    ///< what is filled already stays
  void reopen_selected();
  void bridge_selected();
  void clear_handles();  ///< of the selected holes

  // ---- How patches are made: of the selected holes, of all when none is selected
  struct Way {
    std::string fairness, kernel;
    double bulge = 0;
    int trim_rim = 0;
  };
  Way way() const;
  std::string preset() const;  ///< of all holes
  /// What isn't given stays.
  struct WayChange {
    std::optional<std::string> fairness = {}, kernel = {};
    std::optional<double> bulge = {};
    std::optional<std::int64_t> trim_rim = {};
  };
  void set_way(const WayChange& change, bool dragging = false);
  void set_preset(const std::string& preset);  ///< of all holes: what is scanned
  void set_mode(const std::string& mode);      ///< of all holes: patches, or the model remeshed

  /// After computing was stopped: a remeshing that was asked for is given up, and all is as it was before.
  void cancel();

  // ---- Pointer events
  void take(const PointerEvent& event);  ///< its place in pixels of its view
  void leave();
  bool down() const { return pen_.down(); }
  bool abandon();  ///< gives up the gesture under way. @return false when there was none
  void replay(const recorded::HoleChoice& step);
  void replay(const recorded::HolePoint& step);
  void replay(const recorded::HoleWay& step);

  /// Shows what is there after the document, a result or the selection has changed.
  void follow();

  /// What is drawn over a view.
  void add_to(render::Scene& scene, int view);
  bool knows_sight() const { return sight_.sight() != nullptr; }  ///< of pins: whether the scan hides them
  const std::vector<HolePin>& pins(int view) { return tool_.pins(frame_of_(view)); }
  render::Bounds selection_bounds() const { return HoleOverlay::bounds_of(tool_, tool_.selected()); }

  /// Where what is selected looks to, out of the scan; nothing where that isn't one direction.
  std::optional<Vec3> selection_facing() const;

  /// The next action, in words and keys.
  QString help() const;

 signals:
  void changed();        ///< what is drawn over the views
  void holes_changed();  ///< rows or selection
  void committed(const croquis::recorded::Step& step);
  void told(const QString& sentence);
  void frame_wanted();  ///< of what is selected

 private:
  const Node* node() const;
  std::vector<Index> filled() const;
  std::vector<Index> open_of(const std::vector<Index>& holes) const;
  std::vector<Index> failed_of(const std::vector<Index>& holes) const;
  /// What is open after a selection was filled: of inner holes, what is filled already stays.
  std::vector<Index> open_after(hole_filling::Selection select, std::span<const Index> named) const;
  /// @param limit the operation's own parameter; 0 for no limit
  void fill_named(const std::string& label, hole_filling::Selection select, double limit);
  void attempt(const std::function<void()>& work);
  void edit(const std::string& label, const ParameterValues& values, bool dragging);
  void change_plan(const std::string& label, const std::function<void(HolePlan&)>& change,
                   const ParameterValues& besides = {});
  Way way_of(std::optional<Index> hole) const;  ///< without one, of holes without a request of their own
  bool is_made_so(const recorded::HoleWay& step) const;
  void change_way(const recorded::HoleWay& step, bool dragging);
  void finish(Verdict verdict);
  void apply(const recorded::HoleChoice& step);
  void apply(const recorded::HolePoint& step);
  void follow_pull();
  void feed(const PenStep& step);
  void hover(const PointerEvent& event);
  void take_result(const Node* operation);
  void show_patches();
  void show_handles();
  void selection_moved();

  Studio& studio_;
  ObjectScenes& scenes_;
  std::function<ViewFrame(int)> frame_of_;
  bool active_ = false;
  HoleTool tool_;
  PenInput pen_;
  HoleOverlay overlay_;
  PatchPreview preview_;
  HoleSightMaker sight_;
  std::vector<HoleRow> rows_;
  std::shared_ptr<const Evaluation> shown_;  ///< the result that rows_ describe
  NodeId shown_node_ = 0;
  int gesture_view_ = 0;
  std::optional<HolePlan> pulled_;  ///< before the pull under way
  bool dragging_ = false;           ///< the session's drag has begun
};

}  // namespace croquis::app

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "croquis/document/document.h"
#include "croquis/session/session.h"
#include "croquis/tools/pointer/pointer_event.h"
#include "croquis/tools/pointer/session_drag.h"
#include "croquis/tools/recording/step.h"
#include "croquis/tools/silhouette/sketch_steps.h"
#include "croquis/tools/silhouette/stroke_edit.h"
#include "croquis/tools/strokes/sketch_event.h"

namespace croquis {

enum class SketchMode { Draw, Select, Erase };

struct SketchToolOptions {
  std::string name = "Sketch";                                     ///< of the drawing
  std::string operation = "inflate";                               ///< made together with the first drawing …
  int version = 1;                                                 ///< … of this version …
  std::string port = "drawing";                                    ///< … its input that the drawing goes to …
  ParameterValues parameters = {{"attach", std::string("auto")}};  ///< … and those parameters that it starts with
  /// The parameters of an operation on a drawing of which strokes were taken away; without it they stay.
  std::function<ParameterValues(ParameterValues, const Drawing&)> follow_removal;
  PickReach reach;                    ///< its units_per_pixel is taken from each event
  double eraser_pixels = 6;           ///< radius of the eraser
  double drag_pixels = 4;             ///< a press that moves less is a click
  std::optional<double> mirror = {};  ///< strokes are the same on both sides of the line with that x, sketch units
  std::optional<double> tube = {};  ///< strokes are centre lines of tubes of that radius, sketch units; none: outlines
};

/// The document with a new source and the operation that it goes to.
/// @param drawing a drawing
Document add_drawing(const Document& document, Value drawing, const SketchToolOptions& options);

/// What to draw over the view while a gesture is under way, sketch units.
struct SketchPreview {
  std::vector<StrokeSample> ink;           ///< Draw: the samples so far, as they came
  bool behind = false;                     ///< Draw: the stroke will lie behind the others
  std::optional<double> mirror;            ///< Draw: x of the line on both sides of which it will be the same
  std::optional<double> tube;              ///< Draw: it is the centre line of a tube of this radius
  std::vector<Vec2> eraser;                ///< Erase: the path so far
  std::vector<std::vector<Vec2>> erased;   ///< Erase: what it has covered of the strokes, open polylines
  std::optional<PickBox> box;              ///< Select: the box spanned
  std::optional<std::size_t> held_anchor;  ///< Select: of `held_stroke`, the anchor under way
  std::string held_stroke;
  std::optional<Vec2> moved;  ///< Select: how far what is dragged has come
};

struct SketchGesture;
struct SketchChange;

/// The silhouette pen: draws, selects, bends and erases strokes of one drawing node of a session.
///
/// Draw: a stroke per gesture; with the right button or Shift it lies behind what is drawn. Select: a click picks a
/// stroke (Shift adds or takes away), a drag on an anchor of a selected stroke bends it, on a stroke moves what is
/// selected, elsewhere spans a box. Erase, or the pen's eraser end in any mode: cuts what it covers out of the strokes.
/// Every gesture is one undo step.
/// The session outlives the tool. Everything on the session's thread.
class SketchTool {
 public:
  explicit SketchTool(Session& session, SketchToolOptions options = {});
  ~SketchTool();
  SketchTool(const SketchTool&) = delete;
  SketchTool& operator=(const SketchTool&) = delete;

  SketchMode mode() const { return mode_; }
  void set_mode(SketchMode mode);  ///< gives up a gesture under way

  SketchToolOptions& options() { return options_; }

  Verdict handle(const SketchEvent& event);
  const SketchPreview& preview() const { return preview_; }

  /// What the last Commit did, for recordings.
  const std::optional<recorded::Step>& done() const { return done_; }

  Verdict delete_selected();  ///< Commit, or Continue when nothing is selected
  void select_all();

  /// Drags an anchor, or without one the whole stroke, as one undo step (replays).
  /// @throws Error (E_INPUT) when there is no such stroke or anchor
  Verdict drag(const std::string& stroke, std::optional<std::size_t> anchor, const Vec2& by);

  /// Says something about a stroke. While it is dragged, many calls are one undo step, which the last one ends.
  /// @throws Error (E_INPUT) when there is no such stroke
  Verdict set(const recorded::StrokeReading& setting, bool dragging = false);

  /// The drawing node worked on: the one set, else the document's first drawing; 0 when there is none yet.
  NodeId node() const;
  void set_node(NodeId node) { node_ = node; }
  /// Its drawing, or null.
  std::shared_ptr<const Drawing> drawing() const;

  /// Ids of this drawing's selected strokes, in its order.
  std::vector<std::string> selected() const;
  /// The fit of one of its strokes; kept until the stroke changes. Null when there is no such stroke.
  /// While one of its anchors is dragged the anchors stay those of the beginning, the dragged one moved along.
  const StrokeFit* fit(const std::string& stroke);

 private:
  struct KeptFit {
    std::vector<StrokeSample> samples;  ///< that it was made of
    StrokeFit fit;
  };

  void begin(const SketchEvent& event);
  void go_on(const SketchEvent& event);
  void start_drag();
  Verdict finish();
  Verdict give_up();
  Verdict commit(std::optional<SketchChange> change);

  Session& session_;
  SketchToolOptions options_;
  SketchMode mode_ = SketchMode::Draw;
  NodeId node_ = 0;
  SketchPreview preview_;
  std::optional<recorded::Step> done_;
  std::unique_ptr<SketchGesture> gesture_;  ///< null: none is under way
  SessionDrag drag_;
  std::map<std::string, KeptFit> fits_;
};

/// Says of several strokes of a drawing at once how it is to be read, as one undo step.
/// @throws Error (E_INPUT) when there is no such stroke
void read_as(Session& session, NodeId node, const recorded::ReadingChosen& reading);

}  // namespace croquis

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "croquis/document/document.h"
#include "croquis/session/session.h"
#include "croquis/tools/recording.h"
#include "croquis/tools/sketch_event.h"
#include "croquis/tools/stroke_edit.h"
#include "croquis/tools/stroke_pick.h"

namespace croquis {

enum class SketchMode { Draw, Select, Erase };

/// What an event led to.
enum class Verdict {
  Continue,  ///< go on: only the preview may have changed
  Commit,    ///< something was done: see SketchTool::done
  Revert     ///< what had begun was given up
};

struct SketchToolOptions {
  std::string operation = "inflate";                                 ///< made together with the first drawing …
  std::string port = "drawing";                                      ///< … its input that the drawing goes to …
  ParameterValues parameters = {{"preset", std::string("tablet")}};  ///< … and those parameters that it starts with
  PickReach reach;                                                   ///< its units_per_pixel is taken from each event
  double eraser_pixels = 6;                                          ///< radius of the eraser
  double drag_pixels = 4;                                            ///< a press that moves less is a click
};

/// What to draw over the view while a gesture is under way, sketch units.
struct SketchPreview {
  std::vector<StrokeSample> ink;           ///< Draw: the samples so far, as they came
  std::vector<Vec2> eraser;                ///< Erase: the path so far
  std::vector<std::string> erased;         ///< Erase: ids of the strokes it has touched
  std::optional<PickBox> box;              ///< Select: the box spanned
  std::optional<std::size_t> held_anchor;  ///< Select: of `held_stroke`, the anchor under way
  std::string held_stroke;
};

/// The silhouette pen: draws, selects, bends and erases strokes of one drawing node of a session.
///
/// Draw: a stroke per gesture. Select: a click picks a stroke (Shift adds or takes away), a drag on an anchor of a
/// selected stroke bends it, on a stroke moves what is selected, elsewhere spans a box. Erase, or the pen's eraser end
/// in any mode: deletes the strokes touched. Every gesture is one undo step.
/// The session outlives the tool. Everything on the session's thread.
class SketchTool {
 public:
  explicit SketchTool(Session& session, SketchToolOptions options = {});

  SketchMode mode() const { return mode_; }
  void set_mode(SketchMode mode);  ///< gives up a gesture under way

  Verdict handle(const SketchEvent& event);
  const SketchPreview& preview() const { return preview_; }

  /// What the last Commit did, for recordings.
  const std::optional<recorded::Step>& done() const { return done_; }

  Verdict delete_selected();  ///< Commit, or Continue when nothing is selected
  void select_all();

  /// Drags an anchor, or without one the whole stroke, as one undo step (replays).
  /// @throws Error (E_INPUT) when there is no such stroke or anchor
  Verdict drag(const std::string& stroke, std::optional<std::size_t> anchor, const Vec2& by);

  /// The drawing node worked on: the one set, else the document's first drawing; 0 when there is none yet.
  NodeId node() const;
  void set_node(NodeId node) { node_ = node; }
  /// Its drawing, or null.
  std::shared_ptr<const Drawing> drawing() const;

  /// Ids of this drawing's selected strokes, in its order.
  std::vector<std::string> selected() const;
  /// The fit of one of its strokes; kept until the stroke changes. Null when there is no such stroke.
  const StrokeFit* fit(const std::string& stroke);

 private:
  struct Gesture;
  Session& session_;
  SketchToolOptions options_;
  SketchMode mode_ = SketchMode::Draw;
  NodeId node_ = 0;
  SketchPreview preview_;
  std::optional<recorded::Step> done_;
};

}  // namespace croquis

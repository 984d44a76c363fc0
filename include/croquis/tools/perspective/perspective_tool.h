// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "croquis/document/document.h"
#include "croquis/geometry/affine3.h"
#include "croquis/session/session.h"
#include "croquis/tools/perspective/perspective_steps.h"
#include "croquis/tools/perspective/sheet_units.h"
#include "croquis/tools/pointer/pointer_event.h"
#include "croquis/tools/pointer/session_drag.h"
#include "croquis/tools/strokes/sketch_event.h"

namespace croquis {

enum class PerspectiveMode { Draw, Select, Erase };

struct PerspectiveToolOptions {
  std::string name = "Perspective";       ///< of the drawing
  std::string operation = "perspective";  ///< made together with the drawing …
  int version = 1;                        ///< … of this version …
  std::string port = "drawing";           ///< … its input that the drawing goes to
  Vec2 sheet = {1000, 750};               ///< px, of a new drawing
  double snap_pixels = 14;                ///< of the view: an end this near to a vertex goes to it
  double pick_pixels = 9;                 ///< how far the pointer may miss
  double eraser_pixels = 6;               ///< radius of the eraser
  double drag_pixels = 4;                 ///< a press that moves less is a click
};

/// From the space of perspective drawings, where z is up, to that of the views, where y is.
Affine3 upright_placement();

PerspectiveDrawing empty_sheet(const Vec2& size);  ///< px

/// The document with a drawing in perspective and the operation that it goes to; the solid stands upright in the views.
Document add_perspective_drawing(const Document& document, PerspectiveDrawing drawing,
                                 const PerspectiveToolOptions& options);

/// What to draw over the view while a gesture is under way, px of the sheet.
struct PerspectivePreview {
  std::vector<StrokeSample> ink;             ///< Draw: the samples so far, as they came, on the sketch plane (y up)
  StrokeGroup group = StrokeGroup::Unknown;  ///< Draw: that the stroke would have
  std::optional<Vec2> snap;                  ///< the vertex that the end would go to
  std::vector<std::string> erased;           ///< Erase: ids of the strokes touched
  std::optional<PickBox> box;                ///< Select: the box spanned
  std::optional<Vec2> moved;                 ///< Select: how far the pointer has dragged something; y down
};

struct SheetContext;
struct SheetGesture;

/// The pen on a perspective drawing: draws, selects, bends, joins and erases strokes of one drawing of a session.
///
/// Events come as they fall on the sketch plane; the sheet lies on it upside down: its place (u, v) is at (u, -v).
///
/// Draw: a gesture becomes one stroke, or one for each side between its corners. Ends of edges near a vertex go to it.
/// Groups are chosen, or found by where a line points. Select: a click picks a stroke (Shift adds or takes away),
/// within a face the strokes around it, a drag on a point of a selected stroke bends it, on an end takes the vertex
/// along (Ctrl: the end alone), on a vanishing point turns the lines of its axis, on a stroke moves what is selected,
/// elsewhere spans a box. Erase, or the pen's eraser end in any mode: deletes the strokes touched. Every gesture is one
/// undo step. The session outlives the tool. Everything on the session's thread.
class PerspectiveTool {
 public:
  explicit PerspectiveTool(Session& session, PerspectiveToolOptions options = {});
  ~PerspectiveTool();
  PerspectiveTool(const PerspectiveTool&) = delete;
  PerspectiveTool& operator=(const PerspectiveTool&) = delete;

  PerspectiveMode mode() const { return mode_; }
  void set_mode(PerspectiveMode mode);  ///< gives up a gesture under way

  /// Of the strokes drawn next, and of the one under way; none: by where they point.
  const std::optional<StrokeGroup>& group() const { return group_; }
  void set_group(std::optional<StrokeGroup> group);
  StrokeRole role() const { return role_; }
  void set_role(StrokeRole role) { role_ = role; }

  /// What was found in the drawing; null before that. Groups, vanishing points and mirrors follow it.
  void set_solved(std::shared_ptr<const SolvedDrawing> solved) { solved_ = std::move(solved); }
  const SolvedDrawing* solved() const { return solved_.get(); }

  Verdict handle(const SketchEvent& event);
  const PerspectivePreview& preview() const { return preview_; }

  /// Does a step of perspective_steps(): one undo step. Of strokes whose groups aren't given, these are guessed, and
  /// what a mirror adds is found; what is recorded then has them.
  /// @return Commit; Continue or, of a stroke, Revert where nothing changed
  /// @throws Error (E_INPUT) for strokes that aren't there, and values that can't be
  Verdict take(const recorded::Step& step);
  /// What the last Commit did, for recordings.
  const std::optional<recorded::Step>& done() const { return done_; }

  /// Whether an item is on one of the operation's lists ("faces", "no-faces", "ignore", "sharp").
  bool is_chosen(const std::string& list, const std::string& item) const;

  /// The drawing worked on: the one set, else the document's first one; 0 when there is none.
  NodeId node() const;
  void set_node(NodeId node) { node_ = node; }
  std::shared_ptr<const PerspectiveDrawing> drawing() const;  ///< or null
  NodeId operation_node() const;                              ///< that it goes to; 0 for none

  std::vector<std::string> selected() const;  ///< ids of selected strokes, in the drawing's order
  void select(const std::vector<std::string>& ids);

 private:
  void begin(const SketchEvent& event);
  void go_on(const SketchEvent& event);
  Verdict finish();
  Verdict give_up();
  void start_drag();
  void preview_stroke();
  SheetContext context() const;

  Session& session_;
  PerspectiveToolOptions options_;
  PerspectiveMode mode_ = PerspectiveMode::Draw;
  std::optional<StrokeGroup> group_;
  StrokeGroup last_plane_ = StrokeGroup::Unknown;  ///< that was chosen last: for what could be in several
  StrokeRole role_ = StrokeRole::Edge;
  NodeId node_ = 0;
  std::shared_ptr<const SolvedDrawing> solved_;
  PerspectivePreview preview_;
  std::optional<recorded::Step> done_;

  std::unique_ptr<SheetGesture> gesture_;  ///< null: none is under way
  SessionDrag drag_;
};

}  // namespace croquis

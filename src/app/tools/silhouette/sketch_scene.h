// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <optional>
#include <string>
#include <vector>

#include "app/studio/studio.h"
#include "app/tools/scene_parts.h"
#include "croquis/document/evaluation.h"
#include "croquis/geometry/drawing.h"
#include "croquis/render/scene.h"
#include "croquis/tools/silhouette/sketch_tool.h"

namespace croquis::app {

/// What is covered of strokes that are drawn through behind others. Of a solid's result: the strokes that lie behind
/// others which they cross in full view, and the hidden contours.
struct CoveredStrokes {
  std::vector<std::string> ids;
  std::vector<std::vector<Vec2>> hidden;  ///< polylines, sketch units
  double reach = 0;                       ///< how far a covered line may lie from its contour, which is smoothed
};

/// What the sketch view shows of the studio's drawing, made ready for the renderer. Items are kept until what they
/// show changes.
class SketchScene {
 public:
  /// Strokes, selection, anchors.
  void show_drawing(const Studio& studio, SketchTool& tool);

  /// Hidden contours and marks. What is covered of strokes is seen when the drawing is shown the next time.
  void show_result(const Studio& studio);

  /// What the pen is about to do, but for its ink; cheap enough for every event.
  void show_preview(const SketchPreview& preview);

  /// The stroke under the pointer, or none.
  void show_hovered(const std::optional<std::string>& stroke, const Drawing& drawing);

  void add_to(render::Scene& scene) const;

  /// The box of the strokes, of the selected ones alone if there are any and that is asked for.
  render::Bounds bounds(bool selected_only) const;
  const std::vector<FindingMark>& finding_marks() const { return finding_marks_; }
  /// Nothing is there yet, and the ghost shows what to do.
  bool invites() const { return ghost_ != nullptr; }
  bool has_strokes() const { return strokes_ != nullptr || selected_ != nullptr; }

 private:
  render::LineItemPtr ghost_;   ///< shown while nothing is drawn yet
  render::LineItemPtr others_;  ///< strokes of other sketches
  render::LineItemPtr strokes_;
  render::LineItemPtr selected_;
  render::LineItemPtr hovered_;
  render::MarkItemPtr anchors_;
  render::LineItemPtr hidden_;
  render::MarkItemPtr marks_;
  render::LineItemPtr preview_lines_;
  render::LineItemPtr axis_;  ///< of a symmetric drawing
  CoveredStrokes covered_;
  std::vector<FindingMark> finding_marks_;
};

}  // namespace croquis::app

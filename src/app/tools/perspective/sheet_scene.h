// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QString>
#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/tools/scene_parts.h"
#include "croquis/base/finding.h"
#include "croquis/geometry/perspective_drawing.h"
#include "croquis/operators/perspective_result.h"
#include "croquis/render/line_item.h"
#include "croquis/render/scene.h"
#include "croquis/tools/perspective/perspective_tool.h"

namespace croquis::app {

// How groups of strokes look: a colour, dashes and a letter, so that nobody has to know colours apart.

QColor group_color(StrokeGroup group);

/// "x", "y", "z", "⊥x", "⊥y", "⊥z", "?".
QString group_letter(StrokeGroup group);
QString group_words(StrokeGroup group);  ///< "x", "left" …: what stands on a button

/// "Parallel to x" … "In a plane across z".
QString group_title(StrokeGroup group);

/// From pale yellow over orange to dark red, the worse the darker. @param px how far a line misses its vanishing point
QColor residual_color(double px);

/// Where a place of the sheet lies in a view's space.
using FromSheet = std::function<glm::dvec3(const Vec2&)>;

/// On the sketch plane, y up.
inline glm::dvec3 on_sketch_plane(const Vec2& sheet) { return {sheet.x(), -sheet.y(), 0}; }

/// A place on the stroke, halfway.
Vec2 middle_of_stroke(const PerspectiveStroke& stroke);

/// All of its places are finite.
bool is_drawable(const PerspectiveStroke& stroke);

/// What the sketch view shows of a drawing in perspective. Items are kept until what they show changes.
class SheetScene {
 public:
  void show_drawing(const PerspectiveDrawing& drawing, const std::vector<std::string>& selected, bool points);
  void show_result(const PerspectiveDrawing& drawing, const PerspectiveResult* result, const Findings& findings);
  void show_preview(const PerspectiveDrawing& drawing, const PerspectivePreview& preview);
  void show_hovered(const PerspectiveDrawing& drawing, const std::optional<std::string>& stroke);

  /// Strokes that a mirror would add.
  void show_proposed(const std::vector<PerspectiveStroke>& strokes);

  /// Rays from a place to where each axis vanishes; without a place none.
  void show_guides(const PerspectiveDrawing& drawing, const std::array<std::optional<Vec3>, 3>& vanishing,
                   const std::optional<Vec2>& from);

  /// @param units_per_pixel of the view: letters keep their size
  void add_to(render::Scene& scene, const PerspectiveDrawing& drawing, double units_per_pixel) const;

  /// The sheet and what lies outside of it.
  render::Bounds bounds() const { return bounds_; }
  const std::vector<FindingMark>& marks() const { return finding_marks_; }

 private:
  void show_residuals(const PerspectiveDrawing& drawing, const PerspectiveResult* result);
  void show_vanishing_points(const PerspectiveDrawing& drawing, const PerspectiveResult* result);
  void show_findings(const PerspectiveDrawing& drawing, const Findings& findings);

  std::vector<render::LineItemPtr> strokes_;
  render::LineItemPtr sheet_, selected_, hovered_, residuals_, preview_, guides_, proposed_, horizon_;
  render::MarkItemPtr points_, vertices_, findings_, vanishing_, snap_;
  render::Bounds bounds_;
  std::vector<FindingMark> finding_marks_;
};

/// The strokes alone, for another view. @param opacity 0..1
std::vector<render::LineItemPtr> stroke_items(const PerspectiveDrawing& drawing, const FromSheet& place,
                                              double opacity);

// The letters that stand beside strokes and name their groups.

/// A letter's middle, px of the sheet.
struct GroupLetter {
  StrokeGroup group = StrokeGroup::Unknown;
  Vec2 at = Vec2::Zero();
};

/// A place beside each stroke that is long enough, where no other letter stands; strokes that have none go without one,
/// construction lines before edges. O(#letters²), 60 strokes in well under a millisecond.
/// @param unit px of the sheet per logical pixel of the view, > 0
std::vector<GroupLetter> group_letters(const PerspectiveDrawing& drawing, double unit);

}  // namespace croquis::app

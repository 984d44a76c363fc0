// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "croquis/base/finding.h"
#include "croquis/operators/perspective_result.h"
#include "croquis/render/scene.h"
#include "croquis/tools/perspective/perspective_tool.h"

namespace croquis::app {

/// A finding and where on the sheet it stands, px, y down.
struct SheetMark {
  Vec2 at = Vec2::Zero();
  QString sentence;
  bool error = false;
};

/// Where a place of the sheet lies in a view's space.
using FromSheet = std::function<glm::dvec3(const Vec2&)>;

/// On the sketch plane, y up.
glm::dvec3 on_sketch_plane(const Vec2& sheet);

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
  render::Scene scene(const PerspectiveDrawing& drawing, double units_per_pixel) const;

  /// The sheet and what lies outside of it.
  render::Bounds bounds() const { return bounds_; }
  const std::vector<SheetMark>& marks() const { return finding_marks_; }

 private:
  void show_residuals(const PerspectiveDrawing& drawing, const PerspectiveResult* result);
  void show_vanishing_points(const PerspectiveDrawing& drawing, const PerspectiveResult* result);
  void show_findings(const PerspectiveDrawing& drawing, const Findings& findings);

  std::vector<render::LineItemPtr> strokes_;
  render::LineItemPtr sheet_, selected_, hovered_, residuals_, preview_, guides_, proposed_, horizon_;
  render::MarkItemPtr points_, vertices_, findings_, vanishing_, snap_;
  render::Bounds bounds_;
  std::vector<SheetMark> finding_marks_;
};

/// The strokes alone, for another view. @param opacity 0..1
std::vector<render::LineItemPtr> stroke_items(const PerspectiveDrawing& drawing, const FromSheet& place,
                                              double opacity);

}  // namespace croquis::app

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <vector>

#include "app/tools/holes/hole_rows.h"
#include "croquis/render/scene.h"
#include "croquis/tools/holes/hole_tool.h"

namespace croquis::app {

/// The colour of a hole's rim and pin: distinct for any colour vision, and distinct from the selection's.
QColor hole_color(const HoleRow& hole);

/// Rims of holes over the surface, those behind it faint; handles of patches. Kept until what it shows changes.
class HoleOverlay {
 public:
  /// After holes, selection or handles have changed.
  void follow(const HoleTool& tool, const std::vector<HoleRow>& rows);

  /// What is under the pointer or being pulled; cheap enough for every event.
  void follow_hover(const HoleTool& tool);

  void add_to(render::Scene& scene) const;

  /// Of these holes with some of what is around; empty for none.
  static render::Bounds bounds_of(const HoleTool& tool, const std::vector<Index>& holes);

 private:
  /// Lines that what covers them leaves faint.
  struct SeenThrough {
    render::LineItemPtr clear;
    render::LineItemPtr faint;
  };
  static SeenThrough rims(std::vector<render::LinePath> paths, double width);

  SeenThrough all_;
  SeenThrough selected_;
  SeenThrough hovered_;
  render::MarkItemPtr handles_;
  render::LineItemPtr pull_;
  render::MarkItemPtr pulled_;
};

}  // namespace croquis::app

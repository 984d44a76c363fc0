// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <list>
#include <optional>
#include <vector>

#include "croquis/tools/holes/hole_tool.h"
#include "croquis/tools/pointer/view_frame.h"

namespace croquis {

/// What a HoleTool works on, and what of it lies under a pixel.
class HoleScene {
 public:
  explicit HoleScene(const HoleToolOptions& options) : options_(options) {}

  void set_rims(std::vector<HoleRim> rims);
  void set_patches(std::vector<HolePatchView> patches);
  void set_sight(HoleSight sight);

  const std::vector<HoleRim>& rims() const { return rims_; }
  const HoleRim* rim(Index hole) const;
  std::vector<PatchHandle> handles;

  const std::vector<HolePin>& pins(const ViewFrame& frame) { return view(frame).pins; }
  HoleHover at(const ViewFrame& frame, const Vec2& pixel);

  /// The patch's normal at a place of at(), towards the eye; of a handle its own.
  Vec3 normal_at(const HoleHover& hover, const ViewFrame& frame) const;

  /// Sorted; of those whose place isn't hidden.
  std::vector<Index> in_box(const ViewFrame& frame, const PickBox& box) const;

 private:
  /// A rim's points on screen; those beside or behind the eye are NaN.
  struct ScreenRim {
    std::vector<Vec2> pixels;
    PickBox box;  ///< around them; empty (low > high) when there is none
  };
  /// What one view shows.
  struct View {
    ViewFrame frame;
    std::vector<HolePin> pins;
    std::vector<ScreenRim> rims;
  };
  struct Patch {
    HolePatchView shown;
    Vec3 low, high;  ///< its box
  };
  struct PatchHit {
    Index hole = no_index;
    Vec3 place = Vec3::Zero();
    Vec3 normal = Vec3::UnitZ();
    double distance = 0;
  };

  View& view(const ViewFrame& frame);
  bool sees(const ViewFrame& frame, const Vec3& place) const { return !sight_ || sight_(frame, place); }
  std::optional<std::size_t> handle_at(const ViewFrame& frame, const Vec2& pixel) const;
  const HolePin* pin_at(const View& view, const Vec2& pixel) const;
  Index rim_at(const View& view, const Vec2& pixel) const;
  std::optional<PatchHit> patch_at(const ViewFrame& frame, const Vec2& pixel) const;
  Index opening_at(const View& view, const Vec2& pixel) const;
  bool sees_some_of(const ViewFrame& frame, const HoleRim& rim) const;

  HoleToolOptions options_;
  std::vector<HoleRim> rims_;  ///< by id
  std::vector<Patch> patches_;
  HoleSight sight_;
  std::list<View> views_;  ///< those looked at lately, the last one first
};

/// A place of the model dragged by the pointer: in the plane across the view, or along a line.
class PatchDrag {
 public:
  /// @param grip where the pointer was pressed, near the place. @param axis unit; none: across the view
  PatchDrag(const ViewFrame& frame, const Vec2& grip, const Vec3& from, const std::optional<Vec3>& axis);

  Vec3 to(const Vec2& pixel) const;

 private:
  double along_axis(const Vec2& pixel) const;

  ViewFrame frame_;
  Vec2 grip_;
  Vec3 from_;
  std::optional<Vec3> axis_;
  bool end_on_ = false;  ///< the axis points to the eye: up and down move along it
};

}  // namespace croquis

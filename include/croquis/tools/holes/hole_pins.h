// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "croquis/geometry/poly_mesh.h"
#include "croquis/tools/pointer/view_frame.h"

namespace croquis {

/// A hole as a view shows it.
struct HoleRim {
  Index id = no_index;
  std::vector<Vec3> points;     ///< closed without repeating the first
  Vec3 at = Vec3::Zero();       ///< where its pin stands
  Vec3 normal = Vec3::UnitZ();  ///< outwards, length 1; 0 where there is none
  double radius = 0;            ///< model units
};

/// The rims drawn by a mesh's polylines: hole i is line i; a last point that repeats the first is left out. `at` is the
/// mean along the rim, the normal that of the area the rim spans (against the rim's own turning sense: a boundary runs
/// with the surface on its left, the hole's outside sees it run clockwise), the radius the largest distance from `at`.
std::vector<HoleRim> rims_from_lines(const PolyMesh& lines);

/// Whether nothing hides a place in that view.
using HoleSight = std::function<bool(const ViewFrame& frame, const Vec3& place)>;

struct HolePinOptions {
  double radius = 10;      ///< of a pin, pixels
  double gap = 2;          ///< between pins, pixels
  double most_moved = 36;  ///< pixels a pin may be moved away from its hole's place, to keep clear of others
};

/// Where a view shows a hole, or several that there isn't room for.
struct HolePin {
  std::vector<Index> holes;  ///< those it stands for, sorted; the one whose place it marks is `hole`
  Index hole = no_index;
  Vec2 pixel = Vec2::Zero();   ///< its middle
  Vec2 anchor = Vec2::Zero();  ///< the hole's own place; a leader joins them where they differ
  Vec3 place = Vec3::Zero();   ///< of the model, seen at `pixel`, as deep as the hole: for marks
  bool facing = true;          ///< the hole is seen from outside
  bool visible = true;         ///< nothing hides its place
  bool moved() const { return pixel != anchor; }
};

/// Pins that don't cover each other: larger holes first, those that face the eye and aren't hidden before others; a pin
/// without room is moved to the nearest free place around, or else joins the nearest pin. Holes behind the eye or
/// outside the view have none. Deterministic; O(n log n) with the sight's n calls on top.
std::vector<HolePin> place_pins(std::span<const HoleRim> rims, const ViewFrame& frame,
                                const HolePinOptions& options = {}, const HoleSight& sight = {});

}  // namespace croquis

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "croquis/tools/pointer/pick_box.h"
#include "croquis/tools/strokes/stroke_fit.h"

/// What lies under the pointer on the sketch plane.
namespace croquis {

/// How far a pointer may miss.
struct PickReach {
  double pixels = 8;           ///< >= 0
  double units_per_pixel = 1;  ///< of the view, > 0

  double units() const { return pixels * units_per_pixel; }
};

struct PickedStroke {
  std::string id;
  std::size_t segment = 0;    ///< 0-based: from this sample to the next (of a closed stroke's last, to the first)
  double parameter = 0;       ///< 0..1 on the segment
  Vec2 place = Vec2::Zero();  ///< nearest place on the stroke, sketch units
  double distance = 0;        ///< sketch units
};

/// The place of one stroke nearest to a place, within reach; of equally near ones the first. Linear.
std::optional<PickedStroke> nearest_place(const Stroke& stroke, const Vec2& place, const PickReach& reach = {});

/// The stroke nearest to a place, within reach; of equally near ones the one drawn last, which lies on top.
/// Linear in the drawing's samples.
std::optional<PickedStroke> nearest_stroke(const Drawing& drawing, const Vec2& place, const PickReach& reach = {});

/// The anchor (0-based) nearest to a place, within reach. Linear.
std::optional<std::size_t> nearest_anchor(std::span<const StrokeAnchor> anchors, const Vec2& place,
                                          const PickReach& reach = {});

/// Ids of the strokes of which some piece lies in the box, in the drawing's order. Linear.
std::vector<std::string> strokes_in_box(const Drawing& drawing, const PickBox& box);

}  // namespace croquis

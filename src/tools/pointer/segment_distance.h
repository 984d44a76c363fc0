// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <utility>

#include "croquis/geometry/drawing.h"
#include "croquis/tools/pointer/mesh_event.h"

namespace croquis {

/// Smallest distance of two plane segments, which may have no length; 0 when they cross.
double segment_distance(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d);

/// The part of a segment that lies in an upright box, as parameters 0..1; nothing where they have no place in common.
std::optional<std::pair<double, double>> part_in_box(const Vec2& a, const Vec2& b, const PickBox& box);

inline bool meets_box(const Vec2& a, const Vec2& b, const PickBox& box) { return part_in_box(a, b, box).has_value(); }

/// Segments of a stroke: one less than samples, as many when closed; a dot has one without length.
std::size_t segment_count(const Stroke& stroke);
const Vec2& segment_begin(const Stroke& stroke, std::size_t segment);
const Vec2& segment_end(const Stroke& stroke, std::size_t segment);

}  // namespace croquis

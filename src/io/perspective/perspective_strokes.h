// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>
#include <variant>
#include <vector>

#include "croquis/geometry/perspective_drawing.h"
#include "io/json/report_reader.h"
#include "io/svg/svg_shapes.h"

/// What the files of perspective drawings share: their words and the shapes of strokes.
namespace croquis {

inline constexpr const char* perspective_format = "croquis-perspective/1";
inline constexpr const char* perspective_namespace = "urn:croquis:perspective:1";

/// Calls `write` with the value of each of a stroke's fields that isn't as usual: a text, true or a number.
template <typename Write>
void each_set_field(const PerspectiveStroke& stroke, const Write& write) {
  const PerspectiveStroke usual;
  for (const StrokeField& field : stroke_fields) {
    std::visit(
        [&](auto member) {
          if (stroke.*member == usual.*member) return;
          if constexpr (std::is_same_v<decltype(member), EndLock PerspectiveStroke::*>) {
            write(field, word_of(stroke.*member, end_lock_words));
          } else {
            write(field, stroke.*member);
          }
        },
        field.member);
  }
}

PictureCubic straight_piece(const Vec2& from, const Vec2& to);

/// The cubics of a segment; arcs are cut into at most quarter turns.
std::vector<PictureCubic> cubics_of(const SvgSegment& segment, const Vec2& from);

/// Makes a stroke of one straight segment straight, and one that is parallel to an axis if it is nearly so.
void straighten(PerspectiveStroke& stroke, double tolerance);

/// Angle across the width and back, so that the angle in degrees gives the same radians again.
double degrees_of(double radians);
double radians_of(double degrees);

}  // namespace croquis

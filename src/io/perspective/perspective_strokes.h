// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "croquis/geometry/perspective_drawing.h"
#include "io/svg/svg_shapes.h"

/// What the files of perspective drawings share: their words and the shapes of strokes.
namespace croquis {

inline constexpr const char* perspective_format = "croquis-perspective/1";
inline constexpr const char* perspective_namespace = "urn:croquis:perspective:1";

inline const char* word_of(StrokeRole role) { return role == StrokeRole::Edge ? "edge" : "construction"; }

inline const char* word_of(EndLock lock) {
  return lock == EndLock::Smooth ? "smooth" : lock == EndLock::Corner ? "corner" : "none";
}

inline std::optional<StrokeRole> role_of(std::string_view word) {
  if (word == "edge") return StrokeRole::Edge;
  if (word == "construction") return StrokeRole::Construction;
  return std::nullopt;
}

inline std::optional<EndLock> lock_of(std::string_view word) {
  if (word == "smooth") return EndLock::Smooth;
  if (word == "corner") return EndLock::Corner;
  if (word == "none") return EndLock::None;
  return std::nullopt;
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

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>

#include "croquis/tools/perspective/sheet_units.h"
#include "croquis/tools/perspective/stroke_shape.h"

/// Which group a stroke was meant for, by where it points.
namespace croquis {

/// Where the lines of each axis meet, homogeneous in px; none for an axis of which nothing is known. Of a solved
/// drawing its own; before that, of an axis with several straight strokes the place nearest to all of them (least
/// squares over the lines, weighted by length), of one with a single stroke that stroke's direction.
std::array<std::optional<Vec3>, 3> seen_vanishing_points(const PerspectiveDrawing& drawing,
                                                         const SolvedDrawing* solved);

/// The angle at a place between a line of that direction and the one to a vanishing point; radians, 0..pi/2.
double angle_to(const Vec3& vanishing_point, const Vec2& place, const Vec2& direction);

/// The axis that a straight stroke points along. Before the drawing is solved, axes without lines are guessed, too:
/// z for what is nearly upright, x for what falls to the right, y for what rises.
/// @return nothing when it points to none of them
std::optional<StrokeGroup> guess_axis(const PerspectiveDrawing& drawing, const SolvedDrawing* solved, const Vec2& from,
                                      const Vec2& to);

/// The axis that a straight stroke points along best, where that isn't far off: for what no plane is known of, either.
std::optional<StrokeGroup> nearest_axis(const PerspectiveDrawing& drawing, const SolvedDrawing* solved,
                                        const Vec2& from, const Vec2& to);

/// The plane that a stroke lies in, by what is known of its ends:
/// - Between two vertices of the network, a plane in which both lie: at right angles to an axis along which they have
///   the same coordinate.
/// - A curve that goes on from a line along an axis, or begins or ends along an axis, as where it rounds a corner, lies
///   in a plane with that axis.
/// Of several such planes `preferred` if it is one of them, else the one that is seen more from the front; where
/// nothing is known, `preferred`.
/// @param reach px, how far the ends may lie from where the vertices are seen
StrokeGroup guess_plane(const PerspectiveDrawing& drawing, const SolvedDrawing* solved, const StrokeShape& shape,
                        double reach, StrokeGroup preferred);

}  // namespace croquis

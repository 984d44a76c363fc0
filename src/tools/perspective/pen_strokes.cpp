// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/tools/perspective/pen_strokes.h"

#include <utility>

#include "croquis/tools/perspective/axis_guess.h"
#include "croquis/tools/perspective/drawing_edit.h"
#include "croquis/tools/perspective/stroke_shape.h"

namespace croquis {
namespace {

/// Vertices of the last solution are found this far from where they are drawn, as a share of the sheet's diagonal.
constexpr double found_share = 0.01;

Straightness straightness_of(const PenStrokeOptions& options) {
  if (options.role == StrokeRole::Construction) return Straightness::Always;
  if (!options.group) return Straightness::Guess;
  return is_parallel(*options.group) ? Straightness::Always : Straightness::WhenExact;
}

/// An edge's ends go to vertices, but both to the same one only where the edge was drawn as a loop's part.
StrokeShape snapped_shape(const PerspectiveDrawing& drawing, StrokeShape shape, double reach) {
  const auto start = nearest_end(drawing, shape.start(), reach);
  const auto end = nearest_end(drawing, shape.end(), reach);
  Vec2 from = start ? place_of(drawing, *start) : shape.start();
  Vec2 to = end ? place_of(drawing, *end) : shape.end();
  if (from == to) {
    const bool start_is_nearer = (shape.start() - from).norm() <= (shape.end() - to).norm();
    (start_is_nearer ? to : from) = start_is_nearer ? shape.end() : shape.start();
  }
  return with_ends(std::move(shape), from, to);
}

StrokeGroup group_of(const PerspectiveDrawing& drawing, const StrokeShape& shape, const PenStrokeOptions& options) {
  if (options.group) return *options.group;
  if (shape.straight) {
    const auto axis = guess_axis(drawing, options.solved, shape.start(), shape.end());
    if (axis) return *axis;
  }
  const StrokeGroup preferred = options.role == StrokeRole::Construction ? StrokeGroup::Unknown : options.plane;
  const StrokeGroup plane = guess_plane(drawing, options.solved, shape, found_share * drawing.diagonal(), preferred);
  if (plane != StrokeGroup::Unknown || !shape.straight) return plane;
  return nearest_axis(drawing, options.solved, shape.start(), shape.end()).value_or(plane);
}

}  // namespace

std::vector<std::string> draw_strokes(PerspectiveDrawing& drawing, std::span<const Vec2> places,
                                      const PenStrokeOptions& options) {
  ShapeOptions shaping;
  shaping.units_per_pixel = options.units_per_pixel;
  shaping.straightness = straightness_of(options);
  const PerspectiveDrawing before = drawing;
  std::vector<std::string> ids;
  for (StrokeShape& shape : shapes_of(places, shaping)) {
    if (options.role == StrokeRole::Edge)
      shape = snapped_shape(before, std::move(shape), options.snap_pixels * options.units_per_pixel);
    const bool known = !options.group && ids.size() < options.groups.size();
    const StrokeGroup group = known ? options.groups[ids.size()] : group_of(drawing, shape, options);
    // Short of a vertex a curve may have become a point.
    if ((shape.end() - shape.start()).norm() < vertex_reach(drawing)) continue;
    ids.push_back(add_stroke(drawing, std::move(shape), group, options.role));
  }
  return ids;
}

}  // namespace croquis

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "croquis/geometry/drawing.h"
#include "croquis/tools/pointer/mesh_event.h"
#include "croquis/tools/strokes/stroke_fit.h"

namespace croquis {

// What lies under the pointer on the sketch plane.

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

// Which strokes were meant to be loops.

struct CloseOptions {
  double units_per_pixel = 1;
  double distance = 12;     ///< pixels: ends nearer than this close the stroke …
  double times_longer = 4;  ///< … unless it is shorter than this times the distance: a tick is no loop
  /// Of the stroke's length: how far its end may stop short of its beginning, or run past it. A little more than the
  /// five percent that hands miss: the length is that of what was drawn.
  double share = 0.055;
  double aside_share = 0.035;  ///< of its length: how far aside it may do so
  double least_length = 16;    ///< pixels: shorter strokes stay open
};

/// Whether a drawn stroke was meant to be a loop: its ends are near each other, or its end heads for its beginning and
/// would go on into it, or runs past it, beside it and the same way, or both ends head for one corner.
bool ends_meet(std::span<const StrokeSample> samples, const CloseOptions& options = {});

// Every change that the tools make to a drawing: pure functions from a drawing to a drawing. Strokes that they don't
// name keep equal values, in the same order.

/// A drawing after an edit, and what happened to whom (stroke ids).
struct DrawingEdit {
  Drawing drawing;
  std::vector<std::string> added;
  std::vector<std::string> changed;
  std::vector<std::string> removed;

  bool any() const { return !added.empty() || !changed.empty() || !removed.empty(); }
};

/// The stroke of that id, or null. O(#strokes).
const Stroke* find_stroke(const Drawing& drawing, std::string_view id);

/// "stroke N" with the lowest N above every such name in the drawing.
std::string new_stroke_id(const Drawing& drawing);

/// Sketch units per pixel at which a stroke was drawn (its data "scale"); of strokes without, a thousandth of the
/// drawing's diagonal. So a stroke's anchors depend on the document alone, not on the zoom under which they are seen.
double drawn_scale(const Drawing& drawing, const Stroke& stroke);

/// The fit that gives a stroke of the drawing its anchors. @throws as fit_stroke
StrokeFit fit_in_drawing(const Drawing& drawing, const Stroke& stroke);

struct DrawOptions {
  double units_per_pixel = 1;         ///< > 0, of the view drawn in; kept as the stroke's data "scale"
  CloseOptions closing;               ///< its units_per_pixel is overridden by the one above
  bool redraws = true;                ///< a stroke that follows an old one replaces that part of it
  double redraw_distance = 10;        ///< pixels, how near the new stroke's ends must run to the old one …
  double redraw_degrees = 35;         ///< … and how much they may differ in direction
  std::optional<double> tube = {};    ///< the stroke is the centre line of a tube of this radius; it redraws nothing
  std::optional<double> mirror = {};  ///< x of the line on both sides of which it is the same, sketch units
  bool behind = false;                ///< the stroke lies behind all that is drawn where they cross; it redraws nothing
};

/// Adds a drawn stroke, closed when its ends meet; what then overshoots the seam is left out. When both its ends run
/// along the same old stroke in the same sense, it replaces the part between instead (order and direction are found,
/// closed strokes stay closed): then the old stroke is `changed` and nothing is added. Times are counted from the first
/// sample.
/// @param samples at least one, finite. @throws Error (E_NO_STROKES, E_NOT_FINITE)
DrawingEdit draw_stroke(const Drawing& drawing, std::vector<StrokeSample> samples, const DrawOptions& options = {});

/// Shifts whole strokes; unknown ids are left out. Ends of other strokes that rest on them follow, within 12 pixels of
/// the view that these were drawn in, and bend their strokes; these are `changed` as well.
DrawingEdit move_strokes(const Drawing& drawing, const std::vector<std::string>& ids, const Vec2& by);

/// Moves an anchor and bends the samples to both sides, up to but without the neighbouring anchors, which stay with
/// all that lies beyond. The falloff is smooth over the arc length; closed strokes wrap. Ends that rest on the stroke
/// follow it, as with move_strokes.
/// @param fit of that stroke (fit_in_drawing); @param anchor 0-based
/// @throws Error (E_INPUT) when there is no such stroke or anchor
DrawingEdit drag_anchor(const Drawing& drawing, std::string_view id, const StrokeFit& fit, std::size_t anchor,
                        const Vec2& by);

/// Deletes strokes; unknown ids are left out.
DrawingEdit remove_strokes(const Drawing& drawing, const std::vector<std::string>& ids);

}  // namespace croquis

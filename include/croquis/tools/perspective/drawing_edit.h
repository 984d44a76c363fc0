// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "croquis/geometry/perspective_drawing.h"
#include "croquis/tools/perspective/stroke_shape.h"
#include "croquis/tools/pointer/mesh_event.h"

namespace croquis {

// What lies under the pointer on the sheet of a perspective drawing. Places and reaches are px of the sheet.

/// The stroke nearest to a place, within reach; of equally near ones the one drawn last. Linear.
std::optional<std::string> nearest_stroke(const PerspectiveDrawing& drawing, const Vec2& place, double reach);

/// A point of a stroke that can be dragged (see points_of).
struct PickedPoint {
  std::string stroke;
  std::size_t point = 0;
  friend bool operator==(const PickedPoint&, const PickedPoint&) = default;
};

/// The nearest one of the strokes named, within reach; ends before handles that lie as near.
std::optional<PickedPoint> nearest_point(const PerspectiveDrawing& drawing, const std::vector<std::string>& ids,
                                         const Vec2& place, double reach);

/// Ids of the strokes that lie in the box with some part, in the drawing's order.
std::vector<std::string> strokes_in_box(const PerspectiveDrawing& drawing, const PickBox& box);

/// Ids of the strokes that the tip of an eraser touches on its way, in the drawing's order.
std::vector<std::string> strokes_touched(const PerspectiveDrawing& drawing, const Vec2& from, const Vec2& to,
                                         double radius);

/// Of loops of strokes, as they are drawn, the smallest one that a place lies in. The strokes of a loop may come in any
/// order and direction; what isn't a loop is passed over.
std::optional<std::size_t> face_at(const PerspectiveDrawing& drawing,
                                   const std::vector<std::vector<std::string>>& loops, const Vec2& place);

// Every change that people make to a perspective drawing: pure functions from a drawing to a drawing. Strokes that
// they don't name keep equal values, in the same order. Places are px, y down.

/// An end of a stroke.
struct DrawnEnd {
  std::size_t stroke = 0;  ///< 0-based, in the drawing
  bool last = false;       ///< its last point instead of its first
  friend bool operator==(const DrawnEnd&, const DrawnEnd&) = default;
};

/// How far the ends of one vertex may lie from each other: 0.32 % of the sheet's diagonal, as in the reconstruction.
double vertex_reach(const PerspectiveDrawing& drawing);

/// The stroke of that id, or null. O(#strokes).
const PerspectiveStroke* find_stroke(const PerspectiveDrawing& drawing, std::string_view id);

/// "s1", "s2" … with the lowest number above all of such ids.
std::string new_stroke_id(const PerspectiveDrawing& drawing);

/// Whether ends of the stroke are tied to vertices: edges and links.
bool has_vertices(const PerspectiveStroke& stroke);

/// The end of a stroke with vertices that is nearest to a place, within reach.
std::optional<DrawnEnd> nearest_end(const PerspectiveDrawing& drawing, const Vec2& place, double reach);

const Vec2& place_of(const PerspectiveDrawing& drawing, const DrawnEnd& end);

/// All ends at the same vertex, that one first: those with its name, and those within reach of it.
std::vector<DrawnEnd> ends_at_vertex(const PerspectiveDrawing& drawing, const DrawnEnd& end);

/// A place for each vertex that an edge or link has: the mean of its ends.
std::vector<Vec2> vertices_of(const PerspectiveDrawing& drawing);

/// Adds a stroke. Its ends go to the vertices that they are at exactly, with their names.
/// @return the id
std::string add_stroke(PerspectiveDrawing& drawing, StrokeShape shape, StrokeGroup group, StrokeRole role,
                       bool hidden = false);

/// Deletes strokes and what is known of their lengths. Unknown ids are left out. @return whether there were any
bool remove_strokes(PerspectiveDrawing& drawing, const std::vector<std::string>& ids);

/// Shifts whole strokes. Ends of other strokes that are at the same vertices come along.
void move_strokes(PerspectiveDrawing& drawing, const std::vector<std::string>& ids, const Vec2& by);

/// Points that people can drag: of a line its two ends, of a curve every control point, joints of pieces once.
std::vector<Vec2> points_of(const PerspectiveStroke& stroke);

/// Moves one of those points. An end takes all ends at its vertex along, unless it is moved alone, which parts it from
/// them; a joint its two handles; a handle at a smooth joint turns the other one.
/// @throws Error (E_INPUT) when there is no such stroke or point
void move_point(PerspectiveDrawing& drawing, std::string_view id, std::size_t point, const Vec2& by,
                bool alone = false);

/// The end nearest to a place, within reach, of strokes that have none at the vertex of an end; moved alone, of all
/// other strokes.
std::optional<DrawnEnd> nearest_other_end(const PerspectiveDrawing& drawing, const DrawnEnd& end, const Vec2& place,
                                          double reach, bool alone);

/// Moves an end onto the vertex of another one, with all that is at its own vertex: they are one vertex then.
void join_vertices(PerspectiveDrawing& drawing, const DrawnEnd& end, const DrawnEnd& with);

/// What dragging a point does: moves it, and where an end comes to another vertex (up to rounding), joins it with that.
/// @throws Error (E_INPUT) as move_point
void drag_point(PerspectiveDrawing& drawing, const std::string& id, std::size_t point, const Vec2& by, bool alone);

/// What people set of a stroke; what isn't given stays.
struct StrokeSetting {
  std::optional<StrokeGroup> group;
  std::optional<StrokeRole> role;
  std::map<std::string, std::variant<std::string, bool, EndLock, double>> fields;  ///< by the name in stroke_fields

  template <typename T>
  void set(T PerspectiveStroke::*member, const T& value) {
    for (const StrokeField& field : stroke_fields) {
      if (field.member == decltype(field.member)(member)) fields[field.name] = value;
    }
  }

  bool any() const { return group || role || !fields.empty(); }
  friend bool operator==(const StrokeSetting&, const StrokeSetting&) = default;
};

/// @throws Error (E_INPUT) when there is no such stroke
void set_strokes(PerspectiveDrawing& drawing, const std::vector<std::string>& ids, const StrokeSetting& setting);

/// The length of a stroke in space, or nothing known of it.
/// @throws Error (E_INPUT) when there is no such stroke or the length isn't above 0
void set_length(PerspectiveDrawing& drawing, const std::string& id, std::optional<double> length);

/// Turns lines of an axis about their middles so that they point to a place: construction lines, or where the axis has
/// none, those of its edges that meet no other stroke. @return whether there were any
bool aim_lines(PerspectiveDrawing& drawing, int axis, const Vec2& place);

}  // namespace croquis

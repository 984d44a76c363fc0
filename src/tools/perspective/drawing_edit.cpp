// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/tools/perspective/drawing_edit.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <utility>

#include "croquis/base/error.h"
#include "croquis/geometry/polyline.h"
#include "tools/pointer/segment_distance.h"

namespace croquis {
namespace {

template <typename Use>
bool any_part(const PerspectiveStroke& stroke, const Use& use) {
  const std::vector<Vec2> places = traced(stroke.pieces, stroke.straight);
  for (std::size_t i = 1; i < places.size(); ++i) {
    if (use(places[i - 1], places[i])) return true;
  }
  return false;
}

double distance_to(const PerspectiveStroke& stroke, const Vec2& place) {
  double least = (stroke.start() - place).norm();
  any_part(stroke, [&](const Vec2& a, const Vec2& b) {
    least = std::min(least, segment_distance(a, b, place, place));
    return false;
  });
  return least;
}

template <typename Test>
std::vector<std::string> ids_where(const PerspectiveDrawing& drawing, const Test& test) {
  std::vector<std::string> ids;
  for (const PerspectiveStroke& stroke : drawing.strokes) {
    if (test(stroke)) ids.push_back(stroke.id);
  }
  return ids;
}

/// The strokes one after the other, each from where the one before ended; empty when they don't make a loop.
std::vector<Vec2> loop_of(const PerspectiveDrawing& drawing, const std::vector<std::string>& ids) {
  std::vector<std::vector<Vec2>> parts;
  for (const std::string& id : ids) {
    const PerspectiveStroke* stroke = find_stroke(drawing, id);
    if (stroke == nullptr) return {};
    parts.push_back(traced(stroke->pieces, stroke->straight));
  }
  if (parts.empty()) return {};
  const double reach = 2 * vertex_reach(drawing);
  std::vector<Vec2> loop = std::move(parts.front());
  parts.erase(parts.begin());
  while (!parts.empty()) {
    const auto distance = [&](const std::vector<Vec2>& part) {
      return std::min((part.front() - loop.back()).norm(), (part.back() - loop.back()).norm());
    };
    const auto next = std::ranges::min_element(parts, {}, distance);
    if (distance(*next) > reach) return {};
    const bool reversed = (next->back() - loop.back()).norm() < (next->front() - loop.back()).norm();
    if (reversed) std::ranges::reverse(*next);
    loop.insert(loop.end(), next->begin() + 1, next->end());
    parts.erase(next);
  }
  return (loop.back() - loop.front()).norm() > reach ? std::vector<Vec2>() : loop;
}

constexpr double vertex_share = 0.0032;  // of the sheet's diagonal

/// Handles to both sides of a joint that differ in direction by less: the curve is smooth there.
constexpr double smooth_joint = 5 * 3.14159265358979 / 180;

/// Ends that are dragged onto a vertex are there up to rounding, px.
constexpr double joined_px = 1e-6;

PerspectiveStroke& stroke_of(PerspectiveDrawing& drawing, std::string_view id) {
  const auto found = std::ranges::find(drawing.strokes, id, &PerspectiveStroke::id);
  if (found != drawing.strokes.end()) return *found;
  const std::string name(id);
  throw Error(make_error(Category::Usage, "E_INPUT",
                         "The drawing has no stroke \"" + name + "\"; choose one of those it has.",
                         {{SubjectKind::Stroke, name, {}, {}, {}}}));
}

std::string& name_at(PerspectiveDrawing& drawing, const DrawnEnd& end) {
  PerspectiveStroke& stroke = drawing.strokes[end.stroke];
  return end.last ? stroke.to : stroke.from;
}

const std::string& name_at(const PerspectiveDrawing& drawing, const DrawnEnd& end) {
  const PerspectiveStroke& stroke = drawing.strokes[end.stroke];
  return end.last ? stroke.to : stroke.from;
}

void set_end(PerspectiveStroke& stroke, bool last, const Vec2& place) {
  StrokeShape shape{stroke.pieces, stroke.straight};
  const Vec2 other = last ? shape.start() : shape.end();
  stroke.pieces = with_ends(std::move(shape), last ? other : place, last ? place : other).pieces;
}

template <typename Use>
void each_end(const PerspectiveDrawing& drawing, const Use& use) {
  for (std::size_t i = 0; i < drawing.strokes.size(); ++i) {
    if (!has_vertices(drawing.strokes[i])) continue;
    use(DrawnEnd{i, false});
    use(DrawnEnd{i, true});
  }
}

template <typename Test>
std::optional<DrawnEnd> nearest_end_where(const PerspectiveDrawing& drawing, const Vec2& place, double reach,
                                          const Test& test) {
  std::optional<DrawnEnd> nearest;
  each_end(drawing, [&](const DrawnEnd& end) {
    const double distance = (place_of(drawing, end) - place).norm();
    if (distance > reach || (nearest && distance == reach) || !test(end)) return;
    reach = distance;
    nearest = end;
  });
  return nearest;
}

/// The handle on the other side of a smooth joint turns with this one and keeps its length.
void turn_other_handle(PerspectiveStroke& stroke, std::size_t point, const Vec2& before) {
  const bool after_joint = point % 3 == 1;
  const std::size_t piece = point / 3;
  if (after_joint ? piece == 0 : piece + 1 == stroke.pieces.size()) return;
  const Vec2 joint = after_joint ? stroke.pieces[piece][0] : stroke.pieces[piece][3];
  Vec2& other = after_joint ? stroke.pieces[piece - 1][2] : stroke.pieces[piece + 1][1];
  const Vec2 old_way = before - joint, other_way = joint - other;
  if (std::atan2(std::abs(cross(old_way, other_way)), old_way.dot(other_way)) > smooth_joint) return;
  const Vec2 way = stroke.pieces[piece][point % 3] - joint;
  if (way.norm() > 0) other = joint - other_way.norm() * way.normalized();
}

void move_inner_point(PerspectiveStroke& stroke, std::size_t point, const Vec2& by) {
  const std::size_t piece = point / 3;
  if (point % 3 != 0) {
    const Vec2 before = stroke.pieces[piece][point % 3];
    stroke.pieces[piece][point % 3] += by;
    turn_other_handle(stroke, point, before);
    return;
  }
  stroke.pieces[piece - 1][2] += by;
  stroke.pieces[piece - 1][3] += by;
  stroke.pieces[piece][0] = stroke.pieces[piece - 1][3];
  stroke.pieces[piece][1] += by;
}

std::size_t index_of(const PerspectiveDrawing& drawing, const PerspectiveStroke& stroke) {
  return static_cast<std::size_t>(&stroke - drawing.strokes.data());
}

}  // namespace

std::optional<std::string> nearest_stroke(const PerspectiveDrawing& drawing, const Vec2& place, double reach) {
  std::optional<std::string> nearest;
  for (const PerspectiveStroke& stroke : drawing.strokes) {
    const double distance = distance_to(stroke, place);
    if (distance > reach) continue;
    reach = distance;
    nearest = stroke.id;
  }
  return nearest;
}

std::optional<PickedPoint> nearest_point(const PerspectiveDrawing& drawing, const std::vector<std::string>& ids,
                                         const Vec2& place, double reach) {
  std::optional<PickedPoint> nearest;
  for (const bool ends : {true, false}) {
    for (const std::string& id : ids) {
      const PerspectiveStroke* stroke = find_stroke(drawing, id);
      if (stroke == nullptr) continue;
      const std::vector<Vec2> points = points_of(*stroke);
      for (std::size_t k = 0; k < points.size(); ++k) {
        const bool is_end = k == 0 || k + 1 == points.size();
        const double distance = (points[k] - place).norm();
        if (is_end != ends || distance > reach || (nearest && distance == reach)) continue;
        reach = distance;
        nearest = PickedPoint{id, k};
      }
    }
  }
  return nearest;
}

std::vector<std::string> strokes_in_box(const PerspectiveDrawing& drawing, const PickBox& box) {
  return ids_where(drawing, [&](const PerspectiveStroke& stroke) {
    return any_part(stroke, [&](const Vec2& a, const Vec2& b) { return meets_box(a, b, box); });
  });
}

std::vector<std::string> strokes_touched(const PerspectiveDrawing& drawing, const Vec2& from, const Vec2& to,
                                         double radius) {
  return ids_where(drawing, [&](const PerspectiveStroke& stroke) {
    return any_part(stroke, [&](const Vec2& a, const Vec2& b) { return segment_distance(a, b, from, to) <= radius; });
  });
}

std::optional<std::size_t> face_at(const PerspectiveDrawing& drawing,
                                   const std::vector<std::vector<std::string>>& loops, const Vec2& place) {
  std::optional<std::size_t> smallest;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < loops.size(); ++i) {
    const std::vector<Vec2> loop = loop_of(drawing, loops[i]);
    const double area = std::abs(signed_area(loop));
    if (!encloses(loop, place) || area >= least) continue;
    least = area;
    smallest = i;
  }
  return smallest;
}

double vertex_reach(const PerspectiveDrawing& drawing) { return vertex_share * drawing.diagonal(); }

const PerspectiveStroke* find_stroke(const PerspectiveDrawing& drawing, std::string_view id) {
  const auto found = std::ranges::find(drawing.strokes, id, &PerspectiveStroke::id);
  return found == drawing.strokes.end() ? nullptr : &*found;
}

std::string new_stroke_id(const PerspectiveDrawing& drawing) {
  unsigned long highest = 0;
  for (const PerspectiveStroke& stroke : drawing.strokes) {
    unsigned long number = 0;
    const char* end = stroke.id.data() + stroke.id.size();
    if (stroke.id.size() < 2 || stroke.id[0] != 's') continue;
    const auto read = std::from_chars(stroke.id.data() + 1, end, number);
    if (read.ec == std::errc() && read.ptr == end && number < 1'000'000'000) highest = std::max(highest, number);
  }
  return "s" + std::to_string(highest + 1);
}

bool has_vertices(const PerspectiveStroke& stroke) { return stroke.role == StrokeRole::Edge || stroke.link; }

const Vec2& place_of(const PerspectiveDrawing& drawing, const DrawnEnd& end) {
  const PerspectiveStroke& stroke = drawing.strokes[end.stroke];
  return end.last ? stroke.end() : stroke.start();
}

std::optional<DrawnEnd> nearest_end(const PerspectiveDrawing& drawing, const Vec2& place, double reach) {
  return nearest_end_where(drawing, place, reach, [](const DrawnEnd&) { return true; });
}

std::vector<DrawnEnd> ends_at_vertex(const PerspectiveDrawing& drawing, const DrawnEnd& end) {
  std::vector<DrawnEnd> ends = {end};
  const std::string& name = name_at(drawing, end);
  const double reach = vertex_reach(drawing);
  each_end(drawing, [&](const DrawnEnd& other) {
    if (other.stroke == end.stroke) return;  // the two ends of one stroke are never one vertex
    const std::string& other_name = name_at(drawing, other);
    const bool named = !name.empty() && other_name == name;
    const bool may = name.empty() || other_name.empty();
    if (named || (may && (place_of(drawing, other) - place_of(drawing, end)).norm() <= reach)) ends.push_back(other);
  });
  return ends;
}

std::vector<Vec2> vertices_of(const PerspectiveDrawing& drawing) {
  std::vector<Vec2> places;
  std::vector<bool> seen(2 * drawing.strokes.size(), false);
  const auto number = [](const DrawnEnd& end) { return 2 * end.stroke + (end.last ? 1 : 0); };
  each_end(drawing, [&](const DrawnEnd& end) {
    if (seen[number(end)]) return;
    Vec2 sum = Vec2::Zero();
    const std::vector<DrawnEnd> ends = ends_at_vertex(drawing, end);
    for (const DrawnEnd& one : ends) {
      seen[number(one)] = true;
      sum += place_of(drawing, one);
    }
    places.push_back(sum / static_cast<double>(ends.size()));
  });
  return places;
}

std::string add_stroke(PerspectiveDrawing& drawing, StrokeShape shape, StrokeGroup group, StrokeRole role,
                       bool hidden) {
  PerspectiveStroke stroke;
  stroke.id = new_stroke_id(drawing);
  stroke.role = role;
  stroke.group = group;
  stroke.hidden = hidden;
  stroke.pieces = std::move(shape.pieces);
  stroke.straight = shape.straight;
  if (has_vertices(stroke)) {
    if (const auto end = nearest_end(drawing, stroke.start(), 0)) stroke.from = name_at(drawing, *end);
    if (const auto end = nearest_end(drawing, stroke.end(), 0)) stroke.to = name_at(drawing, *end);
  }
  drawing.strokes.push_back(std::move(stroke));
  return drawing.strokes.back().id;
}

bool remove_strokes(PerspectiveDrawing& drawing, const std::vector<std::string>& ids) {
  const auto named = [&](const std::string& id) { return std::ranges::find(ids, id) != ids.end(); };
  std::erase_if(drawing.known_lengths, [&](const KnownLength& known) { return named(known.stroke); });
  return std::erase_if(drawing.strokes, [&](const PerspectiveStroke& stroke) { return named(stroke.id); }) > 0;
}

void move_strokes(PerspectiveDrawing& drawing, const std::vector<std::string>& ids, const Vec2& by) {
  std::vector<bool> whole(drawing.strokes.size(), false);
  for (const std::string& id : ids) whole[index_of(drawing, stroke_of(drawing, id))] = true;
  std::vector<DrawnEnd> along;
  for (std::size_t i = 0; i < whole.size(); ++i) {
    if (!whole[i] || !has_vertices(drawing.strokes[i])) continue;
    for (const bool last : {false, true}) {
      for (const DrawnEnd& end : ends_at_vertex(drawing, {i, last})) {
        if (!whole[end.stroke] && std::ranges::find(along, end) == along.end()) along.push_back(end);
      }
    }
  }
  for (std::size_t i = 0; i < whole.size(); ++i) {
    if (!whole[i]) continue;
    for (PictureCubic& piece : drawing.strokes[i].pieces) {
      for (Vec2& point : piece) point += by;
    }
  }
  for (const DrawnEnd& end : along) set_end(drawing.strokes[end.stroke], end.last, place_of(drawing, end) + by);
}

std::vector<Vec2> points_of(const PerspectiveStroke& stroke) {
  if (stroke.straight) return {stroke.start(), stroke.end()};
  std::vector<Vec2> points = {stroke.start()};
  for (const PictureCubic& piece : stroke.pieces) points.insert(points.end(), piece.begin() + 1, piece.end());
  return points;
}

void move_point(PerspectiveDrawing& drawing, std::string_view id, std::size_t point, const Vec2& by, bool alone) {
  PerspectiveStroke& stroke = stroke_of(drawing, id);
  const std::size_t count = points_of(stroke).size();
  if (point >= count) {
    throw Error(make_error(Category::Usage, "E_INPUT",
                           "Stroke \"" + stroke.id + "\" has " + std::to_string(count) + " points and no point " +
                               std::to_string(point) + "; choose one of those it has.",
                           {{SubjectKind::Stroke, stroke.id, {}, {}, {}}}));
  }
  if (point > 0 && point + 1 < count) {
    move_inner_point(stroke, point, by);
    return;
  }
  const DrawnEnd end{index_of(drawing, stroke), point > 0};
  if (alone || !has_vertices(stroke)) {
    set_end(stroke, end.last, place_of(drawing, end) + by);
    if (alone) name_at(drawing, end).clear();
    return;
  }
  for (const DrawnEnd& one : ends_at_vertex(drawing, end))
    set_end(drawing.strokes[one.stroke], one.last, place_of(drawing, one) + by);
}

std::optional<DrawnEnd> nearest_other_end(const PerspectiveDrawing& drawing, const DrawnEnd& end, const Vec2& place,
                                          double reach, bool alone) {
  std::vector<bool> own(drawing.strokes.size(), false);
  own[end.stroke] = true;
  for (const DrawnEnd& one : alone ? std::vector<DrawnEnd>() : ends_at_vertex(drawing, end)) own[one.stroke] = true;
  return nearest_end_where(drawing, place, reach, [&](const DrawnEnd& one) { return !own[one.stroke]; });
}

void join_vertices(PerspectiveDrawing& drawing, const DrawnEnd& end, const DrawnEnd& with) {
  const Vec2 place = place_of(drawing, with);
  const std::string name = name_at(drawing, with).empty() ? name_at(drawing, end) : name_at(drawing, with);
  std::vector<DrawnEnd> ends = ends_at_vertex(drawing, end);
  for (const DrawnEnd& one : ends_at_vertex(drawing, with)) ends.push_back(one);
  for (const DrawnEnd& one : ends) {
    set_end(drawing.strokes[one.stroke], one.last, place);
    name_at(drawing, one) = name;
  }
}

void drag_point(PerspectiveDrawing& drawing, const std::string& id, std::size_t point, const Vec2& by, bool alone) {
  const PerspectiveDrawing before = drawing;
  move_point(drawing, id, point, by, alone);
  const PerspectiveStroke& stroke = stroke_of(drawing, id);
  const bool is_end = point == 0 || point + 1 == points_of(stroke).size();
  if (!is_end || !has_vertices(stroke)) return;
  const DrawnEnd end{index_of(drawing, stroke), point != 0};
  const auto other = nearest_other_end(before, end, place_of(drawing, end), joined_px, alone);
  if (other) join_vertices(drawing, end, *other);
}

void set_strokes(PerspectiveDrawing& drawing, const std::vector<std::string>& ids, const StrokeSetting& setting) {
  for (const std::string& id : ids) {
    PerspectiveStroke& stroke = stroke_of(drawing, id);
    if (setting.group) {
      stroke.group = *setting.group;
      stroke.colour.clear();
      if (is_parallel(stroke.group) && !stroke.straight) {
        stroke.pieces = {line_piece(stroke.start(), stroke.end())};
        stroke.straight = true;
      }
    }
    if (setting.role) stroke.role = *setting.role;
    for (const StrokeField& field : stroke_fields) {
      const auto given = setting.fields.find(field.name);
      if (given == setting.fields.end()) continue;
      std::visit([&]<typename T>(T PerspectiveStroke::*member) { stroke.*member = std::get<T>(given->second); },
                 field.member);
    }
  }
}

void set_length(PerspectiveDrawing& drawing, const std::string& id, std::optional<double> length) {
  stroke_of(drawing, id);
  if (length && !(*length > 0 && std::isfinite(*length))) {
    throw Error(make_error(Category::Usage, "E_INPUT", "A stroke's length is a number above 0; type another one.",
                           {{SubjectKind::Stroke, id, {}, {}, {}}}));
  }
  std::erase_if(drawing.known_lengths, [&](const KnownLength& known) { return known.stroke == id; });
  if (length) drawing.known_lengths.push_back({id, *length});
}

bool aim_lines(PerspectiveDrawing& drawing, int axis, const Vec2& place) {
  std::vector<std::size_t> construction, loose;
  for (std::size_t i = 0; i < drawing.strokes.size(); ++i) {
    const PerspectiveStroke& stroke = drawing.strokes[i];
    if (!is_parallel(stroke.group) || axis_of(stroke.group) != axis || !stroke.straight) continue;
    if (!has_vertices(stroke)) construction.push_back(i);
    const bool meets = ends_at_vertex(drawing, {i, false}).size() > 1 || ends_at_vertex(drawing, {i, true}).size() > 1;
    if (has_vertices(stroke) && !meets) loose.push_back(i);
  }
  const std::vector<std::size_t>& lines = construction.empty() ? loose : construction;
  for (const std::size_t i : lines) {
    PerspectiveStroke& stroke = drawing.strokes[i];
    const Vec2 middle = (stroke.start() + stroke.end()) / 2;
    const Vec2 half = (stroke.end() - stroke.start()) / 2;
    Vec2 way = place - middle;
    if (way.norm() == 0) continue;
    way *= half.norm() / way.norm();
    if (way.dot(half) < 0) way = -way;
    stroke.pieces = {line_piece(middle - way, middle + way)};
  }
  return !lines.empty();
}

}  // namespace croquis

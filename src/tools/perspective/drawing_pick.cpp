// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/tools/perspective/drawing_pick.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "croquis/geometry/polyline.h"
#include "croquis/tools/perspective/drawing_edit.h"
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

}  // namespace croquis

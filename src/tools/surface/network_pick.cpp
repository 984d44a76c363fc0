// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/tools/surface/network_pick.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "croquis/attribute_surface/arc_length_curve.h"
#include "croquis/geometry/polyline.h"
#include "tools/pointer/segment_distance.h"

namespace croquis {
namespace {

constexpr double edge_on = 3 * std::numbers::pi / 180;  // a plane seen flatter than that can't be pointed at
constexpr double too_flat = 15 * std::numbers::pi / 180;

constexpr std::size_t seen_parts = 48;  // of a curve
constexpr double as_near_pixels = 1.5;  // what differs by less is ordered by depth

/// Keeps the nearest candidate: in the view, and of those about as near there the one before the others.
class NearestSeen {
 public:
  NearestSeen(const ViewFrame& frame, const Vec2& pixel, double reach) : frame_(frame), pixel_(pixel), reach_(reach) {}

  /// @return whether the place is the nearest one by now
  bool offer(const Vec3& place) {
    const auto seen = frame_.project(place);
    if (!seen) return false;
    const double pixels = (seen->pixel - pixel_).norm();
    if (pixels > reach_) return false;
    const bool clearly = pixels < pixels_ - as_near_pixels;
    const bool before = pixels < pixels_ + as_near_pixels && seen->depth < depth_;
    if (found_ && !clearly && !before) return false;
    found_ = true;
    pixels_ = pixels;
    depth_ = seen->depth;
    return true;
  }

  double pixels() const { return pixels_; }

 private:
  const ViewFrame& frame_;
  Vec2 pixel_;
  double reach_;
  bool found_ = false;
  double pixels_ = 0;
  double depth_ = 0;
};

/// The place of a polyline that is seen nearest to a pixel, as a parameter 0..1 of the whole.
struct SeenPlace {
  double parameter = 0;
  double pixels = 0;
};

std::optional<SeenPlace> nearest_seen(const std::vector<Vec3>& places, const ViewFrame& frame, const Vec2& pixel) {
  std::optional<SeenPlace> nearest;
  const auto parts = static_cast<double>(places.size() - 1);
  for (std::size_t i = 0; i + 1 < places.size(); ++i) {
    const auto a = frame.project(places[i]);
    const auto b = frame.project(places[i + 1]);
    if (!a || !b) continue;
    const double share = nearest_parameter(pixel, a->pixel, b->pixel);
    const double pixels = (a->pixel + share * (b->pixel - a->pixel) - pixel).norm();
    if (!nearest || pixels < nearest->pixels) nearest = SeenPlace{(static_cast<double>(i) + share) / parts, pixels};
  }
  return nearest;
}

std::vector<Vec3> places_along(const std::vector<Vec3>& control) {
  std::vector<Vec3> places;
  for (std::size_t i = 0; i <= seen_parts; ++i)
    places.push_back(bezier_point(control, static_cast<double>(i) / static_cast<double>(seen_parts)));
  return places;
}

bool curve_in_box(const std::vector<Vec3>& places, const ViewFrame& frame, const PickBox& box) {
  for (std::size_t i = 0; i + 1 < places.size(); ++i) {
    const auto a = frame.project(places[i]);
    const auto b = frame.project(places[i + 1]);
    if (a && b && meets_box(a->pixel, b->pixel, box)) return true;
  }
  return false;
}

}  // namespace

std::optional<Vec3> place_on(const SpacePlane& plane, const ViewFrame& frame, const Vec2& pixel) {
  const Ray sight = frame.sight(pixel);
  const Vec3 normal = plane.normal.normalized();
  const double slant = sight.direction.dot(normal);
  if (std::abs(slant) < std::sin(edge_on)) return std::nullopt;
  const double along = (plane.point - sight.origin).dot(normal) / slant;
  const Vec3 place = sight.at(along);
  if (frame.perspective() && (along <= 0 || !frame.project(place))) return std::nullopt;
  return place.allFinite() ? std::optional(place) : std::nullopt;
}

SpacePlane view_plane(const ViewFrame& frame, const Vec3& place) {
  return {place, frame.right().cross(frame.up()).normalized()};
}

SpacePlane plane_through(const ViewFrame& frame, const Vec3& a, const Vec3& b) {
  const Vec3 chord = b - a;
  const Vec3 to_eye = frame.to_eye((a + b) / 2);
  const Vec3 across = to_eye - chord * (chord.dot(to_eye) / std::max(chord.squaredNorm(), 1e-300));
  if (!(chord.norm() > 0) || across.norm() < std::sin(edge_on)) return view_plane(frame, a);
  return {a, across.normalized()};
}

SpacePlane ground_or_view(const ViewFrame& frame, const SpacePlane& ground) {
  const Vec2 middle = frame.size / 2;
  const Ray sight = frame.sight(middle);
  const Vec3 normal = ground.normal.normalized();
  if (std::abs(sight.direction.dot(normal)) >= std::sin(too_flat)) return ground;
  return view_plane(frame, ground.point);
}

std::optional<PickedPlace> nearest_node(const AttributeNetwork& network, const ViewFrame& frame, const Vec2& pixel,
                                        double reach) {
  std::optional<PickedPlace> picked;
  NearestSeen nearest(frame, pixel, reach);
  for (const AttributeNode& node : network.nodes) {
    if (nearest.offer(node.point)) picked = {NetworkElement::Node, node.id, {}, 0, node.point, nearest.pixels()};
  }
  return picked;
}

std::optional<PickedPlace> nearest_handle(const AttributeNetwork& network, const std::vector<std::string>& curves,
                                          const ViewFrame& frame, const Vec2& pixel, double reach) {
  std::optional<PickedPlace> picked;
  NearestSeen nearest(frame, pixel, reach);
  for (const std::string& id : curves) {
    const Index index = find_element(network, NetworkElement::Curve, id);
    if (index == no_index) continue;
    const AttributeCurve& curve = network.curves[index];
    const std::vector<Vec3> control = control_handles(network, curve);
    for (std::size_t j = 0; j < control.size(); ++j) {
      const bool at_node = (j == 0 && curve.from != no_index) || (j + 1 == control.size() && curve.to != no_index);
      if (!at_node && nearest.offer(control[j]))
        picked = {NetworkElement::Curve, id, j, 0, control[j], nearest.pixels()};
    }
  }
  return picked;
}

std::optional<PickedPlace> nearest_curve(const AttributeNetwork& network, const ViewFrame& frame, const Vec2& pixel,
                                         double reach) {
  std::optional<PickedPlace> picked;
  double parameter = 0;
  NearestSeen nearest(frame, pixel, reach);
  for (const AttributeCurve& curve : network.curves) {
    const std::vector<Vec3> control = control_polygon(network, curve);
    const auto seen = nearest_seen(places_along(control), frame, pixel);
    if (!seen || seen->pixels > reach) continue;
    const Vec3 place = bezier_point(control, seen->parameter);
    if (!nearest.offer(place)) continue;
    picked = {NetworkElement::Curve, curve.id, {}, 0, place, nearest.pixels()};
    parameter = seen->parameter;
  }
  if (!picked) return picked;
  const Index index = find_element(network, NetworkElement::Curve, picked->id);
  const std::vector<Vec3> control = control_polygon(network, network.curves[index]);
  if (bezier_length(control) > 0) picked->at = ArcLengthCurve(control).fraction(parameter);
  return picked;
}

std::optional<PickedPlace> nearest_point_attribute(const AttributeNetwork& network, const ViewFrame& frame,
                                                   const Vec2& pixel, double reach) {
  std::optional<PickedPlace> picked;
  NearestSeen nearest(frame, pixel, reach);
  for (const PointAttribute& point : network.points) {
    if (nearest.offer(point.point)) picked = {NetworkElement::Point, point.id, {}, 0, point.point, nearest.pixels()};
  }
  return picked;
}

NetworkElements elements_in_box(const AttributeNetwork& network, const ViewFrame& frame, const PickBox& box) {
  NetworkElements found;
  const auto seen_inside = [&](const Vec3& place) {
    const auto seen = frame.project(place);
    return seen && box.has(seen->pixel);
  };
  for (const AttributeNode& node : network.nodes) {
    if (seen_inside(node.point)) found.nodes.push_back(node.id);
  }
  for (const AttributeCurve& curve : network.curves) {
    if (curve_in_box(places_along(control_polygon(network, curve)), frame, box)) found.curves.push_back(curve.id);
  }
  for (const PointAttribute& point : network.points) {
    if (seen_inside(point.point)) found.points.push_back(point.id);
  }
  return found;
}

std::vector<ViewedCurve> viewed_curves(const AttributeNetwork& network, const ViewFrame& frame) {
  std::vector<ViewedCurve> views;
  const Vec3 forward = -frame.right().cross(frame.up());
  for (const AttributeCurve& curve : network.curves) {
    ViewedCurve view;
    for (const Vec3& place : places_along(control_polygon(network, curve))) {
      const auto seen = frame.project(place);
      if (!seen) break;
      view.places.push_back(seen->pixel);
      view.depths.push_back(place.dot(forward));
    }
    views.push_back(view.places.size() == seen_parts + 1 ? view : ViewedCurve());
  }
  return views;
}

}  // namespace croquis

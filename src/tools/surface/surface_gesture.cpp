// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/surface/surface_gesture.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include <Eigen/Geometry>

#include "croquis/geometry/polyline.h"

namespace croquis {
namespace {

constexpr double most_samples = 0.6;      // share of a stroke's samples that must lie over what it is drawn on
constexpr double curve_snap_share = 0.7;  // × the reach of nodes: curves are everywhere, and nodes come first
constexpr double on_ground = 1e-6;        // × the network's size: so near to the ground is on it

constexpr double seen_from_the_front = 0.25;  // sine between a line and the view's direction: below, places along the
                                              // line can't be distinguished by a pointer

/// 1 for a plane seen straight on, less the flatter it is seen: there a pen that is a pixel off goes far.
double slant_of(const SpacePlane& plane, const ViewFrame& frame, const Vec3& place) {
  constexpr double flattest = 0.25;
  return std::max(flattest, std::abs(frame.to_eye(place).dot(plane.normal.normalized())));
}

/// Where a stroke begins on nothing it is drawn on the patch under its beginning; else on the one under most of it.
/// Empty for none.
std::string face_drawn_on(const SurfaceGesture& gesture) {
  const auto& samples = gesture.stroke;
  if (!gesture.from) return samples.front().patch ? samples.front().patch->face : std::string();
  std::map<std::string, std::size_t> counts;
  for (const auto& sample : samples) {
    if (sample.patch) ++counts[sample.patch->face];
  }
  for (const auto& [face, count] : counts) {
    if (static_cast<double>(count) > most_samples * static_cast<double>(samples.size())) return face;
  }
  return {};
}

bool draws_on_mesh(const SurfaceGesture& gesture) {
  if (!gesture.from) return gesture.stroke.front().mesh.has_value();
  const auto count = std::ranges::count_if(gesture.stroke, [](const auto& sample) { return sample.mesh.has_value(); });
  return static_cast<double>(count) > most_samples * static_cast<double>(gesture.stroke.size());
}

SpacePlane plane_for(const SurfaceGesture& gesture, const SurfaceSettings& settings, const AttributeNetwork& network,
                     const std::optional<SurfaceSnap>& end) {
  const ViewFrame& frame = gesture.start.frame;
  const std::optional<SurfaceSnap>& from = gesture.from;
  const bool is_chosen = settings.plane == SurfacePlane::Chosen;
  SpacePlane wanted = is_chosen ? settings.chosen : settings.ground;
  const BoundingBox box = bounds_of(network);
  const double size = box ? ((*box)[1] - (*box)[0]).norm() : 1;
  const auto lies_on = [&](const SpacePlane& plane, const std::optional<SurfaceSnap>& snap) {
    return !snap || std::abs((snap->place - plane.point).dot(plane.normal.normalized())) <= on_ground * size;
  };
  if (settings.plane == SurfacePlane::View)
    wanted = view_plane(frame, box ? Vec3(((*box)[0] + (*box)[1]) / 2) : settings.ground.point);
  if (settings.plane == SurfacePlane::Ground) wanted = ground_or_view(frame, settings.ground);
  if (lies_on(wanted, from) && lies_on(wanted, end)) return wanted;
  if (from && end && from->end != end->end) return plane_through(frame, from->place, end->place);
  const Vec3 through = from ? from->place : end->place;
  return is_chosen ? SpacePlane{through, settings.chosen.normal} : view_plane(frame, through);
}

/// The stroke on a patch, or with an empty face on a mesh; where it leaves that it goes on across the view.
std::vector<Vec3> places_over(const SurfaceGesture& gesture, const std::string& face) {
  const auto place_of = [&](const SurfaceGesture::Sample& sample) -> std::optional<Vec3> {
    if (face.empty()) return sample.mesh;
    return sample.patch && sample.patch->face == face ? std::optional(sample.patch->point) : std::nullopt;
  };
  const ViewFrame& frame = gesture.start.frame;
  std::optional<Vec3> last;
  for (const auto& sample : gesture.stroke) {
    last = place_of(sample);
    if (last) break;
  }
  std::vector<Vec3> places;
  for (const auto& sample : gesture.stroke) {
    auto place = place_of(sample);
    if (!place && last) place = place_on(view_plane(frame, *last), frame, sample.pixel);
    if (!place) continue;
    last = place;
    places.push_back(*place);
  }
  return places;
}

// ---- Drags

/// Parameter along a line where it comes nearest to what is seen at a pixel, model units.
double nearest_along(const Vec3& place, const Vec3& direction, const Ray& sight) {
  const double cosine = direction.dot(sight.direction);
  const Vec3 offset = sight.origin - place;
  return (offset.dot(direction) - cosine * offset.dot(sight.direction)) / (1 - cosine * cosine);
}

/// How far the pointer has gone, in the plane across the view through a place.
Vec3 way_across(const SurfaceGesture& gesture, const Vec3& place) {
  const ViewFrame& frame = gesture.start.frame;
  const SpacePlane plane = view_plane(frame, place);
  const auto from = place_on(plane, frame, gesture.start.pixel);
  const auto to = place_on(plane, frame, gesture.last);
  return from && to ? Vec3(*to - *from) : Vec3(Vec3::Zero());
}

/// How far the pointer has gone along a normal; one seen from its tip grows upwards.
Vec3 way_along(const SurfaceGesture& gesture, const Vec3& place, const Vec3& normal) {
  const ViewFrame& frame = gesture.start.frame;
  const Vec3 to_eye = frame.to_eye(place);
  if (to_eye.cross(normal).norm() > seen_from_the_front) {
    const double from = nearest_along(place, normal, frame.sight(gesture.start.pixel));
    return (nearest_along(place, normal, frame.sight(gesture.last)) - from) * normal;
  }
  const double up = (gesture.start.pixel.y() - gesture.last.y()) * frame.units_per_pixel(place);
  return (normal.dot(to_eye) < 0 ? -up : up) * normal;
}

/// The node that a single node would be merged into.
std::optional<PickedPlace> node_to_join(const SurfaceGesture& gesture, double snap) {
  const NetworkElements& moving = gesture.moving;
  const bool alone = moving.nodes.size() == 1 && moving.curves.empty() && moving.faces.empty() && moving.points.empty();
  if (!alone) return std::nullopt;
  AttributeNetwork others = *gesture.original;
  const Index own = require_element(others, NetworkElement::Node, moving.nodes.front());
  others.nodes.erase(others.nodes.begin() + static_cast<std::ptrdiff_t>(own));
  return nearest_node(others, gesture.start.frame, gesture.last, snap);
}

recorded::SurfaceDrag moved_elements(const SurfaceGesture& gesture, const SurfaceSight* sight, double snap) {
  const NetworkElements& moving = gesture.moving;
  const PickedPlace& picked = *gesture.picked;
  const bool along_normal = moving.nodes.empty() && moving.curves.empty() && moving.faces.empty() && sight != nullptr &&
                            !gesture.start.modifiers.ctrl;
  const auto normal = along_normal ? sight->normal_at(picked.id) : std::nullopt;
  if (const auto join = node_to_join(gesture, snap)) return {moving, {}, join->place - picked.place, join->id};
  return {moving, {}, normal ? way_along(gesture, picked.place, *normal) : way_across(gesture, picked.place), {}};
}

recorded::SurfaceSlope dragged_slope(const SurfaceGesture& gesture) {
  const SlopeTip& tip = *gesture.tip;
  const SlopeFrame& frame = tip.frame;
  const Vec3 along = frame.inward.cross(frame.normal);
  Vec3 arm = tip.tip + way_across(gesture, tip.tip) - frame.point;
  arm -= along * along.dot(arm);
  const double length = arm.norm();
  SlopeHandle handle{tip.at, frame.normal, tip.magnitude};
  if (length > 1e-6 * frame.length) handle = {tip.at, Vec3(along.cross(arm / length)), length / frame.length};
  return {tip.side, handle};
}

recorded::SurfacePointSetting dragged_ring(const SurfaceGesture& gesture, const SurfaceSight& sight) {
  const AttributeNetwork& original = *gesture.original;
  const PointAttribute& point = original.points[require_element(original, NetworkElement::Point, gesture.ring)];
  const auto centre = gesture.start.frame.project(point.point);
  const double before = sight.radius_of(gesture.ring).value_or(point.radius.value_or(1));
  const double from = centre ? (gesture.start.pixel - centre->pixel).norm() : 0;
  const double to = centre ? (gesture.last - centre->pixel).norm() : 0;
  PointSetting setting;
  setting.radius = std::optional(point.radius.value_or(before) * (from > 0 ? std::max(to / from, 1e-3) : 1));
  return {{gesture.ring}, setting};
}

recorded::SurfacePoint pulled_point(const SurfaceGesture& gesture) {
  const SurfaceHit& hit = *gesture.hit;
  NewPoint point{hit.face, hit.point, hit.fan, {}, {}};
  point.point +=
      gesture.start.modifiers.ctrl ? way_across(gesture, hit.point) : way_along(gesture, hit.point, hit.normal);
  return {point};
}

}  // namespace

std::optional<SurfaceSnap> snap_at(const AttributeNetwork& network, const ViewFrame& frame, const Vec2& pixel,
                                   double reach) {
  if (const auto node = nearest_node(network, frame, pixel, reach)) return SurfaceSnap{{node->id, {}, 0}, node->place};
  const auto curve = nearest_curve(network, frame, pixel, curve_snap_share * reach);
  if (!curve) return std::nullopt;
  const AttributeCurve& found = network.curves[require_element(network, NetworkElement::Curve, curve->id)];
  if (found.from == no_index || found.to == no_index) return std::nullopt;  // inner curves have no nodes to share
  return SurfaceSnap{{{}, curve->id, curve->at}, curve->place};
}

void add_sample(SurfaceGesture& gesture, const SurfaceSight* sight) {
  SurfaceGesture::Sample sample{gesture.last, {}, {}};
  if (sight != nullptr && !gesture.start.modifiers.ctrl) {
    const Ray ray = gesture.start.frame.ray(gesture.last);
    sample.patch = sight->patch_under(ray);
    const auto mesh = sight->mesh_under(ray);
    if (mesh && (!sample.patch || mesh->distance < sample.patch->distance)) {
      sample.mesh = mesh->point;
      sample.patch.reset();
    }
  }
  gesture.stroke.push_back(std::move(sample));
}

StrokeInSpace stroke_in_space(const SurfaceGesture& gesture, const SurfaceSettings& settings,
                              const AttributeNetwork& network, const std::optional<SurfaceSnap>& end) {
  StrokeInSpace stroke;
  stroke.face = face_drawn_on(gesture);
  if (!stroke.face.empty() || draws_on_mesh(gesture)) {
    stroke.points = places_over(gesture, stroke.face);
    return stroke;
  }
  stroke.plane = plane_for(gesture, settings, network, end);
  for (const auto& sample : gesture.stroke) {
    if (const auto place = place_on(*stroke.plane, gesture.start.frame, sample.pixel)) stroke.points.push_back(*place);
  }
  return stroke;
}

std::optional<recorded::SurfaceStroke> stroke_step(const SurfaceGesture& gesture, const StrokeInSpace& stroke,
                                                   const std::optional<SurfaceSnap>& end) {
  if (stroke.points.size() < 2) return std::nullopt;
  const ViewFrame& frame = gesture.start.frame;
  const Vec3& first = stroke.points.front();
  const double slant = stroke.plane ? slant_of(*stroke.plane, frame, first) : 1;
  recorded::SurfaceStroke step{stroke.points, frame.units_per_pixel(first) / slant, {}, {}, stroke.face};
  if (gesture.from) step.start = gesture.from->end;
  if (end) step.end = end->end;
  return step.unit > 0 ? std::optional(step) : std::nullopt;
}

std::vector<ControlHandle> free_handles(const AttributeNetwork& network, const std::vector<std::string>& curves) {
  std::vector<ControlHandle> handles;
  for (const std::string& id : curves) {
    const AttributeCurve& curve = network.curves[require_element(network, NetworkElement::Curve, id)];
    const std::size_t count = control_handles(network, curve).size();
    for (std::size_t j = 0; j < count; ++j) {
      const bool at_node = (j == 0 && curve.from != no_index) || (j + 1 == count && curve.to != no_index);
      if (!at_node) handles.push_back({id, j});
    }
  }
  return handles;
}

std::vector<SlopeTip> slope_tips(const AttributeNetwork& network, const std::string& curve, const SurfaceSight& sight) {
  std::vector<SlopeTip> tips;
  for (const Index face : faces_along(network, require_element(network, NetworkElement::Curve, curve))) {
    const std::string& patch = network.faces[face].id;
    SlopeTip tip;
    tip.side = {curve, patch};
    Index slope = find_slope(network, tip.side);
    if (slope == no_index) slope = find_slope(network, {curve, {}});
    if (slope != no_index) {
      const SlopeAttribute& set = network.slopes[slope];
      if (set.face == no_index) tip.side.face.clear();
      tip.at = *std::ranges::min_element(set.at, {}, [](double at) { return std::abs(at - 0.5); });
      tip.magnitude = set.magnitude;
      tip.automatic = false;
    }
    const auto frame = sight.slope_at(patch, curve, tip.at);
    if (!frame) continue;
    tip.frame = *frame;
    tip.tip = frame->point + tip.magnitude * frame->length * frame->inward;
    tips.push_back(tip);
  }
  return tips;
}

std::optional<SlopeTip> nearest_tip(const std::vector<SlopeTip>& tips, const ViewFrame& frame, const Vec2& pixel,
                                    double reach) {
  std::optional<SlopeTip> nearest;
  for (const SlopeTip& tip : tips) {
    const auto seen = frame.project(tip.tip);
    if (!seen || (seen->pixel - pixel).norm() > reach) continue;
    reach = (seen->pixel - pixel).norm();
    nearest = tip;
  }
  return nearest;
}

bool passes(const std::vector<Vec3>& ring, const ViewFrame& frame, const Vec2& pixel, double reach) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const auto a = frame.project(ring[i]);
    const auto b = frame.project(ring[(i + 1) % ring.size()]);
    if (!a || !b) continue;
    const double share = nearest_parameter(pixel, a->pixel, b->pixel);
    if ((a->pixel + share * (b->pixel - a->pixel) - pixel).norm() <= reach) return true;
  }
  return false;
}

recorded::Step dragged_step(const SurfaceGesture& gesture, const SurfaceSight* sight, double snap) {
  switch (gesture.kind) {
    case SurfaceGesture::Kind::Slope: return dragged_slope(gesture);
    case SurfaceGesture::Kind::Ring: return dragged_ring(gesture, *sight);
    case SurfaceGesture::Kind::Pull: return pulled_point(gesture);
    case SurfaceGesture::Kind::Handle: {
      const PickedPlace& picked = *gesture.picked;
      const ControlHandle handle{picked.id, *picked.control};
      return recorded::SurfaceDrag{{}, handle, way_across(gesture, picked.place), {}};
    }
    default: return moved_elements(gesture, sight, snap);
  }
}

}  // namespace croquis

// SPDX-License-Identifier: GPL-3.0-or-later
// What drags of elements, handles, slopes, rings and points do.
#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Geometry>

#include "croquis/geometry/polyline.h"
#include "croquis/tools/surface/surface_tool.h"
#include "tools/surface/surface_words.h"

namespace croquis {
namespace {

constexpr double seen_from_the_front = 0.25;  // sine between a line and the view's direction: below, a pointer can't
                                              // tell places along the line

/// Parameter along a line where it comes nearest to what is seen at a pixel, model units.
double nearest_along(const Vec3& place, const Vec3& direction, const Ray& sight) {
  const double cosine = direction.dot(sight.direction);
  const Vec3 offset = sight.origin - place;
  return (offset.dot(direction) - cosine * offset.dot(sight.direction)) / (1 - cosine * cosine);
}

bool is_node_alone(const NetworkElements& elements) {
  return elements.nodes.size() == 1 && elements.curves.empty() && elements.faces.empty() && elements.points.empty();
}

}  // namespace

/// How far the pointer has gone, in the plane across the view through a place.
Vec3 SurfaceTool::way_across(const Vec3& place) const {
  const ViewFrame& frame = start_.pointer.frame;
  const SpacePlane plane = view_plane(frame, place);
  const auto from = place_on(plane, frame, start_.pointer.pixel);
  const auto to = place_on(plane, frame, last_);
  return from && to ? Vec3(*to - *from) : Vec3(Vec3::Zero());
}

/// How far the pointer has gone along a normal; one seen from its tip grows upwards.
Vec3 SurfaceTool::way_along(const Vec3& place, const Vec3& normal) const {
  const ViewFrame& frame = start_.pointer.frame;
  const Vec3 to_eye = frame.to_eye(place);
  if (to_eye.cross(normal).norm() > seen_from_the_front) {
    const double from = nearest_along(place, normal, frame.sight(start_.pointer.pixel));
    return (nearest_along(place, normal, frame.sight(last_)) - from) * normal;
  }
  const double up = (start_.pointer.pixel.y() - last_.y()) * frame.units_per_pixel(place);
  return (normal.dot(to_eye) < 0 ? -up : up) * normal;
}

// ---- What a press may take

std::vector<ControlHandle> SurfaceTool::handles() const {
  std::vector<ControlHandle> handles;
  const auto now = network();
  for (const std::string& id : selected().curves) {
    const AttributeCurve& curve = now->curves[require_element(*now, NetworkElement::Curve, id)];
    const std::size_t count = control_handles(*now, curve).size();
    for (std::size_t j = 0; j < count; ++j) {
      const bool at_node = (j == 0 && curve.from != no_index) || (j + 1 == count && curve.to != no_index);
      if (!at_node) handles.push_back({id, j});
    }
  }
  return handles;
}

std::vector<SlopeTip> SurfaceTool::slopes() const {
  std::vector<SlopeTip> tips;
  const NetworkElements chosen = selected();
  if (!sight_ || chosen.curves.size() != 1) return tips;
  const auto now = network();
  const std::string& curve = chosen.curves.front();
  for (const Index face : faces_along(*now, require_element(*now, NetworkElement::Curve, curve))) {
    const std::string& patch = now->faces[face].id;
    SlopeTip tip;
    tip.side = {curve, patch};
    Index slope = find_slope(*now, tip.side);
    if (slope == no_index) slope = find_slope(*now, {curve, {}});
    if (slope != no_index) {
      const SlopeAttribute& set = now->slopes[slope];
      if (set.face == no_index) tip.side.face.clear();
      tip.at = *std::ranges::min_element(set.at, {}, [](double at) { return std::abs(at - 0.5); });
      tip.magnitude = set.magnitude;
      tip.automatic = false;
    }
    const auto frame = sight_->slope_at(patch, curve, tip.at);
    if (!frame) continue;
    tip.frame = *frame;
    tip.tip = frame->point + tip.magnitude * frame->length * frame->inward;
    tips.push_back(tip);
  }
  return tips;
}

std::optional<SlopeTip> SurfaceTool::slope_at(const ViewFrame& frame, const Vec2& pixel) const {
  std::optional<SlopeTip> nearest;
  double least = options_.pick_pixels;
  for (const SlopeTip& tip : slopes()) {
    const auto seen = frame.project(tip.tip);
    if (!seen || (seen->pixel - pixel).norm() > least) continue;
    least = (seen->pixel - pixel).norm();
    nearest = tip;
  }
  return nearest;
}

std::vector<Vec3> SurfaceTool::ring() const {
  const NetworkElements chosen = selected();
  if (!sight_ || chosen.points.size() != 1) return {};
  const auto radius = preview_.radius ? preview_.radius : sight_->radius_of(chosen.points.front());
  return radius ? sight_->ring_of(chosen.points.front(), *radius) : std::vector<Vec3>();
}

bool SurfaceTool::ring_at(const ViewFrame& frame, const Vec2& pixel) const {
  const std::vector<Vec3> places = ring();
  for (std::size_t i = 0; i < places.size(); ++i) {
    const auto a = frame.project(places[i]);
    const auto b = frame.project(places[(i + 1) % places.size()]);
    if (!a || !b) continue;
    const double share = nearest_parameter(pixel, a->pixel, b->pixel);
    if ((a->pixel + share * (b->pixel - a->pixel) - pixel).norm() <= options_.pick_pixels) return true;
  }
  return false;
}

// ---- Dragging

void SurfaceTool::start_drag() {
  const bool pulls = mode_ == SurfaceMode::Point && hit_;
  if (mode_ == SurfaceMode::Patch || (!picked_ && !tip_ && !on_ring_ && !pulls)) {
    gesture_ = Gesture::Box;
    return;
  }
  original_ = std::make_shared<const AttributeNetwork>(network_or_empty());
  if (symmetry_) partners_ = find_partners(*original_, *symmetry_, tolerance_of(*original_));
  gesture_ = tip_ ? Gesture::Slope : on_ring_ ? Gesture::Ring : pulls ? Gesture::Pull : Gesture::Move;
  if (picked_ && picked_->control) gesture_ = Gesture::Handle;
  if (gesture_ == Gesture::Move) {
    moving_ = selected();
    if (!moving_.has(picked_->kind, picked_->id)) {
      if (!start_.pointer.modifiers.shift) moving_ = {};
      moving_.of(picked_->kind).push_back(picked_->id);
      select(moving_);
    }
  }
  drag_.begin(dragged().label);
}

/// The node that a single node would be merged into.
std::optional<PickedPlace> SurfaceTool::node_to_join() const {
  if (!is_node_alone(moving_)) return std::nullopt;
  AttributeNetwork others = *original_;
  const Index own = require_element(others, NetworkElement::Node, moving_.nodes.front());
  others.nodes.erase(others.nodes.begin() + static_cast<std::ptrdiff_t>(own));
  return nearest_node(others, start_.pointer.frame, last_, options_.snap_pixels);
}

SurfaceTool::Dragged SurfaceTool::moved() const {
  const bool only_points = moving_.nodes.empty() && moving_.curves.empty() && moving_.faces.empty();
  const auto normal =
      only_points && sight_ && !start_.pointer.modifiers.ctrl ? sight_->normal_at(picked_->id) : std::nullopt;
  recorded::SurfaceDrag step{moving_, {}, normal ? way_along(picked_->place, *normal) : way_across(picked_->place), {}};
  if (const auto join = node_to_join()) {
    step.by = join->place - picked_->place;
    step.into = join->id;
  }
  AttributeNetwork network = with_moved(*original_, moving_, step.by);
  if (!step.into.empty()) network = merge_nodes(std::move(network), moving_.nodes.front(), step.into);
  return {std::move(network), step, element_label("Move", moving_)};
}

SurfaceTool::Dragged SurfaceTool::slope_dragged() const {
  const SlopeFrame& frame = tip_->frame;
  const Vec3 along = frame.inward.cross(frame.normal);
  Vec3 arm = tip_->tip + way_across(tip_->tip) - frame.point;
  arm -= along * along.dot(arm);
  const double length = arm.norm();
  SlopeHandle handle{tip_->at, frame.normal, tip_->magnitude};
  if (length > 1e-6 * frame.length) handle = {tip_->at, Vec3(along.cross(arm / length)), length / frame.length};
  return {croquis::set_slope(*original_, tip_->side, handle), recorded::SurfaceSlope{tip_->side, handle},
          "Set slope along " + tip_->side.curve};
}

SurfaceTool::Dragged SurfaceTool::ring_dragged() const {
  const std::string id = selected().points.front();
  const PointAttribute& point = original_->points[require_element(*original_, NetworkElement::Point, id)];
  const auto centre = start_.pointer.frame.project(point.point);
  const double before = sight_->radius_of(id).value_or(point.radius.value_or(1));
  const double from = centre ? (start_.pointer.pixel - centre->pixel).norm() : 0;
  const double to = centre ? (last_ - centre->pixel).norm() : 0;
  const double radius = point.radius.value_or(before) * (from > 0 ? std::max(to / from, 1e-3) : 1);
  PointSetting setting;
  setting.radius = std::optional(radius);
  return {croquis::set_points(*original_, {id}, setting), recorded::SurfacePointSetting{{id}, setting},
          "Set radius of point " + id};
}

SurfaceTool::Dragged SurfaceTool::point_pulled() const {
  NewPoint point{hit_->face, hit_->point, hit_->fan, {}, {}};
  point.point += start_.pointer.modifiers.ctrl ? way_across(hit_->point) : way_along(hit_->point, hit_->normal);
  return {add_point(*original_, point).network, recorded::SurfacePoint{point}, "Add point to patch " + hit_->face};
}

SurfaceTool::Dragged SurfaceTool::dragged() const {
  switch (gesture_) {
    case Gesture::Slope: return slope_dragged();
    case Gesture::Ring: return ring_dragged();
    case Gesture::Pull: return point_pulled();
    case Gesture::Handle: break;
    default: return moved();
  }
  const ControlHandle handle{picked_->id, *picked_->control};
  const recorded::SurfaceDrag step{{}, handle, way_across(picked_->place), {}};
  return {move_handles(*original_, {handle}, step.by), step, "Bend curve " + picked_->id};
}

void SurfaceTool::drag_to() {
  Dragged now = dragged();
  preview_.snap.reset();
  if (const auto* step = now.step.as<recorded::SurfaceDrag>(); step != nullptr && !step->into.empty())
    preview_.snap = SurfaceSnap{{step->into, {}, 0}, picked_->place + step->by};
  if (const auto* step = now.step.as<recorded::SurfacePointSetting>()) preview_.radius = *step->setting.radius;
  dragged_ = now.step;
  drag_.to(with_network(on_both_sides(*original_, std::move(now.network))));
}

Verdict SurfaceTool::finish_drag() {
  done_ = dragged_;
  const bool pulled = gesture_ == Gesture::Pull;
  const std::string added = new_element_id(*original_, NetworkElement::Point);
  end_gesture();
  drag_.end();
  if (pulled) select(one_element(NetworkElement::Point, added));
  return Verdict::Commit;
}

}  // namespace croquis

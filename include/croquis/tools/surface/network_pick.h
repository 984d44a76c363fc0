// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "croquis/attribute_surface/curve_edit.h"
#include "croquis/attribute_surface/loop_search.h"
#include "croquis/tools/pointer/mesh_event.h"
#include "croquis/tools/pointer/view_frame.h"

namespace croquis {

// Where a stroke lies in space that is drawn in a view.

/// A plane in space to draw on.
struct SpacePlane {
  Vec3 point = Vec3::Zero();
  Vec3 normal = Vec3::UnitY();  ///< of any length above 0

  friend bool operator==(const SpacePlane&, const SpacePlane&) = default;
};

/// The place of the plane that is shown at a pixel; none where the plane is seen from its edge (below 3 degrees) or the
/// place lies behind the eye.
std::optional<Vec3> place_on(const SpacePlane& plane, const ViewFrame& frame, const Vec2& pixel);

/// Through a place, across the view.
SpacePlane view_plane(const ViewFrame& frame, const Vec3& place);

/// Through two places, and as much across the view as such a plane can be; of places that are one, the view's plane.
SpacePlane plane_through(const ViewFrame& frame, const Vec3& a, const Vec3& b);

/// For a stroke that begins on nothing: the ground where it is seen at 15 degrees or more, else the view's plane
/// through the place of the ground that is nearest to its point.
SpacePlane ground_or_view(const ViewFrame& frame, const SpacePlane& ground);

// What lies under the pointer of an attribute network. Reaches are px of the view; of elements that are as near in the
// view the one nearest to the eye. Nothing hides anything: wires are seen through patches. Linear.

/// A node, a control point of a curve, a place of a curve or a point attribute.
struct PickedPlace {
  NetworkElement kind = NetworkElement::Node;
  std::string id;
  std::optional<std::size_t> control;  ///< of a curve: the handle (control_handles)
  double at = 0;                       ///< of a curve without handle: fraction of its arc length
  Vec3 place = Vec3::Zero();
  double pixels = 0;  ///< from the pointer

  friend bool operator==(const PickedPlace&, const PickedPlace&) = default;
};

std::optional<PickedPlace> nearest_node(const AttributeNetwork& network, const ViewFrame& frame, const Vec2& pixel,
                                        double reach);

/// Of the curves named, without the ends that are at nodes.
std::optional<PickedPlace> nearest_handle(const AttributeNetwork& network, const std::vector<std::string>& curves,
                                          const ViewFrame& frame, const Vec2& pixel, double reach);

std::optional<PickedPlace> nearest_curve(const AttributeNetwork& network, const ViewFrame& frame, const Vec2& pixel,
                                         double reach);

std::optional<PickedPlace> nearest_point_attribute(const AttributeNetwork& network, const ViewFrame& frame,
                                                   const Vec2& pixel, double reach);

/// Nodes, curves and point attributes of which some part is in the box, px of the view.
NetworkElements elements_in_box(const AttributeNetwork& network, const ViewFrame& frame, const PickBox& box);

/// The curves as a view shows them, for find_loop_around; one that is partly beside or behind the eye isn't seen.
std::vector<ViewedCurve> viewed_curves(const AttributeNetwork& network, const ViewFrame& frame);

}  // namespace croquis

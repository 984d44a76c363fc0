// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "croquis/attribute_surface/curve_edit.h"
#include "croquis/attribute_surface/loop_search.h"
#include "croquis/tools/pointer/pick_box.h"
#include "croquis/tools/pointer/view_frame.h"

/// What lies under the pointer of an attribute network. Reaches are px of the view; of elements that are as near in the
/// view the one nearest to the eye. Nothing hides anything: wires are seen through patches. Linear.
namespace croquis {

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

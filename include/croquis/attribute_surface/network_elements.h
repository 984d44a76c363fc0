// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "croquis/geometry/attribute_network.h"

/// The elements of attribute networks by their ids, which stay when others are deleted.
namespace croquis {

enum class NetworkElement : std::uint8_t { Node, Curve, Face, Point };

/// Ids of elements of all kinds.
struct NetworkElements {
  std::vector<std::string> nodes;
  std::vector<std::string> curves;
  std::vector<std::string> faces;
  std::vector<std::string> points;

  bool empty() const { return nodes.empty() && curves.empty() && faces.empty() && points.empty(); }
  std::vector<std::string>& of(NetworkElement kind);
  const std::vector<std::string>& of(NetworkElement kind) const;
  bool has(NetworkElement kind, std::string_view id) const;
  friend bool operator==(const NetworkElements&, const NetworkElements&) = default;
};

/// The element's index, or no_index. Linear.
Index find_element(const AttributeNetwork& network, NetworkElement kind, std::string_view id);

/// @throws Error (Usage, E_INPUT) naming what isn't there
Index require_element(const AttributeNetwork& network, NetworkElement kind, std::string_view id);

/// "n1", "c1", "f1" or "p1" with the lowest number above all of such ids of that kind.
std::string new_element_id(const AttributeNetwork& network, NetworkElement kind);

/// What there is of that kind, in the network's order.
std::vector<std::string> element_ids(const AttributeNetwork& network, NetworkElement kind);

/// The tolerance that the network has, else 1e-4 × the diagonal of its bounding box; model units.
double tolerance_of(const AttributeNetwork& network);

/// Which way a side goes from and to; no_index at ends without a node.
Index start_node(const AttributeNetwork& network, const AttributeSide& side);
Index end_node(const AttributeNetwork& network, const AttributeSide& side);

/// Places where a side begins and ends.
Vec3 start_place(const AttributeNetwork& network, const AttributeSide& side);
Vec3 end_place(const AttributeNetwork& network, const AttributeSide& side);

/// Faces that have the curve in their loop, ascending.
std::vector<Index> faces_along(const AttributeNetwork& network, Index curve);

/// Places along a curve at even parameters, ends included. @param parts > 0; a straight curve has one
std::vector<Vec3> traced_curve(const AttributeNetwork& network, Index curve, std::size_t parts = 32);

}  // namespace croquis

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "croquis/geometry/attribute_network.h"

namespace croquis {

/// Elements that go, by index.
struct RemovedElements {
  std::vector<bool> nodes, curves, faces, points;

  explicit RemovedElements(const AttributeNetwork& network)
      : nodes(network.nodes.size()),
        curves(network.curves.size()),
        faces(network.faces.size()),
        points(network.points.size()) {}
};

/// The network without these, renumbered. Points of faces that go, and slopes and inner curves of what goes, go too.
/// @pre no curve that stays has a node that goes, no face that stays a curve that goes in its loop
AttributeNetwork without_elements(AttributeNetwork network, const RemovedElements& removed);

/// Forgets where points of a face lie in its domain, which has become another one.
void forget_places(AttributeNetwork& network, Index face);

}  // namespace croquis

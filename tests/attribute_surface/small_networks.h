// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "croquis/geometry/attribute_network.h"

/// Small networks whose surfaces are known, made by hand.
namespace croquis::test {

/// A loop of straight curves through these corners, one face "f".
AttributeNetwork straight_loop(const std::vector<Vec3>& corners);

/// A wavy hill over a regular polygon with so many sides, each a cubic that bulges upwards; one face "f".
AttributeNetwork hill(std::size_t sides, double height);

/// Two arcs between two nodes: a leaf of one face "f".
AttributeNetwork small_leaf();

/// A leaf with a triangle beside each arc: faces "f", "left" and "right".
AttributeNetwork leaf_between_triangles();

}  // namespace croquis::test

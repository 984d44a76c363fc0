// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "croquis/geometry/attribute_network.h"

/// Networks of several faces.
namespace croquis::test {

AttributeNetwork sphere_of_octants();                                   ///< closed, 8 faces of three smooth curves
AttributeNetwork cube_sphere();                                         ///< closed, 6 faces of four smooth curves
AttributeNetwork torus_of_quads(std::size_t around, std::size_t tube);  ///< closed, all curves smooth

/// Two sides that meet smoothly in the keel and are upright at the stem: normals there are nearly opposite. A transom
/// closes the stern along creases. Faces "left", "right" and "transom".
AttributeNetwork boat_hull();

/// The network of a file in examples/data/surface: "car_intact", "car_crashed", "pocket5" or "tri_point".
AttributeNetwork example_network(const std::string& name);

/// All of them.
std::vector<AttributeNetwork> joined_networks();

}  // namespace croquis::test

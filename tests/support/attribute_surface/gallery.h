// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "croquis/geometry/attribute_network.h"

/// The attribute networks of examples/data. z is up, lengths are metres.
namespace croquis::test {

AttributeNetwork gallery_bonnet();  ///< a car's bonnet, four smooth faces, with a dent and a bulge along an inner curve
AttributeNetwork gallery_bowl();    ///< five petals around a five-sided foot, a knob in its middle
AttributeNetwork gallery_chair();   ///< a seat shell: two faces, a hollow to sit in, a bend for the back
AttributeNetwork gallery_dinghy();  ///< a hull with a smooth keel, a transom, a foredeck and a bench
AttributeNetwork gallery_kettle();  ///< a round body of faces of four and five sides around a spout; lid and handle
AttributeNetwork gallery_sail();    ///< three curves, one point: the smallest

/// Each with the name of its file.
std::vector<AttributeNetwork> gallery_networks();

}  // namespace croquis::test

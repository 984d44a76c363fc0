// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "croquis/attribute_surface/network_elements.h"

namespace croquis {

/// "Move curve c1", "Move 3 nodes", "Move 5 elements".
std::string element_label(const std::string& verb, const NetworkElements& elements);

NetworkElements one_element(NetworkElement kind, const std::string& id);

/// The network with elements moved: with curves their nodes, with faces all that they are made from.
AttributeNetwork with_moved(AttributeNetwork network, const NetworkElements& elements, const Vec3& by);

}  // namespace croquis

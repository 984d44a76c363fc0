// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "croquis/geometry/attribute_network.h"

namespace croquis {

/// The normal of a slope at a fraction of its curve: turned evenly between those given, beyond them as the nearest one.
Vec3 normal_between(const SlopeAttribute& slope, double at);

}  // namespace croquis

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "croquis/base/finding.h"
#include "croquis/geometry/attribute_network.h"
#include "croquis/geometry/brep.h"

namespace croquis {

/// A face of an attribute network has so many sides.
inline constexpr std::size_t least_network_sides = 2;
inline constexpr std::size_t most_network_sides = 12;

struct SolidNetwork {
  AttributeNetwork network;
  Findings warnings;  ///< FACE_LEFT_OUT: faces with holes, or with too many or too few sides
};

/// The curves and faces of a solid as an attribute network: a node for each vertex ("v0" …), a curve for each edge (its
/// stroke's name), a face for each outer loop ("f0" …, oriented outwards). Curves are the polynomial ones that patches
/// are spanned from; an edge of two becomes two curves ("ID/1", "ID/2") with a node between them. Straight ones need no
/// control points. Curves are smooth where the solid is. Linear, but for the names.
SolidNetwork network_of_solid(const Brep& brep);

}  // namespace croquis

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "croquis/attribute_surface/face_edit.h"
#include "croquis/tools/surface/surface_steps.h"

namespace croquis {

/// A network with a stroke in it.
struct DrawnStroke {
  AttributeNetwork network;
  std::vector<std::string> curves;  ///< ids of its curves; empty for a tap
  std::string label;                ///< "Draw curve c3"
};

/// Where an end of a stroke goes. @throws Error (E_INPUT) for what isn't there
Vec3 place_of_end(const AttributeNetwork& network, const recorded::CurveEnd& end);

/// Adds what a stroke was meant as: curves between nodes; with a face, a curve across it that divides it, or curves
/// inside it.
/// @throws Error (E_INPUT) for elements that aren't there
DrawnStroke with_stroke(AttributeNetwork network, const recorded::SurfaceStroke& stroke);

}  // namespace croquis

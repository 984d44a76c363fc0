// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "croquis/geometry/poly_mesh.h"
#include "croquis/render/color.h"

namespace croquis::render {

/// The colour of a value on a scale from low (dark purple) over blue and green to high (light yellow). Lightness grows
/// all the way, so that people with any colour vision, and grey prints, keep the order.
/// @param value 0 is low, 1 is high; beyond them as at the nearer end; NaN: grey
Color value_color(double value);

/// One line of a legend.
struct ValueSample {
  double value = 0;
  std::string label;  ///< of the value in percent
  Color color;
};

/// Stops for a legend, evenly from 0 to 1. @param count at least 2
std::vector<ValueSample> value_legend(int count = 5);

/// Which values become colours, and of which faces.
struct ValueColoring {
  std::string channel = "confidence";  ///< of the vertices, else of the faces; one number each
  double low = 0;                      ///< the value at the scale's low end …
  double high = 1;                     ///< … and at its high one; not equal to low
  /// A channel of the faces, one whole number each: those below 0 keep their colour. Where a mesh doesn't have it,
  /// faces of which every value is `high` keep theirs.
  std::string mark = "patch_id";
};

/// The mesh with a "color" channel of its corners that shows the values; `make_mesh_item` does the rest. Faces that
/// keep their colour have exactly the colour they had, also where their vertices are shared with others; so have faces
/// with a value that is NaN, and all faces of a mesh that has no such channel. O(corners).
PolyMesh with_value_colors(const PolyMesh& mesh, const ValueColoring& coloring = {});

}  // namespace croquis::render

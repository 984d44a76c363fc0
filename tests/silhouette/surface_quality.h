// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "croquis/geometry/poly_mesh.h"

/// How well an inflated surface looks, measured on its mesh alone.
namespace croquis::test {

struct Spread {
  double mean = 0;
  double p95 = 0;
  double max = 0;
};

/// Sorts the values. Empty: all zero.
Spread spread_of(std::vector<double> values);

/// Smallest angle of each triangle, degrees, ascending.
std::vector<double> smallest_angles(const PolyMesh& mesh);

/// Degrees by which successive front faces along the rim (the outline's edges) differ in direction beyond what the
/// outline itself turns there: a smooth rim has nearly none.
Spread rim_serration(const PolyMesh& mesh);

/// Degrees by which the front is bent inwards most at an edge that ends on the outline: a notch in the rim. Round
/// solids have few degrees of it, from the sampling alone.
double deepest_rim_notch(const PolyMesh& mesh);

/// Heights at which the vertical line through a place pierces the mesh, ascending.
std::vector<double> vertical_hits(const PolyMesh& mesh, const Vec2& place);

/// Sections normal to a tube's axis: the ratio of the half axis that leans towards the viewer to the horizontal one, at
/// every node of the skeleton's polylines. Only where the branch is a tube: a radius or more from its ends,
/// with radii that differ by a tenth at most. At caps and where a body flares, a section isn't an ellipse.
std::vector<double> half_axis_ratios(const PolyMesh& mesh, const PolyMesh& skeleton);

/// The mesh's faces of one object (label of the face channel "object"), with only its vertices.
PolyMesh part_of(const PolyMesh& mesh, int object);

/// As a file would store it: 32-bit floats, or multiples of a grid's spacing.
PolyMesh rounded_to_float(PolyMesh mesh);
PolyMesh rounded_to_grid(PolyMesh mesh, double spacing);

}  // namespace croquis::test

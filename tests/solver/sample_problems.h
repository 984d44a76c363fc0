// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "croquis/solver/least_squares.h"

/// Problems of the kinds that the program solves, at any size, for the solver's tests and benchmark.
namespace croquis::test {

/// A closed centre line seen from above: nodes with a planar place and a height that says who passes over whom.
struct CentreLine {
  std::vector<Eigen::Vector3d> nodes;  ///< in order along the line; the last is joined to the first
};

/// Rings in a row, each linked with the next: over at one crossing, under at the other.
std::vector<CentreLine> chain_of_rings(int rings, int nodes_per_ring);

/// A trefoil knot: three crossings, alternating.
std::vector<CentreLine> trefoil(int nodes);

/// Depth of tubes of the given radius around centre lines: per node a height and a gradient (unknowns 3i, 3i+1, 3i+2),
/// plate-like bending energy, one C1 equality per edge, and one inequality per pair of nodes that would collide
/// (Cordier, Seo, Cho 2006, section 4.4).
LeastSquaresProblem depth_problem(const std::vector<CentreLine>& lines, double radius);

/// Sheets of cells by cells squares above one another, bending like plates and held by anchors at the wrong heights;
/// each pair of neighbouring sheets has to keep a distance at every vertex of a disk that holds the given share of
/// them.
LeastSquaresProblem sheet_problem(int cells, int sheets, double constrained_share);

/// The same for rectangles, as long limbs are; the disk becomes an ellipse.
LeastSquaresProblem sheet_strip(int length, int width, int sheets, double constrained_share);

/// Random dense-ish rows with a feasible point; `tight` rows go through that point.
struct RandomShape {
  int unknowns = 5;
  int objective_rows = 8;
  int equalities = 1;
  int inequalities = 6;
  int tight = 2;
};
LeastSquaresProblem random_problem(const RandomShape& shape, std::uint32_t seed);

}  // namespace croquis::test

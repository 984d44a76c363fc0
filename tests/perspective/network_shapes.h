// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "croquis/geometry/curve_network.h"
#include "croquis/perspective/face_finding.h"
#include "croquis/perspective/solid.h"
#include "support/perspective/solids.h"

/// Curve networks for tests, and what they are compared by.
namespace croquis::test {

/// A face by its loops, each the set of its curves' ids.
using FaceIds = std::set<std::set<std::string>>;

std::multiset<FaceIds> ids_of_faces(const CurveNetwork& network, const FaceSet& set);
std::multiset<FaceIds> ids_of_faces(const PerspectiveSolid& solid);

/// The same curves in another order, some turned, with other ids and vertices in another order.
/// @return the network and, for each of its curves, the id that it had before
std::pair<CurveNetwork, std::vector<std::string>> shuffled(const CurveNetwork& network, unsigned seed);

/// The curves of both; ids of the second get a prefix.
CurveNetwork joined(CurveNetwork a, const CurveNetwork& b, const std::string& prefix);

CurveNetwork moved(CurveNetwork network, double scale, const Vec3& by);
CurveNetwork rotated(CurveNetwork network);

/// Without the curves of these ids.
CurveNetwork without(CurveNetwork network, const std::set<std::string>& ids);

/// An edge of a polyhedron as an arc of the unit sphere, one cubic.
struct PolyhedronNet {
  std::string name;
  CurveNetwork network;
  std::size_t faces = 0;
};

/// Cube, octahedron, dodecahedron, and a prism of three sides, on the unit sphere.
std::vector<PolyhedronNet> sphere_nets();

/// Vertices and handles moved by up to that much, ends of curves with their vertices.
CurveNetwork perturbed(CurveNetwork network, double by, unsigned seed);

/// Straight curves between vertices, with ids "e0", "e1" …
CurveNetwork line_network(const std::vector<Vec3>& vertices, const std::vector<std::array<Index, 2>>& lines);

/// A box in a box, their corners joined: a frame around each of the three axes, none better than another.
CurveNetwork box_in_box();

/// Lines of latitude and longitude of a sphere, as arcs: rings · steps + (rings + 1) · steps curves, the poles are
/// vertices.
CurveNetwork globe(int rings, int steps);

/// A wall of nx by nz boxes of one depth, with all their edges.
CurveNetwork box_wall(int nx, int nz);

FaceFindingResult faces_of(const CurveNetwork& network, const FaceFindingOptions& options = {});

/// The pieces of curves as they are, weights left out.
std::vector<FittedCurve> polynomial_pieces(const CurveNetwork& network);

/// With the faces that are found.
Solid solid_of(const CurveNetwork& network, const SolidOptions& options = {});

std::vector<std::string> sorted_codes(const Findings& findings);

}  // namespace croquis::test

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "croquis/geometry/poly_mesh.h"

/// Control meshes for subdivision. Closed ones are oriented outwards.
namespace croquis::test {

using VertexPair = std::array<Index, 2>;

/// A ring of a stacked cage: for 4 sides a square of half side `size`, else a regular polygon of that circumradius.
struct Ring {
  double size = 1;
  double z = 0;
};

/// Rings joined by quads, closed by a polygon at both ends; vertices ring by ring. The first ring is the top.
/// @param sides n >= 3
PolyMesh ring_stack(Index sides, std::span<const Ring> rings);

/// A screw: head [-2,2]^2 x [0,1], shank [-1,1]^2 x [-3,0]. V 16, E 28, F 14; ring 2 is where the shank meets the head.
PolyMesh bolt();
PolyMesh bolt_loop();        ///< with the 4 edges of ring 2 sharp
PolyMesh bolt_open_chain();  ///< with 3 of them: 8-9-10-11
PolyMesh hex_bolt();         ///< six sides, a collar and a shank: V 30, F 26, with hexagons at both ends

PolyMesh centred_cube();        ///< [-1,1]^3; the top face is 4-5-7-6
PolyMesh cube_top_loop();       ///< with the top's 4 edges sharp
PolyMesh cube_all_sharp();      ///< with all 12
PolyMesh l_bracket();           ///< two arms of unit squares: V 16, F 14
PolyMesh icosahedron();         ///< V 12, F 20: valence 5
PolyMesh pyramid(Index sides);  ///< one n-gon, n triangles, an apex of valence n
PolyMesh house();               ///< pentagons and quads: V 10, F 7
PolyMesh valence_two_disc();    ///< open; an interior vertex with two faces: V 9, F 6
PolyMesh mixed_disc();          ///< open; triangles, quads, a pentagon and a hexagon: V 13, F 8
PolyMesh single_face(Index sides);
PolyMesh back_to_back(Index sides);  ///< two faces on the same vertices: all of valence 2

struct NamedCage {
  std::string name;
  PolyMesh mesh;
};

/// All of the above without tags, a torus, a double torus, a sphere and a grid.
std::vector<NamedCage> all_cages();

/// Every edge once, by its vertices, lower first.
std::vector<VertexPair> all_edges(const PolyMesh& mesh);

PolyMesh tagged(PolyMesh mesh, std::span<const VertexPair> edges, double sharpness = infinite_sharpness);

}  // namespace croquis::test

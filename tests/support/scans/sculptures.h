// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <vector>

#include "croquis/geometry/poly_mesh.h"

/// Solids like those that get scanned, sculpted as zero sets of functions, so that they come in any resolution.
namespace croquis::test {

enum class Sculpture {
  Beast,    ///< four legs, ears, snout, tail
  Head,     ///< nose, brows, eyes, ears, neck
  Hand,     ///< palm and five fingers
  Mug,      ///< a bellied mug with a handle: genus 1, walls of 4 % of the diagonal
  Knot,     ///< a trefoil: genus 1
  Coral,    ///< branches of branches
  Armour,   ///< an egg under 160 scales with sharp valleys
  Shell,    ///< an open wavy shell, walls of 2 % of the diagonal
  Bracket,  ///< machined: sharp edges, bores, a rib and a fillet
  Housing   ///< machined: steps, slots, a bored block
};

inline constexpr std::array all_sculptures = {
    Sculpture::Beast, Sculpture::Head,   Sculpture::Hand,  Sculpture::Mug,     Sculpture::Knot,
    Sculpture::Coral, Sculpture::Armour, Sculpture::Shell, Sculpture::Bracket, Sculpture::Housing};

const char* name_of(Sculpture sculpture);

/// Made of planes and cylinders that meet in sharp edges.
bool is_machined(Sculpture sculpture);

/// About the signed distance to the surface, negative inside; 2 to 3 units across.
double field_value(Sculpture sculpture, const Vec3& point);

/// A closed mesh of one piece with that many triangles within 10 %, evenly sized, vertices on the surface; sharp edges
/// of machined ones run along edges of the mesh. Thin walls need 8,000 triangles. Takes about 0.15 s for 10,000
/// triangles, in proportion for more; the same for any number of threads.
PolyMesh sculpt(Sculpture sculpture, std::size_t triangles);

/// The same for a solid of one's own: about the signed distance, within 3 units of the origin, met by one of the lines
/// along x through (0, ±0.25 i, ±0.3 k), i and k up to 2.
/// @param is_sharp whether edges of the solid run along edges of the mesh, else they come out cut
PolyMesh sculpt(const std::function<double(const Vec3&)>& solid, std::size_t triangles, bool is_sharp = false);

/// Brings points onto the surface of a solid that they are near to.
/// @param cell about how far they may be off
void bring_onto(const std::function<double(const Vec3&)>& solid, std::vector<Vec3>& points, double cell);

}  // namespace croquis::test

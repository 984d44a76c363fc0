// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <functional>

#include "croquis/geometry/vector.h"

/// Solids like those that get scanned, another one for every seed: shapes, sizes and places of all their parts are
/// drawn by lot. See sculpt() for their meshes.
namespace croquis::test {

enum class SolidKind {
  Blob,    ///< limbs and hollows grown together, under waves of many lengths
  Figure,  ///< a robe or legs, arms, a head; some arms come back to the body
  Face,    ///< a head with nose, brows, eyes, ears, neck
  Pot,     ///< a turned vessel, open at the top, walls of 1 to 3 % of the diagonal, with up to two handles
  Part,    ///< machined: prisms, cylinders, bores, slots, chamfers and fillets
  Thorns,  ///< a body with spikes and thin fins
  Bones    ///< bars with thick ends, arches and rings: many handles
};

inline constexpr std::array all_solid_kinds = {SolidKind::Blob, SolidKind::Figure, SolidKind::Face, SolidKind::Pot,
                                               SolidKind::Part, SolidKind::Thorns, SolidKind::Bones};

const char* name_of(SolidKind kind);

/// About the signed distance to the surface, negative inside; of one piece, 2 to 4 units across, around the origin.
/// Thread-safe.
std::function<double(const Vec3&)> random_solid(SolidKind kind, std::uint64_t seed);

}  // namespace croquis::test

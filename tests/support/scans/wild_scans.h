// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

#include "croquis/geometry/poly_mesh.h"

/// Scans as photogrammetry leaves them, where nothing can be relied on: open sheets with ragged borders, things on a
/// piece of ground, specks in the air, sheets upon sheets, densities of 1 to 100, needles, spikes, flipped patches.
namespace croquis::test {

enum class WildScan {
  Terrain,   ///< hills, ragged border, holes, ever denser to one side
  Facade,    ///< a wall with windows and ledges, seen from the front
  Monument,  ///< a sculpture on a piece of ground, seen from above; its bottom is missing
  Layers,    ///< several views of a sculpture upon each other, joined nowhere
  Cloth,     ///< a sheet rolled over itself, whose layers cross
  Fragment,  ///< a sculpture of which large parts are missing
  Interior   ///< the inside of a room with furniture, seen from its middle
};

inline constexpr std::array all_wild_scans = {WildScan::Terrain, WildScan::Facade, WildScan::Monument,
                                              WildScan::Layers,  WildScan::Cloth,  WildScan::Fragment,
                                              WildScan::Interior};

const char* name_of(WildScan kind);

/// About so many triangles, 0.5 to 2 times. Seeds choose the shape and, one by one, what is wrong with it: noise,
/// spikes, specks, needles, patches doubled and flipped, bow-ties, faces missing at random.
PolyMesh wild_scan(WildScan kind, std::uint64_t seed, std::size_t triangles);

}  // namespace croquis::test

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "croquis/geometry/poly_mesh.h"
#include "support/scans/hole_cutter.h"

/// Scans with all that real ones have, of things that are known: another thing, other holes and other damage for every
/// seed. Figures that are reported come from seeds from 50001 on, which nobody looks at while rules are changed; rules
/// are tuned on seeds from 1 to 4999.
namespace croquis::test {

enum class ScanKind {
  Photogrammetry,  ///< density up to 1:30, lumpy noise, pieces in the air, stray triangles, pinches, edges of three
                   ///< faces
  RangeView,       ///< one view's grid of depths, cut where depth jumps, its depth read in steps
  RangeViews,      ///< several views, each a little misplaced, that overlap or leave gaps
  Statue,          ///< open at its flat base of about 40 % of the diagonal
  Pot,             ///< thin walls from both sides; open at the top, where the bottom can't be seen, or the lip is lost
  Face,            ///< a head that is open at the back
  Part,            ///< machined and worn: creases, corners, fillets; half of them are sides whose seams differ by 1e-16
  Thorns,          ///< spikes and thin fins
  Bones            ///< handles, with long rims bent around them
};

inline constexpr std::array all_scan_kinds = {ScanKind::Photogrammetry, ScanKind::RangeView, ScanKind::RangeViews,
                                              ScanKind::Statue,         ScanKind::Pot,       ScanKind::Face,
                                              ScanKind::Part,           ScanKind::Thorns,    ScanKind::Bones};

const char* name_of(ScanKind kind);

/// A hole of which is known what is missing.
struct KnownHole {
  HoleKind kind = HoleKind::Small;
  std::vector<Vec3> places;  ///< on the surface that is missing, evenly by area, about 400
  std::vector<Index> rim;    ///< corners of the mesh that start the edges left open
};

struct KnownScan {
  PolyMesh truth;                ///< the thing: closed and manifold
  PolyMesh mesh;                 ///< what was scanned of it
  std::vector<KnownHole> holes;  ///< what was cut out; sheets may have borders besides
  double diagonal = 0;           ///< of the truth
  std::size_t floating_pieces = 0, stray_triangles = 0, fins = 0;
  bool has_seams = false;  ///< the mesh is cut along its creases
};

/// @param triangles of the thing, within a half, and no fewer than its walls and bars need (5,000 to 30,000); 0: the
/// seed chooses up to 200,000, mostly few. About 0.1 s for 10,000
KnownScan known_scan(ScanKind kind, std::uint64_t seed, std::size_t triangles = 0);

}  // namespace croquis::test

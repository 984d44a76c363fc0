// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "croquis/geometry/poly_mesh.h"
#include "support/random.h"
#include "support/scans/piece_cutter.h"

namespace croquis::test {

enum class HoleKind {
  Small,      ///< radius 0.5 to 1.5 % of the diagonal, at least three edges
  Middle,     ///< 1.5 to 5 %
  Large,      ///< 5 to 12 %
  Huge,       ///< 12 to 25 %
  Crease,     ///< across the sharpest edges or corners that there are, 2 to 6 %
  Islands,    ///< 4 to 10 %, with one to five pieces in it
  Near,       ///< two or three discs, one to three edges apart; a hole each
  BothSkins,  ///< the same place of both sides of a thin wall; a hole each
  Bent,       ///< a band that winds over the surface, 300 edges of rim where the mesh is fine enough
  Occluded,   ///< what no view showed
  Gap,        ///< between views that don't meet
  Opening,    ///< cut off on purpose: a base, a mouth, a back
  Pinhole     ///< one face, whose corner another hole has
};

inline constexpr std::array all_hole_kinds = {
    HoleKind::Small,   HoleKind::Middle,  HoleKind::Large,     HoleKind::Huge, HoleKind::Crease,
    HoleKind::Islands, HoleKind::Near,    HoleKind::BothSkins, HoleKind::Bent, HoleKind::Occluded,
    HoleKind::Gap,     HoleKind::Opening, HoleKind::Pinhole};

const char* name_of(HoleKind kind);

/// Faces taken away from a mesh, ascending.
struct HoleCut {
  HoleKind kind = HoleKind::Small;
  std::vector<Index> faces;
};

/// Takes pieces off a mesh of triangles, at places chosen by lot: ragged discs, rings, bands, all apart from each other
/// and from borders, each with simple rims. Keeps the mesh by reference.
class HoleCutter {
 public:
  HoleCutter(const PolyMesh& mesh, std::uint64_t seed);

  /// Cuts one hole, or those of one place. Huge ones first: a few hundred tries are made.
  /// @return whether there was room
  bool cut(HoleKind kind);

  /// Takes faces away wherever they are, before any hole is cut.
  void remove(HoleKind kind, std::vector<Index> faces);

  const std::vector<HoleCut>& cuts() const { return cuts_; }

 private:
  using Pieces = std::vector<std::vector<Index>>;

  Index random_face();
  Index random_crease();
  Index random_neighbour(Index vertex, Vec3& heading);
  std::vector<Index> disc(Index first, double radius);
  bool cut_disc(HoleKind kind, double low, double high);
  bool cut_ring();
  bool cut_near();
  bool cut_skins();
  bool cut_band();
  bool cut_pinhole();
  bool keep(HoleKind kind, Pieces pieces, std::ptrdiff_t rims);

  const PolyMesh& mesh_;
  PieceCutter cutter_;
  Random random_;
  double diagonal_, edge_;
  std::vector<Index> creases_;  // faces at the sharpest edges
  std::vector<HoleCut> cuts_;
};

}  // namespace croquis::test

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "croquis/base/progress.h"
#include "croquis/geometry/poly_mesh.h"
#include "croquis/geometry/triangle_tree.h"
#include "croquis/geometry/vector.h"
#include "croquis/hole_filling/hole_site.h"
#include "croquis/implicit/box_weight.h"
#include "croquis/implicit/field.h"

namespace croquis::hole_filling {

/// The triangles none of whose corners is left out, as a mesh without unused vertices. Its borders are simple:
/// triangles with two border edges are removed, and those around vertices where borders touch, until there are none.
/// @param triangles manifold and consistently oriented; @param left_out #V
PolyMesh open_sheet(const PolyMesh& triangles, std::span<const std::uint8_t> left_out);

/// A piece of surface with one border loop per rim of a site.
struct MatchedSheet {
  PolyMesh sheet;                         ///< triangles, one component
  std::vector<std::vector<Index>> loops;  ///< per loop of the site's polygon: vertices, the triangles on their left
  std::vector<Index> arrives_at;          ///< holes beyond the site that the sheet ends at; then the rest isn't made
};

/// Finds out which border of a sheet belongs to which rim: each border vertex votes for the rim nearest to it.
///
/// Pieces that end at no rim are dropped, as are borders that end nowhere near one (pinholes): these are closed by
/// least area. Nothing where a rim has no border, or borders of the piece that has most would have to be guessed.
/// @param cell size of the sheet's triangles, and unit of its distance to the rims
/// @throws Cancelled
std::optional<MatchedSheet> match_loops(const HoleSite& site, PolyMesh sheet, double cell, Progress& progress);

/// Two closed borders that run the same way: the left one's strip lies on its left, and ends at the right one.
struct ZipSides {
  std::vector<Vec3> left, right;                  ///< places, in order
  std::vector<Vec3> left_normals, right_normals;  ///< unit, of the surface that the strip is to be part of
};

/// The strip of triangles between both: corners below #left are points of the left side, #left + j is right[j].
///
/// Its edges are as short as can be for short sides, else the shorter one is taken each time (see band_triangulation).
/// Nothing where it would be twisted, as between sides that run against each other (closed and manifold as it would
/// be): when its edges are twice as long on average as the distances to the other side's nearest points. Nor where it
/// turns over: when triangles that look against the surface have more than a tenth of its area.
/// @throws Cancelled
std::optional<std::vector<std::array<Index, 3>>> zip(const ZipSides& sides, Progress& progress);

/// The surface that is there already around a site: finds which places of its continuation lie upon it.
class Covering {
 public:
  /// Takes the triangles that reach into the box. Linear in the view, n log n in those.
  /// @throws Cancelled
  Covering(const HoleSite& site, const implicit::Box& box, const Progress& progress = {});

  /// A place on the field's zero set is covered when the nearest triangle that looks the same way (within 100 degrees)
  /// is within two cells and lies under it; where its foot is on a rim, when the place isn't further than 0.45 cells
  /// beyond, in the direction in which the triangle would go on. Thread-safe.
  void mark(const implicit::Field& field, double cell, std::span<const Vec3> places,
            std::span<std::uint8_t> covered) const;

  /// How near a sheet that looks the other way comes to a vertex of the site's rims, at most `farthest`: the thickness
  /// of a thin wall.
  double wall(double farthest) const;

 private:
  Vec3 onwards(const TriangleFoot& foot) const;

  const HoleSite& site_;
  std::vector<Index> triangles_;            ///< of the view
  std::vector<Vec3> normals_;               ///< unit, per triangle
  std::unordered_map<Index, Vec3> at_rim_;  ///< per vertex of the view the sum of the directions in which edges go on
  std::optional<TriangleTree> tree_;
};

}  // namespace croquis::hole_filling

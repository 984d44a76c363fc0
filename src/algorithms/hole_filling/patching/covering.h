// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "croquis/geometry/triangle_tree.h"
#include "croquis/hole_filling/hole_site.h"
#include "croquis/implicit/box_weight.h"
#include "croquis/implicit/field.h"

namespace croquis::hole_filling {

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
  std::vector<Index> triangles_;  ///< of the view
  std::vector<Vec3> normals_;     ///< unit, per triangle
  std::vector<std::pair<Index, Vec3>>
      at_rim_;  ///< vertex of the view, sum of the directions in which edges there go on
  TriangleTree tree_;
};

}  // namespace croquis::hole_filling

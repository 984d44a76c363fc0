// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <limits>
#include <string>
#include <vector>

#include "croquis/geometry/vector.h"

namespace croquis {

/// Sharpness of an edge that stays sharp under every refinement.
inline constexpr double infinite_sharpness = std::numeric_limits<double>::infinity();

/// The greatest finite sharpness; more counts as infinite, and files that know no infinity write it for that.
inline constexpr double greatest_sharpness = 10;

/// A tagged edge: sharp for so many refinements.
struct Crease {
  std::array<Index, 2> vertices = {no_index, no_index};  ///< in any order
  double sharpness = infinite_sharpness;                 ///< > 0; in whole levels, a fraction blends

  friend bool operator==(const Crease&, const Crease&) = default;
};

/// Tagged elements that people named, to change them together.
struct CreaseSet {
  std::string name;  ///< differs from those of the other sets
  double sharpness = infinite_sharpness;
  std::vector<std::array<Index, 2>> edges;  ///< members, by their vertices (lower first); each is a crease
  std::vector<Index> pins;                  ///< members; each is pinned

  friend bool operator==(const CreaseSet&, const CreaseSet&) = default;
};

/// How a mesh is to be subdivided: one set of tags for all schemes.
///
/// Sparse: a mesh has far fewer tags than edges. Nothing here is promised to fit the mesh; who uses tags refuses by
/// name what is no edge.
struct MeshTags {
  std::vector<Crease> creases;
  std::vector<Index> pins;  ///< vertices that stay where they are
  std::vector<CreaseSet> sets;

  bool empty() const { return creases.empty() && pins.empty() && sets.empty(); }
  friend bool operator==(const MeshTags&, const MeshTags&) = default;
};

}  // namespace croquis

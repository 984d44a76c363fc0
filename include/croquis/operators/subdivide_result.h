// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "croquis/base/described.h"
#include "croquis/geometry/vector.h"
#include "croquis/subdivision/edge_chain.h"

/// What the operation `subdivide` found of its levels; its report is made of this.
namespace croquis {

enum class SubdivisionScheme { DooSabin, CatmullClark, Loop };

/// "doo-sabin", "catmull-clark", "loop".
const char* to_string(SubdivisionScheme scheme);

struct LevelCounts {
  std::size_t vertices = 0, edges = 0, faces = 0;
  std::size_t boundary_edges = 0, sharp_edges = 0;
};

inline auto described(const LevelCounts& counts) {
  return fields(named("vertices", counts.vertices), named("edges", counts.edges), named("faces", counts.faces),
                named("boundary_edges", counts.boundary_edges), named("sharp_edges", counts.sharp_edges));
}
static_assert(describes_every_member<LevelCounts>);

/// An edge of the cage by its two vertices.
using CageEdge = std::array<Index, 2>;

/// A chain of sharp edges of the last level. Angles in radians, lengths in model units.
struct SharpChain {
  std::size_t edges = 0;
  bool closed = false;
  std::array<subdivision::ChainEnd, 2> ends = {};  ///< of an open chain
  double least_angle = 0, greatest_angle = 0;      ///< between the faces on both sides of an edge
  std::array<double, 2> side_angles = {0, 0};      ///< the greatest beside the chain, on its left and right
  double length = 0;
  bool planar = false;
  double deviation = 0;              ///< greatest distance of a vertex from the plane that fits best
  std::vector<CageEdge> cage_edges;  ///< from which the chain comes
};

/// Angles in degrees.
inline auto described(const SharpChain& chain) {
  std::vector<const char*> ends;
  for (std::size_t i = 0; i < chain.ends.size() && !chain.closed; ++i)
    ends.push_back(chain.ends[i] == subdivision::ChainEnd::Corner ? "corner" : "dart");
  return fields(named("edges", chain.edges), named("closed", chain.closed), named("ends", std::move(ends)),
                named("dihedral_min", in_degrees(chain.least_angle)),
                named("dihedral_max", in_degrees(chain.greatest_angle)),
                named("side_max", std::array{in_degrees(chain.side_angles[0]), in_degrees(chain.side_angles[1])}),
                named("length", chain.length), named("planar", chain.planar), named("deviation", chain.deviation),
                named("cage_edges", chain.cage_edges));
}

struct SubdivideResult {
  SubdivisionScheme scheme = SubdivisionScheme::DooSabin;
  std::vector<LevelCounts> levels;  ///< from the cage to the last level
  bool judged = false;              ///< the rest is known: not in drafts
  std::vector<SharpChain> chains;
  std::vector<double> continuity;  ///< greatest angle at untagged edges, per level, radians
  std::string verdict;             ///< how smooth the levels are, in one sentence
};

std::size_t byte_size(const SubdivideResult& result);

}  // namespace croquis

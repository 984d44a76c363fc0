// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "algorithms/silhouette/surface/shell.h"
#include "croquis/base/progress.h"

/// Attached parts become one surface.
namespace croquis::silhouette {

/// Why two parts could not become one surface.
enum class JoinFault {
  DontMeet,  ///< their surfaces have no point in common, or one lies within the other
  Unsolved,  ///< attached, one of them has no depth that can be trusted
  Unsound    ///< they have no sound union, or it lost a piece of what was drawn
};

struct FailedJoin {
  ObjectPair pair;
  JoinFault fault = JoinFault::Unsound;
  std::optional<Index> copied = {};  ///< the object whose copy on the far side can't be joined, where only that can't
};

struct PartJoining {
  std::vector<Shell> groups;       ///< of at least two parts each; they must be checked all the same
  std::vector<FailedJoin> failed;  ///< each pair once, ascending; none: all parts are in `groups`
};

/// Joins parts that are attached to each other, the largest first and then always the largest that is attached to what
/// is already joined. A pair that can't be joined is left out and reported; its parts may still be joined to others.
///
/// Exact predicates; new points are rounded to doubles. Slivers along the seams are removed after each part, which
/// moves the seams by no more than the length given: a later part that crosses a seam of slivers would find that they
/// cut one another, and so would a file that rounds to its digits.
/// @param parts  of different single objects, closed, outward, free of self-intersections; those in no pair are left
/// out
/// @param pairs  of the parts' objects
/// @param sliver seam edges shorter than this may go, sketch units
/// At most two unions per pair, each O(n log n) in practice. @throws Cancelled
PartJoining join_parts(std::span<const Shell* const> parts, std::span<const ObjectPair> pairs, double sliver,
                       Progress& progress);

/// Rounds the seams between joined parts: a band along each seam is triangulated anew, evenly, and then bent as little
/// as it can be (least squares of the Laplacian over the band; Kobbelt et al. 1998) while what lies around it stays.
/// Outlines stay lines of edges, and bend with the band: they are moved where they meet the other part, and only there.
/// @param radii  per pair of objects the half width of the band, sketch units; other seams stay sharp
/// @param finest length of the bands' edges at least, sketch units
/// @return none where there is nothing to round or the band can't be triangulated; what is returned must be checked for
///         intersections
/// O(n log n) in the vertices of the bands, O(n) in the others.
std::optional<Shell> blend_seams(const Shell& joined, const std::map<ObjectPair, double>& radii, double finest);

struct ImprovedUnion {
  Shell surface;
  std::vector<Index> changed;   ///< ascending, faces that aren't those of the surface given
  std::vector<Index> vertices;  ///< per vertex the one of the surface given
};

/// Makes the slender triangles of a joined surface wider, next to its seams above all: edges are flipped, vertices
/// moved within the surface, or onto one another. The surface moves by no more than a seventeenth of the edges there, a
/// change moves a seam by no more than a fortieth and an outline by a 250th of the edge that takes its place; what
/// faces the viewer still does. Only what lies beside a triangle is looked at: that nothing meets has to be checked.
/// @param kept per vertex, triangles there stay as they are
/// O(n) in practice.
ImprovedUnion improve_union(const Shell& joined, const std::vector<std::uint8_t>& kept, Progress& progress);

}  // namespace croquis::silhouette

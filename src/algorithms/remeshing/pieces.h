// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include "croquis/hole_filling/hole_analysis.h"
#include "croquis/hole_filling/hole_choice.h"
#include "croquis/remeshing/remesh.h"

namespace croquis::remeshing {

/// Where components go on in one another, as views of one thing do that overlap or don't quite meet.
struct ViewSeams {
  std::vector<std::pair<Index, Index>> joined;  ///< pairs of components of the view, the lower first, ascending
  std::vector<std::uint8_t> vertices;           ///< per vertex of the mesh, or none: 1 on a rim at a seam

  /// Per hole, or none: 1 for views' rims, which more than a fifth of lies at seams. They are no holes by themselves,
  /// unless a request names them.
  std::vector<std::uint8_t> rims;

  /// Components that face the other way than those that they lie upon, ascending: see minority_of. Nothing is joined
  /// by what is still to be turned.
  std::vector<Index> turned;

  bool at(Index vertex) const { return !vertices.empty() && vertices[vertex] != 0; }
  bool are_along(Index hole) const { return !rims.empty() && rims[hole] != 0; }
};

/// A rim vertex lies at a seam when another component has a vertex within three edges, nearer than one edge along both
/// normals, which are within 53 degrees. Two components are joined by 16 such vertices, if that is a tenth of the
/// rims of one of them. n log n.
///
/// Where normals are within 53 degrees of opposite ones and more vertices say so than the contrary, one of the two is
/// turned over. Walls have two such sides, too, but they are some way apart, and their rims run along each other:
/// nothing is turned where both rims do for four fifths of their length, unless the distance is less than 0.15 edges in
/// the mean, or where that is more than half an edge.
/// @param edge as typical_edge
ViewSeams find_view_seams(const PolyMesh& mesh, const hole_filling::HoleAnalysis& analysis,
                          const std::vector<hole_filling::HoleRequest>& requests, double edge);

/// Two components that lie upon each other along their rims.
struct ViewPair {
  Index first = no_index, second = no_index;
  std::size_t count = 0;  ///< of rim vertices where they do
  bool opposed = false;   ///< and face opposite ways there
};

/// Which components are to be turned over so that pairs agree, ascending: along the pairs with the largest counts
/// first, each component once; of those that are joined that way the smaller part by area, of two equal ones that
/// without the lowest component.
/// @param areas per component
std::vector<Index> minority_of(std::vector<ViewPair> pairs, const std::vector<double>& areas);

/// A part of the mesh that gets a function of its own: a component, or several that share vertices or a hole to fill,
/// or that are views of one thing.
struct RemeshPiece {
  std::vector<Index> vertices;             ///< of the view, ascending
  std::vector<Index> triangles;            ///< of the view, ascending
  std::vector<std::vector<Index>> groups;  ///< chosen holes that the field closes, those together that one sheet does
  std::vector<Index> caps;                 ///< chosen holes that patches close, ascending: the field ends at their rims
  std::vector<Index> seams;                ///< chosen rims at seams of views: what the field leaves open is patched
  bool ends = false;                       ///< has rims that the field ends at
  std::size_t views = 0;                   ///< that it was joined of; 0: no seams
  std::size_t islands = 0;                 ///< of these, pieces in holes of others

  /// Groups, caps and seams, ascending.
  std::vector<Index> chosen_holes() const;
};

/// What becomes of a rim, the stronger later: where several share a vertex the strongest holds there.
enum class RimRule {
  Field,  ///< the field closes it
  Seam,   ///< another view goes on there: the field ends only where all data are far
  Left,   ///< the field would lead away: it ends there, and a patch continues the surface
  Patch,  ///< the field ends there, and a patch closes it: a flat cap, or where no hole is but rim edges are
  Open    ///< a hole that wasn't chosen
};

/// A vertex on a rim.
struct RimPlace {
  Index vertex = 0;       ///< of the view
  Index hole = no_index;  ///< to be closed; no_index: stays open, or no hole is there
  RimRule rule = RimRule::Open;
  Vec3 outwards = Vec3::Zero();  ///< unit, the direction on from the surface; 0 where its edges give none
};

struct RemeshPieces {
  std::vector<RemeshPiece> pieces;  ///< by their lowest component
  std::vector<RimPlace> rims;       ///< by vertex, each once
  std::size_t left_out = 0;         ///< components below the least size

  /// Calls use(vertex's place in the piece's list, rim) for every rim vertex of a piece.
  template <typename Use>
  void for_each_rim(const RemeshPiece& piece, const Use& use) const {
    auto own = piece.vertices.begin();
    for (const RimPlace& rim : rims) {
      own = std::lower_bound(own, piece.vertices.end(), rim.vertex);
      if (own == piece.vertices.end()) return;
      if (*own == rim.vertex) use(static_cast<Index>(own - piece.vertices.begin()), rim);
    }
  }
};

/// @param seams of views, which are joined; @param options whether everything is one piece (Preset::Paper), and the
/// least size of components
RemeshPieces make_pieces(const PolyMesh& mesh, const hole_filling::HoleAnalysis& analysis,
                         const hole_filling::HoleChoice& choice, const ViewSeams& seams, const RemeshOptions& options);

/// Leaves those of a piece's groups of holes to patches for which that holds: where the field leads away.
void leave_to_patches(RemeshPieces& pieces, std::size_t piece,
                      const std::function<bool(const std::vector<Index>&)>& is_left);

}  // namespace croquis::remeshing

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "croquis/base/progress.h"
#include "croquis/geometry/vector.h"
#include "croquis/subdivision/half_edges.h"
#include "croquis/subdivision/level.h"
#include "croquis/subdivision/rules.h"

namespace croquis::subdivision {

/// What the sharp edges that meet at a vertex make of it. Lee, Joo, Hong 2002, section 3.1, knows creases; darts and
/// corners complete it.
enum class VertexClass : std::uint8_t {
  Plain,       ///< no sharp edge, three or more faces: Doo-Sabin's own rules
  ValenceTwo,  ///< no sharp edge, two faces: its face would have two corners
  Dart,        ///< one sharp edge: the end of a chain
  Crease,      ///< two: a chain passes
  Corner       ///< three or more, or pinned, or the only corner of a face on the boundary: stays where it is
};

/// An edge that is sharp in this refinement: tagged with sharpness 1 or more, or on the boundary.
struct SharpLine {
  Index edge = no_index;
  std::array<Index, 2> half_edges = {no_index, no_index};  ///< the second is missing on the boundary
  std::array<Index, 2> vertices = {no_index, no_index};    ///< in the direction of the first half-edge
  double sharpness = 0;                                    ///< infinite on the boundary

  bool on_boundary() const { return half_edges[1] == no_index; }
  std::size_t end_at(Index vertex) const { return vertices[0] == vertex ? 0 : 1; }
};

/// The tagged neighbourhood of a level, as lists.
struct TagClasses {
  std::vector<SharpLine> lines;
  IndexArray line_of_edge;            ///< #E, no_index where the edge isn't sharp
  std::vector<VertexClass> class_of;  ///< #V
  std::vector<std::uint8_t> pinned;   ///< #V
  std::vector<Index> special;         ///< vertices that aren't plain, ascending

  bool sharp(Index edge) const { return line_of_edge[edge] != no_index; }
};

/// Linear in the level, with lists of the tagged neighbourhood's size.
TagClasses classify(const Level& level, const CornerFaces& around, const Rules& rules);

/// The faces of a vertex between two sharp edges that follow one another counter-clockwise; at a dart all of them, from
/// its edge round to itself.
struct Sector {
  Index vertex = no_index;
  Index first_line = no_index, last_line = no_index;  ///< the sharp edges before the first and after the last face
  Index first_side = no_index, last_side = no_index;  ///< their sides within the sector
  Index begin = 0, end = 0;                           ///< its corners, in Sectors::corners
  bool banded = false;

  Index face_count() const { return end - begin; }
};

/// All sectors, vertex by vertex in ascending order, and which chains run beside a band.
struct Sectors {
  std::vector<Sector> list;
  std::vector<Index> corners;     ///< counter-clockwise, sector by sector
  std::vector<bool> side_banded;  ///< side 2i, 2i+1: the faces of line i's two half-edges

  std::span<const Index> corners_of(const Sector& sector) const {
    return std::span(corners).subspan(sector.begin, sector.face_count());
  }
  bool any_banded() const;
};

/// Finds sectors, joins their sides to strips, and bands the irregular ones.
///
/// Faces beside a regular strip share the chain's own points. That needs two faces in each sector a chain passes, one
/// at corners, three at darts: else it would cut faces in two or let them grow. An irregular strip gets a band of quads
/// between chain and faces instead, after which it is regular.
Sectors find_sectors(const Level& level, const CornerFaces& around, const TagClasses& classes);

/// The numbers 0 … count-1 without a few: those kept are numbered again in their order.
///
/// Costs memory for what is left out only, since that is little: tagged neighbourhoods are lines on a surface.
class Compaction {
 public:
  Compaction() = default;

  /// @param left_out below `count`, in any order, possibly repeated
  Compaction(std::vector<Index> left_out, std::size_t count) : left_out_(std::move(left_out)) {
    std::sort(left_out_.begin(), left_out_.end());
    left_out_.erase(std::unique(left_out_.begin(), left_out_.end()), left_out_.end());
    count_ = static_cast<Index>(count);
  }

  const std::vector<Index>& left_out() const { return left_out_; }  ///< ascending
  Index kept_count() const { return count_ - static_cast<Index>(left_out_.size()); }

  bool keeps(Index element) const { return !std::binary_search(left_out_.begin(), left_out_.end(), element); }

  /// How many of those left out come before `element`.
  Index left_out_before(Index element) const {
    return static_cast<Index>(std::lower_bound(left_out_.begin(), left_out_.end(), element) - left_out_.begin());
  }

  /// The new number of a kept element.
  Index rank(Index element) const { return element - left_out_before(element); }

  /// The kept element of that new number.
  Index element(Index rank) const {
    Index low = 0, high = static_cast<Index>(left_out_.size());  // the first left out that comes after the element
    while (low < high) {
      const Index middle = low + (high - low) / 2;
      if (left_out_[middle] - middle <= rank) {
        low = middle + 1;
      } else {
        high = middle;
      }
    }
    return rank + low;
  }

  /// Calls use(begin, end, rank of begin) for each run of kept elements that follow one another; long runs are cut, so
  /// that the caller can look at the cancel flag.
  template <typename Use>
  void for_each_run(Use&& use) const {
    constexpr Index longest = 1u << 16;
    Index begin = 0;
    for (std::size_t i = 0; i <= left_out_.size(); ++i) {
      const Index end = i < left_out_.size() ? left_out_[i] : count_;
      for (; begin < end; begin = std::min(end, begin + longest)) {
        use(begin, std::min(end, begin + longest), begin - static_cast<Index>(i));
      }
      begin = end + 1;
    }
  }

 private:
  std::vector<Index> left_out_;
  Index count_ = 0;
};

/// The vertices of the next level. First those of face corners, in the order of the corners; then, as a list, those of
/// chains, of kept vertices and of spokes.
///
/// Faces beside an unbanded chain use the chain's points in place of their own.
class NewPoints {
 public:
  NewPoints(const HalfEdges& mesh, const TagClasses& classes, const Sectors& sectors);

  std::size_t count() const { return own_.kept_count() + listed_.size(); }

  const Compaction& own() const { return own_; }                       ///< corners with a point of their own
  const std::vector<VertexOrigin>& listed() const { return listed_; }  ///< the others

  /// The point that a corner's face uses there; where all corners have their own, their number.
  Index at(Index corner) const { return points_.empty() ? corner : points_[corner]; }

  /// The point of a sharp edge's end (0 or 1 as in SharpLine::vertices). At a corner of the surface without bands it is
  /// the kept point.
  Index chain(Index line, std::size_t end) const { return chain_[line][end]; }
  Index chain_at(const TagClasses& classes, Index line, Index vertex) const {
    return chain(line, classes.lines[line].end_at(vertex));
  }

  Index kept(Index vertex) const { return find(kept_, vertex); }           ///< of a corner of the surface
  Index spoke(Index half_edge) const { return find(spokes_, half_edge); }  ///< no_index where there is none

 private:
  using Table = std::vector<std::pair<Index, Index>>;  ///< (element, point), ascending

  static Index find(const Table& table, Index element);
  Index list_point(const VertexOrigin& origin);
  void list_corner_points(const HalfEdges& mesh, const TagClasses& classes, const Sectors& sectors);
  void list_kept(const TagClasses& classes);
  void list_chain_ends(const TagClasses& classes, const Sectors& sectors);
  void list_spokes(const HalfEdges& mesh, const TagClasses& classes, const Sectors& sectors);

  Compaction own_;
  IndexArray points_;  ///< #C, empty where all corners have points of their own
  std::vector<std::array<Index, 2>> chain_;
  Table kept_, spokes_;
  std::vector<VertexOrigin> listed_;
};

/// Which elements of a level take the plain rules.
struct PlainParts {
  Compaction edges;              ///< both ends plain: their face is a quad
  Compaction vertices;           ///< plain, with plain edges: their face and all its neighbours are plain too
  Compaction faces;              ///< without corners that aren't plain
  std::vector<Index> bordering;  ///< plain vertices with edges that aren't, ascending
};

PlainParts find_plain_parts(const HalfEdges& mesh, const CornerFaces& around, const TagClasses& classes);

/// New faces listed corner by corner.
struct FaceList {
  std::vector<Index> offsets = {0};
  std::vector<Index> vertices;
  std::vector<FaceOrigin> origins;

  std::size_t size() const { return origins.size(); }
  std::span<const Index> operator[](std::size_t f) const {
    return std::span(vertices).subspan(offsets[f], offsets[f + 1] - offsets[f]);
  }
};

/// What the tagged neighbourhood needs, together; references to what lives during one refinement.
struct Neighbourhood {
  const Level& level;
  const CornerFaces& around;
  const TagClasses& classes;
  const Sectors& sectors;
  const NewPoints& points;
};

/// The new faces of all edges and vertices that aren't plain, and the bands. Vertices that follow one another are
/// dropped when equal, faces left with two corners too: the edges on both sides then are one.
FaceList list_special_faces(const Neighbourhood& near, const PlainParts& plain);

/// Where the parts of the next level lie. Its faces and their corners in this order: the old faces' (with the corners'
/// old numbers), the quads of plain edges, the faces of plain vertices, the listed ones.
struct Layout {
  Index quads_begin = 0;  ///< first corner of each part
  Index vertex_faces_begin = 0;
  Index listed_begin = 0;
  std::size_t vertices = 0, edges = 0, faces = 0, corners = 0;
};

/// Memory of a refinement, kept for the next.
struct FlatScratch {
  IndexArray quad_of_edge;  ///< #E old: the first corner of its quad, no_index without
  IndexArray turned;        ///< #C old: the next corner counter-clockwise around the vertex
};

void number_quads(const HalfEdges& old, const PlainParts& plain, const Layout& layout, FlatScratch& scratch);

/// Which corner of its edge's quad takes a half-edge's place: each half-edge of an edge fills two corners.
inline Index quad_corner(const HalfEdges& old, const FlatScratch& scratch, Index half_edge) {
  return scratch.quad_of_edge[old.corner_edge[half_edge]] + (half_edge < old.twin[half_edge] ? 0 : 2);
}

/// Doo, Sabin 1978: all that follows from the old numbers alone, without a search. Fills everything of `next`, whose
/// arrays have their sizes, but what belongs to listed faces or to edges that aren't plain.
void connect_plain_parts(const HalfEdges& old, const NewPoints& points, const PlainParts& plain, const Layout& layout,
                         FlatScratch& scratch, HalfEdges& next, const Progress& progress);

}  // namespace croquis::subdivision

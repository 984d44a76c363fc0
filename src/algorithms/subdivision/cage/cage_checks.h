// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "croquis/base/finding.h"
#include "croquis/geometry/poly_mesh.h"
#include "croquis/geometry/vector.h"
#include "croquis/subdivision/cage.h"
#include "croquis/subdivision/half_edges.h"

/// What a mesh lacks to be a cage, in sentences.
namespace croquis::subdivision {

/// The corners of a mesh by the edges that they start, in either direction.
class EdgePairing {
 public:
  /// Corners of faces in `left_out` (#F flags) start no edge. Linear time for bounded valences.
  /// @param mesh indices in range
  EdgePairing(const PolyMesh& mesh, const std::vector<bool>& left_out);

  /// Every corner that starts the edge between two vertices, ascending; empty where there is no edge.
  std::span<const Index> corners(Index a, Index b) const;

  /// Calls use(corners) for every edge, by ascending lower and then higher vertex.
  template <typename Use>
  void for_each_edge(Use&& use) const {
    for (std::size_t begin = 0; begin < entries_.size();) {
      std::size_t end = begin + 1;
      while (end < entries_.size() && same_edge(begin, end)) ++end;
      use(std::span<const Index>(corners_).subspan(begin, end - begin));
      begin = end;
    }
  }

 private:
  struct Entry {
    Index low, high;
  };
  bool same_edge(std::size_t i, std::size_t j) const {
    return entries_[i].low == entries_[j].low && entries_[i].high == entries_[j].high;
  }

  std::vector<Index> low_offsets_;  ///< #V+1, into the two below
  std::vector<Entry> entries_;      ///< by low, then high
  std::vector<Index> corners_;
};

struct Orientation {
  std::vector<bool> flipped;                         ///< #F; of each connected part the fewer, on a tie not its first
  std::vector<std::array<Index, 2>> contradictions;  ///< an edge of each part that can't be oriented
};

/// Flips faces until neighbours agree: flood fill across edges of exactly two faces. Linear time.
Orientation orient(const PolyMesh& mesh, const EdgePairing& pairing);

/// What became of the vertices of a mesh whose vertices may have any number of fans.
struct VertexFans {
  std::vector<Index> source_vertex;  ///< #V of the fans -> vertex before
  std::vector<Index> split;          ///< vertices that had several fans, ascending
  std::vector<Index> loose;          ///< vertices that had none, ascending
};

/// Makes each fan a vertex of its own: by old vertex, then by lowest corner. Rewrites corner_vertex and fills
/// vertex_corner. Linear time.
/// @param mesh all but vertex_corner filled
VertexFans split_vertices_into_fans(HalfEdges& mesh, std::size_t vertex_count);

/// Findings of one code, one per element. The first hundred are kept, more would hide the others; the last one kept
/// gives their number.
class FindingList {
 public:
  FindingList(Severity severity, Category category, std::string code);

  /// @param sentence without its full stop; called for those that are kept
  void add(std::vector<Subject> subjects, const std::function<std::string()>& sentence);

  bool empty() const { return count_ == 0; }
  void move_to(Findings& findings);

 private:
  Severity severity_;
  Category category_;
  std::string code_;
  std::size_t count_ = 0;
  Findings kept_;
};

Subject face_subject(std::size_t face);
Subject vertex_subject(std::size_t vertex);

std::string edge_name(std::size_t a, std::size_t b);  ///< "edge (a,b)"

/// E_INDEX, E_NOT_FINITE, E_FACE_DEGENERATE. The first kind leaves nothing to look at further.
Findings check_values(const PolyMesh& mesh);

/// #F: faces with fewer than three corners or repeated vertices.
std::vector<bool> degenerate_faces(const PolyMesh& mesh);

/// E_EDGE_SHARED
void check_sharing(const PolyMesh& mesh, const EdgePairing& pairing, Findings& findings);

/// E_NOT_ORIENTABLE
void check_orientable(const Orientation& orientation, Findings& findings);

/// W_FLIPPED, all in one
void tell_flipped(const std::vector<Index>& faces, Findings& findings);

/// W_BOWTIE, W_LOOSE_VERTEX
void tell_fans(const VertexFans& fans, Findings& findings);

/// W_MAY_FOLD
void tell_reflex_corners(const PolyMesh& mesh, Findings& findings);

/// What reading tags needs of a mesh and its cage, whose topology is complete.
struct TagSource {
  const PolyMesh& mesh;
  const EdgePairing& pairing;
  const std::vector<Index>& cage_corner;  ///< #C of the mesh -> half-edge of the cage
};

/// Puts the mesh's tags onto the cage; W_TAG_NO_EDGE, W_TAG_SHARPNESS.
void read_sharpness(const TagSource& source, Cage& cage, Findings& warnings);

/// Puts the mesh's pins onto the cage, whose sharpness is known; W_PIN_NO_EFFECT.
void read_pins(const PolyMesh& mesh, CageUse use, Cage& cage, Findings& warnings);

/// W_TAG_VANISHES: edges that are sharp alone and retract at both ends.
void tell_vanishing_tags(const Cage& cage, const Rules& rules, Findings& warnings);

}  // namespace croquis::subdivision

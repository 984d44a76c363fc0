// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "croquis/geometry/poly_mesh.h"

namespace croquis {

/// Lists of indices behind one another: list i is [offsets[i], offsets[i+1]) of `values`.
struct IndexTable {
  std::vector<Index> offsets = {0};
  std::vector<Index> values;

  std::size_t size() const { return offsets.size() - 1; }
  std::span<const Index> operator[](std::size_t i) const {
    return {values.data() + offsets[i], values.data() + offsets[i + 1]};
  }
};

/// The neighbourhoods of a mesh: built once, never changed, independent of the mesh's life.
///
/// Any soup is accepted: edges with any number of faces, faces with repeated vertices, vertices without faces, sheets
/// that can't be oriented. "Corner" is an index into PolyMesh::corners; it stands for its vertex in its face and for
/// the edge from there to the face's next corner.
/// Linear in time and memory for bounded valences (a vertex of valence k costs k log k). Reading is thread-safe.
class MeshTopology {
 public:
  /// @throws Error (E_INDEX) when offsets or corners are out of range
  explicit MeshTopology(const PolyMesh& mesh);

  std::size_t vertex_count() const { return vertex_corners_.size(); }
  std::size_t face_count() const { return face_offsets_.size() - 1; }
  std::size_t corner_count() const { return corner_vertex_.size(); }
  std::size_t edge_count() const { return edge_corners_.size(); }

  Index vertex(Index corner) const { return corner_vertex_[corner]; }
  Index face(Index corner) const { return corner_face_[corner]; }

  /// Around its face.
  Index next(Index corner) const {
    if (is_of_triangles_) return corner % 3 == 2 ? corner - 2 : corner + 1;
    const Index face = corner_face_[corner];
    return corner + 1 == face_offsets_[face + 1] ? face_offsets_[face] : corner + 1;
  }

  /// Around its face.
  Index previous(Index corner) const {
    if (is_of_triangles_) return corner % 3 == 0 ? corner + 2 : corner - 1;
    const Index face = corner_face_[corner];
    return corner == face_offsets_[face] ? face_offsets_[face + 1] - 1 : corner - 1;
  }

  /// The edge that a corner starts, or no_index where the next corner repeats the vertex. Edges are numbered by their
  /// lowest corner.
  Index edge(Index corner) const { return corner_edge_[corner]; }

  /// Every corner that starts the edge, ascending; one for a boundary edge, more than two for a non-manifold one.
  std::span<const Index> edge_corners(Index edge) const { return edge_corners_[edge]; }

  /// The ends, in the direction of the edge's lowest corner.
  std::array<Index, 2> edge_vertices(Index edge) const;

  /// The other corner of an edge that has exactly two, else no_index. Both run the same way where faces disagree.
  Index opposite(Index corner) const {
    if (corner_edge_[corner] == no_index) return no_index;
    const auto corners = edge_corners_[corner_edge_[corner]];
    if (corners.size() != 2) return no_index;
    return corners.front() == corner ? corners.back() : corners.front();
  }

  std::span<const Index> vertex_corners(Index vertex) const { return vertex_corners_[vertex]; }  ///< ascending

  /// Umbrellas of a vertex: its corners joined across edges with exactly two. 0 for a vertex without faces; 1 for a
  /// manifold vertex.
  Index fan_count(Index vertex) const { return fans_of_vertex_[vertex]; }

  /// Which of its vertex' fans a corner is in: 0 … fan_count-1, numbered by their lowest corner.
  Index fan(Index corner) const { return corner_fan_[corner]; }

  /// True unless the faces around the vertex form more than one fan or meet at an edge with more than two.
  bool is_manifold(Index vertex) const;

  /// Simple closed rims: vertices in the direction of the faces where these agree, the lowest first; ordered by their
  /// first vertices. Walks stay in a fan where they can and are cut wherever a vertex comes again. A rim that ends at
  /// an edge with more than two faces is listed as a loop too, closed across that gap, in the order walked.
  const IndexTable& boundary_loops() const { return boundary_loops_; }

  /// Faces joined across edges of any number of faces; numbered by their lowest face. Vertices without faces belong to
  /// no component.
  std::size_t component_count() const { return component_count_; }
  Index component(Index face) const { return face_component_[face]; }

 private:
  void number_fans();

  bool is_of_triangles_ = false;  ///< and nothing else, as most meshes: corners go round by threes
  std::vector<Index> face_offsets_;
  std::vector<Index> corner_vertex_, corner_face_, corner_edge_, corner_fan_;
  std::vector<Index> fans_of_vertex_, face_component_;
  IndexTable edge_corners_, vertex_corners_, boundary_loops_;
  std::size_t component_count_ = 0;
};

}  // namespace croquis

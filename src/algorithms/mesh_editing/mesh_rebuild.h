// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "croquis/mesh_editing/mesh_edit.h"

/// What all edits of meshes share: making the new value from a plan of where everything comes from.
namespace croquis {

/// A value between two old elements, or that of one.
struct Blend {
  Index a = no_index;
  Index b = no_index;  ///< no_index: `a` alone
  double t = 0;        ///< 0 at a, 1 at b
};

/// A mesh to be: where its vertices, corners and faces come from.
struct MeshPlan {
  std::vector<Blend> vertices;            ///< #V new, of old vertices
  std::vector<Index> face_offsets = {0};  ///< #F+1 new
  std::vector<Index> corners;             ///< #C new: new vertices
  std::vector<Blend> corner_source;       ///< #C new, of old corners
  std::vector<Index> face_source;         ///< #F new: the old face whose attributes each gets

  void add_corner(Index vertex, const Blend& source) {
    corners.push_back(vertex);
    corner_source.push_back(source);
  }
  void end_face(Index source) {
    face_offsets.push_back(static_cast<Index>(corners.size()));
    face_source.push_back(source);
  }
};

/// A plan that begins with all old vertices.
MeshPlan plan_with_vertices_of(const PolyMesh& mesh);

/// Adds an old face as it is.
void keep_face(MeshPlan& plan, const PolyMesh& mesh, Index face);

/// Old vertices that nothing of the plan uses any more go, but those that had no faces before stay.
/// @param loose  sorted; those that go all the same
/// @return per old vertex (the plan's vertices, which begin with the old ones) its new number, or no_index
std::vector<Index> drop_unused_vertices(MeshPlan& plan, const MeshTopology& before, std::span<const Index> loose = {});

/// The planned mesh without tags. Attributes and polylines that can't be kept are listed in `lost`.
/// @param new_vertex per old vertex its new number or no_index
MeshEdit rebuilt(const PolyMesh& old, const MeshPlan& plan, const std::vector<Index>& new_vertex);

using VertexPair = std::array<Index, 2>;

/// Lower index first.
VertexPair ordered_pair(Index a, Index b);

/// What becomes of tags: the pairs that an old edge's tag goes to and the vertices that a pin goes to; none drops it.
struct TagMap {
  std::function<std::vector<VertexPair>(const VertexPair& edge)> edge;
  std::function<std::vector<Index>(Index vertex)> pin;
};

/// Carries the old tags over, the sets too, and lists the ones that found no place. A pair that two edges go to gets
/// the sharper tag.
void carry_tags(const MeshTags& old, const TagMap& map, MeshEdit& edit);

/// "1 edge (0, 4)", "12 edges (0, 4), (4, 5), (5, 6) …".
std::string named_edges(const std::vector<VertexPair>& edges);

/// Normals from a file become "none here" (NaN) at vertices, and at faces and corners of faces, of which a vertex is
/// marked.
void forget_normals(PolyMesh& mesh, const std::vector<char>& moved_vertices);

}  // namespace croquis

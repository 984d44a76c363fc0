// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <vector>

#include <Eigen/Geometry>

#include "croquis/base/finding.h"
#include "croquis/geometry/mesh_topology.h"
#include "croquis/mesh_editing/mesh_selection.h"

/// Every change that the tools make to a mesh: pure functions from a mesh to a mesh. Linear in the mesh.
///
/// Tags follow their edges and vertices: both parts of a cut edge inherit sharpness and sets. Attributes are carried
/// over: new vertices and corners get blended floating values and colours, else those of the nearer end; new faces
/// those of the face they come from. Whatever can't follow is reported.
namespace croquis {

/// A mesh after an edit, and where everything in it comes from.
struct MeshEdit {
  PolyMesh mesh;
  std::vector<Index> vertex_source;  ///< #V: the old vertex that each is, or was copied from; no_index for new ones
  std::vector<Index> face_source;    ///< #F: the old face that each is, or is a piece of; no_index for new ones
  std::vector<std::array<Index, 2>> new_edges;  ///< of a loop cut: the edges of the new loop, by their vertices
  Elements new_faces;                           ///< of an extrusion or inset: its walls
  Elements moved_faces;                         ///< of an extrusion or inset: the faces inside
  Findings lost;  ///< warnings: W_TAGS_DROPPED, W_ATTRIBUTE_DROPPED, W_LINES_DROPPED, W_NOT_DISSOLVED
};

/// Old elements as the edited mesh has them: each becomes all that came from it. Edges follow their ends.
Elements carried(const MeshEdit& edit, const MeshTopology& before, const MeshTopology& after, ComponentKind kind,
                 std::span<const Index> elements);

/// Edges given by their vertices. Pairs that are no edges are left out.
Elements edges_of(const MeshTopology& topology, std::span<const std::array<Index, 2>> pairs);

/// Moves vertices. Normals that came with the mesh become "none here" (NaN) where the surface changes its shape.
/// @param vertices each once; those out of range are left out
PolyMesh transformed(PolyMesh mesh, std::span<const Index> vertices, const Eigen::Affine3d& map);

/// Cuts all edges of an edge's ring and the quads between them. A face at the end of the ring gets the cut's end as one
/// more corner, so no gap opens; a quad that the ring crosses twice is cut once.
/// @param at 0..1 from the edge's first vertex (MeshTopology::edge_vertices); clamped to 0.001 … 0.999, so that no
///           edge of length 0 arises
/// @throws Error (E_INPUT) when there is no such edge
MeshEdit loop_cut(const PolyMesh& mesh, const MeshTopology& topology, Index edge, double at = 0.5);

/// The new loop without making the mesh: one place per edge of the ring, in its order.
struct LoopCutPreview {
  std::vector<Vec3> points;
  bool closed = false;
};
LoopCutPreview loop_cut_preview(const PolyMesh& mesh, const MeshTopology& topology, Index edge, double at = 0.5);

/// Lifts faces off and joins them to where they were by walls. Neighbours stay together. Tags of the lifted faces'
/// edges and vertices go with them, the rim's too; the walls' own edges have none.
/// @throws Error (E_INPUT) when no face is given
MeshEdit extrude_faces(const PolyMesh& mesh, const MeshTopology& topology, std::span<const Index> faces,
                       const Vec3& offset);

/// Draws the border of faces inwards, within their planes, and fills the strip between with quads. Neighbours stay
/// together; the border of the mesh is drawn inwards as well. Tags go as in an extrusion.
/// @param width model units, the distance of each new edge from the old one; not below 0
/// @throws Error (E_INPUT) when no face is given, or when one has no room for the width (it names a width that fits)
MeshEdit inset_faces(const PolyMesh& mesh, const MeshTopology& topology, std::span<const Index> faces, double width);

/// Area-weighted mean normal of faces, unit length; zero when they cancel out.
Vec3 mean_normal(const PolyMesh& mesh, std::span<const Index> faces);

/// Removes faces, and the vertices that only they had.
MeshEdit delete_faces(const PolyMesh& mesh, const MeshTopology& topology, std::span<const Index> faces);

/// Unites the two faces of each edge, and then removes vertices at which only two edges of those would be left. Where
/// the union would have a hole, touch itself or have no rim, its faces stay as they are, with W_NOT_DISSOLVED; rims
/// stay.
MeshEdit dissolve_edges(const PolyMesh& mesh, const MeshTopology& topology, std::span<const Index> edges);

/// Unites the faces around each vertex into one without it. A vertex on the rim is cut off; faces that would keep
/// fewer than three corners vanish. Vertices without faces are removed.
MeshEdit dissolve_vertices(const PolyMesh& mesh, const MeshTopology& topology, std::span<const Index> vertices);

}  // namespace croquis

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <map>
#include <vector>

#include "croquis/geometry/mesh_tags.h"
#include "croquis/geometry/mesh_topology.h"
#include "croquis/geometry/poly_mesh.h"

namespace croquis::subdivision {

/// Adds to the tags of a mesh without listing anything twice.
class TagChanges {
 public:
  explicit TagChanges(MeshTags& tags);

  /// An infinite crease. A finite one becomes infinite and leaves the named sets, whose members share one sharpness.
  void add_crease(std::array<Index, 2> vertices);
  void add_pin(Index vertex);
  void finish();  ///< sorts the pins

 private:
  MeshTags& tags_;
  std::map<std::array<Index, 2>, std::size_t> crease_of_;
};

/// Triangles that replace a face, as corner numbers within it.
using FaceTriangles = std::vector<std::array<Index, 3>>;

/// The greatest distance of a corner from the plane through the face's centre, relative to the face's diameter.
double relative_deviation(const PolyMesh& mesh, Index face);

/// Cuts a face as polygon_cut does, but avoids diagonals that are edges of the mesh already where there is another.
FaceTriangles triangulated_face(const PolyMesh& mesh, const MeshTopology& topology, Index face);

struct CutMesh {
  PolyMesh mesh;
  std::vector<Index> source_face;  ///< #F of `mesh`
};

/// Replaces faces by triangles, in place of the face; attributes of faces and corners are those of the source.
CutMesh with_faces_cut(const PolyMesh& mesh, const std::map<Index, FaceTriangles>& cuts);

}  // namespace croquis::subdivision

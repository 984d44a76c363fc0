// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "croquis/base/progress.h"
#include "croquis/geometry/poly_mesh.h"
#include "croquis/geometry/vector.h"

/// The parts of GLB files, as they are written.
namespace croquis {

/// Where the numbers of an attribute are among those of a vertex: a normal, a colour with 3 or 4 parts, a place in a
/// texture.
constexpr std::size_t glb_normal = 0, glb_colour = 3, glb_uv = 7, glb_numbers = 9;

/// Members of a mesh's `extras` that are true or missing; viewers pass over them.
struct GlbExtras {
  static constexpr const char* computed_normals = "computed_normals";  ///< reading makes no attribute of them
  static constexpr const char* groups = "groups";  ///< the names of its materials are those of groups of faces
};

/// A vertex of the file: a vertex of the mesh, and what its corners there have in common.
struct GlbVertex {
  Index vertex = 0;
  std::array<float, glb_numbers> numbers{};
};

/// Faces that share a material.
struct GlbPart {
  std::string name;                      ///< empty: none
  std::vector<std::uint32_t> triangles;  ///< #T * 3, vertices of the object
};

struct GlbObject {
  std::string name;                     ///< empty: none
  std::vector<GlbVertex> vertices;      ///< in the order of the mesh's vertices
  std::vector<GlbPart> parts;           ///< in the order of their first faces
  std::vector<std::uint32_t> segments;  ///< #S * 2, of polylines
};

/// A mesh as GLB files hold it. Vertices are split where their corners have different normals, colours or places in a
/// texture.
struct GlbObjects {
  std::vector<GlbObject> objects;  ///< by the "object" of faces and lines, in the order of their first elements
  bool has_normals = false;
  bool normals_computed = false;  ///< by angle and tags, as in pictures; else those of the mesh
  bool has_groups = false;        ///< parts are groups, as there are no materials
  int colour_width = 0;           ///< 0: no colours
  bool has_uv = false;
  bool keeps_order = true;                       ///< of vertices, when objects are read one after the other
  std::vector<const AttributeChannel*> written;  ///< channels that are in it
};

/// @param positions as they are written, of which faces are cut into triangles
/// @throws Cancelled
GlbObjects glb_objects(const PolyMesh& mesh, const std::vector<Vec3>& positions, const Progress& progress);

}  // namespace croquis

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include <glm/glm.hpp>

#include "croquis/geometry/poly_mesh.h"
#include "croquis/render/bounds.h"
#include "croquis/render/color.h"

namespace croquis::render {

/// A corner of a triangle as the graphics card takes it.
struct SurfaceVertex {
  glm::vec3 position;  ///< in the item's own frame
  glm::vec3 normal;    ///< unit length, or 0 where all faces around have no area
  Color color;
  std::uint32_t patch = 0;  ///< the smooth patch it belongs to, 0-based; lines are drawn where patches meet
};

/// An end of a line segment.
struct LineVertex {
  glm::vec3 position;  ///< in the item's own frame
  Color color;
};

/// How a mesh is made ready for display.
struct MeshItemOptions {
  double crease_angle =
      1.0471975511965976;                ///< radians in [0, pi]: faces that meet at more are shaded apart (60 degrees)
  Color line_color = {46, 58, 72, 255};  ///< of polylines without colours of their own
};

/// A mesh ready to be drawn: never changed once made, shared between scenes, undo steps and views.
///
/// Positions are kept relative to the box's centre and in units of its half diagonal, so that single precision serves
/// coordinates of any size.
struct MeshItem {
  glm::dvec3 origin = glm::dvec3(0);  ///< model coordinates = origin + scale * own coordinates
  double scale = 1;
  Bounds bounds;  ///< in model coordinates, of what is drawn
  std::vector<SurfaceVertex> vertices;
  std::vector<std::uint32_t> triangles;  ///< #T * 3, indices into vertices
  std::vector<std::uint32_t> edges;      ///< #E * 2, indices into vertices: the polygons' edges, each once
  std::vector<LineVertex> line_vertices;
  std::vector<std::uint32_t> segments;  ///< #S * 2, indices into line_vertices
  std::uint32_t patch_count = 0;
};

using MeshItemPtr = std::shared_ptr<const MeshItem>;

/// Makes a mesh ready: polygons (concave ones too) are cut into triangles, normals are averaged by angle over faces
/// that meet below the crease angle, vertices at exactly equal places count as one.
///
/// Colours come from a "color" channel of the faces, corners or vertices; else from a palette by "object", by "group",
/// or by connected component, the first of these that tells at least two apart. A missing (NaN) colour falls back to
/// the palette.
/// @throws Error when `validate(mesh)` finds indices, offsets or coordinates that can't be drawn; faces without area
///         are accepted
/// O(n log n), and O(k^2) for a polygon of k corners.
MeshItemPtr make_mesh_item(const PolyMesh& mesh, const MeshItemOptions& options = {});

/// The box of everything in the list; empty for none.
Bounds bounds_of(const std::vector<MeshItemPtr>& items);

/// Every vertex drawn, in model coordinates: what `frame` puts into the picture.
std::vector<glm::dvec3> points_of(const std::vector<MeshItemPtr>& items);

/// The i-th colour of the palette: muted, told apart by people with any colour vision too, repeating after eight.
Color palette_color(std::size_t index);

}  // namespace croquis::render

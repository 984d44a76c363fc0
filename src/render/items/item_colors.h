// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "croquis/geometry/poly_mesh.h"
#include "croquis/render/mesh_item.h"

namespace croquis::render {

/// Which part of the mesh each face belongs to, numbered from 0 as the faces come: by "object", by "group" or by
/// connected component, the first of these that gives at least two parts.
/// @param welded the vertex that stands for all at its place, for each vertex
std::vector<Index> face_parts(const PolyMesh& mesh, std::span<const Index> welded);

/// The colours that a mesh has itself.
class OwnColors {
 public:
  explicit OwnColors(const PolyMesh& mesh);

  /// From a "color" channel of the faces, corners or vertices, the first of these that has one for the corner.
  std::optional<Color> of(std::size_t face, std::size_t corner) const;

 private:
  const PolyMesh& mesh_;
  const AttributeChannel* by_face_;
  const AttributeChannel* by_corner_;
  const AttributeChannel* by_vertex_;
};

/// The colour of each corner: from a "color" channel, else from the palette by part.
std::vector<Color> corner_colors(const PolyMesh& mesh, std::span<const Index> parts);

/// The colour of each vertex of each polyline, in the order of `line_vertices`: from a "color" channel of the lines or
/// vertices, else the one given.
std::vector<Color> line_colors(const PolyMesh& mesh, const Color& fallback);

}  // namespace croquis::render

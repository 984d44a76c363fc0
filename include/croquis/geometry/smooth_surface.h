// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <vector>

#include "croquis/geometry/poly_mesh.h"

namespace croquis {

/// Which corners and faces of a mesh are shaded as one smooth surface.
struct SmoothSurface {
  std::vector<Index> corner_groups;  ///< #C: corners around a vertex with one normal; 0-based, dense, as corners come
  Index group_count = 0;
  std::vector<Index> face_patches;  ///< #F, 0-based, dense: faces joined by smooth edges
  Index patch_count = 0;
  std::vector<std::array<Index, 2>> edges;  ///< #E by 2: each polygon edge once, as two corners of one face
};

/// Where pictures and files shade faces apart: at more than this angle (radians), and at tags of this sharpness.
inline constexpr double usual_crease_angle = 1.0471975511965976;  // 60 degrees
inline constexpr double usual_split_sharpness = 1;

/// Where a surface is sharp.
struct Sharpness {
  double crease_angle = 0;                         ///< radians: faces that meet at more are shaded apart
  std::vector<std::array<Index, 2>> tagged_edges;  ///< the same at any angle, by welded vertices, lower first, sorted
};

/// The edges of at least that sharpness, as `Sharpness` wants them.
std::vector<std::array<Index, 2>> tagged_edges(const MeshTags& tags, std::span<const Index> welded, double least);

/// The lowest vertex at exactly the same place, for each vertex.
std::vector<Index> joined_places(std::span<const Vec3> positions);

/// Two faces are smooth across an edge that they alone share, in opposite senses, at an angle below the crease angle,
/// when both have an area and no tag makes it sharp.
/// @param positions #V, not so large or small that products of three coordinates leave the range of double
/// @param welded as from joined_places
/// @param face_parts #F: patches never reach across parts (normals do)
SmoothSurface find_smooth_surface(const PolyMesh& mesh, std::span<const Vec3> positions, std::span<const Index> welded,
                                  std::span<const Index> face_parts, const Sharpness& sharpness);

}  // namespace croquis

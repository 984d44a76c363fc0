// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "croquis/geometry/vector.h"

namespace croquis {

/// A mesh's faces as arrays: offsets #F+1 into corners, which are vertices.
struct FaceArrays {
  std::span<const Index> offsets;
  std::span<const Index> corners;

  std::size_t face_count() const { return offsets.size() - 1; }
};

/// The unit normal of each face, along its area vector; 0 for faces without area.
std::vector<Vec3> face_normals(const FaceArrays& faces, std::span<const Vec3> positions);

/// For each group of corners the normals of their faces, weighted by the angles at the corners; unit length or 0.
/// @param corner_groups #C, 0 … group_count-1
std::vector<Vec3> group_normals(const FaceArrays& faces, std::span<const Vec3> positions,
                                std::span<const Index> corner_groups, std::size_t group_count);

}  // namespace croquis

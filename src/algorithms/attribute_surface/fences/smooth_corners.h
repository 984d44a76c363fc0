// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "algorithms/attribute_surface/fences/corner_normals.h"
#include "algorithms/attribute_surface/fences/normal_fences.h"
#include "croquis/geometry/vector.h"

namespace croquis {

/// A corner of a face: where its side begins.
struct FaceCorner {
  Index face = no_index;
  std::size_t side = 0;
};

/// Corners of faces that meet smoothly, in one place.
struct CornerGroup {
  std::vector<FaceCorner> corners;
  Vec3 normal = Vec3::Zero();  ///< unit, for the first corner's face
  bool knife_edge = false;     ///< the faces' own normals point away from each other: there is no common one
};

/// By face, what its loop is like. Faces without a fence have none.
struct FaceShape {
  std::vector<DirectedCurve> loop;
  LoopNormals normals;
};

/// The common normals of corners that smooth curves join.
class SmoothCorners {
 public:
  SmoothCorners(const FenceInput& input, const std::vector<bool>& smooth, const std::vector<FaceShape>& shapes);

  const CornerGroup& group(const FaceCorner& corner) const { return groups_[entry(corner).group]; }

  /// The group's normal as that face has it: turned round where its loop runs the other way.
  Vec3 normal(const FaceCorner& corner) const;

 private:
  struct Entry {
    std::size_t group = 0;
    bool turned = false;  ///< against the group's first corner
  };
  struct Link {
    std::size_t other = 0;
    bool turned = false;
  };

  const Entry& entry(const FaceCorner& corner) const { return entries_[number(corner)]; }
  std::size_t number(const FaceCorner& corner) const { return first_of_face_[corner.face] + corner.side; }
  void link_along(const FenceInput& input, Index curve);
  void gather(std::size_t first);

  const std::vector<FaceShape>& shapes_;
  std::vector<std::size_t> first_of_face_;
  std::vector<FaceCorner> corners_;
  std::vector<std::vector<Link>> links_;
  std::vector<Entry> entries_;
  std::vector<CornerGroup> groups_;
};

/// Which side of a face a curve is. @pre it is one
std::size_t side_of(const AttributeFace& face, Index curve);

}  // namespace croquis

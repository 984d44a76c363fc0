// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "croquis/geometry/poly_mesh.h"
#include "geometry/shared_corners.h"

namespace croquis {

/// A triangle with an area, and the values that the fast tests need.
struct MeetingTriangle {
  std::array<Index, 3> vertices{};
  double longest = 0;  ///< its longest edge, squared
};

/// Whether triangles over common positions meet anywhere but in the vertices and edges they share: exactly, but most
/// pairs are decided by a separating plane that is certain in floating point.
class TriangleMeeting {
 public:
  /// Keeps a reference.
  explicit TriangleMeeting(const std::vector<Vec3>& positions) : positions_(positions) {}

  /// Whether the three vertices span an area, exactly; if so, the pair tests accept the triangle.
  bool make(const std::array<Index, 3>& vertices, MeetingTriangle& triangle) const;

  /// @param shared the corners that the two have in common
  bool operator()(const MeetingTriangle& a, const MeetingTriangle& b, const SharedCorners& shared) const;

 private:
  using Corners = std::array<Index, 3>;

  bool meet_anywhere(const Corners& u, const Corners& v) const;
  bool meet_beyond_vertex(const Corners& u, const Corners& v) const;
  bool fold_over(const Corners& u, const Corners& v) const;
  bool clearly_apart(const Corners& u, const Corners& v) const;
  bool clearly_apart_around_vertex(const Corners& u, const Corners& v, double longest) const;
  bool clearly_unfolded(const Corners& u, const Corners& v, double longest) const;

  const std::vector<Vec3>& positions_;
};

}  // namespace croquis

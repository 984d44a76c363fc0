// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "croquis/geometry/vector.h"

/// The polygons of one cube.
///
/// Corner c of a cube lies at (c & 1, c >> 1 & 1, c >> 2 & 1). Edge 4 a + b runs along axis a; the two bits of b place
/// it along the axes a+1 and a+2 (cyclically). Face 2 a + s is that with coordinate a equal to s.
namespace croquis::implicit {

/// Axis of an edge and the corner at which it starts.
struct CubeEdge {
  int axis;
  unsigned corner;
};

constexpr CubeEdge cube_edge(unsigned edge) {
  const unsigned axis = edge / 4;
  const unsigned b = edge % 4;
  return {static_cast<int>(axis), (b & 1U) << ((axis + 1) % 3) | (b >> 1) << ((axis + 2) % 3)};
}

/// The two faces that an edge lies in, one bit per face.
constexpr unsigned faces_of_edge(unsigned edge) {
  const auto [axis, corner] = cube_edge(edge);
  unsigned faces = 0;
  for (int other = 0; other < 3; ++other)
    if (other != axis) faces |= 1U << (2 * other + static_cast<int>(corner >> other & 1U));
  return faces;
}

/// A directed piece of the surface on a face: from one crossed edge to another.
struct FaceSegment {
  unsigned from;
  unsigned to;
  bool operator==(const FaceSegment&) const = default;
};

struct FaceSegments {
  std::array<FaceSegment, 2> segments;
  std::size_t count = 0;
};

/// The segments on a face, the positive side on their left as seen from outside the cube. Depends on the face's four
/// values alone; the cube on its other side finds the same segments, turned round.
/// @param values of the eight corners; below 0 is inside
FaceSegments face_segments(const std::array<double, 8>& values, unsigned face);

/// The closed loops of crossed edges, one behind the other, counter-clockwise seen from the positive side.
struct CubeLoops {
  std::array<std::uint8_t, 12> edges;
  std::array<std::uint8_t, 5> offsets = {};  // loop i is [offsets[i], offsets[i+1]); a cube has 4 at most
  std::size_t count = 0;

  std::span<const std::uint8_t> loop(std::size_t i) const {
    return {edges.data() + offsets[i], edges.data() + offsets[i + 1]};
  }
};

CubeLoops cube_loops(const std::array<double, 8>& values);

/// Triangles of one loop as positions in it.
struct LoopTriangles {
  std::array<std::array<std::uint8_t, 3>, 10> triangles;
  std::size_t count = 0;  ///< 0: a point in the middle of the loop is needed
};

/// No inner edge of the triangles lies in a face of the cube, where the neighbour might have the same edge. Among these
/// triangulations the one with the shortest inner edges (sum of squares); none where every one needs such an edge.
/// @param edges  of the loop, 3 to 12
/// @param points on them
LoopTriangles triangulate_loop(std::span<const std::uint8_t> edges, std::span<const Vec3> points);

}  // namespace croquis::implicit

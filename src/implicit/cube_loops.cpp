// SPDX-License-Identifier: GPL-3.0-or-later
#include "implicit/cube_loops.h"

#include <limits>

namespace croquis::implicit {
namespace {

/// Corners and edges of a face in the order of its own axes u, v: (0,0), (1,0), (1,1), (0,1); edge k joins corners k,
/// k+1.
struct FaceRing {
  std::array<unsigned, 4> corners;
  std::array<unsigned, 4> edges;
};

constexpr FaceRing ring_of(unsigned face) {
  const unsigned axis = face / 2;
  const unsigned u = (axis + 1) % 3;
  const unsigned v = (axis + 2) % 3;
  const unsigned side = face & 1U;
  const unsigned base = side << axis;
  FaceRing ring = {{base, base | 1U << u, base | 1U << u | 1U << v, base | 1U << v}, {}};
  // Along u the remaining axes are v, axis in this cyclic order; along v they are axis, u.
  ring.edges = {4 * u + (side << 1), 4 * v + (side | 2U), 4 * u + (1U | side << 1), 4 * v + side};
  return ring;
}

constexpr std::array<FaceRing, 6> rings = {ring_of(0), ring_of(1), ring_of(2), ring_of(3), ring_of(4), ring_of(5)};

bool positive(double value) { return !(value < 0); }

/// Asymptotic decider (Nielson, Hamann 1991): whether the positive corners of a face with alternating signs are joined,
/// by the sign of the bilinear function's saddle. Of the four values alone, in the face's own order.
bool positives_joined(const std::array<double, 8>& values, const FaceRing& ring) {
  const double even = values[ring.corners[0]] * values[ring.corners[2]];
  const double odd = values[ring.corners[1]] * values[ring.corners[3]];
  return positive(values[ring.corners[0]]) ? even >= odd : odd >= even;
}

/// Cheapest triangulations of all runs of a loop.
struct Runs {
  static constexpr double never = std::numeric_limits<double>::infinity();
  std::array<std::array<double, 12>, 12> cost = {};
  std::array<std::array<std::uint8_t, 12>, 12> tip = {};
};

double edge_cost(std::span<const std::uint8_t> edges, std::span<const Vec3> points, std::size_t a, std::size_t b) {
  if (b == a + 1 || (a == 0 && b + 1 == edges.size())) return 0;  // a side of the loop
  if ((faces_of_edge(edges[a]) & faces_of_edge(edges[b])) != 0) return Runs::never;
  return (points[a] - points[b]).squaredNorm();
}

Runs cheapest_runs(std::span<const std::uint8_t> edges, std::span<const Vec3> points) {
  Runs runs;
  const std::size_t n = edges.size();
  for (std::size_t length = 2; length < n; ++length) {
    for (std::size_t a = 0; a + length < n; ++a) {
      const std::size_t b = a + length;
      double best = Runs::never;
      for (std::size_t tip = a + 1; tip < b; ++tip) {
        const double cost = runs.cost[a][tip] + runs.cost[tip][b];
        if (cost < best) best = cost, runs.tip[a][b] = static_cast<std::uint8_t>(tip);
      }
      runs.cost[a][b] = best + edge_cost(edges, points, a, b);
    }
  }
  return runs;
}

void collect(const Runs& runs, std::size_t a, std::size_t b, LoopTriangles& result) {
  if (b < a + 2) return;
  const std::uint8_t tip = runs.tip[a][b];
  result.triangles[result.count++] = {static_cast<std::uint8_t>(a), tip, static_cast<std::uint8_t>(b)};
  collect(runs, a, tip, result);
  collect(runs, tip, b, result);
}

LoopTriangles triangulate_four(std::span<const std::uint8_t> edges, std::span<const Vec3> points) {
  const double even = edge_cost(edges, points, 0, 2);
  const double odd = edge_cost(edges, points, 1, 3);
  LoopTriangles result;
  if (even == Runs::never && odd == Runs::never) return result;
  result.count = 2;
  if (even <= odd) {
    result.triangles[0] = {0, 1, 2};
    result.triangles[1] = {0, 2, 3};
  } else {
    result.triangles[0] = {0, 1, 3};
    result.triangles[1] = {1, 2, 3};
  }
  return result;
}

}  // namespace

FaceSegments face_segments(const std::array<double, 8>& values, unsigned face) {
  const FaceRing& ring = rings[face];
  const bool flipped = (face & 1U) == 0;  // seen from outside, the ring runs clockwise
  std::array<unsigned, 4> falls = {};     // ring edges where the sign falls, going round counter-clockwise
  std::array<unsigned, 4> rises = {};
  std::size_t fall_count = 0;
  std::size_t rise_count = 0;
  for (unsigned k = 0; k < 4; ++k) {
    const bool before = positive(values[ring.corners[k]]);
    const bool after = positive(values[ring.corners[(k + 1) % 4]]);
    if (before == after) continue;
    if (before != flipped) {
      falls[fall_count++] = k;
    } else {
      rises[rise_count++] = k;
    }
  }
  FaceSegments result;
  result.count = fall_count;
  if (fall_count == 1) result.segments[0] = {ring.edges[falls[0]], ring.edges[rises[0]]};
  if (fall_count != 2) return result;
  // Joined positives: each segment cuts a negative corner off, and goes from its falling edge on to the next one.
  const bool onwards = positives_joined(values, ring) != flipped;
  for (std::size_t i = 0; i < 2; ++i)
    result.segments[i] = {ring.edges[falls[i]], ring.edges[(falls[i] + (onwards ? 1 : 3)) % 4]};
  return result;
}

CubeLoops cube_loops(const std::array<double, 8>& values) {
  constexpr std::uint8_t none = 255;
  std::array<std::uint8_t, 12> next;
  next.fill(none);
  for (unsigned face = 0; face < 6; ++face) {
    const FaceSegments found = face_segments(values, face);
    for (std::size_t i = 0; i < found.count; ++i)
      next[found.segments[i].from] = static_cast<std::uint8_t>(found.segments[i].to);
  }
  CubeLoops loops;
  std::uint8_t filled = 0;
  for (std::uint8_t first = 0; first < 12; ++first) {
    if (next[first] == none) continue;
    for (std::uint8_t edge = first; next[edge] != none;) {
      loops.edges[filled++] = edge;
      const std::uint8_t after = next[edge];
      next[edge] = none;
      edge = after;
    }
    loops.offsets[++loops.count] = filled;
  }
  return loops;
}

LoopTriangles triangulate_loop(std::span<const std::uint8_t> edges, std::span<const Vec3> points) {
  LoopTriangles result;
  if (edges.size() == 3) {
    result.triangles[0] = {0, 1, 2};
    result.count = 1;
    return result;
  }
  if (edges.size() == 4) return triangulate_four(edges, points);
  const Runs runs = cheapest_runs(edges, points);
  if (runs.cost[0][edges.size() - 1] < Runs::never) collect(runs, 0, edges.size() - 1, result);
  return result;
}

}  // namespace croquis::implicit

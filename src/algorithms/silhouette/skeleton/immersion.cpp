// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/skeleton/immersion.h"

#include <algorithm>
#include <string>
#include <utility>

#include "algorithms/silhouette/skeleton/triangle_corners.h"
#include "croquis/base/error.h"
#include "croquis/geometry/disjoint_sets.h"

namespace croquis::silhouette {
namespace {

void make_copies(const PlanarTriangulation& planar, std::span<const int> layers, LiftedTriangulation& lifted) {
  if (layers.size() != planar.triangles.size()) throw_internal("the layers don't match the triangulation");
  lifted.first_copy.reserve(layers.size() + 1);
  for (Index t = 0; t < layers.size(); ++t) {
    if (layers[t] < 0) throw_internal("triangle " + std::to_string(t) + " has a negative number of layers");
    lifted.first_copy.push_back(static_cast<Index>(lifted.planar_triangle.size()));
    lifted.planar_triangle.insert(lifted.planar_triangle.end(), static_cast<std::size_t>(layers[t]), t);
  }
  lifted.first_copy.push_back(static_cast<Index>(lifted.planar_triangle.size()));
  lifted.neighbours.assign(lifted.planar_triangle.size(), {no_index, no_index, no_index});
}

/// One planar edge seen from the side with at least as many layers as the other one.
struct Side {
  Index triangle = no_index;
  Index corner = 0;
  int layers = 0;
};

Side other_side(const PlanarTriangulation& planar, std::span<const int> layers, const Side& side) {
  const Index twin = planar.neighbours[side.triangle][side.corner];
  if (twin == no_index) return {};
  for (Index corner = 0; corner < 3; ++corner) {
    if (planar.neighbours[twin][corner] == side.triangle) return {twin, corner, layers[twin]};
  }
  throw_internal("the neighbours of triangle " + std::to_string(side.triangle) + " disagree");
}

void glue(const Side& upper, const Side& lower, int ending, LiftedTriangulation& lifted) {
  for (int layer = 0; layer < upper.layers; ++layer) {
    if (layer == ending) continue;
    const int twin_layer = ending >= 0 && layer > ending ? layer - 1 : layer;
    const Index triangle = lifted.first_copy[upper.triangle] + static_cast<Index>(layer);
    const Index twin = lifted.first_copy[lower.triangle] + static_cast<Index>(twin_layer);
    lifted.neighbours[triangle][upper.corner] = twin;
    lifted.neighbours[twin][lower.corner] = triangle;
  }
}

void glue_edge(const Side& a, const Side& b, int depth, LiftedTriangulation& lifted) {
  const Side& more = a.layers >= b.layers ? a : b;
  const Side& fewer = a.layers >= b.layers ? b : a;
  const bool contour = depth >= 0;
  if (more.layers - fewer.layers != (contour ? 1 : 0) || depth >= more.layers) {
    throw_internal("the numbers of layers " + std::to_string(more.layers) + " and " + std::to_string(fewer.layers) +
                   " don't fit an edge of depth " + std::to_string(depth));
  }
  glue(more, fewer, contour ? depth : -1, lifted);
}

void glue_copies(const PlanarTriangulation& planar, std::span<const int> layers, std::span<const int> constraint_depth,
                 LiftedTriangulation& lifted) {
  for (Index t = 0; t < planar.triangles.size(); ++t) {
    for (Index corner = 0; corner < 3; ++corner) {
      const Side side{t, corner, layers[t]};
      const Side twin = other_side(planar, layers, side);
      if (twin.triangle != no_index && twin.triangle < t) continue;
      const Index constraint = planar.constraints[t][corner];
      if (constraint != no_index && constraint >= constraint_depth.size()) throw_internal("a constraint has no depth");
      glue_edge(side, twin, constraint == no_index ? -1 : constraint_depth[constraint], lifted);
    }
  }
}

DisjointSets join_corners(const PlanarTriangulation& planar, const LiftedTriangulation& lifted) {
  DisjointSets sets(3 * lifted.neighbours.size());
  for (Index m = 0; m < lifted.neighbours.size(); ++m) {
    for (Index corner = 0; corner < 3; ++corner) {
      const Index twin = lifted.neighbours[m][corner];
      if (twin == no_index || twin < m) continue;
      // The shared edge runs against the twin's sense: my next corner is its previous one.
      const std::array<Index, 3>& ends = planar.triangles[lifted.planar_triangle[twin]];
      const Index start = planar.triangles[lifted.planar_triangle[m]][next(corner)];
      Index twin_start = 0;
      while (ends[twin_start] != start) ++twin_start;
      sets.unite(3 * m + next(corner), 3 * twin + twin_start);
      sets.unite(3 * m + previous(corner), 3 * twin + previous(twin_start));
    }
  }
  return sets;
}

void number_vertices(const PlanarTriangulation& planar, DisjointSets sets, LiftedTriangulation& lifted) {
  std::vector<Index> number(3 * lifted.neighbours.size(), no_index);
  lifted.triangles.resize(lifted.neighbours.size());
  for (Index m = 0; m < lifted.triangles.size(); ++m) {
    for (Index corner = 0; corner < 3; ++corner) {
      Index& vertex = number[sets.root(3 * m + corner)];
      if (vertex == no_index) {
        vertex = static_cast<Index>(lifted.planar_vertex.size());
        lifted.planar_vertex.push_back(planar.triangles[lifted.planar_triangle[m]][corner]);
      }
      lifted.triangles[m][corner] = vertex;
    }
  }
}

/// Marks the boundary and makes sure that every vertex has a neighbourhood like a disk or a half disk: labels that
/// contradict each other around a crossing would show as a fan that winds around it more than once.
void close_fans(const PlanarTriangulation& planar, LiftedTriangulation& lifted) {
  std::vector<int> ends(lifted.planar_vertex.size(), 0);
  std::vector<int> corners(lifted.planar_vertex.size(), 0);
  for (Index m = 0; m < lifted.triangles.size(); ++m) {
    for (Index corner = 0; corner < 3; ++corner) {
      ++corners[lifted.triangles[m][corner]];
      if (lifted.neighbours[m][corner] == no_index) ++ends[lifted.triangles[m][next(corner)]];
    }
  }
  std::vector<int> degree;
  for (const std::array<Index, 3>& triangle : planar.triangles) {
    for (const Index vertex : triangle) {
      if (vertex >= degree.size()) degree.resize(vertex + 1, 0);
      ++degree[vertex];
    }
  }
  lifted.on_boundary.resize(ends.size());
  for (Index v = 0; v < ends.size(); ++v) {
    const Index point = lifted.planar_vertex[v];
    if (ends[v] > 1 || corners[v] > degree[point] || (ends[v] == 0 && corners[v] != degree[point])) {
      throw_internal("the layers around point " + std::to_string(point) + " don't close");
    }
    lifted.on_boundary[v] = ends[v] == 0 ? 0 : 1;
  }
}

/// Every contour segment by its ends, so that it is found from two points in either order.
struct SegmentTable {
  std::vector<std::array<Index, 3>> rows;  ///< lower point, higher point, segment; ascending

  explicit SegmentTable(std::span<const std::array<Index, 2>> segments) {
    rows.reserve(segments.size());
    for (Index s = 0; s < segments.size(); ++s) {
      rows.push_back({std::min(segments[s][0], segments[s][1]), std::max(segments[s][0], segments[s][1]), s});
    }
    std::sort(rows.begin(), rows.end());
  }

  Index find(Index a, Index b) const {
    const std::array<Index, 3> wanted{std::min(a, b), std::max(a, b), 0};
    const auto row = std::lower_bound(rows.begin(), rows.end(), wanted);
    if (row == rows.end() || (*row)[0] != wanted[0] || (*row)[1] != wanted[1])
      throw_internal("a contour runs off its segments");
    return (*row)[2];
  }
};

/// Where the sheet of a segment ends: a lifted triangle and the corner opposite to the segment.
struct RimEdge {
  Index triangle = no_index;
  Index corner = 0;
};

std::vector<RimEdge> rim_edges(const PlanarTriangulation& planar, const LiftedTriangulation& lifted,
                               std::size_t segment_count) {
  std::vector<RimEdge> rims(segment_count);
  for (Index m = 0; m < lifted.neighbours.size(); ++m) {
    for (Index corner = 0; corner < 3; ++corner) {
      if (lifted.neighbours[m][corner] != no_index) continue;
      rims[planar.constraints[lifted.planar_triangle[m]][corner]] = {m, corner};
    }
  }
  return rims;
}

/// The lifted vertices at the ends of a contour's segment, in the contour's direction.
std::array<Index, 2> rim_vertices(const LiftedTriangulation& lifted, const RimEdge& rim, Index begin) {
  if (rim.triangle == no_index) throw_internal("a contour segment bounds no sheet");
  const std::array<Index, 3>& triangle = lifted.triangles[rim.triangle];
  const std::array<Index, 2> ends{triangle[next(rim.corner)], triangle[previous(rim.corner)]};
  if (lifted.planar_vertex[ends[0]] == begin) return ends;
  return {ends[1], ends[0]};
}

}  // namespace

LiftedTriangulation lift(const LabelledFigure& figure) {
  std::vector<int> depth(figure.segments.size());
  for (std::size_t s = 0; s < depth.size(); ++s) depth[s] = figure.arcs[figure.segment_arc[s]].depth;
  return lift(figure.triangulation, figure.layers, depth);
}

std::vector<std::vector<Index>> contour_vertices(const LabelledFigure& figure, const LiftedTriangulation& lifted) {
  const SegmentTable table(figure.segments);
  const std::vector<RimEdge> rims = rim_edges(figure.triangulation, lifted, figure.segments.size());
  std::vector<std::vector<Index>> vertices;
  for (const FigureContour& contour : figure.contours) {
    const std::size_t count = contour.vertices.size();
    std::vector<Index> result(count, no_index);
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t after = (i + 1) % count;
      const Index begin = contour.vertices[i];
      const auto ends = rim_vertices(lifted, rims[table.find(begin, contour.vertices[after])], begin);
      for (const auto& [position, vertex] : {std::pair{i, ends[0]}, std::pair{after, ends[1]}}) {
        if (result[position] != no_index && result[position] != vertex) {
          throw_internal("the boundary leaves its contour at point " + std::to_string(contour.vertices[position]));
        }
        result[position] = vertex;
      }
    }
    vertices.push_back(std::move(result));
  }
  return vertices;
}

LiftedTriangulation lift(const PlanarTriangulation& planar, std::span<const int> layers,
                         std::span<const int> constraint_depth) {
  LiftedTriangulation lifted;
  make_copies(planar, layers, lifted);
  glue_copies(planar, layers, constraint_depth, lifted);
  number_vertices(planar, join_corners(planar, lifted), lifted);
  close_fans(planar, lifted);
  return lifted;
}

}  // namespace croquis::silhouette

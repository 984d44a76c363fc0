// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/skeleton/immersion.h"

#include <string>
#include <utility>

#include "algorithms/silhouette/skeleton/triangle_corners.h"
#include "croquis/base/error.h"
#include "croquis/geometry/disjoint_sets.h"

namespace croquis::silhouette {
namespace {

void make_copies(std::span<const int> layers, LiftedTriangulation& lifted) {
  lifted.first_copy.reserve(layers.size() + 1);
  for (Index t = 0; t < layers.size(); ++t) {
    lifted.first_copy.push_back(static_cast<Index>(lifted.planar_triangle.size()));
    lifted.planar_triangle.insert(lifted.planar_triangle.end(), static_cast<std::size_t>(layers[t]), t);
  }
  lifted.first_copy.push_back(static_cast<Index>(lifted.planar_triangle.size()));
  lifted.neighbours.assign(lifted.planar_triangle.size(), {no_index, no_index, no_index});
}

/// A planar triangle at one of its edges; none beyond the hull.
struct EdgeSide {
  Index triangle = no_index;
  Index corner = 0;
  int layers = 0;
};

/// @param depth the layer that ends at the edge; negative at a plain one
void glue_edge(EdgeSide more, EdgeSide fewer, int depth, LiftedTriangulation& lifted) {
  if (more.layers < fewer.layers) std::swap(more, fewer);
  if (more.layers - fewer.layers != (depth >= 0 ? 1 : 0) || depth >= more.layers) {
    throw_internal("the numbers of layers " + std::to_string(more.layers) + " and " + std::to_string(fewer.layers) +
                   " don't fit an edge of depth " + std::to_string(depth));
  }
  for (int layer = 0; layer < more.layers; ++layer) {
    if (layer == depth) continue;
    const int twin_layer = depth >= 0 && layer > depth ? layer - 1 : layer;
    const Index triangle = lifted.first_copy[more.triangle] + static_cast<Index>(layer);
    const Index twin = lifted.first_copy[fewer.triangle] + static_cast<Index>(twin_layer);
    lifted.neighbours[triangle][more.corner] = twin;
    lifted.neighbours[twin][fewer.corner] = triangle;
  }
}

void glue_copies(const PlanarTriangulation& planar, std::span<const int> layers, std::span<const int> constraint_depth,
                 LiftedTriangulation& lifted) {
  for (Index t = 0; t < planar.triangles.size(); ++t) {
    for (Index corner = 0; corner < 3; ++corner) {
      const Index twin = planar.neighbours[t][corner];
      if (twin < t) continue;
      EdgeSide beyond;
      if (twin != no_index) beyond = {twin, corner_across(planar.neighbours, twin, t), layers[twin]};
      const Index constraint = planar.constraints[t][corner];
      if (constraint != no_index && constraint >= constraint_depth.size()) throw_internal("a constraint has no depth");
      glue_edge({t, corner, layers[t]}, beyond, constraint == no_index ? -1 : constraint_depth[constraint], lifted);
    }
  }
}

void number_vertices(const PlanarTriangulation& planar, LiftedTriangulation& lifted) {
  const auto count = static_cast<Index>(lifted.neighbours.size());
  DisjointSets corners(3 * lifted.neighbours.size());
  for (Index m = 0; m < count; ++m) {
    for (Index corner = 0; corner < 3; ++corner) {
      const Index twin = lifted.neighbours[m][corner];
      if (twin == no_index || twin < m) continue;
      // The shared edge runs against the twin's sense.
      const Index back = corner_across(lifted.neighbours, twin, m);
      corners.unite(3 * m + next(corner), 3 * twin + previous(back));
      corners.unite(3 * m + previous(corner), 3 * twin + next(back));
    }
  }
  std::vector<Index> vertex;
  lifted.planar_vertex.resize(corners.number(vertex));
  lifted.triangles.resize(count);
  for (Index m = 0; m < count; ++m) {
    for (Index corner = 0; corner < 3; ++corner) {
      lifted.triangles[m][corner] = vertex[3 * m + corner];
      lifted.planar_vertex[vertex[3 * m + corner]] = planar.triangles[lifted.planar_triangle[m]][corner];
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

}  // namespace

std::vector<DirectedSegment> directed_segments(const LabelledFigure& figure) {
  std::vector<DirectedSegment> segments;
  for (Index c = 0; c < figure.contours.size(); ++c) {
    const FigureContour& contour = figure.contours[c];
    const auto count = static_cast<Index>(contour.vertices.size());
    for (Index i = 0; i < count; ++i) {
      const int depth = figure.arcs[figure.segment_arc[segments.size()]].depth;
      segments.push_back({c, i, contour.vertices[i], contour.vertices[(i + 1) % count], contour.side, depth});
    }
  }
  return segments;
}

LiftedTriangulation lift(const LabelledFigure& figure) {
  std::vector<int> depth;
  for (const Index arc : figure.segment_arc) depth.push_back(figure.arcs[arc].depth);
  return lift(figure.triangulation, figure.layers, depth);
}

LiftedTriangulation lift(const PlanarTriangulation& planar, std::span<const int> layers,
                         std::span<const int> constraint_depth) {
  LiftedTriangulation lifted;
  make_copies(layers, lifted);
  glue_copies(planar, layers, constraint_depth, lifted);
  number_vertices(planar, lifted);
  close_fans(planar, lifted);
  return lifted;
}

std::vector<std::vector<Index>> contour_vertices(const LabelledFigure& figure, const LiftedTriangulation& lifted) {
  const std::vector<DirectedSegment> segments = directed_segments(figure);
  std::vector<std::vector<Index>> vertices;
  for (const FigureContour& contour : figure.contours) vertices.emplace_back(contour.vertices.size(), no_index);
  for (Index m = 0; m < lifted.triangles.size(); ++m) {
    for (Index corner = 0; corner < 3; ++corner) {
      if (lifted.neighbours[m][corner] != no_index) continue;
      const DirectedSegment& rim = segments[figure.triangulation.constraints[lifted.planar_triangle[m]][corner]];
      std::array<Index, 2> ends{lifted.triangles[m][next(corner)], lifted.triangles[m][previous(corner)]};
      if (lifted.planar_vertex[ends[0]] != rim.begin) std::swap(ends[0], ends[1]);
      std::vector<Index>& contour = vertices[rim.contour];
      for (Index k = 0; k < 2; ++k) {
        Index& known = contour[(rim.position + k) % contour.size()];
        if (known != no_index && known != ends[k]) {
          throw_internal("the boundary leaves its contour at point " + std::to_string(lifted.planar_vertex[ends[k]]));
        }
        known = ends[k];
      }
    }
  }
  return vertices;
}

}  // namespace croquis::silhouette

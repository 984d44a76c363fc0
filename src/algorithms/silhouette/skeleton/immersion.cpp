// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/skeleton/immersion.h"

#include <algorithm>
#include <string>
#include <utility>

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#include "algorithms/silhouette/skeleton/triangle_corners.h"
#include "croquis/base/error.h"
#include "croquis/geometry/disjoint_sets.h"
#include "croquis/geometry/predicates.h"

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

namespace {

/// Connectivity that can be edited; the places stay in the figure's points.
struct MeshTraits : OpenMesh::DefaultTraits {
  VertexAttributes(OpenMesh::Attributes::Status);
  EdgeAttributes(OpenMesh::Attributes::Status);
  FaceAttributes(OpenMesh::Attributes::Status);
  HalfedgeAttributes(OpenMesh::Attributes::PrevHalfedge);
};
using Mesh = OpenMesh::TriMesh_ArrayKernelT<MeshTraits>;

Index number(OpenMesh::BaseHandle handle) { return static_cast<Index>(handle.idx()); }
Mesh::VertexHandle vertex_handle(Index vertex) { return Mesh::VertexHandle(static_cast<int>(vertex)); }

/// The lifted triangulation while vertices are taken out of it and edges are flipped.
class EditedRegion {
 public:
  EditedRegion(const LabelledFigure& figure, const LiftedTriangulation& lifted) : figure_(figure), lifted_(lifted) {
    for (std::size_t v = 0; v < lifted.planar_vertex.size(); ++v) mesh_.new_vertex();
    for (const auto& [a, b, c] : lifted.triangles) add_triangle(a, b, c);
  }

  /// The star of an interior vertex is a simple polygon in the plane, since its angles at the vertex sum to a full
  /// turn: triangles are cut off it until nothing is left. Corners in line with their neighbours are common where
  /// contours are straight; a polygon that isn't flat as a whole always has a corner that can go.
  void remove(Index vertex) {
    std::vector<Index> polygon;
    std::vector<Mesh::FaceHandle> star;
    for (const auto halfedge : mesh_.voh_ccw_range(vertex_handle(vertex))) {
      polygon.push_back(number(mesh_.to_vertex_handle(halfedge)));
      star.push_back(mesh_.face_handle(halfedge));
    }
    for (const Mesh::FaceHandle face : star) mesh_.delete_face(face, false);
    while (polygon.size() >= 3) clip_ear(polygon);
  }

  /// Flips edges until every inner one is locally Delaunay.
  void make_delaunay(const Progress& progress) {
    std::vector<Mesh::EdgeHandle> stack;
    std::vector<bool> waiting(mesh_.n_edges(), false);
    const auto push = [&](Mesh::EdgeHandle edge) {
      if (waiting[number(edge)] || mesh_.is_boundary(edge)) return;
      waiting[number(edge)] = true;
      stack.push_back(edge);
    };
    for (const auto edge : mesh_.edges()) push(edge);  // skips deleted ones
    while (!stack.empty()) {
      progress.check();
      const Mesh::EdgeHandle edge = stack.back();
      stack.pop_back();
      waiting[number(edge)] = false;
      if (!wants_flip(edge)) continue;
      if (!mesh_.is_flip_ok(edge)) throw_internal("two edges of the immersed region share both ends");
      mesh_.flip(edge);
      for (const unsigned int side : {0U, 1U}) {
        const Mesh::HalfedgeHandle following = mesh_.next_halfedge_handle(mesh_.halfedge_handle(edge, side));
        push(mesh_.edge_handle(following));
        push(mesh_.edge_handle(mesh_.next_halfedge_handle(following)));
      }
    }
  }

  /// Writes the triangles in terms of the contours' points.
  void write(ImmersedTriangulation& result) const {
    std::vector<Index> vertex(lifted_.planar_vertex.size(), no_index);
    for (Index v = 0; v < result.lifted_vertex.size(); ++v) vertex[result.lifted_vertex[v]] = v;
    std::vector<Index> face_number(mesh_.n_faces(), no_index);
    Index faces = 0;
    for (const auto face : mesh_.faces()) face_number[number(face)] = faces++;
    for (const auto face : mesh_.faces()) {
      std::array<Index, 3> corners{}, neighbours{};
      Mesh::HalfedgeHandle halfedge = mesh_.halfedge_handle(face);
      for (std::size_t i = 0; i < 3; ++i) {
        corners[i] = vertex[number(mesh_.from_vertex_handle(halfedge))];
        halfedge = mesh_.next_halfedge_handle(halfedge);
        const Mesh::FaceHandle twin = mesh_.opposite_face_handle(halfedge);
        neighbours[i] = twin.is_valid() ? face_number[number(twin)] : no_index;
      }
      result.triangles.push_back(corners);
      result.neighbours.push_back(neighbours);
    }
  }

 private:
  const Vec2& point(Index vertex) const { return figure_.points[lifted_.planar_vertex[vertex]]; }

  void add_triangle(Index a, Index b, Index c) {
    if (!mesh_.add_face(vertex_handle(a), vertex_handle(b), vertex_handle(c)).is_valid()) {
      throw_internal("the immersed region isn't a surface at lifted vertex " + std::to_string(a));
    }
  }

  void clip_ear(std::vector<Index>& polygon) {
    const std::size_t count = polygon.size();
    for (std::size_t i = 0; i < count; ++i) {
      const Index before = polygon[(i + count - 1) % count], ear = polygon[i], after = polygon[(i + 1) % count];
      if (!is_ear(before, ear, after, polygon)) continue;
      add_triangle(before, ear, after);
      polygon.erase(polygon.begin() + static_cast<std::ptrdiff_t>(i));
      return;
    }
    throw_internal("the star of an interior vertex has no ear");
  }

  bool is_ear(Index a, Index b, Index c, const std::vector<Index>& polygon) const {
    if (orientation(point(a), point(b), point(c)) <= 0) return false;
    return std::none_of(polygon.begin(), polygon.end(), [&](Index other) {
      if (other == a || other == b || other == c) return false;
      const Vec2& p = point(other);
      return orientation(point(a), point(b), p) >= 0 && orientation(point(b), point(c), p) >= 0 &&
             orientation(point(c), point(a), p) >= 0;
    });
  }

  /// True when the point across an interior edge lies strictly inside the circle of the triangle on its other side. The
  /// two triangles then form a strictly convex quadrilateral.
  bool wants_flip(Mesh::EdgeHandle edge) const {
    const auto at = [&](Mesh::VertexHandle v) -> const Vec2& { return point(number(v)); };
    const Mesh::HalfedgeHandle halfedge = mesh_.halfedge_handle(edge, 0);
    return in_circle(at(mesh_.from_vertex_handle(halfedge)), at(mesh_.to_vertex_handle(halfedge)),
                     at(mesh_.opposite_vh(halfedge)), at(mesh_.opposite_vh(mesh_.halfedge_handle(edge, 1)))) > 0;
  }

  const LabelledFigure& figure_;
  const LiftedTriangulation& lifted_;
  Mesh mesh_;
};

}  // namespace

ImmersedTriangulation immerse(const LabelledFigure& figure, const LiftedTriangulation& lifted, Progress& progress) {
  ImmersedTriangulation result;
  result.first_vertex.push_back(0);
  for (const std::vector<Index>& contour : contour_vertices(figure, lifted)) {
    result.lifted_vertex.insert(result.lifted_vertex.end(), contour.begin(), contour.end());
    result.first_vertex.push_back(static_cast<Index>(result.lifted_vertex.size()));
  }
  for (const Index vertex : result.lifted_vertex) result.planar_vertex.push_back(lifted.planar_vertex[vertex]);
  EditedRegion region(figure, lifted);
  for (Index v = 0; v < lifted.planar_vertex.size(); ++v) {
    progress.check();
    if (lifted.on_boundary[v] == 0) region.remove(v);
  }
  region.make_delaunay(progress);
  region.write(result);
  progress.report(1);
  return result;
}

}  // namespace croquis::silhouette

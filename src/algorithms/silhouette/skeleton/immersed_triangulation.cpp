// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/skeleton/immersed_triangulation.h"

#include <algorithm>
#include <string>

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#include "croquis/base/error.h"
#include "croquis/geometry/predicates.h"

namespace croquis::silhouette {
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

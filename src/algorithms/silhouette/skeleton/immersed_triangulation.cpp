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

/// Checks for cancellation now and then, so that it costs little.
class Pace {
 public:
  explicit Pace(const Progress& progress) : progress_(progress) {}
  void tick() {
    if (++count_ % 1024 == 0) progress_.check();
  }

 private:
  const Progress& progress_;
  std::size_t count_ = 0;
};

void add_triangle(Mesh& mesh, Index a, Index b, Index c) {
  if (!mesh.add_face(vertex_handle(a), vertex_handle(b), vertex_handle(c)).is_valid()) {
    throw_internal("the immersed region isn't a surface at lifted vertex " + std::to_string(a));
  }
}

Mesh editable_mesh(const LiftedTriangulation& lifted) {
  Mesh mesh;
  const std::size_t vertices = lifted.planar_vertex.size();
  const std::size_t faces = lifted.triangles.size();
  mesh.reserve(vertices, vertices + faces + vertices / 2, faces + faces / 2);
  for (std::size_t v = 0; v < vertices; ++v) mesh.new_vertex();
  for (const std::array<Index, 3>& triangle : lifted.triangles) {
    add_triangle(mesh, triangle[0], triangle[1], triangle[2]);
  }
  return mesh;
}

/// Cuts triangles off a simple polygon until nothing is left. Corners in line with their neighbours are common where
/// contours are straight; a polygon that isn't flat as a whole always has a corner that can go.
class EarClipper {
 public:
  EarClipper(const LabelledFigure& figure, const LiftedTriangulation& lifted, std::vector<Index>& polygon)
      : figure_(figure), lifted_(lifted), polygon_(polygon) {}

  std::array<Index, 3> clip() {
    for (std::size_t i = 0; i < polygon_.size(); ++i) {
      const std::array<Index, 3> ear = corner(i);
      if (!is_ear(ear)) continue;
      polygon_.erase(polygon_.begin() + static_cast<std::ptrdiff_t>(i));
      return ear;
    }
    throw_internal("the star of an interior vertex has no ear");
  }

 private:
  std::array<Index, 3> corner(std::size_t i) const {
    const std::size_t count = polygon_.size();
    return {polygon_[(i + count - 1) % count], polygon_[i], polygon_[(i + 1) % count]};
  }

  const Vec2& point(Index vertex) const { return figure_.points[lifted_.planar_vertex[vertex]]; }

  bool is_ear(const std::array<Index, 3>& ear) const {
    const auto& [a, b, c] = ear;
    if (orientation(point(a), point(b), point(c)) <= 0) return false;
    return std::none_of(polygon_.begin(), polygon_.end(), [&](Index other) {
      if (other == a || other == b || other == c) return false;
      const Vec2& p = point(other);
      return orientation(point(a), point(b), p) >= 0 && orientation(point(b), point(c), p) >= 0 &&
             orientation(point(c), point(a), p) >= 0;
    });
  }

  const LabelledFigure& figure_;
  const LiftedTriangulation& lifted_;
  std::vector<Index>& polygon_;
};

/// The star of an interior vertex is a simple polygon in the plane: its angles at the vertex sum to a full turn.
void remove_vertex(const LabelledFigure& figure, const LiftedTriangulation& lifted, Index vertex, Mesh& mesh) {
  std::vector<Index> polygon;
  std::vector<Mesh::FaceHandle> star;
  for (const auto halfedge : mesh.voh_ccw_range(vertex_handle(vertex))) {
    polygon.push_back(number(mesh.to_vertex_handle(halfedge)));
    star.push_back(mesh.face_handle(halfedge));
  }
  for (const Mesh::FaceHandle face : star) mesh.delete_face(face, false);
  EarClipper clipper(figure, lifted, polygon);
  while (polygon.size() >= 3) {
    const auto [a, b, c] = clipper.clip();
    add_triangle(mesh, a, b, c);
  }
}

std::size_t remove_interior_vertices(const LabelledFigure& figure, const LiftedTriangulation& lifted,
                                     const Progress& progress, Mesh& mesh) {
  Pace pace(progress);
  std::size_t removed = 0;
  for (Index v = 0; v < lifted.planar_vertex.size(); ++v) {
    if (lifted.on_boundary[v]) continue;
    pace.tick();
    remove_vertex(figure, lifted, v, mesh);
    ++removed;
  }
  return removed;
}

/// True when the point across an interior edge lies strictly inside the circle of the triangle on its other side. The
/// two triangles then form a strictly convex quadrilateral.
bool wants_flip(const LabelledFigure& figure, const LiftedTriangulation& lifted, const Mesh& mesh,
                Mesh::EdgeHandle edge) {
  const auto point = [&](Mesh::VertexHandle v) -> const Vec2& {
    return figure.points[lifted.planar_vertex[number(v)]];
  };
  const Mesh::HalfedgeHandle halfedge = mesh.halfedge_handle(edge, 0);
  const Mesh::HalfedgeHandle twin = mesh.halfedge_handle(edge, 1);
  return in_circle(point(mesh.from_vertex_handle(halfedge)), point(mesh.to_vertex_handle(halfedge)),
                   point(mesh.opposite_vh(halfedge)), point(mesh.opposite_vh(twin))) > 0;
}

std::size_t make_delaunay(const LabelledFigure& figure, const LiftedTriangulation& lifted, const Progress& progress,
                          Mesh& mesh) {
  std::vector<Mesh::EdgeHandle> stack;
  std::vector<bool> waiting(mesh.n_edges(), false);
  const auto push = [&](Mesh::EdgeHandle edge) {
    if (waiting[number(edge)] || mesh.is_boundary(edge)) return;
    waiting[number(edge)] = true;
    stack.push_back(edge);
  };
  for (const auto edge : mesh.edges()) push(edge);  // skips deleted ones
  Pace pace(progress);
  std::size_t flips = 0;
  while (!stack.empty()) {
    const Mesh::EdgeHandle edge = stack.back();
    stack.pop_back();
    waiting[number(edge)] = false;
    pace.tick();
    if (!wants_flip(figure, lifted, mesh, edge)) continue;
    if (!mesh.is_flip_ok(edge)) throw_internal("two edges of the immersed region share both ends");
    mesh.flip(edge);
    ++flips;
    for (const unsigned int side : {0U, 1U}) {
      const Mesh::HalfedgeHandle following = mesh.next_halfedge_handle(mesh.halfedge_handle(edge, side));
      push(mesh.edge_handle(following));
      push(mesh.edge_handle(mesh.next_halfedge_handle(following)));
    }
  }
  return flips;
}

void number_contour_points(const LabelledFigure& figure, const LiftedTriangulation& lifted,
                           ImmersedTriangulation& result) {
  result.first_vertex.push_back(0);
  for (const std::vector<Index>& contour : contour_vertices(figure, lifted)) {
    for (const Index vertex : contour) {
      result.lifted_vertex.push_back(vertex);
      result.planar_vertex.push_back(lifted.planar_vertex[vertex]);
    }
    result.first_vertex.push_back(static_cast<Index>(result.lifted_vertex.size()));
  }
}

void flatten(const Mesh& mesh, std::size_t lifted_count, ImmersedTriangulation& result) {
  std::vector<Index> vertex(lifted_count, no_index);
  for (Index v = 0; v < result.lifted_vertex.size(); ++v) vertex[result.lifted_vertex[v]] = v;
  std::vector<Index> face_number(mesh.n_faces(), no_index);
  Index faces = 0;
  for (const auto face : mesh.faces()) face_number[number(face)] = faces++;
  for (const auto face : mesh.faces()) {
    std::array<Index, 3> corners{};
    std::array<Index, 3> neighbours{};
    Mesh::HalfedgeHandle halfedge = mesh.halfedge_handle(face);
    for (std::size_t i = 0; i < 3; ++i) {
      corners[i] = vertex[number(mesh.from_vertex_handle(halfedge))];
      if (corners[i] == no_index) throw_internal("a boundary vertex lies on no contour");
      halfedge = mesh.next_halfedge_handle(halfedge);
      const Mesh::FaceHandle twin = mesh.opposite_face_handle(halfedge);
      neighbours[i] = twin.is_valid() ? face_number[number(twin)] : no_index;
    }
    result.triangles.push_back(corners);
    result.neighbours.push_back(neighbours);
  }
}

}  // namespace

ImmersedTriangulation immerse(const LabelledFigure& figure, const LiftedTriangulation& lifted, Progress& progress) {
  ImmersedTriangulation result;
  number_contour_points(figure, lifted, result);
  Mesh mesh = editable_mesh(lifted);
  result.removed_vertices = remove_interior_vertices(figure, lifted, progress, mesh);
  result.flips = make_delaunay(figure, lifted, progress, mesh);
  flatten(mesh, lifted.planar_vertex.size(), result);
  progress.report(1);
  return result;
}

}  // namespace croquis::silhouette

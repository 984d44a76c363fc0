// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/surface/surface_union.h"

#include <algorithm>
#include <array>
#include <exception>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Polygon_mesh_processing/repair_degeneracies.h>
#include <CGAL/Surface_mesh.h>

namespace croquis::silhouette {
namespace {

namespace pmp = CGAL::Polygon_mesh_processing;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;
using Face = Surface::Face_index;
using FaceObjects = Surface::Property_map<Face, Index>;

FaceObjects face_objects(Surface& surface) { return surface.add_property_map<Face, Index>("f:object", 0).first; }

/// Lets the pieces of a face, and its copies in the other surface, belong to the object of the face.
class ObjectKeeper : public pmp::Corefinement::Default_visitor<Surface> {
 public:
  void before_subface_creations(Face face, Surface& surface) { object_ = face_objects(surface)[face]; }
  void after_subface_created(Face face, Surface& surface) { face_objects(surface)[face] = object_; }
  void after_face_copy(Face from, const Surface& source, Face to, Surface& target) {
    face_objects(target)[to] = source.property_map<Face, Index>("f:object").first[from];
  }

 private:
  Index object_ = 0;
};

Surface to_surface(const UnionPart& part) {
  Surface surface;
  for (const Vec3& p : part.mesh->positions) surface.add_vertex({p.x(), p.y(), p.z()});
  FaceObjects objects = face_objects(surface);
  for (std::size_t f = 0; f < part.mesh->face_count(); ++f) {
    const auto corners = part.mesh->face(f);
    const Face face = surface.add_face(Surface::Vertex_index(corners[0]), Surface::Vertex_index(corners[1]),
                                       Surface::Vertex_index(corners[2]));
    objects[face] = part.object;
  }
  return surface;
}

SurfaceUnion from_surface(Surface& surface) {
  surface.collect_garbage();
  const FaceObjects objects = face_objects(surface);
  SurfaceUnion result;
  for (const auto v : surface.vertices()) {
    const auto& p = surface.point(v);
    result.mesh.positions.emplace_back(p.x(), p.y(), p.z());
  }
  for (const Face face : surface.faces()) {
    std::array<Index, 3> corners{};
    std::size_t i = 0;
    for (const auto v : surface.vertices_around_face(surface.halfedge(face))) corners[i++] = v.idx();
    result.mesh.add_triangle(corners[0], corners[1], corners[2]);
    result.face_objects.push_back(objects[face]);
  }
  return result;
}

// A triangle is a cap beyond this cosine of its largest angle, and a needle beyond this ratio of its edges.
constexpr double cap_cosine = -0.94;
constexpr double needle_ratio = 4;

/// Vertices between faces of two objects.
std::vector<Surface::Vertex_index> seam_vertices(Surface& surface) {
  const FaceObjects objects = face_objects(surface);
  std::vector<Surface::Vertex_index> seam;
  for (const auto v : surface.vertices()) {
    const Index first = objects[surface.face(surface.halfedge(v))];
    for (const Face face : surface.faces_around_target(surface.halfedge(v))) {
      if (objects[face] == first) continue;
      seam.push_back(v);
      break;
    }
  }
  return seam;
}

/// Collapses short edges and flips caps along the seams; all vertices off the seams stay where they are.
void remove_slivers(Surface& surface, double longest) {
  auto fixed = surface.add_property_map<Surface::Vertex_index, bool>("v:fixed", true).first;
  std::vector<Face> beside;
  for (const auto v : seam_vertices(surface)) {
    fixed[v] = false;
    for (const Face face : surface.faces_around_target(surface.halfedge(v))) beside.push_back(face);
  }
  std::sort(beside.begin(), beside.end());
  beside.erase(std::unique(beside.begin(), beside.end()), beside.end());
  pmp::experimental::remove_almost_degenerate_faces(beside, surface, cap_cosine, needle_ratio, longest,
                                                    pmp::parameters::vertex_is_constrained_map(fixed));
}

double projected_area(const PolyMesh& mesh) {
  double area = 0;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    const Vec2 a = mesh.positions[face[0]].head<2>();
    area += std::abs(cross(mesh.positions[face[1]].head<2>() - a, mesh.positions[face[2]].head<2>() - a));
  }
  return area;
}

/// Largest first; equals in the order given.
std::vector<UnionPart> by_size(std::span<const UnionPart> parts) {
  std::vector<std::pair<double, UnionPart>> sized;
  for (const UnionPart& part : parts) sized.emplace_back(-projected_area(*part.mesh), part);
  std::stable_sort(sized.begin(), sized.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<UnionPart> result;
  for (const auto& [area, part] : sized) result.push_back(part);
  return result;
}

bool join(Surface& whole, Surface part) {
  ObjectKeeper keeper;
  try {
    return pmp::corefine_and_compute_union(whole, part, whole,
                                           pmp::parameters::throw_on_self_intersection(true).visitor(keeper));
  } catch (const pmp::Corefinement::Self_intersection_exception&) {
    return false;
  } catch (const std::exception&) {  // a failed precondition of the library
    return false;
  }
}

}  // namespace

std::optional<SurfaceUnion> unite_surfaces(std::span<const UnionPart> parts, double sliver, Progress& progress) {
  Surface whole;
  bool first = true;
  for (const UnionPart& part : by_size(parts)) {
    progress.check();
    if (first) {
      whole = to_surface(part);
    } else if (!join(whole, to_surface(part))) {
      return std::nullopt;
    }
    first = false;
  }
  try {
    remove_slivers(whole, sliver);
  } catch (const std::exception&) {  // a failed precondition of the library
    return std::nullopt;
  }
  return from_surface(whole);
}

}  // namespace croquis::silhouette

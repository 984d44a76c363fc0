// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/joining/surface_union.h"

#include <algorithm>
#include <array>
#include <exception>

#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Polygon_mesh_processing/repair_degeneracies.h>
#include <CGAL/Random.h>

#include "algorithms/silhouette/joining/union_surface.h"

namespace croquis::silhouette {
namespace {

namespace pmp = CGAL::Polygon_mesh_processing;

using Kernel = UnionKernel;
using Surface = UnionSurface;
using Face = Surface::Face_index;
using Vertex = Surface::Vertex_index;
using Place = std::optional<Kernel::Point_3>;

// Sheets of one drawing have their points above one another. Sheared along x and y by these, no two boxes begin at the
// same coordinate: the library breaks such ties by addresses, so that results would change from run to run.
constexpr double shear_x = 0.0171;
constexpr double shear_y = 0.0293;

Surface::Property_map<Vertex, Place> places(Surface& surface) {
  return surface.add_property_map<Vertex, Place>("v:place", Place()).first;
}

/// Lets the pieces of a face, and its copies in the other surface, belong to the object of the face; copied vertices
/// keep their places.
class ObjectKeeper : public pmp::Corefinement::Default_visitor<Surface> {
 public:
  /// @param met set as soon as a face is cut by the other surface
  explicit ObjectKeeper(bool& met) : met_(&met) {}

  void before_subface_creations(Face face, Surface& surface) {
    *met_ = true;
    object_ = face_objects(surface)[face];
  }
  void after_subface_created(Face face, Surface& surface) { face_objects(surface)[face] = object_; }
  void after_face_copy(Face from, const Surface& source, Face to, Surface& target) {
    face_objects(target)[to] = source.property_map<Face, Index>("f:object").first[from];
  }
  void after_vertex_copy(Vertex from, const Surface& source, Vertex to, Surface& target) {
    places(target)[to] = source.property_map<Vertex, Place>("v:place").first[from];
  }

 private:
  bool* met_;
  Index object_ = 0;
};

Surface to_surface(const UnionPart& part) {
  Surface surface;
  auto place = places(surface);
  for (const Vec3& p : part.mesh->positions) {
    const Vertex v = surface.add_vertex({p.x() + shear_x * p.z(), p.y() + shear_y * p.z(), p.z()});
    place[v] = Kernel::Point_3(p.x(), p.y(), p.z());
  }
  FaceObjects objects = face_objects(surface);
  for (std::size_t f = 0; f < part.mesh->face_count(); ++f) {
    const auto corners = part.mesh->face(f);
    const Face face = surface.add_face(Vertex(corners[0]), Vertex(corners[1]), Vertex(corners[2]));
    objects[face] = part.object;
  }
  return surface;
}

// A triangle is a cap beyond this cosine of its largest angle, and a needle beyond this ratio of its edges.
constexpr double cap_cosine = -0.94;
constexpr double needle_ratio = 4;

/// Undoes the shear: the parts' own vertices are where they were, to the last bit.
void straighten(Surface& surface) {
  const auto place = places(surface);
  for (const Vertex v : surface.vertices()) {
    const Kernel::Point_3 p = surface.point(v);
    surface.point(v) = place[v].value_or(Kernel::Point_3(p.x() - shear_x * p.z(), p.y() - shear_y * p.z(), p.z()));
  }
}

/// Vertices between faces of two objects.
std::vector<Vertex> seam_vertices(Surface& surface) {
  const FaceObjects objects = face_objects(surface);
  std::vector<Vertex> seam;
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
  auto fixed = surface.add_property_map<Vertex, bool>("v:fixed", true).first;
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

/// The same surface, all its elements numbered by where they are: the library numbers new ones by addresses in memory,
/// and which slivers are removed first depends on these numbers. @return false where faces can't be added in this order
bool renumber(Surface& surface) {
  surface.collect_garbage();
  const auto place = places(surface);
  const FaceObjects objects = face_objects(surface);
  Surface copy;
  auto copied_place = places(copy);
  FaceObjects copied_objects = face_objects(copy);
  std::vector<Vertex> renumbered(surface.number_of_vertices());
  std::vector<Vertex> order(surface.vertices().begin(), surface.vertices().end());
  std::sort(order.begin(), order.end(), [&](Vertex a, Vertex b) { return surface.point(a) < surface.point(b); });
  for (const Vertex v : order) {
    renumbered[v.idx()] = copy.add_vertex(surface.point(v));
    copied_place[renumbered[v.idx()]] = place[v];
  }
  std::vector<std::pair<std::array<Vertex, 3>, Index>> faces;
  for (const Face face : surface.faces()) {
    std::array<Vertex, 3> corners;
    std::size_t i = 0;
    for (const Vertex v : surface.vertices_around_face(surface.halfedge(face))) corners[i++] = renumbered[v.idx()];
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    faces.emplace_back(corners, objects[face]);
  }
  std::sort(faces.begin(), faces.end());
  for (const auto& [corners, object] : faces) {
    const Face copied = copy.add_face(corners);
    if (copied == Surface::null_face()) return false;
    copied_objects[copied] = object;
  }
  surface = std::move(copy);
  return true;
}

/// The library orders some things by the addresses of its two surfaces: here theirs are always in the same order.
struct UnionPair {
  Surface whole;
  Surface part;
};

Meeting join(UnionPair& surfaces) {
  auto& [whole, part] = surfaces;
  // Its search for pairs of faces takes random numbers from here; earlier use must not matter.
  CGAL::get_default_random() = CGAL::Random(0);
  bool met = false;
  ObjectKeeper keeper(met);
  try {
    const bool sound = pmp::corefine_and_compute_union(
        whole, part, whole, pmp::parameters::throw_on_self_intersection(true).visitor(keeper));
    if (!met) return Meeting::Apart;
    return sound ? Meeting::Joined : Meeting::Unsound;
  } catch (const pmp::Corefinement::Self_intersection_exception&) {
    return Meeting::Unsound;
  } catch (const std::exception&) {  // a failed precondition of the library
    return Meeting::Unsound;
  }
}

/// @return false where the library can't
bool clean_seams(Surface& surface, double sliver) {
  if (!renumber(surface)) return false;
  try {
    remove_slivers(surface, sliver);
  } catch (const std::exception&) {  // a failed precondition of the library
    return false;
  }
  return true;
}

}  // namespace

struct GrowingUnion::State {
  UnionPair surfaces;
  double sliver = 0;
};

GrowingUnion::GrowingUnion(const UnionPart& first, double sliver)
    : state_(std::make_unique<State>(State{{to_surface(first), {}}, sliver})) {}

GrowingUnion::~GrowingUnion() = default;

Meeting GrowingUnion::add(const UnionPart& part) {
  Surface before = state_->surfaces.whole;
  state_->surfaces.part = to_surface(part);
  Meeting meeting = join(state_->surfaces);
  if (meeting == Meeting::Joined && !clean_seams(state_->surfaces.whole, state_->sliver)) meeting = Meeting::Unsound;
  if (meeting != Meeting::Joined) state_->surfaces.whole = std::move(before);
  return meeting;
}

std::optional<SurfaceUnion> GrowingUnion::take() {
  Surface& whole = state_->surfaces.whole;
  straighten(whole);
  if (!clean_seams(whole, state_->sliver)) return std::nullopt;
  return from_surface(whole);
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

}  // namespace croquis::silhouette

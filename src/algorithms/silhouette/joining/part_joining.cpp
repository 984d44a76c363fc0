// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <iterator>
#include <map>
#include <optional>

#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Polygon_mesh_processing/repair_degeneracies.h>
#include <CGAL/Random.h>

#include "algorithms/silhouette/joining/joining.h"
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

Surface to_sheared(const Shell& part) {
  Surface surface = to_surface(part);
  auto place = places(surface);
  for (const Vertex v : surface.vertices()) {
    const Kernel::Point_3 p = surface.point(v);
    place[v] = p;
    surface.point(v) = Kernel::Point_3(p.x() + shear_x * p.z(), p.y() + shear_y * p.z(), p.z());
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

/// How a part and a surface that grows met.
enum class Meeting { Joined, Apart, Unsound };

/// The library orders some things by the addresses of its two surfaces: here theirs are always in the same order.
struct UnionPair {
  Surface whole;
  Surface part;
};

Meeting unite(UnionPair& surfaces) {
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
  } catch (const std::exception&) {  // they intersect themselves, or fail a precondition of the library
    return Meeting::Unsound;
  }
}

/// Unless the part is joined the surface stays as it was.
Meeting join(const Shell& part, double sliver, UnionPair& surfaces) {
  Surface before = surfaces.whole;
  surfaces.part = to_sheared(part);
  Meeting meeting = unite(surfaces);
  if (meeting == Meeting::Joined && !clean_seams(surfaces.whole, sliver)) meeting = Meeting::Unsound;
  if (meeting != Meeting::Joined) surfaces.whole = std::move(before);
  return meeting;
}

/// By the area that the viewer sees of them, every layer counted, largest first; equals in the order given.
std::vector<const Shell*> by_size(std::span<const Shell* const> parts) {
  std::vector<std::pair<double, const Shell*>> sized;
  for (const Shell* part : parts) {
    double area = 0;
    for (Index f = 0; f < part->mesh.face_count(); ++f) area += std::abs(seen_area(part->mesh, f));
    sized.emplace_back(-area, part);
  }
  std::stable_sort(sized.begin(), sized.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<const Shell*> result;
  for (const auto& [area, part] : sized) result.push_back(part);
  return result;
}

/// Parts that are joined to one surface, and which pairs can't be.
struct Joining {
  std::span<const ObjectPair> pairs;
  double sliver = 0;
  std::map<ObjectPair, JoinFault> faults{};
  std::vector<const Shell*> members{};  ///< of the surface that grows

  /// Attachments of the part to members that haven't failed yet.
  std::vector<ObjectPair> open_pairs(const Shell& part) const {
    std::vector<ObjectPair> open;
    for (const Shell* member : members) {
      const ObjectPair pair = std::minmax(part.objects.front(), member->objects.front());
      if (std::ranges::find(pairs, pair) != pairs.end() && !faults.contains(pair)) open.push_back(pair);
    }
    return open;
  }
};

/// Finds out which of the part's pairs can't be joined: those that fail by themselves, or else all.
void blame(const Shell& part, Meeting meeting, Joining& joining) {
  const std::vector<ObjectPair> open = joining.open_pairs(part);
  const JoinFault fault = meeting == Meeting::Apart ? JoinFault::DontMeet : JoinFault::Unsound;
  const auto joins_alone = [&](const ObjectPair& pair) {
    const Index other = pair.first == part.objects.front() ? pair.second : pair.first;
    const auto member =
        std::ranges::find(joining.members, other, [](const Shell* own) { return own->objects.front(); });
    UnionPair surfaces{to_sheared(**member), {}};
    return join(part, joining.sliver, surfaces) == Meeting::Joined;
  };
  std::vector<ObjectPair> failing;
  if (fault == JoinFault::Unsound && open.size() > 1) {
    std::ranges::copy_if(open, std::back_inserter(failing), [&](const ObjectPair& pair) { return !joins_alone(pair); });
  }
  for (const ObjectPair& pair : failing.empty() ? open : failing) joining.faults[pair] = fault;
}

/// Everything that can be joined to the largest part that waits. None for a part that nothing was joined to, and for a
/// surface whose seams can't be cleaned: then its last part's pairs fail.
std::optional<Shell> grow(std::vector<const Shell*>& waiting, Joining& joining, Progress& progress) {
  joining.members.assign(1, waiting.front());
  waiting.erase(waiting.begin());
  UnionPair surfaces{to_sheared(*joining.members.front()), {}};
  for (;;) {
    const auto next =
        std::ranges::find_if(waiting, [&](const Shell* part) { return !joining.open_pairs(*part).empty(); });
    if (next == waiting.end()) break;
    progress.check();
    const Meeting meeting = join(**next, joining.sliver, surfaces);
    if (meeting == Meeting::Joined) {
      joining.members.push_back(*next);
      waiting.erase(next);
    } else {
      blame(**next, meeting, joining);
    }
  }
  if (joining.members.size() == 1) return std::nullopt;
  straighten(surfaces.whole);
  if (!clean_seams(surfaces.whole, joining.sliver)) {
    const Shell* last = joining.members.back();
    joining.members.pop_back();
    for (const ObjectPair& pair : joining.open_pairs(*last)) joining.faults[pair] = JoinFault::Unsound;
    return std::nullopt;
  }
  std::vector<Index> objects;
  for (const Shell* member : joining.members) objects.push_back(member->objects.front());
  return from_surface(surfaces.whole, std::move(objects));
}

}  // namespace

PartJoining join_parts(std::span<const Shell* const> parts, std::span<const ObjectPair> pairs, double sliver,
                       Progress& progress) {
  Joining joining{pairs, sliver};
  std::vector<const Shell*> waiting = by_size(parts);
  PartJoining result;
  while (!waiting.empty()) {
    if (std::optional<Shell> group = grow(waiting, joining, progress)) result.groups.push_back(std::move(*group));
  }
  for (const auto& [pair, fault] : joining.faults) result.failed.push_back({pair, fault});
  return result;
}

}  // namespace croquis::silhouette

// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/tools/mesh/mesh_pick.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "croquis/geometry/polyline.h"
#include "croquis/mesh_editing/mesh_selection.h"
#include "tools/pointer/face_tree.h"
#include "tools/pointer/seen_faces.h"
#include "tools/pointer/segment_distance.h"

namespace croquis {
namespace {

/// Model units of half a pixel: what lies so little in front hides nothing.
constexpr double hiding_pixels = 0.5;

constexpr std::size_t elements_at_once = 8192;  // of a box, for one thread

/// Edges shorter than this on the screen are seen or hidden as a whole.
constexpr double short_pixels = 3;

/// What a pixel and its surroundings show: four planes through the eye, and one behind which the eye is.
FaceTree::Planes planes_around(const ViewFrame& frame, const Vec2& pixel, double reach) {
  const auto clip_x = [&](double x) { return 2 * x / frame.size.x() - 1; };
  const auto clip_y = [&](double y) { return 1 - 2 * y / frame.size.y(); };
  const Eigen::Matrix4d& m = frame.to_clip;
  const auto row = [&](int i) { return Eigen::Vector4d(m.row(i).transpose()); };
  return {row(0) - clip_x(pixel.x() - reach) * row(3), clip_x(pixel.x() + reach) * row(3) - row(0),
          row(1) - clip_y(pixel.y() + reach) * row(3), clip_y(pixel.y() - reach) * row(3) - row(1), row(3)};
}

/// Into a list that is used again and again; ascending, as corners are.
void list_faces(const MeshTopology& topology, std::span<const Index> corners, std::vector<Index>& faces) {
  faces.clear();
  for (const Index corner : corners) faces.push_back(topology.face(corner));
}

std::span<const Index> corners_of(const MeshTopology& topology, ComponentKind kind, Index element) {
  return kind == ComponentKind::Vertex ? topology.vertex_corners(element) : topology.edge_corners(element);
}

struct Candidate {
  PickedElement picked;
  double depth = 0;

  bool operator<(const Candidate& other) const {
    if (picked.distance != other.picked.distance) return picked.distance < other.picked.distance;
    if (depth != other.depth) return depth < other.depth;
    return picked.element < other.picked.element;
  }
};

std::optional<Candidate> vertex_near(const PolyMesh& mesh, const ViewFrame& frame, const Vec2& pixel, Index vertex) {
  const auto at = frame.project(mesh.positions[vertex]);
  if (!at) return std::nullopt;
  return Candidate{{vertex, mesh.positions[vertex], (at->pixel - pixel).norm(), 0}, at->depth};
}

std::optional<Candidate> edge_near(const PolyMesh& mesh, const MeshTopology& topology, const ViewFrame& frame,
                                   const Vec2& pixel, Index edge) {
  const auto [a, b] = topology.edge_vertices(edge);
  const auto segment = project_segment(frame, mesh.positions[a], mesh.positions[b]);
  if (!segment) return std::nullopt;
  const double on_screen = nearest_parameter(pixel, segment->a.pixel, segment->b.pixel);
  const Projected foot = segment->at(on_screen);
  const double t = segment->on_edge(on_screen);
  const Vec3 place = mesh.positions[a] + t * (mesh.positions[b] - mesh.positions[a]);
  return Candidate{{edge, place, (foot.pixel - pixel).norm(), t}, foot.depth};
}

bool polygon_has(const std::vector<Projected>& polygon, const Vec2& place) {
  bool has = false;
  const Projected* a = &polygon.back();
  for (const Projected& b : polygon) {
    const Vec2 from = a->pixel - place;
    const Vec2 to = b.pixel - place;
    if ((from.y() > 0) != (to.y() > 0) && (cross(from, to) > 0) == (to.y() > from.y())) has = !has;
    a = &b;
  }
  return has;
}

bool polygon_meets(const std::vector<Projected>& polygon, const PickBox& box) {
  if (polygon.empty()) return false;
  const Projected* a = &polygon.back();
  for (const Projected& b : polygon) {
    if (part_in_box(a->pixel, b.pixel, box)) return true;
    a = &b;
  }
  return polygon_has(polygon, box.low);
}

}  // namespace

struct MeshPicker::State {
  std::shared_ptr<const PolyMesh> mesh;
  std::shared_ptr<const MeshTopology> known_topology;
  std::optional<FaceTree> tree;
  bool moved = false;
  std::vector<Index> loose;  ///< vertices without faces

  const MeshTopology& topology() {
    if (!known_topology) known_topology = std::make_shared<const MeshTopology>(*mesh);
    return *known_topology;
  }

  const FaceTree& fresh_tree() {
    if (!tree) {
      tree.emplace(*mesh);
      std::vector<bool> used(mesh->vertex_count(), false);
      for (const Index vertex : mesh->corners) used[vertex] = true;
      for (Index vertex = 0; vertex < mesh->vertex_count(); ++vertex) {
        if (!used[vertex]) loose.push_back(vertex);
      }
    } else if (moved) {
      tree->refit(*mesh);
    }
    moved = false;
    return *tree;
  }

  /// Elements of faces that may come near the pixel.
  Elements candidates(const ViewFrame& frame, const Vec2& pixel, ComponentKind kind, double reach) {
    Elements elements;
    for (const Index face : fresh_tree().near(planes_around(frame, pixel, reach))) {
      for (Index corner = mesh->face_offsets[face]; corner < mesh->face_offsets[face + 1]; ++corner) {
        const Index element = kind == ComponentKind::Vertex ? mesh->corners[corner] : topology().edge(corner);
        if (element != no_index) elements.push_back(element);
      }
    }
    if (kind == ComponentKind::Vertex) elements.insert(elements.end(), loose.begin(), loose.end());
    return sorted_unique(std::move(elements));
  }
};

MeshPicker::MeshPicker(std::shared_ptr<const PolyMesh> mesh, std::shared_ptr<const MeshTopology> topology)
    : state_(std::make_unique<State>()) {
  state_->mesh = std::move(mesh);
  state_->known_topology = std::move(topology);
}
MeshPicker::~MeshPicker() = default;
MeshPicker::MeshPicker(MeshPicker&&) noexcept = default;
MeshPicker& MeshPicker::operator=(MeshPicker&&) noexcept = default;

void MeshPicker::move_to(std::shared_ptr<const PolyMesh> mesh) {
  if (mesh == state_->mesh) return;
  state_->mesh = std::move(mesh);
  state_->moved = true;
}

void MeshPicker::prepare() { state_->fresh_tree(); }
const PolyMesh& MeshPicker::mesh() const { return *state_->mesh; }
const MeshTopology& MeshPicker::topology() const { return state_->topology(); }

std::optional<PickedElement> MeshPicker::face_under(const Ray& ray) {
  const FaceTree::Hit hit = state_->fresh_tree().first(*state_->mesh, ray, 0, std::numeric_limits<double>::infinity());
  if (hit.face == no_index) return std::nullopt;
  return PickedElement{hit.face, ray.at(hit.distance), hit.distance, 0};
}

bool MeshPicker::visible(const ViewFrame& frame, const Vec3& place, const std::vector<Index>& own_faces) {
  const auto at = frame.project(place);
  if (!at || at->depth < -1) return false;
  const Ray to_eye{place, frame.to_eye(place)};
  const double to_near_plane = (frame.unproject(at->pixel, -1) - place).norm();
  const double from = hiding_pixels * frame.units_per_pixel(place);
  return !state_->fresh_tree().any(*state_->mesh, to_eye, from, to_near_plane, own_faces);
}

std::optional<PickedElement> MeshPicker::at(const ViewFrame& frame, const Vec2& pixel, ComponentKind kind,
                                            const MeshPickOptions& options) {
  if (kind == ComponentKind::Face) return face_under(frame.ray(pixel));
  const bool vertices = kind == ComponentKind::Vertex;
  std::vector<Candidate> candidates;
  for (const Index element : state_->candidates(frame, pixel, kind, options.pixels)) {
    const auto near = vertices ? vertex_near(*state_->mesh, frame, pixel, element)
                               : edge_near(*state_->mesh, state_->topology(), frame, pixel, element);
    if (near && near->picked.distance <= options.pixels) candidates.push_back(*near);
  }
  std::sort(candidates.begin(), candidates.end());
  std::vector<Index> own;
  for (const Candidate& candidate : candidates) {
    list_faces(state_->topology(), corners_of(state_->topology(), kind, candidate.picked.element), own);
    if (options.through || visible(frame, candidate.picked.place, own)) return candidate.picked;
  }
  return std::nullopt;
}

// ---- Boxes

namespace {

/// Everything that a box query looks at.
struct BoxQuery {
  MeshPicker& picker;
  const ViewFrame& frame;
  const PickBox& box;
  const ScreenMesh& screen;
  const SeenFaces* seen;  ///< null to pick through

  bool sees(const Projected& at, const Vec3& place, const std::vector<Index>& own) const {
    const SeenFaces::Answer answer = seen->ask(at, own);
    if (answer == SeenFaces::Answer::Unclear) return picker.visible(frame, place, own);
    return answer == SeenFaces::Answer::Seen;
  }

  bool has_vertex(Index vertex, std::vector<Index>& own) const {
    if (screen.shown[vertex] == 0 || !box.has(screen.vertices[vertex].pixel)) return false;
    if (seen == nullptr) return true;
    list_faces(picker.topology(), picker.topology().vertex_corners(vertex), own);
    return sees(screen.vertices[vertex], picker.mesh().positions[vertex], own);
  }

  bool has_edge(Index edge, std::vector<Index>& own) const {
    const auto [a, b] = picker.topology().edge_vertices(edge);
    if (screen.shown[a] == 0 && screen.shown[b] == 0) return false;
    const bool whole = screen.shown[a] != 0 && screen.shown[b] != 0;
    // Most edges of a big mesh lie far outside: this test needs no second projection.
    if (whole && !part_in_box(screen.vertices[a].pixel, screen.vertices[b].pixel, box)) return false;
    const Vec3& from = picker.mesh().positions[a];
    const Vec3& to = picker.mesh().positions[b];
    const auto segment = project_segment(frame, from, to);
    if (!segment) return false;
    const auto part = part_in_box(segment->a.pixel, segment->b.pixel, box);
    if (!part || seen == nullptr) return part.has_value();
    list_faces(picker.topology(), picker.topology().edge_corners(edge), own);
    const double pixels = (part->second - part->first) * (segment->b.pixel - segment->a.pixel).norm();
    for (const double share : {0.5, 0.125, 0.875}) {
      if (share != 0.5 && pixels < short_pixels) break;
      const double on_screen = part->first + share * (part->second - part->first);
      const Vec3 place = from + segment->on_edge(on_screen) * (to - from);
      if (sees(segment->at(on_screen), place, own)) return true;
    }
    return false;
  }

  /// @param shown whether a cell of the grid shows it
  bool has_face(Index face, bool shown, std::vector<Projected>& polygon) const {
    if (shown) return true;
    project_face(picker.mesh(), frame, screen, face, polygon);
    if (seen == nullptr) return polygon_meets(polygon, box);
    if (polygon.empty()) return false;
    Vec3 middle = Vec3::Zero();
    for (const Index vertex : picker.mesh().face(face)) middle += picker.mesh().positions[vertex];
    middle /= static_cast<double>(picker.mesh().face(face).size());
    const auto at = frame.project(middle);
    return at && at->depth >= -1 && box.has(at->pixel) && sees(*at, middle, {face});
  }
};

}  // namespace

std::vector<Index> MeshPicker::in_box(const ViewFrame& frame, const PickBox& box, ComponentKind kind, bool through) {
  const ScreenMesh screen(*state_->mesh, frame);
  const auto bounds = screen.bounds();
  // A face around the whole view is in every box though none of its corners are.
  if (!bounds) return {};
  const PickBox view{Vec2::Zero(), frame.size};
  const PickBox shown_box{box.low.cwiseMax(view.low), box.high.cwiseMin(view.high)};
  if ((shown_box.low.array() > shown_box.high.array()).any()) return {};
  std::optional<SeenFaces> seen;
  if (!through) {
    const PickBox region{shown_box.low.cwiseMax(bounds->low), shown_box.high.cwiseMin(bounds->high)};
    const bool empty = (region.low.array() > region.high.array()).any();
    seen.emplace(*state_->mesh, frame, screen, empty ? shown_box : region);
  }
  const BoxQuery query{*this, frame, shown_box, screen, seen ? &*seen : nullptr};
  const std::vector<char> drawn =
      seen && kind == ComponentKind::Face ? seen->faces_shown(state_->mesh->face_count()) : std::vector<char>{};
  state_->fresh_tree();  // this and the topology before several threads use them
  std::vector<char> found(element_count(state_->topology(), kind), 0);
  for_each_part(found.size(), elements_at_once, query_threads(), [&](std::size_t begin, std::size_t end) {
    std::vector<Projected> polygon;
    std::vector<Index> own;
    for (std::size_t i = begin; i < end; ++i) {
      const auto element = static_cast<Index>(i);
      const bool has = kind == ComponentKind::Vertex ? query.has_vertex(element, own)
                       : kind == ComponentKind::Edge
                           ? query.has_edge(element, own)
                           : query.has_face(element, !drawn.empty() && drawn[element] != 0, polygon);
      found[element] = has ? 1 : 0;
    }
  });
  Elements elements;
  for (Index element = 0; element < found.size(); ++element) {
    if (found[element] != 0) elements.push_back(element);
  }
  return elements;
}

std::optional<PickedElement> face_under(const PolyMesh& mesh, const Ray& ray) {
  struct Nearest {
    double distance = std::numeric_limits<double>::infinity();
    Index face = no_index;
  };
  const FaceHit meets(ray);
  std::vector<Nearest> parts((mesh.face_count() + elements_at_once - 1) / elements_at_once);
  for_each_part(mesh.face_count(), elements_at_once, query_threads(), [&](std::size_t begin, std::size_t end) {
    Nearest& nearest = parts[begin / elements_at_once];
    for (std::size_t i = begin; i < end; ++i) {
      const auto distance = meets.distance(mesh, static_cast<Index>(i));
      if (distance && *distance >= 0 && *distance < nearest.distance) nearest = {*distance, static_cast<Index>(i)};
    }
  });
  const auto nearest = std::ranges::min_element(parts, {}, &Nearest::distance);
  if (nearest == parts.end() || nearest->face == no_index) return std::nullopt;
  return PickedElement{nearest->face, ray.at(nearest->distance), nearest->distance, 0};
}

}  // namespace croquis

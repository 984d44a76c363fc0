// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/hole_filling/verification/patch_structure.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include <Eigen/Geometry>

#include "croquis/geometry/degenerate_faces.h"
#include "croquis/geometry/mesh_topology.h"
#include "croquis/geometry/single_precision.h"

namespace croquis::hole_filling {
namespace {

using Edge = std::array<Index, 2>;

/// Rim edges as the patch must run them: against the holes' faces, by the view's vertices; sorted.
std::vector<Edge> expected_border(const HoleAnalysis& analysis, const HolePatch& patch) {
  std::vector<Edge> border;
  for (const Index id : patch.holes) {
    const auto& rim = analysis.holes[id].vertices;
    for (std::size_t i = 0; i < rim.size(); ++i)
      border.push_back({analysis.view.representative_of(rim[i + 1 == rim.size() ? 0 : i + 1]),
                        analysis.view.representative_of(rim[i])});
  }
  std::sort(border.begin(), border.end());
  return border;
}

std::string edge_fault(const LocalPatch& local, const MeshTopology& topology, const std::vector<Edge>& expected) {
  std::vector<Edge> border;
  for (Index edge = 0; edge < topology.edge_count(); ++edge) {
    const auto corners = topology.edge_corners(edge);
    const auto ends = topology.edge_vertices(edge);
    if (corners.size() > 2) return "an edge of the patch has more than two faces";
    if (corners.size() == 1)
      border.push_back({local.vertices[ends[0]], local.vertices[ends[1]]});
    else if (topology.vertex(corners[0]) == topology.vertex(corners[1]))
      return "faces of the patch disagree in direction";
  }
  std::sort(border.begin(), border.end());
  return border == expected ? "" : "the patch's border isn't the rim";
}

/// More fans at a vertex than one, or than rims there are that share it.
bool touches_itself(const LocalPatch& local, const MeshTopology& topology, const std::vector<Edge>& border) {
  for (Index vertex = 0; vertex < topology.vertex_count(); ++vertex) {
    if (topology.fan_count(vertex) == 1) continue;
    const auto rims = std::ranges::equal_range(border, local.vertices[vertex], {}, [](const Edge& e) { return e[0]; });
    if (topology.fan_count(vertex) > rims.size()) return true;
  }
  return false;
}

bool is_sphere_with_holes(const LocalPatch& local, const MeshTopology& topology, std::size_t holes) {
  const auto euler = static_cast<std::ptrdiff_t>(local.vertices.size() + topology.face_count()) -
                     static_cast<std::ptrdiff_t>(topology.edge_count());
  return topology.component_count() == 1 && euler == 2 - static_cast<std::ptrdiff_t>(holes);
}

/// Numbers a patch's vertices: those of the view first, which are few and searched for, then the new ones.
class LocalNumbers {
 public:
  LocalNumbers(const PolyMesh& mesh, const SurfaceView& view, const HolePatch& patch)
      : mesh_(mesh), view_(view), number_of_new_(patch.points.size(), no_index) {
    constexpr Index used = 0;
    for (const auto& t : patch.triangles) {
      for (const Index vertex : t) {
        if (vertex < mesh.vertex_count())
          vertices_.push_back(view.representative_of(vertex));
        else
          number_of_new_[vertex - mesh.vertex_count()] = used;
      }
    }
    std::sort(vertices_.begin(), vertices_.end());
    vertices_.erase(std::unique(vertices_.begin(), vertices_.end()), vertices_.end());
    of_view_ = std::ssize(vertices_);
    for (Index i = 0; i < number_of_new_.size(); ++i) {
      if (number_of_new_[i] == no_index) continue;
      number_of_new_[i] = static_cast<Index>(vertices_.size());
      vertices_.push_back(static_cast<Index>(mesh.vertex_count()) + i);
    }
  }

  /// As LocalPatch has them.
  const std::vector<Index>& vertices() const { return vertices_; }

  Index operator()(Index vertex) const {
    if (vertex >= mesh_.vertex_count()) return number_of_new_[vertex - mesh_.vertex_count()];
    const auto end = vertices_.begin() + of_view_;
    return static_cast<Index>(std::lower_bound(vertices_.begin(), end, view_.representative_of(vertex)) -
                              vertices_.begin());
  }

 private:
  const PolyMesh& mesh_;
  const SurfaceView& view_;
  std::vector<Index> vertices_;
  std::ptrdiff_t of_view_ = 0;
  std::vector<Index> number_of_new_;
};

/// The least corner angle. Angles fall as cotangents rise, so that one arc tangent does for all.
double least_angle(const PolyMesh& mesh) {
  double greatest = -std::numeric_limits<double>::infinity();
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto t = mesh.face(f);
    const std::array<Vec3, 3> sides = {mesh.positions[t[1]] - mesh.positions[t[0]],
                                       mesh.positions[t[2]] - mesh.positions[t[1]],
                                       mesh.positions[t[0]] - mesh.positions[t[2]]};
    const double twice_area = sides[0].cross(sides[1]).norm();
    for (std::size_t i = 0; i < 3; ++i) greatest = std::max(greatest, -sides[i].dot(sides[(i + 1) % 3]) / twice_area);
  }
  return std::isinf(greatest) && greatest < 0 ? std::numbers::pi : std::atan2(1, greatest);
}

/// The patch's faces across its rims: directed edges between vertices of the view with their faces' normals, sorted.
std::vector<std::pair<Edge, Vec3>> normals_at_rims(const PolyMesh& mesh, const LocalPatch& local) {
  std::vector<std::pair<Edge, Vec3>> normals;
  for (std::size_t f = 0; f < local.mesh.face_count(); ++f) {
    const auto t = local.mesh.face(f);
    const auto at = [&](std::size_t i) -> const Vec3& { return local.mesh.positions[t[i]]; };
    for (std::size_t i = 0; i < 3; ++i) {
      const Edge edge = {local.vertices[t[i]], local.vertices[t[(i + 1) % 3]]};
      if (std::max(edge[0], edge[1]) >= mesh.vertex_count()) continue;
      normals.emplace_back(edge, (at(1) - at(0)).cross(at(2) - at(0)));
    }
  }
  std::sort(normals.begin(), normals.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  return normals;
}

}  // namespace

LocalPatch make_local(const PolyMesh& mesh, const HoleAnalysis& analysis, const HolePatch& patch, Precision precision) {
  const LocalNumbers number(mesh, analysis.view, patch);
  LocalPatch local;
  local.vertices = number.vertices();
  local.mesh.positions.reserve(local.vertices.size());
  for (const Index v : local.vertices)
    local.mesh.positions.push_back(v < mesh.vertex_count() ? mesh.positions[v] : patch.points[v - mesh.vertex_count()]);
  if (precision == Precision::Single) round_to_single(local.mesh.positions);
  local.mesh.corners.reserve(3 * patch.triangles.size());
  local.mesh.face_offsets.reserve(patch.triangles.size() + 1);
  for (const auto& t : patch.triangles) local.mesh.add_face(std::array{number(t[0]), number(t[1]), number(t[2])});
  return local;
}

std::string structure_fault(const PolyMesh& mesh, const HoleAnalysis& analysis, const HolePatch& patch,
                            Precision precision) {
  if (patch.triangles.empty()) return "the patch is empty";
  for (const Vec3& point : patch.points) {
    if (!point.allFinite()) return "a coordinate isn't finite";
  }
  const LocalPatch local = make_local(mesh, analysis, patch, precision);
  if (!degenerate_faces(local.mesh).empty()) return "a triangle of the patch has no area";
  const MeshTopology topology(local.mesh);
  const std::vector<Edge> border = expected_border(analysis, patch);
  if (std::string fault = edge_fault(local, topology, border); !fault.empty()) return fault;
  if (touches_itself(local, topology, border)) return "parts of the patch touch in a vertex";
  if (!is_sphere_with_holes(local, topology, patch.holes.size())) return "the patch isn't one simple piece";
  return "";
}

std::vector<Edge> chords_of(const PolyMesh& mesh, const HoleAnalysis& analysis, const HolePatch& patch) {
  std::vector<Edge> edges;
  for (const auto& t : patch.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      if (std::max(t[i], t[(i + 1) % 3]) >= mesh.vertex_count()) continue;
      const auto [low, high] =
          std::minmax({analysis.view.representative_of(t[i]), analysis.view.representative_of(t[(i + 1) % 3])});
      edges.push_back({low, high});
    }
  }
  std::sort(edges.begin(), edges.end());
  std::vector<Edge> chords;  // inner edges come twice
  for (std::size_t i = 1; i < edges.size(); ++i) {
    if (edges[i] == edges[i - 1]) chords.push_back(edges[i]);
  }
  return chords;
}

PatchVerdict measure_patch(const PolyMesh& mesh, const HoleAnalysis& analysis, const HolePatch& patch) {
  const LocalPatch local = make_local(mesh, analysis, patch);
  const auto edges = normals_at_rims(mesh, local);
  PatchVerdict verdict;
  verdict.min_angle = least_angle(local.mesh);
  const SurfaceView& view = analysis.view;
  for (const Index id : patch.holes) {
    for (const Index corner : analysis.holes[id].corners) {
      const Edge across = {view.target(corner), view.origin(corner)};
      const auto found = std::ranges::lower_bound(edges, across, {}, [](const auto& edge) { return edge.first; });
      if (found == edges.end() || found->first != across) continue;
      const auto& t = view.triangles[corner / 3];
      const Vec3& a = mesh.positions[t[0]];
      const Vec3 own = (mesh.positions[t[1]] - a).cross(mesh.positions[t[2]] - a);
      verdict.max_normal_jump = std::max(verdict.max_normal_jump, angle_between(own, found->second));
    }
  }
  return verdict;
}

}  // namespace croquis::hole_filling

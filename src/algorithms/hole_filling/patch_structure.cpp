// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/hole_filling/patch_structure.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "algorithms/hole_filling/single_precision.h"
#include "croquis/geometry/degenerate_faces.h"
#include "croquis/geometry/mesh_topology.h"

namespace croquis::hole_filling {
namespace {

using Edge = std::array<Index, 2>;

Index in_view(const PolyMesh& mesh, const SurfaceView& view, Index vertex) {
  return vertex < mesh.vertex_count() ? view.representative_of(vertex) : vertex;
}

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

double corner_angle(const Vec3& at, const Vec3& a, const Vec3& b) {
  return std::atan2((a - at).cross(b - at).norm(), (a - at).dot(b - at));
}

}  // namespace

LocalPatch make_local(const PolyMesh& mesh, const HoleAnalysis& analysis, const HolePatch& patch, Precision precision) {
  LocalPatch local;
  std::vector<std::array<Index, 3>> triangles = patch.triangles;
  for (auto& t : triangles) {
    for (Index& vertex : t) local.vertices.push_back(vertex = in_view(mesh, analysis.view, vertex));
  }
  std::sort(local.vertices.begin(), local.vertices.end());
  local.vertices.erase(std::unique(local.vertices.begin(), local.vertices.end()), local.vertices.end());
  for (const Index v : local.vertices)
    local.mesh.positions.push_back(v < mesh.vertex_count() ? mesh.positions[v] : patch.points[v - mesh.vertex_count()]);
  if (precision == Precision::Single) round_to_single(local.mesh.positions);
  for (auto& t : triangles) {
    for (Index& vertex : t) {
      const auto found = std::lower_bound(local.vertices.begin(), local.vertices.end(), vertex);
      vertex = static_cast<Index>(found - local.vertices.begin());
    }
    local.mesh.add_face(t);
  }
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
      const auto [low, high] =
          std::minmax({in_view(mesh, analysis.view, t[i]), in_view(mesh, analysis.view, t[(i + 1) % 3])});
      if (high < mesh.vertex_count()) edges.push_back({low, high});
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
  const auto normal = [](const Vec3& a, const Vec3& b, const Vec3& c) { return Vec3((b - a).cross(c - a)); };
  std::vector<std::pair<Edge, Vec3>> border;  // every directed edge of the patch with its face's normal
  PatchVerdict verdict;
  verdict.min_angle = std::numbers::pi;
  for (std::size_t f = 0; f < local.mesh.face_count(); ++f) {
    const auto t = local.mesh.face(f);
    const auto at = [&](std::size_t i) -> const Vec3& { return local.mesh.positions[t[i % 3]]; };
    const Vec3 face_normal = normal(at(0), at(1), at(2));
    for (std::size_t i = 0; i < 3; ++i) {
      verdict.min_angle = std::min(verdict.min_angle, corner_angle(at(i), at(i + 1), at(i + 2)));
      border.emplace_back(Edge{local.vertices[t[i]], local.vertices[t[(i + 1) % 3]]}, face_normal);
    }
  }
  const auto by_edge = [](const auto& a, const auto& b) { return a.first < b.first; };
  std::sort(border.begin(), border.end(), by_edge);
  const SurfaceView& view = analysis.view;
  for (const Index id : patch.holes) {
    for (const Index corner : analysis.holes[id].corners) {
      const Edge across = {view.target(corner), view.origin(corner)};
      const auto found = std::lower_bound(border.begin(), border.end(), std::pair(across, Vec3()), by_edge);
      if (found == border.end() || found->first != across) continue;
      const auto& t = view.triangles[corner / 3];
      const Vec3 own = normal(mesh.positions[t[0]], mesh.positions[t[1]], mesh.positions[t[2]]);
      verdict.max_normal_jump = std::max(verdict.max_normal_jump, corner_angle(Vec3::Zero(), own, found->second));
    }
  }
  return verdict;
}

}  // namespace croquis::hole_filling

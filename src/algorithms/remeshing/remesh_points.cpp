// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/remeshing/remesh_points.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "algorithms/remeshing/vertices_per_part.h"
#include "croquis/base/parallel.h"
#include "croquis/hole_filling/hole_site.h"
#include "croquis/hole_filling/quadric_normals.h"
#include "croquis/hole_filling/surface_reach.h"

namespace croquis::remeshing {
namespace {

using namespace hole_filling;

constexpr double quadric_reach = 4;      // × mean edge of the rim, around it
constexpr double smooth_dihedral = 0.5;  // cosine: beyond, the normal of an edge isn't known
constexpr std::uint8_t unsound = SurfaceView::NoArea | SurfaceView::Sliver;

Vec3 normal_of(const PolyMesh& mesh, const SurfaceView& view, std::size_t triangle) {
  if ((view.flags[triangle] & unsound) != 0) return Vec3::Zero();
  const auto& [a, b, c] = view.triangles[triangle];
  return unit_or_zero((mesh.positions[b] - mesh.positions[a]).cross(mesh.positions[c] - mesh.positions[a]));
}

Vec3 normal_at(const PolyMesh& mesh, const SurfaceView& view, const TriangleFans& fans, std::size_t vertex) {
  Vec3 sum = Vec3::Zero();
  for (const Index corner : fans.at(vertex)) {
    if ((view.flags[corner / 3] & unsound) != 0) continue;
    const Vec3 out = mesh.positions[fans.next(corner)] - mesh.positions[vertex];
    const Vec3 in = mesh.positions[fans.previous(corner)] - mesh.positions[vertex];
    const Vec3 across = out.cross(in);
    const double length = across.norm();
    if (length > 0) sum += std::atan2(length, out.dot(in)) / length * across;
  }
  return unit_or_zero(sum);
}

/// Points on the long edges and large triangles of one piece.
class Sampling {
 public:
  Sampling(const PolyMesh& mesh, const SurfaceView& view, double edge, RemeshPoints& points)
      : mesh_(mesh), view_(view), spacing_(sample_spacing * edge), longest_(longest_edge * edge), points_(points) {}

  void add(Index triangle) {
    const auto& corners = view_.triangles[triangle];
    std::size_t longest = 0;
    std::array<double, 3> lengths;
    for (std::size_t i = 0; i < 3; ++i) {
      lengths[i] = (mesh_.positions[corners[(i + 1) % 3]] - mesh_.positions[corners[i]]).norm();
      if (lengths[i] > lengths[longest]) longest = i;
      if (lengths[i] > longest_) along_edge(3 * triangle + static_cast<Index>(i), lengths[i]);
    }
    if (lengths[longest] > longest_) inside(triangle, longest, lengths[longest]);
  }

 private:
  /// Once per edge: from its lower corner.
  void along_edge(Index corner, double length) {
    const Index other = view_.opposite[corner];
    if (view_.has_opposite(corner) && other < corner) return;
    Vec3 normal = normal_of(mesh_, view_, corner / 3);
    if (view_.has_opposite(corner)) {
      const Vec3 beyond = normal_of(mesh_, view_, other / 3);
      normal = beyond.dot(normal) > smooth_dihedral ? unit_or_zero(normal + beyond) : Vec3(Vec3::Zero());
    }
    const Vec3& from = mesh_.positions[view_.origin(corner)];
    row(corner / 3, from, mesh_.positions[view_.target(corner)] - from, length, normal);
  }

  /// Rows along the longest edge.
  void inside(Index triangle, std::size_t longest, double length) {
    const auto& corners = view_.triangles[triangle];
    const Vec3& from = mesh_.positions[corners[longest]];
    const Vec3 along = mesh_.positions[corners[(longest + 1) % 3]] - from;
    const Vec3 up = mesh_.positions[corners[(longest + 2) % 3]] - from;
    const double height = along.cross(up).norm() / length;
    const Vec3 normal = normal_of(mesh_, view_, triangle);
    const auto rows = static_cast<int>(std::ceil(height / spacing_));
    for (int r = 1; r < rows; ++r) {
      const double t = static_cast<double>(r) / rows;
      row(triangle, from + t * up, (1 - t) * along, (1 - t) * length, normal);
    }
  }

  void row(Index triangle, const Vec3& from, const Vec3& along, double length, const Vec3& normal) {
    const auto steps = static_cast<int>(std::ceil(length / spacing_));
    for (int s = 1; s < steps; ++s) {
      points_.positions.emplace_back(from + static_cast<double>(s) / steps * along);
      points_.normals.push_back(normal);
      points_.triangles.push_back(triangle);
    }
  }

  const PolyMesh& mesh_;
  const SurfaceView& view_;
  double spacing_, longest_;
  RemeshPoints& points_;
};

/// The vertices on the rims of a group of holes, with their normals.
std::vector<ReachedVertex> rim_normals(const PolyMesh& mesh, const HoleAnalysis& analysis,
                                       const std::vector<Index>& group) {
  const HoleSite site = make_site(mesh, analysis, group, {});
  std::vector<ReachedVertex> reached = reach_from_rims(site, quadric_reach * mean_rim_edge(site));
  fit_rim_normals(reached, mesh.positions, tree_of(reached, mesh.positions));
  return {reached.begin(), std::ranges::find_if(reached, [](const ReachedVertex& r) { return r.distance != 0; })};
}

std::vector<std::vector<ReachedVertex>> rim_normals(const PolyMesh& mesh, const HoleAnalysis& analysis,
                                                    const RemeshPieces& pieces, int threads, Progress& progress) {
  std::vector<const std::vector<Index>*> groups;
  for (const RemeshPiece& piece : pieces.pieces)
    for (const std::vector<Index>& group : piece.groups) groups.push_back(&group);
  std::vector<std::vector<ReachedVertex>> rims(groups.size());
  for_each_part(groups.size(), 1, threads, progress, [&](std::size_t begin, std::size_t end) {
    for (std::size_t g = begin; g < end; ++g) rims[g] = rim_normals(mesh, analysis, *groups[g]);
  });
  return rims;
}

}  // namespace

double typical_edge(const PolyMesh& mesh, const SurfaceView& view) {
  double sum = 0;
  for (const auto& t : view.triangles) {
    for (std::size_t i = 0; i < 3; ++i) sum += (mesh.positions[t[(i + 1) % 3]] - mesh.positions[t[i]]).norm();
  }
  return std::min(sum / (3 * static_cast<double>(view.triangles.size())), longest_typical_edge * view.diagonal);
}

std::vector<Vec3> vertex_normals(const PolyMesh& mesh, const HoleAnalysis& analysis, const TriangleFans& fans,
                                 const RemeshPieces& pieces, int threads, Progress& progress) {
  std::vector<Vec3> normals(mesh.vertex_count());
  for_each_part(normals.size(), vertices_per_part, threads, progress, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) normals[v] = normal_at(mesh, analysis.view, fans, v);
  });
  const auto rims = rim_normals(mesh, analysis, pieces, threads, progress);
  for (const std::vector<ReachedVertex>& rim : rims)
    for (const ReachedVertex& vertex : rim) normals[vertex.vertex] = vertex.normal;
  return normals;
}

RemeshPoints points_of(const PolyMesh& mesh, const HoleAnalysis& analysis, const RemeshPiece& piece,
                       const std::vector<Vec3>& normals, double edge) {
  RemeshPoints points;
  points.positions.reserve(piece.vertices.size());
  points.normals.reserve(piece.vertices.size());
  for (const Index v : piece.vertices) {
    points.positions.push_back(mesh.positions[v]);
    points.normals.push_back(normals[v]);
  }
  Sampling sampling(mesh, analysis.view, edge, points);
  for (const Index t : piece.triangles) sampling.add(t);
  return points;
}

}  // namespace croquis::remeshing

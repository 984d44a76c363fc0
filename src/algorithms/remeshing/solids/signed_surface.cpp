// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/remeshing/solids/signed_surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>

#include "algorithms/remeshing/vertices_per_part.h"
#include "croquis/base/parallel.h"

namespace croquis::remeshing {
namespace {

// Cosines of a vertex' normal and its triangles': surfaces are smooth above the one, creased below the other.
constexpr double smooth_cosine = 0.9;
constexpr double unbent_cosine = 0.75;

std::vector<std::array<Vec3, 3>> triangles_of(const PolyMesh& mesh) {
  std::vector<std::array<Vec3, 3>> triangles;
  triangles.reserve(mesh.face_count());
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    triangles.push_back({mesh.positions[face[0]], mesh.positions[face[1]], mesh.positions[face[2]]});
  }
  return triangles;
}

PolyMesh geometry_of(const PolyMesh& mesh) {
  PolyMesh plain;
  plain.positions = mesh.positions;
  plain.corners = mesh.corners;
  plain.face_offsets = mesh.face_offsets;
  return plain;
}

}  // namespace

SignedSurface::SignedSurface(const PolyMesh& mesh, int threads, Progress& progress)
    : mesh_(geometry_of(mesh)),
      fans_(mesh_.vertex_count(), mesh_.corners),
      tree_(triangles_of(mesh_), progress),
      box_(implicit::bounds(mesh_.positions)) {
  find_vertex_normals(threads, progress);
  find_smooth_places();
  find_ways_out(progress);
  for (Index t = 0; t < mesh_.face_count(); ++t) {
    const auto face = mesh_.face(t);
    const Vec3 a = mesh_.positions[face[0]] - box_.middle();
    const Vec3 b = mesh_.positions[face[1]] - box_.middle();
    volume_ += a.dot(b.cross(mesh_.positions[face[2]] - box_.middle())) / 6;
  }
}

Vec3 SignedSurface::normal_of(Index triangle) const {
  const auto face = mesh_.face(triangle);
  const Vec3& a = mesh_.positions[face[0]];
  return unit_or_zero((mesh_.positions[face[1]] - a).cross(mesh_.positions[face[2]] - a));
}

void SignedSurface::find_vertex_normals(int threads, Progress& progress) {
  normals_.assign(mesh_.vertex_count(), Vec3::Zero());
  for_each_part(normals_.size(), vertices_per_part, threads, progress, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      for (const Index corner : fans_.at(v)) {
        const Vec3 next = mesh_.positions[fans_.next(corner)] - mesh_.positions[v];
        const Vec3 previous = mesh_.positions[fans_.previous(corner)] - mesh_.positions[v];
        normals_[v] += std::atan2(next.cross(previous).norm(), next.dot(previous)) * normal_of(corner / 3);
      }
      normals_[v] = unit_or_zero(normals_[v]);
    }
  });
}

void SignedSurface::find_smooth_places() {
  smooth_.assign(mesh_.vertex_count(), 1);
  for (std::size_t c = 0; c < mesh_.corners.size(); ++c) {
    const Index v = mesh_.corners[c];
    const double agrees = normals_[v].dot(normal_of(static_cast<Index>(c / 3)));
    const double share = std::clamp((agrees - unbent_cosine) / (smooth_cosine - unbent_cosine), 0.0, 1.0);
    smooth_[v] = std::min(smooth_[v], static_cast<float>(share));
  }
}

/// How far above a triangle the curved surface lies.
double SignedSurface::bulge(Index triangle, const Vec3& foot) const {
  const auto face = mesh_.face(triangle);
  const Vec3 &a = mesh_.positions[face[0]], &b = mesh_.positions[face[1]], &c = mesh_.positions[face[2]];
  const Vec3 normal = (b - a).cross(c - a);
  const double squared = normal.squaredNorm();
  if (!(squared > 0)) return 0;
  double above = 0;
  const std::array<Vec3, 3> corners = {a, b, c};
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3& next = corners[(i + 1) % 3];
    const double weight = (corners[(i + 2) % 3] - next).cross(foot - next).dot(normal) / squared;
    above += weight * static_cast<double>(smooth_[face[i]]) * (corners[i] - foot).dot(normals_[face[i]]);
  }
  return 0.5 * above;
}

/// Of the edge that begins at a corner: the sum of its triangles' normals.
Vec3 SignedSurface::across(Index corner, bool& is_border) const {
  Vec3 sum = normal_of(corner / 3);
  is_border = true;
  const Index from = mesh_.corners[corner], to = fans_.next(corner);
  for (const Index other : fans_.at(to)) {
    if (fans_.next(other) != from) continue;
    is_border = false;
    sum += normal_of(other / 3);
  }
  return sum;
}

void SignedSurface::find_ways_out(const Progress& progress) {
  for (Index corner = 0; corner < mesh_.corners.size(); ++corner) {
    if (corner % vertices_per_part == 0) progress.check();
    bool is_border = false;
    across(corner, is_border);
    if (!is_border) continue;
    is_closed_ = false;
    if (outs_.empty()) outs_.assign(mesh_.vertex_count(), Vec3::Zero());
    const Index from = mesh_.corners[corner], to = fans_.next(corner);
    const Vec3 out = (mesh_.positions[to] - mesh_.positions[from]).cross(normal_of(corner / 3));
    outs_[from] += out;
    outs_[to] += out;
  }
}

SignedPlace SignedSurface::at(const Vec3& place, double within) const {
  TriangleFoot foot = tree_.nearest(place, within);
  if (foot.triangle == no_index) foot = tree_.nearest(place, std::numeric_limits<double>::infinity());
  SignedPlace found;
  found.triangle = foot.triangle;
  const Index first = 3 * foot.triangle;
  Vec3 normal, out = Vec3::Zero();
  if (foot.corner >= 0) {
    const Index vertex = mesh_.corners[first + static_cast<Index>(foot.corner)];
    normal = normals_[vertex];
    if (!outs_.empty()) out = outs_[vertex];
  } else if (foot.edge >= 0) {
    const Index corner = first + static_cast<Index>(foot.edge);
    bool is_border = false;
    normal = across(corner, is_border);
    if (is_border) out = (mesh_.positions[fans_.next(corner)] - mesh_.positions[mesh_.corners[corner]]).cross(normal);
  } else {
    normal = normal_of(foot.triangle);
  }
  const Vec3 away = place - foot.point;
  const bool is_inside = away.dot(normal) < 0;
  found.distance = is_inside ? -foot.distance : foot.distance;
  found.value = found.distance - bulge(foot.triangle, foot.point);
  found.out = away.dot(unit_or_zero(out));
  found.gradient = foot.distance > 0 ? Vec3((is_inside ? -1 : 1) / foot.distance * away) : unit_or_zero(normal);
  return found;
}

}  // namespace croquis::remeshing

// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/remeshing/views/view_seams.h"

#include <algorithm>
#include <map>
#include <set>

#include <Eigen/Geometry>

#include "croquis/implicit/point_tree.h"

namespace croquis::remeshing {
namespace {

using namespace hole_filling;

constexpr double seam_reach = 3;   // × edge: views between which a row of faces is missing
constexpr double seam_height = 1;  // × edge, along both normals: what views are misplaced by
constexpr double agrees = 0.6;     // cosine
constexpr std::size_t least_seam = 16;
constexpr double least_share = 0.1;
constexpr double rim_share = 0.2;

/// What is known of one component that has a rim.
struct Sheet {
  std::size_t rim = 0;                // vertices on it
  std::map<Index, std::size_t> near;  // of these, by the component that they go on in
};

class SeamFinder {
 public:
  SeamFinder(const PolyMesh& mesh, const SurfaceView& view, double edge) : mesh_(mesh), view_(view), edge_(edge) {}

  ViewSeams run() {
    list_rims();
    if (sheets_.size() < 2) return {};
    list_vertices();
    const implicit::PointTree tree(places_);
    for (const auto& [vertex, component] : rims_) look_around(vertex, component, tree);
    return joined();
  }

 private:
  /// Components whose whole rim is shorter than the least seam go on in nothing.
  void list_rims() {
    for (const Index corner : view_.rim_corners) rims_.emplace_back(view_.origin(corner), view_.component[corner / 3]);
    std::ranges::sort(rims_);
    rims_.erase(std::ranges::unique(rims_).begin(), rims_.end());
    for (const auto& [vertex, component] : rims_) ++sheets_[component].rim;
    std::erase_if(sheets_, [](const auto& sheet) { return 2 * sheet.second.rim < least_seam; });
    std::erase_if(rims_, [&](const auto& rim) { return !sheets_.contains(rim.second); });
  }

  void list_vertices() {
    normals_.assign(mesh_.vertex_count(), Vec3::Zero());
    component_.assign(mesh_.vertex_count(), no_index);
    for (std::size_t t = 0; t < view_.triangles.size(); ++t) {
      if (!sheets_.contains(view_.component[t])) continue;
      const auto& [a, b, c] = view_.triangles[t];
      const Vec3& at = mesh_.positions[a];
      const Vec3 normal = (mesh_.positions[b] - at).cross(mesh_.positions[c] - at);
      for (const Index v : view_.triangles[t]) {
        normals_[v] += normal;
        component_[v] = view_.component[t];
      }
    }
    for (Index v = 0; v < component_.size(); ++v) {
      normals_[v] = unit_or_zero(normals_[v]);
      if (component_[v] == no_index) continue;
      vertices_.push_back(v);
      places_.push_back(mesh_.positions[v]);
    }
  }

  void look_around(Index vertex, Index component, const implicit::PointTree& tree) {
    const Vec3& place = mesh_.positions[vertex];
    const Vec3 reach = Vec3::Constant(seam_reach * edge_);
    std::set<Index> found;
    for (const Index i : tree.inside({place - reach, place + reach})) {
      const Index other = vertices_[i];
      if (component_[other] == component || found.contains(component_[other])) continue;
      if (goes_on_at(vertex, other)) found.insert(component_[other]);
    }
    for (const Index other : found) {
      ++sheets_[component].near[other];
      meetings_.emplace_back(vertex, std::minmax(component, other));
    }
  }

  bool goes_on_at(Index vertex, Index other) const {
    const Vec3 away = mesh_.positions[other] - mesh_.positions[vertex];
    const double height = std::max(std::abs(away.dot(normals_[vertex])), std::abs(away.dot(normals_[other])));
    return away.norm() <= seam_reach * edge_ && height <= seam_height * edge_ &&
           normals_[vertex].dot(normals_[other]) >= agrees;
  }

  bool are_joined(Index a, Index b) {
    Sheet &first = sheets_[a], &second = sheets_[b];
    const std::size_t count = first.near[b] + second.near[a];
    return count >= least_seam &&
           static_cast<double>(count) >= least_share * static_cast<double>(std::min(first.rim, second.rim));
  }

  ViewSeams joined() {
    ViewSeams seams;
    std::map<std::pair<Index, Index>, bool> known;
    for (const auto& [vertex, pair] : meetings_) {
      if (!known.contains(pair)) known[pair] = are_joined(pair.first, pair.second);
      if (!known[pair]) continue;
      seams.vertices.resize(mesh_.vertex_count(), 0);
      seams.vertices[vertex] = 1;
    }
    for (const auto& [pair, is_joined] : known)
      if (is_joined) seams.joined.push_back(pair);
    return seams;
  }

  const PolyMesh& mesh_;
  const SurfaceView& view_;
  double edge_;
  std::vector<std::pair<Index, Index>> rims_;  // vertices, with their components
  std::map<Index, Sheet> sheets_;              // by component
  std::vector<Vec3> normals_;                  // of the mesh's vertices
  std::vector<Index> component_;               // of the mesh's vertices
  std::vector<Index> vertices_;                // of sheets
  std::vector<Vec3> places_;                   // of these
  std::vector<std::pair<Index, std::pair<Index, Index>>> meetings_;
};

bool is_wished(const Hole& hole, const std::vector<HoleRequest>& requests) {
  return std::ranges::any_of(requests, [&](const HoleRequest& request) {
    return std::ranges::find(request.holes, hole.id) != request.holes.end();
  });
}

}  // namespace

ViewSeams find_view_seams(const PolyMesh& mesh, const HoleAnalysis& analysis, const std::vector<HoleRequest>& requests,
                          double edge) {
  ViewSeams seams = SeamFinder(mesh, analysis.view, edge).run();
  if (seams.joined.empty()) return seams;
  for (const Hole& hole : analysis.holes) {
    const auto count = std::ranges::count_if(hole.vertices, [&](Index v) { return seams.at(v); });
    const bool is_rim = static_cast<double>(count) > rim_share * static_cast<double>(hole.vertices.size());
    seams.rims.push_back(is_rim && !is_wished(hole, requests) ? 1 : 0);
  }
  return seams;
}

}  // namespace croquis::remeshing

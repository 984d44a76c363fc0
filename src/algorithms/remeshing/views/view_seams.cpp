// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/remeshing/views/view_seams.h"

#include <algorithm>
#include <map>
#include <set>

#include <Eigen/Geometry>

#include "algorithms/remeshing/views/turned_views.h"
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
constexpr double turned_height = 0.5;  // × edge, in the mean: farther apart are sides of a wall
constexpr double same_height = 0.15;   // × edge, in the mean: no wall is as thin
constexpr double wall_share = 0.8;     // of the rims of both sides of a wall run along the other one

/// Rim vertices beside which another component goes on.
struct Meeting {
  std::size_t count = 0;
  double heights = 0;  // sum, from the rim to that component
};

/// What is known of one component that has a rim.
struct Sheet {
  std::size_t rim = 0;               // vertices on it
  std::map<Index, Meeting> near;     // by the component that they go on in
  std::map<Index, Meeting> opposed;  // the same where that one looks the other way
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
    ViewSeams seams = joined();
    seams.turned = turned(seams);
    return seams;
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
    std::map<Index, Index> found, opposite;  // by component its nearest vertex
    for (const Index i : tree.inside({place - reach, place + reach})) {
      const Index other = vertices_[i];
      if (component_[other] == component) continue;
      if (goes_on_at(vertex, other, 1)) keep_nearer(vertex, other, found);
      if (goes_on_at(vertex, other, -1)) keep_nearer(vertex, other, opposite);
    }
    note(vertex, found, sheets_[component].near);
    note(vertex, opposite, sheets_[component].opposed);
    for (const auto& [other, nearest] : found) meetings_.emplace_back(vertex, std::minmax(component, other));
  }

  void keep_nearer(Index vertex, Index other, std::map<Index, Index>& found) const {
    Index& nearest = found.try_emplace(component_[other], other).first->second;
    const Vec3& place = mesh_.positions[vertex];
    if ((mesh_.positions[other] - place).norm() < (mesh_.positions[nearest] - place).norm()) nearest = other;
  }

  void note(Index vertex, const std::map<Index, Index>& found, std::map<Index, Meeting>& meetings) const {
    for (const auto& [other, nearest] : found) {
      Meeting& meeting = meetings[other];
      ++meeting.count;
      meeting.heights += height(vertex, nearest);
    }
  }

  double height(Index vertex, Index other) const {
    return (mesh_.positions[other] - mesh_.positions[vertex]).dot(normals_[vertex]);
  }

  /// @param side 1, or -1 for a surface that looks the other way
  bool goes_on_at(Index vertex, Index other, int side) const {
    const double farther = std::max(std::abs(height(vertex, other)), std::abs(height(other, vertex)));
    return (mesh_.positions[other] - mesh_.positions[vertex]).norm() <= seam_reach * edge_ &&
           farther <= seam_height * edge_ && side * normals_[vertex].dot(normals_[other]) >= agrees;
  }

  std::size_t agreeing(Index a, Index b) { return sheets_[a].near[b].count + sheets_[b].near[a].count; }

  bool is_seam(Index a, Index b, std::size_t count) const {
    const auto shorter = static_cast<double>(std::min(sheets_.at(a).rim, sheets_.at(b).rim));
    return count >= least_seam && static_cast<double>(count) >= least_share * shorter;
  }

  bool are_joined(Index a, Index b) { return is_seam(a, b, agreeing(a, b)); }

  /// Whether more vertices say so than the contrary.
  bool says_opposed(Index a, Index b) {
    return sheets_[a].opposed[b].count + sheets_[b].opposed[a].count > agreeing(a, b);
  }

  /// Whether two components are one surface, whatever side they look to, and how many vertices say so; not where they
  /// seem to be sides of a wall. What is above one of them is below the other one, unless they are opposed.
  std::size_t meeting_of(Index a, Index b, const Meeting& first, const Meeting& second, bool is_opposed) const {
    const std::size_t count = first.count + second.count;
    if (!is_seam(a, b, count)) return 0;
    const auto share = [&](const Meeting& meeting, Index sheet) {
      return static_cast<double>(meeting.count) / static_cast<double>(sheets_.at(sheet).rim);
    };
    const bool along_all = std::min(share(first, a), share(second, b)) > wall_share;
    const double height = std::abs(first.heights + (is_opposed ? 1 : -1) * second.heights) / static_cast<double>(count);
    return height <= (along_all ? same_height : turned_height) * edge_ ? count : 0;
  }

  std::vector<Index> turned(const ViewSeams& seams) {
    std::set<std::pair<Index, Index>> opposed;
    std::vector<std::pair<Index, Index>> meetings;
    for (const auto& [component, sheet] : sheets_)
      for (const auto& [other, meeting] : sheet.opposed) meetings.emplace_back(component, other);
    for (const auto& [component, other] : meetings)
      if (says_opposed(component, other)) opposed.insert(std::minmax(component, other));
    std::vector<ViewPair> pairs;
    const auto add = [&](Index a, Index b, const Meeting& first, const Meeting& second, bool is_opposed) {
      const std::size_t count = meeting_of(a, b, first, second, is_opposed);
      if (count > 0) pairs.push_back({a, b, count, is_opposed});
    };
    for (const auto& [a, b] : opposed) add(a, b, sheets_[a].opposed[b], sheets_[b].opposed[a], true);
    if (pairs.empty()) return {};
    for (const auto& pair : seams.joined) {
      const auto& [a, b] = pair;
      if (!opposed.contains(pair)) add(a, b, sheets_[a].near[b], sheets_[b].near[a], false);
    }
    std::vector<double> areas(view_.component_count, 0);
    for (std::size_t t = 0; t < view_.triangles.size(); ++t) {
      const auto& [a, b, c] = view_.triangles[t];
      const Vec3& at = mesh_.positions[a];
      areas[view_.component[t]] += 0.5 * (mesh_.positions[b] - at).cross(mesh_.positions[c] - at).norm();
    }
    return minority_of(std::move(pairs), areas);
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

// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/sampling/rim_distance.h"

#include <algorithm>
#include <limits>

#include "algorithms/silhouette/sampling/rim_radius.h"

namespace croquis::silhouette {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

double distance_to(const Vec2& place, const Vec2& begin, const Vec2& end) {
  const Vec2 along = end - begin;
  const double fraction = std::clamp((place - begin).dot(along) / along.squaredNorm(), 0.0, 1.0);
  return (begin + fraction * along - place).norm();
}

class RimWalk {
 public:
  RimWalk(const SheetSampling& sheets, double reach) : sheets_(sheets), reach_(reach) {
    const LiftedTriangulation& lifted = sheets.lifted;
    result_.nearest.assign(lifted.planar_vertex.size(), no_index);
    result_.distance.assign(lifted.planar_vertex.size(), infinite);
    leaving_.assign(lifted.planar_vertex.size(), no_index);
    entering_.assign(lifted.planar_vertex.size(), no_index);
    for (Index t = 0; t < lifted.triangles.size(); ++t) {
      for (std::size_t corner = 0; corner < 3; ++corner) {
        if (lifted.neighbours[t][corner] == no_index) add_edge(t, corner);
      }
    }
  }

  /// Each round reaches at least one ring of vertices further in, until no neighbour knows a nearer edge.
  RimDistances run() {
    for (bool changed = true; changed;) {
      changed = false;
      for (const std::array<Index, 3>& corners : sheets_.lifted.triangles) {
        for (const Index from : corners) changed = offer_around(corners, from) || changed;
      }
    }
    return std::move(result_);
  }

 private:
  const Vec2& place(Index vertex) const { return sheets_.points[sheets_.lifted.planar_vertex[vertex]]; }

  void add_edge(Index triangle, std::size_t corner) {
    const std::array<Index, 3>& corners = sheets_.lifted.triangles[triangle];
    const Index piece = sheets_.planar.constraints[sheets_.lifted.planar_triangle[triangle]][corner];
    const auto edge = static_cast<Index>(result_.edges.size());
    const double radius = sheets_.row_radii[piece];
    result_.edges.push_back(
        {corners[(corner + 1) % 3], corners[(corner + 2) % 3], radius, first_row_depth(radius, sheets_.step)});
    leaving_[result_.edges[edge].begin] = edge;
    entering_[result_.edges[edge].end] = edge;
    for (const Index vertex : {result_.edges[edge].begin, result_.edges[edge].end}) {
      result_.nearest[vertex] = edge;
      result_.distance[vertex] = 0;
    }
  }

  bool offer_around(const std::array<Index, 3>& corners, Index from) {
    const Index edge = result_.nearest[from];
    if (edge == no_index) return false;
    bool taken = false;
    for (const Index to : corners) {
      if (!sheets_.lifted.on_boundary[to] && result_.nearest[to] != edge) taken = offer(to, edge) || taken;
    }
    return taken;
  }

  bool offer(Index vertex, Index edge) {
    const Index around[] = {edge, entering_[result_.edges[edge].begin], leaving_[result_.edges[edge].end]};
    bool taken = false;
    for (const Index candidate : around) {
      const RimEdge& rim = result_.edges[candidate];
      const double distance = distance_to(place(vertex), place(rim.begin), place(rim.end));
      if (distance >= result_.distance[vertex] || distance > reach_ * rim.radius) continue;
      result_.distance[vertex] = distance;
      result_.nearest[vertex] = candidate;
      taken = true;
    }
    return taken;
  }

  const SheetSampling& sheets_;
  double reach_;
  RimDistances result_;
  std::vector<Index> leaving_, entering_;  ///< per lifted vertex, its edges of the boundary
};

}  // namespace

RimDistances rim_distances(const SheetSampling& sheets, double reach) { return RimWalk(sheets, reach).run(); }

double depth_below(const SheetSampling& sheets, const RimEdge& edge, Index vertex) {
  const auto place = [&](Index v) { return sheets.points[sheets.lifted.planar_vertex[v]]; };
  const Vec2 inward = left_of((place(edge.end) - place(edge.begin)).normalized());
  return (place(vertex) - place(edge.begin)).dot(inward);
}

}  // namespace croquis::silhouette

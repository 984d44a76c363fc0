// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/hole_filling/surface_reach.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <Eigen/Geometry>

#include "algorithms/hole_filling/continuation/crease_angle.h"
#include "algorithms/hole_filling/continuation/vertex_numbers.h"

namespace croquis::hole_filling {
namespace {

/// Dijkstra over the edges of the view.
class Reach {
 public:
  Reach(const HoleSite& site, double reach)
      : view_(site.analysis->view),
        positions_(site.mesh->positions),
        reach_(reach),
        crease_cosine_(crease_cosine(site)) {
    const std::map<Index, Index> ranks = ranks_of(site);
    for (const Index id : site.holes) {
      for (const Index start : site.analysis->holes[id].corners) {
        for (const Index corner : {start, SurfaceView::next(start)}) {
          const auto rank = ranks.find(view_.origin(corner));
          offer(corner, 0, rank == ranks.end() ? no_index : rank->second);
        }
      }
    }
  }

  std::vector<ReachedVertex> run() {
    std::vector<ReachedVertex> reached;
    while (!queue_.empty()) {
      const Entry entry = queue_.front();
      std::pop_heap(queue_.begin(), queue_.end(), is_later_);
      queue_.pop_back();
      double& known = distances_[numbers_.known_number(entry.vertex)];
      if (entry.distance > known) continue;
      known = -1;  // done: nothing is nearer
      look_around(entry.corner);
      reached.push_back({entry.vertex, entry.distance, normal(), entry.corner, is_on_crease()});
      for (const Spoke& spoke : fan_) {
        offer(spoke.out, entry.distance + spoke.out_length);
        offer(spoke.in, entry.distance + spoke.in_length);
      }
    }
    return reached;
  }

 private:
  struct Entry {
    double distance;
    Index vertex;
    Index corner;  ///< one at the vertex
    Index rank;    ///< of rim vertices, along the rims; no_index beside them
  };

  static std::map<Index, Index> ranks_of(const HoleSite& site) {
    std::map<Index, Index> ranks;
    for (Index i = 0; i < site.vertices.size(); ++i)
      ranks.try_emplace(site.analysis->view.representative_of(site.vertices[i]), i);
    return ranks;
  }

  /// A triangle of the fan around a vertex, with the corners at its other vertices.
  struct Spoke {
    Index triangle;
    Index out, in;
    double out_length, in_length;
    Vec3 across;   ///< its normal, as long as twice its area
    double angle;  ///< at the vertex
  };

  /// Rim vertices come in the order of the rims, so that neither the numbers of vertices matter nor how the mesh lies
  /// in space. Of other places equally far the one with the least coordinates comes first.
  struct IsLater {
    const std::vector<Vec3>& positions;

    bool operator()(const Entry& a, const Entry& b) const {
      if (a.distance != b.distance) return a.distance > b.distance;
      if (a.rank != b.rank) return a.rank > b.rank;
      const Vec3 &p = positions[a.vertex], &q = positions[b.vertex];
      for (int axis = 0; axis < 3; ++axis) {
        if (p[axis] != q[axis]) return p[axis] > q[axis];
      }
      return a.vertex != b.vertex ? a.vertex > b.vertex : a.corner > b.corner;
    }
  };

  void offer(Index corner, double distance, Index rank = no_index) {
    if (!(distance <= reach_)) return;
    const Index vertex = view_.origin(corner);
    const auto [number, is_new] = numbers_.number(vertex);
    if (is_new) {
      distances_.push_back(distance);
    } else if (distance < distances_[number]) {
      distances_[number] = distance;
    } else {
      return;
    }
    queue_.push_back({distance, vertex, corner, rank});
    std::push_heap(queue_.begin(), queue_.end(), is_later_);
  }

  /// Takes the fan around a corner's vertex, by the numbers of its triangles.
  void look_around(Index corner) {
    triangles_.assign(1, corner / 3);
    add_fan(view_, corner, triangles_);
    std::sort(triangles_.begin(), triangles_.end());
    triangles_.erase(std::unique(triangles_.begin(), triangles_.end()), triangles_.end());
    const Index vertex = view_.origin(corner);
    const Vec3& place = positions_[vertex];
    fan_.clear();
    for (const Index triangle : triangles_) {
      Index here = 3 * triangle;
      while (view_.origin(here) != vertex) ++here;
      Spoke spoke{triangle, SurfaceView::next(here), SurfaceView::previous(here), 0, 0, {}, 0};
      const Vec3 out = positions_[view_.origin(spoke.out)] - place, in = positions_[view_.origin(spoke.in)] - place;
      spoke.out_length = out.norm();
      spoke.in_length = in.norm();
      spoke.across = out.cross(in);
      spoke.angle = std::atan2(spoke.across.norm(), out.dot(in));
      fan_.push_back(spoke);
    }
  }

  Vec3 normal() const {
    Vec3 sum = Vec3::Zero();
    for (const Spoke& spoke : fan_) {
      if ((view_.flags[spoke.triangle] & (SurfaceView::NoArea | SurfaceView::Sliver)) != 0) continue;
      const double length = spoke.across.norm();
      if (length > 0) sum += spoke.angle / length * spoke.across;
    }
    const double length = sum.norm();
    return length > 0 ? Vec3(sum / length) : Vec3(Vec3::Zero());
  }

  /// Any two triangles that share an edge of the fan are compared.
  bool is_on_crease() const {
    for (const Spoke& spoke : fan_) {
      const Index edge = SurfaceView::previous(spoke.out);
      if (!view_.has_opposite(edge)) continue;
      const Index beyond = view_.opposite[edge] / 3;
      const auto other = std::find_if(fan_.begin(), fan_.end(), [&](const Spoke& s) { return s.triangle == beyond; });
      if (other != fan_.end() && !is_smooth(spoke.across, other->across, crease_cosine_)) return true;
    }
    return false;
  }

  const SurfaceView& view_;
  const std::vector<Vec3>& positions_;
  double reach_, crease_cosine_;
  VertexNumbers numbers_;
  std::vector<double> distances_;  ///< per number, the least so far; -1 once it is final
  std::vector<Entry> queue_;       ///< a heap, the nearest first
  const IsLater is_later_{positions_};
  std::vector<Index> triangles_;
  std::vector<Spoke> fan_;
};

}  // namespace

std::vector<ReachedVertex> reach_from_rims(const HoleSite& site, double reach) { return Reach(site, reach).run(); }

}  // namespace croquis::hole_filling

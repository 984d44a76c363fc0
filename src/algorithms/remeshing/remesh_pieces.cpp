// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/remeshing/remesh_pieces.h"

#include <algorithm>
#include <utility>

#include <Eigen/Geometry>

#include "croquis/geometry/disjoint_sets.h"
#include "croquis/hole_filling/fill_jobs.h"

namespace croquis::remeshing {
namespace {

using namespace hole_filling;

class PieceMaker {
 public:
  PieceMaker(const PolyMesh& mesh, const HoleAnalysis& analysis, const HoleChoice& choice, const ViewSeams& seams,
             const RemeshOptions& options)
      : mesh_(mesh),
        view_(analysis.view),
        holes_(analysis.holes),
        choice_(choice),
        seams_(seams),
        options_(options),
        joined_(view_.component_count) {}

  RemeshPieces run() {
    join_at_vertices();
    for (const auto& [a, b] : seams_.joined) joined_.unite(a, b);
    join_at_holes();
    number_pieces();
    list_seams();
    list_vertices();
    list_rims();
    return std::move(result_);
  }

 private:
  /// Components that share a vertex.
  void join_at_vertices() {
    component_at_.assign(mesh_.vertex_count(), no_index);
    for (std::size_t t = 0; t < view_.triangles.size(); ++t) {
      for (const Index vertex : view_.triangles[t]) {
        Index& component = component_at_[vertex];
        if (component == no_index) component = view_.component[t];
        if (component != view_.component[t]) joined_.unite(component, view_.component[t]);
      }
    }
    for (Index c = 1; options_.fill.preset == Preset::Paper && c < view_.component_count; ++c) joined_.unite(0, c);
  }

  Index component_of_rim(const Hole& hole) const { return view_.component[hole.corners.front() / 3]; }

  void join_at_holes() {
    fates_.assign(holes_.size(), RimFate::Open);
    jobs_ = make_jobs(holes_, options_.fill, choice_.is_chosen);
    for (FillJob& job : jobs_) {
      std::erase_if(job.holes, [&](Index hole) { return seams_.are_along(hole); });
      job.is_cap = job.is_cap && options_.fill.preset != Preset::Paper;
      for (const Index hole : job.holes) {
        fates_[hole] = job.is_cap ? RimFate::Patch : RimFate::Field;
        for (const Index corner : holes_[hole].corners)
          joined_.unite(component_of_rim(holes_[job.holes.front()]), view_.component[corner / 3]);
      }
    }
  }

  void list_seams() {
    std::vector<std::uint8_t> is_view(view_.component_count, 0);
    for (const auto& [a, b] : seams_.joined) is_view[a] = is_view[b] = 1;
    std::vector<std::uint8_t> is_island(view_.component_count, 1);
    for (const Hole& hole : holes_)
      if (hole.kind != HoleClass::Islands) is_island[component_of_rim(hole)] = 0;
    for (Index c = 0; c < view_.component_count; ++c) {
      if (is_view[c] == 0 || piece_of_[c] == no_index) continue;
      ++result_.pieces[piece_of_[c]].views;
      result_.pieces[piece_of_[c]].islands += is_island[c];
    }
    for (const Hole& hole : holes_) {
      if (!choice_.is_chosen[hole.id] || !seams_.are_along(hole.id)) continue;
      fates_[hole.id] = RimFate::Seam;
      const Index piece = piece_of_[component_of_rim(hole)];
      if (piece != no_index) result_.pieces[piece].seams.push_back(hole.id);
    }
  }

  void number_pieces() {
    std::vector<std::size_t> triangles(view_.component_count, 0);
    for (const Index component : view_.component) ++triangles[joined_.root(component)];
    const double least = options_.min_component * static_cast<double>(view_.triangles.size());
    piece_of_.assign(view_.component_count, no_index);
    for (Index c = 0; c < view_.component_count; ++c) {
      const Index root = joined_.root(c);
      const bool is_large = static_cast<double>(triangles[root]) >= least;
      if (!is_large) ++result_.left_out;
      if (root == c && is_large) {
        piece_of_[c] = static_cast<Index>(result_.pieces.size());
        result_.pieces.emplace_back().triangles.reserve(triangles[c]);
      }
      piece_of_[c] = piece_of_[root];
    }
    for (Index t = 0; t < view_.triangles.size(); ++t) {
      const Index piece = piece_of_[view_.component[t]];
      if (piece != no_index) result_.pieces[piece].triangles.push_back(t);
    }
    for (FillJob& job : jobs_) {
      if (job.holes.empty()) continue;
      const Index number = piece_of_[component_of_rim(holes_[job.holes.front()])];
      if (number == no_index) continue;
      RemeshPiece& piece = result_.pieces[number];
      if (job.is_cap)
        piece.caps.insert(piece.caps.end(), job.holes.begin(), job.holes.end());
      else
        piece.groups.push_back(std::move(job.holes));
    }
    for (RemeshPiece& piece : result_.pieces) std::sort(piece.caps.begin(), piece.caps.end());
  }

  void list_vertices() {
    std::vector<std::size_t> counts(result_.pieces.size(), 0);
    const auto piece_at = [&](std::size_t v) {
      return component_at_[v] == no_index ? no_index : piece_of_[component_at_[v]];
    };
    for (std::size_t v = 0; v < component_at_.size(); ++v)
      if (piece_at(v) != no_index) ++counts[piece_at(v)];
    for (std::size_t p = 0; p < counts.size(); ++p) result_.pieces[p].vertices.reserve(counts[p]);
    for (std::size_t v = 0; v < component_at_.size(); ++v)
      if (piece_at(v) != no_index) result_.pieces[piece_at(v)].vertices.push_back(static_cast<Index>(v));
  }

  void list_rims() {
    std::vector<std::pair<Index, Index>> holes_of_corners;
    for (const Hole& hole : holes_) {
      for (const Index corner : hole.corners) holes_of_corners.emplace_back(corner, hole.id);
    }
    std::sort(holes_of_corners.begin(), holes_of_corners.end());
    for (const Index corner : view_.rim_corners) {
      const auto found = std::ranges::lower_bound(holes_of_corners, std::pair{corner, Index{0}});
      const bool is_hole = found != holes_of_corners.end() && found->first == corner;
      const RimFate fate_of_rim = is_hole ? fates_[found->second] : RimFate::Patch;
      const bool is_view_rim = !is_hole || seams_.are_along(found->second);
      const Index piece = piece_of_[view_.component[corner / 3]];
      if (fate_of_rim != RimFate::Field && piece != no_index) result_.pieces[piece].ends = true;
      for (const Index vertex : {view_.origin(corner), view_.target(corner)}) {
        const bool is_seam = is_view_rim && seams_.at(vertex);
        const RimFate fate = is_seam ? RimFate::Seam : fate_of_rim;
        result_.rims.push_back(
            {vertex, is_hole && fate_of_rim != RimFate::Open ? found->second : no_index, fate, outwards(corner)});
      }
    }
    merge_rims();
  }

  /// Sum of both edges at a vertex; the strongest fate holds.
  void merge_rims() {
    std::vector<RimPlace>& rims = result_.rims;
    std::stable_sort(rims.begin(), rims.end(), [](const auto& a, const auto& b) { return a.vertex < b.vertex; });
    std::size_t kept = 0;
    for (std::size_t i = 0; i < rims.size(); ++i) {
      if (kept > 0 && rims[kept - 1].vertex == rims[i].vertex) {
        rims[kept - 1].outwards += rims[i].outwards;
        if (std::pair(rims[i].fate, rims[i].hole) > std::pair(rims[kept - 1].fate, rims[kept - 1].hole)) {
          rims[kept - 1].fate = rims[i].fate;
          rims[kept - 1].hole = rims[i].hole;
        }
      } else {
        rims[kept++] = rims[i];
      }
    }
    rims.resize(kept);
    for (RimPlace& rim : rims) {
      const double length = rim.outwards.norm();
      if (length > 0) rim.outwards /= length;
    }
  }

  /// In the plane of the triangle, across its rim edge, as long as that edge.
  Vec3 outwards(Index corner) const {
    const Vec3& a = mesh_.positions[view_.origin(corner)];
    const Vec3 along = mesh_.positions[view_.target(corner)] - a;
    const Vec3 normal = along.cross(mesh_.positions[view_.origin(SurfaceView::previous(corner))] - a);
    const double area = normal.norm();
    return area > 0 ? Vec3(along.cross(normal) / area) : Vec3(Vec3::Zero());
  }

  const PolyMesh& mesh_;
  const SurfaceView& view_;
  const std::vector<Hole>& holes_;
  const HoleChoice& choice_;
  const ViewSeams& seams_;
  const RemeshOptions& options_;
  DisjointSets joined_;
  std::vector<Index> component_at_;  // of a vertex, no_index where it isn't used
  std::vector<Index> piece_of_;      // of a component
  std::vector<FillJob> jobs_;
  std::vector<RimFate> fates_;  // of a hole
  RemeshPieces result_;
};

}  // namespace

RemeshPieces make_pieces(const PolyMesh& mesh, const HoleAnalysis& analysis, const HoleChoice& choice,
                         const ViewSeams& seams, const RemeshOptions& options) {
  return PieceMaker(mesh, analysis, choice, seams, options).run();
}

void leave_to_patches(RemeshPieces& pieces, std::size_t piece,
                      const std::function<bool(const std::vector<Index>&)>& is_left) {
  RemeshPiece& changed = pieces.pieces[piece];
  std::vector<Index> left;
  for (const std::vector<Index>& group : changed.groups)
    if (is_left(group)) left.insert(left.end(), group.begin(), group.end());
  if (left.empty()) return;
  std::erase_if(changed.groups, is_left);
  std::ranges::sort(left);
  changed.caps.insert(changed.caps.end(), left.begin(), left.end());
  std::ranges::sort(changed.caps);
  changed.ends = true;
  for (RimPlace& rim : pieces.rims) {
    if (rim.hole != no_index && std::ranges::binary_search(left, rim.hole)) rim.fate = RimFate::Left;
  }
}

}  // namespace croquis::remeshing

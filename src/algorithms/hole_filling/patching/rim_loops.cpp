// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/hole_filling/patching/rim_loops.h"

#include <algorithm>
#include <map>
#include <utility>

#include "algorithms/hole_filling/patching/open_sheet.h"
#include "croquis/hole_filling/rim_triangulation.h"
#include "croquis/implicit/point_tree.h"

namespace croquis::hole_filling {
namespace {

constexpr double farthest_rim = 3;  // × cell, of a border vertex that votes

/// All rims that might be met.
struct RimPoints {
  std::vector<Vec3> places;
  std::vector<Index> holes;  ///< per place
};

RimPoints rims_near(const HoleSite& site, const PolyMesh& sheet, double margin) {
  implicit::Box box = implicit::bounds(sheet.positions);
  box.low -= Vec3::Constant(margin);
  box.high += Vec3::Constant(margin);
  RimPoints rims;
  for (const Hole& hole : site.analysis->holes) {
    for (const Index v : hole.vertices) {
      if (!box.contains(site.mesh->positions[v])) continue;
      rims.places.push_back(site.mesh->positions[v]);
      rims.holes.push_back(hole.id);
    }
  }
  return rims;
}

class LoopMatching {
 public:
  LoopMatching(const HoleSite& site, PolyMesh sheet, double cell)
      : site_(site),
        sheet_(std::move(sheet)),
        reach_(farthest_rim * cell),
        rims_(rims_near(site, sheet_, reach_)),
        tree_(rims_.places) {}

  std::optional<MatchedSheet> run(Progress& progress) {
    if (!keep_one_component()) return std::nullopt;
    MatchedSheet matched;
    matched.arrives_at = strangers();
    if (!matched.arrives_at.empty()) return matched;
    for (const Index id : rims_of_polygon()) {
      const std::size_t loop = longest_at(id);
      if (loop == loops_.size()) return std::nullopt;
      matched.loops.push_back(loops_[loop].vertices);
      is_taken_[loop] = true;
    }
    for (std::size_t i = 0; i < loops_.size(); ++i) {
      if (!is_taken_[i] && !close(loops_[i].vertices, progress)) return std::nullopt;
    }
    matched.sheet = std::move(sheet_);
    return matched;
  }

 private:
  void find_loops() {
    loops_ = border_loops(sheet_);
    holes_.clear();
    for (const BorderLoop& loop : loops_) holes_.push_back(vote(loop));
    is_taken_.assign(loops_.size(), false);
  }

  /// The hole that a loop ends at, or no_index.
  Index vote(const BorderLoop& loop) const {
    std::map<Index, std::size_t> votes;
    for (const Index v : loop.vertices) {
      const Index nearest = tree_.nearest(sheet_.positions[v]);
      if (nearest == no_index || (rims_.places[nearest] - sheet_.positions[v]).norm() > reach_)
        ++votes[no_index];
      else
        ++votes[rims_.holes[nearest]];
    }
    const auto most =
        std::max_element(votes.begin(), votes.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
    return most->first;
  }

  /// The piece with the longest border at one of the site's rims.
  bool keep_one_component() {
    find_loops();
    std::size_t best = loops_.size();
    for (std::size_t i = 0; i < loops_.size(); ++i) {
      if (!is_own(holes_[i])) continue;
      if (best == loops_.size() || loops_[i].vertices.size() > loops_[best].vertices.size()) best = i;
    }
    if (best == loops_.size()) return false;
    std::vector<bool> wanted(sheet_.face_count(), false);  // there are no more components than faces
    wanted[loops_[best].component] = true;
    sheet_ = components_of(sheet_, wanted);
    find_loops();
    return true;
  }

  bool is_own(Index hole) const { return std::binary_search(site_.holes.begin(), site_.holes.end(), hole); }

  std::vector<Index> strangers() const {
    std::vector<Index> found;
    for (const Index hole : holes_) {
      if (hole != no_index && !is_own(hole)) found.push_back(hole);
    }
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
  }

  /// In the order in which the site's polygon has them.
  std::vector<Index> rims_of_polygon() const {
    std::vector<Index> order = site_.holes;
    const auto& holes = site_.analysis->holes;
    std::stable_sort(order.begin(), order.end(),
                     [&](Index a, Index b) { return holes[a].diameter > holes[b].diameter; });
    return order;
  }

  std::size_t longest_at(Index hole) const {
    std::size_t best = loops_.size();
    for (std::size_t i = 0; i < loops_.size(); ++i) {
      if (holes_[i] != hole) continue;
      if (best == loops_.size() || loops_[i].vertices.size() > loops_[best].vertices.size()) best = i;
    }
    return best;
  }

  /// A hole of the sheet itself.
  bool close(const std::vector<Index>& loop, Progress& progress) {
    RimPolygon polygon;
    const std::vector<Index> order(loop.rbegin(), loop.rend());
    for (const Index v : order) polygon.points.push_back(sheet_.positions[v]);
    polygon.loop_ends = {static_cast<Index>(order.size())};
    const auto found = triangulate_rim(polygon, progress);
    if (!found) return false;
    for (const auto& [a, b, c] : found->triangles) sheet_.add_triangle(order[a], order[b], order[c]);
    return true;
  }

  const HoleSite& site_;
  PolyMesh sheet_;
  double reach_;
  RimPoints rims_;
  implicit::PointTree tree_;
  std::vector<BorderLoop> loops_;
  std::vector<Index> holes_;  ///< per loop
  std::vector<bool> is_taken_;
};

}  // namespace

std::optional<MatchedSheet> match_loops(const HoleSite& site, PolyMesh sheet, double cell, Progress& progress) {
  if (sheet.face_count() == 0) return std::nullopt;
  return LoopMatching(site, std::move(sheet), cell).run(progress);
}

}  // namespace croquis::hole_filling

// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/hole_filling/patching/untangling.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>

#include "algorithms/hole_filling/patching/near_scene.h"
#include "algorithms/hole_filling/triangulation/triangle_cost.h"

namespace croquis::hole_filling {
namespace {

constexpr int most_trials = 300;

/// More pairs than this aren't a few triangles at a rough rim.
constexpr std::size_t most_clashes = 60;

class Untangling {
 public:
  Untangling(const HoleSite& site, HolePatch& patch, Progress& progress)
      : site_(site), patch_(patch), progress_(progress), scene_(site, reach()) {}

  bool run() {
    std::vector<Clash> clashes = find();
    while (!clashes.empty() && clashes.size() <= most_clashes && improve(clashes)) {
    }
    return clashes.empty();
  }

 private:
  const Vec3& point(Index vertex) const {
    const auto given = static_cast<Index>(site_.mesh->vertex_count());
    return vertex < given ? site_.mesh->positions[vertex] : patch_.points[vertex - given];
  }

  Eigen::AlignedBox3d reach() const {
    Eigen::AlignedBox3d box;
    for (const auto& t : patch_.triangles) {
      for (const Index vertex : t) box.extend(point(vertex));
    }
    return box;
  }

  std::vector<Clash> find() { return scene_.clashes(patch_.points, patch_.triangles, progress_); }

  /// The first flip of an edge of a clashing triangle that leaves fewer clashes. @return whether there is one
  bool improve(std::vector<Clash>& clashes) {
    for (const Clash& clash : clashes) {
      for (const Index triangle : {clash.triangle, clash.other}) {
        for (std::size_t side = 0; side < 3 && triangle != no_index; ++side) {
          if (++trials_ > most_trials) return false;
          const auto before = patch_.triangles;
          if (!flip(triangle, side)) continue;
          std::vector<Clash> after = find();
          if (after.size() < clashes.size()) {
            clashes = std::move(after);
            return true;
          }
          patch_.triangles = before;
        }
      }
    }
    return false;
  }

  bool flip(Index triangle, std::size_t side) {
    auto& t = patch_.triangles[triangle];
    const Index a = t[side], b = t[(side + 1) % 3], c = t[(side + 2) % 3];
    for (auto& u : patch_.triangles) {
      for (std::size_t i = 0; i < 3; ++i) {
        if (u[i] != b || u[(i + 1) % 3] != a) continue;
        const Index d = u[(i + 2) % 3];
        if (c == d || are_joined(c, d) || !has_area(a, d, c) || !has_area(b, c, d)) return false;
        t = {a, d, c};
        u = {b, c, d};
        return true;
      }
    }
    return false;  // on the rim
  }

  bool has_area(Index a, Index b, Index c) const { return std::isfinite(triangle_cost(point(a), point(b), point(c))); }

  bool are_joined(Index c, Index d) const {
    const auto has = [](const auto& t, Index v) { return std::find(t.begin(), t.end(), v) != t.end(); };
    return std::any_of(patch_.triangles.begin(), patch_.triangles.end(),
                       [&](const auto& t) { return has(t, c) && has(t, d); });
  }

  const HoleSite& site_;
  HolePatch& patch_;
  Progress& progress_;
  NearScene scene_;
  int trials_ = 0;
};

}  // namespace

bool untangle(const HoleSite& site, HolePatch& patch, Progress& progress) {
  return Untangling(site, patch, progress).run();
}

}  // namespace croquis::hole_filling

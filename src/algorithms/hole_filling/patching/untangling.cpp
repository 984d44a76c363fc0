// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/hole_filling/patching/untangling.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
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
          const auto other = flip(triangle, side);
          if (!other) continue;
          const std::array flipped = {triangle, *other};
          if (scene_.count_clashes_of(flipped, patch_.points, patch_.triangles, progress_) <
              count_of(clashes, flipped)) {
            clashes = find();
            return true;
          }
          patch_.triangles = before;
        }
      }
    }
    return false;
  }

  /// Of clashes with one of two triangles.
  static std::size_t count_of(const std::vector<Clash>& clashes, const std::array<Index, 2>& triangles) {
    return static_cast<std::size_t>(std::ranges::count_if(clashes, [&](const Clash& clash) {
      return std::ranges::find(triangles, clash.triangle) != triangles.end() ||
             std::ranges::find(triangles, clash.other) != triangles.end();
    }));
  }

  /// @return the triangle on the other side of the edge, which is flipped as well; nothing where it can't be
  std::optional<Index> flip(Index triangle, std::size_t side) {
    auto& t = patch_.triangles[triangle];
    const Index a = t[side], b = t[(side + 1) % 3], c = t[(side + 2) % 3];
    for (Index other = 0; other < patch_.triangles.size(); ++other) {
      auto& u = patch_.triangles[other];
      for (std::size_t i = 0; i < 3; ++i) {
        if (u[i] != b || u[(i + 1) % 3] != a) continue;
        const Index d = u[(i + 2) % 3];
        if (c == d || are_joined(c, d) || !has_area(a, d, c) || !has_area(b, c, d)) return std::nullopt;
        t = {a, d, c};
        u = {b, c, d};
        return other;
      }
    }
    return std::nullopt;  // on the rim
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

// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/remeshing/simplification/surface_deviation.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "croquis/base/parallel.h"

namespace croquis::remeshing {
namespace {

using Corners = std::array<Vec3, 3>;

constexpr std::size_t triangles_per_part = 256;
constexpr double least_part = 0.02;       // × distance: what is cut no further
constexpr double on_plane = 1e-6;         // × distance: corners so near to a plane lie on it
constexpr std::size_t most_corners = 12;  // of a convex part: those with more are halved first

/// A convex polygon. Parts that have been cut off have one corner more at most.
struct ConvexPart {
  std::array<Vec3, most_corners + 4> corners;
  std::size_t count = 0;

  std::span<const Vec3> all() const { return {corners.data(), count}; }
  void add(const Vec3& corner) { corners[count++] = corner; }

  Vec3 middle() const {
    Vec3 sum = Vec3::Zero();
    for (const Vec3& p : all()) sum += p;
    return sum / static_cast<double>(count);
  }
};

/// What of a part lies on the positive side of a plane, and what on the other one.
/// @param unit its normal @param slack what is no farther from it counts as on it
std::array<ConvexPart, 2> sides_of(const ConvexPart& part, const Vec3& origin, const Vec3& unit, double slack) {
  std::array<ConvexPart, 2> sides;
  const auto height = [&](const Vec3& p) {
    const double here = unit.dot(p - origin);
    return std::abs(here) <= slack ? 0.0 : here;
  };
  Vec3 last = part.corners[part.count - 1];
  double before = height(last);
  bool is_above = false, is_below = false;
  for (const Vec3& p : part.all()) {
    const double here = height(p);
    if (here * before < 0) {
      const Vec3 crossing = last + before / (before - here) * (p - last);
      for (ConvexPart& side : sides) side.add(crossing);
    }
    if (here >= 0) sides[0].add(p);
    if (here <= 0) sides[1].add(p);
    is_above = is_above || here > 0;
    is_below = is_below || here < 0;
    before = here;
    last = p;
  }
  if (!is_above) sides[0].count = 0;
  if (!is_below) sides[1].count = 0;
  return sides;
}

/// That a triangle lies within a distance of a surface.
class Proof {
 public:
  Proof(const TriangleTree& surface, double distance) : surface_(surface), distance_(distance) {}

  bool holds(const Corners& triangle, Index guess) {
    ConvexPart whole;
    for (const Vec3& corner : triangle) whole.add(corner);
    if (guess != no_index && is_near(whole, surface_.triangle(guess))) return true;
    open_ = {whole};
    while (!open_.empty()) {
      const ConvexPart part = open_.back();
      open_.pop_back();
      if (!look_at(part)) return false;
    }
    return true;
  }

 private:
  /// False when a part can't be proven; else what of it is still open has been put there.
  bool look_at(const ConvexPart& part) {
    const Vec3 middle = part.middle();
    const TriangleFoot foot = surface_.nearest(middle, distance_);
    if (foot.triangle == no_index) return false;
    const Corners& near = surface_.triangle(foot.triangle);
    if (is_near(part, near)) return true;
    double radius = 0;
    for (const Vec3& p : part.all()) radius = std::max(radius, (p - middle).norm());
    if (foot.distance + radius <= distance_) return true;
    if (radius < least_part * distance_) return false;
    if (part.count > most_corners || !cut_along(part, near)) halve(part);
    return true;
  }

  bool is_near(const ConvexPart& part, const Corners& near) const {
    return std::ranges::all_of(part.all(),
                               [&](const Vec3& p) { return foot_on_triangle(near, p).distance <= distance_; });
  }

  /// Cuts along the upright planes through a triangle's edges. @return false when none of them meets the part
  bool cut_along(const ConvexPart& part, const Corners& near) {
    const Vec3 normal = (near[1] - near[0]).cross(near[2] - near[0]);
    ConvexPart over = part;
    bool is_cut = false;
    for (std::size_t e = 0; e < 3; ++e) {
      const Vec3 outwards = (near[(e + 1) % 3] - near[e]).cross(normal);
      if (!(outwards.norm() > 0)) continue;
      const auto [beyond, rest] = sides_of(over, near[e], outwards.normalized(), on_plane * distance_);
      if (beyond.count == 0 || rest.count == 0) continue;
      open_.push_back(beyond);
      over = rest;
      is_cut = true;
    }
    if (is_cut && !is_near(over, near)) open_.push_back(over);
    return is_cut;
  }

  void halve(const ConvexPart& part) {
    std::size_t a = 0, b = 0;
    const auto between = [&](std::size_t i, std::size_t j) { return Vec3(part.corners[i] - part.corners[j]); };
    for (std::size_t i = 0; i < part.count; ++i)
      for (std::size_t j = 0; j < i; ++j)
        if (between(i, j).squaredNorm() > between(a, b).squaredNorm()) a = i, b = j;
    const Vec3 middle = 0.5 * (part.corners[a] + part.corners[b]);
    for (const ConvexPart& half : sides_of(part, middle, between(a, b).normalized(), 0)) open_.push_back(half);
  }

  const TriangleTree& surface_;
  double distance_;
  std::vector<ConvexPart> open_;
};

}  // namespace

std::vector<Index> faces_beyond(std::span<const Corners> triangles, std::span<const Index> guesses,
                                const TriangleTree& surface, double distance, int threads, Progress& progress) {
  std::vector<std::uint8_t> is_beyond(triangles.size());
  for_each_part(triangles.size(), triangles_per_part, threads, progress, [&](std::size_t begin, std::size_t end) {
    Proof proof(surface, distance);
    for (std::size_t t = begin; t < end; ++t)
      is_beyond[t] = proof.holds(triangles[t], guesses.empty() ? no_index : guesses[t]) ? 0 : 1;
  });
  std::vector<Index> beyond;
  for (Index t = 0; t < is_beyond.size(); ++t)
    if (is_beyond[t] != 0) beyond.push_back(t);
  return beyond;
}

}  // namespace croquis::remeshing

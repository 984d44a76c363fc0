// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/perspective/patches/face_sides.h"

#include <algorithm>
#include <cstddef>

#include <Eigen/Geometry>

namespace croquis {
namespace {

Vec3 middle_direction(const std::array<Vec3, 4>& p) { return (p[3] + p[2] - p[1] - p[0]).normalized(); }

class SideMaker {
 public:
  SideMaker(const Brep& brep, const BrepFace& face) : brep_(brep), face_(face) {}

  FaceSide make_side(Index half, Index before, Index after) const {
    const std::vector<std::array<Vec3, 4>> parts = cubics(half);
    FaceSide side;
    side.whole = parts.size() == 1;
    side.full = parts[0];
    if (side.whole) {
      const auto [first, second] = RationalCubic{parts[0]}.split(0.5);
      side.first.points = first.points;
      side.second.points = second.points;
    } else {
      side.first.points = parts[0];
      side.second.points = parts[1];
    }
    side.middle = side.first.points[3];
    side.tangent = side.whole ? middle_direction(parts[0]) : Vec3((parts[0][3] - parts[0][2]).normalized());
    set_across(half, side);
    set_inwards(leg_from_end(before), leg_from_start(after), side);
    return side;
  }

 private:
  Vec3 leg_from_start(Index half) const { return cubics(half).front()[1] - cubics(half).front()[0]; }
  Vec3 leg_from_end(Index half) const { return cubics(half).back()[2] - cubics(half).back()[3]; }

  /// The fitted cubics of an edge in the direction of the half-edge.
  std::vector<std::array<Vec3, 4>> cubics(Index half) const {
    const BrepHalfEdge& h = brep_.half_edges[half];
    std::vector<std::array<Vec3, 4>> result;
    for (const RationalCubic& cubic : brep_.edges[h.edge].fitted) {
      result.push_back(h.reversed ? cubic.reversed().points : cubic.points);
    }
    if (h.reversed) std::ranges::reverse(result);
    return result;
  }

  void set_across(Index half, FaceSide& side) const {
    const BrepHalfEdge& h = brep_.half_edges[half];
    const BrepEdge& edge = brep_.edges[h.edge];
    side.first.common = side.second.common = edge.smooth;
    if (!edge.smooth) return;
    const Vec3 start = h.reversed ? Vec3(-edge.across[1]) : edge.across[0];
    const Vec3 end = h.reversed ? Vec3(-edge.across[0]) : edge.across[1];
    side.first.across = {start, (start + end) / 2};
    side.second.across = {(start + end) / 2, end};
  }

  /// Half way between the slopes at the ends, in the common tangent plane if there is one.
  void set_inwards(const Vec3& first_leg, const Vec3& last_leg, FaceSide& side) const {
    Vec3 direction = first_leg + last_leg;
    if (side.first.common) {
      const Vec3 normal = side.first.across[1].cross(side.tangent).normalized();
      direction -= normal.dot(direction) * normal;
    }
    const Vec3 across = direction - side.tangent.dot(direction) * side.tangent;
    if (across.norm() < 1e-3 * (first_leg.norm() + last_leg.norm())) direction = face_.normal.cross(side.tangent);
    side.inwards = direction.normalized();
  }

  const Brep& brep_;
  const BrepFace& face_;
};

}  // namespace

std::vector<FaceSide> face_sides(const Brep& brep, const BrepFace& face) {
  const std::vector<Index> halves = brep.around(face.loops[0]);
  const SideMaker maker(brep, face);
  std::vector<FaceSide> sides;
  for (std::size_t i = 0; i < halves.size(); ++i) {
    const Index before = halves[(i + halves.size() - 1) % halves.size()];
    sides.push_back(maker.make_side(halves[i], before, halves[(i + 1) % halves.size()]));
  }
  return sides;
}

}  // namespace croquis

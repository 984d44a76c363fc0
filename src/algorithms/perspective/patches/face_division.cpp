// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/perspective/patches/face_division.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

#include <Eigen/Geometry>

#include "algorithms/perspective/patches/patch_fairing.h"

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

constexpr double degree = std::numbers::pi / 180;

/// A diagonal leaves such angles on both sides at its corners: patches turn their back at wider ones.
constexpr double least_angle = 10 * degree, greatest_angle = 170 * degree;

/// Below this sine two legs don't give the plane of a corner, and a plane at this cosine to the face's mean plane
/// doesn't show which way round it is.
constexpr double least_span = 0.05, least_cosine = 0.1;

/// Corners of more than this are wide, and what a diagonal from there costs, x.
constexpr double wide_angle = 190 * degree, wide_price = 0.5;

/// How much dearer a diagonal is for each side that a part has more or less than four.
constexpr double side_cost = 0.5;

/// The corner of a face at the start of a half-edge.
struct FaceCorner {
  Vec3 point = Vec3::Zero();
  Vec3 out = Vec3::Zero();     ///< unit, along the half-edge
  Vec3 normal = Vec3::Zero();  ///< unit, outwards; zero if the sides don't span a plane
  double angle = 0;            ///< inside the face, 0..2 pi
};

/// From `a` to `b`, counter-clockwise about the normal, 0..2 pi.
double turn(const Vec3& a, const Vec3& b, const Vec3& normal) {
  const double angle = std::atan2(normal.dot(a.cross(b)), a.dot(b));
  return angle < 0 ? angle + 2 * std::numbers::pi : angle;
}

FaceCorner corner_between(const FaceSide& before, const FaceSide& after, const Vec3& face_normal) {
  FaceCorner corner;
  corner.point = after.first.points[0];
  corner.out = (after.first.points[1] - after.first.points[0]).normalized();
  const Vec3 back = (before.second.points[2] - before.second.points[3]).normalized();
  const Vec3 span = corner.out.cross(back);
  if (span.norm() < least_span || std::abs(span.dot(face_normal)) < least_cosine * span.norm()) return corner;
  corner.normal = span.dot(face_normal) < 0 ? Vec3(-span.normalized()) : span.normalized();
  corner.angle = turn(corner.out, back, corner.normal);
  return corner;
}

/// The handle of a cubic that leaves in the direction in which the chord lies, seen in the corner's plane; of the
/// length that makes the cubic an arc, if its other end is alike. Zero if it would leave the face.
Vec3 leg_towards(const FaceCorner& corner, const Vec3& chord) {
  Vec3 direction = chord - corner.normal.dot(chord) * corner.normal;
  if (direction.norm() < least_span * chord.norm()) return Vec3::Zero();
  direction.normalize();
  const double angle = turn(corner.out, direction, corner.normal), rest = corner.angle - angle;
  const bool inside = angle > least_angle && rest > least_angle && angle < greatest_angle && rest < greatest_angle;
  if (!inside) return Vec3::Zero();
  return 2.0 / 3.0 * chord.norm() / (1 + direction.dot(chord) / chord.norm()) * direction;
}

/// The patches on both sides of a diagonal between faces of four sides. Each handle may move in its plane.
class DiagonalFamily : public PatchFamily {
 public:
  DiagonalFamily(const Brep& brep, Index edge, const FaceDiagonal& start) : start_(start) {
    const BrepEdge& diagonal = brep.edges[edge];
    ends_ = {diagonal.fitted[0].points[0], diagonal.fitted[0].points[3]};
    for (const bool back : {false, true}) {
      const Index half = diagonal.half_edges[back ? 1 : 0];
      const BrepFace& face = brep.faces[brep.face_of(half)];
      const std::vector<Index> around = brep.around(face.loops[0]);
      for (const FaceSide& side : face_sides(brep, face)) sides_[back ? 1 : 0].push_back(side.as_one());
      side_[back ? 1 : 0] = static_cast<std::size_t>(std::ranges::find(around, half) - around.begin());
    }
  }

  std::size_t patches() const override { return 2; }
  int variables() const override { return 4; }
  std::vector<int> variables_of(std::size_t) const override { return {0, 1, 2, 3}; }
  std::vector<PatchJoint> joints() const override {
    return {{0, static_cast<int>(side_[0]), 1, static_cast<int>(side_[1])}};
  }

  FaceDiagonal shape(const Eigen::VectorXd& values) const {
    FaceDiagonal shape = start_;
    for (std::size_t i = 0; i < 2; ++i) {
      const Vec3& leg = start_.legs[i];
      const auto v = static_cast<Eigen::Index>(2 * i);
      shape.legs[i] = leg + values[v] * leg + values[v + 1] * start_.normals[i].cross(leg);
    }
    return shape;
  }

  GregoryPatch patch(std::size_t index, const Eigen::VectorXd& values) const override;

  /// Handles neither turn by more than 30 degrees nor shrink to nothing.
  bool allowed(const Eigen::VectorXd& values) const override {
    for (const int end : {0, 2}) {
      const double length = 1 + values[end];
      if (length < 0.3 || length > 3 || std::abs(values[end + 1]) > 0.58 * length) return false;
    }
    return true;
  }

 private:
  const FaceDiagonal& start_;
  std::array<Vec3, 2> ends_;
  std::array<std::vector<PatchSide>, 2> sides_;
  std::array<std::size_t, 2> side_{};
};

RationalCubic cubic_of(const FaceDiagonal& diagonal, const std::array<Vec3, 2>& ends) {
  return {{ends[0], ends[0] + diagonal.legs[0], ends[1] + diagonal.legs[1], ends[1]}};
}

/// At both ends, into the face on the left of the diagonal.
std::array<Vec3, 2> across_of(const FaceDiagonal& diagonal) {
  return {diagonal.normals[0].cross(diagonal.legs[0]).normalized(),
          -diagonal.normals[1].cross(diagonal.legs[1]).normalized()};
}

GregoryPatch DiagonalFamily::patch(std::size_t index, const Eigen::VectorXd& values) const {
  const FaceDiagonal diagonal = shape(values);
  const RationalCubic cubic = cubic_of(diagonal, ends_);
  const std::array<Vec3, 2> across = across_of(diagonal);
  PatchSide side{cubic.points, true, across};
  if (index == 1) side = {cubic.reversed().points, true, {-across[1], -across[0]}};
  const std::vector<PatchSide>& sides = sides_[index];
  std::array<PatchSide, 4> used = {sides[0], sides[1], sides[2], sides[3]};
  used[side_[index]] = side;
  return span_patch(used);
}

/// The mean plane of a loop of half-edges, through the points of their cubics.
void set_mean_plane(const Brep& brep, BrepFace& face) {
  std::vector<Vec3> points;
  for (const FaceSide& side : face_sides(brep, face)) {
    for (const PatchSide* half : {&side.first, &side.second}) {
      points.insert(points.end(), half->points.begin(), half->points.begin() + 3);
    }
  }
  Vec3 normal = Vec3::Zero();
  face.origin = Vec3::Zero();
  for (const Vec3& point : points) face.origin += point / static_cast<double>(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    normal += (points[i] - face.origin).cross(points[(i + 1) % points.size()] - face.origin);
  }
  if (normal.norm() > 0) face.normal = normal.normalized();
}

/// Makes the diagonal's edge and the second face; `first` and `second` begin at its corners.
Index cut_loop(Brep& brep, Index face, Index first, Index second) {
  const auto edge = static_cast<Index>(brep.edges.size()), loop = static_cast<Index>(brep.loops.size());
  const auto ahead = static_cast<Index>(brep.half_edges.size()), back = ahead + 1;
  const Index old_loop = brep.faces[face].loops[0];
  const std::vector<Index> around = brep.around(old_loop);
  const auto before = [&](Index half) {
    const auto at = static_cast<std::size_t>(std::ranges::find(around, half) - around.begin());
    return around[(at + around.size() - 1) % around.size()];
  };
  const Index before_first = before(first), before_second = before(second);
  BrepEdge diagonal;
  diagonal.id = "f" + std::to_string(brep.faces[face].outline) + "/" + std::to_string(edge);
  diagonal.start = brep.start_of(first);
  diagonal.end = brep.start_of(second);
  diagonal.half_edges = {ahead, back};
  diagonal.smooth = true;
  brep.edges.push_back(std::move(diagonal));
  brep.half_edges.push_back({edge, false, loop, second});
  brep.half_edges.push_back({edge, true, old_loop, first});
  brep.half_edges[before_first].next = ahead;
  brep.half_edges[before_second].next = back;
  brep.loops[old_loop].first = first;
  brep.loops.push_back({static_cast<Index>(brep.faces.size()), second});
  for (Index half = second; half != ahead; half = brep.half_edges[half].next) brep.half_edges[half].loop = loop;
  BrepFace part = brep.faces[face];
  part.loops = {loop};
  brep.shells[part.shell].faces.push_back(static_cast<Index>(brep.faces.size()));
  brep.faces.push_back(std::move(part));
  return edge;
}

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

std::vector<FaceDiagonal> diagonals(const Brep& brep, Index face) {
  const std::vector<Index> around = brep.around(brep.faces[face].loops[0]);
  const std::vector<FaceSide> sides = face_sides(brep, brep.faces[face]);
  const std::size_t n = sides.size();
  std::vector<FaceCorner> corners;
  for (std::size_t i = 0; i < n; ++i) {
    corners.push_back(corner_between(sides[(i + n - 1) % n], sides[i], brep.faces[face].normal));
  }
  std::vector<FaceDiagonal> found;
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = i + 2; j < n && j - i < n - 1; ++j) {
      const FaceCorner &a = corners[i], &b = corners[j];
      if (a.normal.isZero(0) || b.normal.isZero(0)) continue;
      FaceDiagonal diagonal;
      diagonal.halves = {around[i], around[j]};
      diagonal.legs = {leg_towards(a, b.point - a.point), leg_towards(b, a.point - b.point)};
      diagonal.normals = {a.normal, b.normal};
      if (diagonal.legs[0].isZero(0) || diagonal.legs[1].isZero(0)) continue;
      const auto sides_off = [](std::size_t count) { return std::abs(static_cast<double>(count) - 4); };
      diagonal.cost =
          (b.point - a.point).norm() * (1 + side_cost * (sides_off(j - i + 1) + sides_off(n - (j - i) + 1)));
      if (std::max(a.angle, b.angle) > wide_angle) diagonal.cost *= wide_price;
      found.push_back(diagonal);
    }
  }
  std::ranges::stable_sort(found, {}, &FaceDiagonal::cost);
  return found;
}

void divide_face(Brep& brep, Index face, const FaceDiagonal& diagonal) {
  const Index e = cut_loop(brep, face, diagonal.halves[0], diagonal.halves[1]);
  const std::array<Vec3, 2> ends = {brep.vertices[brep.edges[e].start].point, brep.vertices[brep.edges[e].end].point};
  const auto take = [&](const FaceDiagonal& shape) {
    BrepEdge& edge = brep.edges[e];
    edge.pieces = edge.fitted = {cubic_of(shape, ends)};
    edge.across = across_of(shape);
  };
  take(diagonal);
  bool all_four = true;
  for (const Index half : brep.edges[e].half_edges) {
    BrepFace& part = brep.faces[brep.face_of(half)];
    set_mean_plane(brep, part);
    const std::vector<FaceSide> sides = face_sides(brep, part);
    all_four = all_four && sides.size() == 4 && std::ranges::all_of(sides, &FaceSide::whole);
  }
  if (!all_four) return;
  const DiagonalFamily family(brep, e, diagonal);
  take(family.shape(least_energy(family)));
}

}  // namespace croquis

// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/attribute_surface/fences/normal_fences.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <set>
#include <utility>

#include <Eigen/Geometry>

#include "algorithms/attribute_surface/fences/smooth_corners.h"
#include "algorithms/attribute_surface/network/network_words.h"

namespace croquis {
namespace {

/// A normal nearer than this to a curve's tangent says nothing about the surface, radians.
constexpr double least_slope_angle = std::numbers::pi / 180;
/// Steps in which a normal is carried along a curve.
constexpr int carry_steps = 64;

Vec3 projected_off(const Vec3& normal, const Vec3& tangent) {
  const Vec3 result = normal - normal.dot(tangent) * tangent;
  return result.norm() > 1e-9 ? Vec3(result.normalized()) : Vec3(tangent.unitOrthogonal());
}

/// The normal turned as little as possible along a curve.
Vec3 carried(const DirectedCurve& curve, const Vec3& normal, double from, double to) {
  Vec3 result = projected_off(normal, curve.tangent(from));
  for (int i = 1; i <= carry_steps; ++i) {
    result = projected_off(result, curve.tangent(from + (to - from) * i / carry_steps));
  }
  return result;
}

/// Normals at a curve's ends.
using EndNormals = std::array<Vec3, 2>;

class FenceMaker {
 public:
  FenceMaker(const FenceInput& input, Findings& findings)
      : input_(input),
        findings_(findings),
        smooth_(smooth_curves()),
        shapes_(shapes()),
        corners_(input, smooth_, shapes_) {}

  NormalFences run() {
    check_slopes();
    NormalFences result;
    for (Index face = 0; face < input_.network.faces.size(); ++face) {
      result.sides.emplace_back();
      for (std::size_t side = 0; side < shapes_[face].loop.size(); ++side) {
        result.sides.back().push_back(fence(face, side));
      }
    }
    result.smooth = smooth_;
    return result;
  }

 private:
  const AttributeNetwork& network() const { return input_.network; }

  // ---- Which curves are smooth

  std::vector<bool> smooth_curves() {
    std::vector<bool> result;
    for (Index i = 0; i < network().curves.size(); ++i) {
      const std::vector<Index>& faces = input_.faces_of_curve[i];
      if (faces.size() > 2) tell_nonmanifold(i);
      const bool all = std::ranges::all_of(faces, [&](Index face) { return input_.wants_fences[face]; });
      result.push_back(network().curves[i].join == CurveJoin::Smooth && faces.size() == 2 && faces[0] != faces[1] &&
                       all);
    }
    return result;
  }

  void tell_nonmanifold(Index curve) {
    std::vector<Subject> subjects{subject_of(SubjectKind::Curve, network().curves[curve].id)};
    for (const Index face : input_.faces_of_curve[curve]) {
      subjects.push_back(subject_of(SubjectKind::Face, network().faces[face].id));
    }
    const std::size_t faces = input_.faces_of_curve[curve].size();
    findings_.push_back(make_warning(Category::Geometry, "W_NONMANIFOLD",
                                     "Curve " + quoted(network().curves[curve].id) + " belongs to " +
                                         std::to_string(faces) +
                                         " faces: it can't be smooth there, and the mesh has a non-manifold edge.",
                                     std::move(subjects)));
  }

  std::vector<FaceShape> shapes() const {
    std::vector<FaceShape> result;
    for (Index face = 0; face < network().faces.size(); ++face) {
      FaceShape shape;
      if (input_.wants_fences[face]) {
        for (const AttributeSide& side : network().faces[face].loop) {
          shape.loop.push_back({input_.curves.curves[side.curve].curve, side.reversed});
        }
        shape.normals = loop_normals(shape.loop);
      }
      result.push_back(std::move(shape));
    }
    return result;
  }

  // ---- Normals at the ends of sides

  EndNormals end_normals(Index face, std::size_t side) {
    const Index curve = network().faces[face].loop[side].curve;
    return smooth_[curve] ? shared_normals(face, side, curve) : own_normals(face, side);
  }

  FaceCorner end_corner(Index face, std::size_t side, bool end) const {
    return {face, end ? (side + 1) % shapes_[face].loop.size() : side};
  }

  /// At an edge every face has the normals of its own group.
  EndNormals own_normals(Index face, std::size_t side) const {
    EndNormals result;
    for (const bool end : {false, true}) {
      const FaceCorner corner = end_corner(face, side, end);
      const bool alone = corners_.group(corner).knife_edge;
      const Vec3 normal = alone ? shapes_[face].normals.corners[corner.side] : corners_.normal(corner);
      result[end ? 1 : 0] = projected_off(normal, shapes_[face].loop[side].tangent(end ? 1 : 0));
    }
    return result;
  }

  /// Found for the first of the two faces, so that both have the same.
  EndNormals shared_normals(Index face, std::size_t side, Index curve) {
    const Index first = input_.faces_of_curve[curve][0];
    if (face == first) return first_normals(face, side, curve);
    const std::size_t first_side = side_of(network().faces[first], curve);
    EndNormals normals = first_normals(first, first_side, curve);
    const bool same_way = shapes_[first].loop[first_side].reversed == shapes_[face].loop[side].reversed;
    if (same_way) return {-normals[0], -normals[1]};
    return {normals[1], normals[0]};
  }

  EndNormals first_normals(Index face, std::size_t side, Index curve) {
    const DirectedCurve& along = shapes_[face].loop[side];
    std::array<bool, 2> known{};
    EndNormals result;
    for (const bool end : {false, true}) {
      const FaceCorner corner = end_corner(face, side, end);
      known[end ? 1 : 0] = !corners_.group(corner).knife_edge;
      if (known[end ? 1 : 0]) result[end ? 1 : 0] = projected_off(corners_.normal(corner), along.tangent(end ? 1 : 0));
      if (!known[end ? 1 : 0]) tell_conflict(corner, curve);
    }
    if (known[0] && !known[1]) result[1] = carried(along, result[0], 0, 1);
    if (known[1] && !known[0]) result[0] = carried(along, result[1], 1, 0);
    if (!known[0] && !known[1]) result = normals_from_middle(face, side, curve);
    return result;
  }

  /// A knife edge at both ends, as of a boat: from what the two loops together say about the middle of the curve.
  EndNormals normals_from_middle(Index face, std::size_t side, Index curve) const {
    const Index other = input_.faces_of_curve[curve][1];
    const DirectedCurve& along = shapes_[face].loop[side];
    const std::size_t other_side = side_of(network().faces[other], curve);
    const bool same_way = along.reversed == shapes_[other].loop[other_side].reversed;
    const Vec3 sum = shapes_[face].normals.newell + (same_way ? -1 : 1) * shapes_[other].normals.newell;
    const Vec3 middle = projected_off(sum.norm() > 0.1 ? sum : shapes_[face].normals.newell, along.tangent(0.5));
    return {carried(along, middle, 0.5, 0), carried(along, middle, 0.5, 1)};
  }

  void tell_conflict(const FaceCorner& corner, Index curve) {
    const CornerGroup& group = corners_.group(corner);
    const std::string& place = place_name(group.corners.front());
    if (!told_.insert({group.corners.front().face, group.corners.front().side}).second) return;
    std::vector<Subject> subjects;
    std::string names;
    for (const FaceCorner& member : group.corners) {
      const std::string& id = network().faces[member.face].id;
      subjects.push_back(subject_of(SubjectKind::Face, id));
      names += (names.empty() ? "" : ", ") + quoted(id);
    }
    subjects.push_back(subject_of(SubjectKind::Node, place));
    findings_.push_back(
        make_warning(Category::Geometry, "W_SMOOTH_CONFLICT",
                     "The faces " + names + " meet at node " + quoted(place) +
                         " like the sides of a knife, so they have no common " +
                         "normal there: along the smooth curve " + quoted(network().curves[curve].id) +
                         " it is taken from elsewhere on the curve; make that curve a crease where this is an edge.",
                     std::move(subjects)));
  }

  const std::string& place_name(const FaceCorner& corner) const {
    const AttributeSide& side = network().faces[corner.face].loop[corner.side];
    const AttributeCurve& curve = network().curves[side.curve];
    const Index node = side.reversed ? curve.to : curve.from;
    return node == no_index ? curve.id : network().nodes[node].id;
  }

  // ---- Fences

  NormalFence fence(Index face, std::size_t side) {
    const EndNormals ends = end_normals(face, side);
    NormalFence result{{0, 1}, {ends[0], ends[1]}, 1};
    const NormalFence found = result;
    for (const SlopeAttribute& slope : network().slopes) {
      if (slope.curve != network().faces[face].loop[side].curve) continue;
      if (slope.face != no_index && slope.face != face) continue;
      result.magnitude *= slope.magnitude;
      for (std::size_t i = 0; i < slope.at.size(); ++i) add_slope(result, found, {face, side}, {slope, i});
    }
    return result;
  }

  struct SlopeKey {
    const SlopeAttribute& slope;
    std::size_t index;
  };

  void add_slope(NormalFence& fence, const NormalFence& found, const FaceCorner& of, const SlopeKey& key) const {
    const DirectedCurve& along = shapes_[of.face].loop[of.side];
    const double at = along.reversed ? 1 - key.slope.at[key.index] : key.slope.at[key.index];
    const Vec3 tangent = along.tangent(at);
    if (!tells_slope(key.slope.normals[key.index], tangent)) return;
    Vec3 normal = projected_off(key.slope.normals[key.index], tangent);
    // Meant for all faces along the curve, it points to the side where each of them has its normal.
    const Vec3 own = (1 - at) * found.normals[0] + at * found.normals[1];
    if (key.slope.face == no_index && normal.dot(own) < 0) normal = -normal;
    const auto next = std::ranges::lower_bound(fence.at, at);
    const auto place = next - fence.at.begin();
    if (next != fence.at.end() && *next == at) {
      fence.normals[static_cast<std::size_t>(place)] = normal;
      return;
    }
    fence.at.insert(next, at);
    fence.normals.insert(fence.normals.begin() + place, normal);
  }

  static bool tells_slope(const Vec3& normal, const Vec3& tangent) {
    const double angle = angle_between(normal, tangent);
    return std::min(angle, std::numbers::pi - angle) >= least_slope_angle;
  }

  void check_slopes() {
    for (const SlopeAttribute& slope : network().slopes) {
      const auto& curve = input_.curves.curves[slope.curve].curve;
      for (std::size_t i = 0; curve && i < slope.at.size(); ++i) {
        if (tells_slope(slope.normals[i], curve->place(slope.at[i]).derivative)) continue;
        const std::string& id = network().curves[slope.curve].id;
        findings_.push_back(make_error(Category::Geometry, "E_SLOPE",
                                       "The normal at " + rounded_text(slope.at[i]) + " of curve " + quoted(id) +
                                           " points along the curve, so it tells no slope and is left out: turn it " +
                                           "away from the curve.",
                                       {subject_of(SubjectKind::Curve, id)}));
      }
    }
  }

  const FenceInput& input_;
  Findings& findings_;
  std::vector<bool> smooth_;
  std::vector<FaceShape> shapes_;
  SmoothCorners corners_;
  std::set<std::pair<Index, std::size_t>> told_;
};

}  // namespace

NormalFences make_fences(const FenceInput& input, Findings& findings) { return FenceMaker(input, findings).run(); }

}  // namespace croquis

// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/attribute_surface/fences/normal_fences.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <numbers>
#include <set>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "algorithms/attribute_surface/network/loop_curves.h"
#include "croquis/attribute_surface/arc_length_curve.h"
#include "croquis/geometry/vector.h"

namespace croquis {
namespace {

/// A curve as a loop walks along it.
struct DirectedCurve {
  std::shared_ptr<const ArcLengthCurve> curve;
  bool reversed = false;

  Vec3 at(double t) const { return curve->at(reversed ? 1 - t : t); }
  Vec3 tangent(double t) const;  ///< unit
};

/// Where the normals of a loop come from.
struct LoopNormals {
  Vec3 newell = Vec3::Zero();  ///< of the whole loop, unit; zero for a loop that encloses nothing
  std::vector<Vec3> corners;   ///< unit, at the start of each side: of the tangents that meet there
};

/// Sines of the corner's angle: below the first the corner has no say, from the sum on it has all.
constexpr double least_sine = 0.02;
constexpr double sine_range = 0.18;

constexpr int newell_samples = 32;

double smooth_step(double x) {
  const double t = std::clamp(x, 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

Vec3 newell_normal(const std::vector<DirectedCurve>& loop) {
  const Vec3 origin = loop.front().at(0);
  Vec3 before = Vec3::Zero();
  Vec3 sum = Vec3::Zero();
  for (const DirectedCurve& side : loop) {
    for (int i = 1; i <= newell_samples; ++i) {
      const Vec3 point = side.at(static_cast<double>(i) / newell_samples) - origin;
      sum += before.cross(point);
      before = point;
    }
  }
  return unit_or_zero(sum);
}

Vec3 corner_normal(const Vec3& arriving, const Vec3& leaving, const Vec3& newell) {
  const Vec3 product = leaving.cross(-arriving);
  const double sine = product.norm();
  const double share = smooth_step((sine - least_sine) / sine_range);
  Vec3 normal = (1 - share) * unit_or_zero(newell - newell.dot(leaving) * leaving);
  if (share > 0) normal += share * (product.dot(newell) < 0 ? -1 : 1) / sine * product;
  return normal.norm() > 1e-9 ? Vec3(normal.normalized()) : Vec3(leaving.unitOrthogonal());
}

Vec3 DirectedCurve::tangent(double t) const {
  const Vec3 along = curve->place(reversed ? 1 - t : t).derivative.normalized();
  return reversed ? Vec3(-along) : along;
}

/// Where the tangents of a corner are nearly parallel its normal goes over to the loop's, without a threshold.
LoopNormals loop_normals(const std::vector<DirectedCurve>& loop) {
  LoopNormals result;
  result.newell = newell_normal(loop);
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const DirectedCurve& before = loop[(i + loop.size() - 1) % loop.size()];
    result.corners.push_back(corner_normal(before.tangent(1), loop[i].tangent(0), result.newell));
  }
  return result;
}

/// A corner of a face: where its side begins.
struct FaceCorner {
  Index face = no_index;
  std::size_t side = 0;
};

/// Corners of faces that meet smoothly, in one place.
struct CornerGroup {
  std::vector<FaceCorner> corners;
  Vec3 normal = Vec3::Zero();  ///< unit, for the first corner's face
  bool knife_edge = false;     ///< the faces' own normals point away from each other: there is no common one
};

/// By face, what its loop is like. Faces without a fence have none.
struct FaceShape {
  std::vector<DirectedCurve> loop;
  LoopNormals normals;
};

/// The common normals of corners that smooth curves join.
class SmoothCorners {
 public:
  SmoothCorners(const FenceInput& input, const std::vector<bool>& smooth, const std::vector<FaceShape>& shapes);

  const CornerGroup& group(const FaceCorner& corner) const { return groups_[entry(corner).group]; }

  /// The group's normal as that face has it: turned round where its loop runs the other way.
  Vec3 normal(const FaceCorner& corner) const;

 private:
  struct Entry {
    std::size_t group = 0;
    bool turned = false;  ///< against the group's first corner
  };
  struct Link {
    std::size_t other = 0;
    bool turned = false;
  };

  const Entry& entry(const FaceCorner& corner) const { return entries_[number(corner)]; }
  std::size_t number(const FaceCorner& corner) const { return first_of_face_[corner.face] + corner.side; }
  void link_along(const FenceInput& input, Index curve);
  void gather(std::size_t first);

  const std::vector<FaceShape>& shapes_;
  std::vector<std::size_t> first_of_face_;
  std::vector<FaceCorner> corners_;
  std::vector<std::vector<Link>> links_;
  std::vector<Entry> entries_;
  std::vector<CornerGroup> groups_;
};

constexpr std::size_t no_group = ~std::size_t{0};
/// A sum of unit normals below this part of their number is a knife edge's.
constexpr double least_agreement = 0.3;

/// Which side of a face a curve is. @pre it is one
std::size_t side_of(const AttributeFace& face, Index curve) {
  return static_cast<std::size_t>(std::ranges::find(face.loop, curve, &AttributeSide::curve) - face.loop.begin());
}

/// The corner of a face at the start or the end of a curve.
FaceCorner corner_at(const AttributeNetwork& network, Index face, Index curve, bool end) {
  const std::vector<AttributeSide>& loop = network.faces[face].loop;
  const std::size_t side = side_of(network.faces[face], curve);
  return {face, loop[side].reversed == end ? side : (side + 1) % loop.size()};
}

SmoothCorners::SmoothCorners(const FenceInput& input, const std::vector<bool>& smooth,
                             const std::vector<FaceShape>& shapes)
    : shapes_(shapes) {
  for (Index face = 0; face < input.network.faces.size(); ++face) {
    first_of_face_.push_back(corners_.size());
    for (std::size_t side = 0; side < shapes[face].loop.size(); ++side) corners_.push_back({face, side});
  }
  links_.resize(corners_.size());
  entries_.resize(corners_.size(), {no_group, false});
  for (Index curve = 0; curve < smooth.size(); ++curve) {
    if (smooth[curve]) link_along(input, curve);
  }
  for (std::size_t corner = 0; corner < corners_.size(); ++corner) {
    if (entries_[corner].group == no_group) gather(corner);
  }
}

void SmoothCorners::link_along(const FenceInput& input, Index curve) {
  const Index first = input.faces_of_curve[curve][0];
  const Index second = input.faces_of_curve[curve][1];
  const auto reversed = [&](Index face) {
    const AttributeFace& of = input.network.faces[face];
    return of.loop[side_of(of, curve)].reversed;
  };
  const bool turned = reversed(first) == reversed(second);
  for (const bool end : {false, true}) {
    const std::size_t a = number(corner_at(input.network, first, curve, end));
    const std::size_t b = number(corner_at(input.network, second, curve, end));
    links_[a].push_back({b, turned});
    links_[b].push_back({a, turned});
  }
}

void SmoothCorners::gather(std::size_t first) {
  CornerGroup group;
  Vec3 sum = Vec3::Zero();
  std::vector<std::size_t> waiting{first};
  entries_[first] = {groups_.size(), false};
  for (std::size_t i = 0; i < waiting.size(); ++i) {
    const FaceCorner corner = corners_[waiting[i]];
    group.corners.push_back(corner);
    const bool turned = entries_[waiting[i]].turned;
    sum += (turned ? -1 : 1) * shapes_[corner.face].normals.corners[corner.side];
    for (const Link& link : links_[waiting[i]]) {
      if (entries_[link.other].group != no_group) continue;
      entries_[link.other] = {groups_.size(), turned != link.turned};
      waiting.push_back(link.other);
    }
  }
  group.knife_edge = sum.norm() < least_agreement * static_cast<double>(waiting.size());
  group.normal = unit_or_zero(sum);
  groups_.push_back(group);
}

Vec3 SmoothCorners::normal(const FaceCorner& corner) const {
  const Entry& found = entry(corner);
  return found.turned ? Vec3(-groups_[found.group].normal) : groups_[found.group].normal;
}

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
      if (faces.size() > 2) report_nonmanifold(i);
      const bool all = std::ranges::all_of(faces, [&](Index face) { return input_.wants_fences[face]; });
      result.push_back(network().curves[i].join == CurveJoin::Smooth && faces.size() == 2 && faces[0] != faces[1] &&
                       all);
    }
    return result;
  }

  void report_nonmanifold(Index curve) {
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
      if (!known[end ? 1 : 0]) report_conflict(corner, curve);
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

  void report_conflict(const FaceCorner& corner, Index curve) {
    const CornerGroup& group = corners_.group(corner);
    const std::string& place = place_name(group.corners.front());
    if (!reported_.insert({group.corners.front().face, group.corners.front().side}).second) return;
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
    if (!gives_slope(key.slope.normals[key.index], tangent)) return;
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

  static bool gives_slope(const Vec3& normal, const Vec3& tangent) {
    const double angle = angle_between(normal, tangent);
    return std::min(angle, std::numbers::pi - angle) >= least_slope_angle;
  }

  void check_slopes() {
    for (const SlopeAttribute& slope : network().slopes) {
      const auto& curve = input_.curves.curves[slope.curve].curve;
      for (std::size_t i = 0; curve && i < slope.at.size(); ++i) {
        if (gives_slope(slope.normals[i], curve->place(slope.at[i]).derivative)) continue;
        const std::string& id = network().curves[slope.curve].id;
        findings_.push_back(make_error(Category::Geometry, "E_SLOPE",
                                       "The normal at " + rounded_text(slope.at[i]) + " of curve " + quoted(id) +
                                           " points along the curve, so it gives no slope and is left out: turn it " +
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
  std::set<std::pair<Index, std::size_t>> reported_;
};

}  // namespace

NormalFences make_fences(const FenceInput& input, Findings& findings) { return FenceMaker(input, findings).run(); }

}  // namespace croquis

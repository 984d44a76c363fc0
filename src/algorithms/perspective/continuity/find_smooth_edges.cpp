// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include "algorithms/perspective/solid/plane_axes.h"
#include "croquis/geometry/disjoint_sets.h"
#include "croquis/perspective/edge_continuity.h"

namespace croquis {
namespace {

/// Legs count as lying in a common plane up to this (sine of the angle): a tenth of a millionth of a degree.
constexpr double same_plane = 1e-9;

/// A leg at a smaller angle to the edge (sine) doesn't show where the face goes.
constexpr double least_leg = 0.02;

/// Of legs that can't turn, in the fit of a vertex' plane.
constexpr double fixed_leg_weight = 1e6;

/// Looks for smooth edges with a set of them ruled out.
class SmoothEdges {
 public:
  SmoothEdges(Brep& brep, double angle) : brep_(brep), angle_(angle), previous_(brep.half_edges.size(), no_index) {
    for (Index h = 0; h < brep.half_edges.size(); ++h) previous_[brep.half_edges[h].next] = h;
  }

  bool turns_little(Index e) const {
    const auto [ha, hb] = brep_.edges[e].half_edges;
    if (ha == no_index || hb == no_index || (face_of(ha).planar && face_of(hb).planar)) return false;
    return std::ranges::all_of(std::array{false, true}, [&](bool at_end) {
      const auto [a, b] = sides(e, at_end);
      return a && b && angle_between(*a, -*b) < angle_;
    });
  }

  /// Turns handles so that the legs at each vertex lie in one plane where faces go on smoothly.
  /// @return the smooth edge that misses its plane most, if any does
  std::optional<Index> flatten(const std::set<Index>& smooth) {
    DisjointSets corners(brep_.half_edges.size());
    std::map<Index, std::vector<std::pair<Index, bool>>> ends;  // by a corner of theirs
    for (const Index e : smooth) {
      const auto [ha, hb] = brep_.edges[e].half_edges;
      corners.unite(ha, next(hb));
      corners.unite(next(ha), hb);
    }
    for (const Index e : smooth) {
      ends[corners.root(brep_.edges[e].half_edges[0])].emplace_back(e, false);
      ends[corners.root(brep_.edges[e].half_edges[1])].emplace_back(e, true);
    }
    std::map<Index, std::vector<Index>> groups;
    for (Index h = 0; h < brep_.half_edges.size(); ++h) {
      if (ends.contains(corners.root(h))) groups[corners.root(h)].push_back(h);
    }
    std::optional<Index> worst;
    double greatest = same_plane;
    for (const auto& [root, members] : groups) {
      const Vec3 normal = plane_at(members);
      for (const Index h : members) {
        turn_leg(h, false, normal);
        turn_leg(previous_[h], true, normal);
      }
      for (const auto& [e, at_end] : ends[root]) {
        const double miss = distance_from(e, at_end, normal);
        if (miss <= greatest) continue;
        greatest = miss;
        worst = e;
      }
    }
    return worst;
  }

  void set_across(Index e) {
    BrepEdge& edge = brep_.edges[e];
    edge.smooth = true;
    for (const bool at_end : {false, true}) {
      const auto [a, b] = sides(e, at_end);
      const Vec3 along = leg(edge.half_edges[at_end ? 1 : 0], false).normalized();
      const Vec3 sum = a->normalized() - b->normalized();
      edge.across[at_end ? 1 : 0] = (sum - sum.dot(along) * along).normalized();
    }
  }

 private:
  const BrepFace& face_of(Index half) const { return brep_.faces[brep_.face_of(half)]; }
  Index next(Index half) const { return brep_.half_edges[half].next; }

  /// From the start of a half-edge along it, or from its end back.
  Vec3 leg(Index half, bool from_end) const {
    const BrepEdge& edge = brep_.edges[brep_.half_edges[half].edge];
    if (brep_.half_edges[half].reversed != from_end) return edge.fitted.back().points[2] - edge.fitted.back().points[3];
    return edge.fitted.front().points[1] - edge.fitted.front().points[0];
  }

  /// Into the faces of both half-edges at an end of an edge, at right angles to it; none if a leg runs along the edge.
  std::array<std::optional<Vec3>, 2> sides(Index e, bool at_end) const {
    const auto [ha, hb] = brep_.edges[e].half_edges;
    if (at_end) return {side(ha, leg(next(ha), false), true), side(hb, leg(previous_[hb], true), false)};
    return {side(ha, leg(previous_[ha], true), false), side(hb, leg(next(hb), false), true)};
  }

  std::optional<Vec3> side(Index half, const Vec3& neighbour, bool at_end) const {
    const Vec3 along = leg(half, at_end).normalized();
    if (face_of(half).planar) return Vec3(face_of(half).normal.cross(at_end ? Vec3(-along) : along));
    const Vec3 across = neighbour - neighbour.dot(along) * along;
    if (across.norm() < least_leg * neighbour.norm()) return std::nullopt;
    return across;
  }

  bool is_fixed(Index half) const { return brep_.edges[brep_.half_edges[half].edge].straight; }

  /// The tangent plane of the faces whose corners these are.
  Vec3 plane_at(const std::vector<Index>& corners) const {
    Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
    for (const Index h : corners) {
      if (face_of(h).planar) return face_of(h).normal;
      for (const auto& [half, from_end] : {std::pair(h, false), std::pair(previous_[h], true)}) {
        const Vec3 direction = leg(half, from_end).normalized();
        sum += (is_fixed(half) ? fixed_leg_weight : 1) * direction * direction.transpose();
      }
    }
    return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(sum).eigenvectors().col(0);
  }

  /// Normals of the planes that a curve may not leave.
  std::vector<Vec3> planes_of(const BrepEdge& edge) const {
    std::vector<Vec3> normals;
    for (int axis = 0; axis < 3; ++axis) {
      if (common_level(edge.fitted, axis) != nullptr) normals.push_back(Vec3::Unit(axis));
    }
    for (const Index h : edge.half_edges) {
      if (h == no_index || !face_of(h).planar) continue;
      const Vec3& normal = face_of(h).normal;
      const bool known =
          std::ranges::any_of(normals, [&](const Vec3& n) { return n.cross(normal).norm() < same_plane; });
      if (!known) normals.push_back(normal);
    }
    return normals;
  }

  void turn_leg(Index half, bool from_end, const Vec3& normal) {
    BrepEdge& edge = brep_.edges[brep_.half_edges[half].edge];
    const Vec3 old = leg(half, from_end);
    if (edge.straight || std::abs(normal.dot(old)) <= 1e-15 * old.norm()) return;
    const std::vector<Vec3> planes = planes_of(edge);
    Vec3 direction = old - normal.dot(old) * normal;
    if (planes.size() > 1) return;
    if (planes.size() == 1) {
      direction = normal.cross(planes[0]);
      if (direction.norm() < least_leg) return;
      if (direction.dot(old) < 0) direction = -direction;
    }
    if (angle_between(direction, old) > angle_) return;
    const Vec3 moved = old.norm() * direction.normalized();
    const bool at_start = brep_.half_edges[half].reversed == from_end;
    RationalCubic& cubic = at_start ? edge.fitted.front() : edge.fitted.back();
    cubic.points[at_start ? 1 : 2] = cubic.points[at_start ? 0 : 3] + moved;
  }

  double distance_from(Index e, bool at_end, const Vec3& normal) const {
    const auto [ha, hb] = brep_.edges[e].half_edges;
    const auto miss = [&](const Vec3& direction) { return std::abs(normal.dot(direction.normalized())); };
    const double own = miss(leg(at_end ? hb : ha, false));
    double greatest = own;
    for (const Index half : {ha, hb}) {
      if (face_of(half).planar) continue;  // its side is in the plane, whichever way its edges go
      const bool ahead = (half == ha) == at_end;
      greatest = std::max(greatest, miss(ahead ? leg(next(half), false) : leg(previous_[half], true)));
    }
    return greatest;
  }

  Brep& brep_;
  double angle_;
  std::vector<Index> previous_;
};

Finding smooth_dropped(const BrepEdge& edge) {
  return make_warning(Category::Geometry, "SMOOTH_DROPPED",
                      "The faces along stroke " + edge.id +
                          " nearly go on smoothly, but the strokes at its ends don't lie in one plane: turn their ends "
                          "into a common plane or keep the edge sharp.",
                      {{SubjectKind::Stroke, edge.id, {}, {}, {}}});
}

constexpr int places_per_edge = 32;  ///< spans; one place more

/// Along a side of a patch, a part t of the way.
Vec3 normal_on_side(const GregoryPatch& patch, std::size_t side, double t) {
  const auto [u, v] = place_on_side(side, t);
  return patch.at(u, v).normal();
}

/// The outward normal of a face along one of its half-edges. @param t 0..1 on the half-edge's own way
Vec3 normal_along(const Brep& brep, Index half_edge, double t) {
  const BrepFace& face = brep.faces[brep.face_of(half_edge)];
  if (face.planar) return face.normal;
  const std::vector<Index> around = brep.around(face.loops.front());
  const auto i = static_cast<std::size_t>(std::ranges::find(around, half_edge) - around.begin());
  if (face.patches.size() == 1) return normal_on_side(face.patches.front(), i, t);
  if (t <= 0.5) return normal_on_side(face.patches[i], 0, 2 * t);
  return normal_on_side(face.patches[(i + 1) % around.size()], 3, 2 * t - 1);
}

double jump_across(const Brep& brep, const BrepEdge& edge) {
  double greatest = 0;
  for (int k = 0; k <= places_per_edge; ++k) {
    const double t = static_cast<double>(k) / places_per_edge;
    const Vec3 one = normal_along(brep, edge.half_edges[0], t), other = normal_along(brep, edge.half_edges[1], 1 - t);
    greatest = std::max(greatest, angle_between(one, other));
  }
  return greatest;
}

/// Patch i meets patch i+1 in the line from the middle of half-edge i to the middle of the face.
double jump_inside(const BrepFace& face) {
  double greatest = 0;
  for (std::size_t i = 0; face.patches.size() > 1 && i < face.patches.size(); ++i) {
    const GregoryPatch &patch = face.patches[i], &next = face.patches[(i + 1) % face.patches.size()];
    for (int k = 0; k <= places_per_edge; ++k) {
      const double t = static_cast<double>(k) / places_per_edge;
      greatest = std::max(greatest, angle_between(normal_on_side(patch, 1, t), normal_on_side(next, 2, 1 - t)));
    }
  }
  return greatest;
}

}  // namespace

Findings find_smooth_edges(Brep& brep, const FaceContinuityOptions& options) {
  SmoothEdges search(brep, options.angle);
  std::set<Index> smooth;
  for (Index e = 0; e < brep.edges.size(); ++e) {
    brep.edges[e].smooth = false;
    if (std::ranges::count(options.sharp, brep.edges[e].id) == 0 && search.turns_little(e)) smooth.insert(e);
  }
  Findings warnings;
  const std::vector<BrepEdge> drawn = brep.edges;
  while (const std::optional<Index> worst = search.flatten(smooth)) {
    smooth.erase(*worst);
    warnings.push_back(smooth_dropped(brep.edges[*worst]));
    brep.edges = drawn;
  }
  for (const Index e : smooth) search.set_across(e);
  std::ranges::sort(warnings, {}, &Finding::message);
  return warnings;
}

double greatest_normal_jump(const Brep& brep) {
  double greatest = 0;
  for (const BrepEdge& edge : brep.edges) {
    const bool has_both = edge.half_edges[0] != no_index && edge.half_edges[1] != no_index;
    if (edge.smooth && has_both) greatest = std::max(greatest, jump_across(brep, edge));
  }
  for (const BrepFace& face : brep.faces) greatest = std::max(greatest, jump_inside(face));
  return greatest;
}

}  // namespace croquis

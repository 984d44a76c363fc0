// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/joining/union_improvement.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <utility>

#include <Eigen/Geometry>

#include "algorithms/silhouette/joining/union_triangles.h"
#include "algorithms/silhouette/surface/triangle_shape.h"
#include "croquis/geometry/polyline.h"
#include "croquis/geometry/triangle_tree.h"

namespace croquis::silhouette {
namespace {

using Corners = std::array<Index, 3>;
using Triangles = std::vector<std::array<Vec3, 3>>;

constexpr double sharp_corner = 0.9397;   // cosine of 20 degrees: triangles with a smaller angle are mended
constexpr double least_widening = 0.004;  // of the cosine
constexpr std::size_t most_looks = 12;  // triangles looked at, in parts of all; never met, a bound against endless ones
constexpr std::size_t triangles_per_check = 512;

/// How far a change may move the surface, and how far all of them, in parts of the longest edge there.
constexpr double most_moved = 0.025;
constexpr double most_off_surface = 0.06;

/// How far lines of edges may, in parts of the edge that takes their place: outlines are seen best.
constexpr double most_off_outline = 0.004;
constexpr double most_off_seam = 0.025;

constexpr double least_turned = 0.93;  // cosine: no triangle turns further from what was there

/// Outlines and seams at a vertex.
struct FeatureLine {
  std::vector<Index> ends;       ///< of the edges there
  double slack = most_off_seam;  ///< how far the line may be moved, in parts of the edge that takes its place
};

/// In parts of the segment's length.
double off_segment(const Vec3& place, const Vec3& a, const Vec3& b) {
  return (place - nearest_on_segment(place, a, b)).norm() / (b - a).norm();
}

/// As long as twice the area.
Vec3 normal_of(const std::array<Vec3, 3>& points) { return (points[1] - points[0]).cross(points[2] - points[0]); }

/// Ends at what is nearer than given.
double distance_to(const Triangles& triangles, const Vec3& place, double near) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t t = 0; t < triangles.size() && least > near; ++t) {
    least = std::min(least, foot_on_triangle(triangles[t], place).distance);
  }
  return least;
}

/// How far corners and middles of edges lie from other triangles, the most, and at least as far as given; it ends
/// where that is more than allowed.
double farthest(const Triangles& from, const Triangles& to, double most, double allowed) {
  for (const auto& [a, b, c] : from) {
    for (const Vec3& place : {a, b, c, Vec3((a + b) / 2), Vec3((b + c) / 2), Vec3((c + a) / 2)}) {
      if (most > allowed) return most;
      most = std::max(most, distance_to(to, place, most));
    }
  }
  return most;
}

class UnionImprover {
 public:
  UnionImprover(const Shell& joined, const std::vector<std::uint8_t>& kept)
      : joined_(joined), mesh_(joined), kept_(kept), slender_(mesh_.size(), sharp_corner, most_looks * mesh_.size()) {}

  ImprovedUnion run(Progress& progress) {
    for (Index t = 0; t < mesh_.size(); ++t) slender_.add(t, sharpness(mesh_.corners(t)));
    for (std::size_t looks = 0; const std::optional<Index> t = slender_.next(); ++looks) {
      if (looks % triangles_per_check == 0) progress.check();
      if (!mesh_.is_dead(*t) && sharpness(mesh_.corners(*t)) >= sharp_corner) mend(*t);
    }
    ImprovedUnion improved{joined_, {}, {}};
    improved.changed = mesh_.write(improved.surface);
    improved.vertices = mesh_.written_vertices();
    return improved;
  }

 private:
  double sharpness(const Corners& c) const {
    return sharpest_cosine(mesh_.position(c[0]), mesh_.position(c[1]), mesh_.position(c[2]));
  }

  void mend(Index t) {
    best_ = {};
    best_gain_ = least_widening;
    best_sharpness_ = 1;
    for (std::size_t k = 0; k < 3; ++k) {
      const Index a = mesh_.corners(t)[k];
      const Index b = mesh_.corners(t)[(k + 1) % 3];
      consider_flip(t, k);
      consider_collapse(a, b);
      consider_collapse(b, a);
    }
    for (std::size_t k = 0; k < 3 && best_sharpness_ >= sharp_corner; ++k) {
      consider_moves(mesh_.corners(t)[k]);
      consider_move_onto_edge(t, k);
    }
    if (best_.removed.empty()) return;
    for (const Index added : mesh_.apply(best_)) {
      for (const Index v : mesh_.corners(added)) {
        for (const Index near : mesh_.star(v)) slender_.add(near, sharpness(mesh_.corners(near)));
      }
    }
  }

  void consider_flip(Index t, std::size_t k) {
    const Index other = mesh_.beyond(t, k);
    if (mesh_.side(other) != mesh_.side(t)) return;
    const auto [a, b, c, d] = quad(t, other, k);
    if (mesh_.joins(a, d)) return;
    const Index side = mesh_.side(t);
    consider({{t, other}, {{{a, b, d}, side}, {{a, d, c}, side}}, no_index, {}});
  }

  /// The corners of two triangles beside an edge from b to c: a and d lie opposite to it.
  std::array<Index, 4> quad(Index t, Index other, std::size_t k) const {
    const Corners& own = mesh_.corners(t);
    const Index b = own[(k + 1) % 3];
    return {own[k], b, own[(k + 2) % 3], mesh_.corners(other)[(corner_of(mesh_.corners(other), b) + 1) % 3]};
  }

  /// Outlines and seams that run through a vertex.
  FeatureLine line_through(Index v) const {
    FeatureLine line;
    for (const Spoke& spoke : mesh_.spokes(v)) {
      if (!mesh_.is_feature(spoke)) continue;
      line.ends.push_back(spoke.to);
      if (mesh_.side(spoke.left) / 2 == mesh_.side(spoke.right) / 2) line.slack = most_off_outline;
    }
    return line;
  }

  void consider_collapse(Index from, Index to) {
    const auto [ends, slack] = line_through(from);
    if (!ends.empty() && (ends.size() != 2 || (ends[0] != to && ends[1] != to))) return;
    if (!ends.empty() && off_segment(mesh_.position(from), mesh_.position(ends[0]), mesh_.position(ends[1])) > slack) {
      return;
    }
    if (common_neighbours(from, to) != 2) return;
    Exchange exchange;
    exchange.removed = mesh_.star(from);
    for (const Index t : exchange.removed) {
      Corners corners = mesh_.corners(t);
      if (has_corner(corners, to)) continue;
      corners[corner_of(corners, from)] = to;
      exchange.added.push_back({corners, mesh_.side(t)});
    }
    consider(std::move(exchange));
  }

  std::size_t common_neighbours(Index a, Index b) const {
    std::size_t count = 0;
    for (const Spoke& spoke : mesh_.spokes(a)) count += spoke.to != b && mesh_.joins(spoke.to, b) ? 1U : 0U;
    return count;
  }

  /// Towards the middle of its neighbours, or along the outline or seam that it lies on.
  void consider_moves(Index v) {
    const Vec3 place = mesh_.position(v);
    const auto [ends, slack] = line_through(v);
    if (ends.empty()) {
      const Vec3 middle = middle_of_neighbours(v);
      for (const double share : {1.0, 0.5, 0.25}) consider_move(v, foot_on_star(v, place + share * (middle - place)));
    } else if (ends.size() == 2) {
      for (const std::size_t end : {0U, 1U}) {
        const Vec3 there = mesh_.position(ends[end]);
        const Vec3 behind = mesh_.position(ends[1 - end]);
        for (const double share : {0.5, 0.25}) {
          const Vec3 moved = place + share * (there - place);
          if (off_segment(place, moved, behind) <= slack) consider_move(v, moved);
        }
      }
    }
  }

  Vec3 middle_of_neighbours(Index v) const {
    Vec3 sum = Vec3::Zero();
    for (const Index t : mesh_.star(v)) {
      sum += mesh_.position(mesh_.corners(t)[(corner_of(mesh_.corners(t), v) + 1) % 3]);
    }
    return sum / static_cast<double>(mesh_.star(v).size());
  }

  Vec3 foot_on_star(Index v, const Vec3& place) const {
    TriangleFoot best;
    for (const Index t : mesh_.star(v)) {
      const TriangleFoot foot = foot_on_triangle(points_of(mesh_.corners(t)), place);
      if (foot.distance < best.distance) best = foot;
    }
    return best.point;
  }

  std::array<Vec3, 3> points_of(const Corners& c) const {
    return {mesh_.position(c[0]), mesh_.position(c[1]), mesh_.position(c[2])};
  }

  void consider_move(Index v, const Vec3& place) {
    Exchange exchange{mesh_.star(v), {}, v, place};
    for (const Index t : exchange.removed) exchange.added.push_back({mesh_.corners(t), mesh_.side(t)});
    consider(std::move(exchange));
  }

  /// Moves a corner of a flat triangle onto its opposite edge, which may be of an outline or a seam: the triangle goes,
  /// the one beyond the edge is cut in two.
  void consider_move_onto_edge(Index t, std::size_t k) {
    const Index other = mesh_.beyond(t, k);
    const auto [a, b, c, d] = quad(t, other, k);
    if (!line_through(a).ends.empty() || mesh_.joins(a, d)) return;
    Exchange exchange{
        mesh_.star(a), {}, a, nearest_on_segment(mesh_.position(a), mesh_.position(b), mesh_.position(c))};
    for (const Index near : exchange.removed) {
      if (near != t) exchange.added.push_back({mesh_.corners(near), mesh_.side(near)});
    }
    exchange.removed.push_back(other);
    exchange.added.push_back({{a, b, d}, mesh_.side(other)});
    exchange.added.push_back({{a, d, c}, mesh_.side(other)});
    consider(std::move(exchange));
  }

  void consider(Exchange exchange) {
    double before = -1;
    for (const Index t : exchange.removed) before = std::max(before, sharpness(mesh_.corners(t)));
    double after = -1;
    for (const SidedTriangle& triangle : exchange.added) {
      const auto [a, b, c] = points_after(exchange, triangle.corners);
      after = std::max(after, sharpest_cosine(a, b, c));
      if (before - after <= best_gain_) return;
    }
    if (touches_kept(exchange) || !faces_alike(exchange) || !stays_near(exchange)) return;
    best_gain_ = before - after;
    best_sharpness_ = after;
    best_ = std::move(exchange);
  }

  std::array<Vec3, 3> points_after(const Exchange& exchange, const Corners& corners) const {
    std::array<Vec3, 3> points = points_of(corners);
    for (std::size_t k = 0; k < 3; ++k) {
      if (corners[k] == exchange.moved) points[k] = exchange.place;
    }
    return points;
  }

  bool touches_kept(const Exchange& exchange) const {
    return std::any_of(exchange.removed.begin(), exchange.removed.end(), [&](Index t) {
      const Corners& c = mesh_.corners(t);
      return kept_[c[0]] || kept_[c[1]] || kept_[c[2]];
    });
  }

  /// Whether triangles face the way that those of the same piece did, and fronts the viewer.
  bool faces_alike(const Exchange& exchange) const {
    std::map<Index, Vec3> before;
    for (const Index t : exchange.removed) {
      before.try_emplace(mesh_.side(t), Vec3::Zero()).first->second += normal_of(points_of(mesh_.corners(t)));
    }
    for (auto& [side, sum] : before) sum.normalize();
    for (const SidedTriangle& triangle : exchange.added) {
      const Vec3 own = normal_of(points_after(exchange, triangle.corners));
      if (own.dot(before.at(triangle.side)) < least_turned * own.norm()) return false;
      if ((own.z() > 0) != (triangle.side % 2 == 1)) return false;
    }
    return true;
  }

  /// Whether what is added lies near enough to the surface given; returns how near.
  bool stays_near(Exchange& exchange) const {
    Triangles before;
    Triangles after;
    double off = 0;
    for (const Index t : exchange.removed) {
      before.push_back(points_of(mesh_.corners(t)));
      off = std::max(off, mesh_.off(t));
    }
    for (const SidedTriangle& triangle : exchange.added) after.push_back(points_after(exchange, triangle.corners));
    double longest = 0;
    for (const auto& [a, b, c] : before) longest = std::max({longest, (b - a).norm(), (c - b).norm(), (a - c).norm()});
    const double allowed = std::min(most_moved * longest, most_off_surface * longest - off);
    const double moved = farthest(before, after, farthest(after, before, 0, allowed), allowed);
    for (SidedTriangle& triangle : exchange.added) triangle.off = off + moved;
    return moved <= allowed;
  }

  const Shell& joined_;
  UnionTriangles mesh_;
  const std::vector<std::uint8_t>& kept_;
  SlenderTriangles slender_;
  Exchange best_;              ///< what mends the triangle under consideration best
  double best_sharpness_ = 1;  ///< what the sharpest triangle there has then
  double best_gain_ = 0;       ///< by how much the sharpest triangle there is sharper before
};

}  // namespace

ImprovedUnion improve_union(const Shell& joined, const std::vector<std::uint8_t>& kept, Progress& progress) {
  return UnionImprover(joined, kept).run(progress);
}

}  // namespace croquis::silhouette

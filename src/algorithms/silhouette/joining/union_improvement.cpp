// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <utility>

#include <Eigen/Geometry>

#include "algorithms/silhouette/joining/joining.h"
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

/// A triangle, and which piece of a joined surface it belongs to: the front or the back of an object.
struct SidedTriangle {
  Corners corners{no_index, no_index, no_index};
  Index side = 0;  ///< twice the object, and one more for its front
  double off = 0;  ///< how far it lies from the surface given, at most
};

/// An edge that leaves a vertex, with the triangles on both sides of it.
struct Spoke {
  Index to = no_index;
  Index left = no_index;
  Index right = no_index;
};

/// Some triangles of a closed surface, and those that they would be replaced by; one vertex may move.
struct Exchange {
  std::vector<Index> removed;
  std::vector<SidedTriangle> added;
  Index moved = no_index;
  Vec3 place = Vec3::Zero();  ///< of the vertex that moves
};

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

/// A closed surface whose triangles can be replaced, a few at a time.
struct UnionTriangles {
  std::vector<Vec3> positions;
  std::vector<SidedTriangle> triangles;
  std::vector<std::uint8_t> changed;      ///< per triangle
  std::vector<std::vector<Index>> stars;  ///< per vertex the triangles around it, in no order

  explicit UnionTriangles(const Shell& joined)
      : positions(joined.mesh.positions), changed(joined.mesh.face_count(), 0), stars(joined.mesh.vertex_count()) {
    for (Index f = 0; f < joined.mesh.face_count(); ++f) {
      const auto c = joined.mesh.face(f);
      triangles.push_back({{c[0], c[1], c[2]}, 2 * joined.face_objects[f] + (seen_area(joined.mesh, f) > 0 ? 1 : 0)});
      for (const Index v : c) stars[v].push_back(f);
    }
  }

  bool is_dead(Index t) const { return corners(t)[0] == no_index; }
  const Corners& corners(Index t) const { return triangles[t].corners; }
  Index side(Index t) const { return triangles[t].side; }
  std::array<Vec3, 3> points_of(const Corners& c) const { return {positions[c[0]], positions[c[1]], positions[c[2]]}; }
  double sharpness(Index t) const {
    const auto [a, b, c] = points_of(corners(t));
    return sharpest_cosine(a, b, c);
  }

  /// Edges that leave a vertex, in no order.
  std::vector<Spoke> spokes(Index v) const {
    std::vector<Spoke> found;
    for (const Index left : stars[v]) {
      const Index to = corners(left)[(corner_of(corners(left), v) + 1) % 3];
      for (const Index right : stars[v]) {
        if (corners(right)[(corner_of(corners(right), v) + 2) % 3] == to) found.push_back({to, left, right});
      }
    }
    return found;
  }

  bool joins(Index a, Index b) const {
    return std::ranges::any_of(stars[a], [&](Index t) { return has_corner(corners(t), b); });
  }

  /// The triangle beyond the edge that is opposite to a corner.
  Index beyond(Index t, std::size_t corner) const {
    const Index from = corners(t)[(corner + 2) % 3], to = corners(t)[(corner + 1) % 3];
    const auto leads_there = [&](Index other) {
      return corners(other)[(corner_of(corners(other), from) + 1) % 3] == to;
    };
    const auto found = std::ranges::find_if(stars[from], leads_there);
    return found == stars[from].end() ? no_index : *found;
  }

  /// The corners of two triangles beside an edge from b to c: a and d lie opposite to it.
  std::array<Index, 4> quad(Index t, Index other, std::size_t k) const {
    const Corners& own = corners(t);
    const Index b = own[(k + 1) % 3];
    return {own[k], b, own[(k + 2) % 3], corners(other)[(corner_of(corners(other), b) + 1) % 3]};
  }

  /// Outlines and seams that run through a vertex: where triangles of two pieces meet.
  FeatureLine line_through(Index v) const {
    FeatureLine line;
    for (const auto& [to, left, right] : spokes(v)) {
      if (side(left) == side(right)) continue;
      line.ends.push_back(to);
      if (side(left) / 2 == side(right) / 2) line.slack = most_off_outline;
    }
    return line;
  }

  /// The new triangles take the places of removed ones.
  void apply(const Exchange& exchange) {
    for (const Index t : exchange.removed) {
      for (const Index v : corners(t)) std::erase(stars[v], t);
      triangles[t].corners.fill(no_index);
    }
    if (exchange.moved != no_index) positions[exchange.moved] = exchange.place;
    for (std::size_t k = 0; k < exchange.added.size(); ++k) {
      const Index t = exchange.removed[k];
      triangles[t] = exchange.added[k];
      changed[t] = 1;
      for (const Index v : corners(t)) stars[v].push_back(t);
    }
  }
};

/// What mends a triangle best, of what was considered.
struct Mending {
  const UnionTriangles& mesh;
  const std::vector<std::uint8_t>& kept;
  Exchange best{};
  double sharpness = 1;          ///< what the sharpest triangle there has then
  double gain = least_widening;  ///< by how much the sharpest triangle there is sharper before
};

std::array<Vec3, 3> points_after(const UnionTriangles& mesh, const Exchange& exchange, const Corners& corners) {
  std::array<Vec3, 3> points = mesh.points_of(corners);
  for (std::size_t k = 0; k < 3; ++k) {
    if (corners[k] == exchange.moved) points[k] = exchange.place;
  }
  return points;
}

/// Whether triangles face the way that those of the same piece did, and fronts the viewer.
bool faces_alike(const UnionTriangles& mesh, const Exchange& exchange) {
  std::map<Index, Vec3> before;
  for (const Index t : exchange.removed) {
    before.try_emplace(mesh.side(t), Vec3::Zero()).first->second += normal_of(mesh.points_of(mesh.corners(t)));
  }
  for (auto& [side, sum] : before) sum.normalize();
  return std::ranges::all_of(exchange.added, [&](const SidedTriangle& triangle) {
    const Vec3 own = normal_of(points_after(mesh, exchange, triangle.corners));
    const bool is_turned = own.dot(before.at(triangle.side)) < least_turned * own.norm();
    return !is_turned && (own.z() > 0) == (triangle.side % 2 == 1);
  });
}

/// Whether what is added lies near enough to the surface given; sets how near.
bool stays_near(const UnionTriangles& mesh, Exchange& exchange) {
  Triangles before, after;
  double off = 0;
  for (const Index t : exchange.removed) {
    before.push_back(mesh.points_of(mesh.corners(t)));
    off = std::max(off, mesh.triangles[t].off);
  }
  for (const SidedTriangle& triangle : exchange.added) after.push_back(points_after(mesh, exchange, triangle.corners));
  double longest = 0;
  for (const auto& [a, b, c] : before) longest = std::max({longest, (b - a).norm(), (c - b).norm(), (a - c).norm()});
  const double allowed = std::min(most_moved * longest, most_off_surface * longest - off);
  const double moved = farthest(before, after, farthest(after, before, 0, allowed), allowed);
  for (SidedTriangle& triangle : exchange.added) triangle.off = off + moved;
  return moved <= allowed;
}

void consider(Exchange exchange, Mending& mending) {
  const UnionTriangles& mesh = mending.mesh;
  double before = -1, after = -1;
  for (const Index t : exchange.removed) before = std::max(before, mesh.sharpness(t));
  for (const SidedTriangle& triangle : exchange.added) {
    const auto [a, b, c] = points_after(mesh, exchange, triangle.corners);
    after = std::max(after, sharpest_cosine(a, b, c));
    if (before - after <= mending.gain) return;
  }
  const auto touches_kept = [&](Index t) {
    return std::ranges::any_of(mesh.corners(t), [&](Index v) { return mending.kept[v] != 0; });
  };
  if (std::ranges::any_of(exchange.removed, touches_kept)) return;
  if (!faces_alike(mesh, exchange) || !stays_near(mesh, exchange)) return;
  mending.gain = before - after;
  mending.sharpness = after;
  mending.best = std::move(exchange);
}

void consider_flip(Index t, std::size_t k, Mending& mending) {
  const UnionTriangles& mesh = mending.mesh;
  const Index other = mesh.beyond(t, k);
  const Index side = mesh.side(t);
  if (mesh.side(other) != side) return;
  const auto [a, b, c, d] = mesh.quad(t, other, k);
  if (!mesh.joins(a, d)) consider({{t, other}, {{{a, b, d}, side}, {{a, d, c}, side}}, no_index, {}}, mending);
}

void consider_collapse(Index from, Index to, Mending& mending) {
  const UnionTriangles& mesh = mending.mesh;
  const auto [ends, slack] = mesh.line_through(from);
  if (!ends.empty() && (ends.size() != 2 || (ends[0] != to && ends[1] != to))) return;
  if (!ends.empty() && off_segment(mesh.positions[from], mesh.positions[ends[0]], mesh.positions[ends[1]]) > slack) {
    return;
  }
  const std::vector<Spoke> spokes = mesh.spokes(from);
  const auto is_common = [to = to, &mesh](const Spoke& spoke) { return spoke.to != to && mesh.joins(spoke.to, to); };
  if (std::ranges::count_if(spokes, is_common) != 2) return;
  Exchange exchange{mesh.stars[from], {}, no_index, Vec3::Zero()};
  for (const Index t : exchange.removed) {
    Corners corners = mesh.corners(t);
    if (has_corner(corners, to)) continue;
    corners[corner_of(corners, from)] = to;
    exchange.added.push_back({corners, mesh.side(t)});
  }
  consider(std::move(exchange), mending);
}

void consider_move(Index v, const Vec3& place, Mending& mending) {
  const UnionTriangles& mesh = mending.mesh;
  Exchange exchange{mesh.stars[v], {}, v, place};
  for (const Index t : exchange.removed) exchange.added.push_back({mesh.corners(t), mesh.side(t)});
  consider(std::move(exchange), mending);
}

/// Of the triangles around a vertex.
Vec3 foot_on_star(const UnionTriangles& mesh, Index v, const Vec3& place) {
  TriangleFoot best;
  for (const Index t : mesh.stars[v]) {
    const TriangleFoot foot = foot_on_triangle(mesh.points_of(mesh.corners(t)), place);
    if (foot.distance < best.distance) best = foot;
  }
  return best.point;
}

/// Towards the middle of its neighbours, or along the outline or seam that it lies on.
void consider_moves(Index v, Mending& mending) {
  const UnionTriangles& mesh = mending.mesh;
  const Vec3 place = mesh.positions[v];
  const auto [ends, slack] = mesh.line_through(v);
  if (ends.empty()) {
    Vec3 sum = Vec3::Zero();
    for (const Index t : mesh.stars[v]) sum += mesh.positions[mesh.corners(t)[(corner_of(mesh.corners(t), v) + 1) % 3]];
    const Vec3 middle = sum / static_cast<double>(mesh.stars[v].size());
    for (const double share : {1.0, 0.5, 0.25}) {
      consider_move(v, foot_on_star(mesh, v, place + share * (middle - place)), mending);
    }
  } else if (ends.size() == 2) {
    for (const std::size_t end : {0U, 1U}) {
      const Vec3 there = mesh.positions[ends[end]], behind = mesh.positions[ends[1 - end]];
      for (const double share : {0.5, 0.25}) {
        const Vec3 moved = place + share * (there - place);
        if (off_segment(place, moved, behind) <= slack) consider_move(v, moved, mending);
      }
    }
  }
}

/// Moves a corner of a flat triangle onto its opposite edge, which may be of an outline or a seam: the triangle goes,
/// the one beyond the edge is cut in two.
void consider_move_onto_edge(Index t, std::size_t k, Mending& mending) {
  const UnionTriangles& mesh = mending.mesh;
  const Index other = mesh.beyond(t, k);
  const auto [a, b, c, d] = mesh.quad(t, other, k);
  if (!mesh.line_through(a).ends.empty() || mesh.joins(a, d)) return;
  Exchange exchange{mesh.stars[a], {}, a, nearest_on_segment(mesh.positions[a], mesh.positions[b], mesh.positions[c])};
  for (const Index near : exchange.removed) {
    if (near != t) exchange.added.push_back({mesh.corners(near), mesh.side(near)});
  }
  exchange.removed.push_back(other);
  exchange.added.push_back({{a, b, d}, mesh.side(other)});
  exchange.added.push_back({{a, d, c}, mesh.side(other)});
  consider(std::move(exchange), mending);
}

Mending mending_of(const UnionTriangles& mesh, const std::vector<std::uint8_t>& kept, Index t) {
  Mending mending{mesh, kept};
  for (std::size_t k = 0; k < 3; ++k) {
    const Index a = mesh.corners(t)[k], b = mesh.corners(t)[(k + 1) % 3];
    consider_flip(t, k, mending);
    consider_collapse(a, b, mending);
    consider_collapse(b, a, mending);
  }
  for (std::size_t k = 0; k < 3 && mending.sharpness >= sharp_corner; ++k) {
    consider_moves(mesh.corners(t)[k], mending);
    consider_move_onto_edge(t, k, mending);
  }
  return mending;
}

ImprovedUnion written(const UnionTriangles& triangles, const Shell& joined) {
  ImprovedUnion improved{{{}, joined.objects, {}, joined.euler, joined.blends}, {}, {}};
  Shell& surface = improved.surface;
  std::vector<Index> number(triangles.positions.size(), no_index);
  for (Index v = 0; v < number.size(); ++v) {
    if (triangles.stars[v].empty()) continue;
    number[v] = static_cast<Index>(improved.vertices.size());
    improved.vertices.push_back(v);
    surface.mesh.positions.push_back(triangles.positions[v]);
  }
  for (Index t = 0; t < triangles.triangles.size(); ++t) {
    if (triangles.is_dead(t)) continue;
    if (triangles.changed[t]) improved.changed.push_back(static_cast<Index>(surface.face_objects.size()));
    const auto& [a, b, c] = triangles.corners(t);
    surface.mesh.add_triangle(number[a], number[b], number[c]);
    surface.face_objects.push_back(triangles.side(t) / 2);
  }
  return improved;
}

}  // namespace

ImprovedUnion improve_union(const Shell& joined, const std::vector<std::uint8_t>& kept, Progress& progress) {
  UnionTriangles mesh(joined);
  SlenderTriangles slender(mesh.triangles.size(), sharp_corner, most_looks * mesh.triangles.size());
  for (Index t = 0; t < mesh.triangles.size(); ++t) slender.add(t, mesh.sharpness(t));
  for (std::size_t looks = 0; const std::optional<Index> t = slender.next(); ++looks) {
    if (looks % triangles_per_check == 0) progress.check();
    if (mesh.is_dead(*t) || mesh.sharpness(*t) < sharp_corner) continue;
    const Exchange best = mending_of(mesh, kept, *t).best;
    if (best.removed.empty()) continue;
    mesh.apply(best);
    for (std::size_t k = 0; k < best.added.size(); ++k) {
      for (const Index v : mesh.corners(best.removed[k])) {
        for (const Index near : mesh.stars[v]) slender.add(near, mesh.sharpness(near));
      }
    }
  }
  return written(mesh, joined);
}

}  // namespace croquis::silhouette

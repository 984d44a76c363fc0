// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <Eigen/Geometry>

#include "algorithms/silhouette/surface/sheet_mesh.h"
#include "algorithms/silhouette/surface/triangle_shape.h"

namespace croquis::silhouette {
namespace {

using Corners = std::array<Index, 3>;

constexpr double slender = 0.9272;     // cosine of 22 degrees: triangles with a smaller angle are mended
constexpr double least_gain = 0.004;   // of the cosine
constexpr std::size_t max_rounds = 6;  // changes, in parts of the triangles; never met, a bound against endless ones
constexpr std::size_t changes_per_check = 1024;

/// How far the surface may move along its normal, in parts of the edges there.
constexpr double most_deviation = 0.025;

/// Of the height of a triangle in the plane over its longest side: thinner ones might turn over by rounding.
constexpr double least_flatness = 1e-3;

constexpr double straight = 1e-6;        // of a rim edge: what is nearer to a line lies on it
constexpr double least_rim_bend = 0.98;  // cosine: edges to the rim are bent inwards no further
constexpr double least_alike = 0.93;     // cosine: no triangle turns further from what was there

/// Of the front and the back of a sheet.
constexpr std::array both_sides{true, false};

/// The sheets in space, with what is needed to find and change the triangles around a vertex.
struct SheetTriangles {
  SheetMesh& mesh;
  std::vector<Index> at;                   ///< per vertex one of its triangles
  std::vector<double> sharpness;           ///< per triangle: cosine of its smallest angle, on the front and on the back
  std::array<std::vector<Vec3>, 2> place;  ///< per vertex, of the back (0) and the front (1)

  explicit SheetTriangles(SheetMesh& sheets) : mesh(sheets), at(sheets.place.size(), no_index) {
    for (Index t = 0; t < mesh.triangles.size(); ++t) {
      for (const Index v : mesh.triangles[t]) at[v] = t;
    }
    sharpness.resize(mesh.triangles.size());
    for (Index v = 0; v < mesh.place.size(); ++v) {
      place[0].emplace_back(mesh.place[v].x(), mesh.place[v].y(), mesh.back(v));
      place[1].emplace_back(mesh.place[v].x(), mesh.place[v].y(), mesh.front(v));
    }
  }

  bool is_dead(Index t) const { return mesh.triangles[t][0] == no_index; }
  const Vec3& on(bool in_front, Index v) const { return place[in_front ? 1 : 0][v]; }
  double height(bool in_front, Index v) const { return on(in_front, v).z(); }

  /// Whether an edge may join the two: front and back would share one between rim vertices.
  bool joinable(Index a, Index b) const { return !mesh.on_boundary[a] || !mesh.on_boundary[b]; }

  /// As long as twice the area.
  Vec3 normal(const Corners& t, bool in_front) const {
    const Vec3& origin = on(in_front, t[0]);
    return (on(in_front, t[1]) - origin).cross(on(in_front, t[2]) - origin);
  }

  double longest_edge(const Corners& t, bool in_front) const {
    const Vec3 &a = on(in_front, t[0]), &b = on(in_front, t[1]), &c = on(in_front, t[2]);
    return std::sqrt(std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()}));
  }

  /// Cosine of the slope.
  double levelness(const Corners& t, bool in_front) const {
    const Vec3 across = normal(t, in_front);
    return std::abs(across.z()) / across.norm();
  }

  double sharpness_of(const Corners& t) const {
    const auto on_side = [&](bool in_front) {
      return sharpest_cosine(on(in_front, t[0]), on(in_front, t[1]), on(in_front, t[2]));
    };
    return std::max(on_side(true), on_side(false));
  }

  double twice_area(const Corners& t) const {
    return cross(mesh.place[t[1]] - mesh.place[t[0]], mesh.place[t[2]] - mesh.place[t[0]]);
  }

  bool keeps_sense(const Corners& t) const {
    double longest = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      longest = std::max(longest, (mesh.place[t[k]] - mesh.place[t[(k + 1) % 3]]).squaredNorm());
    }
    return twice_area(t) > least_flatness * longest;
  }

  std::size_t side_towards(Index t, Index other) const { return corner_of(mesh.neighbours[t], other); }

  void replace_neighbour(Index t, Index from, Index to) {
    if (t != no_index) mesh.neighbours[t][side_towards(t, from)] = to;
  }

  Index turned(Index t, Index v, std::size_t to) const {
    return mesh.neighbours[t][(corner_of(mesh.triangles[t], v) + to) % 3];
  }

  /// Finds the triangles around a vertex, counter-clockwise; on the rim from one of its edges to the other.
  void collect_star(Index v, std::vector<Index>& star) const {
    star.clear();
    Index first = at[v];
    while (mesh.on_boundary[v] && turned(first, v, 2) != no_index) first = turned(first, v, 2);
    for (Index t = first;;) {
      star.push_back(t);
      t = turned(t, v, 1);
      if (t == no_index || t == first) return;
    }
  }
};

/// How far a change moves the front and the back of a sheet, at most.
struct Moved {
  double front = 0;
  double back = 0;

  void add(double distance, bool in_front) {
    double& most = in_front ? front : back;
    most = std::max(most, distance);
  }

  bool fits(const SheetClearance& clearance) const { return front <= clearance.front && back <= clearance.back; }

  SheetClearance left_of(const SheetClearance& clearance) const {
    return {clearance.front - front, clearance.back - back};
  }
};

/// What would mend a triangle.
struct Change {
  double gain = least_gain;   ///< by how much the sharpest triangle there is sharper before
  Index triangle = no_index;  ///< of a flip: its edge is opposite to the corner
  std::size_t corner = 0;
  Index from = no_index;  ///< of a collapse: the vertex that goes
  Index to = no_index;    ///< and the one that it goes to
  Moved moved{};          ///< along z
};

/// Whether triangles face the way that those before did, on both sides.
template <typename Before, typename After>
bool face_alike(const SheetTriangles& sheets, const Before& before, const After& after) {
  for (const bool in_front : both_sides) {
    Vec3 sum = Vec3::Zero();
    for (const Corners& t : before) sum += sheets.normal(t, in_front);
    sum.normalize();
    for (const Corners& t : after) {
      const Vec3 own = sheets.normal(t, in_front);
      if (own.dot(sum) < least_alike * own.norm()) return false;
    }
  }
  return true;
}

/// Whether the surface is bent inwards along the edge from the first's corner 0 to its corner 2.
bool is_notch(const SheetTriangles& sheets, const Corners& first, const Corners& second) {
  for (const bool in_front : both_sides) {
    const Vec3 own = sheets.normal(first, in_front), other = sheets.normal(second, in_front);
    const Vec3 across = sheets.on(in_front, second[2]) - sheets.on(in_front, first[0]);
    const bool inwards = (own.dot(across) > 0) == in_front;
    if (inwards && own.dot(other) < least_rim_bend * own.norm() * other.norm()) return true;
  }
  return false;
}

void consider_flip(const SheetTriangles& sheets, Index t, std::size_t k, Change& best) {
  const SheetMesh& mesh = sheets.mesh;
  const Index o = mesh.neighbours[t][k];
  if (o == no_index) return;
  const Corners &own = mesh.triangles[t], &other = mesh.triangles[o];
  const Index a = own[k], b = own[(k + 1) % 3], c = own[(k + 2) % 3], d = other[sheets.side_towards(o, t)];
  if (!sheets.joinable(a, d)) return;
  const Corners first{a, b, d}, second{a, d, c};
  if (!sheets.keeps_sense(first) || !sheets.keeps_sense(second)) return;
  const double before = std::max(sheets.sharpness[t], sheets.sharpness[o]);
  const double after = sheets.sharpness_of(first);
  if (before - after <= best.gain) return;
  const double gain = before - std::max(after, sheets.sharpness_of(second));
  if (gain <= best.gain) return;
  // Where the diagonals cross.
  const Vec2 along = mesh.place[d] - mesh.place[a];
  const Vec2 across = mesh.place[c] - mesh.place[b];
  const Vec2 offset = mesh.place[b] - mesh.place[a];
  const double s = cross(offset, across) / cross(along, across);
  const double r = cross(offset, along) / cross(along, across);
  Moved moved;
  for (const bool in_front : both_sides) {
    const auto z = [&](Index v) { return sheets.height(in_front, v); };
    const double off = std::abs((1 - s) * z(a) + s * z(d) - (1 - r) * z(b) - r * z(c));
    const double edge = (sheets.on(in_front, b) - sheets.on(in_front, c)).norm();
    if (off * sheets.levelness(own, in_front) > most_deviation * edge) return;
    moved.add(off, in_front);
  }
  if (!moved.fits(common_clearance(mesh.clearance[t], mesh.clearance[o]))) return;
  if (!face_alike(sheets, std::array{own, other}, std::array{first, second})) return;
  if ((mesh.on_boundary[a] || mesh.on_boundary[d]) && is_notch(sheets, first, second)) return;
  best = {gain, t, k, no_index, no_index, moved};
}

/// Two triangles that share an edge share the other diagonal then.
void flip(const Change& change, SheetTriangles& sheets) {
  SheetMesh& mesh = sheets.mesh;
  const Index t = change.triangle;
  const std::size_t k = change.corner;
  const Index o = mesh.neighbours[t][k];
  const Corners own = mesh.triangles[t], other = mesh.triangles[o];
  const Corners near_own = mesh.neighbours[t], near_other = mesh.neighbours[o];
  const Index a = own[k], b = own[(k + 1) % 3], c = own[(k + 2) % 3], d = other[sheets.side_towards(o, t)];
  // Across from b and c in the first, from c and b in the second one.
  const Index ca = near_own[(k + 1) % 3], ab = near_own[(k + 2) % 3];
  const Index bd = near_other[corner_of(other, c)], dc = near_other[corner_of(other, b)];
  mesh.triangles[t] = {a, b, d};
  mesh.neighbours[t] = {bd, o, ab};
  mesh.triangles[o] = {a, d, c};
  mesh.neighbours[o] = {dc, ca, t};
  sheets.replace_neighbour(bd, o, t);
  sheets.replace_neighbour(ca, t, o);
  sheets.at[a] = sheets.at[b] = sheets.at[d] = t;
  sheets.at[c] = o;
  mesh.clearance[t] = mesh.clearance[o] = change.moved.left_of(common_clearance(mesh.clearance[t], mesh.clearance[o]));
}

/// Whether a rim vertex lies on the line between its neighbours on the rim, and the edge leads to one of them.
/// @param star of `from`
bool is_straight_rim(const SheetMesh& mesh, const std::vector<Index>& star, Index from, Index to) {
  const Corners &first = mesh.triangles[star.front()], &last = mesh.triangles[star.back()];
  const Index next = first[(corner_of(first, from) + 1) % 3];
  const Index previous = last[(corner_of(last, from) + 2) % 3];
  if (to != next && to != previous) return false;
  const Vec2 along = mesh.place[next] - mesh.place[previous];
  return std::abs(cross(along, mesh.place[from] - mesh.place[previous])) < straight * along.squaredNorm();
}

/// Adds the distances along z where edges from the vertex that goes cross those from the one that stays.
void add_moved_on_spokes(const SheetTriangles& sheets, const std::vector<Index>& star, Index from, Index to,
                         Moved& moved) {
  const SheetMesh& mesh = sheets.mesh;
  const auto spoke_of = [&](Index t) {
    const Corners& own = mesh.triangles[t];
    return own[(corner_of(own, from) + 1) % 3];
  };
  for (const Index t : star) {
    const Index spoke = spoke_of(t);
    if (spoke == to) continue;
    for (const Index other : star) {
      const Index far = spoke_of(other);
      if (far == to || far == spoke) continue;
      const Vec2 along = mesh.place[far] - mesh.place[to];
      const Vec2 across = mesh.place[spoke] - mesh.place[from];
      const Vec2 offset = mesh.place[from] - mesh.place[to];
      const double turn = cross(along, across);
      if (turn == 0) continue;
      const double s = cross(offset, across) / turn;
      const double r = cross(offset, along) / turn;
      if (s < 0 || s > 1 || r < 0 || r > 1) continue;
      for (const bool in_front : both_sides) {
        const auto z = [&](Index v) { return sheets.height(in_front, v); };
        moved.add(std::abs((1 - s) * z(to) + s * z(far) - (1 - r) * z(from) - r * z(spoke)), in_front);
      }
    }
  }
}

/// How far the surface moves up or down; none if that is too far along its normal.
/// @param after the triangles of the star that are left, with the vertex that stays
std::optional<Moved> moved_by_collapse(const SheetTriangles& sheets, const std::vector<Corners>& after, Index from) {
  const SheetMesh& mesh = sheets.mesh;
  Moved moved;
  for (const Corners& corners : after) {
    const double area = sheets.twice_area(corners);
    std::array<double, 3> w{};
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec2& p = mesh.place[corners[(k + 1) % 3]];
      const Vec2& q = mesh.place[corners[(k + 2) % 3]];
      w[k] = cross(p - mesh.place[from], q - mesh.place[from]) / area;
    }
    if (std::min({w[0], w[1], w[2]}) < -1e-9) continue;
    for (const bool in_front : both_sides) {
      double height = 0;
      for (std::size_t k = 0; k < 3; ++k) height += w[k] * sheets.height(in_front, corners[k]);
      const double off = std::abs(height - sheets.height(in_front, from));
      moved.add(off, in_front);
      if (off * sheets.levelness(corners, in_front) > most_deviation * sheets.longest_edge(corners, in_front)) {
        return std::nullopt;
      }
    }
  }
  return moved;
}

/// Whether an edge to the rim would be bent inwards after a collapse.
bool makes_notch(const SheetTriangles& sheets, const std::vector<Index>& star, Index from, Index to) {
  const SheetMesh& mesh = sheets.mesh;
  const auto after = [&](Index t) {
    const Corners& corners = mesh.triangles[t];
    const std::size_t k = corner_of(corners, from);
    return Corners{to, corners[(k + 1) % 3], corners[(k + 2) % 3]};
  };
  for (std::size_t i = 0; i < star.size(); ++i) {
    if (mesh.on_boundary[from] && i + 1 == star.size()) break;
    const Corners first = after(star[i]), second = after(star[(i + 1) % star.size()]);
    if (first[1] == to || first[2] == to || second[2] == to) continue;
    if ((mesh.on_boundary[to] || mesh.on_boundary[first[2]]) && is_notch(sheets, first, second)) return true;
  }
  return false;
}

/// @param star of `from`
void consider_collapse(const SheetTriangles& sheets, const std::vector<Index>& star, Index from, Index to,
                       Change& best) {
  const SheetMesh& mesh = sheets.mesh;
  const bool on_rim = mesh.on_boundary[from] != 0;
  if (on_rim && !mesh.on_boundary[to]) return;
  if (on_rim && !is_straight_rim(mesh, star, from, to)) return;
  double sharp_before = -1, sharp_after = -1;
  SheetClearance clearance;
  for (const Index t : star) sharp_before = std::max(sharp_before, sheets.sharpness[t]);
  std::vector<Corners> before, after;
  for (const Index t : star) {
    Corners corners = before.emplace_back(mesh.triangles[t]);
    clearance = common_clearance(clearance, mesh.clearance[t]);
    if (has_corner(corners, to)) continue;
    const std::size_t k = corner_of(corners, from);
    if (!on_rim && (!sheets.joinable(to, corners[(k + 1) % 3]) || !sheets.joinable(to, corners[(k + 2) % 3]))) return;
    corners[k] = to;
    if (!sheets.keeps_sense(corners)) return;
    sharp_after = std::max(sharp_after, sheets.sharpness_of(corners));
    if (sharp_before - sharp_after <= best.gain) return;
    after.push_back(corners);
  }
  if (before.size() - after.size() != (on_rim ? 1 : 2) || star.size() < (on_rim ? 2 : 4)) return;
  if (sharp_before - sharp_after <= best.gain) return;
  std::optional<Moved> moved = moved_by_collapse(sheets, after, from);
  if (!moved) return;
  if (std::isfinite(clearance.least())) add_moved_on_spokes(sheets, star, from, to, *moved);
  if (!moved->fits(clearance) || !face_alike(sheets, before, after)) return;
  if (makes_notch(sheets, star, from, to)) return;
  best = {sharp_before - sharp_after, no_index, 0, from, to, *moved};
}

/// @param star of the vertex that goes
void collapse(const Change& change, const std::vector<Index>& star, SheetTriangles& sheets) {
  SheetMesh& mesh = sheets.mesh;
  SheetClearance clearance;
  for (const Index t : star) clearance = common_clearance(clearance, mesh.clearance[t]);
  for (const Index t : star) {
    Corners& corners = mesh.triangles[t];
    const std::size_t k = corner_of(corners, change.from);
    if (!has_corner(corners, change.to)) {
      corners[k] = change.to;
      mesh.clearance[t] = change.moved.left_of(clearance);
      continue;
    }
    // The two triangles beside it become neighbours.
    const Index outer = mesh.neighbours[t][k];
    const Index inner = mesh.neighbours[t][corner_of(corners, change.to)];
    sheets.replace_neighbour(outer, t, inner);
    sheets.replace_neighbour(inner, t, outer);
    corners.fill(no_index);
  }
  for (const Index t : star) {
    if (sheets.is_dead(t)) continue;
    for (const Index v : mesh.triangles[t]) sheets.at[v] = t;
  }
}

void remove_dead(const SheetTriangles& sheets) {
  SheetMesh& mesh = sheets.mesh;
  std::vector<Index> number(mesh.triangles.size(), no_index);
  Index count = 0;
  for (Index t = 0; t < number.size(); ++t) {
    if (!sheets.is_dead(t)) number[t] = count++;
  }
  for (Index t = 0; t < number.size(); ++t) {
    if (number[t] == no_index) continue;
    mesh.triangles[number[t]] = mesh.triangles[t];
    mesh.objects[number[t]] = mesh.objects[t];
    mesh.clearance[number[t]] = mesh.clearance[t];
    for (std::size_t k = 0; k < 3; ++k) {
      const Index other = mesh.neighbours[t][k];
      mesh.neighbours[number[t]][k] = other == no_index ? no_index : number[other];
    }
  }
  mesh.triangles.resize(count);
  mesh.neighbours.resize(count);
  mesh.objects.resize(count);
  mesh.clearance.resize(count);
}

}  // namespace

void improve_triangles(SheetMesh& mesh, Progress& progress) {
  SheetTriangles sheets(mesh);
  SlenderTriangles waiting(mesh.triangles.size(), slender, max_rounds * mesh.triangles.size());
  std::vector<Index> star;
  const auto rate = [&](Index t) {
    sheets.sharpness[t] = sheets.sharpness_of(mesh.triangles[t]);
    waiting.add(t, sheets.sharpness[t]);
  };
  // What couldn't be mended before may be so now.
  const auto rate_around = [&](Index t) {
    for (const Index v : mesh.triangles[t]) {
      sheets.collect_star(v, star);
      for (const Index near : star) waiting.add(near, sheets.sharpness[near]);
    }
  };
  for (Index t = 0; t < mesh.triangles.size(); ++t) rate(t);
  for (std::size_t looks = 0; const std::optional<Index> t = waiting.next(); ++looks) {
    if (looks % changes_per_check == 0) progress.check();
    if (sheets.is_dead(*t) || sheets.sharpness[*t] < slender) continue;
    Change best;
    for (std::size_t k = 0; k < 3; ++k) consider_flip(sheets, *t, k, best);
    const Corners corners = mesh.triangles[*t];
    for (std::size_t k = 0; k < 3; ++k) {
      sheets.collect_star(corners[k], star);
      consider_collapse(sheets, star, corners[k], corners[(k + 1) % 3], best);
      consider_collapse(sheets, star, corners[k], corners[(k + 2) % 3], best);
    }
    if (best.triangle != no_index) {
      const Index other = mesh.neighbours[best.triangle][best.corner];
      flip(best, sheets);
      for (const Index changed : {best.triangle, other}) rate(changed);
      rate_around(best.triangle);
    } else if (best.from != no_index) {
      sheets.collect_star(best.from, star);
      collapse(best, star, sheets);
      for (const Index changed : star) {
        if (!sheets.is_dead(changed)) rate(changed);
      }
      rate_around(sheets.at[best.to]);
    }
  }
  remove_dead(sheets);
}

}  // namespace croquis::silhouette

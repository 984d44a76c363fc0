// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/surface/sheet_improvement.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <Eigen/Geometry>

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

/// How far a change moves the front and the back of a sheet, at most.
struct Moved {
  double front = 0;
  double back = 0;

  void add(double distance, bool in_front) {
    double& most = in_front ? front : back;
    most = std::max(most, distance);
  }

  bool fits(const SheetRoom& room) const { return front <= room.front && back <= room.back; }

  SheetRoom left_of(const SheetRoom& room) const { return {room.front - front, room.back - back}; }
};

class SheetImprover {
 public:
  explicit SheetImprover(SheetMesh& mesh)
      : mesh_(mesh),
        at_(mesh.place.size(), no_index),
        sharpness_(mesh.triangles.size(), 0.0),
        waits_(mesh.triangles.size(), 0) {
    for (Index t = 0; t < mesh_.triangles.size(); ++t) {
      for (const Index v : mesh_.triangles[t]) at_[v] = t;
    }
    front_.reserve(mesh.place.size());
    back_.reserve(mesh.place.size());
    for (std::size_t v = 0; v < mesh.place.size(); ++v) {
      const Vec2& place = mesh.place[v];
      front_.emplace_back(place.x(), place.y(), mesh.z[v] + mesh.thickness[v]);
      back_.emplace_back(place.x(), place.y(), mesh.z[v] - mesh.thickness[v]);
    }
  }

  void run(Progress& progress) {
    for (Index t = 0; t < mesh_.triangles.size(); ++t) rate(t);
    const std::size_t most = max_rounds * mesh_.triangles.size();
    for (std::size_t head = 0; head < std::min(waiting_.size(), most); ++head) {
      if (head % changes_per_check == 0) progress.check();
      const Index t = waiting_[head];
      waits_[t] = 0;
      if (!is_dead(t) && sharpness_[t] >= slender) mend(t);
    }
    remove_dead();
  }

 private:
  enum class Kind { None, Flip, Collapse };

  /// What would mend a triangle.
  struct Change {
    double gain = least_gain;  ///< by how much the sharpest triangle there is sharper before
    Kind kind = Kind::None;
    Index triangle = 0;  ///< of a flip: its edge is opposite to the corner
    std::size_t corner = 0;
    Index from = no_index;  ///< of a collapse: the vertex that goes
    Index to = no_index;    ///< and the one that it goes to
    Moved moved{};          ///< along z
  };

  bool is_dead(Index t) const { return mesh_.triangles[t][0] == no_index; }

  const Vec3& front(Index v) const { return front_[v]; }
  const Vec3& back(Index v) const { return back_[v]; }
  const Vec3& at(Index v, bool in_front) const { return in_front ? front_[v] : back_[v]; }

  /// Cosine of the smallest angle, on the front and on the back.
  double sharpness(const Corners& t) const {
    return std::max(sharpest_cosine(front(t[0]), front(t[1]), front(t[2])),
                    sharpest_cosine(back(t[0]), back(t[1]), back(t[2])));
  }

  /// After every change of a triangle.
  void rate(Index t) {
    sharpness_[t] = sharpness(mesh_.triangles[t]);
    wake(t);
  }

  void wake(Index t) {
    if (sharpness_[t] < slender || waits_[t] != 0) return;
    waits_[t] = 1;
    waiting_.push_back(t);
  }

  /// What couldn't be mended before may be so now.
  void wake_around(Index t) {
    for (const Index v : mesh_.triangles[t]) {
      collect_star(v);
      for (const Index near : star_) wake(near);
    }
  }

  double twice_area(const Corners& t) const {
    return cross(mesh_.place[t[1]] - mesh_.place[t[0]], mesh_.place[t[2]] - mesh_.place[t[0]]);
  }

  bool keeps_sense(const Corners& t) const {
    double longest = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      longest = std::max(longest, (mesh_.place[t[k]] - mesh_.place[t[(k + 1) % 3]]).squaredNorm());
    }
    return twice_area(t) > least_flatness * longest;
  }

  /// Whether an edge may join the two: front and back would share one between rim vertices.
  bool joinable(Index a, Index b) const { return !mesh_.on_boundary[a] || !mesh_.on_boundary[b]; }

  static std::size_t corner_of(const Corners& t, Index v) { return t[0] == v ? 0 : t[1] == v ? 1 : 2; }

  std::size_t side_towards(Index t, Index other) const { return corner_of(mesh_.neighbours[t], other); }

  void mend(Index t) {
    Change best;
    for (std::size_t k = 0; k < 3; ++k) consider_flip(t, k, best);
    const Corners corners = mesh_.triangles[t];
    for (std::size_t k = 0; k < 3; ++k) {
      collect_star(corners[k]);
      consider_collapse(corners[k], corners[(k + 1) % 3], best);
      consider_collapse(corners[k], corners[(k + 2) % 3], best);
    }
    if (best.kind == Kind::Flip) flip(best);
    if (best.kind == Kind::Collapse) collapse(best);
  }

  void consider_flip(Index t, std::size_t k, Change& best) const {
    const Index o = mesh_.neighbours[t][k];
    if (o == no_index) return;
    const Corners& own = mesh_.triangles[t];
    const Index a = own[k], b = own[(k + 1) % 3], c = own[(k + 2) % 3];
    const Index d = mesh_.triangles[o][side_towards(o, t)];
    if (!joinable(a, d)) return;
    const Corners first{a, b, d}, second{a, d, c};
    if (!keeps_sense(first) || !keeps_sense(second)) return;
    const double before = std::max(sharpness_[t], sharpness_[o]);
    const double after = sharpness(first);
    if (before - after <= best.gain) return;
    const double gain = before - std::max(after, sharpness(second));
    if (gain <= best.gain) return;
    // Where the diagonals cross.
    const Vec2 along = mesh_.place[d] - mesh_.place[a];
    const Vec2 across = mesh_.place[c] - mesh_.place[b];
    const Vec2 offset = mesh_.place[b] - mesh_.place[a];
    const double s = cross(offset, across) / cross(along, across);
    const double r = cross(offset, along) / cross(along, across);
    const double up = std::abs((1 - s) * front(a).z() + s * front(d).z() - (1 - r) * front(b).z() - r * front(c).z());
    const double down = std::abs((1 - s) * back(a).z() + s * back(d).z() - (1 - r) * back(b).z() - r * back(c).z());
    const Moved moved{up, down};
    if (!moved.fits(common_room(mesh_.room[t], mesh_.room[o]))) return;
    if (up * levelness(own, true) > most_deviation * (front(b) - front(c)).norm()) return;
    if (down * levelness(own, false) > most_deviation * (back(b) - back(c)).norm()) return;
    if (!face_alike(std::array{own, mesh_.triangles[o]}, std::array{first, second})) return;
    if ((mesh_.on_boundary[a] || mesh_.on_boundary[d]) && is_notch(first, second)) return;
    best = {gain, Kind::Flip, t, k, no_index, no_index, moved};
  }

  /// As long as twice the area.
  Vec3 normal(const Corners& t, bool in_front) const {
    const Vec3& origin = at(t[0], in_front);
    return (at(t[1], in_front) - origin).cross(at(t[2], in_front) - origin);
  }

  double longest_edge(const Corners& t, bool in_front) const {
    const Vec3 &a = at(t[0], in_front), &b = at(t[1], in_front), &c = at(t[2], in_front);
    return std::sqrt(std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()}));
  }

  /// Cosine of the slope.
  double levelness(const Corners& t, bool in_front) const {
    const Vec3 across = normal(t, in_front);
    return std::abs(across.z()) / across.norm();
  }

  /// Whether triangles face the way that those before did, on both sides.
  template <typename Before, typename After>
  bool face_alike(const Before& before, const After& after) const {
    for (const bool in_front : {true, false}) {
      Vec3 sum = Vec3::Zero();
      for (const Corners& t : before) sum += normal(t, in_front);
      sum.normalize();
      for (const Corners& t : after) {
        const Vec3 own = normal(t, in_front);
        if (own.dot(sum) < least_alike * own.norm()) return false;
      }
    }
    return true;
  }

  void flip(const Change& change) {
    const Index t = change.triangle;
    const std::size_t k = change.corner;
    const Index o = mesh_.neighbours[t][k];
    const std::size_t j = side_towards(o, t);
    const Corners own = mesh_.triangles[t], other = mesh_.triangles[o];
    const Corners near_own = mesh_.neighbours[t], near_other = mesh_.neighbours[o];
    const Index a = own[k], b = own[(k + 1) % 3], c = own[(k + 2) % 3], d = other[j];
    // Across from b and c in the first, from c and b in the second one.
    const Index ca = near_own[(k + 1) % 3], ab = near_own[(k + 2) % 3];
    const Index bd = near_other[corner_of(other, c)], dc = near_other[corner_of(other, b)];
    mesh_.triangles[t] = {a, b, d};
    mesh_.neighbours[t] = {bd, o, ab};
    mesh_.triangles[o] = {a, d, c};
    mesh_.neighbours[o] = {dc, ca, t};
    replace_neighbour(bd, o, t);
    replace_neighbour(ca, t, o);
    at_[a] = at_[b] = at_[d] = t;
    at_[c] = o;
    mesh_.room[t] = mesh_.room[o] = change.moved.left_of(common_room(mesh_.room[t], mesh_.room[o]));
    rate(t);
    rate(o);
    wake_around(t);
  }

  void replace_neighbour(Index t, Index from, Index to) {
    if (t != no_index) mesh_.neighbours[t][side_towards(t, from)] = to;
  }

  Index turned(Index t, Index v, std::size_t to) const {
    return mesh_.neighbours[t][(corner_of(mesh_.triangles[t], v) + to) % 3];
  }

  /// The triangles around a vertex, counter-clockwise; on the rim from one of its edges to the other.
  void collect_star(Index v) {
    star_.clear();
    Index first = at_[v];
    while (mesh_.on_boundary[v] && turned(first, v, 2) != no_index) first = turned(first, v, 2);
    for (Index t = first;;) {
      star_.push_back(t);
      t = turned(t, v, 1);
      if (t == no_index || t == first) return;
    }
  }

  /// Whether a rim vertex lies on the line between its neighbours on the rim, and the edge leads to one of them.
  /// @pre collect_star(from)
  bool is_straight_rim(Index from, Index to) const {
    const Corners& first = mesh_.triangles[star_.front()];
    const Corners& last = mesh_.triangles[star_.back()];
    const Index next = first[(corner_of(first, from) + 1) % 3];
    const Index previous = last[(corner_of(last, from) + 2) % 3];
    if (to != next && to != previous) return false;
    const Vec2 along = mesh_.place[next] - mesh_.place[previous];
    return std::abs(cross(along, mesh_.place[from] - mesh_.place[previous])) < straight * along.squaredNorm();
  }

  /// @pre collect_star(from)
  void consider_collapse(Index from, Index to, Change& best) {
    const bool on_rim = mesh_.on_boundary[from] != 0;
    if (on_rim && !mesh_.on_boundary[to]) return;
    if (on_rim && !is_straight_rim(from, to)) return;
    double before = -1, after = -1;
    SheetRoom room;
    for (const Index t : star_) before = std::max(before, sharpness_[t]);
    int shared = 0;
    for (const Index t : star_) {
      Corners corners = mesh_.triangles[t];
      room = common_room(room, mesh_.room[t]);
      const std::size_t k = corner_of(corners, from);
      const Index b = corners[(k + 1) % 3], c = corners[(k + 2) % 3];
      if (b == to || c == to) {
        ++shared;
        continue;
      }
      if (!on_rim && (!joinable(to, b) || !joinable(to, c))) return;
      corners[k] = to;
      if (!keeps_sense(corners)) return;
      after = std::max(after, sharpness(corners));
      if (before - after <= best.gain) return;
    }
    if (shared != (on_rim ? 1 : 2) || star_.size() < (on_rim ? 2 : 4) || before - after <= best.gain) return;
    const std::optional<Moved> moved = moved_by_collapse(from, to, std::isfinite(room.least()));
    if (!moved || !moved->fits(room)) return;
    if (!faces_alike_after(from, to) || makes_notch(from, to)) return;
    best = {before - after, Kind::Collapse, 0, 0, from, to, *moved};
  }

  /// Whether the surface is bent inwards along the edge from the first's corner 0 to its corner 2.
  bool is_notch(const Corners& first, const Corners& second) const {
    for (const bool in_front : {true, false}) {
      const Vec3 own = normal(first, in_front), other = normal(second, in_front);
      const Vec3 across = in_front ? front(second[2]) - front(first[0]) : back(second[2]) - back(first[0]);
      const bool inwards = (own.dot(across) > 0) == in_front;
      if (inwards && own.dot(other) < least_rim_bend * own.norm() * other.norm()) return true;
    }
    return false;
  }

  /// Whether an edge to the rim would be bent inwards after a collapse. @pre collect_star(from)
  bool makes_notch(Index from, Index to) const {
    const auto after = [&](Index t) {
      const Corners& corners = mesh_.triangles[t];
      const std::size_t k = corner_of(corners, from);
      return Corners{to, corners[(k + 1) % 3], corners[(k + 2) % 3]};
    };
    for (std::size_t i = 0; i < star_.size(); ++i) {
      if (mesh_.on_boundary[from] && i + 1 == star_.size()) break;
      const Corners first = after(star_[i]), second = after(star_[(i + 1) % star_.size()]);
      if (first[1] == to || first[2] == to || second[2] == to) continue;
      if ((mesh_.on_boundary[to] || mesh_.on_boundary[first[2]]) && is_notch(first, second)) return true;
    }
    return false;
  }

  /// @pre collect_star(from)
  bool faces_alike_after(Index from, Index to) {
    before_.clear();
    after_.clear();
    for (const Index t : star_) {
      Corners corners = mesh_.triangles[t];
      before_.push_back(corners);
      if (corners[0] == to || corners[1] == to || corners[2] == to) continue;
      corners[corner_of(corners, from)] = to;
      after_.push_back(corners);
    }
    return face_alike(before_, after_);
  }

  /// How far the surface moves up or down; none if that is too far along its normal. @pre collect_star(from)
  std::optional<Moved> moved_by_collapse(Index from, Index to, bool everywhere) const {
    Moved moved;
    for (const Index t : star_) {
      Corners corners = mesh_.triangles[t];
      if (corners[0] == to || corners[1] == to || corners[2] == to) continue;
      corners[corner_of(corners, from)] = to;
      const double area = twice_area(corners);
      std::array<double, 3> w{};
      for (std::size_t k = 0; k < 3; ++k) {
        const Vec2& p = mesh_.place[corners[(k + 1) % 3]];
        const Vec2& q = mesh_.place[corners[(k + 2) % 3]];
        w[k] = cross(p - mesh_.place[from], q - mesh_.place[from]) / area;
      }
      if (std::min({w[0], w[1], w[2]}) < -1e-9) continue;
      for (const bool in_front : {true, false}) {
        double height = 0;
        for (std::size_t k = 0; k < 3; ++k) height += w[k] * at(corners[k], in_front).z();
        const double off = std::abs(height - at(from, in_front).z());
        moved.add(off, in_front);
        if (off * levelness(corners, in_front) > most_deviation * longest_edge(corners, in_front)) return std::nullopt;
      }
    }
    if (everywhere) add_moved_on_spokes(from, to, moved);
    return moved;
  }

  /// Adds the distances along z where edges from the vertex that goes cross those from the one that stays.
  void add_moved_on_spokes(Index from, Index to, Moved& moved) const {
    for (const Index t : star_) {
      const Corners& own = mesh_.triangles[t];
      const Index spoke = own[(corner_of(own, from) + 1) % 3];
      if (spoke == to) continue;
      for (const Index other : star_) {
        const Corners& there = mesh_.triangles[other];
        const Index far = there[(corner_of(there, from) + 1) % 3];
        if (far == to || far == spoke) continue;
        const Vec2 along = mesh_.place[far] - mesh_.place[to];
        const Vec2 across = mesh_.place[spoke] - mesh_.place[from];
        const Vec2 offset = mesh_.place[from] - mesh_.place[to];
        const double turn = cross(along, across);
        if (turn == 0) continue;
        const double s = cross(offset, across) / turn;
        const double r = cross(offset, along) / turn;
        if (s < 0 || s > 1 || r < 0 || r > 1) continue;
        for (const bool in_front : {true, false}) {
          const auto height = [&](Index v) { return at(v, in_front).z(); };
          moved.add(std::abs((1 - s) * height(to) + s * height(far) - (1 - r) * height(from) - r * height(spoke)),
                    in_front);
        }
      }
    }
  }

  void collapse(const Change& change) {
    collect_star(change.from);
    SheetRoom room;
    for (const Index t : star_) room = common_room(room, mesh_.room[t]);
    for (const Index t : star_) {
      Corners& corners = mesh_.triangles[t];
      const std::size_t k = corner_of(corners, change.from);
      const bool dies = corners[(k + 1) % 3] == change.to || corners[(k + 2) % 3] == change.to;
      if (!dies) {
        corners[k] = change.to;
        mesh_.room[t] = change.moved.left_of(room);
        continue;
      }
      // The two triangles beside it become neighbours.
      const Index outer = mesh_.neighbours[t][k];
      const Index inner = mesh_.neighbours[t][corner_of(corners, change.to)];
      replace_neighbour(outer, t, inner);
      replace_neighbour(inner, t, outer);
      corners.fill(no_index);
    }
    for (const Index t : star_) {
      if (is_dead(t)) continue;
      for (const Index v : mesh_.triangles[t]) at_[v] = t;
      rate(t);
    }
    wake_around(at_[change.to]);
  }

  void remove_dead() {
    std::vector<Index> number(mesh_.triangles.size(), no_index);
    Index count = 0;
    for (Index t = 0; t < number.size(); ++t) {
      if (!is_dead(t)) number[t] = count++;
    }
    for (Index t = 0; t < number.size(); ++t) {
      if (number[t] == no_index) continue;
      mesh_.triangles[number[t]] = mesh_.triangles[t];
      mesh_.objects[number[t]] = mesh_.objects[t];
      mesh_.room[number[t]] = mesh_.room[t];
      for (std::size_t k = 0; k < 3; ++k) {
        const Index other = mesh_.neighbours[t][k];
        mesh_.neighbours[number[t]][k] = other == no_index ? no_index : number[other];
      }
    }
    mesh_.triangles.resize(count);
    mesh_.neighbours.resize(count);
    mesh_.objects.resize(count);
    mesh_.room.resize(count);
  }

  SheetMesh& mesh_;
  std::vector<Index> at_;            ///< per vertex one of its triangles
  std::vector<double> sharpness_;    ///< per triangle
  std::vector<Index> waiting_;       ///< slender triangles, in the order in which they became so
  std::vector<std::uint8_t> waits_;  ///< per triangle whether it is among those that weren't looked at yet
  std::vector<Vec3> front_, back_;   ///< per vertex
  std::vector<Index> star_;          ///< of the vertex under consideration
  std::vector<Corners> before_, after_;
};

}  // namespace

void improve_triangles(SheetMesh& mesh, Progress& progress) { SheetImprover(mesh).run(progress); }

}  // namespace croquis::silhouette

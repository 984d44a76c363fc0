// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/hole_filling/fairing/patch_editing.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Geometry>

#include "croquis/hole_filling/editable_triangles.h"

namespace croquis::hole_filling {
namespace {

using Side = EditableTriangles::Side;

constexpr double too_long = 4.0 / 3;
constexpr double too_short = 4.0 / 5;
constexpr int most_flip_rounds = 5;

/// Cosine: triangles that a step makes may not turn further from those they come from.
constexpr double least_normal_agreement = 0.5;

/// Of the sine of the two angles against an edge: rounding must not flip back and forth.
constexpr double least_flip_gain = 1e-9;

class PatchEditing {
 public:
  PatchEditing(LoosePatch& patch, EditableTriangles& sides)
      : points_(patch.points), sizes_(patch.sizes), rim_points_(static_cast<Index>(patch.rim_points)), sides_(sides) {}

  void run() {
    split_long();
    collapse_short();
    for (int round = 0; round < most_flip_rounds && flip_once(); ++round) {
    }
  }

 private:
  bool on_rim(Index v) const { return v < rim_points_; }
  Index from(Side s) const { return sides_.from(s); }
  Index to(Side s) const { return sides_.to(s); }

  /// Length as a share of what is wanted.
  double relative_length(Index a, Index b) const {
    return 2 * (points_[a] - points_[b]).norm() / (sizes_[a] + sizes_[b]);
  }

  Vec3 normal(Index a, Index b, Index c) const { return (points_[b] - points_[a]).cross(points_[c] - points_[a]); }
  static bool agree(const Vec3& a, const Vec3& b) {
    const double dot = a.dot(b);
    return dot > 0 && dot * dot > least_normal_agreement * least_normal_agreement * a.squaredNorm() * b.squaredNorm();
  }

  /// The edges there are now, the longest first.
  void split_long() {
    std::vector<std::pair<double, Side>> order;
    for (Side s = 0; s < sides_.count(); ++s) {
      if (!sides_.is_inner_edge(s)) continue;
      const double length = relative_length(from(s), to(s));
      if (length > too_long) order.emplace_back(-length, s);
    }
    std::sort(order.begin(), order.end());
    for (const auto& [length, side] : order) {
      const Side s = sides_.where_is_now(side);
      const Index a = from(s), b = to(s);
      points_.push_back(0.5 * (points_[a] + points_[b]));
      sizes_.push_back(0.5 * (sizes_[a] + sizes_[b]));
      sides_.split(s);
    }
  }

  void collapse_short() {
    for (Side side = 0; side < sides_.count(); ++side) {
      if (!sides_.is_inner_edge(side)) continue;
      const Side s = on_rim(from(side)) ? sides_.twin(side) : side;
      if (on_rim(from(s)) || relative_length(from(s), to(s)) >= too_short) continue;
      if (keeps_shape(s) && keeps_edges_apart(s)) sides_.collapse(s);
    }
  }

  /// Whether the triangles around keep a good size and their side.
  bool keeps_shape(Side s) const {
    const Index gone = from(s), kept = to(s);
    return sides_.all_around(gone, [&](Side out) {
      const Index a = to(out), b = sides_.apex(out);
      if (a == kept) return true;
      if (relative_length(a, kept) > too_long) return false;
      return b == kept || agree(normal(gone, a, b), normal(kept, a, b));
    });
  }

  /// Whether no edge comes to lie on another one, nor a further one between two rim points.
  bool keeps_edges_apart(Side s) const {
    const Index gone = from(s), kept = to(s);
    const Index left = sides_.apex(s), right = sides_.apex(sides_.twin(s));
    if (left == right) return false;
    return sides_.all_around(gone, [&](Side out) {
      const Index a = to(out);
      return a == kept || a == left || a == right || can_be_joined(a, kept);
    });
  }

  bool can_be_joined(Index a, Index b) const {
    if (on_rim(a) && on_rim(b)) return false;
    if (on_rim(a)) std::swap(a, b);  // a rim point's triangles may be several fans: the other one is checked
    return sides_.all_around(a, [&](Side out) { return to(out) != b; });
  }

  bool flip_once() {
    bool any = false;
    for (Side s = 0; s < sides_.count(); ++s) {
      if (!sides_.is_inner_edge(s) || !gains_by_flip(s)) continue;
      sides_.flip(s);
      any = true;
    }
    return any;
  }

  /// Whether the angles against the edge are more than two right ones together, by the sign of their sine, and the
  /// triangles go on looking the same way.
  bool gains_by_flip(Side s) const {
    const Index a = from(s), b = to(s), c = sides_.apex(s), d = sides_.apex(sides_.twin(s));
    const Vec3 ca = points_[a] - points_[c], cb = points_[b] - points_[c];
    const Vec3 da = points_[a] - points_[d], db = points_[b] - points_[d];
    const double at_c = ca.dot(cb), at_d = da.dot(db);
    if (at_c >= 0 && at_d >= 0) return false;
    const double sine = ca.cross(cb).norm() * at_d + at_c * da.cross(db).norm();
    const double scale = std::sqrt(ca.squaredNorm() * cb.squaredNorm() * da.squaredNorm() * db.squaredNorm());
    if (sine >= -least_flip_gain * scale || !can_be_joined(c, d)) return false;
    const Vec3 both = normal(a, b, c) + normal(b, a, d);
    return agree(both, normal(a, d, c)) && agree(both, normal(b, c, d));
  }

  std::vector<Vec3>& points_;
  std::vector<double>& sizes_;
  Index rim_points_;
  EditableTriangles& sides_;
};

/// Without the points that have collapsed.
void take_back(const EditableTriangles& sides, LoosePatch& patch) {
  std::vector<Index> numbers(patch.points.size());
  Index next = 0;
  for (Index v = 0; v < patch.points.size(); ++v) {
    numbers[v] = next;
    if (sides.is_gone(v)) continue;
    patch.points[next] = patch.points[v];
    patch.sizes[next++] = patch.sizes[v];
  }
  patch.points.resize(next);
  patch.sizes.resize(next);
  patch.triangles = sides.triangles();
  for (auto& t : patch.triangles) {
    for (Index& v : t) v = numbers[v];
  }
}

}  // namespace

std::vector<Index> vertices_of(std::span<const std::array<Index, 3>> triangles) {
  std::vector<Index> vertices;
  for (const auto& t : triangles) vertices.insert(vertices.end(), t.begin(), t.end());
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

std::vector<double> mean_lengths(std::span<const Vec3> points, std::span<const std::array<Index, 2>> edges) {
  std::vector<double> sums(points.size(), 0), counts(points.size(), 0);
  for (const auto& edge : edges) {
    const double length = (points[edge[0]] - points[edge[1]]).norm();
    for (const Index v : edge) {
      sums[v] += length;
      counts[v] += 1;
    }
  }
  for (std::size_t v = 0; v < sums.size(); ++v) {
    if (counts[v] > 0) sums[v] /= counts[v];
  }
  return sums;
}

bool bring_to_size(LoosePatch& patch) {
  EditableTriangles sides(patch.triangles, patch.points.size());
  if (!sides.is_manifold(patch.rim_points)) return false;
  PatchEditing(patch, sides).run();
  take_back(sides, patch);
  return true;
}

}  // namespace croquis::hole_filling

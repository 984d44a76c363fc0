// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "algorithms/hole_filling/continuation/creases.h"
#include "algorithms/hole_filling/patching/near_scene.h"
#include "algorithms/hole_filling/patching/patch_methods.h"

namespace croquis::hole_filling {
namespace {

constexpr double farthest_snap = 0.45;  // × edge: nearer vertices come to lie on the crease
constexpr double on_surface = 0.02;     // × edge
constexpr int newton_steps = 8;
constexpr int crease_flip_rounds = 4;
constexpr double least_crease_gain = 0.7;  // a flip has to bring the edge's middle this much nearer to the surface

/// Newton's steps of least length onto the zero sets of two sides.
Vec3 meeting_place(const CreaseField& field, Vec3 place, std::size_t a, std::size_t b) {
  for (int step = 0; step < newton_steps; ++step) {
    Eigen::Matrix<double, 2, 3> gradients;
    gradients << field.fit(a).gradient(place).transpose(), field.fit(b).gradient(place).transpose();
    const Eigen::Vector2d values(field.fit(a).value(place), field.fit(b).value(place));
    const Eigen::Matrix2d square = gradients * gradients.transpose();
    if (!(std::abs(square.determinant()) > 1e-6)) break;  // sides that touch: there is no crease
    place -= gradients.transpose() * square.inverse() * values;
  }
  return place;
}

/// The place nearest to a point where its side meets another one, if that is near; else the point.
/// @param edge of the rims
Vec3 snapped(const CreaseField& field, double edge, const Vec3& point) {
  const std::size_t own = field.value(point).side;
  Vec3 best = point;
  double nearest = farthest_snap * edge;
  for (std::size_t other = 0; other < field.side_count(); ++other) {
    if (other == own || std::abs(field.fit(other).value(point)) > edge) continue;
    const Vec3 place = meeting_place(field, point, own, other);
    const double distance = (place - point).norm();
    if (!(distance < nearest) || !(std::abs(field.value(place).value) < on_surface * edge)) continue;
    nearest = distance;
    best = place;
  }
  return best;
}

/// Flips inner edges, each at most once, where that brings their middles nearer to a creased surface: then they run
/// along its creases.
/// @return whether any was flipped
bool flip_onto(const CreaseField& field, double edge, const PolyMesh& mesh, HolePatch& patch) {
  using Sides = std::vector<std::array<Index, 4>>;  // low, high, triangle, the corner across
  const auto at = [&](Index v) -> const Vec3& { return place_of(patch, mesh, v); };
  const auto off = [&](Index a, Index b) { return std::abs(field.value(0.5 * (at(a) + at(b))).value); };
  const auto twice_area = [&](Index a, Index b, Index c) { return (at(b) - at(a)).cross(at(c) - at(a)).norm(); };
  const auto gains = [&](Index a, Index b, Index c, Index d) {
    if (std::max(c, d) < mesh.vertex_count()) return false;
    const double now = off(a, b);
    if (now < on_surface * edge || off(c, d) > least_crease_gain * now) return false;
    const double before = twice_area(a, b, c) + twice_area(a, b, d);
    return std::min(twice_area(a, c, d), twice_area(b, c, d)) > 0.1 * before;
  };
  Sides sides;
  for (Index t = 0; t < patch.triangles.size(); ++t) {
    const Triangle& corners = patch.triangles[t];
    for (std::size_t i = 0; i < 3; ++i) {
      const auto [low, high] = std::minmax(corners[i], corners[(i + 1) % 3]);
      sides.push_back({low, high, t, corners[(i + 2) % 3]});
    }
  }
  std::ranges::sort(sides);
  const auto are_joined = [&](Index a, Index b) {
    const auto place = std::ranges::lower_bound(sides, std::array<Index, 4>{std::min(a, b), std::max(a, b), 0, 0});
    return place != sides.end() && (*place)[0] == std::min(a, b) && (*place)[1] == std::max(a, b);
  };
  std::vector<char> is_changed(patch.triangles.size(), 0);
  bool any = false;
  for (std::size_t i = 0; i + 1 < sides.size(); ++i) {
    const auto &s = sides[i], &o = sides[i + 1];
    if (s[0] != o[0] || s[1] != o[1] || is_changed[s[2]] != 0 || is_changed[o[2]] != 0) continue;
    const Index c = s[3], d = o[3];
    if (!gains(s[0], s[1], c, d) || are_joined(c, d)) continue;
    Triangle& first = patch.triangles[s[2]];
    std::rotate(first.begin(), std::ranges::find(first, c), first.end());  // the edge follows as this triangle runs it
    patch.triangles[o[2]] = {d, first[2], c};
    first = {c, first[1], d};
    is_changed[s[2]] = is_changed[o[2]] = 1;
    any = true;
  }
  return any;
}

}  // namespace

std::optional<HolePatch> creased_patch(const HoleSite& site, Progress& progress) {
  const bool is_asked_for = site.preset == Preset::Sharp && site.holes.size() == 1;
  const auto field = fit_sides(site, is_asked_for ? usual_side_residual : trusted_side_residual);
  if (!field) return std::nullopt;
  const auto start = smooth_patch(site, false, progress);
  if (!start || start->points.empty()) return start;
  RimField surface;
  surface.other = field->field();
  surface.size = widest_diameter(site);
  surface.edge = mean_rim_edge(site);
  for (std::size_t side = 0; side < field->side_count(); ++side)
    surface.domain_points.push_back(field->fit(side).report().centres);
  auto patch = lay_onto(site, surface, *start, most_rounds, progress);
  if (!patch) return std::nullopt;
  HolePatch aligned = *patch;
  for (Vec3& point : aligned.points) point = snapped(*field, surface.edge, point);
  for (int round = 0; round < crease_flip_rounds && flip_onto(*field, surface.edge, *site.mesh, aligned); ++round) {
  }
  if (untangle(site, aligned, progress)) return aligned;
  untangle(site, *patch, progress);
  return patch;
}

}  // namespace croquis::hole_filling

// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "algorithms/hole_filling/continuation/crease_field.h"
#include "algorithms/hole_filling/patching/implicit_patch.h"
#include "algorithms/hole_filling/patching/patcher.h"
#include "algorithms/hole_filling/patching/untangling.h"

namespace croquis::hole_filling {
namespace {

constexpr double farthest_snap = 0.45;  // × edge: nearer vertices come to lie on the crease
constexpr double on_surface = 0.02;     // × edge
constexpr int newton_steps = 8;
constexpr int crease_flip_rounds = 4;
constexpr double least_crease_gain = 0.7;  // a flip has to bring the edge's middle this much nearer to the surface

/// Makes edges of a patch that lies on a creased surface run along its creases.
class CreaseAlignment {
 public:
  CreaseAlignment(const PolyMesh& mesh, const CreaseField& field, double edge, HolePatch& patch)
      : mesh_(mesh), field_(field), edge_(edge), patch_(patch), given_(static_cast<Index>(mesh.vertex_count())) {}

  void run() {
    for (Vec3& point : patch_.points) snap(point);
    for (int round = 0; round < crease_flip_rounds && flip_once(); ++round) {
    }
  }

 private:
  const Vec3& at(Index v) const { return v < given_ ? mesh_.positions[v] : patch_.points[v - given_]; }

  /// To the nearest place where two sides meet, if that is near.
  void snap(Vec3& point) const {
    const std::size_t own = field_.value(point).side;
    Vec3 best = point;
    double nearest = farthest_snap * edge_;
    for (std::size_t other = 0; other < field_.side_count(); ++other) {
      if (other == own || std::abs(field_.fit(other).value(point)) > edge_) continue;
      const Vec3 place = meeting_place(point, own, other);
      const double distance = (place - point).norm();
      if (!(distance < nearest) || !(std::abs(field_.value(place).value) < on_surface * edge_)) continue;
      nearest = distance;
      best = place;
    }
    point = best;
  }

  /// Newton's steps of least length onto the zero sets of both sides.
  Vec3 meeting_place(Vec3 place, std::size_t a, std::size_t b) const {
    for (int step = 0; step < newton_steps; ++step) {
      Eigen::Matrix<double, 2, 3> gradients;
      gradients << field_.fit(a).gradient(place).transpose(), field_.fit(b).gradient(place).transpose();
      const Eigen::Vector2d values(field_.fit(a).value(place), field_.fit(b).value(place));
      const Eigen::Matrix2d square = gradients * gradients.transpose();
      if (!(std::abs(square.determinant()) > 1e-6)) break;  // sides that touch: there is no crease
      place -= gradients.transpose() * square.inverse() * values;
    }
    return place;
  }

  double distance_of_middle(Index a, Index b) const { return std::abs(field_.value(0.5 * (at(a) + at(b))).value); }

  Vec3 normal(Index a, Index b, Index c) const { return (at(b) - at(a)).cross(at(c) - at(a)); }

  /// The inner edges as they are now, each looked at once.
  bool flip_once() {
    std::vector<std::array<Index, 4>> sides;  // low, high, triangle, the corner across
    for (Index t = 0; t < patch_.triangles.size(); ++t) {
      for (std::size_t i = 0; i < 3; ++i) {
        const auto& corners = patch_.triangles[t];
        const auto [low, high] = std::minmax(corners[i], corners[(i + 1) % 3]);
        sides.push_back({low, high, t, corners[(i + 2) % 3]});
      }
    }
    std::sort(sides.begin(), sides.end());
    std::vector<char> is_changed(patch_.triangles.size(), 0);
    bool any = false;
    for (std::size_t i = 0; i + 1 < sides.size(); ++i) {
      const auto &s = sides[i], &o = sides[i + 1];
      if (s[0] != o[0] || s[1] != o[1] || is_changed[s[2]] != 0 || is_changed[o[2]] != 0) continue;
      if (!gains(s[0], s[1], s[3], o[3]) || has_edge(sides, s[3], o[3])) continue;
      flip(s, o);
      is_changed[s[2]] = is_changed[o[2]] = 1;
      any = true;
    }
    return any;
  }

  static bool has_edge(const std::vector<std::array<Index, 4>>& sides, Index a, Index b) {
    const auto [low, high] = std::minmax(a, b);
    const auto place = std::lower_bound(sides.begin(), sides.end(), std::array<Index, 4>{low, high, 0, 0});
    return place != sides.end() && (*place)[0] == low && (*place)[1] == high;
  }

  bool gains(Index a, Index b, Index c, Index d) const {
    if (c < given_ && d < given_) return false;
    const double now = distance_of_middle(a, b);
    if (now < on_surface * edge_ || distance_of_middle(c, d) > least_crease_gain * now) return false;
    const double before = normal(a, b, c).norm() + normal(a, b, d).norm();
    const double after_first = normal(a, c, d).norm(), after_second = normal(b, c, d).norm();
    return std::min(after_first, after_second) > 0.1 * before;
  }

  void flip(const std::array<Index, 4>& s, const std::array<Index, 4>& o) {
    auto &first = patch_.triangles[s[2]], &second = patch_.triangles[o[2]];
    const Index c = s[3], d = o[3];
    const auto k = static_cast<std::size_t>(std::find(first.begin(), first.end(), c) - first.begin());
    const Index a = first[(k + 1) % 3], b = first[(k + 2) % 3];  // the edge as the first triangle runs it
    first = {c, a, d};
    second = {d, b, c};
  }

  const PolyMesh& mesh_;
  const CreaseField& field_;
  double edge_;
  HolePatch& patch_;
  Index given_;
};

class CreasedPatcher : public Patcher {
 public:
  CreasedPatcher(const ImplicitOptions& options, std::size_t most_triangles, double most_residual)
      : options_(options),
        most_triangles_(most_triangles),
        most_residual_(most_residual),
        start_(faired_patcher(1, most_triangles)) {}

  const char* method() const override { return "creased"; }

  std::optional<HolePatch> attempt(const HoleSite& site, Progress& progress) const override {
    const auto field = fit_sides(site, options_, most_residual_);
    if (!field) return std::nullopt;
    const auto start = start_->attempt(site, progress);
    if (!start || start->points.empty()) return start;
    RimField surface;
    surface.other = field->field();
    surface.size = widest_diameter(site);
    surface.edge = mean_rim_edge(site);
    for (std::size_t side = 0; side < field->side_count(); ++side)
      surface.domain_points.push_back(field->fit(side).report().centres);
    auto patch = lay_onto(site, surface, *start, most_triangles_, progress);
    if (!patch) return std::nullopt;
    HolePatch aligned = *patch;
    CreaseAlignment(*site.mesh, *field, surface.edge, aligned).run();
    if (untangle(site, aligned, progress)) return aligned;
    untangle(site, *patch, progress);
    return patch;
  }

 private:
  ImplicitOptions options_;
  std::size_t most_triangles_;
  double most_residual_;
  std::shared_ptr<const Patcher> start_;
};

}  // namespace

std::shared_ptr<const Patcher> creased_patcher(const ImplicitOptions& options, std::size_t most_triangles,
                                               double most_residual) {
  return std::make_shared<CreasedPatcher>(options, most_triangles, most_residual);
}

}  // namespace croquis::hole_filling

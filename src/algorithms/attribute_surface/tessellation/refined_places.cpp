// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/attribute_surface/tessellation/refined_places.h"

#include <algorithm>
#include <map>
#include <utility>

#include "croquis/geometry/triangle_tree.h"

namespace croquis {
namespace {

/// Triangles with no edge longer than that part of the perimeter stay: tips and tight folds are followed that far.
constexpr double least_edge = 1e-5;
/// Triangles flatter than that, height over longest edge, aren't divided.
constexpr double least_relative_height = 1e-6;

/// Into how many parts the edges of a triangle are divided by the places where it is measured.
constexpr int probe_parts = 6;

using Triangle = std::array<Index, 3>;

/// A place of a triangle where the surface is measured.
struct Probe {
  Vec2 place = Vec2::Zero();
  double error = 0;
};

/// Adds places to a triangulation until it keeps to the surface.
class Refinement {
 public:
  Refinement(const FaceSurface& surface, const FaceRim& rim, const RefinementOptions& options)
      : surface_(surface), options_(options), rim_(rim_places(surface, rim)) {
    for (const Vec2& place : rim_) rim_points_.push_back(surface.at(place));
    if (options.insert_attributes) {
      for (const Vec2& place : attribute_places(surface, rim_)) insert(place);
    }
    const Vec2& middle = surface.domain().middle;
    if (is_apart(middle, rim_, inner_)) insert(middle);
  }

  RefinedPlaces run(Progress& progress) {
    double largest = 0;
    do {
      progress.check();
      made_ = joined_places(rim_, inner_);
      points_ = inner_points_;
      points_.insert(points_.end(), rim_points_.begin(), rim_points_.end());
      largest = add_places();
    } while (made_.inner_count < inner_.size());
    progress.report(1);
    return {std::move(made_), largest};
  }

 private:
  void insert(const Vec2& place) {
    inner_.push_back(place);
    inner_points_.push_back(surface_.at(place));
  }

  /// The same for the same three places in every round: those of the rim are numbered behind a growing inside.
  Triangle name_of(Triangle triangle) const {
    for (Index& vertex : triangle) {
      if (vertex >= made_.inner_count) vertex = no_index - (vertex - static_cast<Index>(made_.inner_count));
    }
    std::ranges::sort(triangle);
    return triangle;
  }

  /// Whether two vertices follow each other along the rim.
  bool is_rim_edge(Index a, Index b) const {
    if (a < made_.inner_count || b < made_.inner_count) return false;
    const std::size_t apart = a < b ? b - a : a - b;
    return apart == 1 || apart + 1 == rim_.size();
  }

  Probe measured(const Triangle& triangle, const Vec2& place) const {
    const TriangleFoot foot =
        foot_on_triangle({points_[triangle[0]], points_[triangle[1]], points_[triangle[2]]}, surface_.at(place));
    return {place, foot.distance};
  }

  void measure(const Triangle& triangle, const Vec2& place, Probe& worst) const {
    const Probe probe = measured(triangle, place);
    if (probe.error > worst.error) worst = probe;
  }

  /// At a part of an edge, counted from its lower vertex on: both triangles find the same place.
  void measure_edge(const Triangle& triangle, std::size_t first, int part, Probe& worst) const {
    const auto [low, high] = std::minmax(triangle[first], triangle[(first + 1) % 3]);
    if (is_rim_edge(low, high)) return;
    const Vec2 along = made_.places[high] - made_.places[low];
    measure(triangle, made_.places[low] + part / double{probe_parts} * along, worst);
  }

  void measure_inside(const Triangle& triangle, Probe& worst) const {
    const Vec2& origin = made_.places[triangle[0]];
    const Vec2 a = (made_.places[triangle[1]] - origin) / probe_parts;
    const Vec2 b = (made_.places[triangle[2]] - origin) / probe_parts;
    for (int i = 1; i + 1 < probe_parts; ++i) {
      for (int j = 1; i + j < probe_parts; ++j) measure(triangle, origin + i * a + j * b, worst);
    }
  }

  /// Where a few places show already that it must be divided, no more are measured.
  Probe worst_of(const Triangle& triangle) const {
    Probe worst;
    for (std::size_t first = 0; first < 3; ++first) measure_edge(triangle, first, probe_parts / 2, worst);
    const auto& at = made_.places;
    measure(triangle, (at[triangle[0]] + at[triangle[1]] + at[triangle[2]]) / 3, worst);
    if (worst.error > 2 * options_.tolerance) return worst;
    measure_inside(triangle, worst);
    for (std::size_t first = 0; first < 3; ++first) {
      for (const int part : {1, 2, 4, 5}) measure_edge(triangle, first, part, worst);
    }
    return worst;
  }

  /// What a triangle can be asked to keep to: no more than the chords of the rim that it has do.
  double limit_of(const Triangle& triangle) const {
    double limit = options_.tolerance;
    for (std::size_t first = 0; first < 3; ++first) {
      const Index from = triangle[first], to = triangle[(first + 1) % 3];
      if (!is_rim_edge(from, to)) continue;
      for (int part = 1; part < probe_parts; ++part) {
        const Vec2 along = made_.places[to] - made_.places[from];
        limit =
            std::max(limit, 1.5 * measured(triangle, made_.places[from] + part / double{probe_parts} * along).error);
      }
    }
    return limit;
  }

  /// Too small or too flat to be divided.
  bool is_stuck(const Triangle& triangle) const {
    const Vec2 &a = made_.places[triangle[0]], &b = made_.places[triangle[1]], &c = made_.places[triangle[2]];
    const double longest = std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()});
    return longest < least_edge || cross(b - a, c - a) < least_relative_height * longest;
  }

  /// The worst place of a triangle; error 0 where it keeps to what it can be asked for.
  Probe fault_of(const Triangle& triangle) const {
    const Probe worst = worst_of(triangle);
    const bool keeps = worst.error <= options_.tolerance || worst.error <= limit_of(triangle);
    return keeps ? Probe{} : worst;
  }

  /// One place for each triangle that is too far from the surface, the worst first; none for those beside it, which
  /// change. @return the largest error that nothing was done about though it is above the tolerance
  double add_places() {
    std::vector<std::pair<Triangle, Probe>> wanted;
    double left = 0;
    std::map<Triangle, Probe> faults;
    for (const Triangle& triangle : made_.triangles) {
      const Triangle name = name_of(triangle);
      const auto known = faults_.find(name);
      const Probe& fault = faults[name] = known != faults_.end() ? known->second : fault_of(triangle);
      if (fault.error == 0) continue;
      if (is_stuck(triangle) || inner_.size() >= options_.most_inner) {
        left = std::max(left, fault.error);
      } else {
        wanted.emplace_back(triangle, fault);
      }
    }
    faults_ = std::move(faults);
    std::ranges::stable_sort(wanted, [](const auto& a, const auto& b) { return a.second.error > b.second.error; });
    std::vector<bool> touched(made_.places.size(), false);
    for (const auto& [triangle, worst] : wanted) {
      if (std::ranges::count_if(triangle, [&](Index v) { return touched[v]; }) > 1) continue;
      if (inner_.size() >= options_.most_inner) break;
      for (const Index vertex : triangle) touched[vertex] = true;
      insert(worst.place);
    }
    return left;
  }

  const FaceSurface& surface_;
  const RefinementOptions& options_;
  std::vector<Vec2> rim_;
  std::vector<Vec3> rim_points_;
  std::vector<Vec2> inner_;
  std::vector<Vec3> inner_points_;
  FacePlaces made_;
  std::vector<Vec3> points_;          ///< of all places of made_
  std::map<Triangle, Probe> faults_;  ///< by the names of triangles that were measured
};

}  // namespace

RefinedPlaces refined_places(const FaceSurface& surface, const FaceRim& rim, Progress& progress,
                             const RefinementOptions& options) {
  return Refinement(surface, rim, options).run(progress);
}

}  // namespace croquis

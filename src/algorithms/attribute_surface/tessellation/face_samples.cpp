// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/attribute_surface/tessellation/face_samples.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include <Eigen/Geometry>

#include "croquis/base/error.h"
#include "croquis/geometry/planar_triangulation.h"
#include "croquis/geometry/triangle_tree.h"

namespace croquis {
namespace {

/// Whether fractions are 0, 1/n, 2/n …
bool are_even(const std::vector<double>& fractions) {
  const auto count = static_cast<double>(fractions.size());
  for (std::size_t i = 0; i < fractions.size(); ++i) {
    if (std::abs(fractions[i] - static_cast<double>(i) / count) > 1e-12) return false;
  }
  return true;
}

/// Rings of a rim that has as many even samples on each side of the domain; none of others.
std::optional<std::size_t> regular_rings(const FaceRim& rim) {
  const std::size_t count = rim.front().size();
  const bool same = std::ranges::all_of(rim, [&](const auto& side) { return side.size() == count && are_even(side); });
  if (!same) return std::nullopt;
  if (rim.size() > 2) return count;
  return count % 2 == 0 ? std::optional(count / 2) : std::nullopt;
}

/// Places of the rings 0 to `rings` - 1.
std::vector<Vec2> ring_places(const DomainPolygon& domain, std::size_t rings) {
  const auto whole = static_cast<double>(rings);
  std::vector<Vec2> places{domain.middle};
  places.reserve(1 + domain.corners.size() * rings * (rings - 1) / 2);
  for (std::size_t ring = 1; ring < rings; ++ring) {
    for (std::size_t k = 0; k < domain.corners.size(); ++k) {
      for (std::size_t i = 0; i < ring; ++i)
        places.push_back(place_in(domain, {k, static_cast<double>(ring - i) / whole, static_cast<double>(i) / whole}));
    }
  }
  return places;
}

/// Numbers of the places of rings around a polygon.
struct RingNumbers {
  std::size_t sides = 0;

  /// @param i 0..ring, where `ring` is the next side's first
  Index at(std::size_t ring, std::size_t side, std::size_t i) const {
    if (ring == 0) return 0;
    const std::size_t around = (side * ring + i) % (sides * ring);
    return static_cast<Index>(1 + sides * ring * (ring - 1) / 2 + around);
  }
};

std::vector<std::array<Index, 3>> ring_triangles(std::size_t sides, std::size_t rings) {
  const RingNumbers number{sides};
  std::vector<std::array<Index, 3>> triangles;
  triangles.reserve(sides * rings * rings);
  for (std::size_t ring = 1; ring <= rings; ++ring) {
    for (std::size_t k = 0; k < sides; ++k) {
      for (std::size_t i = 0; i < ring; ++i) {
        const Index inner = number.at(ring - 1, k, i), next = number.at(ring, k, i + 1);
        triangles.push_back({inner, number.at(ring, k, i), next});
        if (i + 1 < ring) triangles.push_back({inner, next, number.at(ring - 1, k, i + 1)});
      }
    }
  }
  return triangles;
}

/// In domains of perimeter 1: places nearer than that to each other or to the rim are one vertex.
constexpr double least_vertex_distance = 1e-6;

/// The shortest side of the triangles of rings around a place.
double ring_spacing(const DomainPolygon& domain, std::size_t rings, const Vec2& place) {
  const std::size_t k = fan_place_in(domain, place).corner;
  const Vec2 from = domain.corners[k] - domain.middle;
  const Vec2 to = domain.corners[(k + 1) % domain.corners.size()] - domain.middle;
  return std::min({from.norm(), to.norm(), (to - from).norm()}) / static_cast<double>(rings);
}

/// Puts places among those of rings: each is where the nearest of these was, so that no slivers come of it.
/// @param must the first so many of them; others are left out where they are denser than rings
void insert_among(const DomainPolygon& domain, std::size_t rings, const std::vector<Vec2>& inserted, std::size_t must,
                  std::vector<Vec2>& places) {
  std::size_t kept = places.size();  // of the rings, the first ones
  for (std::size_t i = 0; i < inserted.size(); ++i) {
    const Vec2& place = inserted[i];
    const double spacing = ring_spacing(domain, rings, place);
    const auto distance = [&](const Vec2& other) { return (other - place).norm(); };
    const auto end = places.begin() + static_cast<std::ptrdiff_t>(kept);
    const auto is_near = [&](const Vec2& other) { return distance(other) < 0.5 * spacing; };
    if (i >= must && std::any_of(end, places.end(), is_near)) continue;
    const auto nearest = std::ranges::min_element(places.begin(), end, {}, distance);
    if (nearest == end || distance(*nearest) > spacing) {
      places.push_back(place);
    } else {
      *nearest = places[--kept];
      places[kept] = place;
    }
  }
}

Vec3 rim_normal(const FaceSurface& surface, const FaceRim& rim, std::size_t side, std::size_t sample) {
  const Vec3 normal = surface.side_normal(side, rim[side][sample]);
  if (sample > 0) return normal;
  return unit_or_zero(normal + surface.side_normal((side + rim.size() - 1) % rim.size(), 1));
}

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

std::size_t FaceSamples::byte_size() const {
  return sizeof *this + plane.places.size() * sizeof(Vec2) + (points.size() + normals.size()) * sizeof(Vec3) +
         plane.triangles.size() * sizeof(plane.triangles[0]);
}

std::vector<Vec2> rim_places(const FaceSurface& surface, const FaceRim& rim) {
  std::vector<Vec2> places;
  for (std::size_t side = 0; side < rim.size(); ++side) {
    for (const double fraction : rim[side]) places.push_back(surface.side_place(side, fraction));
  }
  return places;
}

bool is_apart(const Vec2& place, const std::vector<Vec2>& rim, const std::vector<Vec2>& places) {
  for (std::size_t i = 0; i < rim.size(); ++i) {
    const Vec2 along = rim[(i + 1) % rim.size()] - rim[i];
    if (cross(along, place - rim[i]) <= least_vertex_distance * along.norm()) return false;
  }
  return std::ranges::none_of(places,
                              [&](const Vec2& other) { return (other - place).norm() < least_vertex_distance; });
}

std::vector<Vec2> attribute_places(const FaceSurface& surface, const std::vector<Vec2>& rim) {
  std::vector<Vec2> places;
  const auto add = [&](const Vec2& place) {
    if (is_apart(place, rim, places)) places.push_back(place);
  };
  for (const PlacedPoint& point : surface.points()) add(point.place);
  for (const PlacedCurve& curve : surface.curves()) std::ranges::for_each(curve.places, add);
  return places;
}

FacePlaces fan_places(const FaceSurface& surface, const FaceRim& rim, bool insert_attributes) {
  const DomainPolygon& domain = surface.domain();
  const std::vector<Vec2> around = rim_places(surface, rim);
  const std::vector<Vec2> inserted = insert_attributes ? attribute_places(surface, around) : std::vector<Vec2>{};
  const std::size_t sides = domain.corners.size();
  const auto regular = regular_rings(rim);
  if (regular && inserted.empty()) {
    FacePlaces made{ring_places(domain, *regular), 0, ring_triangles(sides, *regular)};
    made.inner_count = made.places.size();
    made.places.insert(made.places.end(), around.begin(), around.end());
    return made;
  }
  const std::size_t rings = regular.value_or(std::max<std::size_t>(1, (around.size() + sides / 2) / sides));
  std::vector<Vec2> inner = ring_places(domain, rings);
  insert_among(domain, rings, inserted, surface.points().size(), inner);
  if (rim.size() == 2) std::erase_if(inner, [&](const Vec2& place) { return !is_apart(place, around, {}); });
  return joined_places(around, std::move(inner));
}

FacePlaces joined_places(const std::vector<Vec2>& rim, std::vector<Vec2> inner) {
  FacePlaces made{std::move(inner), 0, {}};
  made.inner_count = made.places.size();
  made.places.insert(made.places.end(), rim.begin(), rim.end());
  const auto first = static_cast<Index>(made.inner_count), count = static_cast<Index>(rim.size());
  std::vector<std::array<Index, 2>> sides;
  for (Index i = 0; i < count; ++i) sides.push_back({first + i, first + (i + 1) % count});
  const PlanarTriangulationResult plane = triangulate(made.places, sides);
  if (!plane.conflict.empty()) throw_internal("the samples of a face can't be joined");
  made.triangles = triangles_inside(plane.triangulation);
  return made;
}

FaceSamples evaluate_places(const FaceSurface& surface, const FaceRim& rim, FacePlaces places) {
  FaceSamples samples;
  samples.plane = std::move(places);
  const auto& all = samples.plane.places;
  samples.points.reserve(samples.plane.inner_count);
  samples.normals.reserve(all.size());
  for (std::size_t i = 0; i < samples.plane.inner_count; ++i) {
    const SurfacePlace place = surface.evaluate(all[i]);
    samples.points.push_back(place.point);
    samples.normals.push_back(unit_or_zero(place.du.cross(place.dv)));
  }
  const bool has_fence = surface.frame().mode == AttributeMode::Smooth;
  for (std::size_t side = 0; side < rim.size(); ++side) {
    for (std::size_t i = 0; i < rim[side].size(); ++i)
      samples.normals.push_back(has_fence ? rim_normal(surface, rim, side, i)
                                          : surface.normal(all[samples.normals.size()]));
  }
  return samples;
}

RefinedPlaces refined_places(const FaceSurface& surface, const FaceRim& rim, Progress& progress,
                             const RefinementOptions& options) {
  return Refinement(surface, rim, options).run(progress);
}

}  // namespace croquis

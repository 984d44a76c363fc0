// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <optional>
#include <vector>

#include <Eigen/Geometry>

#include "algorithms/hole_filling/analysis/analysis_steps.h"
#include "algorithms/hole_filling/analysis/box_search.h"
#include "algorithms/hole_filling/triangulation/triangulations.h"
#include "croquis/geometry/polygon_area.h"

namespace croquis::hole_filling {
namespace {

/// A long distance to begin with: from each point to its farthest, a few times. Squared.
double long_distance(std::span<const Vec3> points) {
  double longest = 0;
  Vec3 from = points.front();
  for (int pass = 0; pass < 3; ++pass) {
    const Vec3 farthest =
        *std::ranges::max_element(points, {}, [&](const Vec3& p) { return (p - from).squaredNorm(); });
    longest = std::max(longest, (farthest - from).squaredNorm());
    from = farthest;
  }
  return longest;
}

double greatest_squared(const Box& a, const Box& b) {
  return (a.max() - b.min()).cwiseMax(b.max() - a.min()).squaredNorm();
}

/// Scanned things reach out farther than sheets and spheres of the same spread: by so much in the mean of 877 holes of
/// known things.
constexpr double usual_reach = 1.2;

/// Sums over the triangles of a component, by area, about its first corner so that large coordinates cost no digits.
struct Spread {
  bool is_begun = false;
  Vec3 origin = Vec3::Zero();
  double area = 0;
  Vec3 first = Vec3::Zero();  ///< moments of the triangles' centres
  double second = 0;

  void add(const Vec3& a, const Vec3& b, const Vec3& c) {
    if (!is_begun) origin = a;
    is_begun = true;
    const double weight = triangle_area(a, b, c);
    const Vec3 centre = (a + b + c) / 3 - origin;
    area += weight;
    first += weight * centre;
    second += weight * centre.squaredNorm();
  }

  /// The variance of a length evenly covered is a twelfth of its square.
  double size() const {
    if (!(area > 0)) return 0;
    return usual_reach * std::sqrt(12 * std::max(0.0, second / area - (first / area).squaredNorm()));
  }
};

/// Pieces that touch in vertices can have a rim in common: it is that of the largest.
Index largest_component(const HoleAnalysis& analysis, const Hole& hole) {
  const auto component = [&](Index corner) { return analysis.view.component[corner / 3]; };
  const Index corner = *std::max_element(hole.corners.begin(), hole.corners.end(), [&](Index a, Index b) {
    return analysis.component_area[component(a)] < analysis.component_area[component(b)];
  });
  return component(corner);
}

/// The rim in the direction of a patch, about its own first vertex so that large coordinates cost no digits.
std::vector<Vec3> local_polygon(const PolyMesh& mesh, const Hole& hole) {
  std::vector<Vec3> polygon;
  polygon.reserve(hole.vertices.size());
  const Vec3& origin = mesh.positions[hole.vertices.front()];
  for (auto vertex = hole.vertices.rbegin(); vertex != hole.vertices.rend(); ++vertex)
    polygon.push_back(mesh.positions[*vertex] - origin);
  return polygon;
}

double perimeter_of(const std::vector<Vec3>& polygon) {
  double sum = (polygon.front() - polygon.back()).norm();
  for (std::size_t i = 1; i < polygon.size(); ++i) sum += (polygon[i] - polygon[i - 1]).norm();
  return sum;
}

void measure_area(const std::vector<Vec3>& polygon, const HoleAnalysisOptions& options, Hole& hole,
                  Progress& progress) {
  RimPolygon rim;
  rim.points = polygon;
  rim.loop_ends = {static_cast<Index>(polygon.size())};
  const auto triangulation = triangulate_rim(rim, progress, options.exact_area_edges);
  hole.area_is_minimal = triangulation && triangulation->is_minimal;
  // A rim on one line, or wound so that no triangulation is proper: what it spans seen along its plane.
  hole.area = triangulation ? triangulation->area : area_normal(polygon).norm();
}

/// Unit normal of a triangle that has one, else zero.
Vec3 normal_of(const PolyMesh& mesh, const SurfaceView& view, Index triangle) {
  if ((view.flags[triangle] & (SurfaceView::NoArea | SurfaceView::Sliver)) != 0) return Vec3::Zero();
  return view.normal(triangle, mesh.positions).normalized();
}

DirectionCone cone_of(const std::vector<Vec3>& directions, const std::vector<double>& weights) {
  DirectionCone cone;
  for (std::size_t i = 0; i < directions.size(); ++i) cone.axis += weights[i] * directions[i];
  const double length = cone.axis.norm();
  cone.axis = length > 0 ? Vec3(cone.axis / length) : Vec3::Zero();
  for (const Vec3& direction : directions) cone.angle = std::max(cone.angle, angle_between(cone.axis, direction));
  return cone;
}

/// Where the faces along the rim look and where they would go on.
void measure_directions(const PolyMesh& mesh, const SurfaceView& view, Hole& hole) {
  std::vector<Vec3> normals, conormals;
  std::vector<double> lengths;
  for (const Index corner : hole.corners) {
    const Vec3 normal = normal_of(mesh, view, corner / 3);
    const Vec3 edge = mesh.positions[view.target(corner)] - mesh.positions[view.origin(corner)];
    if (normal.isZero(0)) continue;
    normals.push_back(normal);
    conormals.push_back(edge.cross(normal).normalized());
    lengths.push_back(edge.norm());
  }
  hole.rim_normals = cone_of(normals, lengths);
  hole.conormal = cone_of(conormals, lengths).axis;
  const Vec3 axis = hole.conormal.dot(hole.normal) < 0 ? Vec3(-hole.normal) : hole.normal;
  double sum = 0, weight = 0;
  for (std::size_t i = 0; i < conormals.size(); ++i) {
    sum += lengths[i] * angle_between(conormals[i], axis);
    weight += lengths[i];
  }
  hole.conormal_tilt = weight > 0 ? sum / weight : std::numbers::pi / 2;
}

Box grown_box(const PolyMesh& mesh, const Hole& hole) {
  const Box box = box_of(hole.vertices, [&](Index vertex) -> const Vec3& { return mesh.positions[vertex]; });
  // The same in all directions: per axis, parallel flat rims would stay apart however near they are.
  const Vec3 reach = Vec3::Constant(hole.diameter / 2);
  return {box.min() - reach, box.max() + reach};
}

/// A sheet's border: its longest rim, of a diameter above this share of the sheet's diagonal.
constexpr double border_diameter = 0.5;

/// An open cross-section, as the base of a statue: above this share of the component's diagonal, …
constexpr double section_diameter = 0.25;
/// … and faces that lead straight on out of its plane within this angle on average, however ragged or bent the rim is,
/// but for rims that have no plane (× diameter); …
constexpr double section_tilt = 25 * std::numbers::pi / 180;
constexpr double section_planarity = 0.2;
/// … or within this angle, where the rim is so flat as only a cut is: a torn rim goes half an edge to and fro along the
/// faces. × diameter, and × mean edge × cosine of their angle
constexpr double cut_tilt = 60 * std::numbers::pi / 180;
constexpr double flat_planarity = 0.02;
constexpr double cut_planarity = 0.35;

/// A slit's width is this many mean edges at most (its area over its length) …
constexpr double slit_width = 1.5;
/// … and so long that there and back is nearly all of its perimeter.
constexpr double slit_length = 0.42;

/// An island lies this near to the plane of the hole around it, × the hole's diameter.
constexpr double island_height = 0.5;

/// Rims of a tunnel look at each other within this angle, differ at most so much in size, and aren't further apart than
/// the larger diameter.
constexpr double tunnel_angle = 40 * std::numbers::pi / 180;
constexpr double tunnel_ratio = 2;

class Classifier {
 public:
  Classifier(const PolyMesh& mesh, const HoleAnalysisOptions& options, HoleAnalysis& analysis)
      : mesh_(mesh), options_(options), analysis_(analysis), is_outer_(analysis.holes.size()) {
    for (const Hole& hole : analysis.holes) is_outer_[hole.id] = is_open_section(hole);
    for (const Index hole : longest_rims()) is_outer_[hole] = is_outer_[hole] || is_border(analysis.holes[hole]);
  }

  void run() {
    for (Hole& hole : analysis_.holes) hole.kind = alone(hole);
    const auto pairs = near_pairs(mesh_, analysis_.holes);
    for (const auto& [a, b] : pairs) join_if_island(a, b);
    for (const auto& [a, b] : pairs) join_if_tunnel(a, b);
  }

 private:
  std::vector<Hole>& holes() { return analysis_.holes; }

  std::vector<Index> longest_rims() const {
    std::vector<Index> longest(analysis_.component_area.size(), no_index);
    for (const Hole& hole : analysis_.holes) {
      Index& known = longest[hole.component];
      if (known == no_index || analysis_.holes[known].perimeter < hole.perimeter) known = hole.id;
    }
    std::erase(longest, no_index);
    return longest;
  }

  bool is_border(const Hole& hole) const {
    return hole.diameter > border_diameter * analysis_.component_diagonal[hole.component] ||
           hole.area > analysis_.component_area[hole.component];
  }

  bool is_open_section(const Hole& hole) const {
    const bool is_wide = hole.diameter > section_diameter * analysis_.component_diagonal[hole.component];
    if (!is_wide) return false;
    if (hole.conormal_tilt < section_tilt) return hole.planarity < section_planarity;
    return hole.conormal_tilt < cut_tilt && is_cut_flat(hole);
  }

  static bool is_cut_flat(const Hole& hole) {
    return hole.planarity < flat_planarity &&
           hole.planarity * hole.diameter < cut_planarity * std::cos(hole.conormal_tilt) * mean_edge(hole);
  }

  static double mean_edge(const Hole& hole) { return hole.perimeter / static_cast<double>(hole.vertices.size()); }

  bool is_slit(const Hole& hole) const {
    return hole.diameter > slit_length * hole.perimeter && hole.area < slit_width * mean_edge(hole) * hole.diameter;
  }

  HoleClass alone(const Hole& hole) const {
    if (is_outer_[hole.id]) return HoleClass::Outer;
    if (hole.shares_vertex) return HoleClass::BowTie;
    if (hole.vertices.size() <= options_.small_edges) return HoleClass::Small;
    return is_slit(hole) ? HoleClass::Slit : HoleClass::Simple;
  }

  void join(Hole& a, Hole& b, HoleClass kind) {
    a.kind = b.kind = kind;
    a.companions.push_back(b.id);
    b.companions.push_back(a.id);
  }

  /// The border of one component in a hole of another.
  void join_if_island(Index a, Index b) {
    const bool b_is_smaller = holes()[b].diameter < holes()[a].diameter;
    Hole& hole = holes()[b_is_smaller ? a : b];
    Hole& island = holes()[b_is_smaller ? b : a];
    if (!is_outer_[island.id] || is_outer_[hole.id] || hole.component == island.component) return;
    if (!island.companions.empty() || !are_compatible(hole, island) || !surrounds(hole, island)) return;
    join(hole, island, HoleClass::Islands);
  }

  bool surrounds(const Hole& hole, const Hole& island) const {
    std::vector<Vec3> rim;
    for (auto vertex = hole.vertices.rbegin(); vertex != hole.vertices.rend(); ++vertex)
      rim.push_back(mesh_.positions[*vertex]);
    const RimPlane plane = plane_of_rim(rim);
    if (std::abs(plane.normal.dot(island.centre - plane.centre)) > island_height * hole.diameter) return false;
    const Vec2 at = plane.project(island.centre);
    double turn = 0;
    for (std::size_t i = 0; i < rim.size(); ++i) {
      const Vec2 from = plane.project(rim[i]) - at;
      const Vec2 to = plane.project(rim[i + 1 == rim.size() ? 0 : i + 1]) - at;
      turn += std::atan2(cross(from, to), from.dot(to));
    }
    return std::abs(turn) > std::numbers::pi;
  }

  void join_if_tunnel(Index i, Index k) {
    Hole& a = holes()[i];
    Hole& b = holes()[k];
    if (a.component == b.component || !a.companions.empty() || !b.companions.empty()) return;
    const Vec3 gap = b.centre - a.centre;
    const double larger = std::max(a.diameter, b.diameter);
    if (larger > tunnel_ratio * std::min(a.diameter, b.diameter) || !(gap.norm() < larger)) return;
    const double limit = std::cos(tunnel_angle);
    const Vec3 direction = gap.normalized();
    const bool facing = a.conormal.dot(direction) > limit && b.conormal.dot(-direction) > limit &&
                        std::abs(a.normal.dot(direction)) > limit && std::abs(b.normal.dot(direction)) > limit;
    if (facing) join(a, b, HoleClass::Tunnel);
  }

  const PolyMesh& mesh_;
  const HoleAnalysisOptions& options_;
  HoleAnalysis& analysis_;
  std::vector<bool> is_outer_;  ///< by shape alone: also of pieces that turn out to be islands
};

}  // namespace

double greatest_distance(std::span<const Vec3> points) {
  constexpr std::size_t run = 16;
  if (points.size() < 2) return 0;
  std::vector<Box> boxes((points.size() + run - 1) / run);
  for (std::size_t i = 0; i < points.size(); ++i) boxes[i / run].extend(points[i]);
  const auto points_of = [&](std::size_t box) {
    return points.subspan(box * run, std::min(run, points.size() - box * run));
  };
  double longest = long_distance(points);
  for (std::size_t a = 0; a < boxes.size(); ++a) {
    for (std::size_t b = a; b < boxes.size(); ++b) {
      if (greatest_squared(boxes[a], boxes[b]) <= longest) continue;
      for (const Vec3& p : points_of(a)) {
        for (const Vec3& q : points_of(b)) longest = std::max(longest, (p - q).squaredNorm());
      }
    }
  }
  return std::sqrt(longest);
}

void measure_components(const PolyMesh& mesh, HoleAnalysis& analysis) {
  const SurfaceView& view = analysis.view;
  const std::vector<Vec3>& positions = mesh.positions;
  std::vector<Spread> spreads(view.component_count);
  std::vector<Box> boxes(view.component_count);
  for (std::size_t t = 0; t < view.triangles.size(); ++t) {
    const auto& [a, b, c] = view.triangles[t];
    spreads[view.component[t]].add(positions[a], positions[b], positions[c]);
    for (const Index vertex : {a, b, c}) boxes[view.component[t]].extend(positions[vertex]);
  }
  analysis.component_area.clear();
  analysis.component_diagonal.clear();
  analysis.component_size.clear();
  for (Index component = 0; component < view.component_count; ++component) {
    analysis.component_area.push_back(spreads[component].area);
    analysis.component_diagonal.push_back(boxes[component].diagonal().norm());
    analysis.component_size.push_back(spreads[component].size());
  }
  for (Hole& hole : analysis.holes) hole.component = largest_component(analysis, hole);
}

void measure_hole(const PolyMesh& mesh, const SurfaceView& view, const HoleAnalysisOptions& options, Hole& hole,
                  Progress& progress) {
  const std::vector<Vec3> polygon = local_polygon(mesh, hole);
  hole.perimeter = perimeter_of(polygon);
  hole.diameter = greatest_distance(polygon);
  const RimPlane plane = plane_of_rim(polygon);
  hole.centre = plane.centre + mesh.positions[hole.vertices.front()];
  hole.normal = plane.normal;
  double deviation = 0;
  for (const Vec3& point : polygon) deviation = std::max(deviation, std::abs(plane.normal.dot(point - plane.centre)));
  hole.planarity = hole.diameter > 0 ? deviation / hole.diameter : 0;
  measure_directions(mesh, view, hole);
  measure_area(polygon, options, hole, progress);
}

bool are_compatible(const Hole& a, const Hole& b) {
  return a.rim_normals.axis.dot(b.rim_normals.axis) >= std::cos(greatest_group_angle);
}

std::vector<std::array<Index, 2>> near_pairs(const PolyMesh& mesh, std::span<const Hole> holes) {
  std::vector<Box> boxes;
  boxes.reserve(holes.size());
  for (const Hole& hole : holes) boxes.push_back(grown_box(mesh, hole));
  const BoxSearch search(boxes.size(), [&](Index hole) -> const Box& { return boxes[hole]; });
  std::vector<std::array<Index, 2>> pairs;
  for (Index low = 0; low < boxes.size(); ++low) {
    search.visit(boxes[low], [&](Index high) {
      if (low < high) pairs.push_back({low, high});
    });
  }
  std::ranges::sort(pairs);
  return pairs;
}

void classify_holes(const PolyMesh& mesh, const HoleAnalysisOptions& options, HoleAnalysis& analysis) {
  Classifier(mesh, options, analysis).run();
}

}  // namespace croquis::hole_filling

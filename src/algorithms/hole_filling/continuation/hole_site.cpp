// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/hole_filling/hole_site.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <map>
#include <optional>
#include <unordered_map>
#include <utility>

#include <Eigen/Dense>
#include <Eigen/Geometry>

#include "algorithms/hole_filling/analysis/sorted_lists.h"
#include "algorithms/hole_filling/continuation/creases.h"

namespace croquis::hole_filling {
namespace {

// Smoothing for noise, × the usual one.
constexpr double noisy_values = 10;
constexpr double noisy_gradients = 6;

bool lies_before(const Vec3& a, const Vec3& b) {
  return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
}

/// The vertex that is farthest from the rim's middle: however vertices are numbered, and however the mesh lies in
/// space, the same. Of several that are about as far, as on a circle, the one with the least coordinates.
std::vector<Index>::iterator first_of_rim(std::vector<Index>& rim, const std::vector<Vec3>& positions) {
  constexpr double about_as_far = 1 - 1e-9;  // of the squared distance
  Vec3 sum = Vec3::Zero();
  for (const Index v : rim) sum += positions[v] - positions[rim.front()];
  const Vec3 middle = positions[rim.front()] + sum / static_cast<double>(rim.size());
  const auto distance = [&](Index v) { return (positions[v] - middle).squaredNorm(); };
  double farthest = 0;
  for (const Index v : rim) farthest = std::max(farthest, distance(v));
  const auto lies_first = [&](Index a, Index b) {
    const bool a_is_far = distance(a) >= about_as_far * farthest, b_is_far = distance(b) >= about_as_far * farthest;
    return a_is_far != b_is_far ? a_is_far : a_is_far && lies_before(positions[a], positions[b]);
  };
  return std::min_element(rim.begin(), rim.end(), lies_first);
}

/// From the same vertex on, so that a rim gives the same patch however vertices are numbered.
void append_rim(const Hole& hole, HoleSite& site) {
  const std::vector<Vec3>& positions = site.mesh->positions;
  std::vector<Index> rim(hole.vertices.rbegin(), hole.vertices.rend());
  const auto first = static_cast<std::size_t>(first_of_rim(rim, positions) - rim.begin());
  for (std::size_t i = 0; i < rim.size(); ++i) {
    const std::size_t place = (first + i) % rim.size();
    site.vertices.push_back(rim[place]);
    site.corners.push_back(hole.corners[(2 * rim.size() - 2 - place) % rim.size()]);
    site.polygon.points.push_back(positions[rim[place]]);
  }
  site.polygon.loop_ends.push_back(static_cast<Index>(site.vertices.size()));
}

/// The edges between the site's own vertices, as pairs of points of its polygon.
void block_known_edges(HoleSite& site, std::span<const std::array<Index, 2>> rim_edges) {
  std::vector<std::pair<Index, Index>> by_vertex;  // vertex of the view, point
  for (Index point = 0; point < site.vertices.size(); ++point)
    by_vertex.emplace_back(site.analysis->view.representative_of(site.vertices[point]), point);
  std::sort(by_vertex.begin(), by_vertex.end());
  const auto points_of = [&](Index vertex) { return with_key(by_vertex, vertex, &std::pair<Index, Index>::first); };
  for (const auto& [vertex, point] : by_vertex) {
    for (const auto& edge : with_key(rim_edges, vertex, [](const auto& e) { return e[0]; })) {
      for (const auto& [other, other_point] : points_of(edge[1])) {
        const auto [low, high] = std::minmax({point, other_point});
        site.polygon.blocked.push_back({low, high});
      }
    }
  }
  std::sort(site.polygon.blocked.begin(), site.polygon.blocked.end());
}

/// Dijkstra over the edges of the view.
class Reach {
 public:
  Reach(const HoleSite& site, double reach)
      : view_(site.analysis->view),
        positions_(site.mesh->positions),
        reach_(reach),
        crease_cosine_(crease_cosine(site)) {
    const std::map<Index, Index> ranks = ranks_of(site);
    for (const Index id : site.holes) {
      for (const Index start : site.analysis->holes[id].corners) {
        for (const Index corner : {start, SurfaceView::next(start)}) {
          const auto rank = ranks.find(view_.origin(corner));
          offer(corner, 0, rank == ranks.end() ? no_index : rank->second);
        }
      }
    }
  }

  std::vector<ReachedVertex> run() {
    std::vector<ReachedVertex> reached;
    while (!queue_.empty()) {
      const Entry entry = queue_.front();
      std::pop_heap(queue_.begin(), queue_.end(), is_later_);
      queue_.pop_back();
      double& known = distances_.at(entry.vertex);
      if (entry.distance > known) continue;
      known = -1;  // done: nothing is nearer
      look_around(entry.corner);
      reached.push_back({entry.vertex, entry.distance, normal(), entry.corner, is_on_crease()});
      for (const Spoke& spoke : fan_) {
        offer(spoke.out, entry.distance + spoke.out_length);
        offer(spoke.in, entry.distance + spoke.in_length);
      }
    }
    return reached;
  }

 private:
  struct Entry {
    double distance;
    Index vertex;
    Index corner;  ///< one at the vertex
    Index rank;    ///< of rim vertices, along the rims; no_index beside them
  };

  static std::map<Index, Index> ranks_of(const HoleSite& site) {
    std::map<Index, Index> ranks;
    for (Index i = 0; i < site.vertices.size(); ++i)
      ranks.try_emplace(site.analysis->view.representative_of(site.vertices[i]), i);
    return ranks;
  }

  /// A triangle of the fan around a vertex, with the corners at its other vertices.
  struct Spoke {
    Index triangle;
    Index out, in;
    double out_length, in_length;
    Vec3 across;   ///< its normal, as long as twice its area
    double angle;  ///< at the vertex
  };

  /// Rim vertices come in the order of the rims, so that neither the numbers of vertices matter nor how the mesh lies
  /// in space. Of other places equally far the one with the least coordinates comes first.
  struct IsLater {
    const std::vector<Vec3>& positions;

    bool operator()(const Entry& a, const Entry& b) const {
      if (a.distance != b.distance) return a.distance > b.distance;
      if (a.rank != b.rank) return a.rank > b.rank;
      const Vec3 &p = positions[a.vertex], &q = positions[b.vertex];
      if (p != q) return lies_before(q, p);
      return a.vertex != b.vertex ? a.vertex > b.vertex : a.corner > b.corner;
    }
  };

  void offer(Index corner, double distance, Index rank = no_index) {
    if (!(distance <= reach_)) return;
    const Index vertex = view_.origin(corner);
    const auto [known, is_new] = distances_.try_emplace(vertex, distance);
    if (!is_new && !(distance < known->second)) return;
    known->second = distance;
    queue_.push_back({distance, vertex, corner, rank});
    std::push_heap(queue_.begin(), queue_.end(), is_later_);
  }

  /// Takes the fan around a corner's vertex, by the numbers of its triangles.
  void look_around(Index corner) {
    triangles_.assign(1, corner / 3);
    add_fan(view_, corner, triangles_);
    sort_unique(triangles_);
    const Index vertex = view_.origin(corner);
    const Vec3& place = positions_[vertex];
    fan_.clear();
    for (const Index triangle : triangles_) {
      Index here = 3 * triangle;
      while (view_.origin(here) != vertex) ++here;
      Spoke spoke{triangle, SurfaceView::next(here), SurfaceView::previous(here), 0, 0, {}, 0};
      const Vec3 out = positions_[view_.origin(spoke.out)] - place, in = positions_[view_.origin(spoke.in)] - place;
      spoke.out_length = out.norm();
      spoke.in_length = in.norm();
      spoke.across = out.cross(in);
      spoke.angle = std::atan2(spoke.across.norm(), out.dot(in));
      fan_.push_back(spoke);
    }
  }

  Vec3 normal() const {
    Vec3 sum = Vec3::Zero();
    for (const Spoke& spoke : fan_) {
      if ((view_.flags[spoke.triangle] & (SurfaceView::NoArea | SurfaceView::Sliver)) != 0) continue;
      const double length = spoke.across.norm();
      if (length > 0) sum += spoke.angle / length * spoke.across;
    }
    const double length = sum.norm();
    return length > 0 ? Vec3(sum / length) : Vec3(Vec3::Zero());
  }

  /// Any two triangles that share an edge of the fan are compared.
  bool is_on_crease() const {
    for (const Spoke& spoke : fan_) {
      const Index edge = SurfaceView::previous(spoke.out);
      if (!view_.has_opposite(edge)) continue;
      const Index beyond = view_.opposite[edge] / 3;
      const auto other = std::find_if(fan_.begin(), fan_.end(), [&](const Spoke& s) { return s.triangle == beyond; });
      if (other != fan_.end() && !is_smooth(spoke.across, other->across, crease_cosine_)) return true;
    }
    return false;
  }

  const SurfaceView& view_;
  const std::vector<Vec3>& positions_;
  double reach_, crease_cosine_;
  std::unordered_map<Index, double> distances_;  ///< of vertices met, the least so far; -1 once it is final
  std::vector<Entry> queue_;                     ///< a heap, the nearest first
  const IsLater is_later_{positions_};
  std::vector<Index> triangles_;
  std::vector<Spoke> fan_;
};

constexpr std::size_t neighbour_count = 16;
constexpr Eigen::Index normal_terms = 5;
constexpr Eigen::Index least_neighbours = 7;       // for five unknowns
constexpr double same_way = 0.5;                   // cosine between neighbours' normals
constexpr double least_quadric_agreement = 0.866;  // cosine between the old normal and the new
constexpr std::size_t most_places = 100;           // at which roughness is measured
constexpr std::size_t rough_neighbours = 17;       // the vertex itself among them
constexpr Eigen::Index quadric_terms = 6;
constexpr Eigen::Index least_rough = 10;
constexpr std::size_t usual_neighbour = 2;  // the third nearest: its distance is that of neighbours

/// Equations of a few neighbours: on the stack.
template <Eigen::Index terms>
using Rows = Eigen::Matrix<double, Eigen::Dynamic, terms, 0, rough_neighbours, terms>;
using Heights = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, rough_neighbours, 1>;

/// By the slopes of z = a x + b y + c x² + d x y + e y² at 0, weighted by 1 / distance, in a frame whose z axis is the
/// normal, scaled to about 1.
Vec3 fitted_normal(const Vec3& place, const Vec3& normal, const std::vector<Vec3>& neighbours) {
  const auto rows = static_cast<Eigen::Index>(neighbours.size());
  if (rows < least_neighbours) return normal;
  const Vec3 x = normal.unitOrthogonal(), y = normal.cross(x);
  double size = 0;
  for (const Vec3& neighbour : neighbours) size = std::max(size, (neighbour - place).norm());
  Rows<normal_terms> matrix(rows, normal_terms);
  Heights heights(rows);
  for (Eigen::Index i = 0; i < rows; ++i) {
    const Vec3 away = (neighbours[static_cast<std::size_t>(i)] - place) / size;
    const Vec3 p(away.dot(x), away.dot(y), away.dot(normal));
    const double weight = 1 / p.norm();
    matrix.row(i) << p.x(), p.y(), p.x() * p.x(), p.x() * p.y(), p.y() * p.y();
    matrix.row(i) *= weight;
    heights[i] = weight * p.z();
  }
  const Eigen::ColPivHouseholderQR<Rows<normal_terms>> solver(matrix);
  if (solver.rank() < normal_terms) return normal;
  const Eigen::Matrix<double, normal_terms, 1> quadric = solver.solve(heights);
  const Vec3 found = (normal - quadric[0] * x - quadric[1] * y).normalized();
  return found.allFinite() && found.dot(normal) > least_quadric_agreement ? found : normal;
}

/// Standard deviation of the offsets (the place's own, 0, among them) from their quadric, × the neighbours' distance.
/// @param offsets nearest first
std::optional<double> roughness_at(const std::vector<Vec3>& offsets, const Vec3& normal) {
  const auto rows = static_cast<Eigen::Index>(offsets.size());
  if (rows < least_rough) return std::nullopt;
  const Vec3 x = normal.unitOrthogonal(), y = normal.cross(x);
  const double size = offsets.back().norm();
  Rows<quadric_terms> matrix(rows, quadric_terms);
  Heights heights(rows);
  for (Eigen::Index i = 0; i < rows; ++i) {
    const Vec3& p = offsets[static_cast<std::size_t>(i)];
    const double u = p.dot(x) / size, v = p.dot(y) / size;
    matrix.row(i) << 1, u, v, u * u, u * v, v * v;
    heights[i] = p.dot(normal);
  }
  const Heights rest = heights - matrix * matrix.colPivHouseholderQr().solve(heights);
  const double spacing = offsets[usual_neighbour + 1].norm();
  if (!(spacing > 0)) return std::nullopt;
  return rest.norm() / std::sqrt(static_cast<double>(rows - quadric_terms)) / spacing;
}

}  // namespace

HoleSite make_site(const PolyMesh& mesh, const HoleAnalysis& analysis, std::span<const Index> holes,
                   std::span<const std::array<Index, 2>> rim_edges) {
  HoleSite site;
  site.mesh = &mesh;
  site.analysis = &analysis;
  site.holes.assign(holes.begin(), holes.end());
  std::vector<Index> order = site.holes;
  std::stable_sort(order.begin(), order.end(),
                   [&](Index a, Index b) { return analysis.holes[a].diameter > analysis.holes[b].diameter; });
  for (const Index id : order) append_rim(analysis.holes[id], site);
  block_known_edges(site, rim_edges);
  return site;
}

PatchSettings adapted(PatchSettings settings, Preset preset) {
  if (preset == Preset::Noisy) {
    settings.implicit.value_smoothing *= noisy_values;
    settings.implicit.gradient_smoothing *= noisy_gradients;
  }
  if (preset == Preset::Paper) settings.implicit.both_sides = false;
  return settings;
}

double rim_length(const HoleSite& site) {
  double length = 0;
  for (const Index id : site.holes) length += site.analysis->holes[id].perimeter;
  return length;
}

double mean_rim_edge(const HoleSite& site) {
  return rim_length(site) / static_cast<double>(std::max<std::size_t>(1, site.vertices.size()));
}

const Hole& widest_hole(const HoleSite& site) {
  const auto diameter = [&](Index hole) { return site.analysis->holes[hole].diameter; };
  return site.analysis->holes[std::ranges::max(site.holes, {}, diameter)];
}

double widest_diameter(const HoleSite& site) { return widest_hole(site).diameter; }

Vec3 triangle_normal(const HoleSite& site, Index triangle) {
  return site.analysis->view.normal(triangle, site.mesh->positions);
}

void add_fan(const SurfaceView& view, Index corner, std::vector<Index>& triangles) {
  const Index pivot = view.origin(corner);
  for (Index edge : {corner, SurfaceView::previous(corner)}) {
    while (view.has_opposite(edge) && view.opposite[edge] / 3 != corner / 3) {
      const Index other = view.opposite[edge];
      triangles.push_back(other / 3);
      edge = view.other_edge_at(other, pivot);
    }
  }
}

std::vector<Index> surroundings(const HoleSite& site, int rings) {
  const SurfaceView& view = site.analysis->view;
  std::vector<Index> triangles;
  for (const Index id : site.holes) {
    for (const Index corner : site.analysis->holes[id].corners) {
      triangles.push_back(corner / 3);
      add_fan(view, corner, triangles);
      add_fan(view, SurfaceView::next(corner), triangles);
    }
  }
  sort_unique(triangles);
  std::vector<Index> outer = triangles;  // what lies further in has its neighbours
  for (int ring = 1; ring < rings; ++ring) {
    std::vector<Index> around, next;
    for (const Index triangle : outer) {
      for (Index corner = 3 * triangle; corner < 3 * triangle + 3; ++corner) add_fan(view, corner, around);
    }
    sort_unique(around);
    std::ranges::set_difference(around, triangles, std::back_inserter(next));
    const auto inner = std::ssize(triangles);
    triangles.insert(triangles.end(), next.begin(), next.end());
    std::inplace_merge(triangles.begin(), triangles.begin() + inner, triangles.end());
    outer = std::move(next);
  }
  return triangles;
}

std::vector<ReachedVertex> reach_from_rims(const HoleSite& site, double reach) { return Reach(site, reach).run(); }

implicit::PointTree tree_of(const std::vector<ReachedVertex>& reached, const std::vector<Vec3>& positions) {
  std::vector<Vec3> places;
  for (const ReachedVertex& r : reached) places.push_back(positions[r.vertex]);
  return implicit::PointTree(places);
}

double surface_roughness(const std::vector<ReachedVertex>& reached, const std::vector<Vec3>& positions,
                         const implicit::PointTree& tree) {
  std::vector<double> found;
  for (std::size_t i = 0; i < reached.size(); i += reached.size() / most_places + 1) {
    if (reached[i].normal == Vec3::Zero()) continue;
    const Vec3& place = positions[reached[i].vertex];
    std::vector<Vec3> offsets;
    for (const Index j : tree.nearest(place, rough_neighbours)) {
      if (reached[j].normal.dot(reached[i].normal) > same_way) offsets.push_back(positions[reached[j].vertex] - place);
    }
    if (const auto roughness = roughness_at(offsets, reached[i].normal)) found.push_back(*roughness);
  }
  if (found.empty()) return 0;
  const auto middle = found.begin() + static_cast<std::ptrdiff_t>(found.size() / 2);
  std::nth_element(found.begin(), middle, found.end());
  return *middle;
}

void fit_rim_normals(std::vector<ReachedVertex>& reached, const std::vector<Vec3>& positions,
                     const implicit::PointTree& tree) {
  std::vector<Vec3> normals;
  for (std::size_t i = 0; i < reached.size() && reached[i].distance == 0; ++i) {
    const Vec3& place = positions[reached[i].vertex];
    std::vector<Vec3> neighbours;
    for (const Index j : tree.nearest(place, neighbour_count)) {
      const Vec3& neighbour = positions[reached[j].vertex];
      if (neighbour != place && reached[j].normal.dot(reached[i].normal) > same_way) neighbours.push_back(neighbour);
    }
    normals.push_back(fitted_normal(place, reached[i].normal, neighbours));
  }
  for (std::size_t i = 0; i < normals.size(); ++i) reached[i].normal = normals[i];
}

}  // namespace croquis::hole_filling

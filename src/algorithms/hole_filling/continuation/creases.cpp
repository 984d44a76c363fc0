// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/hole_filling/continuation/creases.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <unordered_map>

#include <Eigen/Geometry>

#include "algorithms/hole_filling/analysis/sorted_lists.h"
#include "algorithms/hole_filling/continuation/rim_field.h"
#include "algorithms/hole_filling/patching/patch_methods.h"
#include "croquis/base/error.h"
#include "croquis/geometry/disjoint_sets.h"

namespace croquis::hole_filling {
namespace {

constexpr double radians = std::numbers::pi / 180;
constexpr double least_crease = 12 * radians, most_crease = 35 * radians;
constexpr double crease_factor = 4;  // × the angle of usual edges
constexpr double usual_share = 0.8;  // of edges: creases that pass are fewer than the others
constexpr int looked_rings = 3;

/// Falls as the angle grows, and takes a fraction of its time.
double cotangent_between(const Vec3& a, const Vec3& b) {
  const double along = a.dot(b), across = a.cross(b).norm();
  if (across > 0) return along / across;
  return along < 0 ? -std::numeric_limits<double>::infinity() : std::numeric_limits<double>::infinity();
}

double found_crease_cosine(const HoleSite& site) {
  const SurfaceView& view = site.analysis->view;
  std::vector<double> cotangents;
  for (const Index triangle : surroundings(site, looked_rings)) {
    for (Index corner = 3 * triangle; corner < 3 * triangle + 3; ++corner) {
      const Index other = view.opposite[corner];
      if (view.has_opposite(corner) && corner < other)
        cotangents.push_back(cotangent_between(triangle_normal(site, triangle), triangle_normal(site, other / 3)));
    }
  }
  if (cotangents.empty()) return std::cos(most_crease);
  const auto usual =
      cotangents.begin() + static_cast<std::ptrdiff_t>(usual_share * static_cast<double>(cotangents.size() - 1));
  std::nth_element(cotangents.begin(), usual, cotangents.end(), std::greater());
  const double usual_angle = std::atan2(1.0, *usual);
  return std::cos(std::clamp(crease_factor * usual_angle, least_crease, most_crease));
}

/// All at the vertices reached, ascending.
std::vector<Index> triangles_at(const SurfaceView& view, const std::vector<ReachedVertex>& reached) {
  std::vector<Index> triangles;
  for (const ReachedVertex& r : reached) {
    triangles.push_back(r.corner / 3);
    add_fan(view, r.corner, triangles);
  }
  sort_unique(triangles);
  return triangles;
}

constexpr std::size_t least_triangles = 4;  // of a side: fewer aren't enough

/// Joins the triangles of a known surface over the edges that are no creases.
/// @param normals of its triangles
DisjointSets joined_over_smooth_edges(const KnownSurface& known, const std::vector<Vec3>& normals) {
  DisjointSets sets(known.mesh.face_count());
  std::vector<std::array<Index, 3>> edges;  // low, high, face
  for (Index f = 0; f < known.mesh.face_count(); ++f) {
    const auto c = known.mesh.face(f);
    for (std::size_t i = 0; i < 3; ++i) {
      const auto [low, high] = std::minmax(c[i], c[(i + 1) % 3]);
      edges.push_back({low, high, f});
    }
  }
  std::ranges::sort(edges);
  for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
    const auto &edge = edges[i], &next = edges[i + 1];
    if (next[0] != edge[0] || next[1] != edge[1]) continue;
    if (is_smooth(normals[edge[2]], normals[next[2]], known.crease_cosine)) sets.unite(edge[2], next[2]);
  }
  return sets;
}

SmoothSide side_of(const PolyMesh& mesh, const std::vector<Vec3>& normals, const std::vector<Index>& part) {
  std::vector<std::pair<Index, Index>> uses;  // vertex, triangle
  for (const Index f : part) {
    for (const Index v : mesh.face(f)) uses.emplace_back(v, f);
  }
  std::ranges::sort(uses);
  SmoothSide side;
  for (std::size_t i = 0; i < uses.size();) {
    const Index v = uses[i].first;
    Vec3 sum = Vec3::Zero();
    for (; i < uses.size() && uses[i].first == v; ++i) sum += normals[uses[i].second];
    if (!(sum.norm() > 0)) continue;
    side.vertices.push_back(v);
    side.normals.push_back(sum.normalized());
  }
  return side;
}

using Node = CreaseField::Node;
using Tree = std::vector<Node>;

constexpr double least_side_reach = 6;  // × edge
constexpr std::size_t most_known = 4000;
constexpr std::size_t most_sides = 5;           // the number of trees grows as the factorial
constexpr std::size_t most_side_centres = 120;  // per side
constexpr double first_spacing = 0.7;           // of centres, × edge
constexpr double side_spacing_slope = 0.25;     // by how much it grows per distance from the rim
constexpr double side_spacing_growth = 1.2;
constexpr std::size_t most_samples = 1000;

/// Places in the side's list: none nearer to another than the spacing there.
std::vector<std::size_t> spread(const KnownSurface& known, const SmoothSide& side) {
  for (double scale = first_spacing;; scale *= side_spacing_growth) {
    const auto taken = spread_out(
        side.vertices.size(), [&](std::size_t i) -> const Vec3& { return known.mesh.positions[side.vertices[i]]; },
        [&](std::size_t i) {
          return std::max(scale * known.edge, side_spacing_slope * known.distance[side.vertices[i]]);
        },
        most_side_centres);
    if (taken) return *taken;
  }
}

std::shared_ptr<const implicit::LocalFit> fit_of(const KnownSurface& known, const SmoothSide& side,
                                                 const ImplicitOptions& options) {
  implicit::Constraints constraints;
  for (const std::size_t i : spread(known, side)) {
    constraints.positions.push_back(known.mesh.positions[side.vertices[i]]);
    constraints.gradients.push_back(side.normals[i]);
  }
  implicit::FitOptions how;
  how.value_smoothing = options.value_smoothing;
  how.gradient_smoothing = options.gradient_smoothing;
  how.spacing = known.edge;
  try {
    return std::make_shared<const implicit::LocalFit>(constraints, how);
  } catch (const Error&) {
    return nullptr;
  }
}

/// All trees over the sides of a set (bits).
std::vector<Tree> trees_over(unsigned sides) {
  const unsigned lowest = sides & (~sides + 1);
  if (sides == lowest) {
    Node leaf;
    while ((1U << static_cast<unsigned>(leaf.side + 1)) <= sides) ++leaf.side;
    return {{leaf}};
  }
  std::vector<Tree> trees;
  for (unsigned part = (sides - 1) & sides; part > 0; part = (part - 1) & sides) {
    if ((part & lowest) == 0) continue;  // each split once
    for (const Tree& first : trees_over(part)) {
      for (const Tree& second : trees_over(sides & ~part)) {
        for (const bool is_greater : {true, false}) {
          Tree tree = first;
          for (Node node : second) {
            if (node.side < 0) {
              node.first += first.size();
              node.second += first.size();
            }
            tree.push_back(node);
          }
          tree.push_back({-1, is_greater, first.size() - 1, tree.size() - 1});
          trees.push_back(std::move(tree));
        }
      }
    }
  }
  return trees;
}

CreaseField::Value value_of(const Tree& tree, std::span<const double> sides) {
  std::array<CreaseField::Value, 2 * most_sides> values;
  for (std::size_t i = 0; i < tree.size(); ++i) {
    const Node& node = tree[i];
    if (node.side >= 0) {
      const auto side = static_cast<std::size_t>(node.side);
      values[i] = {sides[side], side};
    } else {
      const auto &a = values[node.first], &b = values[node.second];
      values[i] = (a.value > b.value) == node.is_greater ? a : b;
    }
  }
  return values[tree.size() - 1];
}

}  // namespace

double crease_cosine(const HoleSite& site) {
  if (site.memory == nullptr) return found_crease_cosine(site);
  std::optional<double>& known = site.memory->crease_cosine;
  if (!known) known = found_crease_cosine(site);
  return *known;
}

bool is_smooth(const Vec3& normal, const Vec3& other, double crease_cosine) {
  return normal.dot(other) >= crease_cosine * normal.norm() * other.norm();
}

KnownSurface known_surface(const HoleSite& site, double reach, double least_reach, std::size_t most_vertices) {
  auto reached = reach_from_rims(site, std::max(reach * widest_diameter(site), least_reach * mean_rim_edge(site)));
  if (reached.size() > most_vertices) reached.resize(most_vertices);
  return known_surface(site, reached);
}

KnownSurface known_surface(const HoleSite& site, const std::vector<ReachedVertex>& reached) {
  const SurfaceView& view = site.analysis->view;
  KnownSurface known;
  known.edge = mean_rim_edge(site);
  known.size = widest_diameter(site);
  known.crease_cosine = crease_cosine(site);
  std::unordered_map<Index, Index> numbers;  // of the view's vertices
  for (const ReachedVertex& r : reached) {
    numbers.emplace(r.vertex, static_cast<Index>(numbers.size()));
    known.mesh.positions.push_back(site.mesh->positions[r.vertex]);
    known.distance.push_back(r.distance);
  }
  for (const Index triangle : triangles_at(view, reached)) {
    const Triangle& t = view.triangles[triangle];
    if (std::ranges::all_of(t, [&](Index v) { return numbers.contains(v); }))
      known.mesh.add_triangle(numbers.at(t[0]), numbers.at(t[1]), numbers.at(t[2]));
  }
  return known;
}

std::vector<SmoothSide> smooth_sides(const KnownSurface& known) {
  const PolyMesh& mesh = known.mesh;
  std::vector<Vec3> normals;  // per triangle, as long as twice its area
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto c = mesh.face(f);
    const Vec3& a = mesh.positions[c[0]];
    normals.push_back((mesh.positions[c[1]] - a).cross(mesh.positions[c[2]] - a));
  }
  const auto is_at_rim = [&](Index face) {
    return std::ranges::count_if(mesh.face(face), [&](Index v) { return known.distance[v] == 0; }) >= 2;
  };
  std::vector<SmoothSide> sides;
  for (const std::vector<Index>& part : joined_over_smooth_edges(known, normals).lists()) {
    if (part.size() >= least_triangles && std::ranges::any_of(part, is_at_rim))
      sides.push_back(side_of(mesh, normals, part));
  }
  return sides;
}

CreaseField::Value CreaseField::value(const Vec3& point) const {
  std::vector<double> values;
  for (const auto& fit : fits_) values.push_back(fit->value(point));
  return value_of(tree_, values);
}

implicit::Field CreaseField::field() const {
  return [own = *this](std::span<const Vec3> points, std::span<double> values, std::span<Vec3> gradients) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Value found = own.value(points[i]);
      values[i] = found.value;
      if (!gradients.empty()) gradients[i] = own.fits_[found.side]->gradient(points[i]);
    }
  };
}

bool creases_run_in(const HoleSite& site) {
  const SurfaceView& view = site.analysis->view;
  const double cosine = crease_cosine(site);
  std::size_t ends = 0;
  for (const Index id : site.holes) {
    for (const Index rim_corner : site.analysis->holes[id].corners) {
      const Index pivot = view.origin(rim_corner);
      for (Index edge = SurfaceView::previous(rim_corner); view.has_opposite(edge);) {
        const Index other = view.opposite[edge];
        if (!is_smooth(triangle_normal(site, edge / 3), triangle_normal(site, other / 3), cosine) && ++ends == 2)
          return true;
        edge = view.other_edge_at(other, pivot);
      }
    }
  }
  return false;
}

std::optional<CreaseField> fit_sides(const HoleSite& site, double most_residual) {
  const ImplicitOptions& options = site.settings.implicit;
  const KnownSurface known = known_surface(site, options.reach, least_side_reach, most_known);
  const std::vector<SmoothSide> sides = smooth_sides(known);
  if (sides.size() < 2 || sides.size() > most_sides) return std::nullopt;
  std::vector<std::shared_ptr<const implicit::LocalFit>> fits;
  for (const SmoothSide& side : sides) {
    fits.push_back(fit_of(known, side, options));
    if (!fits.back()) return std::nullopt;
  }
  std::vector<std::vector<double>> samples;  // values of all sides, per place
  std::size_t count = 0;
  for (const SmoothSide& side : sides) count += side.vertices.size();
  for (const SmoothSide& side : sides) {
    for (std::size_t i = 0; i < side.vertices.size(); i += count / most_samples + 1) {
      samples.emplace_back();
      for (const auto& fit : fits) samples.back().push_back(fit->value(known.mesh.positions[side.vertices[i]]));
    }
  }
  Tree best;
  double least = most_residual * known.edge * static_cast<double>(samples.size());
  for (const Tree& tree : trees_over((1U << sides.size()) - 1)) {
    double sum = 0;
    for (const auto& values : samples) sum += std::abs(value_of(tree, values).value);
    if (!(sum < least)) continue;
    least = sum;
    best = tree;
  }
  if (best.empty()) return std::nullopt;
  return CreaseField(std::move(fits), std::move(best));
}

}  // namespace croquis::hole_filling

// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/hole_filling/continuation/rim_field.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "algorithms/hole_filling/continuation/creases.h"
#include "croquis/base/error.h"
#include "croquis/hole_filling/hole_site.h"
#include "croquis/implicit/offset_points.h"
#include "croquis/implicit/point_tree.h"

namespace croquis::hole_filling {
namespace {

constexpr double spread_growth = 1.3;

std::vector<PassingPoint> all_passing(const HoleSite& site, const std::vector<ReachedVertex>& reached, double reach) {
  const SurfaceView& view = site.analysis->view;
  const std::vector<Vec3>& positions = site.mesh->positions;
  std::vector<Index> joined;
  for (const ReachedVertex& r : reached) joined.push_back(r.vertex);
  std::ranges::sort(joined);
  const implicit::PointTree rims(site.polygon.points);
  const implicit::Box box = implicit::bounds(site.polygon.points);
  const Vec3 low = box.low - Vec3::Constant(reach), high = box.high + Vec3::Constant(reach);
  std::vector<PassingPoint> passing;
  for (Index t = 0; t < view.triangles.size(); ++t) {
    const auto& [a, b, c] = view.triangles[t];
    const Vec3 middle = (positions[a] + positions[b] + positions[c]) / 3;
    if ((middle.array() < low.array()).any() || (middle.array() > high.array()).any() || view.flags[t] > 1) continue;
    const bool is_joined =
        std::ranges::any_of(view.triangles[t], [&](Index v) { return std::ranges::binary_search(joined, v); });
    if (is_joined || (site.polygon.points[rims.nearest(middle)] - middle).norm() > reach) continue;
    passing.push_back({middle, view.normal(t, positions).normalized()});
  }
  return passing;
}

constexpr int tangent_smoothings = 3;        // of the tangents: rims of removed triangles run in a zigzag
constexpr std::size_t hinge_neighbours = 6;  // rim vertices that a point is turned about

/// Both neighbours' difference, then each the mean with its neighbours'.
std::vector<Vec3> rim_tangents(const RimPolygon& polygon) {
  std::vector<Index> previous(polygon.points.size());
  for (Index i = 0; i < polygon.points.size(); ++i) previous[polygon.next(i)] = i;
  std::vector<Vec3> tangents;
  for (Index i = 0; i < polygon.points.size(); ++i)
    tangents.push_back((polygon.points[polygon.next(i)] - polygon.points[previous[i]]).normalized());
  for (int round = 0; round < tangent_smoothings; ++round) {
    const std::vector<Vec3> before = tangents;
    for (Index i = 0; i < tangents.size(); ++i)
      tangents[i] = (before[previous[i]] + 2 * before[i] + before[polygon.next(i)]).normalized();
  }
  return tangents;
}

constexpr double least_reach = 4;       // × edge
constexpr double quick_reach = 0.75;    // × the reach asked for, where few normals count
constexpr double rim_spacing = 0.7;     // of centres at the rim, × edge
constexpr double spacing_slope = 0.25;  // by how much spacing grows per distance from the rim
constexpr double spacing_growth = 1.15;
constexpr double normal_spacing = 2;     // of centres whose normals count, × edge, and at least
constexpr double normal_slope = 1;       // per distance from the rim
constexpr double most_slope_growth = 2;  // else long rims would take all centres and leave none behind them
constexpr double worst_residual = 0.5;   // × edge, or for long rims × what the centres resolve
constexpr double rough_residual = 5;     // × roughness × that, if it is more: rough rims lie off what is smooth
constexpr std::size_t most_candidates = 30000;  // beside the rim; thinning looks at all of them, so more are sampled
constexpr double smoother = 10;

/// In larger holes, × the component's size, quadratic terms lead away from the surface.
constexpr double widest_quintic = 0.25;

/// The smoothing for the surface's roughness: `smooth` + `rough` × (roughness / 0.1)^power.
struct Smoothing {
  double smooth, rough;
  int power;

  double at(double roughness) const {
    double share = 1;
    for (int i = 0; i < power; ++i) share *= roughness / 0.1;
    return smooth + rough * share;
  }
};
constexpr Smoothing quintic_values = {1, 1e4, 8}, quintic_gradients = {1000, 1e4, 2};
constexpr Smoothing cubic_values = {0.1, 10, 4}, cubic_gradients = {0.5, 30, 2};
constexpr double same_normal = 0.99;      // cosine; a vertex on a crease has the normal of its side
constexpr std::size_t most_passing = 80;  // points of other sheets
constexpr double passing_spacing = 2;     // × edge

/// Rims first, the sparser the farther away.
std::optional<std::vector<std::size_t>> thin(const std::vector<ReachedVertex>& reached,
                                             const std::vector<Vec3>& positions, double spacing, double slope,
                                             std::size_t most) {
  return spread_out(
      reached.size(), [&](std::size_t i) -> const Vec3& { return positions[reached[i].vertex]; },
      [&](std::size_t i) { return std::max(spacing, slope * reached[i].distance); }, most);
}

/// What is fitted to.
struct RimData {
  const HoleSite& site;
  double edge = 0;        ///< of the rims, mean
  double roughness = 0;   ///< of the surface around
  double resolution = 0;  ///< the spacing of centres at the rim, an edge at least
  bool every_normal = false;
  std::vector<ReachedVertex> reached = {};
  std::vector<ReachedVertex> centres = {};
  std::vector<PassingPoint> passing = {};
  std::optional<RimHinge> hinge = {};  ///< where the patch is to bulge
};

/// A hole within one smooth side is continued from that side alone: what lies beyond its creases isn't the same
/// surface, and would bend it.
std::vector<ReachedVertex> within_creases(const HoleSite& site, std::vector<ReachedVertex> reached) {
  if (std::ranges::none_of(reached, &ReachedVertex::on_crease)) return reached;
  const std::vector<SmoothSide> sides = smooth_sides(known_surface(site, reached));
  if (sides.size() != 1 || sides.front().vertices.size() == reached.size()) return reached;
  std::vector<ReachedVertex> kept;
  std::size_t next = 0;
  for (Index i = 0; i < reached.size(); ++i) {
    const bool is_inside = next < sides.front().vertices.size() && sides.front().vertices[next] == i;
    if (is_inside && sides.front().normals[next].dot(reached[i].normal) < same_normal)
      reached[i].normal = sides.front().normals[next];
    if (is_inside) ++next;
    if (is_inside || reached[i].distance == 0) kept.push_back(reached[i]);
  }
  return kept;
}

/// All on the rim, and every so many of the others.
std::vector<ReachedVertex> sampled(const std::vector<ReachedVertex>& reached) {
  const std::size_t stride = reached.size() / most_candidates + 1;
  std::vector<ReachedVertex> kept;
  for (std::size_t i = 0; i < reached.size(); ++i) {
    if (reached[i].distance == 0 || i % stride == 0) kept.push_back(reached[i]);
  }
  return kept;
}

bool takes_few_normals(const RimData& data, implicit::Kernel kernel) {
  return !data.every_normal && kernel == implicit::Kernel::HermiteQuintic;
}

void choose_centres(implicit::Kernel kernel, RimData& data) {
  const std::vector<Vec3>& positions = data.site.mesh->positions;
  const std::size_t asked = data.site.settings.implicit.most_centres;
  const std::size_t surplus = takes_few_normals(data, kernel) ? asked / 4 : 0;  // they cost less
  const std::size_t most = std::min(asked + surplus, 2 * data.site.vertices.size() + 40);
  for (double scale = 1;; scale *= spacing_growth) {
    const auto taken = thin(data.reached, positions, scale * rim_spacing * data.edge,
                            std::min(scale, most_slope_growth) * spacing_slope, most);
    if (!taken) continue;
    for (const std::size_t i : *taken) data.centres.push_back(data.reached[i]);
    data.resolution = std::max(1.0, scale * rim_spacing) * data.edge;
    return;
  }
}

/// Which of the centres' normals count.
std::vector<bool> directed_centres(const RimData& data, implicit::Kernel kernel) {
  const std::size_t count = data.centres.size();
  if (!takes_few_normals(data, kernel)) return std::vector<bool>(count, true);
  std::vector<bool> directed(count, false);
  const auto sparse = thin(data.centres, data.site.mesh->positions, normal_spacing * data.edge, normal_slope, count);
  for (const std::size_t i : *sparse) directed[i] = true;
  return directed;
}

/// For kernels with gradients what is asked for, compared with the defaults, is a factor of what the surface needs.
implicit::FitOptions fit_options(const RimData& data, implicit::Kernel kernel, double factor) {
  const ImplicitOptions& asked = data.site.settings.implicit;
  const ImplicitOptions usual;
  implicit::FitOptions options{kernel, factor * asked.value_smoothing, factor * asked.gradient_smoothing, data.edge};
  if (!implicit::takes_gradients(kernel) || data.hinge) return options;  // a turned rim is met less closely
  const bool is_quintic = kernel == implicit::Kernel::HermiteQuintic;
  options.value_smoothing *= (is_quintic ? quintic_values : cubic_values).at(data.roughness) / usual.value_smoothing;
  options.gradient_smoothing *=
      (is_quintic ? quintic_gradients : cubic_gradients).at(data.roughness) / usual.gradient_smoothing;
  return options;
}

/// Places that are met exactly, whatever the smoothing; their normals aren't known.
void go_through(const std::vector<Vec3>& places, implicit::Constraints& constraints) {
  constraints.softness.assign(constraints.size(), 1.0);
  constraints.softness.insert(constraints.softness.end(), places.size(), 0.0);
  constraints.positions.insert(constraints.positions.end(), places.begin(), places.end());
  if (!constraints.values.empty()) constraints.values.resize(constraints.size(), 0.0);
  if (!constraints.gradients.empty()) constraints.gradients.resize(constraints.size(), Vec3::Zero());
}

std::shared_ptr<const implicit::LocalFit> fitted(const RimData& data, implicit::Kernel kernel, double factor) {
  implicit::Constraints constraints;
  const std::vector<bool> directed = directed_centres(data, kernel);
  for (std::size_t c = 0; c < data.centres.size(); ++c) {
    const ReachedVertex& centre = data.centres[c];
    const Vec3& place = data.site.mesh->positions[centre.vertex];
    constraints.positions.push_back(data.hinge ? data.hinge->place(place) : place);
    constraints.gradients.push_back(!directed[c] ? Vec3(Vec3::Zero())
                                    : data.hinge ? data.hinge->normal(place, centre.normal)
                                                 : centre.normal);
  }
  for (const PassingPoint& point : data.passing) {
    constraints.positions.push_back(point.position);
    constraints.gradients.push_back(point.normal);
  }
  try {
    if (!implicit::takes_gradients(kernel))
      constraints = implicit::with_offset_points(constraints.positions, constraints.gradients,
                                                 {0.5 * data.edge, 6, data.site.settings.implicit.both_sides})
                        .constraints;
    if (!data.site.settings.through.empty()) go_through(data.site.settings.through, constraints);
    return std::make_shared<const implicit::LocalFit>(constraints, fit_options(data, kernel, factor));
  } catch (const Error&) {
    return nullptr;  // nothing that could be fitted: another method's turn
  }
}

/// The farthest that the field takes a rim vertex for being off the surface.
double residual(const RimData& data, const implicit::LocalFit& fit) {
  double worst = 0;
  for (const ReachedVertex& reached : data.reached) {
    if (reached.distance > 0) break;
    const double value = std::abs(fit.value(data.site.mesh->positions[reached.vertex]));
    if (!(value <= worst)) worst = value;
  }
  return worst;
}

}  // namespace

std::vector<PassingPoint> other_sheets(const HoleSite& site, const std::vector<ReachedVertex>& reached, double reach,
                                       double spacing, std::size_t most) {
  return spread_out(all_passing(site, reached, reach), spacing, most);
}

std::vector<PassingPoint> spread_out(const std::vector<PassingPoint>& all, double spacing, std::size_t most) {
  for (;; spacing *= spread_growth) {
    const auto taken = spread_out(
        all.size(), [&](std::size_t i) -> const Vec3& { return all[i].position; }, [&](std::size_t) { return spacing; },
        most);
    if (!taken) continue;
    std::vector<PassingPoint> points;
    for (const std::size_t i : *taken) points.push_back(all[i]);
    return points;
  }
}

RimHinge::RimHinge(const HoleSite& site, double bulge)
    : points_(site.polygon.points),
      tangents_(rim_tangents(site.polygon)),
      tree_(points_),
      angle_(bulge * angle_of_bulge) {}

std::vector<RimHinge::Turn> RimHinge::turns_at(const Vec3& point) const {
  std::vector<Turn> turns;
  double sum = 0;
  for (const Index i : tree_.nearest(point, hinge_neighbours)) {
    const double squared = (points_[i] - point).squaredNorm();
    if (squared == 0) return {{tangents_[i], points_[i], 1}};
    turns.push_back({tangents_[i], points_[i], 1 / squared});
    sum += turns.back().weight;
  }
  for (Turn& turn : turns) turn.weight /= sum;
  return turns;
}

Vec3 RimHinge::place(const Vec3& point) const {
  Vec3 moved = Vec3::Zero();
  for (const Turn& turn : turns_at(point))
    moved += turn.weight * (turn.pivot + Eigen::AngleAxisd(angle_, turn.about) * (point - turn.pivot));
  return moved;
}

Vec3 RimHinge::normal(const Vec3& point, const Vec3& normal) const {
  Vec3 turned = Vec3::Zero();
  for (const Turn& turn : turns_at(point)) turned += turn.weight * (Eigen::AngleAxisd(angle_, turn.about) * normal);
  const double length = turned.norm();
  return length > 0 ? Vec3(turned / length) : normal;
}

bool continues_curvature(const HoleSite& site) {
  if (site.settings.implicit.kernel != implicit::Kernel::Hermite || site.polygon.loop_count() != 1) return false;
  const Hole& hole = site.analysis->holes[site.holes.front()];
  return site.settings.bulge == 0 && site.settings.through.empty() &&
         hole.diameter <= widest_quintic * site.analysis->component_size[hole.component];
}

std::optional<RimField> fit_rims(const HoleSite& site, const RimFitOptions& how) {
  const ImplicitOptions& options = site.settings.implicit;
  const std::vector<Vec3>& positions = site.mesh->positions;
  const double size = widest_diameter(site);
  implicit::Kernel kernel = continues_curvature(site) ? implicit::Kernel::HermiteQuintic : options.kernel;
  RimData data{.site = site, .edge = mean_rim_edge(site), .every_normal = how.every_normal};
  const double share = takes_few_normals(data, kernel) ? quick_reach : 1;
  const double reach = std::max(least_reach * data.edge, share * options.reach * size);
  data.reached = within_creases(site, reach_from_rims(site, reach));
  const implicit::PointTree tree = tree_of(data.reached, positions);
  data.roughness = surface_roughness(data.reached, positions, tree);
  fit_rim_normals(data.reached, positions, tree);
  if (site.settings.bulge != 0) data.hinge.emplace(site, site.settings.bulge);
  if (how.other_sheets)
    data.passing = other_sheets(site, data.reached, reach, passing_spacing * data.edge, most_passing);
  data.passing.insert(data.passing.end(), how.guides.begin(), how.guides.end());
  const bool is_quintic = kernel == implicit::Kernel::HermiteQuintic;
  if (is_quintic && (how.other_sheets || !how.guides.empty())) kernel = implicit::Kernel::Hermite;
  data.reached = sampled(data.reached);
  choose_centres(kernel, data);
  const double farthest = std::max(worst_residual, rough_residual * data.roughness) * data.resolution;
  std::vector<implicit::Kernel> kernels = {kernel};
  if (kernel == implicit::Kernel::HermiteQuintic) kernels.push_back(implicit::Kernel::Hermite);
  for (const implicit::Kernel each : kernels) {
    for (const double factor : {how.stiffness, how.stiffness * smoother}) {
      auto fit = fitted(data, each, factor);
      if (!fit || !(residual(data, *fit) <= farthest)) continue;
      const std::size_t points = fit->report().centres;
      return RimField{std::move(fit), data.edge, size, {}, {points}};
    }
  }
  return std::nullopt;
}

}  // namespace croquis::hole_filling

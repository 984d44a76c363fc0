// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/hole_filling/continuation/rim_field.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "algorithms/hole_filling/continuation/other_sheets.h"
#include "algorithms/hole_filling/continuation/rim_hinge.h"
#include "algorithms/hole_filling/continuation/smooth_sides.h"
#include "croquis/base/error.h"
#include "croquis/hole_filling/quadric_normals.h"
#include "croquis/hole_filling/surface_reach.h"
#include "croquis/implicit/offset_points.h"

namespace croquis::hole_filling {
namespace {

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

/// Takes each vertex unless a taken one is nearer than the spacing there, rims first.
/// @return the vertices taken, or nothing when they are more than `most`
std::optional<std::vector<std::size_t>> thin(const std::vector<ReachedVertex>& reached,
                                             const std::vector<Vec3>& positions, double spacing, double slope,
                                             std::size_t most) {
  std::vector<std::size_t> taken;
  std::vector<Vec3> places;
  for (std::size_t i = 0; i < reached.size(); ++i) {
    const Vec3& place = positions[reached[i].vertex];
    const double least = std::max(spacing, slope * reached[i].distance);
    // The last one taken is most likely too near.
    const bool is_free = std::all_of(places.rbegin(), places.rend(),
                                     [&](const Vec3& other) { return (place - other).squaredNorm() >= least * least; });
    if (!is_free) continue;
    if (taken.size() == most) return std::nullopt;
    taken.push_back(i);
    places.push_back(place);
  }
  return taken;
}

class RimFitting {
 public:
  RimFitting(const HoleSite& site, const ImplicitOptions& options, bool every_normal)
      : positions_(site.mesh->positions),
        options_(options),
        every_normal_(every_normal),
        kernel_(options.kernel),
        rim_size_(site.vertices.size()) {
    edge_ = mean_rim_edge(site);
    size_ = widest_diameter(site);
    if (continues_curvature(site, options)) kernel_ = implicit::Kernel::HermiteQuintic;
    reach_ = std::max(least_reach * edge_, (takes_few_normals() ? quick_reach : 1) * options.reach * size_);
    reached_ = reach_from_rims(site, reach_);
    stay_within_creases(site);
    const implicit::PointTree tree = tree_of(reached_, positions_);
    roughness_ = surface_roughness(reached_, positions_, tree);
    fit_rim_normals(reached_, positions_, tree);
    through_ = site.wish.through;
    if (site.wish.bulge != 0) hinge_.emplace(site, site.wish.bulge);
  }

  void keep_clear_of_others(const HoleSite& site) {
    take_cubic();
    passing_ = other_sheets(site, reached_, reach_, passing_spacing * edge_, most_passing);
  }

  void follow(const std::vector<PassingPoint>& guides) {
    if (!guides.empty()) take_cubic();
    passing_.insert(passing_.end(), guides.begin(), guides.end());
  }

  std::optional<RimField> run(double stiffness) {
    sample_reached();
    choose_centres();
    const auto field = on_kernel(stiffness);
    if (field || kernel_ != implicit::Kernel::HermiteQuintic) return field;
    take_cubic();
    return on_kernel(stiffness);
  }

 private:
  void take_cubic() {
    if (kernel_ == implicit::Kernel::HermiteQuintic) kernel_ = implicit::Kernel::Hermite;
  }

  std::optional<RimField> on_kernel(double stiffness) const {
    const double farthest = std::max(worst_residual, rough_residual * roughness_) * resolution_;
    for (const double factor : {stiffness, stiffness * smoother}) {
      auto fit = fitted(factor);
      if (fit && residual(*fit) <= farthest) {
        const std::size_t points = fit->report().centres;
        return RimField{std::move(fit), edge_, size_, {}, {points}};
      }
    }
    return std::nullopt;
  }

  /// A hole within one smooth side is continued from that side alone: what lies beyond its creases isn't the same
  /// surface, and would bend it.
  void stay_within_creases(const HoleSite& site) {
    if (std::none_of(reached_.begin(), reached_.end(), [](const ReachedVertex& r) { return r.on_crease; })) return;
    const std::vector<SmoothSide> sides = smooth_sides(known_surface(site, reached_));
    if (sides.size() != 1 || sides.front().vertices.size() == reached_.size()) return;
    std::vector<ReachedVertex> kept;
    std::size_t next = 0;
    for (Index i = 0; i < reached_.size(); ++i) {
      const bool is_inside = next < sides.front().vertices.size() && sides.front().vertices[next] == i;
      if (is_inside && sides.front().normals[next].dot(reached_[i].normal) < same_normal)
        reached_[i].normal = sides.front().normals[next];
      if (is_inside) ++next;
      if (is_inside || reached_[i].distance == 0) kept.push_back(reached_[i]);
    }
    reached_ = std::move(kept);
  }

  /// Every so many of those that aren't on the rim.
  void sample_reached() {
    const std::size_t stride = reached_.size() / most_candidates + 1;
    std::vector<ReachedVertex> sampled;
    for (std::size_t i = 0; i < reached_.size(); ++i) {
      if (reached_[i].distance == 0 || i % stride == 0) sampled.push_back(reached_[i]);
    }
    reached_ = std::move(sampled);
  }

  void choose_centres() {
    const std::size_t quick_surplus = takes_few_normals() ? options_.most_centres / 4 : 0;  // they cost less
    const std::size_t most = std::min(options_.most_centres + quick_surplus, 2 * rim_size_ + 40);
    for (double scale = 1;; scale *= spacing_growth) {
      auto taken = thin(reached_, positions_, scale * rim_spacing * edge_,
                        std::min(scale, most_slope_growth) * spacing_slope, most);
      if (!taken) continue;
      centres_ = std::move(*taken);
      resolution_ = std::max(1.0, scale * rim_spacing) * edge_;
      return;
    }
  }

  bool takes_few_normals() const { return !every_normal_ && kernel_ == implicit::Kernel::HermiteQuintic; }

  /// Those of the centres whose normals count.
  std::vector<std::uint8_t> directed_centres() const {
    if (!takes_few_normals()) return std::vector<std::uint8_t>(centres_.size(), 1);
    std::vector<ReachedVertex> centres;
    for (const std::size_t i : centres_) centres.push_back(reached_[i]);
    std::vector<std::uint8_t> directed(centres_.size(), 0);
    const auto sparse = thin(centres, positions_, normal_spacing * edge_, normal_slope, centres.size());
    for (const std::size_t i : *sparse) directed[i] = 1;
    return directed;
  }

  std::shared_ptr<const implicit::LocalFit> fitted(double factor) const {
    implicit::Constraints constraints;
    const std::vector<std::uint8_t> directed = directed_centres();
    for (std::size_t c = 0; c < centres_.size(); ++c) {
      const ReachedVertex& centre = reached_[centres_[c]];
      const Vec3& place = positions_[centre.vertex];
      constraints.positions.push_back(hinge_ ? hinge_->place(place) : place);
      constraints.gradients.push_back(directed[c] == 0 ? Vec3(Vec3::Zero())
                                      : hinge_         ? hinge_->normal(place, centre.normal)
                                                       : centre.normal);
    }
    for (const PassingPoint& point : passing_) {
      constraints.positions.push_back(point.position);
      constraints.gradients.push_back(point.normal);
    }
    const implicit::FitOptions options = fit_options(factor);
    try {
      if (!implicit::takes_gradients(kernel_))
        constraints = implicit::with_offset_points(constraints.positions, constraints.gradients,
                                                   {0.5 * edge_, 6, options_.both_sides})
                          .constraints;
      if (!through_.empty()) go_through(constraints);
      return std::make_shared<const implicit::LocalFit>(constraints, options);
    } catch (const Error&) {
      return nullptr;  // nothing that could be fitted: another method's turn
    }
  }

  /// For kernels with gradients what is asked for, compared with the defaults, is a factor of what the surface needs.
  implicit::FitOptions fit_options(double factor) const {
    const ImplicitOptions usual;
    implicit::FitOptions options{kernel_, factor * options_.value_smoothing, factor * options_.gradient_smoothing,
                                 edge_};
    if (!implicit::takes_gradients(kernel_) || hinge_) return options;  // a turned rim is met less closely
    const bool is_quintic = kernel_ == implicit::Kernel::HermiteQuintic;
    options.value_smoothing *= (is_quintic ? quintic_values : cubic_values).at(roughness_) / usual.value_smoothing;
    options.gradient_smoothing *=
        (is_quintic ? quintic_gradients : cubic_gradients).at(roughness_) / usual.gradient_smoothing;
    return options;
  }

  /// Places that are met exactly, whatever the smoothing; their normals aren't known.
  void go_through(implicit::Constraints& constraints) const {
    constraints.softness.assign(constraints.size(), 1.0);
    constraints.softness.insert(constraints.softness.end(), through_.size(), 0.0);
    constraints.positions.insert(constraints.positions.end(), through_.begin(), through_.end());
    if (!constraints.values.empty()) constraints.values.resize(constraints.size(), 0.0);
    if (!constraints.gradients.empty()) constraints.gradients.resize(constraints.size(), Vec3::Zero());
  }

  /// The farthest that the field takes a rim vertex for being off the surface.
  double residual(const implicit::LocalFit& fit) const {
    double worst = 0;
    for (const ReachedVertex& reached : reached_) {
      if (reached.distance > 0) break;
      const double value = std::abs(fit.value(positions_[reached.vertex]));
      if (!(value <= worst)) worst = value;
    }
    return worst;
  }

  const std::vector<Vec3>& positions_;
  const ImplicitOptions& options_;
  bool every_normal_;
  implicit::Kernel kernel_;
  double roughness_ = 0;
  std::size_t rim_size_;
  double edge_ = 0, size_ = 0, reach_ = 0, resolution_ = 0;
  std::vector<ReachedVertex> reached_;
  std::vector<std::size_t> centres_;
  std::vector<PassingPoint> passing_;
  std::vector<Vec3> through_;
  std::optional<RimHinge> hinge_;  ///< where the patch is to bulge
};

}  // namespace

bool continues_curvature(const HoleSite& site, const ImplicitOptions& options) {
  if (options.kernel != implicit::Kernel::Hermite || site.polygon.loop_count() != 1) return false;
  const Hole& hole = site.analysis->holes[site.holes.front()];
  return site.wish.bulge == 0 && site.wish.through.empty() &&
         hole.diameter <= widest_quintic * site.analysis->component_size[hole.component];
}

std::optional<RimField> fit_rims(const HoleSite& site, const ImplicitOptions& options, const RimFitOptions& how) {
  RimFitting fitting(site, options, how.every_normal);
  if (how.other_sheets) fitting.keep_clear_of_others(site);
  fitting.follow(how.guides);
  return fitting.run(how.stiffness);
}

}  // namespace croquis::hole_filling

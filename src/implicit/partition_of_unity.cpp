// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/implicit/partition_of_unity.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <limits>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "croquis/base/parallel.h"
#include "croquis/implicit/offset_points.h"
#include "croquis/implicit/point_tree.h"
#include "implicit/octree.h"
#include "implicit/point_checks.h"

namespace croquis::implicit {

/// All points of a field, and what a domain takes of them.
class DomainPoints {
 public:
  DomainPoints(std::span<const Vec3> positions, std::span<const Vec3> normals, const DomainOptions& options,
               Progress& progress);

  /// The points in the box, with their normals or, for kernels without gradients, their offset points: if fewer than
  /// min_points, the nearest to its middle instead; if more than `most`, thinned.
  Constraints of(const Box& box, std::size_t most) const;

  /// True when the box holds more than `most` points on the surface.
  bool holds_more_than(std::size_t most, const Box& box) const { return tree_.holds_more_than(most, box); }

  std::span<const Vec3> positions() const { return positions_; }
  std::size_t bytes() const;

 private:
  void make_offsets();

  DomainOptions options_;
  std::vector<Vec3> own_positions_, own_normals_;  // none when they are borrowed
  std::span<const Vec3> positions_, normals_;
  PointTree tree_;
  Constraints offsets_;                    // points off the surface, behind those on it
  std::vector<std::size_t> first_offset_;  // #N+1 into offsets_, or none
};

/// What is evaluated at a place: the value; beside it the gradient's first sum, sum w_i grad f_i; or the whole
/// gradient.
enum class Wanted { Value, FirstSum, Gradient };

/// The domains of a partition of unity, and what they add up to.
class BlendedDomains {
 public:
  BlendedDomains(std::span<const Vec3> positions, std::span<const Vec3> normals, std::vector<ExtraDomain> extras,
                 const DomainOptions& options, Progress& progress);

  /// Fits the domains that have points and the extra ones: nine tenths of the progress.
  void fit(Progress& progress) const;

  /// The same, of those that reach into a slab.
  void fit_between(int axis, double low, double high, Progress& progress) const;

  /// Frees the fits of those that end below a place. Not while others evaluate.
  void forget_below(int axis, double place);

  void evaluate(std::span<const Vec3> places, std::span<double> values, std::span<Vec3> gradients, Wanted wanted) const;
  std::vector<Box> boxes() const;
  DomainReport report() const;

 private:
  /// One box with its fit, which is made when it is first needed.
  struct Domain {
    std::size_t number = 0;
    Box box;
    double weight = 1;
    std::size_t most = 0;                    // points that it takes at most
    std::unique_ptr<const Constraints> own;  // an extra domain's; the others take theirs from the points
    mutable std::unique_ptr<const LocalFit> fit;
    mutable std::atomic<const LocalFit*> ready = nullptr;
    mutable std::uint32_t centres = 0, merged = 0, fits = 0;  // of the fit, also when it was forgotten
    mutable bool rank_revealing = false;
  };

  /// What the domains at one place add up to.
  struct Blend {
    double weight = 0;
    double value = 0;                       // sum of W f
    Vec3 gradient = Vec3::Zero();           // sum of W grad f
    Vec3 weight_gradient = Vec3::Zero();    // sum of grad W
    Vec3 value_times_slope = Vec3::Zero();  // sum of f grad W
    double coverage = 0;                    // sum of W without factors, of all but fillers
    Vec3 coverage_gradient = Vec3::Zero();
  };

  void add_leaf_domains();
  void add_extras(std::vector<ExtraDomain>&& extras);
  bool is_filler(std::size_t domain) const;
  void fit_these(const std::vector<const Domain*>& needed, double share, Progress& progress) const;
  const LocalFit& fit_of(const Domain& domain) const;
  void add(const Domain& domain, const BoxWeight& w, const Vec3& place, Wanted wanted, Blend& blend) const;
  void add_domain(const Domain& domain, const Vec3& place, Wanted wanted, Blend& blend) const;
  void add_filler(const Domain& domain, const Vec3& place, Wanted wanted, const Blend& others, Blend& blend) const;
  Blend blend_at(const Vec3& place, Wanted wanted) const;

  DomainOptions options_;
  DomainPoints points_;
  Octree tree_;
  std::deque<Domain> domains_;                      // one per leaf, then the extra ones
  std::vector<std::vector<Index>> extras_of_leaf_;  // domains whose boxes meet the leaf's cube
  bool has_extras_ = false;

  // One thread makes a fit. Domains share locks: few are made at a time.
  static constexpr std::size_t lock_count = 64;
  mutable std::array<std::mutex, lock_count> locks_;
};

namespace {

/// The mean distance of a point to its nearest neighbour.
double mean_spacing(const PointTree& tree, std::span<const Vec3> positions) {
  double sum = 0;
  for (const Vec3& position : positions) {
    const std::vector<Index> nearest = tree.nearest(position, 2);
    if (nearest.size() == 2) sum += (positions[nearest[1]] - position).norm();
  }
  return sum / static_cast<double>(positions.size());
}

// Sums of weights below this mean that no domain reaches the place: the largest weight is 1 there or far more, the
// least that smooth weights at eight overlapping corners leave is above 1e-12.
constexpr double no_weight = 1e-30;

// The tree's cube is larger than the points by this fraction: fills may bulge out of their box.
constexpr double room = 0.5;

// Of leaf_points: a box that only grazes the surface has few points of its own, but may have a whole sheet of them in
// its overlap. Two such boxes in a hundred would take half of all the time.
constexpr std::size_t crowd = 3;

// Fillers fade out where the other domains' weights (without their factors) add up to this. Their influence is below a
// ten thousandth there; without it, most of those near the surface need never be fitted.
constexpr double enough = 1e-3;

Box cube_around(std::span<const Vec3> positions, const std::vector<ExtraDomain>& extras) {
  Box box = bounds(positions);
  for (const ExtraDomain& extra : extras) {
    box.low = box.low.cwiseMin(extra.box.low);
    box.high = box.high.cwiseMax(extra.box.high);
  }
  const double longest = box.size().maxCoeff();
  const double side = longest > 0 ? (1 + room) * longest : 1;
  return {(box.middle().array() - 0.5 * side).matrix(), (box.middle().array() + 0.5 * side).matrix()};
}

OctreeRule rule_of(const DomainOptions& options, const DomainPoints& points, const Progress& progress) {
  const auto is_full = [&options, &points, &progress](const Box& cube) {
    progress.check();
    return points.holds_more_than(crowd * options.leaf_points, cube.grown(options.overlap));
  };
  return {options.leaf_points, options.max_depth, is_full, options.equal_boxes};
}

// Of one fit: its matrix takes 512 MB then.
constexpr std::size_t most_points = 2000;

void require_options(const DomainOptions& options) {
  require_parameter(options.leaf_points >= 1 && options.min_points >= 1 && options.max_points >= options.min_points,
                    "points-per-domain", "domains need at least one point and no less at most than at least");
  require_parameter(options.max_points <= most_points, "points-per-domain", "domains take 2000 points at most");
  require_parameter(options.overlap >= 0 && options.overlap <= 1, "overlap", "it must lie between 0 and 1");
  require_parameter(options.max_depth >= 0 && options.max_depth <= 20, "max-depth", "it must lie between 0 and 20");
  require_parameter(options.data_weight > 0 && options.filler_weight >= 0, "weight", "weights must be positive");
}

void require_extra(const ExtraDomain& extra) {
  require_constraints(extra.constraints);
  require_parameter(extra.box.low.allFinite() && extra.box.high.allFinite() &&
                        (extra.box.low.array() < extra.box.high.array()).all() && extra.weight > 0,
                    "extra-domain", "its box needs an extent along every axis, and its weight must be positive");
}

}  // namespace

DomainPoints::DomainPoints(std::span<const Vec3> positions, std::span<const Vec3> normals, const DomainOptions& options,
                           Progress& progress)
    : options_(options), positions_(positions), normals_(normals), tree_(positions, options.threads, progress) {
  if (!options.borrow) {
    own_positions_.assign(positions.begin(), positions.end());
    own_normals_.assign(normals.begin(), normals.end());
    positions_ = own_positions_;
    normals_ = own_normals_;
  }
  if (!takes_gradients(options.fit.kernel) && !normals_.empty()) make_offsets();
}

void DomainPoints::make_offsets() {
  const double distance = options_.offset > 0 ? options_.offset : 0.5 * mean_spacing(tree_, positions_);
  if (!(distance > 0)) return;  // all points at one place: there is no offset to choose
  OffsetOptions options;
  options.distance = distance;
  options.both_sides = options_.offset_both_sides;
  OffsetPoints points = with_offset_points(positions_, normals_, options);
  first_offset_.assign(positions_.size() + 1, positions_.size());
  for (const Index origin : points.origins) ++first_offset_[origin + 1];
  // Counts become ends: offset points come in the order of their origins.
  std::size_t end = positions_.size();
  for (std::size_t i = 0; i < positions_.size(); ++i) {
    first_offset_[i] = end;
    end += first_offset_[i + 1] - positions_.size();
  }
  first_offset_.back() = end;
  offsets_ = std::move(points.constraints);
}

Constraints DomainPoints::of(const Box& box, std::size_t most) const {
  std::vector<Index> chosen = tree_.inside(box);
  if (chosen.size() < options_.min_points) {
    chosen = tree_.nearest(box.middle(), options_.min_points);
  } else if (chosen.size() > most) {
    chosen = thinned(positions_, std::move(chosen), box, most);
  }
  std::sort(chosen.begin(), chosen.end());
  Constraints constraints;
  for (const Index i : chosen) constraints.positions.push_back(positions_[i]);
  if (takes_gradients(options_.fit.kernel) && !normals_.empty()) {
    for (const Index i : chosen) constraints.gradients.push_back(normals_[i]);
  }
  if (first_offset_.empty()) return constraints;
  constraints.values.assign(chosen.size(), 0.0);
  for (const Index i : chosen) {
    for (std::size_t k = first_offset_[i]; k < first_offset_[i + 1]; ++k) {
      constraints.positions.push_back(offsets_.positions[k]);
      constraints.values.push_back(offsets_.values[k]);
    }
  }
  return constraints;
}

std::size_t DomainPoints::bytes() const {
  return (own_positions_.capacity() + own_normals_.capacity() + offsets_.positions.capacity()) * sizeof(Vec3) +
         offsets_.values.capacity() * sizeof(double) + first_offset_.capacity() * sizeof(std::size_t) + tree_.bytes();
}

BlendedDomains::BlendedDomains(std::span<const Vec3> positions, std::span<const Vec3> normals,
                               std::vector<ExtraDomain> extras, const DomainOptions& options, Progress& progress)
    : options_(options),
      points_(positions, normals, options, progress),
      tree_(positions, cube_around(positions, extras), rule_of(options, points_, progress)),
      extras_of_leaf_(tree_.leaves().size()) {
  add_leaf_domains();
  add_extras(std::move(extras));
}

bool BlendedDomains::is_filler(std::size_t domain) const {
  return domain < tree_.leaves().size() && tree_.leaves()[domain].point_count() == 0;
}

const LocalFit& BlendedDomains::fit_of(const Domain& domain) const {
  if (const LocalFit* fit = domain.ready.load(std::memory_order_acquire)) return *fit;
  const std::lock_guard lock(locks_[domain.number % lock_count]);
  if (const LocalFit* fit = domain.ready.load(std::memory_order_acquire)) return *fit;
  domain.fit =
      std::make_unique<const LocalFit>(domain.own ? *domain.own : points_.of(domain.box, domain.most), options_.fit);
  const FitReport& report = domain.fit->report();
  domain.centres = static_cast<std::uint32_t>(report.centres);
  domain.merged = static_cast<std::uint32_t>(report.merged);
  domain.rank_revealing = report.rank_revealing;
  ++domain.fits;
  domain.ready.store(domain.fit.get(), std::memory_order_release);
  return *domain.fit;
}

void BlendedDomains::fit(Progress& progress) const {
  std::vector<const Domain*> needed;
  for (std::size_t i = 0; i < domains_.size(); ++i)
    if (!is_filler(i)) needed.push_back(&domains_[i]);
  fit_these(needed, 0.9, progress);
}

void BlendedDomains::fit_between(int axis, double low, double high, Progress& progress) const {
  std::vector<const Domain*> needed;
  for (std::size_t i = 0; i < domains_.size(); ++i) {
    const Domain& domain = domains_[i];
    if (is_filler(i) || domain.ready.load(std::memory_order_acquire) != nullptr) continue;
    if (domain.box.low[axis] <= high && domain.box.high[axis] >= low) needed.push_back(&domain);
  }
  fit_these(needed, 1, progress);
}

void BlendedDomains::fit_these(const std::vector<const Domain*>& needed, double share, Progress& progress) const {
  Progress fitting = progress.step("fit " + std::to_string(needed.size()) + " domains", share);
  for_each_part(needed.size(), 1, options_.threads, fitting, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) fit_of(*needed[i]);
  });
}

void BlendedDomains::forget_below(int axis, double place) {
  for (const Domain& domain : domains_) {
    if (domain.box.high[axis] >= place || domain.ready.load(std::memory_order_acquire) == nullptr) continue;
    domain.ready.store(nullptr, std::memory_order_release);
    domain.fit.reset();
  }
}

void BlendedDomains::add_leaf_domains() {
  for (const Octree::Leaf& leaf : tree_.leaves()) {
    Domain& domain = domains_.emplace_back();
    domain.number = domains_.size();
    domain.box = leaf.cube.grown(options_.overlap);
    const bool filler = leaf.point_count() == 0;
    domain.weight = filler ? options_.filler_weight : options_.data_weight;
    // A filler only continues what is around it: it needs no more points than a leaf has.
    domain.most = filler ? std::max(options_.min_points, options_.leaf_points) : options_.max_points;
  }
}

void BlendedDomains::add_extras(std::vector<ExtraDomain>&& extras) {
  has_extras_ = !extras.empty();
  for (ExtraDomain& extra : extras) {
    const auto index = static_cast<Index>(domains_.size());
    tree_.for_each_meeting(extra.box, [&](Index leaf) { extras_of_leaf_[leaf].push_back(index); });
    Domain& domain = domains_.emplace_back();
    domain.number = domains_.size();
    domain.box = extra.box;
    domain.weight = extra.weight;
    domain.own = std::make_unique<const Constraints>(std::move(extra.constraints));
  }
}

void BlendedDomains::add(const Domain& domain, const BoxWeight& w, const Vec3& place, Wanted wanted,
                         Blend& blend) const {
  double value = 0;
  Vec3 gradient;
  const bool steep = wanted != Wanted::Value;
  fit_of(domain).evaluate({&place, 1}, {&value, 1}, {&gradient, steep ? 1U : 0U});
  blend.weight += w.value;
  blend.value += w.value * value;
  if (steep) blend.gradient += w.value * gradient;
  if (wanted != Wanted::Gradient) return;
  blend.weight_gradient += w.gradient;
  blend.value_times_slope += value * w.gradient;
}

void BlendedDomains::add_domain(const Domain& domain, const Vec3& place, Wanted wanted, Blend& blend) const {
  const BoxWeight w = box_weight(domain.box, place);
  if (!(w.value > 0)) return;
  blend.coverage += w.value;
  blend.coverage_gradient += w.gradient;
  add(domain, {domain.weight * w.value, domain.weight * w.gradient}, place, wanted, blend);
}

/// Times (1 - coverage / enough)^3, which ends twice continuously differentiable.
void BlendedDomains::add_filler(const Domain& domain, const Vec3& place, Wanted wanted, const Blend& others,
                                Blend& blend) const {
  const BoxWeight w = box_weight(domain.box, place);
  const double rest = 1 - others.coverage / enough;
  const double fade = rest * rest * rest;
  const Vec3 fade_gradient = -3 / enough * rest * rest * others.coverage_gradient;
  const BoxWeight faded = {domain.weight * w.value * fade,
                           domain.weight * (fade * w.gradient + w.value * fade_gradient)};
  if (faded.value > 0) add(domain, faded, place, wanted, blend);
}

BlendedDomains::Blend BlendedDomains::blend_at(const Vec3& place, Wanted wanted) const {
  Blend blend;
  tree_.for_each_near(place, options_.overlap, [&](Index leaf) {
    if (tree_.leaves()[leaf].point_count() > 0) add_domain(domains_[leaf], place, wanted, blend);
  });
  const Index home = has_extras_ ? tree_.leaf_at(place) : no_index;
  if (home != no_index)
    for (const Index extra : extras_of_leaf_[home]) add_domain(domains_[extra], place, wanted, blend);
  if (blend.coverage >= enough) return blend;
  const Blend others = blend;
  tree_.for_each_near(place, options_.overlap, [&](Index leaf) {
    if (tree_.leaves()[leaf].point_count() == 0) add_filler(domains_[leaf], place, wanted, others, blend);
  });
  return blend;
}

void BlendedDomains::evaluate(std::span<const Vec3> places, std::span<double> values, std::span<Vec3> gradients,
                              Wanted wanted) const {
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Blend blend = blend_at(places[i], wanted);
    const bool defined = blend.weight >= no_weight;
    values[i] = defined ? blend.value / blend.weight : std::numeric_limits<double>::quiet_NaN();
    if (gradients.empty()) continue;
    gradients[i] = Vec3::Zero();
    if (!defined) continue;
    gradients[i] = blend.gradient / blend.weight;
    if (wanted == Wanted::Gradient)
      gradients[i] += (blend.value_times_slope - values[i] * blend.weight_gradient) / blend.weight;
  }
}

DomainReport BlendedDomains::report() const {
  DomainReport report;
  std::vector<std::size_t> centres;
  report.bytes = points_.bytes() + tree_.bytes();
  for (std::size_t i = 0; i < domains_.size(); ++i) {
    const bool is_extra = i >= tree_.leaves().size();
    const bool has_points = !is_extra && tree_.leaves()[i].point_count() > 0;
    ++(is_extra ? report.extra_domains : has_points ? report.data_domains : report.filler_domains);
    report.bytes += sizeof(Domain);
    const Domain& domain = domains_[i];
    if (const LocalFit* fit = domain.ready.load(std::memory_order_acquire)) report.bytes += fit->bytes();
    report.fits += domain.fits;
    if (domain.fits == 0) continue;
    ++report.fitted;
    if (domain.rank_revealing) ++report.rank_revealing;
    if (!has_points) continue;
    report.merged += domain.merged;
    centres.push_back(domain.centres);
  }
  std::sort(centres.begin(), centres.end());
  if (!centres.empty()) {
    report.min_centres = centres.front();
    report.median_centres = centres[centres.size() / 2];
    report.max_centres = centres.back();
  }
  return report;
}

std::vector<Box> BlendedDomains::boxes() const {
  std::vector<Box> boxes;
  for (const Domain& domain : domains_) boxes.push_back(domain.box);
  return boxes;
}

struct PartitionOfUnity::State : BlendedDomains {
  using BlendedDomains::BlendedDomains;
};

PartitionOfUnity::PartitionOfUnity(std::span<const Vec3> positions, std::span<const Vec3> normals,
                                   std::vector<ExtraDomain> extras, const DomainOptions& options, Progress& progress) {
  require_points(positions, normals);
  for (const ExtraDomain& extra : extras) require_extra(extra);
  require_options(options);
  progress.check();
  Progress cutting = progress.step("cut space", 0.1);
  state_ = std::make_unique<State>(positions, normals, std::move(extras), options, cutting);
  if (options.lazy) return;
  state_->fit(progress);
}

PartitionOfUnity::~PartitionOfUnity() = default;
PartitionOfUnity::PartitionOfUnity(PartitionOfUnity&&) noexcept = default;
PartitionOfUnity& PartitionOfUnity::operator=(PartitionOfUnity&&) noexcept = default;

void PartitionOfUnity::evaluate(std::span<const Vec3> points, std::span<double> values,
                                std::span<Vec3> gradients) const {
  state_->evaluate(points, values, gradients, gradients.empty() ? Wanted::Value : Wanted::Gradient);
}

void PartitionOfUnity::evaluate_for_projection(std::span<const Vec3> points, std::span<double> values,
                                               std::span<Vec3> gradients) const {
  state_->evaluate(points, values, gradients, gradients.empty() ? Wanted::Value : Wanted::FirstSum);
}

double PartitionOfUnity::value(const Vec3& point) const {
  double value = 0;
  evaluate({&point, 1}, {&value, 1});
  return value;
}

Vec3 PartitionOfUnity::gradient(const Vec3& point) const {
  double value = 0;
  Vec3 gradient;
  evaluate({&point, 1}, {&value, 1}, {&gradient, 1});
  return gradient;
}

Field PartitionOfUnity::field() const {
  return [this](std::span<const Vec3> points, std::span<double> values, std::span<Vec3> gradients) {
    evaluate(points, values, gradients);
  };
}

Field PartitionOfUnity::projection_field() const {
  return [this](std::span<const Vec3> points, std::span<double> values, std::span<Vec3> gradients) {
    evaluate_for_projection(points, values, gradients);
  };
}

void PartitionOfUnity::fit_between(int axis, double low, double high, Progress& progress) {
  state_->fit_between(axis, low, high, progress);
}

void PartitionOfUnity::forget_below(int axis, double place) { state_->forget_below(axis, place); }

std::vector<Box> PartitionOfUnity::domain_boxes() const { return state_->boxes(); }

DomainReport PartitionOfUnity::report() const { return state_->report(); }

}  // namespace croquis::implicit

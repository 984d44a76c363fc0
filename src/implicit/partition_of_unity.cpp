// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/implicit/partition_of_unity.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <deque>
#include <limits>
#include <mutex>
#include <optional>
#include <utility>

#include "implicit/domain_points.h"
#include "implicit/octree.h"
#include "implicit/parallel.h"
#include "implicit/point_checks.h"

namespace croquis::implicit {
namespace {

// Sums of weights below this mean that no domain reaches the place: the largest weight is 1 there or far more, the
// least that smooth weights at eight overlapping corners leave is above 1e-12.
constexpr double no_weight = 1e-30;

// Of one fit: its matrix takes 512 MB then.
constexpr std::size_t most_points = 2000;

// The tree's cube is larger than the points by this fraction: fills may bulge out of their box.
constexpr double room = 0.5;

// Of leaf_points: a box that only grazes the surface has few points of its own, but may have a whole sheet of them in
// its overlap. Two such boxes in a hundred would take half of all the time.
constexpr std::size_t crowd = 3;

// Fillers fade out where the other domains' weights (without their factors) add up to this. Their influence is below a
// ten thousandth there; without it, most of those near the surface need never be fitted.
constexpr double enough = 1e-3;

/// One box with its fit, which is made when it is first asked for.
struct DomainFit {
  Box box;
  double weight = 1;
  std::size_t most = 0;            // points that it takes at most
  std::optional<Constraints> own;  // an extra domain's; the others take theirs from the points
  mutable std::once_flag once;
  mutable std::unique_ptr<const LocalFit> fit;
  mutable std::atomic<const LocalFit*> ready = nullptr;
};

void require_options(const DomainOptions& options) {
  require_parameter(options.leaf_points >= 1 && options.min_points >= 1 && options.max_points >= options.min_points,
                    "points-per-domain", "domains need at least one point and no less at most than at least");
  require_parameter(options.max_points <= most_points, "points-per-domain", "domains take 2000 points at most");
  require_parameter(options.overlap >= 0 && options.overlap <= 1, "overlap", "it must lie between 0 and 1");
  require_parameter(options.max_depth >= 0 && options.max_depth <= 20, "max-depth", "it must lie between 0 and 20");
  require_parameter(options.data_weight > 0 && options.filler_weight >= 0, "weight", "weights must be positive");
}

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

OctreeRule rule_of(const DomainOptions& options, const DomainPoints& points) {
  const auto crowded = [&options, &points](const Box& cube) {
    return points.holds_more_than(crowd * options.leaf_points, cube.grown(options.overlap));
  };
  return {options.leaf_points, options.max_depth, crowded, options.equal_boxes};
}

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

enum class Wanted { Value, FirstSum, Gradient };

}  // namespace

struct PartitionOfUnity::State {
  State(std::span<const Vec3> positions, std::span<const Vec3> normals, const std::vector<ExtraDomain>& extras,
        const DomainOptions& chosen)
      : options(chosen),
        points(positions, normals, chosen),
        tree(positions, cube_around(positions, extras), rule_of(chosen, points)),
        extras_of_leaf(tree.leaves().size()) {}

  const LocalFit& fit_of(const DomainFit& domain) const {
    if (const LocalFit* fit = domain.ready.load(std::memory_order_acquire)) return *fit;
    std::call_once(domain.once, [&] {
      domain.fit =
          std::make_unique<const LocalFit>(domain.own ? *domain.own : points.of(domain.box, domain.most), options.fit);
      domain.ready.store(domain.fit.get(), std::memory_order_release);
    });
    return *domain.fit;
  }

  void add_leaf_domains();
  void add_extras(std::vector<ExtraDomain>&& extras);
  void add(const DomainFit& domain, const BoxWeight& w, const Vec3& place, Wanted wanted, Blend& blend) const;
  void add_domain(const DomainFit& domain, const Vec3& place, Wanted wanted, Blend& blend) const;
  void add_filler(const DomainFit& domain, const Vec3& place, Wanted wanted, const Blend& others, Blend& blend) const;
  Blend blend_at(const Vec3& place, Wanted wanted) const;
  void evaluate(std::span<const Vec3> places, std::span<double> values, std::span<Vec3> gradients, Wanted wanted) const;
  DomainReport count_domains() const;

  DomainOptions options;
  DomainPoints points;
  Octree tree;
  std::deque<DomainFit> domains;                   // one per leaf, then the extra ones
  std::vector<std::vector<Index>> extras_of_leaf;  // domains whose boxes meet the leaf's cube
  bool has_extras = false;
};

void PartitionOfUnity::State::add_leaf_domains() {
  for (const Octree::Leaf& leaf : tree.leaves()) {
    DomainFit& domain = domains.emplace_back();
    domain.box = leaf.cube.grown(options.overlap);
    const bool filler = leaf.point_count() == 0;
    domain.weight = filler ? options.filler_weight : options.data_weight;
    // A filler only carries on what is around it: it needs no more points than a leaf has.
    domain.most = filler ? std::max(options.min_points, options.leaf_points) : options.max_points;
  }
}

void PartitionOfUnity::State::add_extras(std::vector<ExtraDomain>&& extras) {
  has_extras = !extras.empty();
  for (ExtraDomain& extra : extras) {
    const auto index = static_cast<Index>(domains.size());
    tree.for_each_meeting(extra.box, [&](Index leaf) { extras_of_leaf[leaf].push_back(index); });
    DomainFit& domain = domains.emplace_back();
    domain.box = extra.box;
    domain.weight = extra.weight;
    domain.own = std::move(extra.constraints);
  }
}

void PartitionOfUnity::State::add(const DomainFit& domain, const BoxWeight& w, const Vec3& place, Wanted wanted,
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

void PartitionOfUnity::State::add_domain(const DomainFit& domain, const Vec3& place, Wanted wanted,
                                         Blend& blend) const {
  const BoxWeight w = box_weight(domain.box, place);
  if (!(w.value > 0)) return;
  blend.coverage += w.value;
  blend.coverage_gradient += w.gradient;
  add(domain, {domain.weight * w.value, domain.weight * w.gradient}, place, wanted, blend);
}

/// Times (1 - coverage / enough)^3, which ends twice continuously differentiable.
void PartitionOfUnity::State::add_filler(const DomainFit& domain, const Vec3& place, Wanted wanted, const Blend& others,
                                         Blend& blend) const {
  const BoxWeight w = box_weight(domain.box, place);
  const double rest = 1 - others.coverage / enough;
  const double fade = rest * rest * rest;
  const Vec3 fade_gradient = -3 / enough * rest * rest * others.coverage_gradient;
  const BoxWeight faded = {domain.weight * w.value * fade,
                           domain.weight * (fade * w.gradient + w.value * fade_gradient)};
  if (faded.value > 0) add(domain, faded, place, wanted, blend);
}

Blend PartitionOfUnity::State::blend_at(const Vec3& place, Wanted wanted) const {
  Blend blend;
  tree.for_each_near(place, options.overlap, [&](Index leaf) {
    if (tree.leaves()[leaf].point_count() > 0) add_domain(domains[leaf], place, wanted, blend);
  });
  const Index home = has_extras ? tree.leaf_at(place) : no_index;
  if (home != no_index)
    for (const Index extra : extras_of_leaf[home]) add_domain(domains[extra], place, wanted, blend);
  if (blend.coverage >= enough) return blend;
  const Blend others = blend;
  tree.for_each_near(place, options.overlap, [&](Index leaf) {
    if (tree.leaves()[leaf].point_count() == 0) add_filler(domains[leaf], place, wanted, others, blend);
  });
  return blend;
}

void PartitionOfUnity::State::evaluate(std::span<const Vec3> places, std::span<double> values,
                                       std::span<Vec3> gradients, Wanted wanted) const {
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

DomainReport PartitionOfUnity::State::count_domains() const {
  DomainReport report;
  std::vector<std::size_t> centres;
  report.bytes = points.bytes() + tree.bytes();
  for (std::size_t i = 0; i < domains.size(); ++i) {
    const bool is_extra = i >= tree.leaves().size();
    const bool has_points = !is_extra && tree.leaves()[i].point_count() > 0;
    ++(is_extra ? report.extra_domains : has_points ? report.data_domains : report.filler_domains);
    report.bytes += sizeof(DomainFit);
    const LocalFit* fit = domains[i].ready.load(std::memory_order_acquire);
    if (fit == nullptr) continue;
    ++report.fitted;
    report.bytes += fit->bytes();
    if (fit->report().rank_revealing) ++report.rank_revealing;
    if (!has_points) continue;
    report.merged += fit->report().merged;
    centres.push_back(fit->report().centres);
  }
  std::sort(centres.begin(), centres.end());
  if (!centres.empty()) {
    report.min_centres = centres.front();
    report.median_centres = centres[centres.size() / 2];
    report.max_centres = centres.back();
  }
  return report;
}

PartitionOfUnity::PartitionOfUnity(std::span<const Vec3> positions, std::span<const Vec3> normals,
                                   std::vector<ExtraDomain> extras, const DomainOptions& options, Progress& progress) {
  require_points(positions, normals);
  for (const ExtraDomain& extra : extras) require_constraints(extra.constraints);
  require_options(options);
  progress.check();
  state_ = std::make_unique<State>(positions, normals, extras, options);
  state_->add_leaf_domains();
  state_->add_extras(std::move(extras));
  std::vector<const DomainFit*> needed;
  for (std::size_t i = 0; i < state_->domains.size(); ++i) {
    const bool is_extra = i >= state_->tree.leaves().size();
    if (is_extra || state_->tree.leaves()[i].point_count() > 0) needed.push_back(&state_->domains[i]);
  }
  for_each_part(needed.size(), 1, options.threads, progress, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) state_->fit_of(*needed[i]);
  });
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

std::vector<Box> PartitionOfUnity::domain_boxes() const {
  std::vector<Box> boxes;
  for (const DomainFit& domain : state_->domains) boxes.push_back(domain.box);
  return boxes;
}

DomainReport PartitionOfUnity::report() const { return state_->count_domains(); }

}  // namespace croquis::implicit

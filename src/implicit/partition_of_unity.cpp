// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/implicit/partition_of_unity.h"

#include <string>
#include <utility>

#include "implicit/blended_domains.h"
#include "implicit/point_checks.h"

namespace croquis::implicit {
namespace {

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
  Progress fitting = progress.step("fit " + std::to_string(state_->domain_count()) + " domains", 0.9);
  state_->fit(fitting);
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

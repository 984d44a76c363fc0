// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "algorithms/hole_filling/patching/cross_validation.h"
#include "algorithms/hole_filling/patching/patcher.h"

namespace croquis::hole_filling {
namespace {

/// A few probes are weak evidence: a later method's error counts this much more than that of the one before it.
constexpr double handicap = 1.25;

/// A method's patch for the site, and its errors at the probes.
struct MethodEntry {
  HolePatch patch;
  std::vector<double> errors;  ///< per probe, NaN where it made nothing
  double handicapped = 0;      ///< what methods are compared by
};

/// Where a method has no result for a probe it counts as equal to the best one.
std::vector<double> best_errors(const std::vector<MethodEntry>& entries, std::size_t probes) {
  std::vector<double> best(probes, std::numeric_limits<double>::quiet_NaN());
  for (const MethodEntry& entry : entries) {
    for (std::size_t i = 0; i < probes; ++i) best[i] = std::fmin(best[i], entry.errors[i]);
  }
  return best;
}

/// NaN without any.
double mean_of(const std::vector<double>& errors, const std::vector<double>& instead) {
  double sum = 0, count = 0;
  for (std::size_t i = 0; i < errors.size(); ++i) {
    const double error = std::isnan(errors[i]) ? instead[i] : errors[i];
    if (std::isnan(error)) continue;
    sum += error;
    count += 1;
  }
  return sum / count;
}

class ValidatedPatcher : public Patcher {
 public:
  ValidatedPatcher(Ladder ways, std::size_t rank) : ways_(std::move(ways)), rank_(rank) {}

  const char* method() const override { return ways_.back()->method(); }

  std::optional<HolePatch> attempt(const HoleSite& site, Progress& progress) const override {
    const CrossValidation validation(site, progress);
    std::vector<MethodEntry> entries;
    for (const auto& way : ways_) {
      auto patch = way->attempt(site, progress);
      if (!patch) continue;
      patch->method = way->method();
      entries.push_back({std::move(*patch), validation.errors(*way, progress), 0});
    }
    if (rank_ >= entries.size()) return std::nullopt;
    const std::vector<double> best = best_errors(entries, validation.probe_count());
    double factor = 1;
    for (MethodEntry& entry : entries) {
      entry.patch.expected_error = mean_of(entry.errors, best);
      entry.handicapped = std::isnan(entry.patch.expected_error) ? factor : factor * entry.patch.expected_error;
      factor *= handicap;
    }
    std::stable_sort(entries.begin(), entries.end(),
                     [](const MethodEntry& a, const MethodEntry& b) { return a.handicapped < b.handicapped; });
    return std::move(entries[rank_].patch);
  }

 private:
  Ladder ways_;
  std::size_t rank_;
};

}  // namespace

std::shared_ptr<const Patcher> validated_patcher(Ladder ways, std::size_t rank) {
  return std::make_shared<ValidatedPatcher>(std::move(ways), rank);
}

}  // namespace croquis::hole_filling

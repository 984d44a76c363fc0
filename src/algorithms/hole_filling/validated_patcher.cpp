// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <numeric>
#include <utility>

#include "algorithms/hole_filling/cross_validation.h"
#include "algorithms/hole_filling/patcher.h"

namespace croquis::hole_filling {
namespace {

class ValidatedPatcher : public Patcher {
 public:
  ValidatedPatcher(Ladder ways, std::size_t rank) : ways_(std::move(ways)), rank_(rank) {}

  const char* method() const override { return ways_.front()->method(); }

  std::optional<HolePatch> attempt(const HoleSite& site, Progress& progress) const override {
    const CrossValidation validation(site, progress);
    std::vector<double> errors;
    for (const auto& way : ways_) errors.push_back(validation.error(*way, progress));
    std::vector<std::size_t> order(ways_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return errors[a] < errors[b]; });
    const std::size_t chosen = order[rank_];
    auto patch = ways_[chosen]->attempt(site, progress);
    if (!patch) return std::nullopt;
    patch->method = ways_[chosen]->method();
    patch->expected_error = errors[chosen];
    return patch;
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

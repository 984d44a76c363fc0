// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/tools/holes/hole_histogram.h"

#include <algorithm>
#include <cmath>

namespace croquis {
namespace {

/// Above a hole's own diameter, by more than rounding to six digits loses.
constexpr double hair = 1e-5;

bool is_size(double diameter) { return std::isfinite(diameter) && diameter > 0; }

}  // namespace

HoleHistogram::HoleHistogram(std::span<const double> diameters, std::size_t bin_count) {
  std::copy_if(diameters.begin(), diameters.end(), std::back_inserter(sorted_), is_size);
  std::sort(sorted_.begin(), sorted_.end());
  if (sorted_.empty()) return;
  const std::size_t count = least() < greatest() ? std::max<std::size_t>(bin_count, 1) : 1;
  for (std::size_t i = 0; i < count; ++i) {
    const auto part = [&](std::size_t n) { return diameter(static_cast<double>(n) / static_cast<double>(count)); };
    bins_.push_back({part(i), part(i + 1), 0});
  }
  for (const double size : sorted_) {
    const auto after = std::upper_bound(bins_.begin(), bins_.end(), size,
                                        [](double value, const Bin& bin) { return value < bin.low; });
    ++(after - 1)->count;
  }
}

std::size_t HoleHistogram::highest() const {
  std::size_t most = 0;
  for (const Bin& bin : bins_) most = std::max(most, bin.count);
  return most;
}

std::size_t HoleHistogram::count_up_to(double diameter) const {
  return static_cast<std::size_t>(std::upper_bound(sorted_.begin(), sorted_.end(), diameter) - sorted_.begin());
}

double HoleHistogram::position(double diameter) const {
  if (empty() || diameter >= greatest()) return 1;
  if (!(diameter > least())) return 0;
  return std::log(diameter / least()) / std::log(greatest() / least());
}

double HoleHistogram::diameter(double position) const {
  if (empty()) return 0;
  if (position >= 1) return greatest();
  if (!(position > 0)) return least();
  return std::clamp(least() * std::pow(greatest() / least(), position), least(), greatest());
}

double HoleHistogram::snapped(double position, double within) const {
  if (empty()) return 0;
  const double wanted = diameter(position);
  auto next = std::lower_bound(sorted_.begin(), sorted_.end(), wanted);
  if (next == sorted_.end()) --next;
  if (next != sorted_.begin() && position - this->position(*(next - 1)) < this->position(*next) - position) --next;
  if (std::abs(this->position(*next) - position) > within) return wanted;
  const auto larger = std::upper_bound(next, sorted_.end(), *next);
  const double raised = *next * (1 + hair);
  // Halfway where the next hole is as near as that.
  return larger != sorted_.end() && raised >= *larger ? *next + (*larger - *next) / 2 : raised;
}

}  // namespace croquis

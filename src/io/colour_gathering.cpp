// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/colour_gathering.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "io/channel_values.h"
#include "io/text.h"

namespace croquis {
namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

}  // namespace

bool ColourGathering::add(std::size_t element, std::span<const std::string_view> words) {
  values_.resize(4 * element, nothing);
  for (const std::string_view word : words) {
    double value = 0;
    if (!parse_number(word, value)) return false;
    whole_ = whole_ && word.find_first_of(".eEnN") == std::string_view::npos;
    values_.push_back(value);
  }
  // No alpha is known to be opaque only at the end, when the scale is; infinity stands for it until then.
  if (words.size() == 3) values_.push_back(std::numeric_limits<double>::infinity());
  width_ = std::max(width_, words.size());
  ++count_;
  return true;
}

void ColourGathering::finish(PolyMesh& mesh, Domain domain) {
  if (count_ == 0) return;
  const std::size_t elements = mesh.element_count(domain);
  values_.resize(4 * elements, nothing);
  const double full = whole_ ? 255 : 1;
  bool bytes = whole_ && count_ == elements;
  std::vector<double> scaled;
  scaled.reserve(elements * width_);
  for (std::size_t e = 0; e < elements; ++e) {
    for (std::size_t k = 0; k < width_; ++k) {
      const double value = std::isinf(values_[4 * e + k]) ? full : values_[4 * e + k];
      bytes = bytes && value >= 0 && value <= full;
      scaled.push_back(value / full);
    }
  }
  mesh.channels.push_back(colour_channel(domain, static_cast<int>(width_), std::move(scaled), bytes));
}

}  // namespace croquis

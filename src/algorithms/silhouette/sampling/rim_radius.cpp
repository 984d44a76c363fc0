// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/sampling/rim_radius.h"

#include <algorithm>
#include <cmath>

namespace croquis::silhouette {
namespace {

constexpr int smoothing_passes = 3;  // with weights 1/4, 1/2, 1/4: chords of neighbouring samples differ by their noise

/// Linear between the values that there are, periodic. At least one value must be there.
void fill_gaps(std::vector<double>& values) {
  const std::size_t count = values.size();
  std::size_t first = 0;
  while (std::isnan(values[first])) ++first;
  for (std::size_t done = 0; done < count;) {
    const std::size_t from = first + done;
    std::size_t length = 1;
    while (std::isnan(values[(from + length) % count])) ++length;
    const double begin = values[from % count];
    const double end = values[(from + length) % count];
    for (std::size_t k = 1; k < length; ++k) {
      values[(from + k) % count] = begin + (end - begin) * static_cast<double>(k) / static_cast<double>(length);
    }
    done += length;
  }
}

void smooth_cycle(std::vector<double>& values) {
  const std::vector<double> old = values;
  const std::size_t count = old.size();
  for (std::size_t i = 0; i < count; ++i) {
    values[i] = 0.25 * old[(i + count - 1) % count] + 0.5 * old[i] + 0.25 * old[(i + 1) % count];
  }
}

}  // namespace

double row_depth(double radius, double angle) { return radius * (1 - std::cos(angle)); }

std::vector<std::vector<double>> rim_radii(const LabelledFigure& figure, const Skeleton& skeleton) {
  std::vector<std::vector<double>> radii;
  for (std::size_t c = 0; c < figure.contours.size(); ++c) {
    std::vector<double> values(figure.contours[c].vertices.size(), std::nan(""));
    if (c < skeleton.contour_radius.size() && skeleton.contour_radius[c].size() == values.size()) {
      values = skeleton.contour_radius[c];
    }
    if (std::all_of(values.begin(), values.end(), [](double r) { return std::isnan(r); })) {
      values.assign(values.size(), skeleton.scale);
    }
    fill_gaps(values);
    for (int pass = 0; pass < smoothing_passes; ++pass) smooth_cycle(values);
    radii.push_back(std::move(values));
  }
  return radii;
}

}  // namespace croquis::silhouette

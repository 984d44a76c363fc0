// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/sampling/rim_radius.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace croquis::silhouette {
namespace {

constexpr int smoothing_passes = 3;  // with weights 1/4, 1/2, 1/4: chords of neighbouring samples differ by their noise

// Between the rows of a tube, radians: 15, 20 and 25 degrees.
constexpr std::array tube_turns = {0.2617993877991494, 0.3490658503988659, 0.4363323129985824};
constexpr double last_angle = 1.12;  // beyond, the plane's own points are even on the surface

// Contour steps.
constexpr double first_arc = 2.2;  // from the rim to the first row
constexpr double widest_gap = 2;   // in the plane: wider ones hold points of their own
constexpr double arc_growth = 1.12;
constexpr double widest_tube = first_arc / tube_turns[0];  // radius; the first row lies nowhere deeper

constexpr double most_widening = 4;  // of the radius of a thin part

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

std::vector<double> row_depths(double radius, double step) {
  std::vector<double> depths;
  double angle = 0;
  double arc = first_arc * step;
  while (depths.size() < most_rows) {
    angle += std::min(tube_turns[std::min(depths.size(), tube_turns.size() - 1)], arc / radius);
    const double depth = radius * (1 - std::cos(angle));
    if (angle > last_angle || (depths.size() >= tube_turns.size() && depth - depths.back() > widest_gap * step)) break;
    arc *= arc_growth;
    depths.push_back(depth);
  }
  return depths;
}

double greatest_first_row() { return 1 - std::cos(tube_turns[0]); }

RimValues rim_radii(const Skeleton& skeleton) {
  RimValues radii = skeleton.contour_radius;
  for (std::vector<double>& values : radii) {
    if (std::all_of(values.begin(), values.end(), [](double r) { return std::isnan(r); })) {
      values.assign(values.size(), skeleton.scale);
    }
    fill_gaps(values);
    for (int pass = 0; pass < smoothing_passes; ++pass) smooth_cycle(values);
  }
  return radii;
}

std::vector<Index> thin_objects(std::span<const double> thickness) {
  std::vector<Index> thin;
  for (Index object = 0; object < thickness.size(); ++object) {
    if (thickness[object] < 1) thin.push_back(object);
  }
  return thin;
}

RimValues row_radii(const LabelledFigure& figure, RimValues radii, std::span<const Index> thin) {
  for (const Index object : thin) {
    for (const Index contour : figure.objects[object].contours) {
      for (double& radius : radii[contour]) radius = std::min(widest_tube * figure.step, most_widening * radius);
    }
  }
  return radii;
}

}  // namespace croquis::silhouette

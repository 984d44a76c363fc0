// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/sampling/rim_radius.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace croquis::silhouette {
namespace {

constexpr int smoothing_passes = 3;  // with weights 1/4, 1/2, 1/4: chords of neighbouring samples differ by their noise

// Between the rows of a tube, radians: 15, 20 and 25 degrees.
constexpr double tube_turns[] = {0.2617993877991494, 0.3490658503988659, 0.4363323129985824};
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

RimRows::RimRows(double radius, double step) {
  double angle = 0;
  double arc = first_arc * step;
  double before = 0;
  while (count_ < most) {
    const double turn = count_ < std::size(tube_turns) ? tube_turns[count_] : tube_turns[std::size(tube_turns) - 1];
    angle += std::min(turn, arc / radius);
    const double depth = radius * (1 - std::cos(angle));
    if (angle > last_angle || (count_ >= std::size(tube_turns) && depth - before > widest_gap * step)) break;
    arc *= arc_growth;
    depth_[count_++] = before = depth;
  }
}

double first_row_depth(double radius, double step) {
  return radius * (1 - std::cos(std::min(tube_turns[0], first_arc * step / radius)));
}

double greatest_first_row() { return 1 - std::cos(tube_turns[0]); }

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

std::vector<Index> thin_objects(std::span<const double> thickness) {
  std::vector<Index> thin;
  for (Index object = 0; object < thickness.size(); ++object) {
    if (thickness[object] < 1) thin.push_back(object);
  }
  return thin;
}

std::vector<std::vector<double>> row_radii(const LabelledFigure& figure, std::vector<std::vector<double>> radii,
                                           std::span<const Index> thin) {
  for (const Index object : thin) {
    for (const Index contour : figure.objects[object].contours) {
      for (double& radius : radii[contour]) {
        radius = std::min(widest_tube * figure.step, most_widening * radius);
      }
    }
  }
  return radii;
}

}  // namespace croquis::silhouette

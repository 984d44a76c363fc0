// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/bench_surface.h"

#include <cmath>

#include "bench/bench.h"

namespace croquis::bench {

std::vector<DomainSample> domain_samples(const DomainPolygon& domain, int rings) {
  std::vector<DomainSample> samples;
  for (std::size_t k = 0; k < domain.corners.size(); ++k) {
    const Vec2 first = domain.corners[k] - domain.middle;
    const Vec2 second = domain.corners[(k + 1) % domain.corners.size()] - domain.middle;
    const double area = cross(first, second) / 2 / (rings * rings);
    const auto add = [&](double a, double b) {
      samples.push_back({domain.middle + (a * first + b * second) / rings, area});
    };
    // Small triangles by their middles: those that point outwards and those between them.
    for (int i = 0; i < rings; ++i) {
      for (int j = 0; i + j < rings; ++j) {
        add(i + 1.0 / 3, j + 1.0 / 3);
        if (i + j + 1 < rings) add(i + 2.0 / 3, j + 2.0 / 3);
      }
    }
  }
  return samples;
}

double geometric_mean(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += std::log(value);
  return std::exp(sum / static_cast<double>(values.size()));
}

void bench_surface(std::ostream& out) {
  bench_surface_domains(out);
  bench_surface_placement(out);
  bench_surface_speed(out);
}

}  // namespace croquis::bench

// SPDX-License-Identifier: GPL-3.0-or-later
#include "implicit/fit_evaluation.h"

#include <algorithm>
#include <cmath>

#include "implicit/lanes.h"

namespace croquis::implicit {
namespace {

constexpr std::size_t chunk = 64;  // centres whose distances lie in buffers of 3 kB altogether

// Squares of distances count as at least this: below it nothing is left of any kernel, and no lane divides by 0.
constexpr double least_square = 1e-280;

/// What the kernels need of the offsets d = x - c of up to `chunk` centres.
struct Offsets {
  double x[chunk], y[chunk], z[chunk];
  double square[chunk];   // |d|^2
  double radius[chunk];   // |d|
  double special[chunk];  // 1/|d| where a kernel needs it for gradients, or ln |d|^2 for the thin plate
};

struct Sums {
  Lanes value = {};
  Lanes x = {}, y = {}, z = {};
};

template <Kernel kernel, bool with_gradients>
CROQUIS_PART void measure(const double* columns, std::size_t stride, std::size_t begin, std::size_t count,
                          const Vec3& p, Offsets& o) {
  const double px = p[0], py = p[1], pz = p[2];
  const double* cx = columns + begin;
  const double* cy = cx + stride;
  const double* cz = cy + stride;
  for (std::size_t i = 0; i < count; ++i) {
    o.x[i] = px - cx[i];
    o.y[i] = py - cy[i];
    o.z[i] = pz - cz[i];
    const double square = o.x[i] * o.x[i] + o.y[i] * o.y[i] + o.z[i] * o.z[i];
    o.square[i] = square > least_square ? square : least_square;
  }
  if constexpr (kernel == Kernel::ThinPlate) {
    for (std::size_t i = 0; i < count; ++i) o.special[i] = log_of_normal(o.square[i]);
  } else {
    for (std::size_t i = 0; i < count; ++i) o.radius[i] = std::sqrt(o.square[i]);
    if constexpr (with_gradients && (kernel == Kernel::Hermite || kernel == Kernel::Biharmonic)) {
      for (std::size_t i = 0; i < count; ++i) o.special[i] = 1 / o.radius[i];
    }
  }
}

/// 8 vectors.
struct LaneVectors {
  Lanes x, y, z;
};

/// The offsets of 8 centres.
CROQUIS_PART void load_offsets(LaneVectors& d, const Offsets& o, std::size_t i) {
  load(d.x, o.x + i);
  load(d.y, o.y + i);
  load(d.z, o.z + i);
}

/// Adds t d.
CROQUIS_PART void add_along(const Offsets& o, std::size_t i, const Lanes& t, Sums& sums) {
  LaneVectors d;
  load_offsets(d, o, i);
  sums.x += t * d.x;
  sums.y += t * d.y;
  sums.z += t * d.z;
}

/// The terms of 8 centres of value kernels: a phi, and t d with t = phi'/r.
template <Kernel kernel, bool with_gradients>
CROQUIS_PART void add_values(const Offsets& o, std::size_t i, const Lanes& a, Sums& sums) {
  Lanes square, radius = {}, special = {}, t;
  load(square, o.square + i);
  if constexpr (kernel != Kernel::ThinPlate) load(radius, o.radius + i);
  if constexpr (kernel == Kernel::ThinPlate || (kernel == Kernel::Biharmonic && with_gradients))
    load(special, o.special + i);
  if constexpr (kernel == Kernel::Triharmonic) {
    sums.value += a * (square * radius);
    t = 3 * (a * radius);
  } else if constexpr (kernel == Kernel::Biharmonic) {
    sums.value += a * radius;
    t = a * special;
  } else {
    sums.value += a * (0.5 * square * special);
    t = a * (special + 1);
  }
  if constexpr (with_gradients) add_along(o, i, t, sums);
}

/// What kernels with gradients take of 8 centres.
struct Directed {
  LaneVectors d, b;
  Lanes square, radius, a;
  Lanes s;  // b . d
};

CROQUIS_PART void load_directed(Directed& c, const Offsets& o, std::size_t i, const double* weights,
                                std::size_t stride) {
  load_offsets(c.d, o, i);
  load(c.square, o.square + i);
  load(c.radius, o.radius + i);
  load(c.a, weights);
  load(c.b.x, weights + stride);
  load(c.b.y, weights + 2 * stride);
  load(c.b.z, weights + 3 * stride);
  c.s = c.b.x * c.d.x + c.b.y * c.d.y + c.b.z * c.d.z;
}

/// Adds t d - u b.
CROQUIS_PART void add_between(const Directed& c, const Lanes& t, const Lanes& u, Sums& sums) {
  sums.x += t * c.d.x - u * c.b.x;
  sums.y += t * c.d.y - u * c.b.y;
  sums.z += t * c.d.z - u * c.b.z;
}

/// The terms of 8 centres of the Hermite kernel, with s = b . d: r (a r^2 - 3 s), and 3 ((a r - s/r) d - r b).
template <bool with_gradients>
CROQUIS_PART void add_hermite(const Offsets& o, std::size_t i, const double* weights, std::size_t stride, Sums& sums) {
  Directed c;
  load_directed(c, o, i, weights, stride);
  sums.value += c.radius * (c.a * c.square - 3 * c.s);
  if constexpr (with_gradients) {
    Lanes inverse;
    load(inverse, o.special + i);
    add_between(c, c.a * c.radius - c.s * inverse, c.radius, sums);
  }
}

/// The same for r^5: r^3 (a r^2 - 5 s), and 5 (r (a r^2 - 3 s) d - r^3 b).
template <bool with_gradients>
CROQUIS_PART void add_quintic(const Offsets& o, std::size_t i, const double* weights, std::size_t stride, Sums& sums) {
  Directed c;
  load_directed(c, o, i, weights, stride);
  const Lanes cube = c.radius * c.square;
  sums.value += cube * (c.a * c.square - 5 * c.s);
  if constexpr (with_gradients) add_between(c, c.radius * (c.a * c.square - 3 * c.s), cube, sums);
}

/// The terms of 8 centres of a kernel with gradients that have none, with the factor of the others: a phi, and t d.
template <Kernel kernel, bool with_gradients>
CROQUIS_PART void add_undirected(const Offsets& o, std::size_t i, const double* weights, Sums& sums) {
  Lanes square, radius, a;
  load(square, o.square + i);
  load(radius, o.radius + i);
  load(a, weights);
  const Lanes t = kernel == Kernel::Hermite ? a * radius : radius * (a * square);
  sums.value += t * square;
  if constexpr (with_gradients) add_along(o, i, t, sums);
}

template <Kernel kernel, bool with_gradients>
CROQUIS_PART void evaluate_point(const FitColumns& fit, const Vec3& point, double& value, Vec3* gradient) {
  Offsets offsets;
  Sums sums;
  for (std::size_t begin = 0; begin < fit.stride; begin += chunk) {
    const std::size_t count = std::min(chunk, fit.stride - begin);
    measure<kernel, with_gradients>(fit.columns, fit.stride, begin, count, point, offsets);
    const double* weights = fit.columns + 3 * fit.stride + begin;
    for (std::size_t i = 0; i < count; i += lane_count) {
      if (takes_gradients(kernel) && begin + i >= fit.directed) {
        add_undirected<kernel, with_gradients>(offsets, i, weights + i, sums);
      } else if constexpr (kernel == Kernel::Hermite) {
        add_hermite<with_gradients>(offsets, i, weights + i, fit.stride, sums);
      } else if constexpr (kernel == Kernel::HermiteQuintic) {
        add_quintic<with_gradients>(offsets, i, weights + i, fit.stride, sums);
      } else {
        Lanes a;
        load(a, weights + i);
        add_values<kernel, with_gradients>(offsets, i, a, sums);
      }
    }
  }
  value = sum(sums.value);
  if constexpr (with_gradients) {
    *gradient = Vec3(sum(sums.x), sum(sums.y), sum(sums.z));
    if constexpr (takes_gradients(kernel)) *gradient *= kernel == Kernel::Hermite ? 3 : 5;
  }
}

template <Kernel kernel>
CROQUIS_PART void evaluate_points(const FitColumns& fit, std::span<const Vec3> points, std::span<double> values,
                                  std::span<Vec3> gradients) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (gradients.empty()) {
      evaluate_point<kernel, false>(fit, points[i], values[i], nullptr);
    } else {
      evaluate_point<kernel, true>(fit, points[i], values[i], &gradients[i]);
    }
  }
}

CROQUIS_FOR_EVERY_MACHINE void evaluate_hermite(const FitColumns& fit, std::span<const Vec3> points,
                                                std::span<double> values, std::span<Vec3> gradients) {
  evaluate_points<Kernel::Hermite>(fit, points, values, gradients);
}

CROQUIS_FOR_EVERY_MACHINE void evaluate_quintic(const FitColumns& fit, std::span<const Vec3> points,
                                                std::span<double> values, std::span<Vec3> gradients) {
  evaluate_points<Kernel::HermiteQuintic>(fit, points, values, gradients);
}

CROQUIS_FOR_EVERY_MACHINE void evaluate_triharmonic(const FitColumns& fit, std::span<const Vec3> points,
                                                    std::span<double> values, std::span<Vec3> gradients) {
  evaluate_points<Kernel::Triharmonic>(fit, points, values, gradients);
}

CROQUIS_FOR_EVERY_MACHINE void evaluate_biharmonic(const FitColumns& fit, std::span<const Vec3> points,
                                                   std::span<double> values, std::span<Vec3> gradients) {
  evaluate_points<Kernel::Biharmonic>(fit, points, values, gradients);
}

CROQUIS_FOR_EVERY_MACHINE void evaluate_thin_plate(const FitColumns& fit, std::span<const Vec3> points,
                                                   std::span<double> values, std::span<Vec3> gradients) {
  evaluate_points<Kernel::ThinPlate>(fit, points, values, gradients);
}

}  // namespace

void evaluate_columns(const FitColumns& fit, std::span<const Vec3> points, std::span<double> values,
                      std::span<Vec3> gradients) {
  switch (fit.kernel) {
    case Kernel::Hermite: return evaluate_hermite(fit, points, values, gradients);
    case Kernel::HermiteQuintic: return evaluate_quintic(fit, points, values, gradients);
    case Kernel::Triharmonic: return evaluate_triharmonic(fit, points, values, gradients);
    case Kernel::Biharmonic: return evaluate_biharmonic(fit, points, values, gradients);
    case Kernel::ThinPlate: return evaluate_thin_plate(fit, points, values, gradients);
  }
}

}  // namespace croquis::implicit

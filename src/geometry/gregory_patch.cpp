// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/geometry/gregory_patch.h"

#include <cstddef>

namespace croquis {
namespace {

struct CubicWeights {
  std::array<double, 4> value;
  std::array<double, 4> slope;
};

CubicWeights cubic_weights(double t) {
  const double s = 1 - t;
  return {{s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t},
          {-3 * s * s, 3 * s * s - 6 * s * t, 6 * s * t - 3 * t * t, 3 * t * t}};
}

/// Column and row, in a bicubic's net, of each boundary point.
constexpr std::array<std::array<std::size_t, 2>, 12> boundary_cell = {
    {{0, 0}, {1, 0}, {2, 0}, {3, 0}, {3, 1}, {3, 2}, {3, 3}, {2, 3}, {1, 3}, {0, 3}, {0, 2}, {0, 1}}};

/// The blend of the two inner points of a corner: how much the one of the side along v = const counts.
struct CornerBlend {
  double value, du, dv;
};

/// @param a,b distances from the corner along u and v; sign_u, sign_v how they change with u and v
CornerBlend corner_blend(double a, double b, double sign_u, double sign_v) {
  const double sum = a + b;
  if (sum <= 0) return {0.5, 0, 0};  // the weight of the net's point is zero of second order there
  return {a / sum, sign_u * b / (sum * sum), -sign_v * a / (sum * sum)};
}

}  // namespace

GregoryWeights gregory_weights(double u, double v) {
  const CubicWeights along_u = cubic_weights(u), along_v = cubic_weights(v);
  GregoryWeights result;
  for (std::size_t i = 0; i < 12; ++i) {
    const auto [column, row] = boundary_cell[i];
    result.value[i] = along_u.value[column] * along_v.value[row];
    result.du[i] = along_u.slope[column] * along_v.value[row];
    result.dv[i] = along_u.value[column] * along_v.slope[row];
  }
  for (std::size_t corner = 0; corner < 4; ++corner) {
    const bool right = corner == 1 || corner == 2, top = corner >= 2;
    const std::size_t column = right ? 2 : 1, row = top ? 2 : 1;
    const CornerBlend blend = corner_blend(right ? 1 - u : u, top ? 1 - v : v, right ? -1 : 1, top ? -1 : 1);
    const double value = along_u.value[column] * along_v.value[row];
    const double du = along_u.slope[column] * along_v.value[row], dv = along_u.value[column] * along_v.slope[row];
    // Sides 0 and 2 are the ones along v = const; they start at corners 0 and 2.
    const std::size_t level = 12 + 2 * corner + corner % 2, upright = 12 + 2 * corner + 1 - corner % 2;
    result.value[level] = value * blend.value;
    result.du[level] = du * blend.value + value * blend.du;
    result.dv[level] = dv * blend.value + value * blend.dv;
    result.value[upright] = value * (1 - blend.value);
    result.du[upright] = du * (1 - blend.value) - value * blend.du;
    result.dv[upright] = dv * (1 - blend.value) - value * blend.dv;
  }
  return result;
}

RationalCubic GregoryPatch::side(int i) const {
  const auto first = static_cast<std::size_t>(3 * i);
  return {{boundary[first], boundary[first + 1], boundary[first + 2], boundary[(first + 3) % 12]}};
}

PatchPoint GregoryPatch::at(double u, double v) const {
  const GregoryWeights weights = gregory_weights(u, v);
  PatchPoint result;
  for (std::size_t i = 0; i < 20; ++i) {
    const Vec3& point = i < 12 ? boundary[i] : inner[i - 12];
    result.at += weights.value[i] * point;
    result.du += weights.du[i] * point;
    result.dv += weights.dv[i] * point;
  }
  return result;
}

}  // namespace croquis

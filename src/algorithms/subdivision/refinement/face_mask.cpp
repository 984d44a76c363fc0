// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/subdivision/refinement/face_mask.h"

#include <cmath>
#include <numbers>

namespace croquis::subdivision {
namespace {

/// Faces up to this size have their roots tabled; larger ones are rare.
constexpr std::size_t largest_tabled = 32;

/// cos and sin of an angle of at most an eighth of a turn, by their series.
Vec2 cos_sin(double angle) {
  const double square = angle * angle;
  double cosine = 1, sine = 1;
  for (int k = 20; k > 0; k -= 2) {
    cosine = 1 - cosine * square / (k * (k - 1));
    sine = 1 - sine * square / (k * (k + 1));
  }
  return {cosine, sine * angle};
}

}  // namespace

Vec2 unit_root(std::size_t j, std::size_t n) {
  j %= n;
  if (2 * j > n) return unit_root(n - j, n).cwiseProduct(Vec2(1, -1));
  if (4 * j > n) {  // beyond a quarter: mirror; 2n and 2j keep the half of n whole
    return unit_root(n - 2 * j, 2 * n).cwiseProduct(Vec2(-1, 1));
  }
  if (8 * j > n) {  // beyond an eighth: cos and sin change places
    const Vec2 mirrored = unit_root(n - 4 * j, 4 * n);
    return {mirrored.y(), mirrored.x()};
  }
  return cos_sin(2 * std::numbers::pi * static_cast<double>(j) / static_cast<double>(n));
}

FaceMask::FaceMask(Weights weights) : weights_(weights) {
  for (std::size_t n = 1; n <= largest_tabled; ++n) {
    for (std::size_t j = 0; j < n; ++j) roots_.push_back(unit_root(j, n));
  }
}

Vec2 FaceMask::root(std::size_t j, std::size_t n) const {
  return n <= largest_tabled ? roots_[n * (n - 1) / 2 + j] : unit_root(j, n);
}

std::vector<double> FaceMask::row(std::size_t n) const {
  const auto count = static_cast<double>(n);
  std::vector<double> weights(n);
  if (weights_ == Weights::Average) {
    for (double& weight : weights) weight = 1 / (4 * count);
    weights[1] = weights[n - 1] = (count + 2) / (8 * count);
    weights[0] = (2 * count + 1) / (4 * count);
    return weights;
  }
  for (std::size_t j = 1; j < n; ++j) weights[j] = (3 + 2 * root(j, n).x()) / (4 * count);
  weights[0] = (count + 5) / (4 * count);
  return weights;
}

void FaceMask::apply_average(const Vec3* points, std::span<const Index> corners, Vec3* result) const {
  const std::size_t n = corners.size();
  Vec3 sum = Vec3::Zero();
  for (const Index corner : corners) sum += points[corner];
  const Vec3 centroid = sum / static_cast<double>(n);
  for (std::size_t j = 0; j < n; ++j) {
    const Vec3 &before = points[corners[(j + n - 1) % n]], &after = points[corners[(j + 1) % n]];
    result[j] = 0.5 * points[corners[j]] + 0.125 * (before + after) + 0.25 * centroid;
  }
}

void FaceMask::apply_to_polygon(const Vec3* points, std::span<const Index> corners, Vec3* result) const {
  if (weights_ == Weights::Average) return apply_average(points, corners, result);
  const std::size_t n = corners.size();
  Vec3 sum = Vec3::Zero(), cosine = Vec3::Zero(), sine = Vec3::Zero();
  for (std::size_t j = 0; j < n; ++j) {
    const Vec3& point = points[corners[j]];
    const Vec2 at = root(j, n);
    sum += point;
    cosine += at.x() * point;
    sine += at.y() * point;
  }
  const auto count = static_cast<double>(n);
  for (std::size_t j = 0; j < n; ++j) {
    const Vec2 at = root(j, n);
    result[j] = 0.25 * points[corners[j]] + (0.75 * sum + 0.5 * (at.x() * cosine + at.y() * sine)) / count;
  }
}

}  // namespace croquis::subdivision

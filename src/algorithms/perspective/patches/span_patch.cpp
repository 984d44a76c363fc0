// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <cstddef>

#include <Eigen/Dense>

#include "algorithms/perspective/patches/patch_energy.h"
#include "croquis/perspective/gregory_patches.h"

namespace croquis {
namespace {

/// A slope chosen by proportion may be so many times the ends' mean; else the mean is taken.
constexpr double least_slope = 0.2, greatest_slope = 4;

Vec3 cubic_middle(const std::array<Vec3, 4>& p) { return (p[0] + 3 * p[1] + 3 * p[2] + p[3]) / 8; }

/// A leg as k · across + h · handle, by least squares.
struct LegParts {
  double across, along;
};

LegParts leg_parts(const Vec3& leg, const Vec3& across, const Vec3& handle) {
  const double aa = across.dot(across), ac = across.dot(handle), cc = handle.dot(handle);
  const double determinant = aa * cc - ac * ac;
  if (determinant <= 0) return {0, 0};
  const double la = leg.dot(across), lc = leg.dot(handle);
  return {(la * cc - lc * ac) / determinant, (lc * aa - la * ac) / determinant};
}

/// The slopes across a side are k(t) a(t) + h(t) c(t): k is a quadratic with the free middle coefficient, a and h are
/// linear, c is the side's direction.
struct CommonSlope {
  std::array<Vec3, 2> a;
  std::array<double, 2> k, h;
  std::array<Vec3, 3> c;

  std::array<Vec3, 2> inner(double km) const {
    return {(k[0] * a[1] + 2 * km * a[0]) / 3 + (2 * h[0] * c[1] + h[1] * c[0]) / 3,
            (2 * km * a[1] + k[1] * a[0]) / 3 + (h[0] * c[2] + 2 * h[1] * c[1]) / 3};
  }
};

class PatchSpanner {
 public:
  PatchSpanner(const std::array<PatchSide, 4>& sides, SlopeRule rule) : sides_(sides), rule_(rule) {
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = 0; j < 3; ++j) patch_.boundary[3 * i + j] = sides[i].points[j];
    }
  }

  GregoryPatch run() {
    for (std::size_t i = 0; i < 4; ++i) {
      if (!sides_[i].common) {
        set_even(i);
        continue;
      }
      slopes_[i] = common_slope(i);
      middle_[i] = rule_ == SlopeRule::Mean ? mean(i) : proportion(i);
      set_common(i);
    }
    if (rule_ == SlopeRule::Fair) make_fair();
    return patch_;
  }

 private:
  const Vec3& boundary(std::size_t i) const { return patch_.boundary[i % 12]; }
  Vec3 first_leg(std::size_t side) const { return boundary(3 * side + 11) - boundary(3 * side); }
  Vec3 last_leg(std::size_t side) const { return boundary(3 * side + 4) - boundary(3 * side + 3); }

  void set_inner(std::size_t side, const Vec3& first, const Vec3& second) {
    patch_.inner[2 * side] = boundary(3 * side + 1) + first;
    patch_.inner[(2 * side + 3) % 8] = boundary(3 * side + 2) + second;
  }

  void set_even(std::size_t side) {
    const Vec3 first = first_leg(side), last = last_leg(side);
    set_inner(side, (2 * first + last) / 3, (first + 2 * last) / 3);
  }

  void set_common(std::size_t side) {
    const std::array<Vec3, 2> inner = slopes_[side].inner(middle_[side]);
    set_inner(side, inner[0], inner[1]);
  }

  CommonSlope common_slope(std::size_t side) const {
    const std::array<Vec3, 4>& p = sides_[side].points;
    CommonSlope slope{sides_[side].across, {}, {}, {p[1] - p[0], p[2] - p[1], p[3] - p[2]}};
    const LegParts first = leg_parts(first_leg(side), slope.a[0], slope.c[0]);
    const LegParts last = leg_parts(last_leg(side), slope.a[1], slope.c[2]);
    slope.k = {first.across, last.across};
    slope.h = {first.along, last.along};
    return slope;
  }

  double mean(std::size_t side) const { return (slopes_[side].k[0] + slopes_[side].k[1]) / 2; }

  /// The neighbouring sides' mean of handle by chord, times the distance to the opposite side.
  double proportion(std::size_t side) const {
    const std::array<Vec3, 4>&before = sides_[(side + 3) % 4].points, &after = sides_[(side + 1) % 4].points;
    const double rho = ((before[2] - before[3]).norm() / (before[3] - before[0]).norm() +
                        (after[1] - after[0]).norm() / (after[3] - after[0]).norm()) /
                       2;
    const double width = (cubic_middle(sides_[side].points) - cubic_middle(sides_[(side + 2) % 4].points)).norm();
    const CommonSlope& slope = slopes_[side];
    const double km = 2 * rho * width / ((slope.a[0] + slope.a[1]) / 2).norm() - mean(side);
    const double ratio = km / mean(side);
    return ratio > least_slope && ratio < greatest_slope ? km : mean(side);
  }

  /// How a side's inner points move with the middle coefficient.
  Vec3 change(std::size_t side, std::size_t end) const { return 2 * slopes_[side].a[end] / 3; }

  /// Energy is quadratic in the points, and these are linear in the middle coefficients.
  void make_fair();

  const std::array<PatchSide, 4>& sides_;
  SlopeRule rule_;
  GregoryPatch patch_;
  std::array<CommonSlope, 4> slopes_{};
  std::array<double, 4> middle_{};
};

void PatchSpanner::make_fair() {
  const Eigen::Matrix<double, 20, 20>& energy = variation_energy();
  const PatchPoints base_force = energy * points_of(patch_);
  std::array<PatchPoints, 4> force;
  std::array<std::array<int, 2>, 4> row{};
  Eigen::Matrix4d system = Eigen::Matrix4d::Identity();
  Eigen::Vector4d right = Eigen::Vector4d::Zero();
  for (std::size_t i = 0; i < 4; ++i) {
    if (!sides_[i].common) continue;
    row[i] = {static_cast<int>(12 + 2 * i), static_cast<int>(12 + (2 * i + 3) % 8)};
    force[i] = energy.col(row[i][0]) * change(i, 0).transpose() + energy.col(row[i][1]) * change(i, 1).transpose();
  }
  const auto work = [&](const PatchPoints& of, std::size_t side) {
    return of.row(row[side][0]).dot(change(side, 0)) + of.row(row[side][1]).dot(change(side, 1));
  };
  for (std::size_t i = 0; i < 4; ++i) {
    if (!sides_[i].common) continue;
    for (std::size_t j = 0; j < 4; ++j) {
      system(static_cast<int>(i), static_cast<int>(j)) = sides_[j].common ? work(force[i], j) : 0;
    }
    right[static_cast<int>(i)] = -work(base_force, i);
  }
  const Eigen::Vector4d solved = system.ldlt().solve(right);
  for (std::size_t i = 0; i < 4; ++i) {
    if (!sides_[i].common) continue;
    const double km = middle_[i] + solved[static_cast<int>(i)], ratio = km / mean(i);
    if (ratio > least_slope && ratio < greatest_slope) middle_[i] = km;
    set_common(i);
  }
}

}  // namespace

GregoryPatch span_patch(const std::array<PatchSide, 4>& sides, const PatchOptions& options) {
  return PatchSpanner(sides, options.slope).run();
}

}  // namespace croquis

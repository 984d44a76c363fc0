// SPDX-License-Identifier: GPL-3.0-or-later
// The functions whose zero sets are the sculptures.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include <Eigen/Geometry>

#include "support/scans/sculptures.h"
#include "support/scans/solid_shapes.h"

namespace croquis::test {
namespace {

constexpr double pi = std::numbers::pi;

double ripple(const Vec3& p, double frequency) {
  return std::sin(frequency * p.x()) * std::sin(frequency * p.y() + 1) * std::sin(frequency * p.z() + 2);
}

/// Both sides alike, but for y = 0 where they are blended smoothly.
Vec3 mirrored(const Vec3& p) { return {p.x(), std::sqrt(p.y() * p.y() + 1e-4), p.z()}; }

double beast(const Vec3& at) {
  const Vec3 p = mirrored(at);
  double d = limb(p, {-0.55, 0, 0.12}, {0.3, 0, 0.1}, 0.3, 0.34);
  d = blend(d, limb(p, {0.4, 0, 0.25}, {0.78, 0, 0.52}, 0.24, 0.2), 0.2);
  d = blend(d, limb(p, {0.85, 0, 0.5}, {1.12, 0, 0.4}, 0.17, 0.1), 0.12);
  d = blend(d, limb(p, {0.74, 0.12, 0.66}, {0.66, 0.26, 0.98}, 0.075, 0.03), 0.06);
  d = blend(d, limb(p, {0.45, 0.2, -0.05}, {0.5, 0.22, -0.42}, 0.15, 0.1), 0.12);
  d = blend(d, limb(p, {0.5, 0.22, -0.42}, {0.45, 0.22, -0.82}, 0.1, 0.085), 0.04);
  d = blend(d, limb(p, {-0.55, 0.2, 0}, {-0.68, 0.23, -0.4}, 0.19, 0.1), 0.12);
  d = blend(d, limb(p, {-0.68, 0.23, -0.4}, {-0.56, 0.23, -0.82}, 0.1, 0.085), 0.04);
  d = blend(d, limb(p, {-0.8, 0, 0.28}, {-1.1, 0, 0.5}, 0.09, 0.06), 0.1);
  d = blend(d, limb(p, {-1.1, 0, 0.5}, {-1.2, 0, 0.85}, 0.06, 0.045), 0.08);
  d = carve(d, ball(p, {0.93, 0.19, 0.58}, 0.05), 0.04);
  return d + 0.006 * ripple(at, 11);
}

double head(const Vec3& at) {
  const Vec3 p = mirrored(at);
  double d = ellipsoid(p, {-0.05, 0, 0.3}, {0.72, 0.58, 0.72});
  d = blend(d, ellipsoid(p, {0.25, 0, -0.15}, {0.45, 0.4, 0.5}), 0.25);
  d = blend(d, limb(p, {-0.15, 0, -0.4}, {-0.25, 0, -1.1}, 0.33, 0.4), 0.2);
  d = blend(d, limb(p, {0.66, 0, 0.28}, {0.86, 0, -0.02}, 0.05, 0.1), 0.1);
  d = blend(d, limb(p, {0.6, 0.08, 0.38}, {0.52, 0.34, 0.4}, 0.07, 0.06), 0.1);
  d = carve(d, ball(p, {0.72, 0.2, 0.22}, 0.12), 0.12);
  d = blend(d, ball(p, {0.57, 0.2, 0.22}, 0.1), 0.02);
  d = blend(d, limb(p, {0.66, 0, -0.25}, {0.56, 0.16, -0.27}, 0.055, 0.03), 0.04);
  d = blend(d, limb(p, {0.65, 0, -0.36}, {0.56, 0.14, -0.34}, 0.06, 0.03), 0.04);
  d = blend(d, ellipsoid(p, {-0.05, 0.6, 0.12}, {0.16, 0.07, 0.24}), 0.08);
  d = carve(d, ellipsoid(p, {0.0, 0.68, 0.12}, {0.09, 0.05, 0.15}), 0.05);
  return d + 0.004 * ripple(at, 14);
}

double hand(const Vec3& p) {
  double d = box(p, {0, 0, 0}, {0.28, 0.02, 0.3}) - 0.11;
  d = blend(d, limb(p, {0, 0, -0.35}, {0.02, 0, -0.95}, 0.2, 0.22), 0.15);
  constexpr std::array<double, 4> lengths = {0.62, 0.76, 0.72, 0.52};
  for (std::size_t finger = 0; finger < 4; ++finger) {
    const double x = -0.3 + 0.2 * static_cast<double>(finger), spread = 0.35 * x, length = lengths[finger];
    const Vec3 knuckle(x, 0, 0.34), middle(x + spread * length / 2, 0.04, 0.34 + length / 2);
    const Vec3 tip(x + spread * length, 0.2, 0.34 + length * 0.95);
    d = blend(d, limb(p, knuckle, middle, 0.1, 0.085), 0.06);
    d = blend(d, limb(p, middle, tip, 0.085, 0.06), 0.03);
  }
  d = blend(d, limb(p, {0.3, 0.02, -0.2}, {0.56, 0.12, 0.1}, 0.13, 0.1), 0.1);
  d = blend(d, limb(p, {0.56, 0.12, 0.1}, {0.64, 0.22, 0.38}, 0.1, 0.07), 0.04);
  return d + 0.003 * ripple(p, 17);
}

double mug(const Vec3& p) {
  const double belly = 0.5 + 0.12 * std::cos(1.6 * p.z() + 0.3);
  const double across = p.head<2>().norm();
  const double solid = -blend(belly - across, 0.75 - std::abs(p.z()), 0.08);
  const double cavity = -blend(belly - 0.1 - across, p.z() + 0.63, 0.06);
  const double vessel = carve(solid, cavity, 0.05);
  const Vec3 q = p - Vec3(0.6, 0, 0);
  const double ring = std::hypot(std::hypot(q.x(), 0.8 * q.z()) - 0.36, 0.8 * q.y()) - 0.075;
  const double handle = std::max(ring, belly - 0.05 - across);
  return blend(vessel, handle, 0.08) + 0.002 * ripple(p, 15);
}

Vec3 trefoil(double t) {
  const double around = 1 + 0.42 * std::cos(3 * t);
  return {0.7 * around * std::cos(2 * t), 0.7 * around * std::sin(2 * t), 0.38 * std::sin(3 * t)};
}

double knot(const Vec3& p) {
  constexpr int samples = 60;
  static const std::array<Vec3, samples> curve = [] {
    std::array<Vec3, samples> places;
    for (int i = 0; i < samples; ++i) places[static_cast<std::size_t>(i)] = trefoil(2 * pi * i / samples);
    return places;
  }();
  const auto nearest = std::min_element(curve.begin(), curve.end(), [&](const Vec3& a, const Vec3& b) {
    return (a - p).squaredNorm() < (b - p).squaredNorm();
  });
  double t = 2 * pi * static_cast<double>(nearest - curve.begin()) / samples;
  constexpr double step = 1e-3;
  for (int i = 0; i < 3; ++i) {
    const Vec3 at = trefoil(t), ahead = trefoil(t + step), behind = trefoil(t - step);
    const Vec3 speed = (ahead - behind) / (2 * step), turn = (ahead - 2 * at + behind) / (step * step);
    const double curvature = std::max(speed.squaredNorm() - (p - at).dot(turn), 0.1 * speed.squaredNorm());
    t += std::clamp((p - at).dot(speed) / curvature, -0.1, 0.1);
  }
  return (p - trefoil(t)).norm() - 0.17 - 0.015 * std::sin(24 * t) + 0.004 * ripple(p, 13);
}

struct Branch {
  Vec3 from, to;
  double thick, thin;
};

void grow(std::vector<Branch>& branches, const Vec3& from, const Vec3& direction, double length, double radius,
          int levels) {
  const Vec3 to = from + length * direction;
  branches.push_back({from, to, radius, 0.8 * radius});
  if (levels == 0) return;
  const Vec3 aside = direction.unitOrthogonal();
  const int forks = levels == 3 ? 3 : 2;
  for (int i = 0; i < forks; ++i) {
    const double angle = 2 * pi * i / forks + 0.8 * levels;
    const Vec3 out = Eigen::AngleAxisd(angle, direction) * aside;
    grow(branches, to, (direction + 0.85 * out).normalized(), 0.74 * length, 0.76 * radius, levels - 1);
  }
}

double coral(const Vec3& p) {
  static const std::vector<Branch> branches = [] {
    std::vector<Branch> all;
    grow(all, {0, 0, -0.9}, {0.05, 0.02, 0.99}, 0.7, 0.2, 3);
    return all;
  }();
  double d = ellipsoid(p, {0, 0, -0.95}, {0.5, 0.45, 0.2});
  for (const Branch& b : branches) d = blend(d, limb(p, b.from, b.to, b.thick, b.thin), 0.07);
  return d + 0.005 * ripple(p, 12);
}

double armour(const Vec3& p) {
  constexpr std::size_t scales = 160;
  static const std::array<Vec3, scales> centres = [] {
    std::array<Vec3, scales> spiral;
    for (std::size_t i = 0; i < scales; ++i) {
      const double z = 1 - (2 * static_cast<double>(i) + 1) / scales,
                   angle = pi * (3 - std::sqrt(5.0)) * static_cast<double>(i);
      spiral[i] = Vec3(std::sqrt(1 - z * z) * std::cos(angle), std::sqrt(1 - z * z) * std::sin(angle), z);
    }
    return spiral;
  }();
  const Vec3 radii(0.8, 0.65, 1.0);
  const Vec3 direction = p.cwiseQuotient(radii).normalized();
  double nearest = -1;
  for (const Vec3& c : centres) nearest = std::max(nearest, c.dot(direction));
  const double dome = std::max(0.0, 1 - (1 - nearest) / 0.02);
  return ellipsoid(p, Vec3::Zero(), radii) - 0.05 * dome;
}

double shell(const Vec3& p) {
  const double angle = std::atan2(p.y(), p.x());
  const double across = p.head<2>().norm();
  const double waves = 0.05 * std::sin(7 * angle) * std::min(1.0, across * across);
  const double bowl = std::abs(ellipsoid(p - Vec3(0, 0, waves), {0, 0, 0.2}, {1, 0.85, 0.8})) - 0.025;
  return -blend(-bowl, -(p.z() - 0.25 - waves), 0.04);
}

double bracket(const Vec3& p) {
  double d = box(p, {0, 0, -0.3}, {1, 0.6, 0.1});
  d = blend(d, cylinder(p, {-0.35, 0, 0}, 2, 0.36, 0.55), 0.16);
  d = std::min(d, box(p, {0.87, 0, 0.05}, {0.13, 0.6, 0.45}));
  d = std::max(d, -cylinder(p, {-0.35, 0, 0}, 2, 0.2, 2));
  for (const double y : {-0.4, 0.4}) {
    d = std::max(d, -cylinder(p, {0.42, y, 0}, 2, 0.09, 2));
    d = std::max(d, -cylinder(p, {0.9, y * 0.75, 0.2}, 0, 0.1, 0.5));
  }
  const double slope = (p.x() + p.z() - 0.62) / std::numbers::sqrt2;
  const double rib = std::max(box(p, {0.5, 0, 0.05}, {0.4, 0.07, 0.3}), -(slope + 0.12));
  return std::min(d, rib);
}

double housing(const Vec3& p) {
  double d = box(p, {0, 0, 0}, {0.8, 0.6, 0.45});
  d = std::max(d, -box(p, {0.55, 0, 0.4}, {0.3, 1, 0.2}));
  d = std::max(d, -cylinder(p, {-0.25, 0, 0.6}, 2, 0.34, 0.6));
  d = std::max(d, -cylinder(p, {-0.25, 0, 0}, 2, 0.16, 2));
  d = std::max(d, -cylinder(p, {0, 0, -0.62}, 1, 0.4, 2));
  for (const double x : {-0.6, 0.6}) d = std::min(d, cylinder(p, {x, -0.55, 0.05}, 1, 0.17, 0.25));
  const double chamfer = (std::abs(p.x()) + std::abs(p.y()) - 1.25) / std::numbers::sqrt2;
  return std::max(d, chamfer);
}

}  // namespace

double field_value(Sculpture sculpture, const Vec3& point) {
  switch (sculpture) {
    case Sculpture::Beast: return beast(point);
    case Sculpture::Head: return head(point);
    case Sculpture::Hand: return hand(point);
    case Sculpture::Mug: return mug(point);
    case Sculpture::Knot: return knot(point);
    case Sculpture::Coral: return coral(point);
    case Sculpture::Armour: return armour(point);
    case Sculpture::Shell: return shell(point);
    case Sculpture::Bracket: return bracket(point);
    case Sculpture::Housing: return housing(point);
  }
  return 0;
}

}  // namespace croquis::test

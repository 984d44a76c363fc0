// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/scans/random_solids.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <Eigen/Geometry>

#include "support/random.h"
#include "support/scans/solid_shapes.h"
#include "support/scans/waves.h"

namespace croquis::test {
namespace {

constexpr double full_turn = 2 * std::numbers::pi;
using Solid = std::function<double(const Vec3&)>;

Vec3 random_direction(Random& random) {
  const double z = random.between(-1, 1), angle = random.between(0, full_turn);
  const double across = std::sqrt(1 - z * z);
  return {across * std::cos(angle), across * std::sin(angle), z};
}

/// Limbs grown together one after the other. Those that are too far to matter are passed over.
class Skeleton {
 public:
  /// @param join how far the blend with what is there already reaches; negative: it is carved out
  void add(const Vec3& a, const Vec3& b, double radius_a, double radius_b, double join) {
    const Vec3 centre = (a + b) / 2;
    limbs_.push_back({a, b, centre, radius_a, radius_b, (a - centre).norm() + std::max(radius_a, radius_b), join});
  }

  /// Limbs along a way, with one radius per place.
  void add_chain(const std::vector<Vec3>& places, const std::vector<double>& radii, double join) {
    for (std::size_t i = 0; i + 1 < places.size(); ++i) add(places[i], places[i + 1], radii[i], radii[i + 1], join);
  }

  double at(const Vec3& p) const {
    double distance = 10;
    for (const Limb& l : limbs_) {
      const double reach = l.reach + std::abs(l.join);
      const double far = l.join > 0 ? distance + reach : reach - distance;
      const double square = (p - l.centre).squaredNorm();
      if (far < 0 || square > far * far) continue;
      const double own = limb(p, l.a, l.b, l.radius_a, l.radius_b);
      distance = l.join > 0 ? blend(distance, own, l.join) : carve(distance, own, -l.join);
    }
    return distance;
  }

 private:
  struct Limb {
    Vec3 a, b, centre;
    double radius_a, radius_b, reach, join;
  };
  std::vector<Limb> limbs_;
};

/// Waves of several lengths as tall as `share` of their length each.
class Relief {
 public:
  Relief(Random& random, double longest, int count, double share)
      : waves_(random, longest, count, 0.55), height_(share * longest / full_turn) {}
  double at(const Vec3& p) const { return height_ * waves_.at(p); }

 private:
  Waves waves_;
  double height_;
};

Solid blob(Random& random) {
  Skeleton body;
  std::vector<Vec3> knots = {Vec3::Zero()};
  const std::size_t limbs = 3 + random.below(8);
  body.add(Vec3::Zero(), 0.2 * random_direction(random), random.between(0.35, 0.6), random.between(0.3, 0.5), 0.1);
  for (std::size_t i = 0; i < limbs; ++i) {
    const Vec3 from = knots[random.below(static_cast<Index>(knots.size()))];
    const Vec3 to = 0.75 * from + random.between(0.35, 0.85) * random_direction(random);
    const double thick = random.between(0.12, 0.35);
    body.add(from, to, thick, thick * random.between(0.3, 1.1), random.between(0.04, 0.25));
    knots.push_back(to);
  }
  const std::size_t hollows = random.below(5);
  for (std::size_t i = 0; i < hollows; ++i) {
    const Vec3 at = random.between(0.5, 0.9) * random_direction(random);
    body.add(at, 1.2 * at, random.between(0.06, 0.2), random.between(0.1, 0.25), -random.between(0.03, 0.1));
  }
  const Relief relief(random, random.between(0.4, 1), 5, random.between(0.03, 0.16));
  return [=](const Vec3& p) { return body.at(p) + relief.at(p); };
}

/// A limb of two parts that may end on the body.
void add_arm(Skeleton& body, Random& random, const Vec3& shoulder, double side, double thick) {
  const Vec3 elbow =
      shoulder + Vec3(0.2 * random.between(-1, 1.5), side * random.between(0.2, 0.5), random.between(-0.45, 0.25));
  const bool is_akimbo = random.unit() < 0.4;
  const Vec3 hand = is_akimbo ? Vec3(0.05, side * 0.15, shoulder.z() - random.between(0.4, 0.7))
                              : Vec3(elbow + random.between(0.3, 0.5) * random_direction(random));
  body.add(shoulder, elbow, thick, 0.85 * thick, 0.06);
  body.add(elbow, hand, 0.85 * thick, 0.7 * thick, 0.03);
  if (is_akimbo || random.unit() < 0.4) return;
  for (std::size_t finger = 0; finger < 4; ++finger) {
    const Vec3 tip = hand + 0.25 * (hand - elbow).normalized() + 0.12 * random_direction(random);
    body.add(hand, tip, 0.4 * thick, 0.025, 0.02);
  }
}

Solid figure(Random& random) {
  Skeleton body;
  const double base = random.between(0.5, 0.72), waist = random.between(0.16, 0.24);
  const double lean = random.between(-0.12, 0.12);
  const Vec3 hip(lean, 0, 0), chest(0, random.between(-0.08, 0.08), random.between(0.4, 0.5));
  if (random.unit() < 0.6) {  // a robe
    body.add({0, 0, -1.3}, hip, base, waist, 0.1);
  } else {
    body.add({0, 0, -1.35}, {0, 0, -1.25}, base, base, 0.1);  // a stand
    for (const double side : {-1.0, 1.0}) {
      const Vec3 knee(random.between(-0.2, 0.3), side * random.between(0.14, 0.26), -0.5);
      body.add_chain({hip, knee, {0.1 * side, side * 0.2, -1.1}}, {0.2, 0.13, 0.11}, 0.08);
    }
  }
  const double shoulders = random.between(0.2, 0.32);
  body.add(hip, chest, waist, random.between(0.2, 0.28), 0.1);
  for (const double side : {-1.0, 1.0}) {
    const Vec3 shoulder = chest + Vec3(0, side * shoulders, 0.08);
    body.add(chest, shoulder, 0.16, 0.12, 0.08);
    add_arm(body, random, shoulder, side, random.between(0.07, 0.11));
  }
  const Vec3 head = chest + Vec3(random.between(-0.1, 0.15), random.between(-0.1, 0.1), 0.5);
  body.add(chest, head, 0.1, 0.09, 0.06);
  body.add(head, head + Vec3(0.04, 0, 0.08), 0.17, 0.16, 0.05);
  body.add(head + Vec3(0.17, 0, 0.06), head + Vec3(0.21, 0, -0.02), 0.02, 0.035, 0.03);  // nose
  const double folds = std::floor(random.between(5, 16)), deep = random.between(0, 0.03), turn = random.between(0, 3);
  const Relief relief(random, random.between(0.2, 0.5), 4, random.between(0.02, 0.1));
  return [=](const Vec3& p) {
    const double below = std::clamp(-p.z() / 1.3, 0.0, 1.0);
    const double robe = deep * below * std::sin(folds * std::atan2(p.y(), p.x()) + turn * p.z());
    return body.at(p) + robe + relief.at(p);
  };
}

Solid face(Random& random) {
  const auto vary = [&](double value) { return value * random.between(0.8, 1.2); };
  const Vec3 skull(vary(0.72), vary(0.56), vary(0.72)), jaw(vary(0.42), vary(0.38), vary(0.5));
  Skeleton parts;
  parts.add({-0.15, 0, -0.4}, {-0.25, 0, -1.15}, vary(0.32), vary(0.4), 0.2);
  const double bridge = vary(0.66), tip = vary(0.86), length = vary(0.3);
  const double low = 0.28 - length;
  parts.add({bridge, 0, 0.28}, {tip, random.between(-0.03, 0.03), low}, vary(0.05), vary(0.09), 0.08);
  for (const double side : {-1.0, 1.0}) {
    parts.add({0.6, 0.08 * side, 0.4}, {0.5, 0.34 * side, vary(0.4)}, vary(0.06), 0.05, 0.08);
    const Vec3 eye(0.6, 0.21 * side, 0.22);
    parts.add(eye + Vec3(0.12, 0, 0), eye + Vec3(0.2, 0, 0), vary(0.11), 0.12, -0.08);
    parts.add(eye, eye + Vec3(0.01, 0, 0), vary(0.1), 0.1, 0.015);
    const Vec3 ear(random.between(-0.15, 0.05), side * 0.55, 0.1);
    parts.add(ear - Vec3(0, 0, 0.12), ear + Vec3(-0.05, 0.06 * side, 0.14), 0.05, vary(0.08), 0.05);
    parts.add(ear + Vec3(0.02, 0.1 * side, -0.05), ear + Vec3(0, 0.12 * side, 0.1), 0.03, 0.05, -0.04);
  }
  parts.add({0.62, -0.12, low - 0.2}, {0.62, 0.12, low - 0.2}, 0.05, 0.05, 0.03);
  parts.add({0.61, -0.1, low - 0.3}, {0.61, 0.1, low - 0.3}, 0.06, 0.06, 0.03);
  const Relief hair(random, random.between(0.1, 0.25), 3, random.between(0.05, 0.25));
  const Relief skin(random, 0.5, 4, 0.02);
  return [=](const Vec3& p) {
    double d = ellipsoid(p, {-0.05, 0, 0.3}, skull);
    d = blend(d, ellipsoid(p, {0.25, 0, -0.15}, jaw), 0.25);
    const double grown = std::clamp(2 * (p.z() - 0.45 - 0.6 * p.x()), 0.0, 1.0);
    d = d + grown * hair.at(p) + skin.at(p);
    const double all = parts.at(p);
    return blend(d, all, 0.06);
  };
}

/// The radius of a turned vessel over its height.
class Profile {
 public:
  explicit Profile(Random& random) : belly_(random.between(0.45, 0.75)) {
    for (std::size_t i = 0; i < heights_.size(); ++i) {
      heights_[i] = random.between(-0.28, 0.28) / (1 + static_cast<double>(i));
      phases_[i] = random.between(0, full_turn);
    }
  }

  double at(double z) const {
    double radius = belly_;
    for (std::size_t i = 0; i < heights_.size(); ++i)
      radius += heights_[i] * std::sin((1.4 + 1.5 * static_cast<double>(i)) * z + phases_[i]);
    return std::max(radius, 0.2);
  }

 private:
  double belly_;
  std::array<double, 4> heights_{};
  std::array<double, 4> phases_{};
};

Solid pot(Random& random) {
  const Profile profile(random);
  const double wall = random.between(0.05, 0.1), tall = random.between(0.6, 1.1);
  const double ribs = std::floor(random.between(4, 24)), deep = random.unit() < 0.5 ? random.between(0.005, 0.03) : 0;
  const double lip = random.unit() < 0.5 ? random.between(0, 0.05) : 0;
  Skeleton handles;
  const std::size_t count = random.below(3);
  for (std::size_t i = 0; i < count; ++i) {
    const double angle = static_cast<double>(i) * full_turn / 2, low = random.between(-0.5, -0.1) * tall;
    const double high = random.between(0.2, 0.7) * tall, out = random.between(0.2, 0.4);
    const Vec3 away(std::cos(angle), std::sin(angle), 0), up(0, 0, 1);
    const double from = profile.at(low), to = profile.at(high), thick = random.between(0.05, 0.08);
    handles.add_chain({from * away + low * up, (from + out) * away + (0.8 * low + 0.2 * high) * up,
                       (to + out) * away + (0.2 * low + 0.8 * high) * up, to * away + high * up},
                      {thick, thick, thick, thick}, 0.05);
  }
  const Relief hand_made(random, 0.9, 3, 0.012);
  return [=](const Vec3& p) {
    const double across = p.head<2>().norm(), angle = std::atan2(p.y(), p.x());
    constexpr double step = 1e-3;
    const double slope = (profile.at(p.z() + step) - profile.at(p.z() - step)) / (2 * step);
    const double steep = std::sqrt(1 + slope * slope);
    const double bulge = lip * std::exp(-std::pow((p.z() - tall) / 0.08, 2));
    const double side = (across - profile.at(p.z()) - bulge - deep * std::sin(ribs * angle)) / steep + hand_made.at(p);
    const double outer = -blend(-side, tall - std::abs(p.z()), 0.05);
    const double inner = -blend(-(side + wall), tall + 1 - std::abs(p.z() - 1 - wall), 0.05);
    const double vessel = carve(outer, inner, 0.6 * wall);
    return blend(vessel, std::max(handles.at(p), -(side + 0.5 * wall)), 0.04);
  };
}

/// A prism over a polygon of random corners.
class Prism {
 public:
  Prism(Random& random, double radius) {
    const std::size_t count = 3 + random.below(6);
    const double turn = random.between(0, full_turn);
    const bool is_star = random.unit() < 0.3;
    for (std::size_t i = 0; i < count; ++i) {
      const double angle = turn + full_turn * static_cast<double>(i) / static_cast<double>(count);
      const double r = radius * (is_star && i % 2 == 1 ? random.between(0.5, 0.7) : random.between(0.85, 1.1));
      corners_.emplace_back(r * std::cos(angle), r * std::sin(angle));
    }
  }

  /// The distance to the polygon, across.
  double at(const Vec2& p) const {
    double square = 1e9;
    bool is_inside = false;
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      const Vec2 &a = corners_[i], &b = corners_[(i + 1) % corners_.size()];
      const Vec2 along = b - a;
      const double t = std::clamp((p - a).dot(along) / along.squaredNorm(), 0.0, 1.0);
      square = std::min(square, (p - a - t * along).squaredNorm());
      if ((a.y() > p.y()) != (b.y() > p.y()) && p.x() < a.x() + (p.y() - a.y()) / along.y() * along.x())
        is_inside = !is_inside;
    }
    return (is_inside ? -1 : 1) * std::sqrt(square);
  }

 private:
  std::vector<Vec2> corners_;
};

struct Bore {
  Vec3 at;
  int axis;
  double radius, half_length;
  bool is_slot;
};

double bored(double d, const Bore& bore, const Vec3& p) {
  if (!bore.is_slot) return std::max(d, -cylinder(p, bore.at, bore.axis, bore.radius, bore.half_length));
  Vec3 half = Vec3::Constant(bore.radius);
  half[bore.axis] = bore.half_length;
  half[(bore.axis + 1) % 3] *= 2.5;
  return std::max(d, -box(p, bore.at, half));
}

Solid part(Random& random) {
  const Prism plate(random, random.between(0.7, 1.1)), boss(random, random.between(0.3, 0.5));
  const double thick = random.between(0.15, 0.5), tall = thick + random.between(0.1, 0.6);
  const double fillet = random.unit() < 0.5 ? random.between(0.05, 0.2) : 0;
  const double edge = random.unit() < 0.4 ? random.between(0.02, 0.06) : 0;  // rounded: worn, or broken
  const Vec3 block(random.between(0.3, 0.7), random.between(0.15, 0.5), random.between(0.2, 0.6));
  const Vec3 beside(random.between(-0.5, 0.5), random.between(-0.5, 0.5), random.between(0, 0.3));
  const bool has_boss = random.unit() < 0.7, is_boss_round = random.unit() < 0.5;
  const double boss_radius = random.between(0.2, 0.4);
  std::vector<Bore> bores;
  const std::size_t count = 1 + random.below(5);
  for (std::size_t i = 0; i < count; ++i) {
    const bool is_through = random.unit() < 0.6;
    bores.push_back({{random.between(-0.55, 0.55), random.between(-0.55, 0.55), random.between(0, 0.4)},
                     static_cast<int>(random.below(3)),
                     random.between(0.06, 0.16),
                     is_through ? 3 : random.between(0.1, 0.3),
                     random.unit() < 0.3});
  }
  const double chamfer = random.unit() < 0.5 ? random.between(0.06, 0.15) : 0;
  const auto join = [fillet](double a, double b) { return fillet > 0 ? blend(a, b, fillet) : std::min(a, b); };
  return [=](const Vec3& p) {
    const double side = plate.at(p.head<2>()), top = std::abs(p.z()) - thick / 2;
    double d = edge > 0 ? -blend(-side, -top, edge) : std::max(side, top);
    if (chamfer > 0) d = std::max(d, (side + top + chamfer) / std::numbers::sqrt2);
    d = join(d, box(p, beside, block / 2));
    if (has_boss) {
      const double across = is_boss_round ? p.head<2>().norm() - boss_radius : boss.at(p.head<2>());
      d = join(d, std::max(across, std::abs(p.z() - tall / 2) - tall / 2));
    }
    for (const Bore& bore : bores) d = bored(d, bore, p);
    return d;
  };
}

struct Fin {
  Vec3 at;
  Eigen::Matrix3d axes;  // rows
  Vec3 half;
};

Solid thorns(Random& random) {
  Skeleton body;
  const Vec3 end = random.between(0.2, 0.7) * random_direction(random);
  const double thick = random.between(0.35, 0.55);
  body.add(-end, end, thick, thick * random.between(0.6, 1), 0.1);
  const std::size_t spikes = 8 + random.below(25);
  for (std::size_t i = 0; i < spikes; ++i) {
    const Vec3 out = random_direction(random), from = random.between(-0.9, 0.9) * end + 0.8 * thick * out;
    const double wide = random.between(0.04, 0.14);
    body.add(from, from + (random.between(0.15, 0.7) + 0.2 * thick) * out, wide, random.between(0.015, 0.03),
             random.between(0.02, 0.08));
  }
  std::vector<Fin> fins;
  const std::size_t count = 1 + random.below(5);
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 out = random_direction(random);
    const Vec3 across = out.cross(random_direction(random)).normalized();
    Eigen::Matrix3d axes;
    axes.row(0) = out, axes.row(1) = across, axes.row(2) = out.cross(across);
    const Vec3 half(random.between(0.2, 0.45), random.between(0.1, 0.35), random.between(0.012, 0.03));
    fins.push_back({random.between(-0.8, 0.8) * end + (0.8 * thick + 0.5 * half.x()) * out, axes, half});
  }
  const Relief relief(random, 0.5, 3, random.between(0.01, 0.06));
  return [=](const Vec3& p) {
    double d = body.at(p) + relief.at(p);
    for (const Fin& fin : fins) {
      const Vec3 q = fin.axes * (p - fin.at);
      d = blend(d, box(q, Vec3::Zero(), fin.half) - 0.01, 0.04);
    }
    return d;
  };
}

Solid bones(Random& random) {
  Skeleton body;
  std::vector<Vec3> knots;
  const std::size_t count = 4 + random.below(4);
  for (std::size_t i = 0; i < count; ++i) {
    const double angle = full_turn * (static_cast<double>(i) + random.between(-0.3, 0.3)) / static_cast<double>(count);
    knots.emplace_back(random.between(0.5, 0.9) * std::cos(angle), random.between(0.5, 0.9) * std::sin(angle),
                       random.between(-0.6, 0.6));
  }
  const auto bone = [&](const Vec3& a, const Vec3& b, double bow) {
    const double thin = random.between(0.07, 0.13), knob = thin * random.between(1.2, 2);
    const Vec3 aside = (b - a).cross(random_direction(random)).normalized();
    const auto place = [&](double t) { return Vec3(a + t * (b - a) + bow * std::sin(full_turn / 2 * t) * aside); };
    body.add_chain({a, place(0.12), place(0.35), place(0.65), place(0.88), b}, {knob, thin, thin, thin, thin, knob},
                   0.05);
  };
  for (std::size_t i = 0; i < count; ++i) bone(knots[i], knots[(i + 1) % count], random.between(0, 0.3));
  const std::size_t arches = 1 + random.below(3);
  for (std::size_t i = 0; i < arches; ++i) {
    const Index a = random.below(static_cast<Index>(count));
    const auto half = static_cast<Index>(count / 2);
    bone(knots[a], knots[(a + half) % count], random.between(0.1, 0.5));
  }
  const Vec3 plate = knots[0];
  const Vec3 radii(random.between(0.3, 0.5), random.between(0.2, 0.4), random.between(0.12, 0.3));
  const Relief relief(random, random.between(0.3, 0.6), 4, random.between(0.02, 0.1));
  return [=](const Vec3& p) { return blend(body.at(p), ellipsoid(p, plate, radii), 0.1) + relief.at(p); };
}

}  // namespace

const char* name_of(SolidKind kind) {
  constexpr std::array names = {"blob", "figure", "face", "pot", "part", "thorns", "bones"};
  return names[static_cast<std::size_t>(kind)];
}

std::function<double(const Vec3&)> random_solid(SolidKind kind, std::uint64_t seed) {
  Random random(seed * 1009 + static_cast<std::uint64_t>(kind));
  switch (kind) {
    case SolidKind::Blob: return blob(random);
    case SolidKind::Figure: return figure(random);
    case SolidKind::Face: return face(random);
    case SolidKind::Pot: return pot(random);
    case SolidKind::Part: return part(random);
    case SolidKind::Thorns: return thorns(random);
    case SolidKind::Bones: return bones(random);
  }
  return {};
}

}  // namespace croquis::test

// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/attribute_surface/loops.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include <Eigen/Geometry>

#include "support/attribute_surface/network_builder.h"
#include "support/random.h"

namespace croquis::test {
namespace {

constexpr double pi = std::numbers::pi;

Vec3 in_a_box(Random& random, double half) {
  return {random.between(-half, half), random.between(-half, half), random.between(-half, half)};
}

Eigen::Quaterniond any_rotation(Random& random) {
  const Vec3 axis = in_a_box(random, 1);
  return Eigen::Quaterniond(Eigen::AngleAxisd(random.between(0, pi), axis.normalized()));
}

/// Control points between two places, as far off the straight line as `swing` times its length.
std::vector<Vec3> wild_inner(Random& random, const Vec3& from, const Vec3& to, double swing) {
  const std::uint32_t degree = 1 + random.below(6);
  std::vector<Vec3> inner;
  for (std::uint32_t k = 1; k < degree; ++k) {
    const Vec3 straight = from + (to - from) * k / degree;
    inner.emplace_back(straight + in_a_box(random, swing * (to - from).norm()));
  }
  return inner;
}

/// One face along curves made between corners.
template <typename Inner>
AttributeNetwork loop_of(const std::string& name, const std::vector<Vec3>& corners, Inner&& inner) {
  NetworkBuilder builder(name);
  std::vector<AttributeSide> loop;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec3 &from = corners[i], &to = corners[(i + 1) % corners.size()];
    loop.push_back({builder.curve(builder.node(from), builder.node(to), inner(from, to)), false});
  }
  builder.face(std::move(loop));
  return std::move(builder.network);
}

AttributeNetwork polygon_of(const std::string& name, const std::vector<Vec3>& corners) {
  return loop_of(name, corners, [](const Vec3&, const Vec3&) { return std::vector<Vec3>(); });
}

std::string named(const std::string& kind, std::size_t sides, std::uint64_t seed) {
  return kind + " of " + std::to_string(sides) + ", seed " + std::to_string(seed);
}

/// Two curves both ways between the same places must differ.
std::vector<Vec3> bulge(Random& random, const Vec3& from, const Vec3& to) {
  const Vec3 right(to.y() - from.y(), from.x() - to.x(), random.between(-0.5, 0.5));
  return {from + 0.5 * right + 0.2 * (to - from), to + 0.4 * right};
}

/// Cumulated random angles, spread over a part of the turn.
std::vector<double> spread_angles(Random& random, std::size_t count, double whole, std::size_t parts) {
  std::vector<double> angles{0};
  for (std::size_t i = 1; i <= parts; ++i) angles.push_back(angles.back() + random.between(0.5, 1.5));
  const double factor = whole / angles.back();
  angles.resize(count);
  for (double& angle : angles) angle *= factor;
  return angles;
}

}  // namespace

AttributeNetwork random_loop(std::size_t sides, std::uint64_t seed) {
  Random random(1000 * seed + sides);
  std::vector<Vec3> corners;
  for (std::size_t i = 0; i < sides; ++i) {
    const double angle = 2 * pi * (static_cast<double>(i) + random.between(-0.3, 0.3)) / static_cast<double>(sides);
    const double radius = random.between(0.6, 1.5);
    corners.emplace_back(radius * std::cos(angle), radius * std::sin(angle), random.between(-0.5, 0.5));
  }
  return loop_of(named("random loop", sides, seed), corners, [&](const Vec3& from, const Vec3& to) {
    return sides == 2 ? bulge(random, from, to) : wild_inner(random, from, to, 0.25);
  });
}

AttributeNetwork flat_loop(std::size_t sides, std::uint64_t seed) {
  AttributeNetwork network = random_loop(sides, seed);
  network.name = named("flat loop", sides, seed);
  Random random(seed);
  const Eigen::Quaterniond turn = any_rotation(random);
  const Vec3 move = in_a_box(random, 2);
  const auto flatten = [&](Vec3& p) { p = turn * Vec3(p.x(), p.y(), 0) + move; };
  for (AttributeNode& node : network.nodes) flatten(node.point);
  for (AttributeCurve& curve : network.curves) std::ranges::for_each(curve.control, flatten);
  return network;
}

AttributeNetwork cyclic_polygon(std::size_t sides, std::uint64_t seed) {
  Random random(2000 * seed + sides);
  const bool outside = seed % 3 == 2;
  const std::vector<double> angles =
      spread_angles(random, sides, outside ? random.between(2.4, 3) : 2 * pi, outside ? sides - 1 : sides);
  const Eigen::Quaterniond turn = any_rotation(random);
  const Vec3 move = in_a_box(random, 3);
  const double radius = random.between(0.5, 3);
  std::vector<Vec3> corners;
  for (const double angle : angles)
    corners.emplace_back(move + radius * (turn * Vec3(std::cos(angle), std::sin(angle), 0)));
  return polygon_of(named("cyclic polygon", sides, seed), corners);
}

AttributeNetwork convex_polygon(std::size_t sides, std::uint64_t seed) {
  AttributeNetwork network = cyclic_polygon(sides, 3 * seed);
  network.name = named("convex polygon", sides, seed);
  Random random(seed);
  const Vec3 axis = (network.nodes[1].point - network.nodes[0].point).normalized();
  const double stretch = random.between(1.5, 3);
  for (AttributeNode& node : network.nodes) node.point += (stretch - 1) * axis.dot(node.point) * axis;
  return network;
}

AttributeNetwork leaf_loop() {
  NetworkBuilder builder("leaf");
  const Vec3 stalk(0, 0, 0), tip(2, 0, 0.3);
  const Index right = builder.curve({stalk, {0.6, -0.7, 0.3}, {1.4, -0.5, 0.5}, tip});
  const Index left = builder.curve({tip, {1.3, 0.6, 0.55}, {0.5, 0.7, 0.25}, stalk});
  builder.face({{right, false}, {left, false}});
  return std::move(builder.network);
}

AttributeNetwork wavy_star(std::size_t sides) {
  std::vector<Vec3> corners;
  for (std::size_t i = 0; i < sides; ++i) {
    const double angle = 2 * pi * static_cast<double>(i) / static_cast<double>(sides);
    const double radius = i % 2 == 0 ? 1.3 : 0.9;
    corners.emplace_back(radius * std::cos(angle), radius * std::sin(angle), i % 2 == 0 ? 0.1 : -0.1);
  }
  return loop_of("wavy star of " + std::to_string(sides), corners, [](const Vec3& from, const Vec3& to) {
    std::vector<Vec3> inner;
    for (int k = 1; k < 5; ++k)
      inner.emplace_back(from + 0.2 * k * (to - from) + Vec3(0, 0, k % 2 == 0 ? 0.15 : -0.15));
    return inner;
  });
}

AttributeNetwork l_loop() {
  return polygon_of("L", {{0, 0, 0}, {3, 0, 0}, {3, 0.4, 0}, {0.4, 0.4, 0}, {0.4, 3, 0}, {0, 3, 0}});
}

AttributeNetwork resized(const AttributeNetwork& network, double factor, const Vec3& move) {
  AttributeNetwork result = network;
  const auto map = [&](Vec3& p) { p = factor * p + move; };
  for (AttributeNode& node : result.nodes) map(node.point);
  for (AttributeCurve& curve : result.curves) std::ranges::for_each(curve.control, map);
  for (AttributeFace& face : result.faces) {
    for (InnerCurve& inner : face.inner)
      inner.radius = inner.radius ? std::optional(*inner.radius * factor) : inner.radius;
  }
  for (PointAttribute& point : result.points) {
    map(point.point);
    if (point.radius) *point.radius *= factor;
  }
  if (result.tolerance) *result.tolerance *= factor;
  return result;
}

std::vector<AttributeNetwork> strained_loops() {
  std::vector<AttributeNetwork> result{resized(random_loop(4, 71), 1e-3), resized(random_loop(5, 72), 1e4),
                                       resized(random_loop(6, 73), 1, {1e5, -2e5, 5e4})};
  result[0].name += ", in metres";
  result[1].name += ", in tenths of a millimetre";
  result[2].name += ", far away";

  const auto repeated = [](const Vec3& from, const Vec3& to) {
    return std::vector<Vec3>{from, Vec3(from + Vec3(0, 0, 0.4)), Vec3(to + Vec3(0, 0, 0.4)), to};
  };
  result.push_back(loop_of("ends repeated", {{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0.2}}, repeated));
  result.push_back(loop_of("middles repeated", {{0, 0, 0}, {2, 0, 0}, {1, 1.5, 0}}, [](const Vec3& a, const Vec3& b) {
    return std::vector<Vec3>(3, 0.5 * (a + b) + Vec3(0, 0, 0.3));
  }));
  result.push_back(polygon_of("one short side", {{0, 0, 0}, {2, 0, 0}, {2, 1e-5, 0}, {1, 1.5, 0.3}}));
  result.back().tolerance = 1e-7;
  result.push_back(loop_of("one long side", {{0, 0, 0}, {1, 0, 0}, {0.5, 0.8, 0}}, [](const Vec3& a, const Vec3& b) {
    if (a.y() > 0 || b.y() > 0) return std::vector<Vec3>();
    return std::vector<Vec3>{{-3, -6, 2}, {4, -6, 2}};
  }));
  result.push_back(loop_of("there and back", {{0, 0, 0}, {2, 0, 0}, {1, 1.5, 0}}, [](const Vec3& a, const Vec3& b) {
    return std::vector<Vec3>{a + 0.9 * (b - a), a + 0.1 * (b - a) + Vec3(0, 0, 0.1)};
  }));
  return result;
}

std::vector<AttributeNetwork> all_loops() {
  std::vector<AttributeNetwork> result = strained_loops();
  for (std::size_t sides = 2; sides <= 12; ++sides) {
    for (std::uint64_t seed = 1; seed <= 3; ++seed) result.push_back(random_loop(sides, seed));
  }
  result.push_back(leaf_loop());
  result.push_back(wavy_star(6));
  result.push_back(wavy_star(10));
  return result;
}

}  // namespace croquis::test

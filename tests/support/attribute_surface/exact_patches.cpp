// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/attribute_surface/exact_patches.h"

#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "support/attribute_surface/network_builder.h"

namespace croquis::test {
namespace {

constexpr double ring_radius = 2;
constexpr double tube_radius = 0.8;

/// A height with its derivatives.
struct Height {
  double z = 0;
  Vec2 slope = Vec2::Zero();
  Eigen::Matrix2d bend = Eigen::Matrix2d::Zero();
};

Height saddle_at(const Vec2& p) {
  Height height{p.x() * p.y(), {p.y(), p.x()}, Eigen::Matrix2d::Zero()};
  height.bend(0, 1) = height.bend(1, 0) = 1;
  return height;
}

/// Falls towards the front, is round across, and has a crown along its middle.
Height hood_at(const Vec2& p) {
  const double x = p.x(), y = p.y(), crown = 0.08 * std::exp(-4 * y * y);
  Height height;
  height.z = 0.4 - 0.1 * x * x - 0.05 * x * x * x - 0.2 * y * y + crown;
  height.slope = {-0.2 * x - 0.15 * x * x, -0.4 * y - 8 * y * crown};
  height.bend(0, 0) = -0.2 - 0.3 * x;
  height.bend(1, 1) = -0.4 + (64 * y * y - 8) * crown;
  return height;
}

Vec3 on(const Height& height, const Vec2& p) { return {p.x(), p.y(), height.z}; }

/// Newton's method for the least distance, begun below the point.
Vec3 nearest_on(Height (*surface)(const Vec2&), const Vec3& point) {
  Vec2 p = point.head<2>();
  for (int step = 0; step < 50; ++step) {
    const Height height = surface(p);
    const double above = height.z - point.z();
    const Vec2 gradient = p - point.head<2>() + above * height.slope;
    const Eigen::Matrix2d hessian =
        Eigen::Matrix2d::Identity() + height.slope * height.slope.transpose() + above * height.bend;
    const Vec2 move = hessian.inverse() * gradient;
    p -= move;
    if (move.norm() < 1e-15) break;
  }
  return on(surface(p), p);
}

/// A place of a plane of parameters becomes one of the surface; sides are straight in the parameters.
using Map = std::function<Vec3(const Vec2&)>;

ExactPatch cut(const std::string& name, const std::vector<Vec2>& corners, const Map& map, NearestOnSurface nearest) {
  NetworkBuilder builder(name);
  std::vector<AttributeSide> loop;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec2 &from = corners[i], &to = corners[(i + 1) % corners.size()];
    const auto side = [&](double t) { return map((1 - t) * from + t * to); };
    loop.push_back({builder.curve(bezier_near(side)), false});
  }
  builder.network.faces[builder.face(std::move(loop))].id = name;
  return {std::move(builder.network), std::move(nearest)};
}

Vec3 sphere_place(double longitude, double latitude) {
  const double degree = std::numbers::pi / 180;
  return {std::cos(latitude * degree) * std::cos(longitude * degree),
          std::cos(latitude * degree) * std::sin(longitude * degree), std::sin(latitude * degree)};
}

/// Sides are great circles.
ExactPatch cut_from_sphere(const std::string& name, const std::vector<Vec3>& corners) {
  NetworkBuilder builder(name);
  std::vector<AttributeSide> loop;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec3 &from = corners[i], &to = corners[(i + 1) % corners.size()];
    loop.push_back({builder.curve(bezier_near([&](double t) { return great_circle(from, to, t); })), false});
  }
  builder.network.faces[builder.face(std::move(loop))].id = name;
  return {std::move(builder.network), nearest_on_sphere};
}

ExactPatch cut_from_torus(const std::string& name, const std::vector<Vec2>& corners) {
  return cut(
      name, corners, [](const Vec2& p) { return torus_place(p.x(), p.y()); }, nearest_on_torus);
}

ExactPatch cut_from_saddle(const std::string& name, const std::vector<Vec2>& corners) {
  return cut(
      name, corners, [](const Vec2& p) { return on(saddle_at(p), p); }, nearest_on_saddle);
}

ExactPatch cut_from_hood(const std::string& name, const std::vector<Vec2>& corners) {
  return cut(
      name, corners, [](const Vec2& p) { return on(hood_at(p), p); }, nearest_on_hood);
}

}  // namespace

Vec3 nearest_on_sphere(const Vec3& point) { return point.normalized(); }

Vec3 nearest_on_torus(const Vec3& point) {
  const Vec3 ring = ring_radius * Vec3(point.x(), point.y(), 0).normalized();
  return ring + tube_radius * (point - ring).normalized();
}

Vec3 nearest_on_saddle(const Vec3& point) { return nearest_on(saddle_at, point); }

Vec3 nearest_on_hood(const Vec3& point) { return nearest_on(hood_at, point); }

Vec3 torus_place(double around, double tube) {
  const double distance = ring_radius + tube_radius * std::cos(tube);
  return {distance * std::cos(around), distance * std::sin(around), tube_radius * std::sin(tube)};
}

Vec3 great_circle(const Vec3& from, const Vec3& to, double t) {
  const double angle = angle_between(from, to);
  return (std::sin((1 - t) * angle) * from + std::sin(t * angle) * to) / std::sin(angle);
}

std::vector<ExactPatch> exact_patches() {
  const std::vector<Vec3> pentagon{sphere_place(0, 0), sphere_place(50, -5), sphere_place(65, 35), sphere_place(25, 60),
                                   sphere_place(-12, 30)};
  return {cut_from_sphere("octant", {Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()}),
          cut_from_sphere("wedge", {sphere_place(0, 0), sphere_place(20, 0), Vec3::UnitZ()}),
          cut_from_sphere("skinny obtuse", {sphere_place(0, 0), sphere_place(80, 0), sphere_place(25, 12)}),
          cut_from_torus("torus triangle", {{0, 0.2}, {1.1, 0.1}, {0.9, 0.9}}),
          cut_from_saddle("saddle triangle", {{-0.9, -0.5}, {0.9, -0.1}, {0.5, 0.25}}),
          cut_from_hood("hood triangle", {{-0.9, -0.3}, {0.9, -0.2}, {-0.4, 0.25}}),
          cut_from_torus("torus quad", {{0, 0}, {1.2, 0}, {1.2, 1}, {0, 1}}),
          cut_from_hood("hood trapezoid", {{-0.8, -0.7}, {0.8, -0.5}, {0.8, 0.5}, {-0.8, 0.7}}),
          cut_from_sphere("sphere pentagon", pentagon),
          cut_from_hood("hood pentagon", {{-0.9, -0.4}, {0.2, -0.6}, {0.9, -0.1}, {0.5, 0.5}, {-0.7, 0.4}}),
          cut_from_saddle("saddle quad", {{0, 0}, {1, 0.1}, {1.1, 1}, {-0.1, 0.9}})};
}

}  // namespace croquis::test

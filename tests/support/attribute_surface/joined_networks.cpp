// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/attribute_surface/joined_networks.h"

#include <algorithm>
#include <numbers>
#include <utility>

#include "croquis/io/attribute_network_file.h"
#include "croquis/io/file.h"
#include "support/attribute_surface/exact_patches.h"
#include "support/attribute_surface/network_builder.h"

namespace croquis::test {
namespace {

using Corners = std::vector<Vec3>;

/// A smooth great circle between two unit vectors, once.
void add_great_circle(NetworkBuilder& builder, const Vec3& from, const Vec3& to) {
  const Index start = builder.node(from), end = builder.node(to);
  for (const AttributeCurve& curve : builder.network.curves) {
    if (std::minmax(curve.from, curve.to) == std::minmax(start, end)) return;
  }
  builder.curve(bezier_near([&](double t) { return great_circle(from, to, t); }), CurveJoin::Smooth);
}

AttributeNetwork ball_of(const std::string& name, const std::vector<Corners>& faces) {
  NetworkBuilder builder(name);
  for (const Corners& corners : faces) {
    std::vector<Index> nodes;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      add_great_circle(builder, corners[i], corners[(i + 1) % corners.size()]);
      nodes.push_back(builder.node(corners[i]));
    }
    builder.face(nodes);
  }
  return std::move(builder.network);
}

}  // namespace

AttributeNetwork sphere_of_octants() {
  std::vector<Corners> faces;
  for (int octant = 0; octant < 8; ++octant) {
    const double x = octant & 1 ? -1 : 1, y = octant & 2 ? -1 : 1, z = octant & 4 ? -1 : 1;
    Corners corners{{x, 0, 0}, {0, y, 0}, {0, 0, z}};
    if (x * y * z < 0) std::swap(corners[1], corners[2]);
    faces.push_back(corners);
  }
  return ball_of("sphere of octants", faces);
}

AttributeNetwork cube_sphere() {
  std::vector<Corners> faces;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double side : {-1.0, 1.0}) {
      Corners corners;
      for (const auto& [a, b] : {std::pair(-1.0, -1.0), {1.0, -1.0}, {1.0, 1.0}, {-1.0, 1.0}}) {
        Vec3 corner = Vec3::Zero();
        corner[axis] = side;
        corner[(axis + 1) % 3] = a * side;
        corner[(axis + 2) % 3] = b;
        corners.emplace_back(corner.normalized());
      }
      faces.push_back(corners);
    }
  }
  return ball_of("cube sphere", faces);
}

AttributeNetwork torus_of_quads(std::size_t around, std::size_t tube) {
  NetworkBuilder builder("torus of " + std::to_string(around) + " x " + std::to_string(tube));
  const auto angle = [](std::size_t i, std::size_t count) {
    return 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(count);
  };
  // The curves of node (i, j) go on around the axis and around the tube.
  for (std::size_t i = 0; i < around; ++i) {
    for (std::size_t j = 0; j < tube; ++j) {
      const double u = angle(i, around), v = angle(j, tube), du = angle(1, around), dv = angle(1, tube);
      builder.curve(bezier_near([&](double t) { return torus_place(u + t * du, v); }), CurveJoin::Smooth);
      builder.curve(bezier_near([&](double t) { return torus_place(u, v + t * dv); }), CurveJoin::Smooth);
    }
  }
  const auto curve_at = [&](std::size_t i, std::size_t j, std::size_t which) {
    return static_cast<Index>(2 * (i % around * tube + j % tube) + which);
  };
  for (std::size_t i = 0; i < around; ++i) {
    for (std::size_t j = 0; j < tube; ++j) {
      builder.face({{curve_at(i, j, 0), false},
                    {curve_at(i + 1, j, 1), false},
                    {curve_at(i, j + 1, 0), true},
                    {curve_at(i, j, 1), true}});
    }
  }
  return std::move(builder.network);
}

AttributeNetwork boat_hull() {
  NetworkBuilder builder("boat hull");
  const Vec3 stem(4, 0, 1), keel(0, 0, 0), left(0, 1, 1), right(0, -1, 1);
  const Index along = builder.curve({keel, {1.5, 0, -0.3}, {3.6, 0, -0.3}, stem}, CurveJoin::Smooth);
  const Index rail_left = builder.curve({stem, {3.2, 0.15, 1}, {1.5, 1.3, 0.9}, left});
  const Index rail_right = builder.curve({stem, {3.2, -0.15, 1}, {1.5, -1.3, 0.9}, right});
  const Index stern_left = builder.curve({left, {0, 1, 0.5}, {0, 0.6, 0}, keel});
  const Index stern_right = builder.curve({right, {0, -1, 0.5}, {0, -0.6, 0}, keel});
  const Index top = builder.curve({left, {-0.1, 0.4, 1.05}, {-0.1, -0.4, 1.05}, right});
  builder.network.faces[builder.face({{along, false}, {rail_left, false}, {stern_left, false}})].id = "left";
  builder.network.faces[builder.face({{stern_right, true}, {rail_right, true}, {along, true}})].id = "right";
  builder.network.faces[builder.face({{stern_left, true}, {top, false}, {stern_right, false}})].id = "transom";
  return std::move(builder.network);
}

AttributeNetwork example_network(const std::string& name) {
  const std::string path = CROQUIS_SOURCE_DIR "/examples/data/surface/" + name + ".json";
  return read_attribute_network(read_file(path), path).network;
}

std::vector<AttributeNetwork> joined_networks() {
  std::vector<AttributeNetwork> result{sphere_of_octants(), cube_sphere(), torus_of_quads(6, 4), boat_hull()};
  for (const char* name : {"car_intact", "car_crashed", "pocket5"}) result.push_back(example_network(name));
  return result;
}

}  // namespace croquis::test

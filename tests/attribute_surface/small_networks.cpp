// SPDX-License-Identifier: GPL-3.0-or-later
#include "attribute_surface/small_networks.h"

#include <cmath>
#include <numbers>
#include <string>

namespace croquis::test {
namespace {

Index add_node(AttributeNetwork& network, const Vec3& place) {
  network.nodes.push_back({"n" + std::to_string(network.nodes.size()), place});
  return static_cast<Index>(network.nodes.size() - 1);
}

Index add_curve(AttributeNetwork& network, Index from, Index to, std::vector<Vec3> between = {}) {
  AttributeCurve curve{"c" + std::to_string(network.curves.size()), from, to, {}, CurveJoin::Crease};
  if (!between.empty()) {
    curve.control = {network.nodes[from].point};
    curve.control.insert(curve.control.end(), between.begin(), between.end());
    curve.control.push_back(network.nodes[to].point);
  }
  network.curves.push_back(std::move(curve));
  return static_cast<Index>(network.curves.size() - 1);
}

void add_face(AttributeNetwork& network, const std::string& id, std::vector<AttributeSide> loop) {
  AttributeFace face;
  face.id = id;
  face.loop = std::move(loop);
  network.faces.push_back(std::move(face));
}

}  // namespace

AttributeNetwork straight_loop(const std::vector<Vec3>& corners) {
  AttributeNetwork network;
  std::vector<AttributeSide> loop;
  for (const Vec3& corner : corners) add_node(network, corner);
  for (Index i = 0; i < corners.size(); ++i)
    loop.push_back({add_curve(network, i, (i + 1) % static_cast<Index>(corners.size())), false});
  add_face(network, "f", std::move(loop));
  return network;
}

AttributeNetwork hill(std::size_t sides, double height) {
  AttributeNetwork network;
  const auto count = static_cast<Index>(sides);
  const auto corner = [&](Index i) {
    const double angle = 2 * std::numbers::pi * i / static_cast<double>(count);
    return Vec3(std::cos(angle), std::sin(angle), i % 2 == 0 ? 0 : 0.2 * height);
  };
  for (Index i = 0; i < count; ++i) add_node(network, corner(i));
  std::vector<AttributeSide> loop;
  for (Index i = 0; i < count; ++i) {
    const Index next = (i + 1) % count;
    const Vec3 from = corner(i), to = corner(next), up(0, 0, height);
    loop.push_back({add_curve(network, i, next, {from + (to - from) / 3 + up, to + (from - to) / 3 + up}), false});
  }
  add_face(network, "f", std::move(loop));
  return network;
}

AttributeNetwork small_leaf() {
  AttributeNetwork network;
  const Index a = add_node(network, {0, 0, 0}), b = add_node(network, {3, 0, 0});
  const Index low = add_curve(network, a, b, {{1, -1, 0.3}, {2, -0.8, 0.2}});
  const Index high = add_curve(network, a, b, {{0.8, 1.2, 0.4}, {2.2, 1, 0.1}});
  add_face(network, "f", {{low, false}, {high, true}});
  return network;
}

AttributeNetwork leaf_between_triangles() {
  AttributeNetwork network = small_leaf();
  const Index left = add_node(network, {1.5, -3, 0}), right = add_node(network, {1.5, 3, 0.5});
  add_face(network, "left", {{add_curve(network, 0, left), false}, {add_curve(network, left, 1), false}, {0, true}});
  add_face(network, "right",
           {{1, false}, {add_curve(network, 1, right), false}, {add_curve(network, right, 0), false}});
  return network;
}

}  // namespace croquis::test

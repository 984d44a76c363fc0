// SPDX-License-Identifier: GPL-3.0-or-later
#include "attribute_surface/network_samples.h"

#include <cmath>

#include "croquis/io/attribute_network_file.h"

namespace croquis::test {
namespace {

double height(double x, double y) { return 0.3 * std::sin(x) * std::cos(0.7 * y); }

std::string grid_name(const char* prefix, int i, int j) { return prefix + std::to_string(i) + "_" + std::to_string(j); }

AttributeCurve arched(const AttributeNetwork& network, std::string id, Index from, Index to) {
  const Vec3 start = network.nodes[from].point;
  const Vec3 end = network.nodes[to].point;
  const Vec3 lift(0.02, -0.03, 0.1);
  return {std::move(id),
          from,
          to,
          {start, start + (end - start) / 3 + lift, start + (end - start) * 2 / 3 + lift, end},
          CurveJoin::Smooth};
}

Index index_of(const std::string& id, const std::vector<AttributeCurve>& curves) {
  for (Index i = 0; i < curves.size(); ++i) {
    if (curves[i].id == id) return i;
  }
  return no_index;
}

}  // namespace

AttributeNetwork bent_sheet(int columns, int rows) {
  AttributeNetwork network;
  const auto node = [&](int i, int j) { return static_cast<Index>(j * (columns + 1) + i); };
  for (int j = 0; j <= rows; ++j) {
    for (int i = 0; i <= columns; ++i)
      network.nodes.push_back({grid_name("n", i, j), {double(i), double(j), height(i, j)}});
  }
  for (int j = 0; j <= rows; ++j) {
    for (int i = 0; i <= columns; ++i) {
      if (i < columns) network.curves.push_back(arched(network, grid_name("u", i, j), node(i, j), node(i + 1, j)));
      if (j < rows) network.curves.push_back(arched(network, grid_name("v", i, j), node(i, j), node(i, j + 1)));
    }
  }
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      AttributeFace face;
      face.id = grid_name("f", i, j);
      face.loop = {{index_of(grid_name("u", i, j), network.curves), false},
                   {index_of(grid_name("v", i + 1, j), network.curves), false},
                   {index_of(grid_name("u", i, j + 1), network.curves), true},
                   {index_of(grid_name("v", i, j), network.curves), true}};
      network.faces.push_back(face);
    }
  }
  return network;
}

AttributeNetwork rich_sheet(int columns, int rows) {
  AttributeNetwork network = bent_sheet(columns, rows);
  for (Index face = 0; face < network.faces.size(); ++face) {
    const Vec3 corner = network.nodes[network.curves[network.faces[face].loop[0].curve].from].point;
    const std::string number = std::to_string(face + 1);
    network.points.push_back(
        {"p" + number, face, corner + Vec3(0.5, 0.5, 0.4), FanPlace{face % 4, 0.2, 0.1}, {}, {}, {}});
  }
  network.curves.push_back({"inside", no_index, no_index, {{0.3, 0.3, 0.2}, {0.5, 0.4, 0.3}, {0.7, 0.3, 0.2}}, {}});
  network.faces[0].inner.push_back({static_cast<Index>(network.curves.size() - 1), InnerProfile::Smooth, 0.2});
  network.slopes.push_back({0, no_index, {0.25, 0.75}, {{0, 0.1, 1}, {0, -0.1, 1}}, 1});
  network.slopes.push_back({0, 0, {0.5}, {{0, 0.4, 1}}, 1.5});
  return network;
}

AttributeNetwork wire_box() {
  AttributeNetwork network;
  for (Index i = 0; i < 8; ++i) {
    network.nodes.push_back({"n" + std::to_string(i), {double(i & 1U), double(i >> 1U & 1U), double(i >> 2U)}});
  }
  for (int axis = 0; axis < 3; ++axis) {
    for (Index i = 0; i < 8; ++i) {
      const Index bit = Index{1} << axis;
      if ((i & bit) != 0) continue;
      const std::string others =
          std::to_string(i >> ((axis + 1) % 3) & 1U) + std::to_string(i >> ((axis + 2) % 3) & 1U);
      network.curves.push_back({std::string(1, "xyz"[axis]) + others, i, i | bit, {}, CurveJoin::Crease});
    }
  }
  return network;
}

std::string text_of(const AttributeNetwork& network) { return write_attribute_network(network); }

}  // namespace croquis::test

// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/surface/skeleton_curves.h"

#include <variant>
#include <vector>

namespace croquis::silhouette {
namespace {

std::vector<double>& radius_channel(PolyMesh& curves) {
  AttributeChannel* channel = curves.channel("radius", Domain::Vertex);
  if (channel == nullptr) {
    curves.channels.push_back({"radius", Domain::Vertex, 1, std::vector<double>(curves.vertex_count(), 0.0), {}});
    channel = &curves.channels.back();
  }
  return std::get<std::vector<double>>(channel->data);
}

}  // namespace

void append_skeleton(const Skeleton& skeleton, PolyMesh& curves) {
  const auto first = static_cast<Index>(curves.vertex_count());
  std::vector<double>& radius = radius_channel(curves);
  for (const SkeletonNode& node : skeleton.nodes) {
    curves.positions.emplace_back(node.position.x(), node.position.y(), node.z);
    radius.push_back(node.radius);
  }
  std::vector<std::vector<Index>> around(skeleton.nodes.size());  // per node its edges
  for (Index e = 0; e < skeleton.edges.size(); ++e) {
    for (const Index end : skeleton.edges[e]) around[end].push_back(e);
  }
  std::vector<std::uint8_t> used(skeleton.edges.size(), 0);
  const auto add_branch = [&](Index node, Index edge) {
    std::vector<Index> line{first + node};
    while (used[edge] == 0) {
      used[edge] = 1;
      const auto& [a, b] = skeleton.edges[edge];
      node = node == a ? b : a;
      line.push_back(first + node);
      if (around[node].size() != 2) break;
      edge = around[node][0] == edge ? around[node][1] : around[node][0];
    }
    curves.add_line(line);
  };
  // First those that start at an end or a junction, then the loops.
  for (const bool loops : {false, true}) {
    for (Index node = 0; node < around.size(); ++node) {
      if (!loops && around[node].size() == 2) continue;
      for (const Index edge : around[node]) {
        if (used[edge] == 0) add_branch(node, edge);
      }
    }
  }
}

}  // namespace croquis::silhouette

// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/silhouette/surface/skeleton_curves.h"

#include <variant>
#include <vector>

namespace croquis::silhouette {
namespace {

struct HalfEdge {
  Index to = 0;
  Index edge = 0;
};

class BranchTracer {
 public:
  explicit BranchTracer(const Skeleton& skeleton) : around_(skeleton.nodes.size()), used_(skeleton.edges.size(), 0) {
    for (Index e = 0; e < skeleton.edges.size(); ++e) {
      const auto& [a, b] = skeleton.edges[e];
      around_[a].push_back({b, e});
      around_[b].push_back({a, e});
    }
  }

  /// Calls visit(nodes) for every branch: first those that start at an end or a junction, then the loops.
  template <typename Visit>
  void trace(Visit visit) {
    for (const bool loops : {false, true}) {
      for (Index node = 0; node < around_.size(); ++node) {
        if (!loops && around_[node].size() == 2) continue;
        for (const HalfEdge& start : around_[node]) {
          if (!used_[start.edge]) visit(follow(node, start));
        }
      }
    }
  }

 private:
  std::vector<Index> follow(Index from, HalfEdge step) {
    std::vector<Index> nodes{from};
    while (!used_[step.edge]) {
      used_[step.edge] = 1;
      nodes.push_back(step.to);
      const std::vector<HalfEdge>& around = around_[step.to];
      if (around.size() != 2) break;
      step = around[0].edge == step.edge ? around[1] : around[0];
    }
    return nodes;
  }

  std::vector<std::vector<HalfEdge>> around_;
  std::vector<std::uint8_t> used_;
};

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
  BranchTracer(skeleton).trace([&](std::vector<Index> nodes) {
    for (Index& node : nodes) node += first;
    curves.add_line(nodes);
  });
}

}  // namespace croquis::silhouette

// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/evaluation_order.h"

#include <cstddef>
#include <map>
#include <set>

namespace croquis {
namespace {

/// The nodes that the target depends on, with the links among them.
struct Graph {
  struct Vertex {
    const Node* node = nullptr;
    std::set<NodeId> inputs;
    std::set<NodeId> users;
  };
  std::map<NodeId, Vertex> vertices;
};

Graph gather(const Document& document, NodeId target) {
  std::map<NodeId, const Node*> by_id;
  for (const auto& node : document.nodes()) by_id.emplace(node->id, node.get());
  Graph graph;
  std::vector<NodeId> pending;
  const auto reach = [&](NodeId id) {
    const auto found = by_id.find(id);
    if (found == by_id.end()) return false;
    if (graph.vertices.emplace(id, Graph::Vertex{found->second, {}, {}}).second) pending.push_back(id);
    return true;
  };
  reach(target);
  while (!pending.empty()) {
    const NodeId id = pending.back();
    pending.pop_back();
    for (const auto& [port, link] : graph.vertices.at(id).node->inputs) {
      if (!reach(link.node)) continue;
      graph.vertices.at(id).inputs.insert(link.node);
      graph.vertices.at(link.node).users.insert(id);
    }
  }
  return graph;
}

/// Takes out of the graph, one after the other, the vertices without neighbours on one side.
template <class Neighbours>
std::vector<NodeId> peel(std::map<NodeId, Graph::Vertex>& vertices, Neighbours before, Neighbours after) {
  std::vector<NodeId> peeled;
  for (const auto& [id, vertex] : vertices) {
    if ((vertex.*before).empty()) peeled.push_back(id);
  }
  for (std::size_t i = 0; i < peeled.size(); ++i) {
    for (const NodeId next : vertices.at(peeled[i]).*after) {
      const auto vertex = vertices.find(next);
      (vertex->second.*before).erase(peeled[i]);
      if ((vertex->second.*before).empty()) peeled.push_back(next);
    }
    vertices.erase(peeled[i]);
  }
  return peeled;
}

}  // namespace

std::vector<OrderedNode> evaluation_order(const Document& document, NodeId target) {
  Graph graph = gather(document, target);
  std::map<NodeId, const Node*> nodes;
  for (const auto& [id, vertex] : graph.vertices) nodes.emplace(id, vertex.node);

  std::vector<OrderedNode> order;
  for (const NodeId id : peel(graph.vertices, &Graph::Vertex::inputs, &Graph::Vertex::users)) {
    order.push_back({nodes.at(id), false});
  }
  const std::vector<NodeId> behind = peel(graph.vertices, &Graph::Vertex::users, &Graph::Vertex::inputs);
  for (const auto& [id, vertex] : graph.vertices) order.push_back({vertex.node, true});
  for (auto id = behind.rbegin(); id != behind.rend(); ++id) order.push_back({nodes.at(*id), false});
  return order;
}

}  // namespace croquis

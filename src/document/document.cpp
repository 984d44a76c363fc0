// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/document/document.h"

#include <algorithm>
#include <iterator>
#include <set>
#include <utility>

namespace croquis {
namespace {

bool links_to(const Node& node, NodeId id) {
  return std::any_of(node.inputs.begin(), node.inputs.end(),
                     [id](const auto& input) { return input.second.node == id; });
}

}  // namespace

Document Document::of(std::vector<std::shared_ptr<const Node>> nodes, NodeId next_id) {
  Document document;
  document.next_id_ = std::max<NodeId>(next_id, 1);
  for (const auto& node : nodes) document.next_id_ = std::max(document.next_id_, node->id + 1);
  document.nodes_ = std::move(nodes);
  return document;
}

const Node* Document::find(NodeId id) const {
  const auto found = std::find_if(nodes_.begin(), nodes_.end(), [id](const auto& node) { return node->id == id; });
  return found == nodes_.end() ? nullptr : found->get();
}

std::vector<std::shared_ptr<const Node>> Document::upstream(NodeId id) const {
  std::set<NodeId> wanted{id};
  std::vector<NodeId> open{id};
  while (!open.empty()) {
    const Node* node = find(open.back());
    open.pop_back();
    if (node == nullptr) continue;
    for (const auto& [port, link] : node->inputs) {
      if (wanted.insert(link.node).second) open.push_back(link.node);
    }
  }
  std::vector<std::shared_ptr<const Node>> nodes;
  std::ranges::copy_if(nodes_, std::back_inserter(nodes), [&](const auto& node) { return wanted.contains(node->id); });
  return nodes;
}

Document Document::with(Node node) const {
  Document edited = *this;
  if (node.id == 0) node.id = next_id_;
  edited.next_id_ = std::max(next_id_, node.id + 1);
  const NodeId id = node.id;
  auto shared = std::make_shared<const Node>(std::move(node));
  const auto place =
      std::find_if(edited.nodes_.begin(), edited.nodes_.end(), [id](const auto& other) { return other->id == id; });
  if (place == edited.nodes_.end()) {
    edited.nodes_.push_back(std::move(shared));
  } else {
    *place = std::move(shared);
  }
  return edited;
}

Document Document::without(NodeId id) const {
  if (find(id) == nullptr) return *this;
  Document edited;
  edited.next_id_ = next_id_;
  for (const auto& node : nodes_) {
    if (node->id == id) continue;
    if (!links_to(*node, id)) {
      edited.nodes_.push_back(node);
      continue;
    }
    Node unlinked = *node;
    std::erase_if(unlinked.inputs, [id](const auto& input) { return input.second.node == id; });
    edited.nodes_.push_back(std::make_shared<const Node>(std::move(unlinked)));
  }
  return edited;
}

}  // namespace croquis

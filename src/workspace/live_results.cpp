// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/workspace/live_results.h"

#include <algorithm>
#include <utility>

namespace croquis {

LiveResults::LiveResults(Evaluator& evaluator, LiveEvaluation::Post post, Listener listener)
    : evaluator_(evaluator), post_(std::move(post)), listener_(std::move(listener)) {}

bool LiveResults::follow(const Document& document, const std::set<NodeId>& nodes, const std::set<NodeId>& lost) {
  for (const NodeId node : nodes) live_node(node).follow(document);
  return std::erase_if(nodes_, [&](auto& entry) {
           if (nodes.contains(entry.first)) return false;
           entry.second->pause();
           return document.find(entry.first) == nullptr || lost.contains(entry.first);
         }) > 0;
}

const LiveNode* LiveResults::find(NodeId node) const {
  const auto found = nodes_.find(node);
  return found == nodes_.end() ? nullptr : found->second.get();
}

bool LiveResults::busy() const {
  return std::ranges::any_of(nodes_, [](const auto& entry) { return entry.second->busy(); });
}

void LiveResults::cancel() {
  for (const auto& [id, live] : nodes_) live->cancel();
}

void LiveResults::hold(bool held) {
  if (std::exchange(held_, held) == held || held) return;
  if (std::exchange(results_wait_, false)) report_results();
  if (listener_.busy_changed) listener_.busy_changed(busy());
}

void LiveResults::report_results() {
  results_wait_ = held_;
  if (!held_ && listener_.changed) listener_.changed();
}

LiveNode& LiveResults::live_node(NodeId node) {
  std::unique_ptr<LiveNode>& live = nodes_[node];
  if (live) return *live;
  LiveNode::Host host;
  host.post = post_;
  host.changed = [this] { report_results(); };
  host.progress = [this](double fraction, const std::string& step) {
    if (!held_ && listener_.progress) listener_.progress(fraction, step);
  };
  host.busy_changed = [this] {
    if (!held_ && listener_.busy_changed) listener_.busy_changed(busy());
  };
  live = std::make_unique<LiveNode>(evaluator_, node, std::move(host));
  return *live;
}

std::unique_ptr<LiveNode> LiveResults::beside(NodeId node, std::function<void()> changed) {
  LiveNode::Host host;
  host.post = post_;
  host.changed = std::move(changed);
  host.progress = [](double, const std::string&) {};
  host.busy_changed = [] {};
  return std::make_unique<LiveNode>(evaluator_, node, std::move(host));
}

}  // namespace croquis

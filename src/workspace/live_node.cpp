// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/workspace/live_node.h"

#include <algorithm>
#include <utility>

namespace croquis {
namespace {

constexpr std::chrono::milliseconds draft_patience{400};  // a draft that takes longer gives way to a newer one

/// Whether the same is computed of both: where an object stands and whether it is seen makes no difference.
bool same_for_computing(const std::shared_ptr<const Node>& a, const std::shared_ptr<const Node>& b) {
  return a == b || (a->id == b->id && a->name == b->name && a->operation == b->operation && a->version == b->version &&
                    a->parameters == b->parameters && a->inputs == b->inputs && a->source == b->source &&
                    a->transform == b->transform && a->enabled == b->enabled);
}

}  // namespace

LiveNode::LiveNode(Evaluator& evaluator, NodeId node, Host host) : node_(node), host_(std::move(host)) {
  LiveEvaluation::Callbacks callbacks;
  callbacks.result = [this](NodeId, std::shared_ptr<const Evaluation> result, Quality quality) {
    take(std::move(result), quality);
  };
  callbacks.progress = host_.progress;
  callbacks.busy = [this](bool) { host_.busy_changed(); };
  live_ = std::make_unique<LiveEvaluation>(evaluator, host_.post, std::move(callbacks));
}

void LiveNode::follow(const Document& document) {
  document_ = document;
  std::vector<std::shared_ptr<const Node>> nodes = document.upstream(node_);
  const bool same = std::ranges::equal(nodes, made_of_, same_for_computing);
  made_of_ = std::move(nodes);
  if (same) return;
  if (drafting_ && Clock::now() - requested_at_ <= draft_patience) {
    // Drags are faster than drafts: the draft under way is shown before the next one begins.
    waiting_ = true;
  } else {
    evaluate();
  }
}

void LiveNode::cancel() {
  waiting_ = false;
  drafting_ = false;
  live_->cancel();
}

void LiveNode::pause() {
  if (busy()) made_of_.clear();
  cancel();
}

void LiveNode::evaluate() {
  waiting_ = false;
  drafting_ = true;
  requested_at_ = Clock::now();
  live_->request(document_, node_);
}

void LiveNode::take(std::shared_ptr<const Evaluation> result, Quality quality) {
  // Edits of the final mesh may not fit the coarser draft of it: what there is says more than that.
  const bool fits_no_draft = quality == Quality::Draft && result->failed && result_;
  if (!fits_no_draft) {
    result_ = std::move(result);
    quality_ = quality;
  }
  drafting_ = false;
  if (waiting_) evaluate();
  const auto report = host_.changed;  // a receiver may remove this node
  report();
}

}  // namespace croquis

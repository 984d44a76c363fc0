// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "croquis/document/evaluator.h"
#include "croquis/session/live_evaluation.h"

namespace croquis {

/// One node of the document, kept evaluated. Requests that come faster than drafts are made wait for the draft under
/// way, so that something moves during every drag.
class LiveNode {
 public:
  struct Host {
    LiveEvaluation::Post post;
    std::function<void()> changed;  ///< result() is another one
    std::function<void(double fraction, const std::string& step)> progress;
    std::function<void()> busy_changed;
  };

  /// @param evaluator outlives this
  LiveNode(Evaluator& evaluator, NodeId node, Host host);

  NodeId node() const { return node_; }

  /// Evaluates the node when it, or anything that it is made from, isn't what it was.
  void follow(const Document& document);

  /// Stops; what is there stays.
  void cancel();

  /// The same while nobody looks: what was stopped begins again with the next call of follow.
  void pause();

  bool busy() const { return waiting_ || live_->busy(); }

  /// The newest there is, older than the document while busy. Null before the first one.
  const std::shared_ptr<const Evaluation>& result() const { return result_; }
  Quality quality() const { return quality_; }

 private:
  using Clock = std::chrono::steady_clock;

  void evaluate();
  void take(std::shared_ptr<const Evaluation> result, Quality quality);

  NodeId node_;
  Host host_;
  Document document_;                                 ///< the newest to be evaluated
  std::vector<std::shared_ptr<const Node>> made_of_;  ///< the node and all that leads to it, as last seen
  std::shared_ptr<const Evaluation> result_;
  Quality quality_ = Quality::Final;
  bool drafting_ = false;  ///< the draft of the newest request hasn't come yet
  bool waiting_ = false;   ///< the document has changed since
  Clock::time_point requested_at_;
  std::unique_ptr<LiveEvaluation> live_;  ///< last: its jobs use all of the above
};

}  // namespace croquis

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>

#include "croquis/document/evaluator.h"
#include "croquis/session/live_evaluation.h"
#include "croquis/workspace/live_node.h"

namespace croquis {

/// Several nodes of a document, each kept evaluated beside the thread that owns this. For one thread.
class LiveResults {
 public:
  /// Each may be empty.
  struct Listener {
    std::function<void()> changed;  ///< some node has another result
    std::function<void(double fraction, const std::string& step)> progress;
    std::function<void(bool busy)> busy_changed;
  };

  /// @param evaluator outlives this
  /// @param post      runs something later on the owner's thread; can be called until the destructor has returned
  LiveResults(Evaluator& evaluator, LiveEvaluation::Post post, Listener listener);

  /// Evaluates these nodes. All others pause; they are kept with their last results as long as they are in the document
  /// and not among `lost`.
  /// @return whether results were forgotten
  bool follow(const Document& document, const std::set<NodeId>& nodes, const std::set<NodeId>& lost);

  /// Null for a node that isn't kept.
  const LiveNode* find(NodeId node) const;

  /// Some newest result isn't final, or doesn't belong to the document that was followed last.
  bool busy() const;

  /// Stops what is being computed; what is there stays.
  void cancel();
  void clear() { nodes_.clear(); }

  /// While held, results and the progress towards them are kept back; released, they are reported at once.
  void hold(bool held);

  /// A node evaluated by itself.
  /// @param changed its result is another one
  std::unique_ptr<LiveNode> beside(NodeId node, std::function<void()> changed);

 private:
  LiveNode& live_node(NodeId node);
  void report_results();

  Evaluator& evaluator_;
  LiveEvaluation::Post post_;
  Listener listener_;
  bool held_ = false;
  bool results_wait_ = false;                          ///< for the end of holding
  std::map<NodeId, std::unique_ptr<LiveNode>> nodes_;  ///< last: their jobs use all of the above
};

}  // namespace croquis

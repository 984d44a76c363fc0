// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "croquis/document/document.h"
#include "croquis/document/evaluation.h"
#include "croquis/document/evaluator.h"

namespace croquis {

/// Keeps the picture of one node up to date without holding up the thread that it belongs to.
///
/// Each request is computed as a draft first and then in full; the newest one wins, and what an older one still
/// computes is cancelled and its result dropped. A computation that is slow to notice goes on beside its successor,
/// up to max_workers of them; beyond that the newest request waits for one of them to end.
///
/// All calls, and all callbacks, belong to the owner's thread. No callback runs after the destructor has begun, even
/// when what was posted runs later.
class LiveEvaluation {
 public:
  /// Threads at most: the one that computes, and those that don't notice that they should stop.
  static constexpr std::size_t max_workers = 4;

  /// Runs something later, and in order, on the owner's thread. Called from any thread; doesn't throw.
  using Post = std::function<void(std::function<void()>)>;

  /// Each may be empty.
  struct Callbacks {
    /// A draft and then the final evaluation of a request; the final one alone when it was there already.
    std::function<void(NodeId, std::shared_ptr<const Evaluation>, Quality)> result;
    /// 0..1 of the request under way, never backwards within it.
    std::function<void(double fraction, const std::string& step)> progress;
    /// True when a request begins where none was; false when the last one is answered or cancelled.
    std::function<void(bool busy)> busy;
  };

  /// @param evaluator outlives this
  /// @param post      can be called until the destructor has returned
  LiveEvaluation(Evaluator& evaluator, Post post, Callbacks callbacks);

  /// Cancels, and waits until every computation has noticed.
  ~LiveEvaluation();
  LiveEvaluation(const LiveEvaluation&) = delete;
  LiveEvaluation& operator=(const LiveEvaluation&) = delete;

  /// While requests follow each other quickly, drafts are made at once and the final result waits a moment.
  /// @throws Error (E_THREAD) when the system gives no thread at all
  void request(Document document, NodeId node);

  /// Answers at once; what is under way is abandoned, and its result dropped.
  void cancel();

  /// Whether a request waits for its final result to be handed over.
  bool busy() const;

 private:
  struct State;

  void start_worker();

  std::shared_ptr<State> state_;  ///< shared with the workers and with what was posted
  std::vector<std::thread> workers_;
};

}  // namespace croquis

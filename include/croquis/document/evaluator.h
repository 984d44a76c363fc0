// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>

#include "croquis/base/progress.h"
#include "croquis/document/document.h"
#include "croquis/document/evaluation.h"
#include "croquis/document/registry.h"

namespace croquis {

/// Computes nodes when they are asked for, and nothing twice: results are kept by what they were made from, stage
/// results of operations beside them, all under one byte cap (see Memo).
///
/// What is wrong with a node is a finding in its Evaluation and never thrown: an operation's own errors; links that
/// lead nowhere or to no such output (E_LINK) or in a circle (E_CYCLE); an input that failed (its errors, and then
/// E_INPUT_FAILED); an
/// operation that isn't there (E_OPERATION_UNKNOWN) or older than the node (E_OPERATION_NEWER); a source without a
/// value (E_NO_VALUE); a transform that isn't invertible (E_TRANSFORM). A failed node keeps its last good outputs as
/// long as they are kept at all, marked as stale.
///
/// A node's transform is applied to all its outputs, and only that is done again when it alone was changed. A node that
/// is off gives the value that its first linked input of the type of its first output has, under that output's name and
/// with that input's key; other outputs are absent, and its transform doesn't count. Without such an input it fails
/// (E_STEP_OFF), like a source that is off.
///
/// Thread safe. Evaluations run side by side: only looking things up is under a lock, so that a computation that is
/// slow to notice its cancelling holds up nobody.
class Evaluator {
 public:
  /// @param registry outlives the evaluator
  /// @param byte_cap of all kept results
  explicit Evaluator(const Registry& registry, std::size_t byte_cap = std::size_t{1} << 30);
  ~Evaluator();
  Evaluator(const Evaluator&) = delete;
  Evaluator& operator=(const Evaluator&) = delete;

  /// O(#nodes log #nodes) beside what has to be computed; a value is hashed once.
  /// @throws Cancelled when the progress was cancelled; then nothing of the node under way is kept
  std::shared_ptr<const Evaluation> evaluate(const Document& document, NodeId id, Quality quality, Progress& progress);

  /// What is known of a node of the document without computing anything: a kept result, final before draft, or what is
  /// wrong with it (see above), with the last good outputs. Null when it would have to be computed.
  std::shared_ptr<const Evaluation> find(const Document& document, NodeId id) const;

  /// The last good outputs of a node, as long as they are kept; null where there are none, and for a source.
  std::shared_ptr<const Evaluation> last_good(NodeId id) const;

  /// What a file kept of a node: these are its last good outputs until it is computed.
  void keep_last_good(NodeId id, Values outputs);

  /// Forgets which outputs were each node's last good ones: for another document, whose ids mean other nodes.
  void forget_last_good();

  /// Forgets all that is kept, those too.
  void forget();

  /// Another cap from now on: what is beyond it is forgotten at once.
  void set_byte_cap(std::size_t byte_cap);

  /// What is kept: never more than the cap.
  std::size_t bytes() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace croquis

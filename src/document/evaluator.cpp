// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/document/evaluator.h"

#include <algorithm>
#include <map>
#include <mutex>
#include <optional>
#include <vector>

#include "croquis/base/error.h"
#include "croquis/document/byte_size.h"
#include "croquis/document/memo.h"
#include "document/evaluation_order.h"
#include "document/node_content.h"
#include "document/node_faults.h"
#include "document/operation_runner.h"
#include "document/value_hashes.h"

namespace croquis {

struct Evaluator::State {
  const Registry& registry;
  Memo memo;
  ValueHashes hashes;
  std::mutex mutex;
  std::map<NodeId, ContentHash> last_good;  ///< under the mutex

  State(const Registry& operations, std::size_t byte_cap) : registry(operations), memo(byte_cap) {}
};

namespace {

/// One node of the evaluation under way.
struct Slot {
  NodeState state;
  ContentHash key;        ///< of what is used here: of the final result when that is available
  ContentHash final_key;  ///< of the final result
  bool needed = false;
};

/// One call of Evaluator::evaluate.
class Pull {
 public:
  Pull(const Registry& registry, Memo& memo, ValueHashes& hashes, Quality quality)
      : registry_(registry), memo_(memo), hashes_(hashes), quality_(quality) {}

  /// Finds out what is known of a node. Its inputs were added before it, but for those in a cycle with it.
  void add(const OrderedNode& ordered);

  /// Computes what the target needs.
  void compute(NodeId target, Progress& progress);

  const NodeState& state_of(NodeId id) const { return slots_.at(id).state; }

  /// Of the results that were needed, the good ones of operations.
  std::map<NodeId, ContentHash> good_keys() const;

 private:
  ContentHash key_of(const Slot& slot, Quality quality) const;
  NodeStates inputs_of(const Slot& slot) const;
  void mark_needed(NodeId target);
  std::shared_ptr<const Evaluation> compute(const Slot& slot, Progress& progress);

  const Registry& registry_;
  Memo& memo_;
  ValueHashes& hashes_;
  Quality quality_;
  std::map<NodeId, Slot> slots_;
  std::vector<NodeId> order_;
};

std::shared_ptr<const Evaluation> source_evaluation(const Value& value, const ContentHash& key) {
  Evaluation evaluation;
  evaluation.outputs["value"] = value;
  evaluation.key = key;
  return std::make_shared<const Evaluation>(std::move(evaluation));
}

std::shared_ptr<const Evaluation> failed_evaluation(Findings findings, Quality quality, const ContentHash& key) {
  Evaluation evaluation;
  evaluation.findings = std::move(findings);
  evaluation.failed = true;
  evaluation.quality = quality;
  evaluation.key = key;
  return std::make_shared<const Evaluation>(std::move(evaluation));
}

void Pull::add(const OrderedNode& ordered) {
  const Node& node = *ordered.node;
  Slot slot;
  slot.state.node = &node;
  slot.state.in_circle = ordered.in_circle;
  if (node.source) {
    ContentHasher hasher;
    hasher.add("source");
    hasher.add(hashes_.of(*node.source));
    slot.key = slot.final_key = hasher.digest();
    if (faults_of(slot.state, {}).empty()) slot.state.evaluation = source_evaluation(*node.source, slot.key);
  } else {
    slot.state.operation = registry_.find(node.operation);
    if (slot.state.operation != nullptr) slot.state.description = slot.state.operation->describe();
    slot.key = slot.final_key = key_of(slot, Quality::Final);
    slot.state.evaluation = memo_.find<Evaluation>(slot.final_key);
    if (quality_ == Quality::Draft && !slot.state.evaluation) {
      slot.key = key_of(slot, Quality::Draft);
      slot.state.evaluation = memo_.find<Evaluation>(slot.key);
    }
  }
  order_.push_back(node.id);
  slots_.emplace(node.id, std::move(slot));
}

/// With default parameters filled in where possible, so that a default given explicitly is the same thing.
ParameterValues effective_parameters(const NodeState& state) {
  if (state.operation == nullptr) return state.node->parameters;
  try {
    return complete(state.description.parameters, state.node->parameters);
  } catch (const Error&) {
    return state.node->parameters;  // reported when the node is computed
  }
}

ContentHash Pull::key_of(const Slot& slot, Quality quality) const {
  const Node& node = *slot.state.node;
  ContentHasher hasher;
  hasher.add("operation");
  hasher.add(node.operation);
  hasher.add(node.version);
  hasher.add(slot.state.description.version);
  hasher.add(static_cast<int>(quality));
  add_content(hasher, effective_parameters(slot.state));
  hasher.add(node.inputs.size());
  for (const auto& [port, link] : node.inputs) {
    hasher.add(port);
    hasher.add(link.output);
    const auto input = slots_.find(link.node);
    hasher.add(input != slots_.end());
    if (input == slots_.end()) continue;
    hasher.add(quality == Quality::Final ? input->second.final_key : input->second.key);
  }
  return hasher.digest();
}

void Pull::mark_needed(NodeId target) {
  slots_.at(target).needed = true;
  for (auto id = order_.rbegin(); id != order_.rend(); ++id) {
    const Slot& slot = slots_.at(*id);
    if (!slot.needed || slot.state.evaluation) continue;
    for (const auto& [port, link] : slot.state.node->inputs) {
      if (const auto input = slots_.find(link.node); input != slots_.end()) input->second.needed = true;
    }
  }
}

void Pull::compute(NodeId target, Progress& progress) {
  mark_needed(target);
  std::vector<Slot*> missing;
  for (const NodeId id : order_) {
    Slot& slot = slots_.at(id);
    if (slot.needed && !slot.state.evaluation) missing.push_back(&slot);
  }
  for (Slot* slot : missing) {
    const std::string& name = slot->state.node->name;
    Progress part =
        progress.step(name.empty() ? slot->state.description.title : name, 1.0 / static_cast<double>(missing.size()));
    slot->state.evaluation = compute(*slot, part);
  }
  progress.report(1);
}

NodeStates Pull::inputs_of(const Slot& slot) const {
  NodeStates inputs;
  for (const auto& [port, link] : slot.state.node->inputs) {
    if (const auto input = slots_.find(link.node); input != slots_.end()) inputs[link.node] = &input->second.state;
  }
  return inputs;
}

std::shared_ptr<const Evaluation> Pull::compute(const Slot& slot, Progress& progress) {
  const NodeStates inputs = inputs_of(slot);
  // Not kept: they name nodes, whose names may change, and cost nothing.
  if (Findings faults = faults_of(slot.state, inputs); !faults.empty()) {
    return failed_evaluation(std::move(faults), quality_, slot.key);
  }
  Values values;
  for (const auto& [port, link] : slot.state.node->inputs) {
    values[port] = inputs.at(link.node)->evaluation->outputs.at(link.output);
  }
  Context context{progress, quality_, &memo_};
  OperationOutcome outcome = run_guarded(*slot.state.operation, values, slot.state.node->parameters, context);
  progress.check();  // a result may be incomplete when the flag was set meanwhile
  Evaluation evaluation;
  evaluation.outputs = std::move(outcome.result.outputs);
  evaluation.findings = std::move(outcome.result.warnings);
  evaluation.details = std::move(outcome.result.details);
  if (!outcome.failed) add_version_warning(slot.state, evaluation.findings);
  evaluation.failed = outcome.failed;
  evaluation.quality = quality_;
  evaluation.key = slot.key;
  const std::size_t bytes =
      sizeof evaluation + byte_size(evaluation.outputs) + byte_size(evaluation.findings) + evaluation.details.bytes();
  auto shared = std::make_shared<const Evaluation>(std::move(evaluation));
  return outcome.repeatable ? memo_.keep<Evaluation>(slot.key, std::move(shared), bytes) : shared;
}

std::map<NodeId, ContentHash> Pull::good_keys() const {
  std::map<NodeId, ContentHash> keys;
  for (const auto& [id, slot] : slots_) {
    const bool good = slot.needed && slot.state.evaluation && !slot.state.evaluation->failed;
    if (good && !slot.state.node->source) keys.emplace(id, slot.key);
  }
  return keys;
}

/// A failed evaluation with the last good outputs, where they are still kept.
std::shared_ptr<const Evaluation> with_stale_outputs(const std::shared_ptr<const Evaluation>& failed, Memo& memo,
                                                     const ContentHash& last_good) {
  const auto good = memo.find<Evaluation>(last_good);
  if (!good) return failed;
  Evaluation evaluation = *failed;
  evaluation.outputs = good->outputs;
  evaluation.details = good->details;
  evaluation.stale = true;
  return std::make_shared<const Evaluation>(std::move(evaluation));
}

}  // namespace

Evaluator::Evaluator(const Registry& registry, std::size_t byte_cap)
    : state_(std::make_unique<State>(registry, byte_cap)) {}

Evaluator::~Evaluator() = default;

std::shared_ptr<const Evaluation> Evaluator::evaluate(const Document& document, NodeId id, Quality quality,
                                                      Progress& progress) {
  progress.check();
  const std::vector<OrderedNode> order = evaluation_order(document, id);
  if (order.empty()) return failed_evaluation({no_such_node(id)}, quality, {});
  Pull pull(state_->registry, state_->memo, state_->hashes, quality);
  for (const OrderedNode& ordered : order) pull.add(ordered);
  pull.compute(id, progress);

  const std::shared_ptr<const Evaluation> evaluation = pull.state_of(id).evaluation;
  std::optional<ContentHash> last_good;
  {
    const std::lock_guard lock(state_->mutex);
    for (const auto& [node, key] : pull.good_keys()) state_->last_good[node] = key;
    if (const auto found = state_->last_good.find(id); found != state_->last_good.end()) last_good = found->second;
  }
  if (!evaluation->failed || !last_good) return evaluation;
  return with_stale_outputs(evaluation, state_->memo, *last_good);
}

void Evaluator::forget_last_good() {
  const std::lock_guard lock(state_->mutex);
  state_->last_good.clear();
}

void Evaluator::forget() {
  forget_last_good();
  state_->memo.clear();
}

void Evaluator::set_byte_cap(std::size_t byte_cap) { state_->memo.set_byte_cap(byte_cap); }

std::size_t Evaluator::bytes() const { return state_->memo.bytes(); }

}  // namespace croquis

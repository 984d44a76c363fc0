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
#include "document/evaluation_steps.h"
#include "document/value_hashes.h"

namespace croquis {

struct Evaluator::State {
  const Registry& registry;
  Memo memo;
  ValueHashes hashes;
  std::mutex mutex;
  std::map<NodeId, ContentHash> last_good;  ///< under the mutex

  State(const Registry& operations, std::size_t byte_cap) : registry(operations), memo(byte_cap) {}

  /// Where it failed, with the node's last good outputs, as long as they are kept.
  std::shared_ptr<const Evaluation> with_last_good(NodeId id, std::shared_ptr<const Evaluation> evaluation);
  std::shared_ptr<const Evaluation> find_last_good(NodeId id);
};

namespace {

/// A result's names among the kept ones.
struct ResultKeys {
  ContentHash plain;   ///< before the node's transform
  ContentHash placed;  ///< after it: the same without one
};

/// One node of the evaluation under way.
struct Slot {
  NodeState state;
  ResultKeys keys;                          ///< of what is used here: of the final result when that is available
  ResultKeys final_keys;                    ///< of the final result
  std::shared_ptr<const Evaluation> plain;  ///< before the node's transform, where it is there already
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

  /// Without computing: what is kept of the node, or what is wrong with it; null where neither is known.
  std::shared_ptr<const Evaluation> known(NodeId id);

  /// Of the results that were needed, the good ones of operations.
  std::map<NodeId, ContentHash> good_keys() const;

 private:
  void add_source(Slot& slot);
  void add_operation(Slot& slot);
  void add_passing(Slot& slot);
  ContentHash key_of(const Slot& slot, Quality quality) const;
  void find_kept(Slot& slot, const ResultKeys& keys);
  Link resolved(const Link& link) const;
  NodeStates inputs_of(const Slot& slot) const;
  void mark_needed(NodeId target);
  std::shared_ptr<const Evaluation> compute(const Slot& slot, Progress& progress);
  std::shared_ptr<const Evaluation> compute_plain(const Slot& slot, const NodeStates& inputs, Progress& progress);
  std::shared_ptr<const Evaluation> place(const Slot& slot, const Evaluation& plain, const Progress& progress);
  std::shared_ptr<const Evaluation> keep(const ContentHash& key, Evaluation evaluation);

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

ResultKeys keys_of(const Node& node, const ContentHash& plain) {
  if (node.transform.is_identity()) return {plain, plain};
  ContentHasher hasher;
  hasher.add("transform");
  hasher.add(plain);
  add_content(hasher, node.transform);
  return {plain, hasher.digest()};
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
    add_source(slot);
  } else {
    slot.state.operation = registry_.find(node.operation);
    if (slot.state.operation != nullptr) slot.state.description = registry_.description(node.operation);
    if (node.enabled) {
      add_operation(slot);
    } else {
      add_passing(slot);
    }
  }
  order_.push_back(node.id);
  slots_.emplace(node.id, std::move(slot));
}

void Pull::add_source(Slot& slot) {
  const Node& node = *slot.state.node;
  ContentHasher hasher;
  hasher.add("source");
  hasher.add(hashes_.of(*node.source));
  slot.keys = slot.final_keys = keys_of(node, hasher.digest());
  if (!faults_of(slot.state, {}).empty()) return;
  slot.plain = source_evaluation(*node.source, slot.keys.plain);
  slot.state.evaluation = node.transform.is_identity() ? slot.plain : memo_.find<Evaluation>(slot.keys.placed);
}

void Pull::add_operation(Slot& slot) {
  slot.final_keys = keys_of(*slot.state.node, key_of(slot, Quality::Final));
  find_kept(slot, slot.final_keys);
  if (quality_ == Quality::Draft && !slot.state.evaluation && !slot.plain) {
    find_kept(slot, keys_of(*slot.state.node, key_of(slot, Quality::Draft)));
  }
}

void Pull::find_kept(Slot& slot, const ResultKeys& keys) {
  slot.keys = keys;
  slot.state.evaluation = memo_.find<Evaluation>(keys.placed);
  if (!slot.state.evaluation && slot.state.node->transform.is_invertible()) {
    slot.plain = memo_.find<Evaluation>(keys.plain);
  }
}

/// What is off has the key of what it passes on, and its users look through it: so they find what was made of that.
void Pull::add_passing(Slot& slot) {
  for (const auto& [port, link] : used_inputs(slot.state)) {
    const auto input = slots_.find(link.node);
    if (input == slots_.end()) continue;
    slot.keys = input->second.keys;
    slot.final_keys = input->second.final_keys;
  }
}

/// The link to what is really used: through nodes that are off.
Link Pull::resolved(const Link& link) const {
  Link end = link;
  for (auto slot = slots_.find(end.node); slot != slots_.end(); slot = slots_.find(end.node)) {
    if (!passes_on(slot->second.state, end.output)) break;
    end = used_inputs(slot->second.state).begin()->second;
  }
  return end;
}

/// With default parameters filled in where possible, so that a default given explicitly is the same thing.
ParameterValues effective_parameters(const NodeState& state) {
  if (state.operation == nullptr) return state.node->parameters;
  try {
    return complete(state.description->parameters, state.node->parameters);
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
  hasher.add(slot.state.description->version);
  hasher.add(static_cast<int>(quality));
  add_content(hasher, effective_parameters(slot.state));
  hasher.add(node.inputs.size());
  for (const auto& [port, given] : node.inputs) {
    const Link link = resolved(given);
    hasher.add(port);
    hasher.add(link.output);
    const auto input = slots_.find(link.node);
    hasher.add(input != slots_.end());
    if (input == slots_.end()) continue;
    if (!input->second.state.node->enabled) {
      hasher.add("off");  // this output isn't there
    } else {
      hasher.add(quality == Quality::Final ? input->second.final_keys.placed : input->second.keys.placed);
    }
  }
  return hasher.digest();
}

void Pull::mark_needed(NodeId target) {
  slots_.at(target).needed = true;
  for (auto id = order_.rbegin(); id != order_.rend(); ++id) {
    const Slot& slot = slots_.at(*id);
    if (!slot.needed || slot.state.evaluation || slot.plain) continue;
    for (const auto& [port, link] : used_inputs(slot.state)) {
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
        progress.step(name.empty() ? slot->state.description->title : name, 1.0 / static_cast<double>(missing.size()));
    slot->state.evaluation = compute(*slot, part);
  }
  progress.report(1);
}

/// The input of a node that is off, under the name of its own output.
std::shared_ptr<const Evaluation> passed_evaluation(const NodeState& state, const NodeStates& inputs) {
  const Link link = used_inputs(state).begin()->second;
  const Evaluation& input = *inputs.at(link.node)->evaluation;
  Evaluation evaluation;
  evaluation.outputs[state.description->outputs.front().name] = input.outputs.at(link.output);
  evaluation.quality = input.quality;
  evaluation.key = input.key;
  return std::make_shared<const Evaluation>(std::move(evaluation));
}

std::shared_ptr<const Evaluation> Pull::known(NodeId id) {
  for (const NodeId each : order_) {
    Slot& slot = slots_.at(each);
    if (slot.state.evaluation) continue;
    const NodeStates inputs = inputs_of(slot);
    const bool decided =
        std::ranges::all_of(inputs, [](const auto& input) { return input.second->evaluation != nullptr; });
    if (!decided) continue;
    if (Findings faults = faults_of(slot.state, inputs); !faults.empty()) {
      slot.state.evaluation = failed_evaluation(std::move(faults), quality_, slot.keys.placed);
    } else if (!slot.state.node->enabled) {
      slot.state.evaluation = passed_evaluation(slot.state, inputs);
    }
  }
  return slots_.at(id).state.evaluation;
}

NodeStates Pull::inputs_of(const Slot& slot) const {
  NodeStates inputs;
  for (const auto& [port, link] : used_inputs(slot.state)) {
    if (const auto input = slots_.find(link.node); input != slots_.end()) inputs[link.node] = &input->second.state;
  }
  return inputs;
}

std::shared_ptr<const Evaluation> Pull::compute(const Slot& slot, Progress& progress) {
  const Node& node = *slot.state.node;
  const NodeStates inputs = inputs_of(slot);
  if (!slot.plain) {
    // Not kept: they name nodes, whose names may change, and cost nothing.
    if (Findings faults = faults_of(slot.state, inputs); !faults.empty()) {
      return failed_evaluation(std::move(faults), quality_, slot.keys.placed);
    }
    if (!node.enabled) return passed_evaluation(slot.state, inputs);
  }
  const auto plain = slot.plain ? slot.plain : compute_plain(slot, inputs, progress);
  return plain->failed || node.transform.is_identity() ? plain : place(slot, *plain, progress);
}

std::shared_ptr<const Evaluation> Pull::place(const Slot& slot, const Evaluation& plain, const Progress& progress) {
  const OperationOutcome outcome = guarded(
      [&] {
        OperationResult result{plain.outputs, {}};
        for (auto& [port, value] : result.outputs) value = value.transformed(slot.state.node->transform);
        return result;
      },
      progress);
  if (outcome.failed) return failed_evaluation(outcome.result.warnings, plain.quality, slot.keys.placed);
  Evaluation evaluation = plain;
  evaluation.outputs = outcome.result.outputs;
  evaluation.key = slot.keys.placed;
  return keep(slot.keys.placed, std::move(evaluation));
}

std::shared_ptr<const Evaluation> Pull::compute_plain(const Slot& slot, const NodeStates& inputs, Progress& progress) {
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
  evaluation.key = slot.keys.plain;
  if (!outcome.repeatable) return std::make_shared<const Evaluation>(std::move(evaluation));
  return keep(slot.keys.plain, std::move(evaluation));
}

std::shared_ptr<const Evaluation> Pull::keep(const ContentHash& key, Evaluation evaluation) {
  const std::size_t bytes =
      sizeof evaluation + byte_size(evaluation.outputs) + byte_size(evaluation.findings) + evaluation.details.bytes();
  return memo_.keep<Evaluation>(key, std::make_shared<const Evaluation>(std::move(evaluation)), bytes);
}

std::map<NodeId, ContentHash> Pull::good_keys() const {
  std::map<NodeId, ContentHash> keys;
  for (const auto& [id, slot] : slots_) {
    const bool good = slot.needed && slot.state.evaluation && !slot.state.evaluation->failed;
    // A source needs none, and what a node that is off passes on is kept under other names.
    if (good && !slot.state.node->source && slot.state.node->enabled) keys.emplace(id, slot.keys.placed);
  }
  return keys;
}

}  // namespace

Evaluator::Evaluator(const Registry& registry, std::size_t byte_cap)
    : state_(std::make_unique<State>(registry, byte_cap)) {}

Evaluator::~Evaluator() = default;

std::shared_ptr<const Evaluation> Evaluator::State::with_last_good(NodeId id,
                                                                   std::shared_ptr<const Evaluation> evaluation) {
  const auto good = evaluation->failed ? find_last_good(id) : nullptr;
  if (!good) return evaluation;
  Evaluation stale = *evaluation;
  stale.outputs = good->outputs;
  stale.details = good->details;
  stale.stale = true;
  return std::make_shared<const Evaluation>(std::move(stale));
}

std::shared_ptr<const Evaluation> Evaluator::State::find_last_good(NodeId id) {
  std::optional<ContentHash> last;
  {
    const std::lock_guard lock(mutex);
    if (const auto found = last_good.find(id); found != last_good.end()) last = found->second;
  }
  return last ? memo.find<Evaluation>(*last) : nullptr;
}

std::shared_ptr<const Evaluation> Evaluator::last_good(NodeId id) const { return state_->find_last_good(id); }

void Evaluator::keep_last_good(NodeId id, Values outputs) {
  ContentHasher hasher;
  hasher.add("kept");
  for (const auto& [port, value] : outputs) {
    hasher.add(port);
    hasher.add(state_->hashes.of(value));
  }
  Evaluation evaluation;
  evaluation.outputs = std::move(outputs);
  evaluation.key = hasher.digest();
  const std::size_t bytes = sizeof evaluation + byte_size(evaluation.outputs);
  const ContentHash key = evaluation.key;
  state_->memo.keep<Evaluation>(key, std::make_shared<const Evaluation>(std::move(evaluation)), bytes);
  const std::lock_guard lock(state_->mutex);
  state_->last_good[id] = key;
}

std::shared_ptr<const Evaluation> Evaluator::evaluate(const Document& document, NodeId id, Quality quality,
                                                      Progress& progress) {
  progress.check();
  const std::vector<OrderedNode> order = evaluation_order(document, id);
  if (order.empty()) return failed_evaluation({no_such_node(id)}, quality, {});
  Pull pull(state_->registry, state_->memo, state_->hashes, quality);
  for (const OrderedNode& ordered : order) pull.add(ordered);
  pull.compute(id, progress);
  {
    const std::lock_guard lock(state_->mutex);
    for (const auto& [node, key] : pull.good_keys()) state_->last_good[node] = key;
  }
  return state_->with_last_good(id, pull.state_of(id).evaluation);
}

std::shared_ptr<const Evaluation> Evaluator::find(const Document& document, NodeId id) const {
  const std::vector<OrderedNode> order = evaluation_order(document, id);
  if (order.empty()) return failed_evaluation({no_such_node(id)}, Quality::Final, {});
  Pull pull(state_->registry, state_->memo, state_->hashes, Quality::Draft);
  for (const OrderedNode& ordered : order) pull.add(ordered);
  std::shared_ptr<const Evaluation> known = pull.known(id);
  return known ? state_->with_last_good(id, std::move(known)) : nullptr;
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

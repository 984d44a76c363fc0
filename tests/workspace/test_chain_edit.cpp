// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "croquis/base/error.h"
#include "croquis/document/evaluator.h"
#include "croquis/workspace/chain.h"
#include "croquis/workspace/chain_edit.h"
#include "support/trial_operation.h"

namespace croquis::test {
namespace {

/// "scale" multiplies a mesh, "shift" adds to it: their order counts. "draw" makes a mesh of a drawing.
Registry chain_operations() {
  Registry registry;
  add_operation(registry, mesh_to_mesh("scale"), [](const Values& inputs, const ParameterValues& parameters, Context&) {
    return scaled(inputs, parameters);
  });
  add_operation(registry, mesh_to_mesh("shift"),
                [](const Values& inputs, const ParameterValues& parameters, Context&) -> OperationResult {
                  const double by = std::get<double>(parameters.at("factor"));
                  return {{{"mesh", point(x_of(inputs.at("mesh")) + by)}}, {}};
                });
  OperationDescription draw = mesh_to_mesh("draw");
  draw.inputs = {{"drawing", ValueType::Drawing, "The drawing."}};
  add_operation(registry, std::move(draw),
                [](const Values&, const ParameterValues& parameters, Context&) -> OperationResult {
                  return {{{"mesh", point(std::get<double>(parameters.at("factor")))}}, {}};
                });
  return registry;
}

Value value_of(const Document& document, const Registry& registry, NodeId node) {
  Evaluator evaluator(registry);
  Progress progress;
  const auto evaluation = evaluator.evaluate(document, node, Quality::Final, progress);
  INFO((evaluation->findings.empty() ? std::string() : evaluation->findings.front().message));
  REQUIRE_FALSE(evaluation->failed);
  return evaluation->outputs.at(main_link(*document.find(node), registry).output);
}

/// The same chain as a list of numbers: what the edits are to amount to.
struct ModelStep {
  bool scales = true;
  double factor = 1;
  bool enabled = true;
};

double apply(const std::vector<ModelStep>& steps, double x) {
  for (const ModelStep& step : steps) {
    if (step.enabled) x = step.scales ? x * step.factor : x + step.factor;
  }
  return x;
}

class RandomChain {
 public:
  explicit RandomChain(unsigned seed) : random_(seed) {
    document_ = Document().with(source_node(point(start_)));
    chain_ = {document_.nodes().front()->id};
  }

  void edit() {
    switch (pick(6)) {
      case 0: return add();
      case 1: return remove();
      case 2: return toggle();
      case 3: return move();
      case 4: return copy();
      default:
        if (pick(4) == 0) freeze();
    }
  }

  void check() const {
    REQUIRE(chain_to(document_, registry_, chain_.back()) == chain_);
    REQUIRE(document_.nodes().size() == chain_.size());
    REQUIRE_FALSE(is_used(document_, chain_.back()));
    const double x = x_of(value_of(document_, registry_, chain_.back()));
    const double wanted = apply(model_, start_);
    REQUIRE(std::abs(x - wanted) <= 1e-12 * (1 + std::abs(wanted)));
  }

 private:
  int pick(int count) { return std::uniform_int_distribution<int>(0, count - 1)(random_); }
  int step() { return pick(static_cast<int>(model_.size())); }
  NodeId node(int step) const { return chain_[static_cast<std::size_t>(step) + 1]; }

  void add() {
    if (model_.size() > 12) return;
    const int place = pick(static_cast<int>(chain_.size()));
    const ModelStep step{pick(2) == 0, 0.25 * (1 + pick(8)), true};
    AddedNode added = with_step(document_, registry_, chain_[static_cast<std::size_t>(place)],
                                step.scales ? "scale" : "shift", {{"factor", step.factor}});
    document_ = std::move(added.document);
    chain_.insert(chain_.begin() + place + 1, added.node);
    model_.insert(model_.begin() + place, step);
  }

  void remove() {
    if (model_.empty()) return;
    const int gone = step();
    document_ = without_step(document_, registry_, node(gone));
    chain_.erase(chain_.begin() + gone + 1);
    model_.erase(model_.begin() + gone);
  }

  void toggle() {
    if (model_.empty()) return;
    const int changed = step();
    ModelStep& in_model = model_[static_cast<std::size_t>(changed)];
    in_model.enabled = !in_model.enabled;
    document_ = with_step_enabled(document_, registry_, node(changed), in_model.enabled);
  }

  void move() {
    if (model_.empty()) return;
    const int moved = step();
    const int by = pick(2) == 0 ? 1 : -1;
    const int place = moved + by;
    const auto work = [&] { return with_step_moved(document_, registry_, node(moved), by); };
    if (place < 0 || place >= static_cast<int>(model_.size())) {
      CHECK_THROWS_AS(work(), Error);
      return;
    }
    document_ = work();
    std::swap(chain_[static_cast<std::size_t>(moved) + 1], chain_[static_cast<std::size_t>(place) + 1]);
    std::swap(model_[static_cast<std::size_t>(moved)], model_[static_cast<std::size_t>(place)]);
  }

  void copy() {
    if (model_.empty() || model_.size() > 12) return;
    const int copied = step();
    AddedNode added = with_step_copied(document_, registry_, node(copied));
    document_ = std::move(added.document);
    chain_.insert(chain_.begin() + copied + 2, added.node);
    model_.insert(model_.begin() + copied + 1, model_[static_cast<std::size_t>(copied)]);
  }

  void freeze() {
    if (model_.empty()) return;
    const int frozen = step();
    const Value value = value_of(document_, registry_, node(frozen));
    document_ = with_step_frozen(document_, registry_, node(frozen), value);
    start_ = x_of(value);
    chain_.erase(chain_.begin(), chain_.begin() + frozen + 1);
    model_.erase(model_.begin(), model_.begin() + frozen + 1);
  }

  Registry registry_ = chain_operations();
  std::mt19937 random_;
  double start_ = 1.5;
  Document document_;
  std::vector<NodeId> chain_;
  std::vector<ModelStep> model_;
};

TEST_CASE("workspace: random edits of a chain do what the same edits of a list of numbers do") {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    INFO("seed " << seed);
    RandomChain chain(seed);
    for (int edit = 0; edit < 60; ++edit) {
      chain.edit();
      chain.check();
    }
  }
}

/// The sentence that the work is refused with; empty when it isn't.
std::string refusal(const std::function<void()>& work) {
  try {
    work();
  } catch (const Error& error) {
    return error.findings().front().message;
  }
  return {};
}

struct DrawnChain {
  Registry registry = chain_operations();
  Document document;
  NodeId drawing = 0, solid = 0, scale = 0;

  DrawnChain() {
    document = Document().with(source_node(std::make_shared<const Drawing>(), "sketch"));
    drawing = document.nodes().front()->id;
    AddedNode added = with_step(document, registry, drawing, "draw");
    solid = added.node;
    added = with_step(added.document, registry, solid, "scale");
    scale = added.node;
    document = std::move(added.document);
  }
};

TEST_CASE("workspace: steps that don't fit are refused with their names, and nothing changes") {
  const DrawnChain c;
  CHECK(refusal([&] { with_step(c.document, c.registry, c.drawing, "scale"); }).find("works on a mesh") !=
        std::string::npos);
  CHECK(refusal([&] { with_step(c.document, c.registry, c.drawing, "scale"); }).find("sketch") != std::string::npos);
  CHECK(refusal([&] { with_step(c.document, c.registry, c.drawing, "nothing"); }).find("nothing") != std::string::npos);
  CHECK(refusal([&] { without_step(c.document, c.registry, c.solid); }).find("\"scale\" needs a mesh") !=
        std::string::npos);
  CHECK(refusal([&] { without_step(c.document, c.registry, c.drawing); }).find("\"sketch\"") != std::string::npos);
  CHECK(refusal([&] { with_step_enabled(c.document, c.registry, c.solid, false); }).find("can't be switched off") !=
        std::string::npos);
  CHECK(refusal([&] {
          with_step_moved(c.document, c.registry, c.scale, -1);
        }).find("\"scale\" can't come before \"draw\"") != std::string::npos);
  CHECK_THROWS_AS(with_step_moved(c.document, c.registry, c.scale, 1), Error);
}

TEST_CASE("workspace: a copied object shares the values and nothing else") {
  const DrawnChain c;
  const AddedNode copied = with_object_copied(c.document, c.scale);
  const std::vector<NodeId> chain = chain_to(copied.document, c.registry, copied.node);
  REQUIRE(chain.size() == 3);
  CHECK(copied.document.nodes().size() == 6);
  CHECK(*copied.document.find(chain.front())->source == *c.document.find(c.drawing)->source);
  CHECK(copied.document.find(chain.front())->name == "sketch 2");
  for (const NodeId id : chain) CHECK(c.document.find(id) == nullptr);
  const Document rest = without_object(copied.document, c.scale);
  CHECK(rest.nodes().size() == 3);
  CHECK(chain_to(rest, c.registry, copied.node) == chain);
}

TEST_CASE("workspace: what another chain uses outlives an object") {
  const DrawnChain c;
  const AddedNode other = with_step(c.document, c.registry, c.drawing, "draw");
  CHECK(steps_after(other.document, c.registry, c.drawing).size() == 2);
  const Document rest = without_object(other.document, c.scale);
  CHECK(rest.nodes().size() == 2);
  CHECK(chain_to(rest, c.registry, other.node) == std::vector<NodeId>{c.drawing, other.node});
  CHECK(without_object(rest, other.node).nodes().empty());
}

TEST_CASE("a step goes on from the output of its type, and steps after it from what it gives") {
  Registry registry = chain_operations();
  OperationDescription scan = mesh_to_mesh("scan");
  scan.outputs.push_back({"drawing", ValueType::Drawing, "What was seen."});
  add_operation(registry, std::move(scan), [](const Values& inputs, const ParameterValues&, Context&) {
    return OperationResult{{{"mesh", inputs.at("mesh")}, {"drawing", std::make_shared<const Drawing>()}}, {}};
  });
  const Document start = Document().with(source_node(point(3)));
  const AddedNode scanned = with_step(start, registry, start.nodes().front()->id, "scan");
  const AddedNode shifted = with_step(scanned.document, registry, scanned.node, "shift");
  const AddedNode drawn = with_step(shifted.document, registry, scanned.node, "draw", {{"factor", 5.0}});
  CHECK(drawn.document.find(drawn.node)->inputs.at("drawing") == Link{scanned.node, "drawing"});
  CHECK(drawn.document.find(shifted.node)->inputs.at("mesh") == Link{drawn.node, "mesh"});
  CHECK(x_of(value_of(drawn.document, registry, shifted.node)) == 7);
  CHECK_THROWS_AS(with_step_frozen(drawn.document, registry, scanned.node, point(3)), Error);
  CHECK_THROWS_AS(with_step(drawn.document, registry, drawn.node, "draw"), Error);
  const Document without = without_step(drawn.document, registry, drawn.node);
  CHECK(without.find(shifted.node)->inputs.at("mesh") == Link{scanned.node, "mesh"});
  CHECK(x_of(value_of(without, registry, shifted.node)) == 5);
}

}  // namespace
}  // namespace croquis::test

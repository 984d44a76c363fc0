// SPDX-License-Identifier: GPL-3.0-or-later
#include <atomic>
#include <functional>
#include <limits>

#include <catch2/catch.hpp>

#include "croquis/document/content_hash.h"
#include "croquis/document/evaluator.h"
#include "support/trial_operation.h"

/// Nodes with a transform, and nodes that are off.
namespace croquis {
namespace {

using test::add_operation;
using test::mesh_to_mesh;
using test::operation_node;
using test::point;
using test::source_node;
using test::x_of;

Affine3 shift(double x) {
  Affine3 map;
  map.offset.x() = x;
  return map;
}

/// "scale" counts how often it computes; "both" has a report beside its mesh and takes one first.
struct StateFixture {
  Registry registry;
  std::atomic<int> computed = 0;
  Document document;

  StateFixture() {
    add_operation(registry, mesh_to_mesh("scale"),
                  [this](const Values& inputs, const ParameterValues& values, Context&) {
                    ++computed;
                    return test::scaled(inputs, values);
                  });
    OperationDescription both = mesh_to_mesh("both");
    both.inputs.insert(both.inputs.begin(), {"name", ValueType::Report, "A name.", false, true});
    both.inputs.push_back({"other", ValueType::Mesh, "Another mesh.", false, true});
    both.outputs.push_back({"details", ValueType::Report, "A report."});
    add_operation(registry, both, [this](const Values& inputs, const ParameterValues& values, Context&) {
      ++computed;
      OperationResult result = test::scaled(inputs, values);
      result.outputs["details"] = std::make_shared<const Report>(Report("both"));
      return result;
    });
    document = Document()
                   .with(source_node(point(1), "cube"))
                   .with(operation_node("scale", {1, "value"}, 2, "double"))
                   .with(operation_node("scale", {2, "mesh"}, 3, "triple"));
  }

  void edit(NodeId id, const std::function<void(Node&)>& change) {
    Node node = *document.find(id);
    change(node);
    document = document.with(node);
  }
  void place(NodeId id, const Affine3& map) {
    edit(id, [&](Node& node) { node.transform = map; });
  }
  void turn(NodeId id, bool on) {
    edit(id, [&](Node& node) { node.enabled = on; });
  }
};

std::shared_ptr<const Evaluation> evaluate(Evaluator& evaluator, const Document& document, NodeId id,
                                           Quality quality = Quality::Final) {
  Progress progress;
  return evaluator.evaluate(document, id, quality, progress);
}

std::string codes(const Evaluation& evaluation) {
  std::string all;
  for (const Finding& finding : evaluation.findings) all += (all.empty() ? "" : " ") + finding.code;
  return all;
}

TEST_CASE("what a node gives is moved by its transform, and its users see it moved") {
  StateFixture f;
  f.place(1, shift(10));
  f.place(2, shift(100));
  Evaluator evaluator(f.registry);
  CHECK(x_of(evaluate(evaluator, f.document, 1)->outputs.at("value")) == 11);
  CHECK(x_of(evaluate(evaluator, f.document, 2)->outputs.at("mesh")) == 122);
  CHECK(x_of(evaluate(evaluator, f.document, 3)->outputs.at("mesh")) == 366);
  CHECK(x_of(*f.document.find(1)->source) == 1);
}

TEST_CASE("moving a node computes its users again but not itself, and moving it back nothing") {
  StateFixture f;
  Evaluator evaluator(f.registry);
  const auto before = evaluate(evaluator, f.document, 3);
  REQUIRE(f.computed == 2);
  f.place(2, shift(5));
  const auto moved = evaluate(evaluator, f.document, 2);
  CHECK(f.computed == 2);
  CHECK(moved->key != evaluate(evaluator, f.document, 1)->key);
  CHECK(x_of(evaluate(evaluator, f.document, 3)->outputs.at("mesh")) == 21);
  CHECK(f.computed == 3);
  CHECK(evaluate(evaluator, f.document, 3)->key != before->key);
  f.place(2, {});
  CHECK(evaluate(evaluator, f.document, 3)->key == before->key);
  CHECK(f.computed == 3);
  for (int i = 1; i < 20; ++i) {
    f.place(3, shift(i));
    CHECK(x_of(evaluate(evaluator, f.document, 3)->outputs.at("mesh")) == 6 + i);
  }
  CHECK(f.computed == 3);
}

TEST_CASE("results are the same with an empty memo, drafts too") {
  StateFixture f;
  f.place(1, shift(2));
  f.place(3, shift(-1));
  Evaluator warm(f.registry);
  for (const Quality quality : {Quality::Draft, Quality::Final, Quality::Draft}) {
    Evaluator cold(f.registry, 0);
    const auto a = evaluate(warm, f.document, 3, quality);
    const auto b = evaluate(cold, f.document, 3, quality);
    CHECK(content_hash(a->outputs.at("mesh")) == content_hash(b->outputs.at("mesh")));
  }
}

TEST_CASE("a transform without an inverse is a finding of its node, and of no other") {
  StateFixture f;
  Evaluator evaluator(f.registry);
  evaluate(evaluator, f.document, 3);
  Affine3 flat;
  flat.linear.col(1).setZero();
  Affine3 endless = shift(std::numeric_limits<double>::infinity());
  for (const Affine3& map : {flat, endless}) {
    for (const NodeId id : {NodeId{1}, NodeId{2}}) {
      StateFixture g;
      g.document = f.document;
      g.place(id, map);
      const auto failed = evaluate(evaluator, g.document, id);
      CHECK(failed->failed);
      CHECK(codes(*failed) == "E_TRANSFORM");
      CHECK(failed->findings[0].message.find(g.document.find(id)->name) != std::string::npos);
      CHECK(codes(*evaluate(evaluator, g.document, id + 1)) == "E_TRANSFORM E_INPUT_FAILED");
    }
  }
  CHECK_FALSE(evaluate(evaluator, f.document, 3)->failed);
}

TEST_CASE("a node that is off passes on its input, whose users find what was made of it") {
  StateFixture f;
  Evaluator evaluator(f.registry);
  f.edit(3, [](Node& node) { node.inputs["mesh"] = {1, "value"}; });
  const auto direct = evaluate(evaluator, f.document, 3);
  REQUIRE(f.computed == 1);
  f.edit(3, [](Node& node) { node.inputs["mesh"] = {2, "mesh"}; });
  f.turn(2, false);
  f.place(2, shift(7));
  const auto off = evaluate(evaluator, f.document, 2);
  CHECK_FALSE(off->failed);
  CHECK(off->outputs.size() == 1);
  CHECK(off->outputs.at("mesh") == *f.document.find(1)->source);
  CHECK(off->key == evaluate(evaluator, f.document, 1)->key);
  const auto through = evaluate(evaluator, f.document, 3);
  CHECK(through->key == direct->key);
  CHECK(through->outputs == direct->outputs);
  CHECK(f.computed == 1);
}

TEST_CASE("of several inputs the first linked one of the output's type is passed on, and no other is asked") {
  StateFixture f;
  Node node = operation_node("both", {2, "mesh"}, 1, "both");
  node.inputs["other"] = {1, "value"};
  node.inputs["name"] = {99, "value"};
  node.enabled = false;
  const Document document = f.document.with(node);
  Evaluator evaluator(f.registry);
  const auto off = evaluate(evaluator, document, 4);
  CHECK_FALSE(off->failed);
  CHECK(x_of(off->outputs.at("mesh")) == 2);
  CHECK_FALSE(off->outputs.contains("details"));
  node = *document.find(4);
  node.inputs.erase("mesh");
  CHECK(evaluate(evaluator, document.with(node), 4)->outputs.at("mesh") == *document.find(1)->source);
  node.inputs.erase("other");
  const auto without = evaluate(evaluator, document.with(node), 4);
  CHECK(codes(*without) == "E_STEP_OFF");
  CHECK(without->findings[0].message.find("'both'") != std::string::npos);
}

TEST_CASE("an output that a node gives no more when it is off is missed by its users") {
  StateFixture f;
  const Node both = operation_node("both", {1, "value"}, 1, "both");
  Node user = operation_node("both", {1, "value"}, 1, "user");
  user.inputs["name"] = {4, "details"};
  Document document = f.document.with(both).with(user);
  Evaluator evaluator(f.registry);
  CHECK_FALSE(evaluate(evaluator, document, 5)->failed);
  Node off = *document.find(4);
  off.enabled = false;
  document = document.with(off);
  const auto failed = evaluate(evaluator, document, 5);
  CHECK(codes(*failed) == "E_STEP_OFF");
  CHECK(failed->findings[0].message.find("'both'") != std::string::npos);
}

TEST_CASE("links to two outputs of one node through nodes that are off are not mistaken for one another") {
  StateFixture f;
  OperationDescription two = mesh_to_mesh("two");
  two.outputs.push_back({"second", ValueType::Mesh, "Another one."});
  add_operation(f.registry, two, [](const Values& inputs, const ParameterValues& values, Context&) {
    OperationResult result = test::scaled(inputs, values);
    result.outputs["second"] = point(1000);
    return result;
  });
  Node first = operation_node("scale", {4, "mesh"}, 1), second = operation_node("scale", {4, "second"}, 1);
  first.enabled = second.enabled = false;
  const Document document = f.document.with(operation_node("two", {1, "value"}, 5))
                                .with(first)
                                .with(second)
                                .with(operation_node("scale", {5, "mesh"}, 2))
                                .with(operation_node("scale", {6, "mesh"}, 2));
  Evaluator evaluator(f.registry);
  CHECK(x_of(evaluate(evaluator, document, 7)->outputs.at("mesh")) == 10);
  CHECK(x_of(evaluate(evaluator, document, 8)->outputs.at("mesh")) == 2000);
}

TEST_CASE("sources that are off, circles of nodes that are off and failed inputs are findings") {
  StateFixture f;
  Evaluator evaluator(f.registry);
  f.turn(1, false);
  CHECK(codes(*evaluate(evaluator, f.document, 1)) == "E_STEP_OFF");
  f.turn(2, false);
  CHECK(codes(*evaluate(evaluator, f.document, 2)) == "E_STEP_OFF E_INPUT_FAILED");
  f.edit(2, [](Node& node) { node.inputs["mesh"] = {3, "mesh"}; });
  f.turn(3, false);
  Document circle = f.document.with(operation_node("scale", {3, "mesh"}, 2));
  for (const NodeId id : {NodeId{2}, NodeId{3}}) CHECK(codes(*evaluate(evaluator, circle, id)) == "E_CYCLE");
  CHECK(codes(*evaluate(evaluator, circle, 4)) == "E_CYCLE E_INPUT_FAILED");
}

TEST_CASE("a chain of many nodes that are off ends at its source") {
  StateFixture f;
  Document document = Document().with(source_node(point(4)));
  for (NodeId id = 1; id < 300; ++id) {
    Node node = operation_node("scale", {id, id == 1 ? "value" : "mesh"}, 2);
    node.enabled = false;
    document = document.with(node);
  }
  Evaluator evaluator(f.registry);
  CHECK(x_of(evaluate(evaluator, document, 300)->outputs.at("mesh")) == 4);
  CHECK(f.computed == 0);
}

}  // namespace
}  // namespace croquis

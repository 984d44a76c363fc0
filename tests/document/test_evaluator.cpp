// SPDX-License-Identifier: GPL-3.0-or-later
#include <atomic>
#include <thread>

#include <catch2/catch.hpp>

#include "croquis/base/error.h"
#include "croquis/document/evaluator.h"
#include "support/trial_operation.h"

namespace croquis {
namespace {

using test::add_operation;
using test::mesh_to_mesh;
using test::operation_node;
using test::point;
using test::source_node;
using test::x_of;

/// "scale" fails for negative factors.
struct Fixture {
  Registry registry;
  Document document;

  Fixture() {
    add_operation(registry, mesh_to_mesh("scale"),
                  [](const Values& inputs, const ParameterValues& parameters, Context&) {
                    if (std::get<double>(parameters.at("factor")) < 0) {
                      throw Error(Findings{make_error(Category::Geometry, "E_NEGATIVE", "Negative."),
                                           make_warning(Category::Geometry, "W_ODD", "Odd.")});
                    }
                    OperationResult result = test::scaled(inputs, parameters);
                    result.warnings.push_back(make_warning(Category::Geometry, "W_SCALED", "Scaled."));
                    return result;
                  });
    document = Document()
                   .with(source_node(point(1), "cube"))
                   .with(operation_node("scale", {1, "value"}, 2, "double"))
                   .with(operation_node("scale", {2, "mesh"}, 3, "triple"));
  }

  void set_factor(NodeId id, double factor) {
    Node node = *document.find(id);
    node.parameters["factor"] = factor;
    document = document.with(node);
  }

  void link(NodeId id, Link input) {
    Node node = *document.find(id);
    node.inputs["mesh"] = std::move(input);
    document = document.with(node);
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

TEST_CASE("a node is what its operation makes of its inputs") {
  Fixture f;
  Evaluator evaluator(f.registry);
  const auto source = evaluate(evaluator, f.document, 1);
  CHECK(source->outputs.at("value") == *f.document.find(1)->source);
  CHECK_FALSE(source->failed);
  const auto result = evaluate(evaluator, f.document, 3);
  CHECK(x_of(result->outputs.at("mesh")) == 6);
  CHECK_FALSE(result->failed);
  CHECK_FALSE(result->stale);
  CHECK(codes(*result) == "W_SCALED");
}

TEST_CASE("an optional input may be absent, and must fit when it isn't") {
  Fixture f;
  OperationDescription description = mesh_to_mesh("named");
  description.inputs.push_back({"name", ValueType::Report, "How it is called.", false, true});
  add_operation(f.registry, description, [](const Values& inputs, const ParameterValues& parameters, Context&) {
    OperationResult result = test::scaled(inputs, parameters);
    const auto name = inputs.find("name");
    const std::string word = name == inputs.end() ? "nobody" : name->second.get<Report>().as_string();
    result.warnings.push_back(make_warning(Category::Geometry, word, word));
    return result;
  });
  Node node = operation_node("named", {1, "value"}, 2, "named");
  Document document = f.document.with(node).with(source_node(std::make_shared<const Report>(Report("cat"))));
  Evaluator evaluator(f.registry);
  const auto without = evaluate(evaluator, document, 4);
  CHECK(codes(*without) == "nobody");
  node = *document.find(4);
  node.inputs["name"] = {5, "value"};
  const auto with = evaluate(evaluator, document.with(node), 4);
  CHECK(codes(*with) == "cat");
  CHECK(with->key != without->key);
  node.inputs["name"] = {1, "value"};
  const auto wrong = evaluate(evaluator, document.with(node), 4);
  CHECK(wrong->failed);
  CHECK(codes(*wrong) == "E_INPUT");
}

TEST_CASE("a node that fails keeps its findings and shows its last good result as stale") {
  Fixture f;
  Evaluator evaluator(f.registry);
  f.set_factor(2, -1);
  const auto first = evaluate(evaluator, f.document, 2);
  CHECK(first->failed);
  CHECK_FALSE(first->stale);
  CHECK(first->outputs.empty());

  f.set_factor(2, 5);
  evaluate(evaluator, f.document, 2);
  for (const double factor : {-1.0, -2.0}) {
    f.set_factor(2, factor);
    for (const Quality quality : {Quality::Draft, Quality::Final}) {
      const auto failed = evaluate(evaluator, f.document, 2, quality);
      CHECK(failed->failed);
      CHECK(failed->stale);
      CHECK(codes(*failed) == "E_NEGATIVE W_ODD");
      CHECK(x_of(failed->outputs.at("mesh")) == 5);
    }
  }
  f.set_factor(2, 4);
  const auto mended = evaluate(evaluator, f.document, 2);
  CHECK_FALSE(mended->failed);
  CHECK_FALSE(mended->stale);
  CHECK(x_of(mended->outputs.at("mesh")) == 4);
}

TEST_CASE("what depends on a failed node says so, names it, and is stale too") {
  Fixture f;
  Evaluator evaluator(f.registry);
  evaluate(evaluator, f.document, 3);
  f.set_factor(2, -1);
  const auto failed = evaluate(evaluator, f.document, 3);
  CHECK(failed->failed);
  // The reason comes first, so that whoever shows this node alone has it.
  REQUIRE(codes(*failed) == "E_NEGATIVE E_INPUT_FAILED");
  CHECK(failed->findings[1].message.find("'double'") != std::string::npos);
  CHECK(failed->findings[1].subjects[0].id == "2");
  CHECK(failed->stale);
  CHECK(x_of(failed->outputs.at("mesh")) == 6);
  // The name is the one of now, though nothing else has changed.
  Node renamed = *f.document.find(2);
  renamed.name = "twice";
  CHECK(evaluate(evaluator, f.document.with(renamed), 3)->findings[1].message.find("'twice'") != std::string::npos);
  // What comes after it waits as well, for the same reason, told once.
  f.document = f.document.with(operation_node("scale", {3, "mesh"}, 1, "behind"));
  CHECK(codes(*evaluate(evaluator, f.document, 4)) == "E_NEGATIVE E_INPUT_FAILED");
}

TEST_CASE("outputs that a file kept of a node are its last good ones until it is computed") {
  Fixture f;
  Evaluator evaluator(f.registry);
  f.set_factor(2, -1);
  CHECK_FALSE(evaluator.last_good(2));
  evaluator.keep_last_good(2, {{"mesh", point(5)}});
  const auto failed = evaluate(evaluator, f.document, 2);
  CHECK(failed->failed);
  CHECK(failed->stale);
  CHECK(x_of(failed->outputs.at("mesh")) == 5);
  f.set_factor(2, 4);
  CHECK(x_of(evaluate(evaluator, f.document, 2)->outputs.at("mesh")) == 4);
  CHECK(x_of(evaluator.last_good(2)->outputs.at("mesh")) == 4);
}

TEST_CASE("last good results are forgotten on request") {
  Fixture f;
  Evaluator evaluator(f.registry);
  evaluate(evaluator, f.document, 2);
  evaluator.forget_last_good();
  f.set_factor(2, -1);
  CHECK_FALSE(evaluate(evaluator, f.document, 2)->stale);
}

TEST_CASE("links in a circle are findings") {
  Fixture f;
  Evaluator evaluator(f.registry);
  f.document = f.document.with(operation_node("scale", {3, "mesh"}, 1, "behind"));
  f.link(2, {3, "mesh"});
  CHECK(codes(*evaluate(evaluator, f.document, 2)) == "E_CYCLE");
  CHECK(codes(*evaluate(evaluator, f.document, 3)) == "E_CYCLE");
  CHECK(codes(*evaluate(evaluator, f.document, 4)) == "E_CYCLE E_INPUT_FAILED");
  f.link(2, {2, "mesh"});
  CHECK(codes(*evaluate(evaluator, f.document, 2)) == "E_CYCLE");
  CHECK(codes(*evaluate(evaluator, f.document, 3)) == "E_CYCLE E_INPUT_FAILED");
}

TEST_CASE("links that lead nowhere are findings") {
  Fixture f;
  Evaluator evaluator(f.registry);
  f.link(2, {77, "mesh"});
  const auto nowhere = evaluate(evaluator, f.document, 2);
  REQUIRE(codes(*nowhere) == "E_LINK");
  CHECK(nowhere->findings[0].message.find("77") != std::string::npos);
  f.link(2, {1, "shadow"});
  CHECK(codes(*evaluate(evaluator, f.document, 2)) == "E_LINK");
  f.document = Fixture().document;
  Node node = *f.document.find(2);
  node.inputs["colour"] = {1, "value"};
  CHECK(codes(*evaluate(evaluator, f.document.with(node), 2)) == "E_LINK");
  node.inputs.clear();
  CHECK(codes(*evaluate(evaluator, f.document.with(node), 2)) == "E_INPUT");
  CHECK(codes(*evaluate(evaluator, f.document, 9)) == "E_NODE");
}

TEST_CASE("values, parameters and operations that don't fit are findings") {
  Fixture f;
  Evaluator evaluator(f.registry);
  const auto code_of = [&](const auto& change) {
    Node node = *f.document.find(2);
    change(node);
    return codes(*evaluate(evaluator, f.document.with(node), 2));
  };
  CHECK(code_of([](Node& n) { n.operation = "twist"; }) == "E_OPERATION_UNKNOWN");
  CHECK(code_of([](Node& n) { n.version = 2; }) == "E_OPERATION_NEWER");
  CHECK(code_of([](Node& n) { n.version = 0; }) == "W_SCALED W_OPERATION_OLDER");
  CHECK(code_of([](Node& n) { n.operation.clear(); }) == "E_NO_VALUE");
  CHECK(code_of([](Node& n) { n.source = std::shared_ptr<const PolyMesh>(); }) == "E_NO_VALUE");
  CHECK(code_of([](Node& n) { n.parameters["factor"] = 11.0; }) == "E_PARAMETER");
  CHECK(code_of([](Node& n) { n.parameters["twist"] = 1.0; }) == "E_PARAMETER");
  const Document drawn = f.document.with([] {
    Node node = source_node(std::make_shared<const Drawing>());
    node.id = 1;
    return node;
  }());
  CHECK(codes(*evaluate(evaluator, drawn, 2)) == "E_INPUT");
}

TEST_CASE("whatever an operation throws is a finding") {
  Registry registry;
  Fixture f;
  int kind = 0;
  add_operation(registry, mesh_to_mesh("scale"), [&](const Values&, const ParameterValues&, Context&) {
    if (kind == 0) throw std::runtime_error("broken");
    if (kind == 1) throw std::bad_alloc();
    if (kind == 2) throw Cancelled();
    return OperationResult{};
  });
  for (const auto& code : {"E_INTERNAL", "E_MEMORY", "E_INTERNAL", "E_INTERNAL"}) {
    Evaluator evaluator(registry);
    const auto failed = evaluate(evaluator, f.document, 2);
    CHECK(failed->failed);
    CHECK(codes(*failed) == code);
    ++kind;
  }
}

TEST_CASE("a chain of many nodes is evaluated without deep recursion") {
  Fixture f;
  constexpr NodeId count = 20000;
  std::vector<std::shared_ptr<const Node>> nodes = {f.document.nodes()[0]};
  for (NodeId id = 2; id <= count; ++id) {
    Node node = operation_node("scale", {id - 1, id == 2 ? "value" : "mesh"}, id % 2 == 0 ? 2 : 0.5);
    node.id = id;
    nodes.push_back(std::make_shared<const Node>(node));
  }
  Evaluator evaluator(f.registry);
  CHECK(x_of(evaluate(evaluator, Document::of(nodes, 0), count)->outputs.at("mesh")) == 2);
  // The same nodes as one large circle.
  Node first = *nodes[1];
  first.inputs["mesh"] = {count, "mesh"};
  nodes[1] = std::make_shared<const Node>(first);
  CHECK(codes(*evaluate(evaluator, Document::of(nodes, 0), count)) == "E_CYCLE");
}

TEST_CASE("a cancelled evaluation throws and keeps nothing of the node under way") {
  Fixture f;
  Registry registry;
  std::atomic<bool> cancel = false;
  int calls = 0;
  add_operation(registry, mesh_to_mesh("scale"),
                [&](const Values& inputs, const ParameterValues& parameters, Context& context) {
                  ++calls;
                  if (calls == 2) cancel = true;
                  if (calls == 2) context.progress.check();
                  if (calls == 4) cancel = true;  // and doesn't notice
                  return test::scaled(inputs, parameters);
                });
  Evaluator evaluator(registry);
  const auto cancellable = [&] {
    Progress progress({}, &cancel);
    return evaluator.evaluate(f.document, 3, Quality::Final, progress);
  };
  CHECK_THROWS_AS(cancellable(), Cancelled);
  CHECK(calls == 2);
  CHECK_THROWS_AS(cancellable(), Cancelled);  // before anything is computed
  CHECK(calls == 2);
  cancel = false;
  CHECK(x_of(cancellable()->outputs.at("mesh")) == 6);  // the first node was kept
  CHECK(calls == 3);
  f.set_factor(3, 4);
  CHECK_THROWS_AS(cancellable(), Cancelled);
  cancel = false;
  CHECK(x_of(cancellable()->outputs.at("mesh")) == 8);
  CHECK(calls == 5);
}

TEST_CASE("progress never goes back and ends at 1") {
  Fixture f;
  Evaluator evaluator(f.registry);
  for (int i = 0; i < 2; ++i) {  // cold and warm
    double last = 0;
    bool back = false;
    Progress progress([&](double fraction, const std::string&) {
      back = back || fraction < last;
      last = fraction;
    });
    evaluator.evaluate(f.document, 3, Quality::Final, progress);
    CHECK_FALSE(back);
    CHECK(last == 1);
  }
}

TEST_CASE("an evaluation doesn't wait for one that takes long") {
  Registry registry;
  std::atomic<bool> release = false;
  std::atomic<bool> inside = false;
  add_operation(registry, mesh_to_mesh("scale"),
                [&](const Values& inputs, const ParameterValues& parameters, Context&) {
                  if (std::get<double>(parameters.at("factor")) == 7) {
                    inside = true;
                    while (!release) std::this_thread::yield();
                  }
                  return test::scaled(inputs, parameters);
                });
  Fixture f;
  Evaluator evaluator(registry);
  Document slow = f.document.with(operation_node("scale", {1, "value"}, 7));
  std::thread waiting([&] { evaluate(evaluator, slow, 4); });
  while (!inside) std::this_thread::yield();
  CHECK(x_of(evaluate(evaluator, slow, 3)->outputs.at("mesh")) == 6);
  release = true;
  waiting.join();
}

/// What a trial operation finds.
struct Found {
  double factor = 0;
};
std::size_t byte_size(const Found&) { return 100000; }

/// Scales, and fails for negative factors.
OperationResult scaled_with_details(const Values& inputs, const ParameterValues& parameters) {
  const double factor = std::get<double>(parameters.at("factor"));
  if (factor < 0) throw Error(make_error(Category::Geometry, "E_TRIAL", "It is negative."));
  OperationResult result = test::scaled(inputs, parameters);
  result.details = Found{factor};
  return result;
}

TEST_CASE("what an operation found goes with its outputs, and stays with them when they are stale") {
  Registry registry;
  add_operation(registry, mesh_to_mesh("scale"), [](const Values& inputs, const ParameterValues& parameters, Context&) {
    return scaled_with_details(inputs, parameters);
  });
  Evaluator evaluator(registry);
  const auto document_with = [](double factor) {
    return Document().with(source_node(point(1))).with(operation_node("scale", {1, "value"}, factor));
  };
  const auto good = evaluate(evaluator, document_with(3), 2);
  REQUIRE(good->result<Found>() != nullptr);
  CHECK(good->result<Found>()->factor == 3);
  CHECK(good->result<int>() == nullptr);
  CHECK(evaluator.bytes() > 100000);
  CHECK(evaluate(evaluator, document_with(3), 1)->result<Found>() == nullptr);

  const auto failed = evaluate(evaluator, document_with(-1), 2);
  REQUIRE((failed->failed && failed->stale));
  CHECK(x_of(failed->outputs.at("mesh")) == 3);
  REQUIRE(result_of<Found>(failed.get()) != nullptr);
  CHECK(result_of<Found>(failed.get())->factor == 3);
  CHECK(result_of<Found>(nullptr) == nullptr);
}

}  // namespace
}  // namespace croquis

// SPDX-License-Identifier: GPL-3.0-or-later
#include <atomic>
#include <thread>
#include <vector>

#include <catch2/catch.hpp>

#include "croquis/document/evaluator.h"
#include "croquis/document/memo.h"
#include "support/random.h"
#include "support/trial_operation.h"

namespace croquis {
namespace {

using test::add_operation;
using test::mesh_to_mesh;
using test::operation_node;
using test::point;
using test::source_node;
using test::x_of;

/// Operations that count how often they compute.
struct Counting {
  Registry registry;
  std::atomic<int> calls = 0;
  std::atomic<int> stages = 0;
  Document document;

  Counting() {
    add_operation(registry, mesh_to_mesh("scale"),
                  [this](const Values& inputs, const ParameterValues& parameters, Context&) {
                    ++calls;
                    return test::scaled(inputs, parameters);
                  });
    add_operation(registry, mesh_to_mesh("staged"),
                  [this](const Values& inputs, const ParameterValues& parameters, Context& context) {
                    ++calls;
                    return staged(inputs, parameters, context);
                  });
    document = Document()
                   .with(source_node(point(1)))
                   .with(operation_node("scale", {1, "value"}, 2))
                   .with(operation_node("scale", {2, "mesh"}, 3));
  }

  /// A stage of the input alone, as slow ones should be: (x + 1) is kept, then scaled.
  OperationResult staged(const Values& inputs, const ParameterValues& parameters, Context& context) {
    ContentHasher hasher;
    hasher.add("staged 1 plus");
    hasher.add(content_hash(inputs.at("mesh")));
    const auto plus = memoized<double>(
        context.memo, hasher.digest(),
        [&] {
          ++stages;
          return x_of(inputs.at("mesh")) + 1;
        },
        [](double) { return sizeof(double); });
    return test::scaled({{"mesh", point(*plus)}}, parameters);
  }

  int computed(Evaluator& evaluator, const Document& edited, NodeId id, Quality quality = Quality::Final) {
    const int before = calls;
    Progress progress;
    last = evaluator.evaluate(edited, id, quality, progress);
    return calls - before;
  }
  std::shared_ptr<const Evaluation> last;
};

Document with_factor(const Document& document, NodeId id, double factor) {
  Node node = *document.find(id);
  node.parameters["factor"] = factor;
  return document.with(node);
}

TEST_CASE("only what depends on a change is computed again") {
  Counting c;
  Evaluator evaluator(c.registry);
  CHECK(c.computed(evaluator, c.document, 3) == 2);
  CHECK(c.computed(evaluator, c.document, 3) == 0);
  CHECK(c.computed(evaluator, c.document, 2) == 0);
  CHECK(c.computed(evaluator, with_factor(c.document, 3, 5), 3) == 1);
  CHECK(c.computed(evaluator, with_factor(c.document, 2, 5), 3) == 2);
  CHECK(c.computed(evaluator, c.document, 3) == 0);  // back, as after undo
  CHECK(x_of(c.last->outputs.at("mesh")) == 6);
}

TEST_CASE("results are found by content: names, new copies and explicit defaults change nothing") {
  Counting c;
  Evaluator evaluator(c.registry);
  c.computed(evaluator, c.document, 3);
  Node node = *c.document.find(2);
  node.name = "other";
  node.visible = false;
  node.parameters.clear();  // 2 is the default
  CHECK(c.computed(evaluator, c.document.with(node), 3) == 0);
  Node source = *c.document.find(1);
  source.source = point(1);
  CHECK(c.computed(evaluator, c.document.with(source), 3) == 0);
  source.source = point(2);
  CHECK(c.computed(evaluator, c.document.with(source), 3) == 2);
  const Document elsewhere =
      Document().with(source_node(point(9))).with(source_node(point(1))).with(operation_node("scale", {2, "value"}, 2));
  CHECK(c.computed(evaluator, elsewhere, 3) == 0);
}

TEST_CASE("a node that two others use is computed once") {
  Counting c;
  OperationDescription two = mesh_to_mesh("join");
  two.inputs.push_back({"other", ValueType::Mesh, "The other mesh."});
  add_operation(c.registry, two, [](const Values& inputs, const ParameterValues&, Context&) {
    return OperationResult{{{"mesh", point(x_of(inputs.at("mesh")) * 100 + x_of(inputs.at("other")))}}, {}};
  });
  Node join = operation_node("join", {2, "mesh"}, 1);
  join.inputs["other"] = {3, "mesh"};
  Evaluator evaluator(c.registry);
  CHECK(c.computed(evaluator, c.document.with(join), 4) == 2);
  CHECK(x_of(c.last->outputs.at("mesh")) == 206);
}

TEST_CASE("drafts are kept beside final results, and a final result serves as a draft") {
  Counting c;
  Evaluator evaluator(c.registry);
  CHECK(c.computed(evaluator, c.document, 3, Quality::Draft) == 2);
  CHECK(c.last->quality == Quality::Draft);
  CHECK(c.computed(evaluator, c.document, 3, Quality::Draft) == 0);
  CHECK(c.computed(evaluator, c.document, 3, Quality::Final) == 2);
  CHECK(c.last->quality == Quality::Final);
  const ContentHash final_key = c.last->key;
  CHECK(c.computed(evaluator, c.document, 3, Quality::Draft) == 0);
  CHECK(c.last->quality == Quality::Final);
  CHECK(c.last->key == final_key);
  // A draft of what depends on a final result uses that one.
  CHECK(c.computed(evaluator, with_factor(c.document, 3, 5), 3, Quality::Draft) == 1);
}

TEST_CASE("failures are kept, running out of memory is not") {
  Counting c;
  bool memory = false;
  int failures = 0;
  add_operation(c.registry, mesh_to_mesh("fail"),
                [&](const Values&, const ParameterValues&, Context&) -> OperationResult {
                  ++failures;
                  if (memory) throw std::bad_alloc();
                  throw std::runtime_error("no");
                });
  Evaluator evaluator(c.registry);
  const Document document = c.document.with(operation_node("fail", {1, "value"}, 1));
  c.computed(evaluator, document, 4);
  c.computed(evaluator, document, 4);
  CHECK(failures == 1);
  memory = true;
  c.computed(evaluator, with_factor(document, 4, 2), 4);
  c.computed(evaluator, with_factor(document, 4, 2), 4);
  CHECK(failures == 3);
}

TEST_CASE("results above the byte cap are thrown away, and come out the same when they are asked for again") {
  Counting c;
  constexpr std::size_t cap = 20000;
  Evaluator small(c.registry, cap);
  Evaluator none(c.registry, 0);
  Evaluator large(c.registry);
  test::Random random(1);
  for (int i = 0; i < 200; ++i) {
    const Document document = with_factor(c.document, 2 + random.below(2), 0.25 * random.below(40));
    c.computed(small, document, 3);
    const ContentHash kept = content_hash(c.last->outputs.at("mesh"));
    CHECK(small.bytes() <= cap);
    CHECK(c.computed(none, document, 3) == 2);
    CHECK(content_hash(c.last->outputs.at("mesh")) == kept);
    c.computed(large, document, 3);
    CHECK(content_hash(c.last->outputs.at("mesh")) == kept);
  }
  CHECK(none.bytes() == 0);
  CHECK(large.bytes() > cap);
}

TEST_CASE("stages are kept while other parameters change, and change no result") {
  Counting c;
  const Document document = c.document.with(operation_node("staged", {1, "value"}, 2));
  Evaluator warm(c.registry);
  for (int i = 0; i < 10; ++i) {
    const Document edited = with_factor(document, 4, 0.5 * i);
    c.computed(warm, edited, 4);
    const ContentHash hash = content_hash(c.last->outputs.at("mesh"));
    CHECK(c.stages == i + 1);  // the first one, and one of each cold evaluator
    Evaluator cold(c.registry);
    c.computed(cold, edited, 4);
    CHECK(content_hash(c.last->outputs.at("mesh")) == hash);
  }
}

TEST_CASE("many threads may evaluate at once") {
  Counting c;
  Evaluator evaluator(c.registry, 20000);
  std::atomic<int> wrong = 0;
  std::vector<std::thread> threads;
  for (std::uint64_t seed = 0; seed < 4; ++seed) {
    threads.emplace_back([&, seed] {
      test::Random random(seed);
      for (int i = 0; i < 200; ++i) {
        const double factor = 0.25 * random.below(40);
        Progress progress;
        const auto result = evaluator.evaluate(with_factor(c.document, 2, factor), 3,
                                               random.below(2) == 0 ? Quality::Draft : Quality::Final, progress);
        if (x_of(result->outputs.at("mesh")) != 3 * factor) ++wrong;
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  CHECK(wrong == 0);
}

}  // namespace
}  // namespace croquis

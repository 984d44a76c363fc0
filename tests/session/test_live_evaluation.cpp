// SPDX-License-Identifier: GPL-3.0-or-later
#include <atomic>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include <catch2/catch.hpp>

#include "croquis/session/live_evaluation.h"
#include "support/main_loop.h"
#include "support/trial_operation.h"

namespace croquis {
namespace {

using test::x_of;

/// "scale" by 7 is stubborn: it ignores its cancelling until it is released. "scale" by 8 waits to be cancelled.
/// Drafts are 1000 too large.
struct Fixture {
  Registry registry;
  std::optional<Evaluator> evaluator;
  test::MainLoop loop;
  std::atomic<bool> release = false;
  std::atomic<int> inside = 0;  ///< computations under way that wait
  std::string heard;            ///< d or f with the result's x, then "+" and "-" for busy and idle
  std::vector<double> fractions;
  std::optional<LiveEvaluation> live;

  Fixture() {
    test::add_operation(registry, test::mesh_to_mesh("scale"),
                        [this](const Values& inputs, const ParameterValues& parameters, Context& context) {
                          const double factor = std::get<double>(parameters.at("factor"));
                          if (factor == 7) wait([] {});
                          if (factor == 8) wait([&] { context.progress.check(); });
                          for (int i = 1; i <= 10; ++i) context.progress.report(0.1 * i);
                          const double extra = context.quality == Quality::Draft ? 1000 : 0;
                          return OperationResult{{{"mesh", test::point(x_of(inputs.at("mesh")) * factor + extra)}}, {}};
                        });
    evaluator.emplace(registry);
    LiveEvaluation::Callbacks callbacks;
    callbacks.result = [this](NodeId, const std::shared_ptr<const Evaluation>& evaluation, Quality quality) {
      const bool value = evaluation->outputs.contains("value");
      const int x = static_cast<int>(x_of(evaluation->outputs.at(value ? "value" : "mesh")));
      heard += (quality == Quality::Draft ? "d" : "f") + std::to_string(x) + " ";
    };
    callbacks.progress = [this](double fraction, const std::string&) { fractions.push_back(fraction); };
    callbacks.busy = [this](bool busy) { heard += busy ? "+ " : "- "; };
    live.emplace(*evaluator, loop.post(), callbacks);
  }
  ~Fixture() {
    release = true;  // whatever a failing test left waiting
    live.reset();
  }

  void wait(const std::function<void()>& check) {
    struct Inside {
      std::atomic<int>& count;
      explicit Inside(std::atomic<int>& counter) : count(counter) { ++count; }
      ~Inside() { --count; }
    } guard(inside);
    while (!release) {
      check();
      std::this_thread::yield();
    }
  }

  /// Node 2 is node 1 (x = 1) times the factor.
  void request(double factor, NodeId node = 2) {
    live->request(
        Document().with(test::source_node(test::point(1))).with(test::operation_node("scale", {1, "value"}, factor)),
        node);
  }
  void finish() {
    loop.run_until([this] { return !live->busy(); });
    loop.run_all();
  }
  void await_inside(int count) {
    while (inside != count) std::this_thread::yield();
  }
};

TEST_CASE("a request is answered with a draft and then with the final result") {
  Fixture f;
  CHECK_FALSE(f.live->busy());
  f.request(3);
  CHECK(f.live->busy());
  CHECK(f.heard.empty());  // nothing but through the loop
  f.finish();
  CHECK(f.heard == "+ d1003 f3 - ");
}

TEST_CASE("a final result that is at hand needs no draft") {
  Fixture f;
  f.request(3);
  f.finish();
  f.heard.clear();
  f.request(3);
  f.finish();
  CHECK(f.heard == "+ f3 - ");
  f.heard.clear();
  f.request(3, 1);
  f.finish();
  CHECK(f.heard == "+ f1 - ");
}

TEST_CASE("a failed node and one that isn't there are answered too") {
  Fixture f;
  LiveEvaluation::Callbacks callbacks;
  std::string codes;
  callbacks.result = [&](NodeId, const std::shared_ptr<const Evaluation>& evaluation, Quality) {
    codes += evaluation->findings.at(0).code + " ";
  };
  f.live.emplace(*f.evaluator, f.loop.post(), callbacks);
  f.request(99);
  f.finish();
  f.request(3, 44);
  f.finish();
  CHECK(codes == "E_PARAMETER E_PARAMETER E_NODE E_NODE ");
}

TEST_CASE("the newest request wins and stale results are dropped") {
  Fixture f;
  f.request(8);
  f.await_inside(1);
  for (int factor = 2; factor < 6; ++factor) f.request(factor);
  f.finish();
  CHECK(f.heard == "+ d1005 f5 - ");
}

TEST_CASE("a result that was posted before a newer request came is dropped") {
  Fixture f;
  f.request(3);
  // The draft and the final result are in the queue, beside busy and at least one progress.
  while (f.evaluator->bytes() == 0 || f.loop.waiting() < 4) std::this_thread::yield();
  f.request(4);
  f.finish();
  CHECK(f.heard == "+ d1004 f4 - ");
}

TEST_CASE("cancelling answers at once, even while a computation ignores it, whose result is dropped") {
  Fixture f;
  f.request(7);
  f.await_inside(1);
  f.live->cancel();
  CHECK_FALSE(f.live->busy());
  f.loop.run_all();
  CHECK(f.inside == 1);  // still at it
  CHECK(f.heard.find_first_of("df") == std::string::npos);
  f.release = true;
  f.await_inside(0);
  f.request(2);
  f.finish();
  CHECK(f.heard.find("7 ") == std::string::npos);
  CHECK(f.heard.ends_with("d1002 f2 - "));
}

TEST_CASE("a request doesn't wait for an abandoned computation that ignores its cancelling") {
  Fixture f;
  f.request(7);
  f.await_inside(1);
  f.request(3);
  f.finish();
  CHECK(f.inside == 1);
  CHECK(f.heard == "+ d1003 f3 - ");
}

TEST_CASE("stubborn computations are bounded, and the newest request follows when one of them ends") {
  Fixture f;
  constexpr int all = static_cast<int>(LiveEvaluation::max_workers);
  for (int i = 1; i <= all; ++i) {
    f.request(7);
    f.await_inside(i);
  }
  for (int i = 0; i < 20; ++i) f.request(2);
  f.request(3);
  f.loop.run_all();
  CHECK(f.inside == all);
  CHECK(f.live->busy());
  CHECK(f.heard == "+ ");
  f.release = true;
  f.finish();
  CHECK(f.heard == "+ d1003 f3 - ");
}

TEST_CASE("cancelling nothing is nothing, and cancelling a waiting request is its end") {
  Fixture f;
  f.live->cancel();
  f.loop.run_all();
  CHECK(f.heard.empty());
  f.request(8);
  f.live->cancel();
  f.live->cancel();
  f.loop.run_all();
  CHECK_FALSE(f.live->busy());
  CHECK(f.heard.find_first_of("df") == std::string::npos);
}

TEST_CASE("progress never goes back within a request and doesn't flood the loop") {
  Fixture f;
  f.request(3);
  while (f.loop.waiting() < 4) std::this_thread::yield();
  // Of dozens of reports in two evaluations, one waits at a time.
  CHECK(f.loop.waiting() == 4);
  f.finish();
  REQUIRE_FALSE(f.fractions.empty());
  f.request(4);
  f.finish();
  f.fractions.clear();
  for (int i = 0; i < 20; ++i) {
    f.request(0.25 * i);
    f.finish();
    CHECK(std::is_sorted(f.fractions.begin(), f.fractions.end()));
    for (const double fraction : f.fractions) CHECK((fraction >= 0 && fraction <= 1));
    f.fractions.clear();
  }
}

TEST_CASE("no callback runs after destruction, whatever is still in the loop") {
  Fixture f;
  f.request(3);
  while (f.loop.waiting() < 4) std::this_thread::yield();
  f.live.reset();
  f.loop.run_all();
  CHECK(f.heard.empty());
  CHECK(f.fractions.empty());
}

TEST_CASE("destruction ends computations that listen") {
  Fixture f;
  f.request(8);
  f.await_inside(1);
  f.live.reset();
  CHECK(f.inside == 0);
  f.loop.run_all();
  CHECK(f.heard.empty());
}

TEST_CASE("callbacks may request, cancel, and end the evaluation itself") {
  Fixture f;
  LiveEvaluation::Callbacks callbacks;
  callbacks.result = [&](NodeId, const std::shared_ptr<const Evaluation>& evaluation, Quality quality) {
    const int x = static_cast<int>(x_of(evaluation->outputs.at("mesh")));
    f.heard += std::to_string(x) + " ";
    if (x == 3) f.request(4);
    if (x == 4) f.live->cancel();
    if (x == 5 && quality == Quality::Final) f.live.reset();
  };
  callbacks.busy = [&](bool busy) { f.heard += busy ? "+ " : "- "; };
  f.live.emplace(*f.evaluator, f.loop.post(), callbacks);
  f.request(3);
  f.finish();
  CHECK(f.heard == "+ 1003 3 1004 4 - ");
  f.heard.clear();
  f.request(5);
  f.loop.run_until([&] { return !f.live; });
  f.loop.run_all();
  CHECK(f.heard == "+ 1005 5 ");
}

TEST_CASE("a storm of requests and cancels ends with the last answer") {
  Fixture f;
  for (int i = 0; i < 300; ++i) {
    f.request(i % 3 == 0 ? 8 : 0.01 * i);
    if (i % 7 == 0) f.live->cancel();
    if (i % 5 == 0) f.loop.run_all();
  }
  f.request(6);
  f.finish();
  CHECK(f.heard.ends_with("d1006 f6 - "));
}

}  // namespace
}  // namespace croquis

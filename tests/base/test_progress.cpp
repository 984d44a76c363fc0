// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <thread>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>

#include "croquis/base/error.h"
#include "croquis/base/progress.h"

using namespace croquis;

namespace {

struct Recorder {
  std::vector<std::pair<double, std::string>> reports;

  Progress::Sink sink() {
    return [this](double fraction, const std::string& step) { reports.emplace_back(fraction, step); };
  }

  bool rises_within_bounds() const {
    const bool sorted =
        std::is_sorted(reports.begin(), reports.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    return sorted && std::all_of(reports.begin(), reports.end(),
                                 [](const auto& report) { return report.first >= 0 && report.first <= 1; });
  }
};

}  // namespace

TEST_CASE("a progress without a sink takes reports and never cancels") {
  Progress progress;
  Progress part = progress.step("part", 0.5);
  part.report(0.3);
  part.check();
  progress.report(1);
  CHECK_FALSE(progress.cancelled());
}

TEST_CASE("steps one after the other fill their shares and end at one") {
  Recorder recorder;
  Progress progress(recorder.sink());
  Progress first = progress.step("first", 0.25);
  first.report(0.5);
  first.report(1);
  Progress second = progress.step("second", 0.75);
  second.report(0.5);
  second.report(1);
  const std::vector<std::pair<double, std::string>> expected = {{0.0, "first"},   {0.125, "first"},  {0.25, "first"},
                                                                {0.25, "second"}, {0.625, "second"}, {1.0, "second"}};
  CHECK(recorder.reports == expected);
}

TEST_CASE("nested steps stay in the share of their parents") {
  Recorder recorder;
  Progress progress(recorder.sink());
  progress.step("before", 0.5);
  Progress outer = progress.step("outer", 0.5);
  Progress inner = outer.step("inner", 0.5);
  Progress innermost = inner.step("innermost", 0.5);
  innermost.report(1);
  CHECK(recorder.reports.back() == std::pair<double, std::string>(0.625, "innermost"));
  inner.report(1);
  CHECK(recorder.reports.back() == std::pair<double, std::string>(0.75, "inner"));
  outer.report(1);
  CHECK(recorder.reports.back() == std::pair<double, std::string>(1.0, "outer"));
}

TEST_CASE("skipped and abandoned steps leave no gap and nothing goes backwards") {
  Recorder recorder;
  Progress progress(recorder.sink());
  progress.step("skipped", 0.2);
  Progress abandoned = progress.step("abandoned", 0.3);
  abandoned.report(0.1);
  Progress last = progress.step("last", 0.5);
  CHECK(recorder.reports.back() == std::pair<double, std::string>(0.5, "last"));
  last.report(0.8);
  abandoned.report(0.2);  // late: must not be seen as a step back
  last.report(0.2);
  CHECK(recorder.reports.back().first == 0.9);
  CHECK(recorder.rises_within_bounds());
}

TEST_CASE("fractions and shares out of range are held to the range") {
  Recorder recorder;
  Progress progress(recorder.sink());
  for (const double fraction : {-1.0, 0.25, std::nan(""), 7.0, std::numeric_limits<double>::infinity()}) {
    progress.report(fraction);
  }
  CHECK(recorder.rises_within_bounds());
  CHECK(recorder.reports.back().first == 1.0);

  Recorder greedy;
  Progress whole(greedy.sink());
  for (int i = 0; i < 4; ++i) whole.step("too much", 0.4).report(1);
  CHECK(greedy.rises_within_bounds());
  CHECK(greedy.reports.back().first == 1.0);
}

TEST_CASE("a share that is negative or no number gives an empty step") {
  for (const double share : {-0.5, std::nan(""), -std::numeric_limits<double>::infinity()}) {
    Recorder recorder;
    Progress progress(recorder.sink());
    progress.step("half", 0.5).report(1);
    progress.step("odd", share).report(1);
    CHECK(recorder.reports.back().first == 0.5);
    progress.step("rest", 0.5).report(1);
    CHECK(recorder.reports.back().first == 1.0);
    CHECK(recorder.rises_within_bounds());
  }
}

TEST_CASE("many nested uneven steps rise and end at exactly one") {
  for (int parts = 1; parts <= 30; ++parts) {
    Recorder recorder;
    Progress progress(recorder.sink());
    for (int i = 0; i < parts; ++i) {
      Progress part = progress.step("part", 1.0 / parts);
      for (int k = 0; k < 7; ++k) part.step("piece", 1.0 / 7).report(1);
      part.report(1);
    }
    progress.report(1);
    CHECK(recorder.rises_within_bounds());
    CHECK(recorder.reports.back().first == 1.0);
  }
}

TEST_CASE("cancelling stops every report, check and new step, and stays") {
  std::atomic<bool> cancel{false};
  Recorder recorder;
  Progress progress(recorder.sink(), &cancel);
  Progress part = progress.step("part", 0.5);
  part.report(0.5);
  const std::size_t seen = recorder.reports.size();
  cancel = true;
  for (int i = 0; i < 3; ++i) {
    CHECK(progress.cancelled());
    CHECK(part.cancelled());
    CHECK_THROWS_AS(part.report(0.6), Cancelled);
    CHECK_THROWS_AS(progress.check(), Cancelled);
    CHECK_THROWS_AS(part.step("inner", 0.5), Cancelled);
  }
  CHECK(recorder.reports.size() == seen);
}

TEST_CASE("cancelling before the start lets nothing happen") {
  const std::atomic<bool> cancel{true};
  Recorder recorder;
  Progress progress(recorder.sink(), &cancel);
  CHECK_THROWS_AS(progress.step("first", 1), Cancelled);
  CHECK(recorder.reports.empty());
}

TEST_CASE("another thread can cancel") {
  std::atomic<bool> cancel{false};
  Progress progress({}, &cancel);
  std::thread host([&] { cancel = true; });
  const auto work = [&] {
    while (true) progress.check();
  };
  CHECK_THROWS_AS(work(), Cancelled);
  host.join();
}

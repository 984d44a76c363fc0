// SPDX-License-Identifier: GPL-3.0-or-later
#include <atomic>
#include <stdexcept>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "croquis/base/error.h"
#include "croquis/base/parallel.h"

namespace croquis {
namespace {

TEST_CASE("every element is worked on once, whatever threads and grain") {
  for (const int threads : {0, 1, 2, 8}) {
    for (const std::size_t grain : {std::size_t{1}, std::size_t{7}, std::size_t{1000}}) {
      std::vector<int> times(1001, 0);
      Progress progress;
      for_each_part(times.size(), grain, threads, progress, [&](std::size_t begin, std::size_t end) {
        if (end - begin > grain) return;  // its elements would be missing
        for (std::size_t i = begin; i < end; ++i) ++times[i];
      });
      CHECK(times == std::vector<int>(1001, 1));
    }
  }
}

TEST_CASE("the lowest failure is passed on, for any number of threads") {
  for (const int threads : {1, 2, 8}) {
    for (int run = 0; run < 20; ++run) {
      Progress progress;
      const auto work = [](std::size_t begin, std::size_t) {
        if (begin >= 40) throw std::runtime_error(std::to_string(begin));
      };
      CHECK_THROWS_WITH(for_each_part(200, 1, threads, progress, work), "40");
    }
  }
}

TEST_CASE("cancelling ends the work before its end, and progress rises to 1") {
  for (const int threads : {1, 4}) {
    std::atomic<bool> cancel = false;
    std::atomic<int> done = 0;
    Progress progress({}, &cancel);
    CHECK_THROWS_AS(for_each_part(100000, 1, threads, progress,
                                  [&](std::size_t, std::size_t) {
                                    if (++done == 50) cancel = true;
                                  }),
                    Cancelled);
    CHECK(done < 100000);
    std::vector<double> seen;
    Progress told([&](double fraction, const std::string&) { seen.push_back(fraction); });
    for_each_part(100, 1, threads, told, [](std::size_t, std::size_t) {});
    CHECK(seen.back() == 1);
    for (std::size_t i = 1; i < seen.size(); ++i) CHECK(seen[i] >= seen[i - 1]);
  }
}

TEST_CASE("an even grain gives every thread one part at most, and none fewer elements than are worth it") {
  for (const std::size_t count :
       {std::size_t{0}, std::size_t{1}, std::size_t{99}, std::size_t{100}, std::size_t{1001}}) {
    for (const int threads : {1, 2, 3, 8}) {
      const std::size_t grain = even_grain(count, threads, 100);
      std::vector<int> times(count, 0);
      std::atomic<int> parts = 0;
      for_each_part(count, grain, threads, [&](std::size_t begin, std::size_t end) {
        ++parts;
        for (std::size_t i = begin; i < end; ++i) ++times[i];
      });
      CHECK(times == std::vector<int>(count, 1));
      CHECK(parts <= threads);
      CHECK((parts <= 1 || grain >= 100));
      if (count >= 1000 && threads <= 8) CHECK(parts == threads);
    }
  }
}

}  // namespace
}  // namespace croquis

// SPDX-License-Identifier: GPL-3.0-or-later
#include <atomic>
#include <string>
#include <thread>
#include <vector>

#include <catch2/catch.hpp>

#include "croquis/document/memo.h"
#include "support/random.h"

namespace croquis {
namespace {

ContentHash key(std::uint64_t number) { return {0, number}; }

std::size_t hundred(const auto&) { return 100; }

/// Room for `count` results of 100 bytes.
std::size_t room_for(std::size_t count) { return count * (100 + Memo::entry_bytes); }

int get(Memo& memo, std::uint64_t number, int& calls) {
  const auto make = [&] {
    ++calls;
    return static_cast<int>(number) * 10;
  };
  return *memo.get<int>(key(number), make, hundred<int>);
}

TEST_CASE("a result is made once") {
  Memo memo;
  int calls = 0;
  CHECK(get(memo, 1, calls) == 10);
  CHECK(get(memo, 1, calls) == 10);
  CHECK(get(memo, 2, calls) == 20);
  CHECK(calls == 2);
  CHECK(memo.bytes() == room_for(2));
  memo.clear();
  CHECK(memo.bytes() == 0);
  CHECK(get(memo, 1, calls) == 10);
  CHECK(calls == 3);
}

TEST_CASE("the least recently used results go first") {
  Memo memo(room_for(3));
  int calls = 0;
  for (const std::uint64_t number : {1U, 2U, 3U, 1U, 4U}) get(memo, number, calls);
  CHECK(memo.find<int>(key(1)));
  CHECK_FALSE(memo.find<int>(key(2)));
  CHECK(memo.find<int>(key(3)));
  CHECK(memo.find<int>(key(4)));
  CHECK(memo.bytes() == room_for(3));
}

TEST_CASE("a result that is too large is handed out and not kept, and throws nothing else away") {
  Memo memo(room_for(2));
  int calls = 0;
  get(memo, 1, calls);
  const auto large = memo.get<std::string>(
      key(2), [] { return std::string("large"); }, [](const std::string&) { return room_for(2); });
  CHECK(*large == "large");
  CHECK_FALSE(memo.find<std::string>(key(2)));
  CHECK(memo.find<int>(key(1)));
  Memo none(0);
  CHECK(get(none, 1, calls) == 10);
  CHECK(none.bytes() == 0);
}

TEST_CASE("another cap throws away what is beyond it at once, the least recently used first") {
  Memo memo(room_for(4));
  int calls = 0;
  for (const std::uint64_t number : {1U, 2U, 3U, 4U, 1U}) get(memo, number, calls);
  memo.set_byte_cap(room_for(2));
  CHECK(memo.bytes() == room_for(2));
  CHECK(memo.find<int>(key(1)));
  CHECK(memo.find<int>(key(4)));
  memo.set_byte_cap(0);
  CHECK(memo.bytes() == 0);
  CHECK(get(memo, 5, calls) == 50);
  CHECK(memo.bytes() == 0);
  memo.set_byte_cap(room_for(1));
  get(memo, 5, calls);
  CHECK(memo.bytes() == room_for(1));
}

TEST_CASE("a size that overflows any sum isn't kept") {
  Memo memo(room_for(2));
  memo.get<int>(
      key(1), [] { return 1; }, [](int) { return std::numeric_limits<std::size_t>::max(); });
  CHECK(memo.bytes() == 0);
}

TEST_CASE("what is thrown away lives on with those who hold it") {
  Memo memo(room_for(1));
  int calls = 0;
  const auto held = memo.get<int>(
      key(1), [] { return 7; }, hundred<int>);
  get(memo, 2, calls);
  CHECK_FALSE(memo.find<int>(key(1)));
  CHECK(*held == 7);
}

TEST_CASE("results of different types don't meet under one key") {
  Memo memo;
  memo.get<int>(
      key(1), [] { return 7; }, hundred<int>);
  const auto text = memo.get<std::string>(
      key(1), [] { return std::string("seven"); }, hundred<std::string>);
  CHECK(*text == "seven");
  CHECK(*memo.find<int>(key(1)) == 7);
  CHECK_FALSE(memo.find<double>(key(1)));
}

TEST_CASE("a maker may use the memo, and what it throws keeps nothing") {
  Memo memo;
  int calls = 0;
  const auto outer = memo.get<int>(
      key(1), [&] { return get(memo, 2, calls) + 1; }, hundred<int>);
  CHECK(*outer == 21);
  CHECK_THROWS_AS(memo.get<int>(
                      key(3), []() -> int { throw std::runtime_error("no"); }, hundred<int>),
                  std::runtime_error);
  CHECK_FALSE(memo.find<int>(key(3)));
  CHECK(get(memo, 3, calls) == 30);
}

TEST_CASE("without a memo everything is made") {
  int calls = 0;
  for (int i = 0; i < 2; ++i) {
    const auto make = [&] { return ++calls; };
    CHECK(*memoized<int>(nullptr, key(1), make, hundred<int>) == i + 1);
  }
  Memo memo;
  for (int i = 0; i < 2; ++i) {
    const auto make = [&] { return ++calls; };
    CHECK(*memoized<int>(&memo, key(1), make, hundred<int>) == 3);
  }
}

TEST_CASE("many threads get the right results within the cap") {
  Memo memo(room_for(20));
  std::atomic<int> wrong = 0;
  std::atomic<int> above = 0;
  std::vector<std::thread> threads;
  for (std::uint64_t seed = 0; seed < 4; ++seed) {
    threads.emplace_back([&, seed] {
      test::Random random(seed);
      int calls = 0;
      for (int i = 0; i < 3000; ++i) {
        const std::uint64_t number = random.below(40);
        if (get(memo, number, calls) != static_cast<int>(number) * 10) ++wrong;
        if (memo.bytes() > room_for(20)) ++above;
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  CHECK(wrong == 0);
  CHECK(above == 0);
  CHECK(memo.bytes() == room_for(20));
}

}  // namespace
}  // namespace croquis

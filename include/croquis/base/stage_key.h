// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "croquis/base/members.h"
#include "croquis/base/stage_cache.h"

namespace croquis {

/// Numbers of which the type knows how many there are, as vectors of geometry.
template <typename T>
concept FixedNumbers = (T::SizeAtCompileTime > 0) && std::is_arithmetic_v<typename T::Scalar>;

/// Writes byte by byte what a stage's result depends on, for a StageCache. Lists and texts bring their length along, so
/// that pieces can't be shifted from one into the next. Keys are for the run alone, they are never stored.
class StageKey {
 public:
  template <typename Number>
  requires std::is_arithmetic_v<Number> || std::is_enum_v<Number> StageKey& add(Number number) {
    bytes_.append(reinterpret_cast<const char*>(&number), sizeof number);
    return *this;
  }
  template <FixedNumbers Vector>
  StageKey& add(const Vector& vector) {
    for (const auto number : vector) add(number);
    return *this;
  }
  StageKey& add(std::string_view text) {
    add(text.size());
    bytes_.append(text);
    return *this;
  }
  StageKey& add(const std::string& text) { return add(std::string_view(text)); }
  StageKey& add(const char* text) { return add(std::string_view(text)); }
  template <typename T, std::size_t Size>
  StageKey& add(const std::array<T, Size>& elements) {
    for (const T& element : elements) add(element);
    return *this;
  }
  template <typename T>
  StageKey& add(const std::vector<T>& list) {
    add(list.size());
    for (const T& element : list) add(element);
    return *this;
  }
  template <typename Key, typename Value>
  StageKey& add(const std::map<Key, Value>& map) {
    add(map.size());
    for (const auto& [key, value] : map) add(key).add(value);
    return *this;
  }
  template <typename First, typename Second>
  StageKey& add(const std::pair<First, Second>& pair) {
    return add(pair.first).add(pair.second);
  }
  /// Every member that the struct lists.
  template <HasMemberList Options>
  StageKey& add(const Options& options) {
    std::apply([this](const auto&... member) { (add(member), ...); }, members(options));
    return *this;
  }

  const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
};

/// The result of a stage from the cache, or made; without a cache always made.
/// @param make  returns a Result
/// @param bytes estimates the memory of a const Result&
template <typename Result, typename Make, typename Bytes>
std::shared_ptr<const Result> cached(StageCache* cache, std::string_view stage, const StageKey& key, Make&& make,
                                     Bytes&& bytes) {
  if (cache == nullptr) return std::make_shared<const Result>(std::forward<Make>(make)());
  return std::static_pointer_cast<const Result>(cache->get(stage, key.bytes(), [&] {
    auto result = std::make_shared<const Result>(make());
    const std::size_t size = bytes(*result);
    return StageCache::Stage{std::move(result), size};
  }));
}

/// What the cache holds of a stage, or null: for results that are made many at a time.
template <typename Result>
std::shared_ptr<const Result> kept(StageCache* cache, std::string_view stage, const StageKey& key) {
  struct NotKept {};
  if (cache == nullptr) return nullptr;
  try {
    return std::static_pointer_cast<const Result>(
        cache->get(stage, key.bytes(), []() -> StageCache::Stage { throw NotKept(); }));
  } catch (const NotKept&) {
    return nullptr;
  }
}

}  // namespace croquis

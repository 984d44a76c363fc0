// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <set>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>

#include "croquis/base/members.h"

/// Options with one member changed, for each member: whether all of them count.
namespace croquis::test {

/// Another value, near to the one given, so that it is still in range.
template <typename Value>
Value changed(const Value& value) {
  if constexpr (std::is_same_v<Value, bool>) {
    return !value;
  } else if constexpr (std::is_enum_v<Value>) {
    return value == Value{} ? static_cast<Value>(1) : Value{};
  } else if constexpr (std::is_integral_v<Value>) {
    return static_cast<Value>(value + 1);
  } else if constexpr (std::is_floating_point_v<Value>) {
    return value == 0 ? Value(0.25) : value * Value(0.875);
  } else if constexpr (HasMemberList<Value>) {
    Value other = value;
    auto& first = std::get<0>(members(other));
    const_cast<std::remove_cvref_t<decltype(first)>&>(first) = changed(first);
    return other;
  } else {
    Value longer = value;  // a list
    using Element = typename Value::value_type;
    if constexpr (requires { Element::Zero(); }) {
      longer.push_back(Element::Zero());  // vectors begin without values
    } else {
      longer.push_back({});
    }
    return longer;
  }
}

template <typename Options, std::size_t... I>
std::vector<Options> changes_of(const Options& options, std::index_sequence<I...>) {
  std::vector<Options> changes;
  const auto add = [&](auto index) {
    Options other = options;
    const auto& member = std::get<decltype(index)::value>(members(other));
    const_cast<std::remove_cvref_t<decltype(member)>&>(member) = changed(member);
    changes.push_back(std::move(other));
  };
  (add(std::integral_constant<std::size_t, I>{}), ...);
  return changes;
}

/// One copy for each member, in which that one is changed.
template <typename Options>
std::vector<Options> changes_of(const Options& options) {
  constexpr std::size_t count = std::tuple_size_v<decltype(members(options))>;
  // The compiler sees to it that as many are listed as there are; none may be listed twice.
  const auto places =
      std::apply([](const auto&... member) { return std::set<const void*>{static_cast<const void*>(&member)...}; },
                 members(options));
  CHECK(places.size() == count);
  return changes_of(options, std::make_index_sequence<count>());
}

}  // namespace croquis::test

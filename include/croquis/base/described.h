// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <numbers>
#include <optional>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "croquis/base/members.h"
#include "croquis/base/report.h"

/// Reports of structs whose members have names: what an algorithm returns is what `--json` writes.
///
/// A struct S names its members by a function beside it,
///
///     inline auto described(const S& s) { return fields(named("name", s.name), named("edges", s.edges)); }
///
/// and `static_assert(describes_every_member<S>)` behind it fails to compile when a member is forgotten. Enumerations
/// have a to_string(E) beside them.
namespace croquis {

/// A member's name and value: one that was computed is held, another one referred to.
template <typename T>
struct Field {
  const char* name;
  T value;
};

template <typename T>
constexpr Field<T> named(const char* name, T&& value) {
  return {name, std::forward<T>(value)};
}

template <typename... T>
struct FieldList {
  std::tuple<Field<T>...> list;
};

template <typename... T>
constexpr FieldList<T...> fields(Field<T>... list) {
  return {{std::move(list)...}};
}

template <typename S>
concept Described = requires(const S& s) {
  described(s);
};

template <typename... T>
constexpr std::size_t field_count(const FieldList<T...>*) {
  return sizeof...(T);
}

template <Described S>
inline constexpr bool describes_every_member =
    field_count(static_cast<const decltype(described(std::declval<const S&>()))*>(nullptr)) == member_count<S>();

/// As reports have angles.
constexpr double in_degrees(double radians) { return radians * (180 / std::numbers::pi); }
constexpr std::optional<double> in_degrees(const std::optional<double>& radians) {
  return radians ? std::optional(in_degrees(*radians)) : std::nullopt;
}

template <typename T>
Report to_report(const T& value);

template <typename... T>
Report to_report(const FieldList<T...>& all) {
  Report::Object members;
  std::apply([&](const auto&... field) { (members.emplace_back(field.name, to_report(field.value)), ...); }, all.list);
  return Report::of_members(std::move(members));
}

/// An object of a described struct or of pairs of a name and a value, null of an absent value, a word of an
/// enumeration, an array of any other list.
template <typename T>
Report to_report(const T& value) {
  if constexpr (Described<T>) {
    return to_report(described(value));
  } else if constexpr (std::is_constructible_v<Report, const T&>) {
    return Report(value);
  } else if constexpr (std::is_enum_v<T>) {
    return Report(to_string(value));
  } else if constexpr (requires { value.has_value(); }) {
    return value ? to_report(*value) : Report();
  } else if constexpr (requires { value.begin()->second; }) {
    Report::Object members;
    for (const auto& [name, member] : value) members.emplace_back(name, to_report(member));
    return Report::of_members(std::move(members));
  } else {
    Report list = Report::array();
    for (const auto& element : value) list.push(to_report(element));
    return list;
  }
}

/// What a value takes besides its own size.
template <typename T>
std::size_t heap_size(const T& value) {
  std::size_t bytes = 0;
  if constexpr (Described<T>) {
    std::apply([&](const auto&... field) { ((bytes += heap_size(field.value)), ...); }, described(value).list);
  } else if constexpr (requires { value.has_value(); }) {
    if (value) bytes = heap_size(*value);
  } else if constexpr (!std::is_trivially_copyable_v<T> && requires { value.begin(); }) {
    if constexpr (requires { value.capacity(); }) bytes = value.capacity() * sizeof *value.begin();
    if constexpr (!std::is_arithmetic_v<std::remove_cvref_t<decltype(*value.begin())>>)
      for (const auto& element : value) bytes += heap_size(element);
  } else if constexpr (requires { value.second; }) {
    bytes = heap_size(value.first) + heap_size(value.second);
  }
  return bytes;
}

/// Of the results of operations, see ResultBox.
template <Described Result>
std::size_t byte_size(const Result& result) {
  return sizeof(Result) + heap_size(result);
}

}  // namespace croquis

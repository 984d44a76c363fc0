// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include <Eigen/Core>

#include "croquis/base/limits.h"
#include "croquis/base/members.h"
#include "document/content_size.h"
#include "document/values/value_row.h"

/// Bytes, hashes and sizes of structs, made from the lists of their members (base/members.h): member by member in the
/// order of the list, so that this order is part of project files and never changes.
///
/// Numbers have their own width, flags and enumerations 1 byte, vectors and matrices their coefficients column by
/// column; texts, lists and maps begin with a count, what may be absent with a flag, alternatives with their number. A
/// list that names all members by a structured binding is complete as well: std::optional keeps lists_every_member from
/// counting. Beside an enumeration has to stand, beside a struct may stand
///
///     constexpr Enum last_of(Enum);       // its last value
///     void require_valid(const Struct&);  // of what was read: throws BadBytes
namespace croquis {

template <typename T, template <typename...> class Template>
inline constexpr bool is_made_of = false;
template <template <typename...> class Template, typename... Arguments>
inline constexpr bool is_made_of<Template<Arguments...>, Template> = true;

template <typename T>
concept FixedMatrix = std::is_base_of_v<Eigen::MatrixBase<T>, T>;

template <typename T>
inline constexpr bool is_array = false;
template <typename T, std::size_t N>
inline constexpr bool is_array<std::array<T, N>> = true;

/// Lists of plain numbers are copied as a whole.
template <typename T>
inline constexpr bool is_number_list = false;
template <typename T>
inline constexpr bool is_number_list<std::vector<T>> = std::is_arithmetic_v<T>;

/// Types whose coordinates may be any numbers, also those that nothing can be computed with (limits.h).
template <typename T>
inline constexpr bool holds_any_number = false;

/// What an absent number or vector adds to a hash behind its flag.
enum class Absent { Nothing, Zero };

/// The members of a struct or of a std::tie.
template <typename T>
auto members_of(const T& value) {
  if constexpr (is_made_of<T, std::tuple>) {
    return value;
  } else {
    return members(value);
  }
}

/// The same list, to give the members other values.
template <typename T>
auto members_to_set(T& value) {
  return std::apply(
      [](const auto&... member) { return std::tie(const_cast<std::remove_cvref_t<decltype(member)>&>(member)...); },
      members(std::as_const(value)));
}

// ---- Writing

template <typename T>
void store_member(const T& value, ByteWriter& writer) {
  const auto store_each = [&](const auto& elements) {
    for (const auto& element : elements) store_member(element, writer);
  };
  if constexpr (std::is_same_v<T, std::monostate>) {
    return;
  } else if constexpr (std::is_same_v<T, bool>) {
    writer.flag(value);
  } else if constexpr (std::is_enum_v<T>) {
    writer.number(static_cast<std::uint8_t>(value));
  } else if constexpr (std::is_arithmetic_v<T>) {
    writer.number(value);
  } else if constexpr (std::is_same_v<T, std::string>) {
    writer.text(value);
  } else if constexpr (FixedMatrix<T>) {
    for (const double number : value.reshaped()) writer.number(number);
  } else if constexpr (is_number_list<T>) {
    writer.numbers(value);
  } else if constexpr (is_array<T>) {
    store_each(value);
  } else if constexpr (is_made_of<T, std::vector> || is_made_of<T, std::map>) {
    writer.count(value.size());
    store_each(value);
  } else if constexpr (is_made_of<T, std::optional>) {
    writer.flag(value.has_value());
    if (value) store_member(*value, writer);
  } else if constexpr (is_made_of<T, std::variant>) {
    writer.number(static_cast<std::uint8_t>(value.index()));
    std::visit([&](const auto& held) { store_member(held, writer); }, value);
  } else if constexpr (is_made_of<T, std::pair>) {
    store_member(value.first, writer);
    store_member(value.second, writer);
  } else {
    std::apply([&](const auto&... member) { (store_member(member, writer), ...); }, members_of(value));
  }
}

// ---- Reading

/// The fewest bytes that a value of the type takes: counts are checked with it.
template <typename T>
constexpr std::size_t least_bytes() {
  if constexpr (std::is_same_v<T, bool> || std::is_enum_v<T> || is_made_of<T, std::optional>) {
    return 1;
  } else if constexpr (std::is_arithmetic_v<T>) {
    return sizeof(T);
  } else if constexpr (FixedMatrix<T>) {
    return T::SizeAtCompileTime * sizeof(double);
  } else if constexpr (is_array<T>) {
    return std::tuple_size_v<T> * least_bytes<typename T::value_type>();
  } else if constexpr (std::is_same_v<T, std::string> || is_made_of<T, std::vector> || is_made_of<T, std::map>) {
    return sizeof(std::uint64_t);
  } else if constexpr (is_made_of<T, std::variant>) {
    return 1 + sizeof(std::uint64_t);  // of lists
  } else {
    return []<typename... Member>(std::type_identity<std::tuple<Member...>>) {
      return (least_bytes<std::remove_cvref_t<Member>>() + ...);
    }(std::type_identity<decltype(members(std::declval<const T&>()))>());
  }
}

/// What was written of a value of that type. @throws BadBytes
template <typename T, bool any_number = holds_any_number<T>>
T load_member(ByteReader& reader);

/// The alternative of a variant that has that number.
template <typename T, std::size_t I = 0>
T load_alternative(std::size_t number, ByteReader& reader) {
  if constexpr (I == std::variant_size_v<T>) {
    throw BadBytes("a channel's type is not known");
  } else {
    return number == I ? T(load_member<std::variant_alternative_t<I, T>>(reader))
                       : load_alternative<T, I + 1>(number, reader);
  }
}

template <typename T, bool any_number>
T load_struct(ByteReader& reader) {
  T value;
  std::apply(
      [&]<typename... Member>(Member&... member) {
        ((member = load_member < Member, any_number || holds_any_number < Member >> (reader)), ...);
      },
      members_to_set(value));
  if constexpr (requires { require_valid(value); }) require_valid(value);
  return value;
}

template <typename T, bool any_number>
T load_member(ByteReader& reader) {
  if constexpr (std::is_same_v<T, bool>) {
    return reader.flag();
  } else if constexpr (std::is_enum_v<T>) {
    const auto number = reader.number<std::uint8_t>();
    if (number > static_cast<std::uint8_t>(last_of(T()))) throw BadBytes("a kind of something is not known");
    return static_cast<T>(number);
  } else if constexpr (std::is_arithmetic_v<T>) {
    return reader.number<T>();
  } else if constexpr (std::is_same_v<T, std::string>) {
    return reader.text();
  } else if constexpr (FixedMatrix<T>) {
    T numbers;
    for (double& number : numbers.reshaped()) number = reader.number<double>();
    if (!any_number && !are_usable_numbers(numbers.reshaped()))
      throw BadBytes(std::string("a number ") + unusable_words);
    return numbers;
  } else if constexpr (is_number_list<T>) {
    return reader.numbers<typename T::value_type>();
  } else if constexpr (is_array<T>) {
    T elements;
    for (auto& element : elements) element = load_member<typename T::value_type, any_number>(reader);
    return elements;
  } else if constexpr (is_made_of<T, std::vector>) {
    using Element = typename T::value_type;
    T elements;
    const std::size_t count = reader.count(least_bytes<Element>());
    // More memory than the bytes themselves take isn't set aside for a count that nothing proves.
    if (sizeof(Element) == least_bytes<Element>()) elements.reserve(count);
    for (std::size_t i = 0; i < count; ++i)
      elements.push_back(load_member < Element, any_number || holds_any_number < Element >> (reader));
    return elements;
  } else if constexpr (is_made_of<T, std::map>) {
    T entries;
    const std::size_t least = least_bytes<typename T::key_type>() + least_bytes<typename T::mapped_type>();
    for (std::size_t left = reader.count(least); left > 0; --left) {
      auto key = load_member<typename T::key_type>(reader);
      entries.insert_or_assign(std::move(key), load_member<typename T::mapped_type>(reader));
    }
    return entries;
  } else if constexpr (is_made_of<T, std::optional>) {
    return reader.flag() ? T(load_member<typename T::value_type>(reader)) : std::nullopt;
  } else if constexpr (is_made_of<T, std::variant>) {
    return load_alternative<T>(reader.number<std::uint8_t>(), reader);
  } else {
    return load_struct<T, any_number>(reader);
  }
}

// ---- Hash

template <Absent absent = Absent::Nothing, typename T>
void hash_member(const T& value, ContentHasher& hasher) {
  const auto hash_each = [&](const auto& elements) {
    for (const auto& element : elements) hash_member<absent>(element, hasher);
  };
  if constexpr (std::is_same_v<T, std::monostate>) {
    return;
  } else if constexpr (std::is_enum_v<T>) {
    hasher.add(static_cast<int>(value));
  } else if constexpr (std::is_arithmetic_v<T> || std::is_same_v<T, std::string>) {
    hasher.add(value);
  } else if constexpr (FixedMatrix<T>) {
    for (const double number : value.reshaped()) hasher.add(number);
  } else if constexpr (std::is_same_v<T, std::vector<std::uint32_t>>) {
    hasher.add(std::span<const std::uint32_t>(value));
  } else if constexpr (is_array<T>) {
    hash_each(value);
  } else if constexpr (is_made_of<T, std::vector> || is_made_of<T, std::map>) {
    hasher.add(value.size());
    hash_each(value);
  } else if constexpr (is_made_of<T, std::optional>) {
    hasher.add(value.has_value());
    if (value) {
      hash_member<absent>(*value, hasher);
    } else if constexpr (absent == Absent::Zero && FixedMatrix<typename T::value_type>) {
      hash_member(T::value_type::Zero().eval(), hasher);
    } else if constexpr (absent == Absent::Zero && std::is_arithmetic_v<typename T::value_type>) {
      hash_member(typename T::value_type(0), hasher);
    }
  } else if constexpr (is_made_of<T, std::variant>) {
    hasher.add(value.index());
    std::visit(
        [&]<typename Held>(const Held& held) {
          if constexpr (is_number_list<Held>) {
            hasher.add(std::as_bytes(std::span(held)));
          } else {
            hash_member<absent>(held, hasher);
          }
        },
        value);
  } else if constexpr (is_made_of<T, std::pair>) {
    hash_member<absent>(value.first, hasher);
    hash_member<absent>(value.second, hasher);
  } else {
    std::apply([&](const auto&... member) { (hash_member<absent>(member, hasher), ...); }, members_of(value));
  }
}

// ---- Size

/// The memory that a value takes beside the object itself.
template <typename T>
std::size_t held_bytes(const T& value) {
  std::size_t bytes = 0;
  const auto add_each = [&](const auto& elements) {
    for (const auto& element : elements) bytes += held_bytes(element);
  };
  if constexpr (std::is_same_v<T, std::string>) {
    bytes = value.capacity();
  } else if constexpr (is_number_list<T>) {
    bytes = size_of(value);
  } else if constexpr (is_made_of<T, std::vector>) {
    bytes = size_of(value);
    add_each(value);
  } else if constexpr (is_made_of<T, std::map>) {
    bytes = value.size() * (tree_node + sizeof(typename T::value_type));
    add_each(value);
  } else if constexpr (is_made_of<T, std::optional>) {
    if (value) bytes = held_bytes(*value);
  } else if constexpr (is_made_of<T, std::variant>) {
    bytes = std::visit([](const auto& held) { return held_bytes(held); }, value);
  } else if constexpr (is_made_of<T, std::pair>) {
    bytes = held_bytes(value.first) + held_bytes(value.second);
  } else if constexpr (!std::is_arithmetic_v<T> && !std::is_enum_v<T> && !FixedMatrix<T> && !is_array<T> &&
                       !std::is_same_v<T, std::monostate>) {
    std::apply([&](const auto&... member) { bytes = (held_bytes(member) + ...); }, members_of(value));
  }
  return bytes;
}

/// What a definition (value_row.h) need not say for a struct that lists its members in their one layout.
template <typename Struct>
struct ListedValue {
  using Content = Struct;
  static constexpr std::uint32_t layout = 1;

  static void add_content(const Struct& content, ContentHasher& hasher) { hash_member(content, hasher); }
  static std::size_t byte_size(const Struct& content) { return sizeof(Struct) + held_bytes(content); }

  static void store(const Struct& content, ByteWriter& writer) {
    writer.number(layout);
    store_member(content, writer);
  }

  static Struct load(ByteReader& reader) {
    read_layout(reader, layout);
    return load_member<Struct>(reader);
  }
};

}  // namespace croquis

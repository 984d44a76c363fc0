// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <tuple>
#include <type_traits>
#include <utility>

/// Lists of a struct's members, for what has to look at all of them: keys of stages are made of such lists.
///
/// A struct S lists its members by a function `members(const S&)` beside it, which returns a std::tie of all of them.
/// `static_assert(lists_every_member<S>)` behind it fails to compile when a member is forgotten.
namespace croquis {

/// Stands for a member of any type but its own struct.
template <typename Owner>
struct AnyMember {
  template <typename Member>
  requires(!std::is_same_v<Member, Owner>) constexpr operator Member() const noexcept;
};

/// How many members the aggregate S has: with so many initializers it can be made, with one more not.
template <typename S, typename... Given>
consteval std::size_t member_count() {
  if constexpr (requires { S{Given{}..., AnyMember<S>{}}; }) {
    return member_count<S, Given..., AnyMember<S>>();
  } else {
    return sizeof...(Given);
  }
}

template <typename S>
concept HasMemberList = requires(const S& s) {
  members(s);
};

template <typename S>
inline constexpr bool lists_every_member = std::tuple_size_v<decltype(members(std::declval<const S&>()))> ==
                                           member_count<S>();

}  // namespace croquis

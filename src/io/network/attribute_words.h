// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "croquis/geometry/attribute_network.h"

/// The words of the format croquis-abs/1.
namespace croquis {

inline constexpr const char* attribute_network_format = "croquis-abs/1";

inline constexpr std::array<const char*, 2> join_words = {"crease", "smooth"};
inline constexpr std::array<const char*, 3> mode_words = {"smooth", "position", "paper"};
inline constexpr std::array<const char*, 2> domain_words = {"chordlength", "uniform"};
inline constexpr std::array<const char*, 2> point_profile_words = {"smooth", "cone"};
inline constexpr std::array<const char*, 2> inner_profile_words = {"smooth", "sharp"};

template <typename Enum, std::size_t N>
const char* word_of(Enum kind, const std::array<const char*, N>& words) {
  return words[static_cast<std::size_t>(kind)];
}

template <typename Enum, std::size_t N>
std::optional<Enum> kind_of(std::string_view word, const std::array<const char*, N>& words) {
  for (std::size_t i = 0; i < N; ++i) {
    if (word == words[i]) return static_cast<Enum>(i);
  }
  return std::nullopt;
}

}  // namespace croquis

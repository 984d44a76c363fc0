// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

/// What the containers of contents take beside the objects that they are in.
namespace croquis {

/// A tree node's pointers and colour beside its content, as libstdc++ and libc++ lay it out.
inline constexpr std::size_t tree_node = 32;

inline std::size_t size_of(const std::string& text) { return sizeof(std::string) + text.capacity(); }

template <class T>
std::size_t size_of(const std::vector<T>& plain) {
  return plain.capacity() * sizeof(T);
}

inline std::size_t size_of(const std::map<std::string, std::string>& texts) {
  std::size_t bytes = 0;
  for (const auto& [key, text] : texts) bytes += tree_node + size_of(key) + size_of(text);
  return bytes;
}

}  // namespace croquis

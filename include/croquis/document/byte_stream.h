// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

/// The canonical form of values in project files: fixed-width little-endian numbers, and 64-bit counts before lists.
namespace croquis {

/// Bytes that don't follow the form. Turned into findings by the project reader, which knows whose bytes they were.
class BadBytes : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

template <typename T>
std::array<char, sizeof(T)> little_endian(T value) {
  static_assert(std::is_arithmetic_v<T>);
  auto bytes = std::bit_cast<std::array<char, sizeof(T)>>(value);
  if constexpr (std::endian::native == std::endian::big) std::reverse(bytes.begin(), bytes.end());
  return bytes;
}

template <typename T>
T from_little_endian(std::array<char, sizeof(T)> bytes) {
  if constexpr (std::endian::native == std::endian::big) std::reverse(bytes.begin(), bytes.end());
  return std::bit_cast<T>(bytes);
}

class ByteWriter {
 public:
  template <typename T>
  void number(T value) {
    const auto bytes = little_endian(value);
    bytes_.append(bytes.data(), bytes.size());
  }

  void flag(bool value) { number<std::uint8_t>(value ? 1 : 0); }
  void count(std::size_t value) { number<std::uint64_t>(value); }

  void text(std::string_view value) {
    count(value.size());
    bytes_.append(value);
  }

  /// The count, then the numbers.
  template <typename T>
  void numbers(const std::vector<T>& values) {
    count(values.size());
    if constexpr (std::endian::native == std::endian::little) {
      bytes_.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
    } else {
      for (const T value : values) number(value);
    }
  }

  void texts(const std::map<std::string, std::string>& values) {
    count(values.size());
    for (const auto& [key, value] : values) {
      text(key);
      text(value);
    }
  }

  std::string take() { return std::move(bytes_); }

 private:
  std::string bytes_;
};

/// Reads what ByteWriter wrote. Every count is compared with the bytes that are left before anything is allocated.
/// All members throw BadBytes.
class ByteReader {
 public:
  explicit ByteReader(std::string_view bytes) : rest_(bytes) {}

  template <typename T>
  T number() {
    std::array<char, sizeof(T)> bytes;
    std::memcpy(bytes.data(), take(sizeof(T)).data(), sizeof(T));
    return from_little_endian<T>(bytes);
  }

  bool flag() {
    const auto value = number<std::uint8_t>();
    if (value > 1) throw BadBytes("a flag is neither 0 nor 1");
    return value == 1;
  }

  /// @param least bytes that one element takes at least (1 or more)
  std::size_t count(std::size_t least) {
    const auto value = number<std::uint64_t>();
    if (value > rest_.size() / least) throw BadBytes("a count is larger than what follows");
    return static_cast<std::size_t>(value);
  }

  std::string text() { return std::string(take(count(1))); }

  template <typename T>
  std::vector<T> numbers() {
    std::vector<T> values(count(sizeof(T)));
    const std::string_view bytes = take(values.size() * sizeof(T));
    if (!bytes.empty()) std::memcpy(values.data(), bytes.data(), bytes.size());
    if constexpr (std::endian::native == std::endian::big) {
      for (T& value : values) value = from_little_endian<T>(std::bit_cast<std::array<char, sizeof(T)>>(value));
    }
    return values;
  }

  std::map<std::string, std::string> texts() {
    std::map<std::string, std::string> values;
    for (std::size_t left = count(16); left > 0; --left) {
      std::string key = text();
      values.insert_or_assign(std::move(key), text());
    }
    return values;
  }

  /// Nothing may follow the value.
  void finish() const {
    if (!rest_.empty()) throw BadBytes("bytes follow the value");
  }

 private:
  std::string_view take(std::size_t length) {
    if (length > rest_.size()) throw BadBytes("it ends too early");
    const std::string_view taken = rest_.substr(0, length);
    rest_.remove_prefix(length);
    return taken;
  }

  std::string_view rest_;
};

}  // namespace croquis

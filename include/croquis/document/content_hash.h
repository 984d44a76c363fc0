// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <compare>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string_view>

#include "croquis/document/value.h"

/// Fingerprints of contents: equal contents have equal hashes on every machine, and with 128 bits two different
/// contents never meet by chance. They are no protection against somebody who makes contents meet on purpose.
namespace croquis {

class Document;

struct ContentHash {
  std::uint64_t high = 0;
  std::uint64_t low = 0;

  friend auto operator<=>(const ContentHash&, const ContentHash&) = default;
};

/// Takes one piece after the other. XXH3, 128 bits, seed 0 (the xxHash library's own documentation).
///
/// Texts and arrays bring their length along, so that pieces can't be shifted from one into the next; numbers bring
/// 8 bytes, least significant first. Doubles count by their bits: 0 and -0 differ.
class ContentHasher {
 public:
  ContentHasher();
  ~ContentHasher();
  ContentHasher(const ContentHasher&) = delete;
  ContentHasher& operator=(const ContentHasher&) = delete;

  void add(std::string_view text);
  void add(std::span<const std::byte> bytes);
  void add(std::span<const double> numbers);
  void add(std::span<const std::uint32_t> numbers);
  void add(double number);
  void add(const ContentHash& hash);

  template <std::integral Integer>
  void add(Integer number) {
    add_integer(static_cast<std::uint64_t>(number));
  }

  /// Of all pieces so far; more may follow.
  ContentHash digest() const;

 private:
  struct State;

  void add_integer(std::uint64_t number);

  std::unique_ptr<State> state_;
};

/// Of everything in the value that a computation can see, names of files and their lines included; its type too.
/// O(bytes of the value).
ContentHash content_hash(const Value& value);

/// Of everything people see in the document: its nodes with their ids and their order. Two documents of equal hash
/// differ at most in the id that the next new node gets. O(bytes of all sources).
ContentHash content_hash(const Document& document);

}  // namespace croquis

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace croquis {

/// What is wrong in an attribute's text, and at which byte of it.
struct SvgTextError {
  std::string message;
  std::size_t position = 0;
  bool limit = false;  ///< nothing wrong, but too much of it
};

/// Walks over the numbers, flags and words of an SVG attribute.
class SvgScanner {
 public:
  explicit SvgScanner(std::string_view text) : text_(text) {}

  void skip_blanks();
  void skip_separators();  ///< blanks with at most one comma among them

  bool at_end() const { return position_ == text_.size(); }
  char peek() const { return at_end() ? '\0' : text_[position_]; }
  char take() { return text_[position_++]; }
  std::size_t position() const { return position_; }

  /// The next number as SVG writes them ("1.5.5" are two, "1-2" are two). Too large ones are infinite; the words NaN
  /// and Infinity are read too, so that they can be refused by their own name.
  /// Nothing, and nothing consumed, when there is none.
  std::optional<double> number();

  /// A single 0 or 1, which needs no separator after it.
  std::optional<bool> flag();

  /// Letters, for names of transforms and units.
  std::string_view word();

 private:
  std::size_t skip_digits(std::size_t from) const;
  std::size_t end_of_number() const;
  std::optional<double> number_word();

  std::string_view text_;
  std::size_t position_ = 0;
};

}  // namespace croquis

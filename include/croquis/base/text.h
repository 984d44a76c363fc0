// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <charconv>
#include <concepts>
#include <cstddef>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

/// Small texts that people write and read: lists, numbers, counts.
namespace croquis {

/// The parts of a text between separators, without empty ones. They refer to the text.
/// @param separators any of these characters separates
std::vector<std::string_view> text_parts(std::string_view text, std::string_view separators);

/// The shortest decimal text that reads back as the same number; the same in every locale.
std::string number_text(double number);

/// A number rounded to so many significant digits, up to 17.
std::string number_text(double number, int digits);

/// Reads a number of which the whole text consists, without blanks or a leading '+'.
/// @param number is given the value, rounded to the nearest one there is; "inf" and "nan" are numbers too
/// @return false for any other text, and for a number that doesn't fit
template <typename Number>
requires std::integral<Number> || std::floating_point<Number>
bool read_number(std::string_view text, Number& number) {
  const char* end = text.data() + text.size();
  const auto [stopped, error] = std::from_chars(text.data(), end, number);
  return error == std::errc{} && stopped == end;
}

/// "1 hole", "2 holes".
std::string counted(std::size_t count, const std::string& one, const std::string& many);

}  // namespace croquis

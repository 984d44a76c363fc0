// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>

#include "croquis/base/text.h"

/// What is accepted from outside: by every reader of files, every typed parameter and every check of a value before it
/// is worked with. What lies beyond is refused there, by the name of the element, so that no algorithm has to expect
/// it.
namespace croquis {

/// The largest size of a number. Areas reach 1e60, volumes 1e90, the products of ten coordinates in geometric
/// predicates 1e300: all of them are finite numbers.
inline constexpr double largest_number = 1e30;

/// How deep lists, objects and groups may be nested, in JSON, in SVG and in projects. They are followed by recursion;
/// programs that draw stay below 30.
inline constexpr int deepest_nesting = 200;

/// The most pieces of curves, and samples of them, in one drawing: some hundred megabytes.
inline constexpr std::size_t most_curve_pieces = 4'000'000;

/// The most pixels of a picture that is read: 400 MB, and a sheet of A4 at 950 dots per inch.
inline constexpr std::size_t most_picture_pixels = 100'000'000;

/// How sentences say of a number that it can't be used: "vertex 3 has a coordinate that …".
inline constexpr const char* unusable_words = "isn't finite or is larger than 1e30";

/// False for NaN, the infinities and what is larger than largest_number.
inline bool is_usable_number(double number) { return std::abs(number) <= largest_number; }

/// Whether all can be used. @param numbers any range of them, such as a point
template <typename Numbers>
bool are_usable_numbers(const Numbers& numbers) {
  return std::all_of(numbers.begin(), numbers.end(), is_usable_number);
}

/// Reads a usable number of which the whole text consists, as read_number does.
inline std::optional<double> usable_number(std::string_view text) {
  double number = 0;
  return read_number(text, number) && is_usable_number(number) ? std::optional(number) : std::nullopt;
}

}  // namespace croquis

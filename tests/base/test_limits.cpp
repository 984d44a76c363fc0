// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cmath>
#include <limits>

#include <catch2/catch.hpp>

#include "croquis/base/limits.h"

namespace croquis::test {

constexpr double infinity = std::numeric_limits<double>::infinity();

TEST_CASE("the largest number that is accepted leaves room for the largest product that is made of ten") {
  CHECK(std::isfinite(1000 * std::pow(largest_number, 10)));
  CHECK_FALSE(std::isfinite(std::pow(std::nextafter(largest_number, infinity), 11)));
}

TEST_CASE("numbers are usable up to the largest one, with either sign") {
  for (const double number : {0.0, -0.0, 5e-324, 1e30, -1e30}) CHECK(is_usable_number(number));
  for (const double number : {std::nextafter(1e30, infinity), -1e31, 1e308, infinity, -infinity, std::nan("")})
    CHECK_FALSE(is_usable_number(number));
}

TEST_CASE("a range of numbers is usable when each of them is") {
  CHECK(are_usable_numbers(std::array{1.0, -1e30, 0.0}));
  CHECK(are_usable_numbers(std::array<double, 0>()));
  for (std::size_t place = 0; place < 3; ++place) {
    std::array numbers{1.0, 2.0, 3.0};
    numbers[place] = std::nan("");
    CHECK_FALSE(are_usable_numbers(numbers));
  }
}

TEST_CASE("text gives a usable number or none") {
  CHECK(usable_number("-1e30") == -1e30);
  CHECK(usable_number("0.5") == 0.5);
  for (const char* text : {"1e31", "nan", "inf", "-1e308", "1e999", "", "1x", "+1", " 1"})
    CHECK_FALSE(usable_number(text));
}

}  // namespace croquis::test

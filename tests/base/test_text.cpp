// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>

#include "croquis/base/index_list.h"
#include "croquis/base/text.h"

namespace croquis {
namespace {

TEST_CASE("parts of a text hold all but the separators, and none is empty") {
  for (const std::string text : {"", ",", "a", "a,b", ",;a,,b;c d;", " 0, 3-5 ;7 ", ";;;"}) {
    std::string kept, expected;
    for (const std::string_view part : text_parts(text, ",; ")) {
      CHECK_FALSE(part.empty());
      CHECK(part.find_first_of(",; ") == std::string_view::npos);
      kept += part;
    }
    for (const char c : text) {
      if (c != ',' && c != ';' && c != ' ') expected += c;
    }
    CHECK(kept == expected);
  }
  CHECK(text_parts("one  two", " ") == std::vector<std::string_view>{"one", "two"});
  CHECK(text_parts("no separator", "") == std::vector<std::string_view>{"no separator"});
}

TEST_CASE("a number's text reads back as the same number, in no more characters than 17 digits need") {
  for (const double number : {0.0, 0.1, 1.0 / 3, -2.5e-300, 123456789.0, 5e-324, std::numeric_limits<double>::max()}) {
    const std::string text = number_text(number);
    CHECK(std::strtod(text.c_str(), nullptr) == number);
    double read = -1;
    CHECK(read_number(text, read));
    CHECK(read == number);
  }
  CHECK(number_text(0.1) == "0.1");
  CHECK(number_text(1234.56, 4) == "1235");
}

TEST_CASE("only a text that is a number as a whole is read") {
  double number = 0;
  for (const char* text : {"", " 1", "1 ", "+1", "1,5", "1e999", "one"}) CHECK_FALSE(read_number(text, number));
  std::int64_t integer = 0;
  CHECK(read_number("-12", integer));
  CHECK(integer == -12);
  for (const char* text : {"1.5", "99999999999999999999", "0x10"}) CHECK_FALSE(read_number(text, integer));
}

TEST_CASE("numbers of elements are written as ranges, and read again") {
  const std::vector<std::pair<std::vector<std::uint32_t>, const char*>> lists{{{}, ""},
                                                                              {{7}, "7"},
                                                                              {{3, 4}, "3-4"},
                                                                              {{5, 6, 7, 2}, "5-7,2"},
                                                                              {{0, 2, 3, 4, 9}, "0,2-4,9"},
                                                                              {{2, 2, 1}, "2,2,1"}};
  for (const auto& [numbers, text] : lists) {
    CHECK(index_list_text(numbers, ',') == text);
    std::vector<std::uint32_t> read;
    std::string_view rest = text;
    while (!rest.empty()) {
      const std::size_t end = std::min(rest.find(','), rest.size());
      CHECK(append_indices(rest.substr(0, end), read));
      rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    CHECK(read == numbers);
  }
  std::vector<std::uint32_t> none;
  for (const char* wrong : {"", "-", "3-", "-3", "5-4", "a", "1-2-3", "0-10000000"})
    CHECK_FALSE(append_indices(wrong, none));
  CHECK(none.empty());
  CHECK(append_indices("1-10000000", none));
  CHECK(none.size() == 10000000);
}

TEST_CASE("one is counted in the singular, none and more in the plural") {
  CHECK(counted(0, "hole", "holes") == "0 holes");
  CHECK(counted(1, "hole", "holes") == "1 hole");
  CHECK(counted(2, "hole", "holes") == "2 holes");
}

}  // namespace
}  // namespace croquis

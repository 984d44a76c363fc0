// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/byte_size.h"

#include <cctype>
#include <charconv>
#include <cmath>
#include <string_view>

#include "croquis/base/error.h"

namespace croquis::cli {

std::int64_t parse_byte_size(const std::string& text) {
  double number = 0;
  const char* end = text.data() + text.size();
  const auto [stopped, error] = std::from_chars(text.data(), end, number);
  std::string_view suffix(stopped, static_cast<std::size_t>(end - stopped));
  if (suffix.ends_with("iB")) {
    suffix.remove_suffix(2);
  } else if (suffix.ends_with("B")) {
    suffix.remove_suffix(1);
  }
  constexpr std::string_view units = "KMGT";
  if (suffix.size() == 1) {
    const auto power = units.find(static_cast<char>(std::toupper(static_cast<unsigned char>(suffix[0]))));
    if (power != std::string_view::npos) {
      number *= std::pow(1024.0, static_cast<double>(power + 1));
      suffix = {};
    }
  }
  if (error != std::errc{} || !suffix.empty() || !(number >= 1) || number > 1e18) {
    throw Error(make_error(Category::Usage, "E_PARAMETER",
                           "'" + text + "' is no value for max-memory: it takes a size such as 512M or 2G.",
                           {{SubjectKind::Parameter, "max-memory", {}, {}, {}}}));
  }
  return static_cast<std::int64_t>(number);
}

}  // namespace croquis::cli

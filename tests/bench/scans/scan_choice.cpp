// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/scans/scan_choice.h"

#include <algorithm>
#include <cctype>
#include <stdexcept>

namespace croquis::bench {
namespace {

bool is_number(const std::string& word) {
  return !word.empty() && std::ranges::all_of(word, [](unsigned char c) { return std::isdigit(c) != 0; });
}

}  // namespace

ScanChoice scan_choice(const std::vector<std::string>& words) {
  ScanChoice choice;
  std::vector<test::ScanKind> kinds;
  std::size_t numbers = 0;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const auto kind =
        std::ranges::find_if(test::all_scan_kinds, [&](test::ScanKind k) { return name_of(k) == words[i]; });
    if (is_number(words[i]) && numbers < 2) {
      (numbers++ == 0 ? choice.first : choice.count) = std::stoull(words[i]);
    } else if (kind != test::all_scan_kinds.end()) {
      kinds.push_back(*kind);
    } else if (words[i] == "to" && i + 1 < words.size()) {
      choice.folder = words[++i];
    } else {
      throw std::invalid_argument("Words of scans: FIRST COUNT KIND… to FOLDER; not '" + words[i] + "'.");
    }
  }
  if (!kinds.empty()) choice.kinds = kinds;
  return choice;
}

}  // namespace croquis::bench

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "support/scans/known_scans.h"

namespace croquis::bench {

/// Which known scans a benchmark is about.
struct ScanChoice {
  std::uint64_t first = 1, count = 4;  ///< seeds, of every kind
  std::vector<test::ScanKind> kinds = {test::all_scan_kinds.begin(), test::all_scan_kinds.end()};
  std::string folder;  ///< for meshes to look at; empty: none are written
};

/// Words FIRST [COUNT] [KIND…] [to FOLDER], each of which may be left out.
/// @throws std::invalid_argument
ScanChoice scan_choice(const std::vector<std::string>& words);

}  // namespace croquis::bench

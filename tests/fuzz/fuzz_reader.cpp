// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "fuzz/readers.h"

/// The fuzzer of the reader that CROQUIS_FUZZED_READER names.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const croquis::test::FuzzedReader& reader = croquis::test::fuzzed_reader(CROQUIS_FUZZED_READER);
  const std::string broken = reader.verdict_on({reinterpret_cast<const char*>(data), size}).broken;
  if (broken.empty()) return 0;
  std::fprintf(stderr, "%s\n", broken.c_str());
  std::abort();
}

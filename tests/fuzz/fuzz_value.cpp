// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "fuzz/project_property.h"

/// The values in a project file, whose hashes keep the fuzzer of whole files from them. The first byte chooses the
/// kind.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const auto types = croquis::value_types();
  const croquis::ValueType type = types[data[0] % types.size()];
  const std::string broken = croquis::test::broken_value(type, {reinterpret_cast<const char*>(data) + 1, size - 1});
  if (broken.empty()) return 0;
  std::fprintf(stderr, "%s\n", broken.c_str());
  std::abort();
}

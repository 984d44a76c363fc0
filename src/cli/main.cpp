// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <string>
#include <vector>

#ifdef __GLIBC__
#include <malloc.h>
#endif

#include "cli/command_line.h"
#include "cli/runner.h"
#include "croquis/operators/all_operations.h"

namespace {

/// What one step gives back the next one takes: without this, memory for larger meshes would go to the system and come
/// back page by page, which costs as much as a step itself.
void keep_memory() {
#ifdef __GLIBC__
  mallopt(M_MMAP_THRESHOLD, 1 << 30);
  mallopt(M_TRIM_THRESHOLD, 1 << 30);
#endif
}

}  // namespace

int main(int argc, char** argv) {
  using namespace croquis;
  keep_memory();
  const std::vector<std::string> arguments(argv + std::min(argc, 1), argv + argc);
  const Registry registry = all_operations();
  const auto commands = cli::all_commands(registry);
  return cli::run(arguments, commands);
}

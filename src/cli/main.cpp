// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <string>
#include <vector>

#include "cli/command_line.h"
#include "cli/runner.h"
#include "croquis/operators/all_operations.h"

int main(int argc, char** argv) {
  using namespace croquis;
  const std::vector<std::string> arguments(argv + std::min(argc, 1), argv + argc);
  const Registry registry = all_operations();
  const auto commands = cli::all_commands(registry);
  return cli::run(arguments, commands);
}

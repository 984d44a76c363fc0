// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "support/scratch_folder.h"

/// The real croquis-cli, run as a stranger's script would.
namespace croquis::test {

struct ProcessResult {
  int code = -1;  ///< exit code, or -signal
  std::string out;
  std::string err;
  long peak_kilobytes = 0;             ///< 0 under sanitizers, which use more than the program
  double cpu_seconds = 0;              ///< processor time of the program, the system's on its behalf included
  double cpu_seconds_interrupted = 0;  ///< of these, those after it was interrupted
};

struct ProcessOptions {
  std::string standard_input = {};
  std::filesystem::path folder = {};  ///< where it runs; empty: here
  int interrupt_after_ms = 0;         ///< sends SIGINT after this, × slowness; 0: never
  std::string interrupt_at = {};      ///< sends SIGINT once the standard error has this; empty: never
};

/// Runs croquis-cli with these arguments to its end (killed after 60 s, × slowness).
ProcessResult run_cli(const std::vector<std::string>& arguments, const ProcessOptions& options = {});

/// The whole file.
std::string slurp(const std::filesystem::path& path);

}  // namespace croquis::test

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

/// The real croquis-cli, run as a stranger's script would.
namespace croquis::test {

struct ProcessResult {
  int code = -1;  ///< exit code, or -signal
  std::string out;
  std::string err;
  long peak_kilobytes = 0;
  double cpu_seconds = 0;  ///< processor time of the program, the system's on its behalf included
};

struct ProcessOptions {
  std::string standard_input = {};
  std::filesystem::path folder = {};  ///< where it runs; empty: here
  int interrupt_after_ms = 0;         ///< sends SIGINT after this; 0: never
};

/// Runs croquis-cli with these arguments to its end (killed after 60 s).
ProcessResult run_cli(const std::vector<std::string>& arguments, const ProcessOptions& options = {});

/// A new empty folder that is removed with its content at the end of the test.
class ScratchFolder {
 public:
  ScratchFolder();
  ~ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

  /// Writes a file into it and returns its path.
  std::string write(const std::string& name, const std::string& bytes) const;

  /// The path a file of that name would have.
  std::string operator/(const std::string& name) const { return (path_ / name).string(); }

  /// Names of everything in it, sorted.
  std::vector<std::string> names() const;

 private:
  std::filesystem::path path_;
};

/// The whole file.
std::string slurp(const std::filesystem::path& path);

}  // namespace croquis::test

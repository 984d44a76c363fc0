// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "croquis/base/parameter.h"
#include "croquis/base/progress.h"
#include "croquis/base/report.h"
#include "croquis/document/registry.h"
#include "croquis/geometry/mesh_report.h"

/// What every subcommand of croquis-cli is made of; the parser, the help and the runner use nothing else of them.
namespace croquis::cli {

enum class OutputNeed {
  None,      ///< the command prints, it writes no file
  Required,  ///< -o must be given
  Optional   ///< -o may be absent when another output is asked for
};

struct CommandDescription {
  std::string name;
  std::string sentence;
  bool needs_input = true;
  std::string input_word = "FILE";  ///< how the help calls the input
  OutputNeed output = OutputNeed::None;
  std::vector<ParameterDescription> parameters;
  std::vector<std::string> examples;  ///< whole command lines that work
};

/// What was typed: the subcommand's own parameters and the options that all share.
struct Invocation {
  std::string input;          ///< path, or "-" for standard input
  std::string output;         ///< path, "-" for standard output, or empty
  std::string input_format;   ///< empty: from the name
  std::string output_format;  ///< empty: from the name
  ParameterValues parameters;
  bool json = false;
  bool quiet = false;
  bool strict = false;
  std::string progress = "auto";
  std::int64_t threads = 1;
  std::int64_t seed = 0;
  std::int64_t memory_limit = 0;  ///< bytes, 0 for none
  double timeout = 0;             ///< seconds, 0 for none
};

/// The output of a command; filled as far as it came, also when it throws.
struct CommandResult {
  std::string text;  ///< for people, ends without a newline; the files that were written are listed besides
  std::optional<MeshReport> mesh;
  std::optional<Report> details;
  Findings warnings;
  std::map<std::string, std::string> files;  ///< bytes by path; written together when the command has succeeded
};

class Command {
 public:
  virtual ~Command() = default;

  virtual CommandDescription describe() const = 0;

  /// @throws Error, Cancelled
  virtual void run(const Invocation& invocation, CommandResult& result, Progress& progress) const = 0;
};

/// Every subcommand: one per operation, and those of the host itself. The registry must outlive them.
std::vector<std::unique_ptr<Command>> all_commands(const Registry& registry);

}  // namespace croquis::cli

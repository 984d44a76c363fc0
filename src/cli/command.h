// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <map>
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
  std::vector<ParameterDescription> parameters = {};
  std::vector<std::string> examples = {};  ///< whole command lines that work
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

/// A subcommand.
struct Command {
  CommandDescription description;
  /// @throws Error, Cancelled
  std::function<void(const Invocation&, CommandResult&, Progress&)> run;
};

/// `info`: what a mesh file holds.
Command info_command();
/// `check`: succeeds only for closed, manifold, oriented meshes without self-intersection.
Command check_command();
/// `convert`: from any mesh format to any other.
Command convert_command();
/// `render`: a picture of a mesh, without any display.
Command render_command();
/// `run`: evaluates a project and writes its visible meshes that no other visible mesh is made of.
Command run_command(const Registry& registry);
/// `operations`: every operation with its parameters, and the reference page.
Command operations_command(const Registry& registry);
/// `edits`: every edit with its parameters, and the reference page.
Command edits_command();

/// The subcommand of an operation, made from its description: parameters become options, the first output is -o, every
/// further output is an option of its name that writes a file, but for the report "details". Outputs that have no file
/// format are what follow-ups go on from, whose outputs and parameters are options as well. The first input is the
/// command's; every report among the further ones is an option of its name that reads a JSON file.
Command operation_command(const Operation& operation, const Registry& registry);

/// Every subcommand: one per operation, and those of the host itself. The registry must outlive them.
std::vector<Command> all_commands(const Registry& registry);

}  // namespace croquis::cli

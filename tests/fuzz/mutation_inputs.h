// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "support/random.h"

namespace croquis::test {

/// A file and the commands that are run on it.
struct MutationBase {
  std::string file;                   ///< below the project's folder; empty: a project of every kind of node is made
  std::vector<std::string> commands;  ///< arguments of croquis-cli, separated by blanks; {} is the input, {root} the
                                      ///< project's folder
};

/// One kind of input that is mutated.
struct MutationSystem {
  std::string name;
  std::vector<MutationBase> bases;
};

/// sketch, perspective, network, cage, scan, edits, project.
const std::vector<MutationSystem>& mutation_systems();

/// What croquis-cli is called with.
using Arguments = std::vector<std::string>;

struct MutatedInput {
  std::filesystem::path file;
  Arguments arguments;
};

/// Writes the input of that seed into the folder.
MutatedInput write_mutated_input(const MutationSystem& system, std::uint64_t seed, const std::filesystem::path& folder);

/// All commands of the system that take such a file, with this one.
std::vector<Arguments> commands_on(const MutationSystem& system, const std::filesystem::path& input);

}  // namespace croquis::test

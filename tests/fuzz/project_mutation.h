// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "support/random.h"

namespace croquis::test {

/// Changes the rows of a project file: one to three of them are dropped, doubled, mixed up, or given other values.
/// Stored contents are changed together with their hashes, so that readers get to see them.
void mutate_project(const std::filesystem::path& file, Random& random);

}  // namespace croquis::test

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "croquis/base/progress.h"
#include "croquis/io/project_file.h"
#include "io/project/database.h"

namespace croquis {

/// Everything in an open project that can be read; warnings name the rest.
/// @param database opened with one of Database::read…
/// @param types    of values that are known: nodes of others are left out
/// @throws Error E_PROJECT_VERSION, E_PROJECT_DAMAGED
/// @throws Cancelled
ProjectFile read_project_database(Database& database, const std::string& file_name, Progress& progress,
                                  std::span<const ValueType> types = value_types());

/// Its picture; empty when there is none, or something else in its place.
std::vector<std::uint8_t> read_thumbnail(const Database& database);

/// The value of a key in the table `meta`; empty when there is none.
std::string read_meta(const Database& database, const std::string& key);

}  // namespace croquis

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "io/project/database.h"

/// How a document lies in an SQLite database. docs/project-file.md describes it for other programs.
namespace croquis {

/// "CROQ": by this `file` and desktops recognise projects.
inline constexpr std::uint32_t project_application_id = 0x43524f51;

/// Raised with every change of the tables.
inline constexpr std::int64_t project_schema_version = 1;

/// SQLite itself ends at 2 GiB; parts of this size can also be read one at a time.
inline constexpr int max_chunk_bytes = 64 * 1024 * 1024;

/// The tables that this version knows.
inline constexpr std::array<std::string_view, 8> project_tables = {"meta",    "nodes", "parameters", "links",
                                                                   "sources", "blobs", "chunks",     "thumbnail"};

/// Makes the tables of a new database.
void create_schema(Database& database);

}  // namespace croquis

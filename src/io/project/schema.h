// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <set>
#include <string_view>

#include "io/project/database.h"

/// How a document lies in an SQLite database. docs/project-file.md describes it for other programs.
namespace croquis {

/// "CROQ": by this `file` and desktops recognise projects.
inline constexpr std::uint32_t project_application_id = 0x43524f51;

/// Raised with every change of the tables: the newest one that this version knows.
inline constexpr std::int64_t project_schema_version = 5;

/// SQLite itself ends at 2 GiB; parts of this size can also be read one at a time.
inline constexpr int max_chunk_bytes = 64 * 1024 * 1024;

/// The tables that this version knows.
inline constexpr std::array<std::string_view, 16> project_tables = {
    "meta",      "nodes",      "parameters", "links",     "sources",      "blobs", "chunks",     "objects",
    "thumbnail", "transforms", "nodes_off",  "backdrops", "kept_results", "past",  "past_nodes", "versions"};

/// Makes the tables of a new database: those of the first schema.
void create_schema(Database& database);

/// Tables that only some projects have. Versions that know only an earlier schema open these as well and leave out what
/// they don't know.
enum class TableGroup {
  Placements,  ///< of nodes that have a transform or are off; since schema 2
  Backdrops,   ///< of pictures behind drawings; since schema 3
  Objects,     ///< of objects that were moved or belong to a group; since schema 4
  Results,     ///< of steps that don't fit what they are given; since schema 4
  Past,        ///< of what undo leads back to, in working databases only, and of the nodes of versions
  Versions     ///< of documents that people keep under names; since schema 5
};

bool has_tables(const Database& database, TableGroup group);

/// Makes the tables, unless they are there, and raises the number of the schema.
void require_tables(Database& database, TableGroup group);

/// All that are there.
std::set<TableGroup> tables_in(const Database& database);

}  // namespace croquis

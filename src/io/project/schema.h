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

/// Raised with every change of the tables: the newest one that this version knows.
inline constexpr std::int64_t project_schema_version = 4;

/// That of projects in which no object was moved or belongs to a group, and every step fits what it is given, so that
/// no result has to be kept.
inline constexpr std::int64_t third_schema_version = 3;

/// That of those in which, besides, no drawing has a picture behind it.
inline constexpr std::int64_t second_schema_version = 2;

/// That of projects in which, besides, no node has a transform or is off. Versions that know only this schema open the
/// others as well and leave all of this out.
inline constexpr std::int64_t first_schema_version = 1;

/// SQLite itself ends at 2 GiB; parts of this size can also be read one at a time.
inline constexpr int max_chunk_bytes = 64 * 1024 * 1024;

/// The tables that this version knows.
inline constexpr std::array<std::string_view, 15> project_tables = {
    "meta",      "nodes",      "parameters", "links",     "sources",      "blobs", "chunks",    "objects",
    "thumbnail", "transforms", "nodes_off",  "backdrops", "kept_results", "past",  "past_nodes"};

/// Makes the tables of a new database: those of the first schema.
void create_schema(Database& database);

/// Makes the tables that the second schema has beside those of the first, unless they are there.
void require_later_tables(Database& database);
bool has_later_tables(const Database& database);

/// The same for the table of the third schema.
void require_backdrops(Database& database);
bool has_backdrops(const Database& database);

/// The same for the table of the fourth schema.
void require_objects(Database& database);
bool has_objects(const Database& database);
void require_kept_results(Database& database);
bool has_kept_results(const Database& database);

/// The tables that only working databases have: what undo leads back to.
void require_past(Database& database);
bool has_past(const Database& database);

}  // namespace croquis

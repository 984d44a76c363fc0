// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/project/schema.h"

#include <algorithm>
#include <string>

namespace croquis {
namespace {

struct LaterTables {
  const char* sql;
  const char* names;  ///< in quotes
  int count;
  std::int64_t version;  ///< the schema that has them first; 0 for what working databases alone have
};

/// By TableGroup.
constexpr std::array<LaterTables, 6> later_tables = {
    {{"CREATE TABLE transforms(node INTEGER PRIMARY KEY, numbers BLOB NOT NULL);"
      "CREATE TABLE nodes_off(node INTEGER PRIMARY KEY)",
      "'transforms', 'nodes_off'", 2, 2},
     {"CREATE TABLE backdrops(node INTEGER PRIMARY KEY, hash BLOB NOT NULL, numbers BLOB NOT NULL,"
      " visible INTEGER NOT NULL)",
      "'backdrops'", 1, 3},
     {"CREATE TABLE objects(node INTEGER PRIMARY KEY, numbers BLOB NOT NULL, object_group TEXT NOT NULL)", "'objects'",
      1, 4},
     {"CREATE TABLE kept_results(node INTEGER NOT NULL, role TEXT NOT NULL, kind TEXT NOT NULL, hash BLOB NOT NULL,"
      " PRIMARY KEY(node, role)) WITHOUT ROWID",
      "'kept_results'", 1, 4},
     {"CREATE TABLE past(number INTEGER PRIMARY KEY, label TEXT NOT NULL, next_id INTEGER NOT NULL,"
      " nodes BLOB NOT NULL);"
      "CREATE TABLE past_nodes(hash BLOB PRIMARY KEY, bytes BLOB NOT NULL, source BLOB NOT NULL,"
      " picture BLOB NOT NULL) WITHOUT ROWID",
      "'past', 'past_nodes'", 2, 0},
     {"CREATE TABLE versions(number INTEGER PRIMARY KEY, name TEXT NOT NULL, next_id INTEGER NOT NULL,"
      " nodes BLOB NOT NULL, png BLOB NOT NULL)",
      "'versions'", 1, 5}}};

constexpr std::int64_t first_version = 1;

}  // namespace

// Columns without a declared type keep each value exactly as it was given.
void create_schema(Database& database) {
  database.execute(
      "CREATE TABLE meta(key TEXT PRIMARY KEY, value) WITHOUT ROWID;"
      "CREATE TABLE nodes(id INTEGER PRIMARY KEY, position INTEGER NOT NULL, name TEXT NOT NULL,"
      " operation TEXT NOT NULL, version INTEGER NOT NULL, visible INTEGER NOT NULL);"
      "CREATE TABLE parameters(node INTEGER NOT NULL, name TEXT NOT NULL, type TEXT NOT NULL, value,"
      " PRIMARY KEY(node, name)) WITHOUT ROWID;"
      "CREATE TABLE links(node INTEGER NOT NULL, input TEXT NOT NULL, source INTEGER NOT NULL, output TEXT NOT NULL,"
      " PRIMARY KEY(node, input)) WITHOUT ROWID;"
      "CREATE TABLE sources(node INTEGER PRIMARY KEY, kind TEXT NOT NULL, hash BLOB NOT NULL);"
      "CREATE TABLE blobs(hash BLOB PRIMARY KEY, length INTEGER NOT NULL) WITHOUT ROWID;"
      "CREATE TABLE chunks(hash BLOB NOT NULL, number INTEGER NOT NULL, bytes BLOB NOT NULL,"
      " PRIMARY KEY(hash, number));"
      "CREATE TABLE thumbnail(id INTEGER PRIMARY KEY, png BLOB NOT NULL);"
      "PRAGMA application_id=" +
      std::to_string(project_application_id) + ";PRAGMA user_version=" + std::to_string(first_version));
}

bool has_tables(const Database& database, TableGroup group) {
  const LaterTables& tables = later_tables[static_cast<std::size_t>(group)];
  // Counted here: projects of unknown origin are read without any function of SQL.
  Statement statement(
      database, std::string("SELECT name FROM sqlite_schema WHERE type='table' AND name IN (") + tables.names + ")");
  int found = 0;
  while (statement.step()) ++found;
  return found == tables.count;
}

void require_tables(Database& database, TableGroup group) {
  if (has_tables(database, group)) return;
  const LaterTables& tables = later_tables[static_cast<std::size_t>(group)];
  database.execute(tables.sql);
  if (tables.version == 0) return;
  // Readers of the first schema can follow every later one so far.
  const std::int64_t now = std::max(tables.version, database.integer("PRAGMA user_version"));
  database.execute("INSERT OR REPLACE INTO meta(key, value) VALUES('readable_since', '" +
                   std::to_string(first_version) + "');PRAGMA user_version=" + std::to_string(now));
}

std::set<TableGroup> tables_in(const Database& database) {
  std::set<TableGroup> there;
  for (std::size_t i = 0; i < later_tables.size(); ++i) {
    if (has_tables(database, static_cast<TableGroup>(i))) there.insert(static_cast<TableGroup>(i));
  }
  return there;
}

}  // namespace croquis

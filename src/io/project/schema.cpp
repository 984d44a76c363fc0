// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/project/schema.h"

#include <algorithm>
#include <string>

namespace croquis {

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
      std::to_string(project_application_id) + ";PRAGMA user_version=" + std::to_string(first_schema_version));
}

namespace {

/// Readers of the first schema can follow every later one so far.
void raise_version(Database& database, std::int64_t version) {
  const std::int64_t now = std::max(version, database.integer("PRAGMA user_version"));
  database.execute("INSERT OR REPLACE INTO meta(key, value) VALUES('readable_since', '" +
                   std::to_string(first_schema_version) + "');PRAGMA user_version=" + std::to_string(now));
}

// Counted here: projects of unknown origin are read without any function of SQL.
int count_tables(const Database& database, const std::string& names) {
  Statement statement(database, "SELECT name FROM sqlite_schema WHERE type='table' AND name IN (" + names + ")");
  int found = 0;
  while (statement.step()) ++found;
  return found;
}

}  // namespace

void require_later_tables(Database& database) {
  if (has_later_tables(database)) return;
  database.execute(
      "CREATE TABLE transforms(node INTEGER PRIMARY KEY, numbers BLOB NOT NULL);"
      "CREATE TABLE nodes_off(node INTEGER PRIMARY KEY)");
  raise_version(database, second_schema_version);
}

bool has_later_tables(const Database& database) { return count_tables(database, "'transforms', 'nodes_off'") == 2; }

void require_backdrops(Database& database) {
  if (has_backdrops(database)) return;
  database.execute(
      "CREATE TABLE backdrops(node INTEGER PRIMARY KEY, hash BLOB NOT NULL, numbers BLOB NOT NULL,"
      " visible INTEGER NOT NULL)");
  raise_version(database, third_schema_version);
}

bool has_backdrops(const Database& database) { return count_tables(database, "'backdrops'") == 1; }

void require_objects(Database& database) {
  if (has_objects(database)) return;
  database.execute("CREATE TABLE objects(node INTEGER PRIMARY KEY, numbers BLOB NOT NULL, object_group TEXT NOT NULL)");
  raise_version(database, project_schema_version);
}

bool has_objects(const Database& database) { return count_tables(database, "'objects'") == 1; }

void require_kept_results(Database& database) {
  if (has_kept_results(database)) return;
  database.execute(
      "CREATE TABLE kept_results(node INTEGER NOT NULL, role TEXT NOT NULL, kind TEXT NOT NULL, hash BLOB NOT NULL,"
      " PRIMARY KEY(node, role)) WITHOUT ROWID");
  raise_version(database, project_schema_version);
}

void require_past(Database& database) {
  if (has_past(database)) return;
  database.execute(
      "CREATE TABLE past(number INTEGER PRIMARY KEY, label TEXT NOT NULL, next_id INTEGER NOT NULL,"
      " nodes BLOB NOT NULL);"
      "CREATE TABLE past_nodes(hash BLOB PRIMARY KEY, bytes BLOB NOT NULL, source BLOB NOT NULL,"
      " picture BLOB NOT NULL) WITHOUT ROWID");
}

bool has_past(const Database& database) { return count_tables(database, "'past', 'past_nodes'") == 2; }

bool has_kept_results(const Database& database) { return count_tables(database, "'kept_results'") == 1; }

}  // namespace croquis

// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/project/schema.h"

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

void require_later_tables(Database& database) {
  if (has_later_tables(database)) return;
  database.execute(
      "CREATE TABLE transforms(node INTEGER PRIMARY KEY, numbers BLOB NOT NULL);"
      "CREATE TABLE nodes_off(node INTEGER PRIMARY KEY);"
      "INSERT OR REPLACE INTO meta(key, value) VALUES('readable_since', '" +
      std::to_string(first_schema_version) + "');PRAGMA user_version=" + std::to_string(project_schema_version));
}

// Counted here: projects of unknown origin are read without any function of SQL.
bool has_later_tables(const Database& database) {
  Statement statement(database,
                      "SELECT name FROM sqlite_schema WHERE type='table' AND name IN ('transforms', 'nodes_off')");
  int found = 0;
  while (statement.step()) ++found;
  return found == 2;
}

}  // namespace croquis

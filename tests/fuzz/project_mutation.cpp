// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz/project_mutation.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "fuzz/text_mutation.h"
#include "io/project/blob_store.h"
#include "io/project/database.h"

namespace croquis::test {
namespace {

struct Blob {
  std::string bytes;
};

using Cell = std::variant<std::monostate, std::int64_t, double, std::string, Blob>;
using Row = std::vector<Cell>;

struct Table {
  const char* name;
  int columns;
};

constexpr std::array<Table, 10> tables = {{{"nodes", 6},
                                           {"parameters", 4},
                                           {"links", 4},
                                           {"sources", 3},
                                           {"transforms", 2},
                                           {"nodes_off", 1},
                                           {"chunks", 3},
                                           {"meta", 2},
                                           {"objects", 3},
                                           {"kept_results", 4}}};

Cell cell_of(const Statement& row, int column) {
  if (row.is_integer(column)) return row.integer(column);
  if (row.is_number(column)) return row.number(column);
  if (row.is_text(column)) return std::string(row.text(column));
  if (row.is_blob(column)) return Blob{std::string(row.blob(column))};
  return std::monostate();
}

/// None of a table that this project doesn't need.
std::vector<Row> rows_of(Database& database, const Table& table) {
  std::vector<Row> rows;
  const std::string known = std::string("SELECT count(*) FROM sqlite_schema WHERE name='") + table.name + "'";
  if (database.integer(known) == 0) return rows;
  Statement statement(database, std::string("SELECT * FROM ") + table.name);
  while (statement.step()) {
    Row row;
    for (int column = 0; column < table.columns; ++column) row.push_back(cell_of(statement, column));
    rows.push_back(std::move(row));
  }
  return rows;
}

struct CellBinder {
  Statement& statement;
  int column;

  void operator()(std::monostate) const { statement.bind_null(column); }
  void operator()(const std::string& text) const { statement.bind_text(column, text); }
  void operator()(const Blob& blob) const { statement.bind_blob(column, blob.bytes); }
  template <typename Number>
  void operator()(Number number) const {
    statement.bind(column, number);
  }
};

/// Rows that a table can't hold are left out.
void write_rows(Database& database, const Table& table, const std::vector<Row>& rows) {
  database.execute(std::string("DELETE FROM ") + table.name);
  std::string places = "?";
  for (int column = 1; column < table.columns; ++column) places += ",?";
  Statement insert(database, std::string("INSERT OR IGNORE INTO ") + table.name + " VALUES(" + places + ")");
  for (const Row& row : rows) {
    for (int column = 0; column < table.columns; ++column)
      std::visit(CellBinder{insert, column}, row[static_cast<std::size_t>(column)]);
    insert.run();
  }
}

void change_bytes(std::string& bytes, Random& random) {
  if (bytes.empty()) return;
  const auto below = [&](std::size_t count) { return random.below(static_cast<std::uint32_t>(count)); };
  const std::uint32_t kind = random.below(8);
  if (kind < 5 && bytes.size() >= 8) {  // numbers begin anywhere, most of them at multiples of four
    const std::size_t at = std::min<std::size_t>(4 * below(bytes.size() / 4), bytes.size() - 8);
    const auto number = std::bit_cast<std::array<char, 8>>(extreme_number(random));
    std::ranges::copy(number, bytes.begin() + static_cast<std::ptrdiff_t>(at));
  } else if (kind == 5) {
    bytes.resize(below(bytes.size()));
  } else if (kind == 6) {
    bytes.insert(below(bytes.size()), bytes.substr(below(bytes.size()), 1 + random.below(24)));
  } else {
    bytes[below(bytes.size())] = static_cast<char>(random.below(256));
  }
}

struct CellChange {
  Random& random;

  void operator()(std::monostate) const {}
  void operator()(std::int64_t& number) const {
    constexpr std::array<std::int64_t, 6> numbers = {0, -1, 2147483648, INT64_MAX, INT64_MIN, 1000000};
    const std::uint64_t moved = static_cast<std::uint64_t>(number) + random.below(3) - 1;  // may wrap round
    number = random.below(2) == 0 ? static_cast<std::int64_t>(moved) : numbers[random.below(numbers.size())];
  }
  void operator()(double& number) const { number = extreme_number(random); }
  void operator()(std::string& text) const { text = mutated_text(text, TextSyntax::Lines, random); }
  void operator()(Blob& blob) const { change_bytes(blob.bytes, random); }
};

void change_rows(std::vector<Row>& rows, Random& random) {
  const auto any_row = [&] { return random.below(static_cast<std::uint32_t>(rows.size())); };
  const std::uint32_t row = any_row(), other = any_row();
  const std::uint32_t column = random.below(static_cast<std::uint32_t>(rows[row].size()));
  const std::uint32_t kind = random.below(8);
  if (kind == 0) {
    rows.erase(rows.begin() + row);
  } else if (kind == 1) {
    std::swap(rows[row][column], rows[other][column]);
  } else if (kind == 2) {
    rows[row][column] = rows[other][column];
  } else {
    if (kind == 3) rows.push_back(rows[row]);
    std::visit(CellChange{random}, rows[row][column]);
  }
}

/// Gives contents other bytes under their new hash, everywhere.
void change_content(Database& database, Random& random) {
  std::vector<Row> chunks = rows_of(database, {"chunks", 3});
  if (chunks.empty()) return;
  Row& chunk = chunks[random.below(static_cast<std::uint32_t>(chunks.size()))];
  const std::string old = std::get<Blob>(chunk[0]).bytes;
  std::string bytes = std::get<Blob>(chunk[2]).bytes;
  for (std::uint32_t changes = 1 + random.below(3); changes > 0; --changes) change_bytes(bytes, random);
  const std::string hash = blob_hash(bytes);
  Statement(database, "UPDATE chunks SET hash=?, bytes=? WHERE hash=?")
      .bind_blob(0, hash)
      .bind_blob(1, bytes)
      .bind_blob(2, old)
      .run();
  Statement(database, "UPDATE blobs SET hash=?, length=? WHERE hash=?")
      .bind_blob(0, hash)
      .bind(1, static_cast<std::int64_t>(bytes.size()))
      .bind_blob(2, old)
      .run();
  Statement(database, "UPDATE sources SET hash=? WHERE hash=?").bind_blob(0, hash).bind_blob(1, old).run();
}

}  // namespace

void mutate_project(const std::filesystem::path& file, Random& random) {
  Database database = Database::write_new(file);
  for (std::uint32_t changes = 1 + random.below(3); changes > 0; --changes) {
    if (random.below(3) == 0) {
      change_content(database, random);
      continue;
    }
    const Table& table = tables[random.below(tables.size())];
    std::vector<Row> rows = rows_of(database, table);
    if (rows.empty()) continue;
    change_rows(rows, random);
    write_rows(database, table, rows);
  }
}

}  // namespace croquis::test

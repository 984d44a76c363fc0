// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>

#include "croquis/base/progress.h"

struct sqlite3;
struct sqlite3_stmt;

namespace croquis {

/// An error of SQLite. Callers, which know what was being read or written, make findings of it.
class DatabaseError : public std::runtime_error {
 public:
  DatabaseError(int code, const std::string& message) : std::runtime_error(message), code_(code) {}

  /// For people whose file can't be written.
  std::string reason() const;

 private:
  int code_;
};

/// One connection. Files of unknown origin are opened with `read`, which runs nothing that the file contains:
/// no triggers, views, functions or extensions, rows and statements within limits, and an end to the work.
/// All members throw DatabaseError; those that run statements also Cancelled.
class Database {
 public:
  /// A new database in an existing empty file, for a single writer that syncs and renames the file itself.
  static Database write_new(const std::filesystem::path& file);

  /// A database that outlives its process' death at any moment (write-ahead log); made when it isn't there.
  static Database open_durable(const std::filesystem::path& file);

  /// A finished file, which doesn't change while it is read.
  /// @param progress must outlive the database; its cancel flag is checked while statements run
  static Database read(const std::filesystem::path& file, std::uintmax_t size, const Progress& progress);

  /// The same for bytes in memory, which must outlive the database.
  static Database read(std::string_view bytes, const Progress& progress);

  /// The same for a durable database, with what its log holds.
  static Database read_durable(const std::filesystem::path& file, std::uintmax_t size, const Progress& progress);

  /// Statements without results.
  void execute(const std::string& sql);

  /// Ends a transaction that failed; never throws.
  void roll_back() noexcept;

  /// The first column of the first row as a whole number.
  std::int64_t integer(const std::string& sql);

  sqlite3* handle() const { return handle_.get(); }

  /// What SQLite complained about last, as an exception.
  [[noreturn]] void fail() const;

  /// Counts bytes that were read: no file has more of them than it is long, unless its parts overlap.
  void charge(std::size_t bytes) const;

 private:
  struct Closer {
    void operator()(sqlite3* handle) const;
  };
  /// How far statements may go, and who may stop them.
  struct Guard {
    const Progress* progress = nullptr;
    std::uint64_t steps_left = 0;
    std::uint64_t bytes_left = 0;
  };

  Database(const std::string& name, int flags);
  void defend(std::uintmax_t size, const Progress& progress);
  static int on_steps(void* guard);

  std::unique_ptr<Guard> guard_;
  std::unique_ptr<sqlite3, Closer> handle_;
};

/// One prepared statement. Parameters and columns count from 0.
class Statement {
 public:
  Statement(const Database& database, std::string_view sql);

  Statement& bind(int index, std::int64_t value);
  Statement& bind(int index, double value);
  Statement& bind_text(int index, std::string_view value);  ///< must live until the statement is reset
  Statement& bind_blob(int index, std::string_view value);  ///< must live until the statement is reset
  Statement& bind_null(int index);

  /// The next row. @return false after the last one
  bool step();

  /// Runs to the end and makes it ready for other values.
  void run();
  void reset();

  std::int64_t integer(int column) const;
  double number(int column) const;
  std::string_view text(int column) const;  ///< valid until the next step
  std::string_view blob(int column) const;  ///< valid until the next step
  bool is_integer(int column) const;
  bool is_number(int column) const;
  bool is_text(int column) const;
  bool is_blob(int column) const;

 private:
  struct Finalizer {
    void operator()(sqlite3_stmt* statement) const;
  };

  std::string_view charged(const char* data, int column) const;

  const Database& database_;
  std::unique_ptr<sqlite3_stmt, Finalizer> statement_;
};

/// Bytes among the values of a statement, which aren't text.
struct Bytes {
  std::string_view bytes;
};

inline void bind_value(Statement& statement, int index, std::int64_t value) { statement.bind(index, value); }
inline void bind_value(Statement& statement, int index, std::string_view text) { statement.bind_text(index, text); }
inline void bind_value(Statement& statement, int index, Bytes value) { statement.bind_blob(index, value.bytes); }

/// Runs one statement without results.
/// @param values of its parameters, in their order: whole numbers, texts and Bytes
template <typename... Values>
void run_statement(const Database& database, std::string_view sql, const Values&... values) {
  Statement statement(database, sql);
  int index = 0;
  (bind_value(statement, index++, values), ...);
  statement.run();
}

}  // namespace croquis

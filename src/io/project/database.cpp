// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/project/database.h"

#include <algorithm>
#include <array>
#include <limits>
#include <new>

#include <sqlite3.h>

#include "croquis/base/error.h"
#include "io/project/schema.h"

namespace croquis {
namespace {

/// SQLite's virtual machine calls back after this many steps to ask whether to go on: some tens of microseconds.
constexpr int steps_per_question = 1000;
/// A row takes at least four bytes of the file and all our statements together a few hundred steps per row. What needs
/// more is a damaged tree whose branches lead back into each other.
constexpr std::uint64_t steps_per_byte = 200;
constexpr std::uint64_t least_steps = 2'000'000;

struct Limit {
  int id;
  int value;
};

constexpr std::array<Limit, 8> limits = {{{SQLITE_LIMIT_LENGTH, max_chunk_bytes + 4096},
                                          {SQLITE_LIMIT_SQL_LENGTH, 100'000},
                                          {SQLITE_LIMIT_COLUMN, 100},
                                          {SQLITE_LIMIT_EXPR_DEPTH, 50},
                                          {SQLITE_LIMIT_COMPOUND_SELECT, 3},
                                          {SQLITE_LIMIT_VDBE_OP, 25'000},
                                          {SQLITE_LIMIT_ATTACHED, 0},
                                          {SQLITE_LIMIT_TRIGGER_DEPTH, 0}}};

struct Switch {
  int id;
  int value;
};

constexpr std::array<Switch, 5> switches = {{{SQLITE_DBCONFIG_DEFENSIVE, 1},
                                             {SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0},
                                             {SQLITE_DBCONFIG_ENABLE_TRIGGER, 0},
                                             {SQLITE_DBCONFIG_ENABLE_VIEW, 0},
                                             {SQLITE_DBCONFIG_ENABLE_LOAD_EXTENSION, 0}}};

/// Reading is all that may happen: no functions, no writing, no other files.
int allow_reading(void*, int action, const char*, const char*, const char*, const char*) {
  const bool reads = action == SQLITE_SELECT || action == SQLITE_READ || action == SQLITE_PRAGMA;
  return reads ? SQLITE_OK : SQLITE_DENY;
}

/// A file name that SQLite takes as an address, with everything special in it written as %XX.
std::string uri_of(const std::filesystem::path& file) {
  static constexpr std::string_view plain = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789/._-";
  static constexpr std::string_view digits = "0123456789ABCDEF";
  std::string uri = "file:";
  for (const char c : std::filesystem::absolute(file).string()) {
    const auto byte = static_cast<unsigned char>(c);
    if (plain.find(c) != std::string_view::npos) {
      uri += c;
    } else {
      (uri += '%').append(1, digits[byte / 16]).append(1, digits[byte % 16]);
    }
  }
  return uri;
}

}  // namespace

std::string DatabaseError::reason() const { return code_ == SQLITE_FULL ? "the disk is full" : what(); }

void Database::Closer::operator()(sqlite3* handle) const { sqlite3_close_v2(handle); }

Database::Database(const std::string& name, int flags) : guard_(std::make_unique<Guard>()) {
  sqlite3* handle = nullptr;
  const int code = sqlite3_open_v2(name.c_str(), &handle, flags | SQLITE_OPEN_NOMUTEX, nullptr);
  handle_.reset(handle);
  if (code != SQLITE_OK) {
    throw DatabaseError(code, handle == nullptr ? "out of memory" : sqlite3_errmsg(handle));
  }
}

// The file is renamed into place when it is complete, so a journal beside it would protect nothing.
Database Database::write_new(const std::filesystem::path& file) {
  Database database(std::filesystem::absolute(file).string(), SQLITE_OPEN_READWRITE);
  database.execute("PRAGMA journal_mode=OFF; PRAGMA synchronous=OFF; PRAGMA locking_mode=EXCLUSIVE");
  return database;
}

Database Database::open_durable(const std::filesystem::path& file) {
  Database database(std::filesystem::absolute(file).string(), SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE);
  sqlite3_busy_timeout(database.handle(), 5000);
  database.execute("PRAGMA journal_mode=WAL; PRAGMA synchronous=FULL");
  return database;
}

Database Database::read(const std::filesystem::path& file, std::uintmax_t size, const Progress& progress) {
  Database database(uri_of(file) + "?immutable=1", SQLITE_OPEN_READONLY | SQLITE_OPEN_URI);
  database.defend(size, progress);
  return database;
}

Database Database::read(std::string_view bytes, const Progress& progress) {
  Database database(":memory:", SQLITE_OPEN_READWRITE);
  auto* data = reinterpret_cast<unsigned char*>(const_cast<char*>(bytes.data()));  // the flag makes it read only
  const auto size = static_cast<sqlite3_int64>(bytes.size());
  const int code = sqlite3_deserialize(database.handle(), "main", data, size, size, SQLITE_DESERIALIZE_READONLY);
  if (code != SQLITE_OK) database.fail();
  database.defend(bytes.size(), progress);
  return database;
}

Database Database::read_durable(const std::filesystem::path& file, std::uintmax_t size, const Progress& progress) {
  Database database(std::filesystem::absolute(file).string(), SQLITE_OPEN_READWRITE);
  sqlite3_busy_timeout(database.handle(), 5000);
  database.defend(size, progress);
  return database;
}

void Database::defend(std::uintmax_t size, const Progress& progress) {
  for (const Switch& item : switches) sqlite3_db_config(handle(), item.id, item.value, nullptr);
  for (const Limit& limit : limits) sqlite3_limit(handle(), limit.id, limit.value);
  sqlite3_set_authorizer(handle(), allow_reading, nullptr);
  constexpr std::uint64_t largest = std::numeric_limits<std::uint64_t>::max() / steps_per_byte / 2;
  guard_->progress = &progress;
  guard_->steps_left = least_steps + std::min<std::uint64_t>(size, largest) * steps_per_byte;
  guard_->bytes_left = size + 65536;  // our own statements' results as well
  sqlite3_progress_handler(handle(), steps_per_question, on_steps, guard_.get());
  execute("PRAGMA cell_size_check=ON");
}

int Database::on_steps(void* guard) {
  auto& state = *static_cast<Guard*>(guard);
  if (state.progress->cancelled() || state.steps_left < steps_per_question) return 1;
  state.steps_left -= steps_per_question;
  return 0;
}

void Database::execute(const std::string& sql) {
  if (sqlite3_exec(handle(), sql.c_str(), nullptr, nullptr, nullptr) != SQLITE_OK) fail();
}

void Database::roll_back() noexcept { sqlite3_exec(handle(), "ROLLBACK", nullptr, nullptr, nullptr); }

std::int64_t Database::integer(const std::string& sql) {
  Statement statement(*this, sql);
  return statement.step() ? statement.integer(0) : 0;
}

void Database::fail() const {
  if (guard_->progress != nullptr && guard_->progress->cancelled()) throw Cancelled();
  const int code = sqlite3_errcode(handle()) & 0xff;
  // SQLite returns this for some damaged schemas, too, while memory is free.
  if (code == SQLITE_NOMEM && guard_->progress == nullptr) throw std::bad_alloc();
  if (code == SQLITE_INTERRUPT) throw DatabaseError(SQLITE_CORRUPT, "its parts lead back into each other");
  throw DatabaseError(code, sqlite3_errmsg(handle()));
}

void Database::charge(std::size_t bytes) const {
  if (guard_->progress == nullptr) return;
  if (bytes > guard_->bytes_left) throw DatabaseError(SQLITE_CORRUPT, "its parts overlap");
  guard_->bytes_left -= bytes;
}

void Statement::Finalizer::operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }

Statement::Statement(const Database& database, std::string_view sql) : database_(database) {
  sqlite3_stmt* statement = nullptr;
  const int code = sqlite3_prepare_v2(database.handle(), sql.data(), static_cast<int>(sql.size()), &statement, nullptr);
  statement_.reset(statement);
  if (code != SQLITE_OK) database.fail();
}

Statement& Statement::bind(int index, std::int64_t value) {
  if (sqlite3_bind_int64(statement_.get(), index + 1, value) != SQLITE_OK) database_.fail();
  return *this;
}

Statement& Statement::bind(int index, double value) {
  if (sqlite3_bind_double(statement_.get(), index + 1, value) != SQLITE_OK) database_.fail();
  return *this;
}

Statement& Statement::bind_text(int index, std::string_view value) {
  const char* data = value.empty() ? "" : value.data();
  if (sqlite3_bind_text64(statement_.get(), index + 1, data, value.size(), SQLITE_STATIC, SQLITE_UTF8) != SQLITE_OK) {
    database_.fail();
  }
  return *this;
}

Statement& Statement::bind_blob(int index, std::string_view value) {
  const char* data = value.empty() ? "" : value.data();
  if (sqlite3_bind_blob64(statement_.get(), index + 1, data, value.size(), SQLITE_STATIC) != SQLITE_OK) {
    database_.fail();
  }
  return *this;
}

Statement& Statement::bind_null(int index) {
  if (sqlite3_bind_null(statement_.get(), index + 1) != SQLITE_OK) database_.fail();
  return *this;
}

bool Statement::step() {
  const int code = sqlite3_step(statement_.get());
  if (code != SQLITE_ROW && code != SQLITE_DONE) database_.fail();
  return code == SQLITE_ROW;
}

void Statement::run() {
  while (step()) {
  }
  reset();
}

void Statement::reset() { sqlite3_reset(statement_.get()); }

std::int64_t Statement::integer(int column) const { return sqlite3_column_int64(statement_.get(), column); }
double Statement::number(int column) const { return sqlite3_column_double(statement_.get(), column); }

std::string_view Statement::charged(const char* data, int column) const {
  const auto size = static_cast<std::size_t>(sqlite3_column_bytes(statement_.get(), column));
  database_.charge(size);
  return data == nullptr ? std::string_view() : std::string_view(data, size);
}

std::string_view Statement::text(int column) const {
  const auto* data = reinterpret_cast<const char*>(sqlite3_column_text(statement_.get(), column));
  return charged(data, column);
}

std::string_view Statement::blob(int column) const {
  const auto* data = static_cast<const char*>(sqlite3_column_blob(statement_.get(), column));
  return charged(data, column);
}

bool Statement::is_integer(int column) const { return sqlite3_column_type(statement_.get(), column) == SQLITE_INTEGER; }
bool Statement::is_number(int column) const { return sqlite3_column_type(statement_.get(), column) == SQLITE_FLOAT; }
bool Statement::is_text(int column) const { return sqlite3_column_type(statement_.get(), column) == SQLITE_TEXT; }
bool Statement::is_blob(int column) const { return sqlite3_column_type(statement_.get(), column) == SQLITE_BLOB; }

}  // namespace croquis

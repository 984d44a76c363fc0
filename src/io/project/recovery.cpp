// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/io/recovery.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <ctime>
#include <optional>
#include <system_error>

#include <unistd.h>

#include "croquis/base/error.h"
#include "io/project/damage_log.h"
#include "io/project/database.h"
#include "io/project/process_lock.h"
#include "io/project/project_reader.h"
#include "io/project/project_writer.h"
#include "io/project/schema.h"
#include "io/system_files.h"

namespace croquis {
namespace {

namespace fs = std::filesystem;

constexpr const char* work_ending = ".work";
constexpr int name_attempts = 10000;

fs::path lock_of(const fs::path& work) { return fs::path(work).replace_extension(".lock"); }

std::string utc_now() {
  const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  std::tm parts{};
  ::gmtime_r(&now, &parts);
  std::array<char, 32> text{};
  const std::size_t length = std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%SZ", &parts);
  return {text.data(), length};
}

std::vector<fs::path> files_ending(const fs::path& folder, const char* ending) {
  std::vector<fs::path> files;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    if (entry.path().extension() == ending) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

/// With its log, which holds what isn't in the database yet.
std::uintmax_t size_of(const fs::path& work) {
  std::uintmax_t sum = 0;
  for (const char* ending : {"", "-wal"}) {
    std::error_code error;
    const auto size = fs::file_size(work.string() + ending, error);
    if (!error) sum += size;
  }
  return sum;
}

/// What a dead process left, if it ever committed anything; unreadable remains count, too.
std::optional<RecoverableWork> inspect_work(const fs::path& file) {
  RecoverableWork work;
  work.file = file;
  try {
    const Progress progress;
    Database database = Database::read_durable(file, size_of(file), progress);
    if (database.integer("SELECT 1 FROM sqlite_schema WHERE name='thumbnail'") == 0) return std::nullopt;
    work.time = read_meta(database, "time");
    if (work.time.empty()) return std::nullopt;
    work.project_path = read_meta(database, "project_path");
    work.thumbnail_png = read_thumbnail(database);
  } catch (const DatabaseError&) {
    work.time.clear();
  }
  return work;
}

/// Removes what dead processes left without anything to recover.
void sweep(const fs::path& folder) {
  for (const fs::path& file : files_ending(folder, work_ending)) {
    if (!is_process_alive(lock_of(file)) && !inspect_work(file)) discard(file);
  }
  for (const fs::path& lock : files_ending(folder, ".lock")) {
    const fs::path work = fs::path(lock).replace_extension(work_ending);
    if (!fs::exists(work) && !is_process_alive(lock)) ::unlink(lock.c_str());
  }
}

struct LockedName {
  fs::path file;
  ProcessLock lock;
};

LockedName free_name(const fs::path& folder) {
  for (int attempt = 0; attempt < name_attempts; ++attempt) {
    const std::string name = std::to_string(::getpid()) + "-" + std::to_string(attempt);
    const fs::path file = folder / (name + work_ending);
    if (auto lock = ProcessLock::take(lock_of(file))) return {file, std::move(*lock)};
  }
  fail_writing(folder.string(), "no name is free in it");
}

}  // namespace

struct WorkingCopy::State {
  explicit State(LockedName name)
      : file(std::move(name.file)),
        lock(std::move(name.lock)),
        database(Database::open_durable(file)),
        writer(database) {}

  fs::path file;
  ProcessLock lock;
  Database database;
  ProjectWriter writer;
};

WorkingCopy::WorkingCopy(std::unique_ptr<State> state) : state_(std::move(state)) {}
WorkingCopy::WorkingCopy(WorkingCopy&&) noexcept = default;
WorkingCopy& WorkingCopy::operator=(WorkingCopy&&) noexcept = default;
WorkingCopy::~WorkingCopy() = default;

WorkingCopy WorkingCopy::create(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) fail_writing(folder.string(), writing_reason(error.value()));
  sweep(folder);
  try {
    auto state = std::make_unique<State>(free_name(folder));
    state->database.execute("BEGIN");
    create_schema(state->database);
    state->database.execute("COMMIT");
    return WorkingCopy(std::move(state));
  } catch (const DatabaseError& failure) {
    fail_writing(folder.string(), failure.reason());
  }
}

void WorkingCopy::commit(const Document& document, const std::string& project_path,
                         const std::vector<std::uint8_t>& thumbnail_png, const KeptWork& kept) {
  Database& database = state_->database;
  try {
    database.execute("BEGIN IMMEDIATE");
    Progress progress;
    state_->writer.write(document, kept, progress);
    state_->writer.write_meta("project_path", project_path);
    state_->writer.write_meta("time", utc_now());
    state_->writer.write_thumbnail(thumbnail_png);
    database.execute("COMMIT");
    state_->writer.confirm();
  } catch (const DatabaseError& failure) {
    database.roll_back();
    fail_writing(state_->file.string(), failure.reason());
  } catch (...) {
    database.roll_back();
    throw;
  }
}

void WorkingCopy::close_cleanly() {
  if (state_ == nullptr) return;
  const fs::path file = state_->file;
  state_.reset();
  discard(file);
}

const fs::path& WorkingCopy::file() const { return state_->file; }

std::vector<RecoverableWork> find_recoverable(const fs::path& folder) {
  std::vector<RecoverableWork> found;
  for (const fs::path& file : files_ending(folder, work_ending)) {
    if (is_process_alive(lock_of(file))) continue;
    if (auto work = inspect_work(file)) found.push_back(std::move(*work));
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const RecoverableWork& a, const RecoverableWork& b) { return a.time > b.time; });
  return found;
}

ProjectFile recover(const fs::path& file, Progress& progress) {
  std::error_code error;
  if (!fs::is_regular_file(file, error)) fail_reading(file.string(), reading_reason(ENOENT));
  try {
    Database database = Database::read_durable(file, size_of(file), progress);
    return read_project_database(database, file.string(), progress);
  } catch (const DatabaseError&) {
    throw damaged_project(file.string(), changed_bytes);
  }
}

// The database first: without it the next process removes the rest.
void discard(const fs::path& file) {
  for (const char* ending : {"", "-wal", "-shm"}) ::unlink((file.string() + ending).c_str());
  ::unlink(lock_of(file).c_str());
}

}  // namespace croquis

// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/io/project_file.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <string>
#include <string_view>
#include <system_error>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "croquis/base/error.h"
#include "io/project/damage_log.h"
#include "io/project/database.h"
#include "io/project/project_reader.h"
#include "io/project/project_writer.h"
#include "io/project/schema.h"
#include "io/system_files.h"

namespace croquis {
namespace {

namespace fs = std::filesystem;

/// The first bytes of a file and its length: enough to recognise a project before SQLite reads it.
struct ProjectHead {
  std::uintmax_t size = 0;
  std::array<char, 100> bytes{};  ///< SQLite's header; zero where the file is shorter
};

// https://www.sqlite.org/fileformat2.html, section 1.3
constexpr std::string_view sqlite_magic("SQLite format 3\0", 16);
constexpr std::size_t application_id_offset = 68;

std::uint32_t application_id(const ProjectHead& head) {
  std::uint32_t id = 0;
  for (std::size_t i = 0; i < 4; ++i) id = id << 8 | static_cast<unsigned char>(head.bytes[application_id_offset + i]);
  return id;
}

/// @throws Error E_FILE_OPEN
ProjectHead read_project_head(const fs::path& path) {
  const std::string name = path.string();
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  struct stat status {};
  if (!file.valid() || ::fstat(file.get(), &status) != 0) fail_reading(name, reading_reason(errno));
  if (S_ISDIR(status.st_mode)) fail_reading(name, reading_reason(EISDIR));
  if (!S_ISREG(status.st_mode)) fail_reading(name, "it is a device or pipe");
  ProjectHead head;
  head.size = static_cast<std::uintmax_t>(status.st_size);
  if (::pread(file.get(), head.bytes.data(), head.bytes.size(), 0) < 0) fail_reading(name, reading_reason(errno));
  return head;
}

ProjectHead project_head(std::string_view bytes) {
  ProjectHead head;
  head.size = bytes.size();
  std::copy_n(bytes.begin(), std::min(bytes.size(), head.bytes.size()), head.bytes.begin());
  return head;
}

/// @throws Error E_EMPTY, E_PROJECT_FORMAT
void require_project(const ProjectHead& head, const std::string& file_name) {
  if (head.size == 0) {
    throw Error(make_error(Category::Malformed, "E_EMPTY", "The file '" + file_name + "' is empty.",
                           {file_subject(file_name)}));
  }
  const std::string_view bytes(head.bytes.data(), head.bytes.size());
  if (bytes.starts_with(sqlite_magic) && application_id(head) == project_application_id) return;
  throw Error(make_error(Category::Malformed, "E_PROJECT_FORMAT",
                         "The file '" + file_name + "' is not a Croquis project; give a .croq file.",
                         {file_subject(file_name)}));
}

constexpr std::string_view project_ending = ".croq";
constexpr std::string_view damaged_ending = "~damaged";
constexpr int aside_attempts = 10000;

bool has_project_ending(std::string name) {
  std::ranges::transform(name, name.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return name.ends_with(project_ending);
}

/// Backups lie beside the file itself, not beside a link to it.
fs::path resolved_project(const fs::path& path) {
  std::error_code error;
  const fs::path canonical = fs::weakly_canonical(path, error);
  return error ? path : canonical;
}

/// In one step: a file that appears under that name meanwhile is never replaced. @return an errno, 0 for success
int rename_to_free_name(const fs::path& from, const fs::path& to) {
  if (::renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), RENAME_NOREPLACE) == 0) return 0;
  if (errno != EINVAL) return errno;
  // File systems that can't promise it.
  std::error_code ignored;
  if (fs::exists(fs::symlink_status(to, ignored))) return EEXIST;
  return ::rename(from.c_str(), to.c_str()) == 0 ? 0 : errno;
}

constexpr int most_name_attempts = 10000;

[[noreturn]] void fail(const fs::path& path, int error) { fail_writing(path.string(), writing_reason(error)); }

/// ".NAME." and ".saving" round a number: hidden, and distinct from other programs' files.
std::string temporary_prefix(const fs::path& target) { return "." + target.filename().string() + "."; }
constexpr const char* temporary_ending = ".saving";

fs::path folder_of(const fs::path& target) {
  const fs::path folder = target.parent_path();
  return folder.empty() ? fs::path(".") : folder;
}

fs::path resolved(const fs::path& path) {
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0) {
    if (errno != ENOENT) fail(path, errno);
    return path;
  }
  if (S_ISDIR(status.st_mode)) fail(path, EISDIR);
  if (!S_ISREG(status.st_mode)) fail_writing(path.string(), "it is a device or pipe");
  if (::access(path.c_str(), W_OK) != 0) fail(path, errno);
  std::error_code error;
  const fs::path canonical = fs::canonical(path, error);
  return error ? path : canonical;
}

/// Temporary files of processes that died are not locked any more.
void remove_remains(const fs::path& target) {
  const std::string prefix = temporary_prefix(target);
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder_of(target), error)) {
    const std::string name = entry.path().filename().string();
    if (!name.starts_with(prefix) || !name.ends_with(temporary_ending)) continue;
    const Descriptor file(::open(entry.path().c_str(), O_RDONLY | O_NOFOLLOW | O_CLOEXEC));
    if (file.valid() && ::flock(file.get(), LOCK_EX | LOCK_NB) == 0) ::unlink(entry.path().c_str());
  }
}

int open_temporary(const fs::path& target, const fs::path& path, fs::path& temporary) {
  for (int attempt = 0; attempt < most_name_attempts; ++attempt) {
    const std::string number = std::to_string(::getpid()) + "-" + std::to_string(attempt);
    temporary = folder_of(target) / (temporary_prefix(target) + number + temporary_ending);
    const int file = ::open(temporary.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (file >= 0) return file;
    if (errno != EEXIST) fail(path, errno);
  }
  fail_writing(path.string(), "no temporary file could be made in its folder");
}

fs::path backup(const fs::path& target, int number) { return target.string() + "~" + std::to_string(number); }

/// Makes room for NAME~1. Only files that block the place move, so that a gap, left by a process that died between
/// two of these steps, costs no backup.
void move_backups_on(const fs::path& target, int count) {
  int gap = 1;
  while (gap < count && fs::exists(fs::symlink_status(backup(target, gap)))) ++gap;
  for (int number = gap; number > 1; --number) {
    ::rename(backup(target, number - 1).c_str(), backup(target, number).c_str());
  }
}

/// The old file gets a second name, so that the first one is never without a file.
void keep_backup(const fs::path& target, const fs::path& path, int count) {
  struct stat status {};
  if (count < 1 || ::stat(target.c_str(), &status) != 0) return;
  move_backups_on(target, count);
  const fs::path first = backup(target, 1);
  ::unlink(first.c_str());  // only there when a single backup is kept, or when it could not be moved
  if (::link(target.c_str(), first.c_str()) == 0) return;
  std::error_code error;  // file systems without hard links
  fs::copy_file(target, first, fs::copy_options::overwrite_existing, error);
  if (error) fail(path, error.value());
}

/// A new version of a file, made beside it and put in its place in one step; the old ones become backups.
///
/// A process that dies leaves the old file and its backups as they were, and its temporary file, which the next
/// replacement of the same file removes. Symbolic links are followed.
class AtomicReplacement {
 public:
  /// Makes the empty temporary file, with the permissions of the file that it replaces.
  /// @throws Error E_WRITE
  explicit AtomicReplacement(const fs::path& path);
  AtomicReplacement(const AtomicReplacement&) = delete;
  AtomicReplacement& operator=(const AtomicReplacement&) = delete;

  /// Removes the temporary file unless it was committed.
  ~AtomicReplacement();

  /// To be filled by the caller, and closed.
  const fs::path& temporary() const { return temporary_; }

  /// Syncs, moves the backups on (NAME~1 to NAME~2 …), makes the old file NAME~1, and renames the new one.
  /// @throws Error E_WRITE
  void commit(int backups);

 private:
  fs::path path_;    ///< as given, for messages
  fs::path target_;  ///< with symbolic links resolved
  fs::path temporary_;
  Descriptor held_;  ///< of the temporary file, locked: it isn't one of a dead process
};

AtomicReplacement::AtomicReplacement(const fs::path& path) : path_(path), target_(resolved(path)), held_(-1) {
  remove_remains(target_);
  held_ = Descriptor(open_temporary(target_, path_, temporary_));
  ::flock(held_.get(), LOCK_EX | LOCK_NB);
  struct stat status {};
  if (::stat(target_.c_str(), &status) == 0) ::fchmod(held_.get(), status.st_mode & 07777);
}

AtomicReplacement::~AtomicReplacement() {
  if (!temporary_.empty()) ::unlink(temporary_.c_str());
}

void AtomicReplacement::commit(int backups) {
  if (::fsync(held_.get()) != 0 && errno != EINVAL) fail(path_, errno);
  keep_backup(target_, path_, backups);
  if (::rename(temporary_.c_str(), target_.c_str()) != 0) fail(path_, errno);
  temporary_.clear();
  sync_folder_of(target_);
}

void fill(const fs::path& file, const ProjectFile& project, Progress& progress) {
  Database database = Database::write_new(file);
  database.execute("BEGIN");
  create_schema(database);
  ProjectWriter writer(database);
  writer.write_meta("application", "croquis " CROQUIS_VERSION);
  Progress writing = progress.step("save", 0.9);
  writer.write(project.document, {project.kept.results, {}, project.kept.versions}, writing);
  writer.write_thumbnail(project.thumbnail_png);
  database.execute("COMMIT");
}

}  // namespace

void save_project(const fs::path& path, const ProjectFile& project, Progress& progress) {
  AtomicReplacement replacement(path);
  try {
    fill(replacement.temporary(), project, progress);
  } catch (const DatabaseError& error) {
    fail_writing(path.string(), error.reason());
  }
  progress.check();
  replacement.commit(project_backup_count);
  progress.report(1);
}

ProjectFile load_project(const fs::path& path, Progress& progress) {
  const std::string name = path.string();
  const ProjectHead head = read_project_head(path);
  require_project(head, name);
  try {
    Database database = Database::read(path, head.size, progress);
    return read_project_database(database, name, progress);
  } catch (const DatabaseError&) {
    throw damaged_project(name, changed_bytes);
  }
}

ProjectFile read_project(std::string_view bytes, const std::string& file_name, Progress& progress) {
  require_project(project_head(bytes), file_name);
  try {
    Database database = Database::read(bytes, progress);
    return read_project_database(database, file_name, progress);
  } catch (const DatabaseError&) {
    throw damaged_project(file_name, changed_bytes);
  }
}

std::vector<fs::path> project_backups(const fs::path& path) {
  std::vector<fs::path> found;
  for (int number = 1; number <= project_backup_count; ++number) {
    const fs::path backup = resolved_project(path).string() + "~" + std::to_string(number);
    std::error_code error;
    if (fs::is_regular_file(backup, error)) found.push_back(backup);
  }
  return found;
}

std::optional<fs::path> project_of_backup(const fs::path& path) {
  const std::string name = path.string();
  const std::size_t mark = name.rfind('~');
  if (mark == std::string::npos || !has_project_ending(name.substr(0, mark))) return std::nullopt;
  const std::string_view number = std::string_view(name).substr(mark + 1);
  const bool is_number =
      !number.empty() && std::ranges::all_of(number, [](unsigned char c) { return std::isdigit(c); });
  const bool is_aside = std::string_view(name).substr(mark).starts_with(damaged_ending);
  return is_number || is_aside ? std::optional<fs::path>(name.substr(0, mark)) : std::nullopt;
}

bool is_project_name(const fs::path& path) {
  return has_project_ending(path.string()) || project_of_backup(path).has_value();
}

fs::path put_damaged_project_aside(const fs::path& path) {
  const fs::path project = resolved_project(path);
  for (int attempt = 1; attempt < aside_attempts; ++attempt) {
    const std::string number = attempt == 1 ? "" : "-" + std::to_string(attempt);
    const fs::path aside = project.string() + std::string(damaged_ending) + number;
    const int error = rename_to_free_name(project, aside);
    if (error == 0) return aside;
    if (error != EEXIST) fail_writing(aside.string(), writing_reason(error));
  }
  fail_writing(path.string(), "no name is free beside it for the damaged version");
}

}  // namespace croquis

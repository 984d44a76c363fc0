// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/io/project_file.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "croquis/base/error.h"
#include "io/descriptor.h"
#include "io/file_errors.h"
#include "io/project/atomic_replacement.h"
#include "io/project/damage_log.h"
#include "io/project/database.h"
#include "io/project/project_reader.h"
#include "io/project/project_writer.h"
#include "io/project/schema.h"

namespace croquis {
namespace {

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
ProjectHead read_project_head(const std::filesystem::path& path) {
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

void fill(const std::filesystem::path& file, const ProjectFile& project, Progress& progress) {
  Database database = Database::write_new(file);
  database.execute("BEGIN");
  create_schema(database);
  ProjectWriter writer(database);
  writer.write_meta("application", "croquis " CROQUIS_VERSION);
  Progress writing = progress.step("save", 0.9);
  writer.write(project.document, {project.kept.results, {}}, writing);
  writer.write_thumbnail(project.thumbnail_png);
  database.execute("COMMIT");
}

}  // namespace

void save_project(const std::filesystem::path& path, const ProjectFile& project, Progress& progress) {
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

ProjectFile load_project(const std::filesystem::path& path, Progress& progress) {
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

}  // namespace croquis

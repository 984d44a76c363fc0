// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/io/project_file.h"

#include "io/file_errors.h"
#include "io/project/atomic_replacement.h"
#include "io/project/damage_log.h"
#include "io/project/database.h"
#include "io/project/project_head.h"
#include "io/project/project_reader.h"
#include "io/project/project_writer.h"
#include "io/project/schema.h"

namespace croquis {
namespace {

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

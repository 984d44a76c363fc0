// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "croquis/base/finding.h"
#include "croquis/base/progress.h"
#include "croquis/document/document.h"
#include "croquis/document/kept_work.h"

/// Documents as project files (.croq): SQLite databases whose tables docs/project-file.md describes.
namespace croquis {

/// What a project file holds.
struct ProjectFile {
  Document document;
  std::vector<std::uint8_t> thumbnail_png;  ///< of at most 16 MiB; may be empty
  Findings warnings;                        ///< of loading: W_PROJECT_DAMAGED, W_PROJECT_NEWER, W_IGNORED
  KeptWork kept = {};                       ///< the past is recovered work's alone: save_project leaves it out
};

/// How many earlier versions of a project lie beside it: NAME~1 (the newest) to NAME~3.
inline constexpr int project_backup_count = 3;

/// The earlier versions beside a project: those that are there, the newest first.
std::vector<std::filesystem::path> project_backups(const std::filesystem::path& path);

/// Whether a path has the name of a project or of a backup of one: "a.croq", "a.croq~2".
bool is_project_name(const std::filesystem::path& path);

/// The project that a backup is one of: "a.croq" for "a.croq~2"; nothing for any other name.
std::optional<std::filesystem::path> project_of_backup(const std::filesystem::path& path);

/// Moves a damaged project out of the way of the next save, so that neither it nor a backup is lost: to "NAME~damaged",
/// or "NAME~damaged-2" … where that is taken. @return where it is now
/// @throws Error E_WRITE (Io) nothing has changed then
std::filesystem::path put_damaged_project_aside(const std::filesystem::path& path);

/// Writes the project so that, whatever happens meanwhile, the path holds either the old or the whole new one: a new
/// database beside it is filled, synced and renamed. The project that was there before becomes NAME~1. The same
/// project gives the same bytes. Linear in the size of the document.
///
/// Nothing of the values is rounded; strokes without samples are dropped.
/// @throws Error E_WRITE (Io) with the reason: nothing has changed then; E_LIMIT for reports nested deeper than
/// limits.h says
/// @throws Cancelled nothing has changed then
void save_project(const std::filesystem::path& path, const ProjectFile& project, Progress& progress);

/// Reads a project that may come from anybody: no code of the file is run, memory and time are linear in its size
/// whatever it claims, and what comes out is safe to compute with. Of a damaged file everything that is whole is kept;
/// warnings name each node, input and parameter that is lost.
/// @throws Error Malformed: E_FILE_OPEN, E_EMPTY, E_PROJECT_FORMAT (not a project), E_PROJECT_DAMAGED (nothing can be
///         read), E_PROJECT_VERSION (saved by a newer Croquis that this one can't follow)
/// @throws Cancelled
ProjectFile load_project(const std::filesystem::path& path, Progress& progress);

/// The same for the bytes of a project file. @param file_name for findings
ProjectFile read_project(std::string_view bytes, const std::string& file_name, Progress& progress);

}  // namespace croquis

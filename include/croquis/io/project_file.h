// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "croquis/base/finding.h"
#include "croquis/base/progress.h"
#include "croquis/document/document.h"

/// Documents as project files (.croq): SQLite databases whose tables docs/project-file.md describes.
namespace croquis {

/// What a project file holds.
struct ProjectFile {
  Document document;
  std::vector<std::uint8_t> thumbnail_png;  ///< of at most 16 MiB; may be empty
  Findings warnings;                        ///< of loading: W_PROJECT_DAMAGED, W_PROJECT_NEWER, W_IGNORED
};

/// How many earlier versions of a project lie beside it: NAME~1 (the newest) to NAME~3.
inline constexpr int project_backup_count = 3;

/// Writes the project so that, whatever happens meanwhile, the path holds either the old or the whole new one: a new
/// database beside it is filled, synced and renamed. The project that was there before becomes NAME~1. The same
/// project gives the same bytes. Linear in the size of the document.
///
/// Nothing of the values is rounded; strokes without samples are dropped.
/// @throws Error E_WRITE (Io) with the reason: nothing has changed then; E_LIMIT for reports nested over 200 deep
/// @throws Cancelled nothing has changed then
void save_project(const std::filesystem::path& path, const ProjectFile& project, Progress& progress);

/// Reads a project that may come from a stranger: no code of the file is run, memory and time are linear in its size
/// whatever it claims, and what comes out is safe to compute with. Of a damaged file everything that is whole is kept;
/// warnings name each node, input and parameter that is lost.
/// @throws Error Malformed: E_FILE_OPEN, E_EMPTY, E_PROJECT_FORMAT (not a project), E_PROJECT_DAMAGED (nothing can be
///         read), E_PROJECT_VERSION (saved by a newer Croquis that this one can't follow)
/// @throws Cancelled
ProjectFile load_project(const std::filesystem::path& path, Progress& progress);

/// The same for the bytes of a project file. @param file_name for findings
ProjectFile read_project(std::string_view bytes, const std::string& file_name, Progress& progress);

}  // namespace croquis

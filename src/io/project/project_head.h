// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace croquis {

/// The first bytes of a file and its length: enough to recognise a project before SQLite reads it.
struct ProjectHead {
  std::uintmax_t size = 0;
  std::array<char, 100> bytes{};  ///< SQLite's header; zero where the file is shorter
};

/// @throws Error E_FILE_OPEN
ProjectHead read_project_head(const std::filesystem::path& path);

ProjectHead project_head(std::string_view bytes);

/// @throws Error E_EMPTY, E_PROJECT_FORMAT
void require_project(const ProjectHead& head, const std::string& file_name);

}  // namespace croquis

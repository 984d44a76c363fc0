// SPDX-License-Identifier: GPL-3.0-or-later
// Files beside a project: earlier versions, and damaged ones that were kept.
#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstdio>
#include <string_view>
#include <system_error>

#include <fcntl.h>

#include "croquis/io/project_file.h"
#include "io/file_errors.h"

namespace croquis {
namespace {

namespace fs = std::filesystem;

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

}  // namespace

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

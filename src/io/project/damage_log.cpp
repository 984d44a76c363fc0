// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/project/damage_log.h"

#include <algorithm>
#include <filesystem>
#include <string_view>

#include "croquis/io/project_file.h"

namespace croquis {
namespace {

constexpr std::size_t max_losses = 100;
constexpr std::size_t max_quoted = 120;

/// Bytes of the character at the beginning, 0 when it isn't UTF-8 (RFC 3629, section 4). Overlong forms and surrogates
/// pass: nothing decodes them here.
std::size_t utf8_length(std::string_view text) {
  const auto lead = static_cast<unsigned char>(text.front());
  const std::size_t length = lead < 0x80                   ? 1
                             : lead >= 0xc2 && lead < 0xe0 ? 2
                             : lead >= 0xe0 && lead < 0xf0 ? 3
                             : lead >= 0xf0 && lead < 0xf5 ? 4
                                                           : 0;
  if (length > text.size()) return 0;
  for (std::size_t i = 1; i < length; ++i) {
    if ((static_cast<unsigned char>(text[i]) & 0xc0) != 0x80) return 0;
  }
  return length;
}

/// "; earlier versions lie beside it: a.croq~1, a.croq~2."
std::string earlier_versions(const std::string& file) {
  std::string names;
  for (const std::filesystem::path& version : project_backups(project_of_backup(file).value_or(file))) {
    if (version.filename() == std::filesystem::path(file).filename()) continue;
    names += (names.empty() ? "" : ", ") + version.filename().string();
  }
  return names.empty() ? "; no earlier versions lie beside it." : "; open an earlier version beside it: " + names + ".";
}

}  // namespace

void DamageLog::lose(const std::string& loss, std::vector<Subject> subjects) {
  if (losses_.size() < max_losses) losses_.push_back({loss, std::move(subjects)});
}

Findings DamageLog::warnings() const {
  Findings findings;
  const std::string versions = losses_.empty() ? "" : earlier_versions(file_);
  for (const Loss& loss : losses_) {
    std::vector<Subject> subjects = loss.subjects;
    subjects.push_back(file_subject(file_));
    findings.push_back(make_warning(Category::Malformed, "W_PROJECT_DAMAGED",
                                    "The project '" + file_ + "' is damaged: " + loss.text + versions,
                                    std::move(subjects)));
  }
  return findings;
}

void DamageLog::refuse() const {
  throw damaged_project(file_, losses_.empty() ? "it is incomplete" : losses_.front().text);
}

Error damaged_project(const std::string& file, const std::string& reason) {
  return Error(
      make_error(Category::Malformed, "E_PROJECT_DAMAGED",
                 "The project '" + file + "' is damaged and can't be opened: " + reason + earlier_versions(file),
                 {file_subject(file)}));
}

Subject file_subject(const std::string& file) { return {SubjectKind::File, file, file, std::nullopt, {}}; }

std::string printable(const std::string& text) {
  const std::string line = text.substr(text.find_last_of('\n') + 1);
  std::string shown;
  for (std::size_t i = 0; i < line.size() && shown.size() < max_quoted;) {
    const std::size_t length = utf8_length(std::string_view(line).substr(i));
    const bool good = length > 1 || (length == 1 && line[i] >= ' ' && line[i] != '\x7f');
    good ? shown.append(line, i, length) : shown.append(1, '?');
    i += std::max<std::size_t>(length, 1);
  }
  return shown;
}

}  // namespace croquis

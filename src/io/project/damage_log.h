// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "croquis/base/error.h"

namespace croquis {

/// What a damaged project has lost, for people.
class DamageLog {
 public:
  explicit DamageLog(std::string file) : file_(std::move(file)) {}

  bool empty() const { return losses_.empty(); }

  /// @param loss a clause such as "its links can't be read"; only the first hundred are kept
  void lose(const std::string& loss, std::vector<Subject> subjects = {});

  /// One W_PROJECT_DAMAGED for each loss.
  Findings warnings() const;

  /// @throws Error E_PROJECT_DAMAGED: nothing of the project can be read
  [[noreturn]] void refuse() const;

  const std::string& file() const { return file_; }

 private:
  struct Loss {
    std::string text;
    std::vector<Subject> subjects;
  };

  std::string file_;
  std::vector<Loss> losses_;
};

/// Why nothing of a file, or of a part of it, can be read: what SQLite says of it means nothing to people.
inline constexpr const char* changed_bytes = "its bytes aren't those that were saved";

/// E_PROJECT_DAMAGED with that reason, and the earlier versions that lie beside the file.
Error damaged_project(const std::string& file, const std::string& reason);

/// The file as a finding's subject.
Subject file_subject(const std::string& file);

/// One line without control characters, valid UTF-8, not too long: names in a damaged file may be anything.
std::string printable(const std::string& text);

}  // namespace croquis

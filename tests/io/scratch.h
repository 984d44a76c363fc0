// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "croquis/base/finding.h"
#include "support/scratch_folder.h"

namespace croquis::test {

/// A folder of its own, gone at the end, whose files are named by paths.
class Scratch : public ScratchFolder {
 public:
  std::filesystem::path operator/(const std::string& name) const { return path() / name; }

  std::set<std::string> names() const {
    const std::vector<std::string> all = ScratchFolder::names();
    return {all.begin(), all.end()};
  }
};

void write_bytes(const std::filesystem::path& path, const std::string& bytes);

/// The findings of the Error that the call throws; empty when it throws none.
Findings findings_of(const std::function<void()>& call);

/// Runs the body in a process of its own. @return its exit status; 99 for an exception, -signal when killed
int in_child(const std::function<int()>& body);

}  // namespace croquis::test

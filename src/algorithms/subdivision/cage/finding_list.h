// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "croquis/base/finding.h"

namespace croquis::subdivision {

/// Findings of one code, one per element. The first hundred are kept, more would hide the others; the last one kept
/// gives their number.
class FindingList {
 public:
  FindingList(Severity severity, Category category, std::string code);

  /// @param sentence without its full stop; called for those that are kept
  void add(std::vector<Subject> subjects, const std::function<std::string()>& sentence);

  bool empty() const { return count_ == 0; }
  void move_to(Findings& findings);

 private:
  Severity severity_;
  Category category_;
  std::string code_;
  std::size_t count_ = 0;
  Findings kept_;
};

Subject face_subject(std::size_t face);
Subject vertex_subject(std::size_t vertex);

std::string edge_name(std::size_t a, std::size_t b);  ///< "edge (a,b)"

}  // namespace croquis::subdivision

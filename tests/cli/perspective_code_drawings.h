// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <set>
#include <string>
#include <vector>

namespace croquis::test {

/// A drawing that a code is about.
struct CodeDrawing {
  std::string code;
  std::string svg;
  std::set<std::string> strokes;  ///< that findings of the code name, together
  int findings = 1;               ///< of the code
  int exit_code = 0;              ///< 4: the code is an error
  std::vector<std::string> options{};
};

/// A U, a J and an S, each with one smooth face of eight sides as its top that no single point sees whole.
std::vector<std::string> folding_drawings();

/// One drawing for each code that strokes of a perspective drawing can have.
std::vector<CodeDrawing> code_drawings();

}  // namespace croquis::test

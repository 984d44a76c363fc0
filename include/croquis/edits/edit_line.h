// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "croquis/edits/edit.h"

/// Edits as lines of text: "extrude faces=3,4 by=0,0,1".
///
/// A line is the edit's id, its elements (vertices=, edges= or faces=, with numbers from 0 such as 0,3-5, or "all";
/// edges have the numbers of MeshTopology), and parameters as name=value, in any order, separated by blanks.
namespace croquis {

/// An edit with what it is applied to.
struct EditLine {
  std::string edit;  ///< id
  EditTarget target;
  ParameterValues parameters;  ///< those given

  friend bool operator==(const EditLine&, const EditLine&) = default;
};

/// Reads lines separated by line ends or ';'. Empty lines, and lines that begin with '#', are left out.
/// @throws Error (E_EDIT) with one finding for every line that can't be understood
std::vector<EditLine> parse_edit_lines(std::string_view text);

/// The line that parse_edit_lines turns back into the same edit.
std::string to_text(const EditLine& line);
std::string to_text(const std::vector<EditLine>& lines);

/// "1 face", "3 vertices".
std::string counted_elements(ComponentKind kind, std::size_t count);

/// What people read: "Inset 2 faces".
/// @param whole stands for the elements of a line that works on all of them
std::string label_of(const EditLine& line, const std::string& whole);

}  // namespace croquis

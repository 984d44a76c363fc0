// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

/// How the perspective tool's undo steps are called.
namespace croquis {

/// "stroke s3".
inline std::string stroke_name(const std::string& id) { return "stroke " + id; }

/// "Move stroke s3", "Erase 2 strokes".
inline std::string named_label(const std::string& verb, const std::vector<std::string>& ids) {
  return verb + ' ' + (ids.size() == 1 ? stroke_name(ids.front()) : std::to_string(ids.size()) + " strokes");
}

}  // namespace croquis

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "croquis/base/report.h"

/// Reports as JSON (RFC 8259), and back.
namespace croquis {

/// Reads a file that may come from anybody. Numbers without fraction and exponent that fit are integers; of members
/// with the same name the last one counts, in the first one's place. Time and memory are linear in the size of the
/// file.
/// @param file_name for findings
/// @throws Error Malformed: E_EMPTY, E_SYNTAX with the line, also for numbers too large for doubles, for bytes that are
///         no UTF-8, and for more than deepest_nesting levels (limits.h)
Report read_json(std::string_view bytes, const std::string& file_name);

enum class JsonLayout {
  Indented,  ///< for files: ends with a newline
  OneLine    ///< for streams: without a newline
};

/// The report as JSON: numbers read back exactly, infinite ones and NaN become null, bytes that are no UTF-8 are
/// replaced.
std::string write_json(const Report& report, JsonLayout layout = JsonLayout::Indented);

}  // namespace croquis

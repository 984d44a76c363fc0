// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

/// What the program reports about an input: one sentence, a stable code, and the elements it is about.
namespace croquis {

/// How much a finding matters: a warning goes with a result, an error replaces it.
enum class Severity { Info, Warning, Error };

/// What kind of trouble; each host maps it to its own answer (the command line to an exit code).
enum class Category {
  Malformed,  ///< the input can't be read: syntax, truncation, values that are not finite
  Geometry,   ///< well-formed input that has no valid result
  Limit,      ///< a memory, time or search bound was reached
  Io,         ///< a file can't be opened or written
  Usage,      ///< an option or parameter that doesn't exist or is out of its range
  Internal    ///< our own mistake
};

enum class SubjectKind {
  Stroke,
  Contour,
  Crossing,
  Line,
  Curve,
  Node,
  Point,
  Face,
  Edge,
  Vertex,
  Hole,
  Parameter,
  File
};

/// The name of a kind as files and reports spell it ("stroke", "file", …).
const char* to_string(SubjectKind kind);

/// One element a finding is about, named so that its owner can find it.
struct Subject {
  SubjectKind kind = SubjectKind::File;
  std::string id;                    ///< a stroke's name, a 0-based index as text, a parameter's or file's name
  std::optional<std::string> file;   ///< the file it was read from
  std::optional<std::int64_t> line;  ///< 1-based line of that file
  std::vector<double> at;            ///< place in the input's own frame: empty, [x,y] or [x,y,z]
};

/// One sentence about the input: what is wrong, where, and what to do.
struct Finding {
  Severity severity = Severity::Error;
  Category category = Category::Internal;
  std::string code;     ///< stable upper-case name, documented in docs/errors.md
  std::string message;  ///< one sentence for people
  std::vector<Subject> subjects;
};

using Findings = std::vector<Finding>;

/// True when at least one finding is an error.
bool has_errors(const Findings& findings);

/// Short forms for the two severities that algorithms produce.
Finding make_error(Category category, std::string code, std::string message, std::vector<Subject> subjects = {});
Finding make_warning(Category category, std::string code, std::string message, std::vector<Subject> subjects = {});

}  // namespace croquis

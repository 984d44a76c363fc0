// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
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

/// One element a finding is about: its number where it has one, an edge by its two vertices, anything else by name.
struct Subject {
  SubjectKind kind = SubjectKind::File;
  std::string id;                          ///< a stroke's, parameter's or file's name, a node's id; else empty
  std::optional<std::string> file;         ///< the file it was read from
  std::optional<std::int64_t> line;        ///< 1-based line of that file
  std::vector<double> at;                  ///< place in the input's own frame: empty, [x,y] or [x,y,z]
  std::optional<std::int64_t> index = {};  ///< of a face, vertex, edge, line, point, hole or list; from 0
  std::optional<std::array<std::int64_t, 2>> vertices = {};  ///< of an edge
};

/// The element of that number.
Subject numbered_subject(SubjectKind kind, std::size_t index, std::vector<double> at = {});

/// The edge between two vertices.
Subject edge_subject(std::size_t a, std::size_t b);

/// The subject as reports and sentences spell it: its id, "7", or "3-7" for an edge.
std::string name_of(const Subject& subject);

/// A change of one stroke that would mend what a finding says.
struct FindingFix {
  std::string stroke;  ///< its id
  std::string group;   ///< the one that it would get
  std::string text;    ///< one sentence for people
};

/// One sentence about the input: what is wrong, where, and what to do.
struct Finding {
  Severity severity = Severity::Error;
  Category category = Category::Internal;
  std::string code;     ///< stable upper-case name, documented in docs/errors.md
  std::string message;  ///< one sentence for people
  std::vector<Subject> subjects;
  std::optional<FindingFix> fix = {};  ///< that can be made without asking
};

using Findings = std::vector<Finding>;

/// True when at least one finding is an error.
bool has_errors(const Findings& findings);

/// True when at least one finding is a warning or an error: more than a note.
bool has_warnings(const Findings& findings);

/// Short forms for the two severities that algorithms produce.
Finding make_error(Category category, std::string code, std::string message, std::vector<Subject> subjects = {});
Finding make_warning(Category category, std::string code, std::string message, std::vector<Subject> subjects = {});

}  // namespace croquis

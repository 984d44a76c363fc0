// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "croquis/base/finding.h"
#include "croquis/io/mesh_file.h"

namespace croquis {

/// Where in the file something was found.
struct Place {
  enum class Kind { File, Line, Byte } kind = Kind::File;
  std::int64_t number = 0;  ///< 1-based line or 0-based byte
};

inline Place at_line(std::int64_t line) { return {Place::Kind::Line, line}; }
inline Place at_byte(std::size_t byte) { return {Place::Kind::Byte, static_cast<std::int64_t>(byte)}; }

/// What a reader reports about its file: collects findings, at most 100 of a code, and passes on progress.
class ReadContext {
 public:
  ReadContext(const MeshSource& source, Progress& progress) : source_(source), progress_(progress) {}

  /// Notes what is wrong; reading may go on to find more. Stops by itself when there are too many.
  void error(const char* code, const std::string& message, Place place, std::vector<Subject> elements = {});

  /// Notes it and stops: nothing after this place can be trusted.
  [[noreturn]] void fail(const char* code, const std::string& message, Place place);

  void warn(const char* code, const std::string& message, Place place, std::vector<Subject> elements = {});

  /// A position that can't be used (limits.h): an error, or a warning where the caller asked for it.
  void not_finite(std::size_t vertex, Place place);

  /// A face that uses a vertex that is not there. @param shown the index as the file has it
  void bad_index(std::size_t face, std::int64_t shown, std::size_t vertex_count, Place place);

  void too_few_corners(std::size_t face, std::size_t corners, Place place);

  const std::string& file_name() const { return source_.file_name; }
  std::size_t file_size() const { return source_.bytes.size(); }

  bool has_errors() const { return error_count_ > 0; }

  /// To be called for every element; reports how far it is now and then.
  /// @throws Cancelled
  void tick(std::size_t position) {
    if (++ticks_ % ticks_per_report == 0) report(position);
  }

  /// Throws all errors if there are any, else gives the warnings.
  Findings finish();

 private:
  static constexpr std::size_t ticks_per_report = std::size_t{1} << 16;

  void report(std::size_t position);
  bool counts_as_new(const std::string& code);
  Finding located(Finding finding, Place place, std::vector<Subject> elements) const;
  void append_counts_of_more();
  [[noreturn]] void throw_errors();

  const MeshSource& source_;
  Progress& progress_;
  Findings findings_;
  std::map<std::string, std::size_t> counts_;
  std::size_t error_count_ = 0;
  std::size_t ticks_ = 0;
};

/// Subjects for one element by its 0-based index.
std::vector<Subject> vertex_subject(std::size_t vertex);
std::vector<Subject> face_subject(std::size_t face);

}  // namespace croquis

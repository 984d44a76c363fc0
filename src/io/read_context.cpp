// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/read_context.h"

#include "croquis/base/error.h"
#include "croquis/base/limits.h"

namespace croquis {
namespace {

constexpr std::size_t findings_per_code = 100;  // more of one code don't help and cost memory
constexpr std::size_t errors_before_giving_up = 10000;

bool is_warning_code(const std::string& code) { return code.starts_with("W_"); }

}  // namespace

std::vector<Subject> vertex_subject(std::size_t vertex) { return {numbered_subject(SubjectKind::Vertex, vertex)}; }

std::vector<Subject> face_subject(std::size_t face) { return {numbered_subject(SubjectKind::Face, face)}; }

void ReadContext::error(const char* code, const std::string& message, Place place, std::vector<Subject> elements) {
  ++error_count_;
  if (counts_as_new(code)) {
    findings_.push_back(located(make_error(Category::Malformed, code, message), place, std::move(elements)));
  }
  if (error_count_ >= errors_before_giving_up) throw_errors();
}

void ReadContext::fail(const char* code, const std::string& message, Place place) {
  error(code, message, place);
  throw_errors();
}

void ReadContext::warn(const char* code, const std::string& message, Place place, std::vector<Subject> elements) {
  if (!counts_as_new(code)) return;
  findings_.push_back(located(make_warning(Category::Malformed, code, message), place, std::move(elements)));
}

void ReadContext::not_finite(std::size_t vertex, Place place) {
  const std::string what = "vertex " + std::to_string(vertex) + " has a coordinate that " + unusable_words;
  if (source_.keep_not_finite) {
    warn("W_NOT_FINITE", what, place, vertex_subject(vertex));
  } else {
    error("E_NOT_FINITE", what + "; repair it or drop it", place, vertex_subject(vertex));
  }
}

void ReadContext::bad_index(std::size_t face, std::int64_t shown, std::size_t vertex_count, Place place) {
  error("E_INDEX",
        "face " + std::to_string(face) + " uses vertex " + std::to_string(shown) + ", but the file has " +
            std::to_string(vertex_count) + " vertices",
        place, face_subject(face));
}

void ReadContext::too_few_corners(std::size_t face, std::size_t corners, Place place) {
  error("E_FACE_DEGENERATE",
        "face " + std::to_string(face) + " has " + std::to_string(corners) + " corners, and a face needs at least 3",
        place, face_subject(face));
}

Findings ReadContext::finish() {
  if (has_errors()) throw_errors();
  append_counts_of_more();
  return std::move(findings_);
}

void ReadContext::report(std::size_t position) {
  progress_.report(static_cast<double>(position) / static_cast<double>(source_.bytes.size()));
}

bool ReadContext::counts_as_new(const std::string& code) { return ++counts_[code] <= findings_per_code; }

Finding ReadContext::located(Finding finding, Place place, std::vector<Subject> elements) const {
  std::string where = "'" + source_.file_name + "'";
  Subject file{SubjectKind::File, source_.file_name, source_.file_name, std::nullopt, {}};
  if (place.kind == Place::Kind::Line) {
    where += ", line " + std::to_string(place.number);
    file.line = place.number;
  } else if (place.kind == Place::Kind::Byte) {
    where += ", byte " + std::to_string(place.number);
  }
  finding.message = where + ": " + finding.message + ".";
  finding.subjects.push_back(std::move(file));
  for (Subject& element : elements) finding.subjects.push_back(std::move(element));
  return finding;
}

void ReadContext::append_counts_of_more() {
  for (const auto& [code, count] : counts_) {
    if (count <= findings_per_code) continue;
    const std::string more = std::to_string(count - findings_per_code) + " more findings of this kind are not listed";
    const Finding finding = is_warning_code(code) ? make_warning(Category::Malformed, code, more)
                                                  : make_error(Category::Malformed, code, more);
    findings_.push_back(located(finding, {}, {}));
  }
}

void ReadContext::throw_errors() {
  append_counts_of_more();
  throw Error(std::move(findings_));
}

}  // namespace croquis

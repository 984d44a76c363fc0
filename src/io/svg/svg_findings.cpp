// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "croquis/base/error.h"
#include "io/svg/svg_walk.h"

namespace croquis {
namespace {

constexpr std::size_t most_of_a_code = 100;

}  // namespace

void SvgFindings::add(Finding finding) {
  const std::size_t count = ++counts_[finding.code];
  if (count <= most_of_a_code) findings_.push_back(std::move(finding));
}

void SvgFindings::file_error(Category category, const char* code, const std::string& message,
                             std::optional<std::int64_t> line) {
  add(make_error(category, code, message, {{SubjectKind::File, file_, file_, line, {}}}));
}

void SvgFindings::stroke_error(Category category, const char* code, const std::string& message,
                               const std::string& stroke, std::int64_t line) {
  add(make_error(category, code, message, {{SubjectKind::Stroke, stroke, file_, line, {}}}));
}

void SvgFindings::stroke_warning(const char* code, const std::string& message, const std::string& stroke,
                                 std::int64_t line) {
  add(make_warning(Category::Malformed, code, message, {{SubjectKind::Stroke, stroke, file_, line, {}}}));
}

void SvgFindings::stroke_note(const char* code, const std::string& message, const std::string& stroke,
                              std::int64_t line) {
  Finding note = make_warning(Category::Malformed, code, message, {{SubjectKind::Stroke, stroke, file_, line, {}}});
  note.severity = Severity::Info;
  add(std::move(note));
}

void SvgFindings::file_warning(const char* code, const std::string& message, std::int64_t line) {
  add(make_warning(Category::Malformed, code, message, {{SubjectKind::File, file_, file_, line, {}}}));
}

void SvgFindings::stop_on_errors() {
  if (has_errors(findings_)) throw Error(take());
}

Findings SvgFindings::take() {
  for (const auto& entry : counts_) {
    const std::string& code = entry.first;
    const std::size_t count = entry.second;
    if (count <= most_of_a_code) continue;
    const auto last =
        std::find_if(findings_.rbegin(), findings_.rend(), [&](const Finding& f) { return f.code == code; });
    Finding rest = *last;
    rest.message = std::to_string(count - most_of_a_code) + " more findings of the kind " + code + " are not listed";
    rest.subjects = {{SubjectKind::File, file_, file_, std::nullopt, {}}};
    findings_.push_back(std::move(rest));
  }
  counts_.clear();
  return std::move(findings_);
}

std::int64_t LineCounter::line_at(std::size_t position) {
  position = std::min(position, text_.size());
  if (position < position_) {
    position_ = 0;
    line_ = 1;
  }
  const auto from = text_.begin() + static_cast<std::ptrdiff_t>(position_);
  const auto to = text_.begin() + static_cast<std::ptrdiff_t>(position);
  line_ += std::count(from, to, '\n');
  position_ = position;
  return line_;
}

}  // namespace croquis

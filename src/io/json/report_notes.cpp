// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "io/json/report_reader.h"
#include "io/text.h"

namespace croquis {
namespace {

constexpr std::size_t most_notes = 100;

}  // namespace

void ReportNotes::add(Finding error) {
  if (errors_.size() < most_notes) errors_.push_back(std::move(error));
}

void ReportNotes::refuse(const char* code, const std::string& place, const std::string& what) {
  const std::string where = place.empty() ? who_ + ": " : who_ + ", " + place + ": ";
  add(make_error(Category::Malformed, code, where + what + ".", subjects_));
}

void ReportNotes::note_unknown(const Report& object, const char* what, std::initializer_list<std::string_view> known) {
  for (const auto& [key, value] : object.as_object()) {
    const bool is_known = std::ranges::find(known, std::string_view(key)) != known.end();
    if (!is_known && ignored_.size() < most_notes) ++ignored_[in_quotes(key) + " of " + what];
  }
}

Findings ReportNotes::finish() {
  if (!errors_.empty()) throw Error(std::move(errors_));
  Findings warnings;
  for (const auto& [name, count] : ignored_) {
    warnings.push_back(make_warning(
        Category::Malformed, "W_IGNORED",
        who_ + ": " + std::to_string(count) + " " + name + " were passed over: " + format_ + " has no such member.",
        subjects_));
  }
  return warnings;
}

}  // namespace croquis

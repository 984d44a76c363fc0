// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <initializer_list>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "croquis/base/error.h"
#include "croquis/base/limits.h"
#include "croquis/base/report.h"

namespace croquis {

/// A report of that type, or null.
template <typename T>
const T* report_as(const Report* report) {
  return report == nullptr ? nullptr : std::get_if<T>(&report->value());
}

/// The member of an object; null where there is none, and of what is no object.
inline const Report* member_of(const Report& object, std::string_view key) {
  return report_as<Report::Object>(&object) == nullptr ? nullptr : object.find(key);
}

inline bool is_number(const Report* report) {
  return report_as<std::int64_t>(report) != nullptr || report_as<double>(report) != nullptr;
}

/// A usable number (limits.h).
inline std::optional<double> number_of(const Report* report) {
  if (!is_number(report) || !is_usable_number(report->as_number())) return std::nullopt;
  return report->as_number();
}

/// Exactly so many usable numbers.
template <std::size_t N>
std::optional<std::array<double, N>> numbers_of(const Report* report) {
  const auto* list = report_as<Report::Array>(report);
  if (list == nullptr || list->size() != N) return std::nullopt;
  std::array<double, N> result{};
  for (std::size_t i = 0; i < N; ++i) {
    const std::optional<double> number = number_of(&(*list)[i]);
    if (!number) return std::nullopt;
    result[i] = *number;
  }
  return result;
}

/// The value of an enumeration that a word stands for. @param words of its values, in their order
template <typename Enum, std::size_t N>
std::optional<Enum> value_of_word(std::string_view word, const std::array<const char*, N>& words) {
  for (std::size_t i = 0; i < N; ++i) {
    if (word == words[i]) return static_cast<Enum>(i);
  }
  return std::nullopt;
}

template <typename Enum, std::size_t N>
const char* word_of(Enum value, const std::array<const char*, N>& words) {
  return words[static_cast<std::size_t>(value)];
}

/// What is wrong with a report, and the members that its format doesn't have: at most a hundred of each.
class ReportNotes {
 public:
  /// @param who what sentences call the report  @param subjects of all findings
  ReportNotes(std::string who, const char* format, std::vector<Subject> subjects = {})
      : who_(std::move(who)), format_(format), subjects_(std::move(subjects)) {}

  void add(Finding error);
  std::size_t error_count() const { return errors_.size(); }

  /// @param place such as edges[3].v, empty for the whole report
  void refuse(const char* code, const std::string& place, const std::string& what);

  /// @param what people call objects with these members
  void note_unknown(const Report& object, const char* what, std::initializer_list<std::string_view> known);

  /// W_IGNORED for each name of a member that was passed over.
  /// @throws Error with all that is wrong, if anything is
  Findings finish();

 private:
  std::string who_;
  const char* format_;
  std::vector<Subject> subjects_;
  Findings errors_;
  std::map<std::string, std::size_t> ignored_;
};

}  // namespace croquis

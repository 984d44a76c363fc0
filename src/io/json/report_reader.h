// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>

#include "croquis/base/error.h"
#include "croquis/base/limits.h"
#include "croquis/base/report.h"

namespace croquis {

/// A report of that type, or null.
template <typename T>
const T* report_as(const Report* report) {
  return report == nullptr ? nullptr : std::get_if<T>(&report->value());
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

}  // namespace croquis

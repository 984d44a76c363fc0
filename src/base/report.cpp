// SPDX-License-Identifier: GPL-3.0-or-later
#include "croquis/base/report.h"

#include <stdexcept>

namespace croquis {

Report& Report::set(std::string key, Report value) {
  if (is_null()) value_ = Object{};
  for (Member& member : std::get<Object>(value_)) {
    if (member.first == key) {
      member.second = std::move(value);
      return *this;
    }
  }
  std::get<Object>(value_).emplace_back(std::move(key), std::move(value));
  return *this;
}

void Report::push(Report value) {
  if (is_null()) value_ = Array{};
  std::get<Array>(value_).push_back(std::move(value));
}

const Report* Report::find(std::string_view key) const {
  const Object* object = std::get_if<Object>(&value_);
  if (object == nullptr) return nullptr;
  for (const Member& member : *object) {
    if (member.first == key) return &member.second;
  }
  return nullptr;
}

const Report& Report::at(std::string_view key) const {
  const Report* member = find(key);
  if (member == nullptr) throw std::out_of_range("no member " + std::string(key));
  return *member;
}

std::int64_t Report::as_integer() const { return std::get<std::int64_t>(value_); }

double Report::as_number() const {
  if (const auto* integer = std::get_if<std::int64_t>(&value_)) return static_cast<double>(*integer);
  return std::get<double>(value_);
}

}  // namespace croquis

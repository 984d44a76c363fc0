// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace croquis {

/// A small tree of named figures: what an operation reports about its result.
///
/// Free of any file format, so that operations, panels and the command line share one value; keys keep the order in
/// which they were set.
class Report {
 public:
  using Array = std::vector<Report>;
  using Member = std::pair<std::string, Report>;
  using Object = std::vector<Member>;
  using Value = std::variant<std::monostate, bool, std::int64_t, double, std::string, Array, Object>;

  Report() = default;
  Report(bool value) : value_(value) {}
  Report(int value) : value_(std::int64_t{value}) {}
  Report(std::uint32_t value) : value_(std::int64_t{value}) {}
  Report(std::int64_t value) : value_(value) {}
  Report(std::size_t value) : value_(static_cast<std::int64_t>(value)) {}
  Report(double value) : value_(value) {}
  Report(const char* value) : value_(std::string(value)) {}
  Report(std::string value) : value_(std::move(value)) {}
  Report(Array value) : value_(std::move(value)) {}

  static Report object() { return Report(Value(Object{})); }
  static Report array() { return Report(Value(Array{})); }

  /// An object of these members, whose keys differ: for readers of many, since `set` looks through all of them.
  static Report of_members(Object members) { return Report(Value(std::move(members))); }

  /// An array of anything a Report can be made of.
  template <typename Range>
  static Report list(const Range& range) {
    Array array;
    for (const auto& element : range) array.emplace_back(element);
    return Report(std::move(array));
  }

  const Value& value() const { return value_; }

  /// Sets a member; null becomes an object first. Returns *this to chain.
  Report& set(std::string key, Report value);

  /// Appends an element; null becomes an array first.
  void push(Report value);

  /// The member of that name, or null when there is none.
  const Report* find(std::string_view key) const;

  /// Member access for readers that know the key is there.
  /// @throws std::out_of_range
  const Report& at(std::string_view key) const;

  bool is_null() const { return std::holds_alternative<std::monostate>(value_); }
  std::int64_t as_integer() const;  ///< @throws std::bad_variant_access
  double as_number() const;         ///< an integer counts as a number. @throws std::bad_variant_access
  const std::string& as_string() const { return std::get<std::string>(value_); }
  const Array& as_array() const { return std::get<Array>(value_); }
  const Object& as_object() const { return std::get<Object>(value_); }

 private:
  explicit Report(Value value) : value_(std::move(value)) {}

  Value value_;
};

}  // namespace croquis

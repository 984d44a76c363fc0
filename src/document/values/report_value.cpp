// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <variant>

#include "croquis/base/error.h"
#include "croquis/base/limits.h"
#include "croquis/base/report.h"
#include "document/values/member_bytes.h"

namespace croquis {

inline auto members(const Report& report) { return std::tie(report.value()); }

namespace {

bool is_deeper_than(const Report& report, int levels) {
  if (levels < 0) return true;
  const auto* array = std::get_if<Report::Array>(&report.value());
  const auto* object = std::get_if<Report::Object>(&report.value());
  return (array != nullptr &&
          std::ranges::any_of(*array, [&](const Report& element) { return is_deeper_than(element, levels - 1); })) ||
         (object != nullptr &&
          std::ranges::any_of(*object, [&](const auto& member) { return is_deeper_than(member.second, levels - 1); }));
}

Report read_tree(ByteReader& reader, int depth);

Report read_array(ByteReader& reader, int depth) {
  Report::Array array;
  for (std::size_t left = reader.count(1); left > 0; --left) array.push_back(read_tree(reader, depth + 1));
  return Report(std::move(array));
}

Report read_object(ByteReader& reader, int depth) {
  Report::Object object;
  for (std::size_t left = reader.count(1 + sizeof(std::uint64_t)); left > 0; --left) {
    std::string key = reader.text();
    object.emplace_back(std::move(key), read_tree(reader, depth + 1));
  }
  return Report::of_members(std::move(object));
}

// The cases are the alternatives of Report::Value in their order.
Report read_tree(ByteReader& reader, int depth) {
  if (depth > deepest_nesting) throw BadBytes("it is nested too deeply");
  switch (reader.number<std::uint8_t>()) {
    case 0: return {};
    case 1: return reader.flag();
    case 2: return reader.number<std::int64_t>();
    case 3: return reader.number<double>();
    case 4: return reader.text();
    case 5: return read_array(reader, depth);
    case 6: return read_object(reader, depth);
    default: throw BadBytes("a report's kind of value is not known");
  }
}

/// Figures as a tree, which has no place in space.
struct ReportValue : ListedValue<Report> {
  static constexpr const char* name = "report";
  static constexpr std::uint64_t tag = 2;

  static void store(const Report& report, ByteWriter& writer) {
    if (is_deeper_than(report, deepest_nesting)) {
      throw Error(make_error(Category::Limit, "E_LIMIT",
                             "A report is nested deeper than " + std::to_string(deepest_nesting) +
                                 " levels, more than a project file can hold; remove that node."));
    }
    ListedValue::store(report, writer);
  }

  static Report load(ByteReader& reader) {
    read_layout(reader, layout);
    return read_tree(reader, 0);
  }
};

}  // namespace

constinit const ValueTraits ValueTraits::Report = value_row<ReportValue>();

}  // namespace croquis

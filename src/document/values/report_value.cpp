// SPDX-License-Identifier: GPL-3.0-or-later
#include <type_traits>
#include <variant>

#include "croquis/base/error.h"
#include "croquis/base/limits.h"
#include "document/content_size.h"
#include "document/values/value_row.h"

namespace croquis {
namespace {

constexpr std::uint32_t report_layout = 1;

/// Deeper trees would need a deep call stack to be read. Ours have fewer than ten levels.

void write_tree(const Report& report, int depth, ByteWriter& writer);

struct TreeWriter {
  int depth;
  ByteWriter& writer;
  void operator()(std::monostate) const {}
  void operator()(bool value) const { writer.flag(value); }
  void operator()(std::int64_t value) const { writer.number(value); }
  void operator()(double value) const { writer.number(value); }
  void operator()(const std::string& value) const { writer.text(value); }
  void operator()(const Report::Array& array) const {
    writer.count(array.size());
    for (const Report& element : array) write_tree(element, depth + 1, writer);
  }
  void operator()(const Report::Object& object) const {
    writer.count(object.size());
    for (const auto& [key, member] : object) {
      writer.text(key);
      write_tree(member, depth + 1, writer);
    }
  }
};

void write_tree(const Report& report, int depth, ByteWriter& writer) {
  if (depth > deepest_nesting) {
    throw Error(make_error(Category::Limit, "E_LIMIT",
                           "A report is nested deeper than " + std::to_string(deepest_nesting) +
                               " levels, more than a project file can hold; remove that node."));
  }
  writer.number(static_cast<std::uint8_t>(report.value().index()));
  std::visit(TreeWriter{depth, writer}, report.value());
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

void hash_tree(const Report& report, ContentHasher& hasher) {
  hasher.add(report.value().index());
  std::visit(
      [&](const auto& value) {
        using Kind = std::decay_t<decltype(value)>;
        if constexpr (std::is_same_v<Kind, Report::Array>) {
          hasher.add(value.size());
          for (const Report& element : value) hash_tree(element, hasher);
        } else if constexpr (std::is_same_v<Kind, Report::Object>) {
          hasher.add(value.size());
          for (const auto& [key, member] : value) {
            hasher.add(key);
            hash_tree(member, hasher);
          }
        } else if constexpr (!std::is_same_v<Kind, std::monostate>) {
          hasher.add(value);
        }
      },
      report.value());
}

std::size_t tree_size(const Report& report) {
  std::size_t bytes = sizeof(Report);
  if (const auto* text = std::get_if<std::string>(&report.value())) bytes += text->capacity();
  if (const auto* array = std::get_if<Report::Array>(&report.value())) {
    for (const Report& element : *array) bytes += tree_size(element);
  }
  if (const auto* object = std::get_if<Report::Object>(&report.value())) {
    for (const auto& [key, member] : *object) bytes += size_of(key) + tree_size(member);
  }
  return bytes;
}

/// Figures as a tree, which has no place in space.
struct ReportValue {
  using Content = Report;
  static constexpr const char* name = "report";
  static constexpr std::uint64_t tag = 2;

  static void add_content(const Report& report, ContentHasher& hasher) { hash_tree(report, hasher); }
  static std::size_t byte_size(const Report& report) { return tree_size(report); }

  static void store(const Report& report, ByteWriter& writer) {
    writer.number(report_layout);
    write_tree(report, 0, writer);
  }

  static Report load(ByteReader& reader) {
    read_layout(reader, report_layout);
    return read_tree(reader, 0);
  }
};

}  // namespace

constinit const ValueTraits ValueTraits::Report = value_row<ReportValue>();

}  // namespace croquis

// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/report_table.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>
#include <vector>

#include "cli/mesh_text.h"

namespace croquis::cli {
namespace {

/// One text per row, the key first.
using Column = std::vector<std::string>;

constexpr const char* unknown = "-";

/// Of what isn't a number, NaN.
double number_in(const Report& part) {
  const auto* number = std::get_if<double>(&part.value());
  return number == nullptr ? std::nan("") : *number;
}

std::string cell_text(const Report* cell) {
  if (cell == nullptr) return unknown;
  struct Visitor {
    std::string operator()(std::int64_t value) const { return std::to_string(value); }
    std::string operator()(double value) const { return number_text(value); }
    std::string operator()(bool value) const { return value ? "yes" : "no"; }
    std::string operator()(const std::string& value) const { return value; }
    std::string operator()(std::monostate) const { return unknown; }
    std::string operator()(const Report::Array& array) const {
      constexpr std::size_t most_shown = 8;
      if (array.size() > most_shown) return std::to_string(array.size()) + " values";
      double largest = 0;
      for (const Report& part : array) largest = std::max(largest, std::abs(number_in(part)));
      std::string text;
      for (const Report& part : array) {
        // What rounding left of a zero.
        const bool is_zero = std::abs(number_in(part)) <= 1e-9 * largest;
        text += (text.empty() ? "" : " ") + (is_zero ? "0" : cell_text(&part));
      }
      return text.empty() ? unknown : text;
    }
    std::string operator()(const Report::Object&) const { return unknown; }
  };
  return std::visit(Visitor{}, cell->value());
}

Column column_of(const Report& list, const std::string& key) {
  Column column = {key};
  for (const Report& row : list.as_array()) column.push_back(cell_text(row.find(key)));
  return column;
}

bool says_something(const Column& column) {
  return std::any_of(column.begin() + 1, column.end(), [](const std::string& cell) { return cell != unknown; });
}

std::size_t width_of(const Column& column) {
  std::size_t width = 0;
  for (const std::string& cell : column) width = std::max(width, cell.size());
  return width;
}

/// Without the blanks at its end.
std::string trimmed(std::string line) {
  line.erase(line.find_last_not_of(' ') + 1);
  return line;
}

}  // namespace

std::string report_table(const Report& list) {
  if (list.as_array().empty()) return "";
  std::vector<Column> columns;
  for (const auto& [key, value] : list.as_array().front().as_object()) {
    Column column = column_of(list, key);
    if (says_something(column)) columns.push_back(std::move(column));
  }
  std::string table;
  for (std::size_t row = 0; row <= list.as_array().size(); ++row) {
    std::string line;
    for (const Column& column : columns) {
      line += column[row] + std::string(width_of(column) - column[row].size() + 2, ' ');
    }
    table += (row == 0 ? "" : "\n") + trimmed(std::move(line));
  }
  return table;
}

std::string list_text(const Report& details) {
  std::string text;
  for (const auto& [key, value] : details.as_object()) {
    const auto* words = std::get_if<std::string>(&value.value());
    const auto* rows = std::get_if<Report::Array>(&value.value());
    const std::string part = words != nullptr ? *words : rows != nullptr ? report_table(value) : "";
    if (!part.empty()) text += (text.empty() ? "" : "\n") + part;
  }
  return text;
}

}  // namespace croquis::cli

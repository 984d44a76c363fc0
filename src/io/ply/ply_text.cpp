// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "io/ply/ply_columns.h"
#include "io/text.h"

namespace croquis {
namespace {

// Some exporters write integers as 255.0.
template <typename T>
bool parse_value(std::string_view word, T& value) {
  if (parse_number(word, value)) return true;
  if constexpr (std::is_integral_v<T>) {
    double number = 0;
    if (!parse_number(word, number) || number != std::floor(number)) return false;
    if (number < static_cast<double>(std::numeric_limits<T>::min())) return false;
    if (number > static_cast<double>(std::numeric_limits<T>::max())) return false;
    value = static_cast<T>(number);
    return true;
  }
  return false;
}

class TextRows {
 public:
  TextRows(std::string_view bytes, PlyCursor& cursor, bool keep, PlyTable& table, ReadContext& context)
      : lines_(bytes, cursor.byte, cursor.line), cursor_(cursor), keep_(keep), table_(table), context_(context) {}

  void read() {
    for (std::size_t row = 0; row < table_.element.count; ++row) {
      const TextLine line = next_line(row);
      context_.tick(lines_.position());
      line_ = line.number;
      WordReader words(line.text);
      bool good = true;
      for (std::size_t i = 0; good && i < table_.columns.size(); ++i) good = read_property(table_.columns[i], words);
      if (good && !words.next().empty()) {
        context_.error("E_COUNT", "the line has more values than " + in_quotes(table_.element.name) + " has properties",
                       at_line(line_));
      }
      if (!good) pad(row + 1);
    }
    cursor_ = {lines_.position(), lines_.line_number() + 1};
  }

 private:
  TextLine next_line(std::size_t row) {
    TextLine line;
    bool found = lines_.next(line);
    while (found && trimmed(line.text).empty()) found = lines_.next(line);
    if (!found) {
      context_.fail("E_TRUNCATED",
                    "the file ends after " + std::to_string(row) + " of " + std::to_string(table_.element.count) +
                        " elements " + in_quotes(table_.element.name),
                    at_line(lines_.line_number()));
    }
    if (row == 0 || line.number != line_ + 1) table_.lines.emplace_back(row, line.number);
    return line;
  }

  template <typename T>
  bool read_value(std::vector<T>& values, WordReader& words) {
    const std::string_view word = words.next();
    T value{};
    if (word.empty()) {
      context_.error("E_COUNT", "the line has too few values for " + in_quotes(table_.element.name), at_line(line_));
      return false;
    }
    if (!parse_value(word, value)) {
      context_.error("E_SYNTAX", in_quotes(word) + " is not a value of type " + name_of(type_), at_line(line_));
      return false;
    }
    if (keep_) values.push_back(value);
    return true;
  }

  bool read_property(PlyColumn& column, WordReader& words) {
    type_ = column.property.type;
    return std::visit(
        [&](auto& values) {
          if (!column.property.is_list) return read_value(values, words);
          std::int64_t length = 0;
          if (!read_length(words, length)) return false;
          for (std::int64_t i = 0; i < length; ++i) {
            if (!read_value(values, words)) return false;
          }
          column.list_ends.push_back(static_cast<Index>(values.size()));
          return true;
        },
        column.values);
  }

  bool read_length(WordReader& words, std::int64_t& length) {
    const std::string_view word = words.next();
    if (parse_value(word, length) && length >= 0) return true;
    context_.error("E_COUNT", in_quotes(word) + " is not the length of a list", at_line(line_));
    return false;
  }

  // After an error only the numbering of rows matters: nothing of this file will be used.
  void pad(std::size_t rows) {
    for (PlyColumn& column : table_.columns) {
      std::visit(
          [&](auto& values) {
            if (!column.property.is_list && keep_) values.resize(rows);
            if (column.property.is_list) column.list_ends.resize(rows, static_cast<Index>(values.size()));
          },
          column.values);
    }
  }

  LineReader lines_;
  PlyCursor& cursor_;
  bool keep_;
  PlyTable& table_;
  ReadContext& context_;
  std::int64_t line_ = 0;
  PlyType type_ = PlyType::Float32;
};

}  // namespace

PlyTable read_ply_text(std::string_view bytes, const PlyElement& element, bool keep, PlyCursor& cursor,
                       ReadContext& context) {
  PlyTable table{element, empty_columns(element), PlyEncoding::Ascii, cursor.byte, {}};
  TextRows(bytes, cursor, keep, table, context).read();
  return table;
}

}  // namespace croquis

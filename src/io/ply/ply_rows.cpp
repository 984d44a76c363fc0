// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>

#include "io/ply/ply_tables.h"
#include "io/text.h"

namespace croquis {
namespace {

template <typename T>
T load(const char* from, bool swap) {
  std::array<char, sizeof(T)> bytes;
  std::memcpy(bytes.data(), from, sizeof(T));
  if (swap) std::reverse(bytes.begin(), bytes.end());
  return std::bit_cast<T>(bytes);
}

std::int64_t load_integer(const char* from, PlyType type, bool swap) {
  switch (type) {
    case PlyType::Int8: return load<std::int8_t>(from, swap);
    case PlyType::Uint8: return load<std::uint8_t>(from, swap);
    case PlyType::Int16: return load<std::int16_t>(from, swap);
    case PlyType::Uint16: return load<std::uint16_t>(from, swap);
    case PlyType::Int32: return load<std::int32_t>(from, swap);
    case PlyType::Uint32: return load<std::uint32_t>(from, swap);
    default: return -1;
  }
}

class BinaryRows {
 public:
  BinaryRows(std::string_view bytes, PlyCursor& cursor, bool keep, PlyTable& table, ReadContext& context)
      : bytes_(bytes),
        cursor_(cursor),
        keep_(keep),
        swap_((table.encoding == PlyEncoding::BigEndian) != (std::endian::native == std::endian::big)),
        table_(table),
        context_(context) {}

  void read() {
    const bool has_list = std::any_of(table_.columns.begin(), table_.columns.end(),
                                      [](const PlyColumn& column) { return column.property.is_list; });
    has_list ? read_rows() : read_fixed_rows();
  }

 private:
  // The header was checked against the file's size, but lists of elements before this one may have used it up.
  void require(std::size_t size, std::size_t row) {
    if (size <= bytes_.size() - cursor_.byte) return;
    context_.fail("E_TRUNCATED",
                  "the file ends in element " + std::to_string(row) + " of " + std::to_string(table_.element.count) +
                      " elements " + in_quotes(table_.element.name),
                  at_byte(cursor_.byte));
  }

  void read_fixed_rows() {
    std::size_t row_size = 0;
    for (const PlyColumn& column : table_.columns) row_size += size_of(column.property.type);
    if (row_size == 0) return;
    const std::size_t fitting = (bytes_.size() - cursor_.byte) / row_size;
    if (fitting < table_.element.count) {
      cursor_.byte += fitting * row_size;
      require(row_size, fitting);
    }
    std::size_t offset = cursor_.byte;
    for (PlyColumn& column : table_.columns) {
      if (keep_) read_strided(column, offset, row_size);
      offset += size_of(column.property.type);
    }
    cursor_.byte += row_size * table_.element.count;
  }

  void read_strided(PlyColumn& column, std::size_t offset, std::size_t stride) {
    std::visit(
        [&]<typename T>(std::vector<T>& values) {
          values.resize(table_.element.count);
          const char* from = bytes_.data() + offset;
          for (T& value : values) {
            context_.tick(static_cast<std::size_t>(from - bytes_.data()));
            value = load<T>(from, swap_);
            from += stride;
          }
        },
        column.values);
  }

  void read_rows() {
    for (std::size_t row = 0; row < table_.element.count; ++row) {
      context_.tick(cursor_.byte);
      for (PlyColumn& column : table_.columns) {
        const std::size_t count = column.property.is_list ? read_length(column, row) : 1;
        read_values(column, count, row);
      }
    }
  }

  std::size_t read_length(const PlyColumn& column, std::size_t row) {
    const std::size_t size = size_of(column.property.count_type);
    require(size, row);
    const std::int64_t length = load_integer(bytes_.data() + cursor_.byte, column.property.count_type, swap_);
    if (length < 0) {
      context_.fail("E_COUNT", "a list has the length " + std::to_string(length), at_byte(cursor_.byte));
    }
    cursor_.byte += size;
    return static_cast<std::size_t>(length);
  }

  void read_values(PlyColumn& column, std::size_t count, std::size_t row) {
    const std::size_t size = count * size_of(column.property.type);
    require(size, row);
    std::visit(
        [&]<typename T>(std::vector<T>& values) {
          if (row == 0 && keep_) make_room(values, column.list_ends, count);
          const char* from = bytes_.data() + cursor_.byte;
          for (std::size_t i = 0; keep_ && i < count; ++i) values.push_back(load<T>(from + i * sizeof(T), swap_));
          if (column.property.is_list && keep_) column.list_ends.push_back(static_cast<Index>(values.size()));
        },
        column.values);
    cursor_.byte += size;
  }

  /// For rows that are all as long as the first one, as far as the file has room for them.
  template <typename T>
  void make_room(std::vector<T>& values, std::vector<Index>& ends, std::size_t first_count) const {
    const std::size_t rows = table_.element.count;
    values.reserve(std::min(rows * std::min(first_count, bytes_.size()), (bytes_.size() - cursor_.byte) / sizeof(T)));
    ends.reserve(std::min(rows, bytes_.size()));
  }

  std::string_view bytes_;
  PlyCursor& cursor_;
  bool keep_;
  bool swap_;
  PlyTable& table_;
  ReadContext& context_;
};

}  // namespace

PlyTable read_ply_binary(std::string_view bytes, const PlyElement& element, PlyEncoding encoding, bool keep,
                         PlyCursor& cursor, ReadContext& context) {
  PlyTable table{element, empty_columns(element), encoding, cursor.byte, {}};
  BinaryRows(bytes, cursor, keep, table, context).read();
  return table;
}

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

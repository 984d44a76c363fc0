// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <set>

#include "io/ply/ply_tables.h"
#include "io/text.h"

namespace croquis {
namespace {

struct TypeName {
  const char* first;   // the original name
  const char* second;  // its later alias
  PlyType type;
  std::size_t size;
};

constexpr std::array type_names = {
    TypeName{"char", "int8", PlyType::Int8, 1},        TypeName{"uchar", "uint8", PlyType::Uint8, 1},
    TypeName{"short", "int16", PlyType::Int16, 2},     TypeName{"ushort", "uint16", PlyType::Uint16, 2},
    TypeName{"int", "int32", PlyType::Int32, 4},       TypeName{"uint", "uint32", PlyType::Uint32, 4},
    TypeName{"float", "float32", PlyType::Float32, 4}, TypeName{"double", "float64", PlyType::Float64, 8}};

std::optional<PlyType> type_named(std::string_view name) {
  for (const TypeName& candidate : type_names) {
    if (name == candidate.first || name == candidate.second) return candidate.type;
  }
  return std::nullopt;
}

class HeaderReader {
 public:
  HeaderReader(std::string_view bytes, ReadContext& context) : bytes_(bytes), context_(context) {}

  PlyHeader read() {
    const bool returns_only = find_line_end();
    LineReader lines(returns_only ? bytes_.substr(0, header_end()) : bytes_);
    TextLine line;
    if (!lines.next(line) || trimmed(line.text) != "ply") {
      context_.fail("E_SYNTAX", "a PLY file begins with the line 'ply'", at_line(1));
    }
    while (true) {
      if (!lines.next(line)) context_.fail("E_TRUNCATED", "the header has no end_header", at_line(line.number));
      line_ = line.number;
      WordReader words(line.text);
      const std::string_view keyword = words.next();
      if (keyword == "end_header") break;
      handle(keyword, words);
    }
    header_.body = lines.position();
    header_.body_line = line_ + 1;
    if (!has_format_) fail_syntax("the header names no format");
    check_sizes();
    return std::move(header_);
  }

 private:
  [[noreturn]] void fail_syntax(const std::string& message) { context_.fail("E_SYNTAX", message, at_line(line_)); }

  // Binary data may hold any byte, so the header's own first line decides how its lines end.
  bool find_line_end() const { return bytes_.size() > 4 && bytes_[3] == '\r' && bytes_[4] != '\n'; }

  std::size_t header_end() const {
    const std::size_t end = bytes_.find("\rend_header\r");
    return end == std::string_view::npos ? bytes_.size() : end + 12;
  }

  void handle(std::string_view keyword, WordReader& words) {
    if (keyword == "format") return read_format(words);
    if (keyword == "element") return read_element(words);
    if (keyword == "property") return read_property(words);
    if (keyword == "obj_info") return read_object_info(words);
    if (keyword == "comment" || keyword.empty()) return;
    fail_syntax(in_quotes(keyword) + " does not belong in a PLY header");
  }

  void read_format(WordReader& words) {
    const std::string_view name = words.next();
    if (name == "ascii") {
      header_.encoding = PlyEncoding::Ascii;
    } else if (name == "binary_little_endian") {
      header_.encoding = PlyEncoding::LittleEndian;
    } else if (name == "binary_big_endian") {
      header_.encoding = PlyEncoding::BigEndian;
    } else {
      fail_syntax(in_quotes(name) + " is not a PLY format");
    }
    if (words.next() != "1.0") fail_syntax("only version 1.0 of PLY is known");
    has_format_ = true;
  }

  void read_element(WordReader& words) {
    PlyElement element;
    element.name = words.next();
    const std::string_view count = words.next();
    if (element.name.empty()) fail_syntax("an element needs a name and a count");
    if (!parse_number(count, element.count)) {
      context_.fail("E_COUNT", in_quotes(count) + " is not a number of elements", at_line(line_));
    }
    if (!element_names_.insert(element.name).second)
      fail_syntax("the element " + in_quotes(element.name) + " comes twice");
    property_names_.clear();
    header_.elements.push_back(std::move(element));
  }

  void read_property(WordReader& words) {
    if (header_.elements.empty()) fail_syntax("a property stands before the first element");
    PlyProperty property;
    WordReader ahead = words;
    property.is_list = ahead.next() == "list";
    if (property.is_list) {
      words = ahead;
      property.count_type = read_type(words);
      if (!is_integer(property.count_type)) fail_syntax("the length of a list must be an integer");
    }
    property.type = read_type(words);
    property.name = words.next();
    if (property.name.empty()) fail_syntax("a property needs a name");
    if (!property_names_.insert(property.name).second) {
      fail_syntax("the property " + in_quotes(property.name) + " comes twice");
    }
    header_.elements.back().properties.push_back(std::move(property));
  }

  // Programs write anything behind obj_info; only a scan's grid is asked for.
  void read_object_info(WordReader& words) {
    const std::string_view name = words.next();
    std::size_t number = 0;
    if ((name != "num_cols" && name != "num_rows") || !parse_number(words.next(), number)) return;
    (name == "num_cols" ? header_.grid.columns : header_.grid.rows) = number;
  }

  PlyType read_type(WordReader& words) {
    const std::string_view name = words.next();
    const std::optional<PlyType> type = type_named(name);
    if (!type) fail_syntax(in_quotes(name) + " is not a PLY type");
    return *type;
  }

  void check_sizes() {
    // The last line of a text needs no end, hence one byte more.
    std::size_t left = bytes_.size() - header_.body + (header_.encoding == PlyEncoding::Ascii ? 1 : 0);
    for (PlyElement& element : header_.elements) {
      const std::size_t size = least_size(element);
      if (size == 0) element.count = 0;  // elements without properties take no bytes and hold nothing
      if (size > 0 && element.count > left / size) {
        context_.fail("E_TRUNCATED",
                      "the header claims " + std::to_string(element.count) + " elements " + in_quotes(element.name) +
                          ", but the rest of the file can hold no more than " + std::to_string(left / size),
                      at_byte(header_.body));
      }
      left -= size * element.count;
    }
  }

  std::size_t least_size(const PlyElement& element) const {
    std::size_t size = 0;
    for (const PlyProperty& property : element.properties) {
      const std::size_t binary = size_of(property.is_list ? property.count_type : property.type);
      size += header_.encoding == PlyEncoding::Ascii ? 2 : binary;  // a digit and what parts it from the next
    }
    return size;
  }

  std::string_view bytes_;
  ReadContext& context_;
  PlyHeader header_;
  std::int64_t line_ = 0;
  bool has_format_ = false;
  std::set<std::string, std::less<>> element_names_, property_names_;
};

}  // namespace

std::size_t size_of(PlyType type) { return type_names[static_cast<std::size_t>(type)].size; }
const char* name_of(PlyType type) { return type_names[static_cast<std::size_t>(type)].first; }
bool is_integer(PlyType type) { return type != PlyType::Float32 && type != PlyType::Float64; }

PlyHeader read_ply_header(std::string_view bytes, ReadContext& context) { return HeaderReader(bytes, context).read(); }

namespace {

AttributeChannel::Data empty_values(PlyType type) {
  switch (type) {
    case PlyType::Int8: return std::vector<std::int8_t>();
    case PlyType::Uint8: return std::vector<std::uint8_t>();
    case PlyType::Int16: return std::vector<std::int16_t>();
    case PlyType::Uint16: return std::vector<std::uint16_t>();
    case PlyType::Int32: return std::vector<std::int32_t>();
    case PlyType::Uint32: return std::vector<std::uint32_t>();
    case PlyType::Float32: return std::vector<float>();
    case PlyType::Float64: return std::vector<double>();
  }
  return {};
}

}  // namespace

std::vector<PlyColumn> empty_columns(const PlyElement& element) {
  std::vector<PlyColumn> columns;
  for (const PlyProperty& property : element.properties) {
    columns.push_back({property, empty_values(property.type), {}});
  }
  return columns;
}

Place PlyTable::place(std::size_t row) const {
  if (encoding == PlyEncoding::Ascii) {
    const auto after = std::upper_bound(lines.begin(), lines.end(), row,
                                        [](std::size_t r, const auto& entry) { return r < entry.first; });
    if (after == lines.begin()) return {};
    const auto& [known_row, line] = *std::prev(after);
    return at_line(line + static_cast<std::int64_t>(row - known_row));
  }
  std::size_t byte = first_byte;
  for (const PlyColumn& column : columns) {
    const std::size_t size = size_of(column.property.type);
    byte += column.property.is_list ? row * size_of(column.property.count_type) + column.list_begin(row) * size
                                    : row * size;
  }
  return at_byte(byte);
}

}  // namespace croquis

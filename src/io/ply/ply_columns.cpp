// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/ply/ply_columns.h"

#include <algorithm>

namespace croquis {
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

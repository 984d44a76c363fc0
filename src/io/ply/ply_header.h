// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "io/read_context.h"

namespace croquis {

enum class PlyType { Int8, Uint8, Int16, Uint16, Int32, Uint32, Float32, Float64 };

std::size_t size_of(PlyType type);
const char* name_of(PlyType type);  ///< "char", "uchar", … "double"
bool is_integer(PlyType type);

struct PlyProperty {
  std::string name;
  PlyType type = PlyType::Float32;
  bool is_list = false;
  PlyType count_type = PlyType::Uint8;  ///< lists only, an integer type
};

struct PlyElement {
  std::string name;
  std::size_t count = 0;
  std::vector<PlyProperty> properties;
};

enum class PlyEncoding { Ascii, LittleEndian, BigEndian };

/// Size of a range scan's grid, as `obj_info num_cols` and `obj_info num_rows` tell it; 0 where they don't.
struct PlyGrid {
  std::size_t columns = 0, rows = 0;
};

struct PlyHeader {
  PlyEncoding encoding = PlyEncoding::Ascii;
  PlyGrid grid;
  std::vector<PlyElement> elements;
  std::size_t body = 0;        ///< the first byte after the header
  std::int64_t body_line = 0;  ///< and its line
};

/// Reads the header (Turk, The PLY Polygon File Format, 1994) and refuses counts that the rest of the file can't hold.
/// @throws Error E_SYNTAX, E_COUNT, E_TRUNCATED
PlyHeader read_ply_header(std::string_view bytes, ReadContext& context);

}  // namespace croquis

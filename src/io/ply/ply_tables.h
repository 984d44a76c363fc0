// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "croquis/geometry/poly_mesh.h"
#include "io/read_context.h"

/// What PLY files are made of, and what becomes of it in a mesh.
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

/// Size of a range scan's grid, as `obj_info num_cols` and `obj_info num_rows` say; 0 where they don't.
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

/// All values of one property.
struct PlyColumn {
  PlyProperty property;
  AttributeChannel::Data values;      ///< lists one after the other
  std::vector<Index> list_ends = {};  ///< lists only: where each element's list ends in `values`

  std::size_t list_begin(std::size_t row) const { return row == 0 ? 0 : list_ends[row - 1]; }
  std::size_t list_size(std::size_t row) const { return list_ends[row] - list_begin(row); }
};

/// One element's data, and where its rows stand in the file.
struct PlyTable {
  PlyElement element;
  std::vector<PlyColumn> columns;
  PlyEncoding encoding = PlyEncoding::Ascii;
  std::size_t first_byte = 0;                               ///< of row 0 (binary)
  std::vector<std::pair<std::size_t, std::int64_t>> lines;  ///< (row, line) wherever rows don't follow line by line

  /// Where a row stands. For binary lists O(row): for findings only.
  Place place(std::size_t row) const;
};

/// Where reading has come to.
struct PlyCursor {
  std::size_t byte = 0;
  std::int64_t line = 0;  ///< text only
};

/// Reads one element's rows and moves the cursor behind them.
/// @param keep false to pass over them: the columns stay empty
/// @throws Error E_TRUNCATED, E_COUNT, E_SYNTAX
PlyTable read_ply_text(std::string_view bytes, const PlyElement& element, bool keep, PlyCursor& cursor,
                       ReadContext& context);
PlyTable read_ply_binary(std::string_view bytes, const PlyElement& element, PlyEncoding encoding, bool keep,
                         PlyCursor& cursor, ReadContext& context);

/// Empty columns of the properties' types.
std::vector<PlyColumn> empty_columns(const PlyElement& element);

/// PLY's names for the parts of a channel; the first row of a channel is what the writer uses.
struct PlyPartNames {
  std::string_view channel;
  int width;
  std::array<std::string_view, 4> parts;
};

/// Longer rows stand before their beginnings, so that the first match is the right one.
inline constexpr std::array ply_part_names = {
    PlyPartNames{"normal", 3, {"nx", "ny", "nz"}},
    PlyPartNames{"normal", 3, {"normal_x", "normal_y", "normal_z"}},
    PlyPartNames{"color", 4, {"red", "green", "blue", "alpha"}},
    PlyPartNames{"color", 3, {"red", "green", "blue"}},
    PlyPartNames{"color", 4, {"r", "g", "b", "a"}},
    PlyPartNames{"color", 3, {"r", "g", "b"}},
    PlyPartNames{"color", 3, {"diffuse_red", "diffuse_green", "diffuse_blue"}},
    PlyPartNames{"uv", 2, {"s", "t"}},
    PlyPartNames{"uv", 2, {"u", "v"}},
    PlyPartNames{"uv", 2, {"texture_u", "texture_v"}}};

/// Triangulates a range view: PLY's element `range_grid`, one row for each place of the scanner's grid, line by line,
/// with a list of the one vertex seen there, or of none (Stanford 3D Scanning Repository).
/// Four neighbours give two triangles, cut along the shorter diagonal, three give one. Triangles with an edge longer
/// than 4 × the median of the grid's edges would cross a step in depth: they are left out and counted in a warning.
/// All faces are turned so that their areas together look along +z, where Stanford's scanners stand.
/// @param indices the grid's list of vertices  @param mesh has the vertices; the triangles are added
/// @throws Error E_COUNT, E_INDEX
void triangulate_range_grid(const PlyGrid& size, const PlyTable& grid, const PlyColumn& indices, PolyMesh& mesh,
                            ReadContext& context);

}  // namespace croquis

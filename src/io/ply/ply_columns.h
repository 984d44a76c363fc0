// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>
#include <utility>
#include <vector>

#include "croquis/geometry/poly_mesh.h"
#include "io/ply/ply_header.h"

namespace croquis {

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

}  // namespace croquis

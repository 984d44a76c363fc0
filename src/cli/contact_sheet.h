// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "croquis/io/png.h"

namespace croquis::cli {

/// One picture of a contact sheet.
struct SheetTile {
  std::string text;  ///< below it: digits, '.', '-', '+', 'e' and the letters of "failed"; others are gaps
  std::vector<std::uint8_t> rgba;  ///< as Picture has it; empty where there is nothing to show: the tile says "failed"
};

/// Columns of a sheet: it is about as wide as it has rows.
int sheet_columns(int tiles);

/// Pictures of one size in rows, with a line of text below each.
/// @param tiles at least one
Picture contact_sheet(const std::vector<SheetTile>& tiles, int tile_width, int tile_height);

}  // namespace croquis::cli

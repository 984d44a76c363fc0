// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/contact_sheet.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace croquis::cli {
namespace {

constexpr int glyph_width = 5, glyph_height = 7;
constexpr int dot_size = 2;      // pixels a dot of a letter is wide
constexpr int text_height = 28;  // of the text below a picture
constexpr int tile_gap = 4;      // round each picture

using Color = std::array<std::uint8_t, 4>;
constexpr Color paper_color = {250, 250, 250, 255}, ink_color = {30, 34, 40, 255}, failure_color = {244, 222, 220, 255};

/// Rows of dots from above, the left one the highest of five bits.
struct Glyph {
  char letter;
  std::array<std::uint8_t, glyph_height> rows;
};

constexpr std::array<Glyph, 19> glyphs = {{{'0', {14, 17, 19, 21, 25, 17, 14}},
                                           {'1', {4, 12, 4, 4, 4, 4, 14}},
                                           {'2', {14, 17, 1, 2, 4, 8, 31}},
                                           {'3', {31, 2, 4, 2, 1, 17, 14}},
                                           {'4', {2, 6, 10, 18, 31, 2, 2}},
                                           {'5', {31, 16, 30, 1, 1, 17, 14}},
                                           {'6', {6, 8, 16, 30, 17, 17, 14}},
                                           {'7', {31, 1, 2, 4, 8, 8, 8}},
                                           {'8', {14, 17, 17, 14, 17, 17, 14}},
                                           {'9', {14, 17, 17, 15, 1, 2, 12}},
                                           {'.', {0, 0, 0, 0, 0, 12, 12}},
                                           {'-', {0, 0, 0, 31, 0, 0, 0}},
                                           {'+', {0, 4, 4, 31, 4, 4, 0}},
                                           {'e', {0, 0, 14, 17, 31, 16, 14}},
                                           {'f', {6, 9, 8, 28, 8, 8, 8}},
                                           {'a', {0, 0, 14, 1, 15, 17, 15}},
                                           {'i', {4, 0, 12, 4, 4, 4, 14}},
                                           {'l', {12, 4, 4, 4, 4, 4, 14}},
                                           {'d', {1, 1, 13, 19, 17, 17, 15}}}};

void fill_box(Picture& picture, int left, int top, int width, int height, const Color& color) {
  for (int y = std::max(top, 0); y < std::min(top + height, picture.height); ++y) {
    for (int x = std::max(left, 0); x < std::min(left + width, picture.width); ++x) {
      std::ranges::copy(color, picture.rgba.begin() + 4 * (static_cast<std::ptrdiff_t>(y) * picture.width + x));
    }
  }
}

void write_text(Picture& picture, const std::string& text, int middle, int top) {
  constexpr int advance = (glyph_width + 1) * dot_size;
  int left = middle - (static_cast<int>(text.size()) * advance - dot_size) / 2;
  for (const char letter : text) {
    const auto glyph = std::ranges::find(glyphs, letter, &Glyph::letter);
    for (int row = 0; glyph != glyphs.end() && row < glyph_height; ++row) {
      for (int column = 0; column < glyph_width; ++column) {
        const bool set = (glyph->rows[static_cast<std::size_t>(row)] >> (glyph_width - 1 - column) & 1) != 0;
        if (set) fill_box(picture, left + column * dot_size, top + row * dot_size, dot_size, dot_size, ink_color);
      }
    }
    left += advance;
  }
}

void copy_tile(const std::vector<std::uint8_t>& rgba, int width, int height, Picture& to, int left, int top) {
  for (int y = 0; y < height; ++y) {
    const auto row = rgba.begin() + 4 * static_cast<std::ptrdiff_t>(y) * width;
    std::copy_n(row, 4 * width, to.rgba.begin() + 4 * (static_cast<std::ptrdiff_t>(top + y) * to.width + left));
  }
}

}  // namespace

int sheet_columns(int tiles) { return static_cast<int>(std::ceil(std::sqrt(static_cast<double>(tiles)))); }

Picture contact_sheet(const std::vector<SheetTile>& tiles, int tile_width, int tile_height) {
  const int count = static_cast<int>(tiles.size()), columns = sheet_columns(count);
  const int across = tile_width + 2 * tile_gap, down = tile_height + 2 * tile_gap + text_height;
  Picture sheet{columns * across, (count + columns - 1) / columns * down, {}};
  sheet.rgba.resize(4 * static_cast<std::size_t>(sheet.width) * static_cast<std::size_t>(sheet.height));
  fill_box(sheet, 0, 0, sheet.width, sheet.height, paper_color);
  for (int place = 0; place < count; ++place) {
    const SheetTile& tile = tiles[static_cast<std::size_t>(place)];
    const int left = place % columns * across + tile_gap, top = place / columns * down + tile_gap;
    const int middle = left + tile_width / 2;
    if (tile.rgba.empty()) {
      fill_box(sheet, left, top, tile_width, tile_height, failure_color);
      write_text(sheet, "failed", middle, top + (tile_height - glyph_height * dot_size) / 2);
    } else {
      copy_tile(tile.rgba, tile_width, tile_height, sheet, left, top);
    }
    write_text(sheet, tile.text, middle, top + tile_height + (text_height - glyph_height * dot_size) / 2);
  }
  return sheet;
}

}  // namespace croquis::cli

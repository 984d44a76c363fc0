// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace croquis::tracing {

/// One value for each pixel, top row first.
template <typename T>
struct PixelGrid {
  int width = 0;
  int height = 0;
  std::vector<T> values;  ///< width × height

  PixelGrid() = default;
  PixelGrid(int columns, int rows, T value = {})
      : width(columns),
        height(rows),
        values(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows), value) {}

  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
  }
  T& at(int x, int y) { return values[index(x, y)]; }
  const T& at(int x, int y) const { return values[index(x, y)]; }
  bool has(int x, int y) const { return x >= 0 && y >= 0 && x < width && y < height; }

  /// The value there, or the one that an empty pixel has beyond the border.
  T at_or_empty(int x, int y) const { return has(x, y) ? at(x, y) : T{}; }
};

/// Which pixels belong to something: 0 or 1.
using Mask = PixelGrid<std::uint8_t>;

struct Pixel {
  int x = 0;
  int y = 0;

  friend bool operator==(const Pixel&, const Pixel&) = default;
};

/// The eight neighbours of a pixel in order around it, beginning to the right; even ones share a side with it.
inline constexpr std::array<Pixel, 8> around = {{{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}};

inline Pixel neighbour(const Pixel& pixel, int direction) {
  const Pixel& step = around[static_cast<std::size_t>(direction & 7)];
  return {pixel.x + step.x, pixel.y + step.y};
}

}  // namespace croquis::tracing

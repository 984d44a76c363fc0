// SPDX-License-Identifier: GPL-3.0-or-later
#include "implicit/cholesky.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "implicit/lanes.h"

namespace croquis::implicit {
namespace {

constexpr std::size_t block = 48;  // columns per step; a strip of 8 rows of them is 3 kB
constexpr std::size_t tile_columns = 4;

/// Columns [begin, end) of the factor, all rows, from a matrix to which the columns before have been applied.
CROQUIS_PART bool factor_panel(double* a, std::size_t n, std::size_t stride, std::size_t begin, std::size_t end,
                               double least) {
  for (std::size_t j = begin; j < end; ++j) {
    double* column = a + j * stride;
    if (!(column[j] > least)) return false;
    const double pivot = std::sqrt(column[j]);
    const double inverse = 1 / pivot;
    column[j] = pivot;
    for (std::size_t i = j + 1; i < n; ++i) column[i] *= inverse;
    for (std::size_t k = j + 1; k < end; ++k) {
      double* other = a + k * stride;
      const double factor = column[k];
      for (std::size_t i = k; i < n; ++i) other[i] -= factor * column[i];
    }
  }
  return true;
}

/// Rows [begin, n) of the panel, strip by strip of `width` rows, each strip's columns one behind the other; 0 below the
/// end.
template <std::size_t width>
CROQUIS_PART void pack(const double* panel, std::size_t n, std::size_t stride, std::size_t begin, std::size_t columns,
                       double* packed) {
  for (std::size_t row = begin; row < n; row += width) {
    const std::size_t count = std::min(width, n - row);
    for (std::size_t k = 0; k < columns; ++k, packed += width) {
      const double* from = panel + k * stride + row;
      if (count == width) {
        for (std::size_t r = 0; r < width; ++r) packed[r] = from[r];
      } else {
        for (std::size_t r = 0; r < width; ++r) packed[r] = r < count ? from[r] : 0;
      }
    }
  }
}

/// 8 rows times 4 columns of the product of a strip and a group.
CROQUIS_PART void multiply_tile(const double* strip, const double* group, std::size_t columns, Lanes* tile) {
  Lanes t0 = {}, t1 = {}, t2 = {}, t3 = {};
  for (std::size_t k = 0; k < columns; ++k, strip += lane_count, group += tile_columns) {
    Lanes rows;
    load(rows, strip);
    t0 += rows * group[0];
    t1 += rows * group[1];
    t2 += rows * group[2];
    t3 += rows * group[3];
  }
  tile[0] = t0, tile[1] = t1, tile[2] = t2, tile[3] = t3;
}

/// Takes a tile off the matrix, its lower triangle alone.
CROQUIS_PART void subtract_tile(const Lanes* tile, double* a, std::size_t n, std::size_t stride, std::size_t row,
                                std::size_t column) {
  for (std::size_t c = 0; c < std::min(tile_columns, n - column); ++c) {
    double* to = a + (column + c) * stride;
    if (row >= column + c && row + lane_count <= n) {
      Lanes old;
      load(old, to + row);
      old -= tile[c];
      store(old, to + row);
    } else {
      for (std::size_t r = 0; r < std::min(lane_count, n - row); ++r)
        if (row + r >= column + c) to[row + r] -= tile[c][r];
    }
  }
}

CROQUIS_FOR_EVERY_MACHINE bool factor_blocks(double* a, std::size_t n, std::size_t stride, double least, double* strips,
                                             double* groups) {
  for (std::size_t begin = 0; begin < n; begin += block) {
    const std::size_t end = std::min(begin + block, n);
    if (!factor_panel(a, n, stride, begin, end, least)) return false;
    const std::size_t columns = end - begin;
    pack<lane_count>(a + begin * stride, n, stride, end, columns, strips);
    pack<tile_columns>(a + begin * stride, n, stride, end, columns, groups);
    for (std::size_t column = end; column < n; column += tile_columns) {
      const double* group = groups + (column - end) * columns;
      for (std::size_t row = end + (column - end) / lane_count * lane_count; row < n; row += lane_count) {
        Lanes tile[tile_columns];
        multiply_tile(strips + (row - end) * columns, group, columns, tile);
        subtract_tile(tile, a, n, stride, row, column);
      }
    }
  }
  return true;
}

CROQUIS_PART double dot(const double* a, const double* b, std::size_t n) {
  Lanes lanes = {};
  std::size_t i = 0;
  for (; i + lane_count <= n; i += lane_count) {
    Lanes u, v;
    load(u, a + i);
    load(v, b + i);
    lanes += u * v;
  }
  double rest = 0;
  for (; i < n; ++i) rest += a[i] * b[i];
  return sum(lanes) + rest;
}

CROQUIS_FOR_EVERY_MACHINE void substitute(const double* a, std::size_t n, std::size_t stride, double* b) {
  for (std::size_t j = 0; j < n; ++j) {
    const double* column = a + j * stride;
    b[j] /= column[j];
    for (std::size_t i = j + 1; i < n; ++i) b[i] -= column[i] * b[j];
  }
  for (std::size_t j = n; j-- > 0;) {
    const double* column = a + j * stride;
    b[j] = (b[j] - dot(column + j + 1, b + j + 1, n - j - 1)) / column[j];
  }
}

}  // namespace

bool factor_cholesky(double* a, std::size_t n, std::size_t stride, double least) {
  std::vector<double> strips(whole_lanes(n) * block);
  std::vector<double> groups(whole_lanes(n) * block);
  return factor_blocks(a, n, stride, least, strips.data(), groups.data());
}

void solve_cholesky(const double* a, std::size_t n, std::size_t stride, double* b) { substitute(a, n, stride, b); }

}  // namespace croquis::implicit

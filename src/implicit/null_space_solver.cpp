// SPDX-License-Identifier: GPL-3.0-or-later
#include "implicit/null_space_solver.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/QR>

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

using Eigen::MatrixXd;
using Eigen::VectorXd;

// Of the unit box: directions in which centres spread less than this don't hold a linear term.
constexpr double flat = 1e-9;

// Of the largest diagonal entry: a smaller pivot is rounding.
constexpr double least_pivot = 1e-14;

constexpr Eigen::Index width = 4;  // reflectors that are applied at once, missing ones 0

/// Some reflectors of a QR decomposition as H = I - V T V'.
struct Reflectors {
  MatrixXd v;  // n by 4, padded with 0
  MatrixXd t;  // 4 by 4, upper triangular
};

/// Those from `first` on, `width` at most.
Reflectors reflectors_from(const Eigen::ColPivHouseholderQR<MatrixXd>& qr, Eigen::Index first, Eigen::Index rank) {
  const Eigen::Index n = qr.rows();
  Reflectors h = {MatrixXd::Zero(n, width), MatrixXd::Zero(width, width)};
  for (Eigen::Index k = 0; k < std::min(width, rank - first); ++k) {
    const Eigen::Index row = first + k;
    const double tau = qr.hCoeffs()[row];
    h.v(row, k) = 1;
    h.v.col(k).tail(n - row - 1) = qr.matrixQR().col(row).tail(n - row - 1);
    h.t.col(k).head(k) = -tau * (h.t.topLeftCorner(k, k) * (h.v.leftCols(k).transpose() * h.v.col(k)));
    h.t(k, k) = tau;
  }
  return h;
}

/// H = H1 H2 ...
std::vector<Reflectors> reflectors_of(const Eigen::ColPivHouseholderQR<MatrixXd>& qr, Eigen::Index rank) {
  std::vector<Reflectors> blocks;
  for (Eigen::Index first = 0; first < rank; first += width) blocks.push_back(reflectors_from(qr, first, rank));
  return blocks;
}

/// y = A v for four columns at once; A is read column by column.
CROQUIS_FOR_EVERY_MACHINE void multiply(const double* a, std::size_t n, const double* v, double* y) {
  for (std::size_t j = 0; j < n; ++j) {
    const double v0 = v[j], v1 = v[n + j], v2 = v[2 * n + j], v3 = v[3 * n + j];
    const double* column = a + j * n;
    for (std::size_t i = 0; i < n; ++i) {
      y[i] += column[i] * v0;
      y[n + i] += column[i] * v1;
      y[2 * n + i] += column[i] * v2;
      y[3 * n + i] += column[i] * v3;
    }
  }
}

/// A -= V W' + W V', the lower triangle.
CROQUIS_FOR_EVERY_MACHINE void subtract_products(double* a, std::size_t n, const double* v, const double* w) {
  for (std::size_t j = 0; j < n; ++j) {
    double* column = a + j * n;
    const double v0 = v[j], v1 = v[n + j], v2 = v[2 * n + j], v3 = v[3 * n + j];
    const double w0 = w[j], w1 = w[n + j], w2 = w[2 * n + j], w3 = w[3 * n + j];
    for (std::size_t i = j; i < n; ++i) {
      column[i] -= ((v[i] * w0 + w[i] * v0) + (v[n + i] * w1 + w[n + i] * v1)) +
                   ((v[2 * n + i] * w2 + w[2 * n + i] * v2) + (v[3 * n + i] * w3 + w[3 * n + i] * v3));
    }
  }
}

/// The lower triangle of H'AH: A - V W' - W V' with W = A V T - V (T'V' A V T) / 2.
void reflect_both_sides(MatrixXd& a, const Reflectors& h) {
  const auto n = static_cast<std::size_t>(a.rows());
  MatrixXd y = MatrixXd::Zero(a.rows(), width);
  multiply(a.data(), n, h.v.data(), y.data());
  const MatrixXd yt = y.lazyProduct(h.t);
  const MatrixXd s = h.t.transpose().lazyProduct(h.v.transpose().lazyProduct(yt));
  const MatrixXd w = yt - 0.5 * h.v.lazyProduct(s);
  subtract_products(a.data(), n, h.v.data(), w.data());
}

VectorXd reflected(const Reflectors& h, const VectorXd& x, bool transposed) {
  const VectorXd inner = h.v.transpose() * x;
  if (transposed) return x - h.v * (h.t.transpose() * inner);
  return x - h.v * (h.t * inner);
}

/// The whole matrix again: one block of reflectors has overwritten nothing above the diagonal.
void mirror_upper_triangle(MatrixXd& a) {
  for (Eigen::Index j = 0; j < a.cols(); ++j)
    for (Eigen::Index i = j + 1; i < a.rows(); ++i) a(i, j) = a(j, i);
}

void mirror_lower_triangle(MatrixXd& a) {
  for (Eigen::Index j = 0; j < a.cols(); ++j)
    for (Eigen::Index i = 0; i < j; ++i) a(i, j) = a(j, i);
}

/// The lower triangle of H'AH.
void reflect_both_sides(MatrixXd& a, const std::vector<Reflectors>& blocks) {
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    if (i > 0) mirror_lower_triangle(a);
    reflect_both_sides(a, blocks[i]);
  }
}

VectorXd reflected(const std::vector<Reflectors>& blocks, VectorXd x, bool transposed) {
  for (std::size_t i = 0; i < blocks.size(); ++i)
    x = reflected(blocks[transposed ? i : blocks.size() - 1 - i], x, transposed);
  return x;
}

ConstrainedWeights solve_whole(const MatrixXd& a, const MatrixXd& q, const VectorXd& h, int rank) {
  const Eigen::Index n = a.rows();
  const Eigen::Index k = q.cols();
  MatrixXd whole = MatrixXd::Zero(n + k, n + k);
  whole << a, q, q.transpose(), MatrixXd::Zero(k, k);
  VectorXd right = VectorXd::Zero(n + k);
  right.head(n) = h;
  const VectorXd x = Eigen::CompleteOrthogonalDecomposition<MatrixXd>(whole).solve(right);
  return {x.head(n), x.tail(k), rank, true};
}

}  // namespace

bool factor_cholesky(double* a, std::size_t n, std::size_t stride, double least) {
  std::vector<double> strips(whole_lanes(n) * block);
  std::vector<double> groups(whole_lanes(n) * block);
  return factor_blocks(a, n, stride, least, strips.data(), groups.data());
}

void solve_cholesky(const double* a, std::size_t n, std::size_t stride, double* b) { substitute(a, n, stride, b); }

ConstrainedWeights solve_constrained(MatrixXd& a, const MatrixXd& q, const VectorXd& h) {
  const Eigen::Index n = a.rows();
  Eigen::ColPivHouseholderQR<MatrixXd> qr;
  qr.setThreshold(flat);
  qr.compute(q);
  const Eigen::Index rank = qr.rank();
  const std::vector<Reflectors> reflectors = reflectors_of(qr, rank);
  const VectorXd diagonal = a.diagonal();
  const MatrixXd original = reflectors.size() > 1 ? a : MatrixXd();  // else its upper triangle stays
  reflect_both_sides(a, reflectors);

  const VectorXd right = reflected(reflectors, h, true);
  const MatrixXd coupling = a.bottomLeftCorner(n - rank, rank);
  const double largest = n > rank ? a.diagonal().tail(n - rank).maxCoeff() : 0;
  VectorXd free = right.tail(n - rank);
  const auto count = static_cast<std::size_t>(n - rank);
  const auto stride = static_cast<std::size_t>(n);
  double* corner = a.data() + rank * (n + 1);
  if (count > 0 && !factor_cholesky(corner, count, stride, least_pivot * largest)) {
    if (original.size() > 0) return solve_whole(original, q, h, static_cast<int>(rank));
    mirror_upper_triangle(a);
    a.diagonal() = diagonal;
    return solve_whole(a, q, h, static_cast<int>(rank));
  }
  solve_cholesky(corner, count, stride, free.data());

  ConstrainedWeights result;
  result.rank = static_cast<int>(rank);
  VectorXd rotated = VectorXd::Zero(n);
  rotated.tail(n - rank) = free;
  result.weights = reflected(reflectors, rotated, false);
  const MatrixXd r =
      MatrixXd(qr.matrixR().topRows(rank).template triangularView<Eigen::Upper>()) * qr.colsPermutation().transpose();
  const VectorXd rest = right.head(rank) - coupling.transpose() * free;
  result.coefficients = Eigen::CompleteOrthogonalDecomposition<MatrixXd>(r).solve(rest);
  return result;
}

}  // namespace croquis::implicit

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "croquis/geometry/vector.h"

namespace croquis {

/// Something to choose: its cost and the rows that it covers.
struct CoverColumn {
  double cost = 0;
  std::vector<Index> rows;
};

struct EdgePrices {
  std::vector<double> price;    ///< per row
  std::vector<double> reduced;  ///< per column: cost less the prices of its rows
  double bound = 0;             ///< no choice that covers every row twice costs less
};

/// Lagrange multipliers of "every row twice", by subgradient steps of Polyak's length.
/// @param goal about what the best choice costs; the nearer, the faster
EdgePrices price_rows(const std::vector<CoverColumn>& columns, std::size_t row_count, double goal);

}  // namespace croquis

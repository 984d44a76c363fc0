// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/perspective/faces/edge_prices.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace croquis {
namespace {

constexpr int most_price_steps = 200;
constexpr int patience = 12;              ///< steps without a better bound before steps are halved
constexpr double least_step = 0.01;       ///< × Polyak's length
constexpr double starting_price = -0.25;  ///< a quadrilateral's, per side

/// The bound that the prices give; fills the reduced costs and how far each row is from being covered twice.
double price_bound(const std::vector<CoverColumn>& columns, const std::vector<double>& price,
                   std::vector<double>& reduced, std::vector<double>& lack) {
  double bound = 0;
  for (const double p : price) bound += 2 * p;
  std::ranges::fill(lack, 2.0);
  for (std::size_t c = 0; c < columns.size(); ++c) {
    double cost = columns[c].cost;
    for (const Index row : columns[c].rows) cost -= price[row];
    reduced[c] = cost;
    if (cost >= 0) continue;
    bound += cost;
    for (const Index row : columns[c].rows) lack[row] -= 1;
  }
  return bound;
}

}  // namespace

EdgePrices price_rows(const std::vector<CoverColumn>& columns, std::size_t row_count, double goal) {
  std::vector<double> price(row_count, starting_price), reduced(columns.size()), lack(row_count);
  EdgePrices best{price, reduced, -1e300};
  double scale = 1;
  int waited = 0;
  for (int step = 0; step < most_price_steps && scale > least_step; ++step) {
    const double bound = price_bound(columns, price, reduced, lack);
    if (bound > best.bound + 1e-9) {
      best = {price, reduced, bound};
      waited = 0;
    } else if (++waited >= patience) {
      scale /= 2;
      waited = 0;
      price = best.price;
      price_bound(columns, price, reduced, lack);
    }
    double squares = 0;
    for (const double l : lack) squares += l * l;
    if (squares == 0 || best.bound >= goal - 1e-9) break;
    const double length = scale * std::max(goal - bound, 0.05) / squares;
    for (std::size_t row = 0; row < row_count; ++row) price[row] += length * lack[row];
  }
  return best;
}

}  // namespace croquis

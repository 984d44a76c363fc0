// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace croquis::bench {

/// The middle value; of an even number the mean of both. 0 for none.
double median(std::vector<double> values);

double mean(const std::vector<double>& values);  ///< 0 for none

/// The value that a share of them doesn't exceed. 0 for none.
double quantile(std::vector<double> values, double share);

/// Spearman's: the correlation of ranks, equal values sharing theirs. 0 for fewer than three pairs.
double rank_correlation(const std::vector<double>& x, const std::vector<double>& y);

}  // namespace croquis::bench

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <ostream>

/// Each prints a table of times as ratios against a peer measured in the same run. Times are medians of several runs.
namespace croquis::bench {

void bench_holes(std::ostream& out);
void bench_implicit(std::ostream& out);
void bench_readers(std::ostream& out);
void bench_solver(std::ostream& out);
void bench_silhouette(std::ostream& out);
void bench_subdivision(std::ostream& out);

}  // namespace croquis::bench

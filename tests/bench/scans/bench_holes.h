// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <ostream>
#include <string>

/// The sections of the benchmark of hole filling. Every table names the target beside the figure.
namespace croquis::bench {

void report_hole_accuracy(std::ostream& out);  ///< sculptures with known holes, every method
void report_hole_growth(std::ostream& out);    ///< time and memory over size, and against std::sort
void report_long_rims(std::ostream& out);      ///< one rim of 10,000 edges
void report_hole_speed(std::ostream& out);     ///< whole programs, from file to file; threads
void report_external_holes(std::ostream& out, const std::string& folder);  ///< see cases_in

}  // namespace croquis::bench

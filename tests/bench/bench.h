// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <ostream>
#include <string>
#include <vector>

/// Each prints a table of times as ratios against a peer measured in the same run. Times are medians of several runs.
namespace croquis::bench {

/// @param sections of it to run, none for all that need no further word; `external FOLDER` measures scans of one's own
void bench_holes(std::ostream& out, const std::vector<std::string>& sections);

/// Scans like the world's, every kind of hole in them: filled by the default options and by peers.
/// @param words see scan_choice
void bench_holes_wild(std::ostream& out, const std::vector<std::string>& words);

void bench_implicit(std::ostream& out);
void bench_perspective(std::ostream& out);
void bench_readers(std::ostream& out);
void bench_solver(std::ostream& out);
void bench_remesh(std::ostream& out);

/// The same scans made anew: what lies where no scan is, and what it costs beside screened Poisson.
/// @param words see scan_choice
void bench_remesh_wild(std::ostream& out, const std::vector<std::string>& words);

void bench_silhouette(std::ostream& out);

/// How often drawings with random errors of the hand are read as they were meant.
/// @param words "tuning" for the seeds that rules were tuned on; a folder for the drawings that aren't read
void bench_silhouette_hand(std::ostream& out, const std::vector<std::string>& words);

/// What becomes of sketches that other people drew: solids, what the strokes were read as, and the time.
/// @param words a folder of .svg files
void bench_strangers(std::ostream& out, const std::vector<std::string>& words);

void bench_subdivision(std::ostream& out);
void bench_surface(std::ostream& out);

}  // namespace croquis::bench

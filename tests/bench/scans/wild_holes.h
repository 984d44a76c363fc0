// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "support/scans/known_scans.h"

/// Known scans filled by the default options and by peers, hole by hole.
namespace croquis::bench {

enum class Filler { Ours, Tangent, Curved, MeshLab };  ///< the middle two are CGAL's, continuity 1 and 2
inline constexpr std::array all_fillers = {Filler::Ours, Filler::Tangent, Filler::Curved, Filler::MeshLab};

const char* name_of(Filler filler);

inline constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// What a program made of one hole.
struct FilledHole {
  bool is_closed = false;   ///< every edge of its rim has a new face
  double error = unknown;   ///< of a closed one: mean distance of the places missing to its patch, 1e-4 diagonals
  double cpu_ms = unknown;  ///< of filling this hole alone; MeshLab: unknown
};

struct HoleRecord {
  test::ScanKind scan;
  std::uint64_t seed = 0;
  std::size_t number = 0;  ///< in the scan
  test::HoleKind kind;
  std::size_t rim_edges = 0;
  double diameter = 0;               ///< of its rim, × diagonal
  bool has_seams = false;            ///< of the scan
  bool has_own_rim = false;          ///< it isn't part of a sheet's border, or of a gap's
  bool is_left = false;              ///< an OUTER rim that the default options don't fill
  std::array<FilledHole, 4> filled;  ///< by Filler
  FilledHole asked;                  ///< ours, where it was left and then asked for by number
  std::string method;                ///< ours
  double confidence = unknown;       ///< ours, reported

  const FilledHole& of(Filler filler) const { return filled[static_cast<std::size_t>(filler)]; }
};

struct ScanRecord {
  test::ScanKind kind;
  std::uint64_t seed = 0;
  std::size_t triangles = 0, open_edges = 0;
  std::array<std::ptrdiff_t, 4> new_intersections{};  ///< pairs of faces, by Filler
  std::array<std::ptrdiff_t, 4> edges_left{};         ///< that still have one face, by Filler; -1: not installed
  std::array<double, 4> cpu_ms{};                     ///< of all holes together; MeshLab: its whole process
  bool is_kept = true;                                ///< ours: the mesh given comes first, bit by bit
  std::vector<HoleRecord> holes;
};

/// @param folder where scan, truth and results are written, or empty
ScanRecord fill_known_scan(test::ScanKind kind, std::uint64_t seed, const std::string& folder);

}  // namespace croquis::bench

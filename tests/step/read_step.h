// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <map>
#include <string>

namespace croquis::test {

/// What OpenCASCADE's reader finds in a STEP file, checked by its own analyser.
struct ReadSolid {
  bool valid = false;   ///< BRepCheck_Analyzer
  bool closed = false;  ///< every edge of every shell has two faces
  std::size_t solids = 0;
  std::size_t shells = 0;
  std::size_t faces = 0;
  std::size_t edges = 0;
  std::size_t planes = 0;  ///< faces on planes
  std::size_t lines = 0;   ///< edges along lines
  std::size_t rational_edges = 0;
  double volume = 0;  ///< millimetres³
};

/// Solids without faces where the bytes can't be read.
ReadSolid read_step(const std::string& bytes);

/// Of all faces, within 1e-12 of it: slow for many. Millimetres².
double area_in_step(const std::string& bytes);

}  // namespace croquis::test

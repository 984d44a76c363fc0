// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "croquis/geometry/poly_mesh.h"

/// Other programs' hole filling: all holes of a mesh.
namespace croquis::bench {

struct FilledMesh {
  PolyMesh mesh;
  std::size_t first_new_face = 0;  ///< faces given come first
  double cpu_ms = 0;               ///< of filling alone in-process, else of the whole process
};

/// CGAL's triangulate_refine_and_fair_hole, rim by rim.
/// @param continuity 1 or 2
FilledMesh cgal_fill(const PolyMesh& mesh, unsigned continuity);

/// What was made of one rim.
struct FilledRim {
  std::vector<Index> vertices;                 ///< of the mesh given
  std::size_t first_face = 0, face_count = 0;  ///< of the mesh filled; no face where it failed
  double cpu_ms = 0;
};

struct FilledRims {
  FilledMesh filled;
  std::vector<FilledRim> rims;
};

/// The same for any soup of triangles, which CGAL's own functions turn and cut apart first until it is manifold. No
/// search that grows with the third power, which CGAL falls back to otherwise: rims of scans would take hours.
FilledRims cgal_fill_rims(const PolyMesh& mesh, unsigned continuity);

/// MeshLab's "Close Holes" by meshlabserver under xvfb-run, which gives it the GL context without which it aborts.
/// Nothing when they aren't installed.
std::optional<FilledMesh> meshlab_fill(const PolyMesh& mesh);

/// The same from file to file. @return processor time in ms, nothing when it failed or isn't installed
std::optional<double> meshlab_fill_file(const std::string& in, const std::string& out);

}  // namespace croquis::bench

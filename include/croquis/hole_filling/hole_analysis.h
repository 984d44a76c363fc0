// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <tuple>
#include <vector>

#include "croquis/base/finding.h"
#include "croquis/base/members.h"
#include "croquis/base/progress.h"
#include "croquis/hole_filling/surface_view.h"

namespace croquis::hole_filling {

/// What a rim is of, as far as shape shows. The first that applies, in the order islands, tunnel, outer, bow-tie,
/// small, slit, simple.
enum class HoleClass {
  Small,    ///< at most 10 edges
  Simple,   ///< anything else
  Islands,  ///< a hole with a separate piece of surface in it, or that piece's own border
  Tunnel,   ///< one of two rims of different components that face each other across a gap
  Outer,    ///< the border of a sheet, or a cut where the surface shows no tendency to close
  Slit,     ///< long, with sides within 1.5 edges of each other
  BowTie    ///< shares a vertex with another rim
};

/// "small", "simple", "islands", "tunnel", "OUTER", "slit", "bow-tie".
const char* to_string(HoleClass kind);

/// A cone that holds directions of unit length.
struct DirectionCone {
  Vec3 axis = Vec3::Zero();  ///< unit, or zero when the directions cancel out
  double angle = 0;          ///< the greatest angle to the axis, radians
};

/// A simple closed rim. Lengths in model units, angles in radians.
struct Hole {
  Index id = 0;                        ///< place in HoleAnalysis::holes
  HoleClass kind = HoleClass::Simple;  ///< see there
  std::vector<Index> vertices;         ///< #R, of the mesh, in the direction of the faces, the lowest first
  std::vector<Index> corners;          ///< #R, of the view: edge i runs from vertices[i] to vertices[i+1]
  Index component = 0;                 ///< of the view; the largest, where the rim runs over pieces that touch
  double perimeter = 0;
  double diameter = 0;            ///< the greatest distance of two rim vertices, exact
  double area = 0;                ///< of the minimal triangulation; see `area_is_minimal`
  bool area_is_minimal = false;   ///< else that of a triangulation no flip of which is smaller
  Vec3 centre = Vec3::Zero();     ///< of the rim's edges, weighted by length
  Vec3 normal = Vec3::Zero();     ///< unit, of the plane nearest to the rim, on the side that the faces look to
  double planarity = 0;           ///< the greatest distance of a rim vertex to that plane, × diameter
  DirectionCone rim_normals;      ///< of the faces along the rim
  Vec3 conormal = Vec3::Zero();   ///< mean of the directions in which the faces would continue into the hole
  double conormal_tilt = 0;       ///< mean angle of those directions to the plane's normal, either way
  bool shares_vertex = false;     ///< with another rim
  bool ambiguous = false;         ///< its faces don't agree in direction: on a one-sided component
  std::vector<Index> companions;  ///< holes that belong to it: its islands, the hole around it, a tunnel's other rim
};

struct HoleAnalysisOptions {
  std::size_t small_edges = 10;                  ///< a rim of so many edges is "small"
  std::size_t exact_area_edges = 100;            ///< longer rims' areas are estimated; cost grows with the third power
  double weld_tolerance = usual_weld_tolerance;  ///< × diagonal; see view_surface
};
constexpr auto members(const HoleAnalysisOptions& options) {
  return std::tie(options.small_edges, options.exact_area_edges, options.weld_tolerance);
}
static_assert(lists_every_member<HoleAnalysisOptions>);

struct HoleAnalysis {
  SurfaceView view;
  std::vector<Hole> holes;             ///< ordered by their lowest vertex, then by the following ones
  std::vector<double> component_area;  ///< per component of the view
  std::vector<double> component_diagonal;

  /// By the spread of its area: about the diagonal of scanned things (1.2 times that of sheets, rods and spheres), but
  /// the same however the scan lies in space, as patches have to be: methods are chosen by it. 0 without area.
  std::vector<double> component_size;
  std::size_t open_rims = 0;  ///< chains of rim edges that end at edges of many faces: no holes
  Findings warnings;          ///< W_WELDED, W_ORIENTATION, W_NONMANIFOLD, W_DEGENERATE, W_BOWTIE
};

/// Finds, measures and classifies the rims of a mesh that may be dirty; the mesh isn't changed.
///
/// n log n at most in faces and rim edges together; the same for any number of threads.
/// @throws Error as view_surface
/// @throws Cancelled
HoleAnalysis analyse_holes(const PolyMesh& mesh, Progress& progress, const HoleAnalysisOptions& options = {});

/// Of a diameter above a fifth of its piece's size: the place to begin from decides what a patch becomes.
inline bool is_wide(const HoleAnalysis& analysis, Index hole) {
  return analysis.holes[hole].diameter > 0.2 * analysis.component_size[analysis.holes[hole].component];
}

}  // namespace croquis::hole_filling

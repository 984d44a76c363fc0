// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "bench/scans/hole_peers.h"
#include "croquis/hole_filling/fill_holes.h"
#include "support/scans/scans.h"

/// Meshes with holes of which is known what is missing, and what fills made of them.
namespace croquis::bench {

struct HoleCase {
  std::string name;
  PolyMesh mesh;
  std::vector<std::vector<Vec3>> removed;  ///< places on the surface removed, per hole
  double diagonal = 0;
};

/// @param cuts meshes are given away without their loose vertices
HoleCase case_of(const std::string& name, const test::CutScan& cuts);

/// Cases of X_cut.ply and X_removed_pts.txt in a folder: a line `hole …` before the points of each hole, `x y z` per
/// line.
std::vector<HoleCase> cases_in(const std::string& folder);

/// Every way to fill that is compared: other programs', then ours by fairness and preset.
enum class Method { MeshLab, CgalTangent, CgalCurved, Smooth, Implicit, Sharp, Noisy };
const char* name_of(Method method);

/// Nothing when the program isn't installed.
std::optional<FilledMesh> fill(const PolyMesh& mesh, Method method);

/// How far the surface removed is from the patches, × 1e-4 diagonal.
struct Accuracy {
  double mean = 0;         ///< over holes, of the mean over each hole's places
  double median_hole = 0;  ///< of those means
};
Accuracy accuracy(const HoleCase& holes, const FilledMesh& filled);

/// Edges with one face.
std::size_t border_edges(const PolyMesh& mesh);

/// Of the new faces. Angles in degrees.
struct PatchShape {
  double edge_ratio = 0;  ///< median over patches of mean inner edge / mean rim edge, patches of 10 rim edges and more
  double uneven_patches = 0;  ///< share of these patches with a ratio outside 0.7..1.4
  double small_angles = 0;    ///< share of angles below 10
  double median_min_angle = 0;
  std::size_t open_rims = 0;             ///< edges that still have one face
  std::ptrdiff_t new_intersections = 0;  ///< pairs of faces, beyond those of the mesh given
};
PatchShape patch_shape(const PolyMesh& given, const FilledMesh& filled);

}  // namespace croquis::bench

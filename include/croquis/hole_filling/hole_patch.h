// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <limits>
#include <numbers>
#include <span>
#include <string>
#include <vector>

#include "croquis/geometry/vector.h"
#include "croquis/hole_filling/hole_analysis.h"

namespace croquis::hole_filling {

/// New surface that closes one hole, or several holes that belong together (a hole and its islands, both ends of a
/// tunnel). It refers to the mesh and is in no mesh yet.
struct HolePatch {
  std::vector<Index> holes;                     ///< ids in the analysis, ascending
  std::vector<Vec3> points;                     ///< new vertices
  std::vector<std::array<Index, 3>> triangles;  ///< corners below #V are vertices of the mesh, #V + i is points[i]
  std::vector<Index> arrives_at = {};  ///< further holes that the surface continued from these arrives at, ascending:
                                       ///< those belong to them, and there are no triangles
  bool rises_too_far = false;  ///< over its hole, see rises_too_far(): it isn't wanted, and there are no triangles
  std::vector<std::size_t> domain_points = {};  ///< of each function that it lies on: the points it was fitted to
};

/// Beyond this angle across the rim a wedge of less than 60 degrees is left between patch and surface, which scans of
/// things hardly ever have: of 95 patches of scans three bent by more than 85 degrees, and all of them by more than
/// 130. Radians.
inline constexpr double doubtful_fold = 120 * std::numbers::pi / 180;

/// What the verification of a patch found. Angles in radians.
struct PatchVerdict {
  std::string fault;           ///< empty for a sound patch, else why it can't be taken
  double min_angle = 0;        ///< of all corners of the patch
  double max_normal_jump = 0;  ///< greatest angle between the faces on the two sides of a rim edge

  bool is_sound() const { return fault.empty(); }
};

/// Where a vertex of a patch is.
inline const Vec3& place_of(const HolePatch& patch, const PolyMesh& mesh, Index v) {
  return v < mesh.vertex_count() ? mesh.positions[v] : patch.points[v - mesh.vertex_count()];
}

/// How a patch meets the face beyond a rim edge.
struct RimFold {
  Index from = 0, to = 0;  ///< vertices of the mesh
  double length = 0;
  double angle = 0;  ///< radians, negative where the patch turns to the inner side; 0 where it isn't there
};

/// Along each of the patch's rims.
std::vector<std::vector<RimFold>> rim_folds(const HolePatch& patch, const PolyMesh& mesh, const HoleAnalysis& analysis);

/// The mean angle between faces of edges that follow each other along the rims, radians: how much the surface around
/// turns there, by its shape or by roughness, which no method continues. Linear in the rims.
double rim_bend(const PolyMesh& mesh, const HoleAnalysis& analysis, std::span<const Index> holes);

/// How far off a patch is likely to be, × diagonal of the model's piece:
/// 0.1 D (1 + 3 D) (0.02 + 4 D^2 + bend + fold). Fitted to known scans, but for 0.02 + 4 D^2, which says that what is
/// far from the rims is a guess, however smooth they are (docs/algorithms/hole_filling.md has predicted and true
/// errors).
/// @param depth D: the distance from the rims, × diagonal
/// @param bend see rim_bend
/// @param fold what the patch's turn at the rims counts, or 0
double predicted_error(double depth, double bend, double fold);

/// 1 / (1 + error / 0.01): a half where an error of one percent of the diagonal is predicted, 0.91 for a thousandth.
double confidence_in(double error);

/// The predicted error of which a confidence comes, × diagonal.
double error_at(double confidence);

/// 1 up to 90 degrees, then 1 / (1 + x^2) with x the excess over them in 30 degrees: a half at 120, a fifth at 150.
double trust_in_fold(double angle);

/// By the predicted error of a patch as far from its rims as it goes. Its fold: with a the angle between patch and
/// surface, meant over stretches of the rims so that the roughness of single faces evens out, 4 a^3, as only wide folds
/// are wrong; but 8 a without new vertices, where a flat patch leaves the surface, and a is the angle of the surface's
/// mean direction into the hole, if that is more.
///
/// Times trust_in_fold of the greatest angle between neighbouring faces of the patch, across its rims too. Patches
/// without new vertices are looked at evenly by area.
double confidence_of(const HolePatch& patch, const PolyMesh& mesh, const HoleAnalysis& analysis);

/// The same for each of the patch's new vertices, by its own distance from the rims, and with the angle between the
/// faces at the rim, continued harmonically into the patch. 0..1, one per new vertex: falls from the rims to the
/// middle. Near-linear.
std::vector<float> vertex_confidence(const HolePatch& patch, const PolyMesh& mesh, const HoleAnalysis& analysis);

/// A patch below this should be checked: more than 2.3 percent of the diagonal is predicted.
inline constexpr double low_confidence = 0.3;

}  // namespace croquis::hole_filling

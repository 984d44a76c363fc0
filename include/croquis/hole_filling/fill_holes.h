// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Geometry>

#include "croquis/base/finding.h"
#include "croquis/base/progress.h"
#include "croquis/base/stage_cache.h"
#include "croquis/hole_filling/fill_options.h"
#include "croquis/hole_filling/hole_analysis.h"

namespace croquis::hole_filling {

enum class FillAction {
  Fill,   ///< closed
  Leave,  ///< not chosen
  Failed  ///< chosen, but no method made a sound patch: still open
};

/// What happened to one hole; its measures are in the analysis. Angles in radians, NaN where a remeshed model has no
/// face of its own there.
struct HoleOutcome {
  FillAction action = FillAction::Leave;
  std::string method;          ///< of the patch taken, empty without one
  std::string reason;          ///< why it was left, failed, or not filled by the first method
  double max_normal_jump = 0;  ///< greatest angle between the faces on the two sides of a rim edge
  double mean_fold = 0;        ///< mean of those angles along the hole's own rim, by length; patched holes alone
  double min_angle = 0;        ///< of the patch's corners
  double confidence = 0;       ///< 0..1, by the error to be expected of the whole patch, see confidence_of
  std::size_t new_vertices = 0, new_faces = 0;  ///< of a patch for several holes: at its lowest
  Eigen::AlignedBox3d box;                      ///< of the patch's new vertices
  Index patch = no_index;  ///< number of the patch, the same for holes that one patch joins; as in "patch_id"
  /// Mean distance of the patch to the surface that was there, as its confidence predicts it; model units. Preset Sharp
  /// alone, else NaN.
  double expected_error = std::numeric_limits<double>::quiet_NaN();
};

/// Least, middle and greatest number of points that the functions of a surface are fitted to.
struct DomainPointCounts {
  std::size_t min = 0, median = 0, max = 0;
};

struct FillResult {
  PolyMesh mesh;          ///< vertices and faces given, unchanged, without those that trimming removes; then
                          ///< those of the patches
  HoleAnalysis analysis;  ///< of the mesh given
  std::vector<HoleOutcome> outcomes;  ///< per hole of the analysis
  std::size_t new_vertices = 0, new_faces = 0;
  std::size_t removed_vertices = 0, removed_faces = 0;  ///< by trimming
  std::size_t domains = 0;                              ///< functions that were fitted for the patches taken
  DomainPointCounts points_per_domain;
  std::size_t open_edges = 0;  ///< of the result, counted in the view of the analysis: those of rims without a patch
  bool outside_unchanged = false;  ///< looked at again at the end: what wasn't removed comes first, bit by bit
  Findings warnings;               ///< those of the analysis, W_OUTER_LEFT, W_STRAYS, W_FALLBACK, W_LOW_CONFIDENCE,
                                   ///< W_BOX_GROWN, W_HOLE_FAILED
};

/// The most that fill_holes will hold at a time, in bytes, the mesh given not counted. Linear in its channels, and
/// allocates nothing.
std::size_t predicted_fill_bytes(const PolyMesh& mesh, const FillOptions& options);

/// "fill", "leave", "failed".
const char* to_string(FillAction action);

/// Closes holes by patches and changes nothing else. Every patch is verified (see PatchVerifier) before it is taken;
/// where one isn't sound the next method is tried, and at last the hole stays open with a reason. A hole with its
/// islands, and the two ends of a tunnel, get one patch. Channels of vertices are continued harmonically into the
/// patches ("normal" is computed), those of faces get the value beside the rim, those of corners NaN or 0.
///
/// Near-linear in faces; see triangulate_rim and FillOptions for rims. The same for any number of threads.
/// @throws Error as analyse_holes; E_PARAMETER for an id that no hole has; E_MEMORY (Category::Limit) before anything
///         large is allocated
/// @throws Cancelled
FillResult fill_holes(const PolyMesh& mesh, const FillOptions& options, Progress& progress);

/// The analysis' findings, then those about the holes: left as OUTER, filled by another method, failed.
Findings fill_findings(const PolyMesh& scan, const FillResult& result);

/// How people ask for what a method makes: "by rbf", "smooth", "flat" or "bridged".
std::string option_of(std::string_view method);

/// Why a hole failed of which the whole piece was left out; the finding is about the piece.
inline constexpr const char* piece_left_out = "its piece of the mesh was left out";

/// Why the rim of a few triangles was left that hang in a hole by a vertex: the first of its companions.
inline constexpr const char* hangs_at_rim = "hangs at the rim of a hole by a corner";

/// Channels that filled and remeshed models carry.
inline constexpr const char* patch_channel = "patch_id";
inline constexpr const char* confidence_channel = "confidence";

}  // namespace croquis::hole_filling

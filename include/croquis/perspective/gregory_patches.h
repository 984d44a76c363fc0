// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "croquis/base/finding.h"
#include "croquis/geometry/brep.h"

/// Gregory patches over the loops of faces that aren't planar.
namespace croquis {

/// How the size of the slope across a side is chosen between its ends, where nothing dictates it.
enum class SlopeRule : std::uint8_t {
  Mean,        ///< the mean of the ends (Chiyokura and Kimura 1983)
  Proportion,  ///< as far as the patch is wide there, in proportion to the neighbouring sides' handles
  Fair         ///< least variation of curvature: a linear solve per patch over the squares of third derivatives
};

struct PatchOptions {
  SlopeRule slope = SlopeRule::Fair;
};

/// A side of a patch on its way around, with the directions that the slope across it is made of.
struct PatchSide {
  std::array<Vec3, 4> points{};  ///< cubic; each side begins where the one before ends
  bool common = false;           ///< slopes lie in the span of `across` and the side's own direction, as those of the
                                 ///< patch on the other side do; else they go from one end's to the other's evenly
  std::array<Vec3, 2> across{};  ///< at the start and end, into the patch; between them linear
};

/// The patch inside four sides. Where sides are common to two patches, their normals agree along the whole side, if at
/// both ends the neighbouring handles lie in the span of `across` and the side.
GregoryPatch span_patch(const std::array<PatchSide, 4>& sides, const PatchOptions& options = {});

/// Spans patches over all faces that aren't planar: one over four sides with one cubic each, else n around a middle
/// point. Where the patches around the middle fold over, the middle is moved; if that isn't enough, the face is divided
/// by an edge from corner to corner. PATCH_FOLDED names faces that stay folded.
/// @param brep smooth edges are known (find_smooth_edges)
Findings span_patches(Brep& brep, const PatchOptions& options = {});

}  // namespace croquis

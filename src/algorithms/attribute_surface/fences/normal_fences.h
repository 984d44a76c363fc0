// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "algorithms/attribute_surface/network/loop_curves.h"
#include "croquis/attribute_surface/face_surface.h"
#include "croquis/base/finding.h"
#include "croquis/geometry/attribute_network.h"

namespace croquis {

/// Along every side of every smooth face the normals of its surface: found from the tangents in the corners, with one
/// normal for all faces that meet smoothly there, or as slopes say.
/// docs/algorithms/attribute_surface.md, "Normal fences".
struct NormalFences {
  std::vector<std::vector<NormalFence>> sides;  ///< by face and side; empty for faces that aren't smooth
  std::vector<bool> smooth;                     ///< by curve: two smooth faces meet in it without an edge
};

/// What the fences need to know of a network.
struct FenceInput {
  const AttributeNetwork& network;
  const LoopCurves& curves;
  const std::vector<std::vector<Index>>& faces_of_curve;  ///< that close
  const std::vector<bool>& wants_fences;                  ///< by face: it closes and is smooth
};

/// Findings: W_SMOOTH_CONFLICT, W_NONMANIFOLD, E_SLOPE (that normal is left out).
NormalFences make_fences(const FenceInput& input, Findings& findings);

}  // namespace croquis

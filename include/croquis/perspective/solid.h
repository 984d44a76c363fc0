// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "croquis/base/finding.h"
#include "croquis/base/progress.h"
#include "croquis/geometry/brep.h"
#include "croquis/geometry/curve_network.h"
#include "croquis/perspective/edge_continuity.h"
#include "croquis/perspective/face_finding.h"
#include "croquis/perspective/gregory_patches.h"
#include "croquis/perspective/tessellation.h"

namespace croquis {

/// Polynomial cubics close to each curve of a network: one, or two that go on smoothly into each other. More count as
/// the two nearest to them.
using FittedCurves = std::vector<std::vector<RationalCubic>>;

/// The pieces of curves as they are, weights left out: for networks of polynomial curves.
FittedCurves polynomial_pieces(const CurveNetwork& network);

/// The topology of a set of faces, without smooth edges and patches. Numbers of elements follow the order of faces
/// alone. A vertex where several fans of faces meet becomes several.
/// @param fitted per curve of the network
Brep make_brep(const CurveNetwork& network, const FittedCurves& fitted, const FaceSet& faces);

struct SolidOptions {
  FaceContinuityOptions continuity;
  PatchOptions patches;
  TessellationOptions tessellation;
};

struct Solid {
  Brep brep;
  Tessellation tessellation;
  Findings warnings;  ///< SMOOTH_DROPPED, PATCH_FOLDED
};

/// From faces to a solid: B-rep, smooth edges, patches, mesh. Shells whose volume comes out with the wrong sign are
/// turned over.
/// @throws Cancelled
Solid make_solid(const CurveNetwork& network, const FittedCurves& fitted, const FaceSet& faces, Progress& progress,
                 const SolidOptions& options = {});

}  // namespace croquis

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "croquis/base/finding.h"
#include "croquis/base/progress.h"
#include "croquis/geometry/brep.h"
#include "croquis/geometry/curve_network.h"
#include "croquis/perspective/curve_lifting.h"
#include "croquis/perspective/edge_continuity.h"
#include "croquis/perspective/face_finding.h"
#include "croquis/perspective/gregory_patches.h"
#include "croquis/perspective/tessellation.h"

namespace croquis {

/// The pieces of curves as they are, weights left out: for networks of polynomial curves.
std::vector<FittedCurve> polynomial_pieces(const CurveNetwork& network);

/// The topology of a set of faces, without smooth edges and patches. Numbers of elements follow the order of faces
/// alone. A vertex where several fans of faces meet becomes several.
/// @param fitted per curve of the network, with pieces that go on smoothly into each other. Patches have one or two on
///   a side; of more, each half becomes one cubic with the same ends and directions
Brep make_brep(const CurveNetwork& network, const std::vector<FittedCurve>& fitted, const FaceSet& faces);

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
Solid make_solid(const CurveNetwork& network, const std::vector<FittedCurve>& fitted, const FaceSet& faces,
                 Progress& progress, const SolidOptions& options = {});

}  // namespace croquis

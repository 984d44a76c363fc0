// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "croquis/base/finding.h"
#include "croquis/geometry/poly_mesh.h"

namespace croquis::cli {

struct FinitePart {
  PolyMesh mesh;
  Findings warnings;  ///< at most one W_BAD_DROPPED: how much is gone
};

/// A mesh without the vertices that are not finite, and without the faces, polylines and tags that use them. What
/// remains keeps its order and its attributes. Linear time.
FinitePart finite_part(PolyMesh mesh);

}  // namespace croquis::cli

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "croquis/geometry/brep.h"
#include "croquis/perspective/tessellation.h"

namespace croquis {

/// An edge as the vertices of a mesh, from its start to its end.
struct EdgeSamples {
  std::vector<Index> vertices;
  std::size_t middle = 0;     ///< position of the sample where the two halves of a side of patches meet
  std::vector<Vec3> normals;  ///< of smooth edges, common to both faces; else empty
};

/// Into how many spans the sides of each patch of a face are cut: of single patches sides 0 and 2, then 1 and 3; of
/// stars each patch's side 0, then its side 1.
struct FaceSpans {
  std::vector<std::array<std::size_t, 2>> along;
};

struct BrepSamples {
  std::vector<EdgeSamples> edges;
  std::vector<FaceSpans> faces;
  std::vector<Vec3> corner_normal;  ///< per half-edge, of its face at its start; zero where no smooth edge rules it
};

/// Samples every edge once, as its own bends and those of its patches need, and appends the points to the mesh.
BrepSamples sample_edges(const Brep& brep, const TessellationOptions& options, PolyMesh& mesh);

}  // namespace croquis

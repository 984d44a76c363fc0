// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "croquis/base/finding.h"
#include "croquis/base/progress.h"
#include "croquis/geometry/brep.h"
#include "croquis/geometry/curve_network.h"
#include "croquis/geometry/poly_mesh.h"
#include "croquis/perspective/curve_lifting.h"
#include "croquis/perspective/edge_continuity.h"
#include "croquis/perspective/face_finding.h"

namespace croquis {

/// A side of a patch on its way around, with the directions that the slope across it is made of.
struct PatchSide {
  std::array<Vec3, 4> points{};  ///< cubic; each side begins where the one before ends
  bool common = false;           ///< slopes lie in the span of `across` and the side's own direction, as those of the
                                 ///< patch on the other side do; else they go from one end's to the other's evenly
  std::array<Vec3, 2> across{};  ///< at the start and end, into the patch; between them linear
};

/// The patch inside four sides. Where sides are common to two patches, their normals agree along the whole side, if at
/// both ends the neighbouring handles lie in the span of `across` and the side. The size of the slope across a side,
/// where nothing dictates it, is that of least variation of curvature: a linear solve over the squares of third
/// derivatives.
GregoryPatch span_patch(const std::array<PatchSide, 4>& sides);

/// Spans patches over all faces that aren't planar: one over four sides with one cubic each, else n around a middle
/// point. Where the patches around the middle fold over, the middle is moved; if that isn't enough, the face is divided
/// by an edge from corner to corner. PATCH_FOLDED names faces that stay folded.
/// @param brep smooth edges are known (find_smooth_edges)
Findings span_patches(Brep& brep);

struct TessellationOptions {
  double chord_tolerance = 0.0005;  ///< greatest distance of mesh and surface, × diagonal of the box; 0.00001..0.01
  std::size_t most_spans = 128;     ///< of an edge or across a patch
};

/// The corner channel of unit normals (3 doubles) is "normal"; the face channel "group" ("f0", "f1" …) has for each
/// triangle the outline that its face of the B-rep fills.
struct Tessellation {
  PolyMesh mesh;               ///< triangles, counter-clockwise from outside
  std::vector<double> volume;  ///< per shell; of open shells what the cone from the origin has
  Findings warnings;           ///< PATCH_FOLDED: planar faces whose outlines cross, made as fans
};

/// Triangles along the surfaces of a B-rep. Each edge is sampled once and both faces use these points, so that the mesh
/// of a closed shell is watertight; vertices are shared by number, never by distance. Corners at smooth edges share
/// normals. Planar faces are triangulated by constrained Delaunay, holes included; patches by grids that are stitched
/// to the samples of their edges.
/// @throws Cancelled
Tessellation tessellate(const Brep& brep, Progress& progress, const TessellationOptions& options = {});

/// The topology of a set of faces, without smooth edges and patches. Numbers of elements follow the order of faces
/// alone. A vertex where several fans of faces meet becomes several.
/// @param fitted per curve of the network, with pieces that go on smoothly into each other. Patches have one or two on
///   a side; of more, each half becomes one cubic with the same ends and directions
Brep make_brep(const CurveNetwork& network, const std::vector<FittedCurve>& fitted, const FaceSet& faces);

struct SolidOptions {
  FaceContinuityOptions continuity;
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

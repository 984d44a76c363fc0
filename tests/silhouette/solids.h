// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "croquis/geometry/mesh_report.h"
#include "croquis/geometry/triangle_tree.h"
#include "croquis/silhouette/solid.h"
#include "silhouette/figure_fixtures.h"

/// Solids of drawings and figures, and what every one of them has to be.
namespace croquis::test {

silhouette::Solid solid_of(const Drawing& drawing, const silhouette::Options& options = {});
silhouette::Solid solid_of(const FigureFixture& fixture, const silhouette::Options& options = {});

/// Self-intersections counted.
MeshReport report_of(const PolyMesh& mesh);

/// Closed, manifold, turned outward, no face without area, meeting itself nowhere.
void check_sound(const PolyMesh& mesh);

/// The faces of an object, with only its vertices.
PolyMesh part_named(const silhouette::Solid& solid, const std::string& name);

/// Extent along z.
double depth_of(const PolyMesh& mesh);

TriangleTree tree_of(const PolyMesh& mesh);

/// Of triangles with an angle below 15 degrees.
double slender_share(const PolyMesh& mesh);

Sketch character_named(const std::string& name);

}  // namespace croquis::test

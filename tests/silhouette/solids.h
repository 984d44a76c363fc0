// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "croquis/geometry/mesh_report.h"
#include "croquis/geometry/triangle_tree.h"
#include "croquis/silhouette/solid.h"
#include "silhouette/figure_fixtures.h"

/// Solids of drawings and figures, what every one of them has to be, and how their parts lie behind one another.
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

/// How a part of a solid lies, measured on its mesh.
struct PartDepth {
  std::string name;
  double low = 0;  ///< sketch units, along z
  double high = 0;
  double slope = 0;  ///< of the plane that is nearest to its vertices along z: rise per length

  double depth() const { return high - low; }
  double middle() const { return (low + high) / 2; }
};

/// One per object, in the order of the mesh's labels. Of joined objects only what can be seen counts.
std::vector<PartDepth> part_depths(const silhouette::Solid& solid);

/// The same by the names of objects.
std::map<std::string, PartDepth> depths_by_name(const silhouette::Solid& solid);

/// From the first of their middles to the last, over the sum of their depths: 0 where all lie in one plane, and below 1
/// in a stack of parts that touch.
double middle_spread(const std::vector<PartDepth>& parts);

double steepest(const std::vector<PartDepth>& parts);

}  // namespace croquis::test

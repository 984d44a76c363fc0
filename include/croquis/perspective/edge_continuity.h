// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "croquis/base/finding.h"
#include "croquis/geometry/brep.h"
#include "croquis/geometry/camera.h"
#include "croquis/geometry/curve_network.h"

/// Where strokes go on smoothly into each other, and where faces do across an edge.
namespace croquis {

/// An end of a curve.
struct CurveEnd {
  Index curve = no_index;
  bool at_end = false;
  friend auto operator<=>(const CurveEnd&, const CurveEnd&) = default;
};

struct CurveContinuityOptions {
  double angle = 0.2618;          ///< radians, 2..30 degrees: strokes that turn less go on smoothly
  std::vector<CurveEnd> corners;  ///< ends that stay corners
  std::vector<CurveEnd> smooth;   ///< ends that go on smoothly up to twice the angle
};

struct SmoothJoint {
  CurveEnd a, b;
  double angle = 0;  ///< radians that they turned before
};

/// Makes curves that meet nearly in one direction meet exactly so: best pairs first, each end in one pair at most.
/// Vertices stay; handles keep their length and turn; curves stay in the planes at right angles to an axis that they
/// lie in. A straight curve gives its direction to the other one; two curves of one plane take the mean weighted by
/// handle lengths, two of different planes the direction of the axis that both contain if it is near. What can't is
/// left a corner. Call it before cubics are fitted.
/// @param camera if given, weights of moved handles change so that the curve still is what is seen as a cubic
std::vector<SmoothJoint> join_smoothly(CurveNetwork& network, const Camera* camera,
                                       const CurveContinuityOptions& options = {});

struct FaceContinuityOptions {
  double angle = 0.2618;           ///< radians, 2..30 degrees: faces that turn less across an edge go on smoothly
  std::vector<std::string> sharp;  ///< ids of curves that stay sharp
};

/// Finds the edges that faces cross smoothly, and sets BrepEdge::smooth and ::across. Handles of fitted cubics turn
/// into a common plane at vertices where that is needed, but no curve leaves a plane that it lies in, no straight one
/// and no vertex moves, and planar faces stay. Edges between two planar faces stay
/// as they are.
/// @return SMOOTH_DROPPED for edges that can't be smooth then
Findings find_smooth_edges(Brep& brep, const FaceContinuityOptions& options = {});

/// The largest angle in radians between the normals of the two faces along smooth edges, and of the patches of a face
/// along their common lines: what is left of a kink. Normals are one-sided limits at 33 places of each edge, so that no
/// distance is chosen. 0 without smooth edges and patches. Linear.
double greatest_normal_jump(const Brep& brep);

}  // namespace croquis

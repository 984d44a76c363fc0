// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <numbers>
#include <tuple>
#include <vector>

#include "croquis/base/finding.h"
#include "croquis/base/members.h"
#include "croquis/geometry/curve_network.h"
#include "croquis/geometry/perspective_drawing.h"
#include "croquis/perspective/drawing_vertices.h"
#include "croquis/perspective/vertex_coordinates.h"

/// From drawn strokes to curves in space, once the camera and the vertices are known.
///
/// Cho and Kim, section 2.2, item 1, lift the control points and take the polynomial cubic through them, which isn't
/// seen where it was drawn. A drawn cubic is the picture of a rational cubic: with d_i the ray of control point b_i and
/// n the normal of its plane, weights w_i = n · d_i and points P_i = E + (c - n · E) / w_i d_i.
namespace croquis {

struct CurveOptions {
  double fit_distance = 0.5;                        ///< u: a polynomial cubic may be seen so far off …
  double fit_error = 1e-3;                          ///< × diagonal of the bounding box, or be so far off in space
  double joint_angle = 5 * std::numbers::pi / 180;  ///< radians: pieces of a path that turn more meet in a vertex
};

constexpr auto members(const CurveOptions& options) {
  return std::tie(options.fit_distance, options.fit_error, options.joint_angle);
}

static_assert(lists_every_member<CurveOptions>);

/// A polynomial stand-in for a curve, for surfaces that need one.
struct FittedCurve {
  std::vector<RationalCubic> pieces;  ///< weights 1; two for a piece of the exact curve that one doesn't fit. Ends and
                                      ///< their directions are those of the exact pieces; joints inside are smooth
  double distance = 0;                ///< px: how far off it is seen
  double error = 0;                   ///< model units
};

/// Curves of all edges that can be lifted, in the order of their strokes.
struct LiftedCurves {
  CurveNetwork network;       ///< exact: rational pieces. Ids are those of the strokes; parts of a path with
                              ///< corners are called "ID/1", "ID/2" …
  std::vector<Index> stroke;  ///< of each curve
  std::vector<Index> vertex;  ///< of each vertex of the drawing the one of the network, or no_index
  std::vector<Index> flat;    ///< strokes that stay in the picture
  Findings warnings;          ///< CURVE_BEHIND_HORIZON
};

/// Lifts the edges of a drawing. Vertices of the network are those of the drawing that have curves, in their order,
/// then corners of paths. What is in an axis' plane has its coordinate bit by bit, and curves that meet have the same
/// ends. Strokes whose group is ignored are lifted nearest to the plane that they were drawn for.
LiftedCurves lift_curves(const PerspectiveDrawing& drawing, const DrawingVertices& vertices,
                         const VertexCoordinates& coordinates, const CurveOptions& options);

/// Polynomial stand-ins for all curves of a network.
/// @param unit px of a u, see sheet_units_per_diagonal
std::vector<FittedCurve> fit_curves(const CurveNetwork& network, const Camera& camera, double unit,
                                    const CurveOptions& options);

/// A polynomial cubic, or two, near a rational one: same ends and directions there; the lengths of the handles follow
/// from least squares over foot points. Straight curves become exact.
/// @param camera sees it, for the distance
/// @param most_distance px, @param most_error model units: one cubic has to keep one of them
FittedCurve fit_polynomial(const RationalCubic& exact, const Camera& camera, double most_distance, double most_error);

}  // namespace croquis

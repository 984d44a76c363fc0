// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "croquis/base/described.h"
#include "croquis/geometry/camera.h"
#include "croquis/geometry/curve_network.h"
#include "croquis/geometry/perspective_drawing.h"

/// What the operation `perspective` found in a drawing; its report is made of this. Places in the picture are px, y
/// down; places in space model units.
namespace croquis {

/// What became of a stroke.
struct PerspectiveStrokeResult {
  std::string id;
  bool used = true;                          ///< no finding names it
  StrokeGroup group = StrokeGroup::Unknown;  ///< as it was used: from its colour, or as the drawing says better
  std::optional<double> residual;            ///< px; of strokes along an axis, how far they miss the vanishing point
};

/// A change of one stroke after which the drawing no longer contradicts itself.
struct ProposedFix {
  std::string stroke;
  StrokeGroup group = StrokeGroup::Unknown;
  std::string text;  ///< one sentence for people
};

/// A corner of the solid.
struct PerspectiveCorner {
  std::string id;  ///< the name that strokes give it, or "v0" …
  Vec3 at = Vec3::Zero();
};
inline auto described(const PerspectiveCorner& corner) {
  return fields(named("id", corner.id), named("at", corner.at));
}
static_assert(describes_every_member<PerspectiveCorner>);

/// A face of the solid.
struct PerspectiveFace {
  std::string id;                                 ///< "f0" …, as groups of the mesh are named
  std::vector<std::vector<std::string>> strokes;  ///< per loop, the outer one first
  bool planar = true;
};
inline auto described(const PerspectiveFace& face) {
  return fields(named("id", face.id), named("strokes", face.strokes), named("kind", face.planar ? "planar" : "patch"));
}
static_assert(describes_every_member<PerspectiveFace>);

/// A set of faces that would close, too: AMBIGUOUS.
struct FaceAlternative {
  std::vector<PerspectiveFace> faces;
};

/// What the operation `perspective` gives besides its outputs.
struct PerspectiveResult {
  int mode = 3;   ///< vanishing points that aren't at infinity: 1, 2 or 3
  Camera camera;  ///< with its eye in the world
  std::array<Vec3, 3> vanishing_points{Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};  ///< homogeneous, px
  double focal_deviation = 0;                                                      ///< px, one standard deviation
  Vec2 principal_deviation = Vec2::Zero();                                         ///< px
  std::vector<PerspectiveStrokeResult> strokes;  ///< in the order of the drawing, construction too
  std::vector<Vec2> vertex_places;               ///< px: where the ends of edges meet
  CurveNetwork network;                          ///< every edge stroke that has a place in space
  std::size_t edge_strokes = 0;                  ///< in the drawing
  std::vector<PerspectiveCorner> corners;
  std::vector<PerspectiveFace> faces;
  std::size_t internal_faces_rejected = 0;  ///< regions of planes inside the solid
  std::vector<FaceAlternative> alternatives;
  std::vector<std::string> open_strokes;  ///< that lack a face
  std::vector<ProposedFix> fixes;         ///< the most likely one first
  std::size_t shells = 0;
  bool closed = false;
  double max_reprojection_error = 0;  ///< px
  double max_g1_angle = 0;            ///< radians, across smooth edges
};

std::size_t byte_size(const PerspectiveResult& result);

}  // namespace croquis

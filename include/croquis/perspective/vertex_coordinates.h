// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <numbers>
#include <span>
#include <tuple>
#include <vector>

#include "croquis/base/finding.h"
#include "croquis/base/members.h"
#include "croquis/base/progress.h"
#include "croquis/geometry/camera.h"
#include "croquis/geometry/perspective_drawing.h"
#include "croquis/perspective/camera_estimation.h"
#include "croquis/perspective/drawing_vertices.h"

/// From the vertices of a drawing and its camera to their coordinates.
///
/// Cho and Kim, section 3.1, item 5, pass coordinates on from edge to edge, which gives another result for another
/// order. Here coordinates that strokes make equal are one unknown (a class), and all classes are found at once, so
/// that planes are planes and cycles close, exactly.
namespace croquis {

struct CoordinateOptions {
  bool promote = true;               ///< straight strokes in planes that point at a vanishing point run along that axis
  double promote_sigmas = 3;         ///< as long as they miss it by no more than so many sigma …
  double promote_distance = 1.5;     ///< u, or so much
  double promote_ratio = 3;          ///< and the other axis of their plane by so many times as much
  bool merge_planes = true;          ///< planes of one axis that are nearly one become one
  double merge_distance = 0.02;      ///< × diagonal of the bounding box, 0..0.05; coarse drawings: up to 0.05
  double merge_rise = 16;            ///< 1..25: chi-squared that making two planes one may cost
  double contradiction = 4;          ///< 2..10: rms of the residuals, in sigma, from which on something is wrong
  double contradiction_noise = 0.5;  ///< u: sigma is at least taken for this
  double lone_contradiction = 7;     ///< a single vertex so many sigma off is also wrong, if a stroke explains it
  int most_contradictions = 10;      ///< strokes that are left out
  double grazing = 2 * std::numbers::pi / 180;  ///< radians: planes seen at a smaller angle give no depth
  double grazing_deviation = 0.05;              ///< × diagonal of the bounding box: from then on it is reported
};

constexpr auto members(const CoordinateOptions& options) {
  return std::tie(options.promote, options.promote_sigmas, options.promote_distance, options.promote_ratio,
                  options.merge_planes, options.merge_distance, options.merge_rise, options.contradiction,
                  options.contradiction_noise, options.lone_contradiction, options.most_contradictions, options.grazing,
                  options.grazing_deviation);
}

static_assert(lists_every_member<CoordinateOptions>);

/// A straight stroke that is taken for one along an axis.
struct PromotedStroke {
  Index stroke = no_index;
  StrokeGroup group = StrokeGroup::Unknown;
  friend bool operator==(const PromotedStroke&, const PromotedStroke&) = default;
};

/// Two planes that became one.
struct MergedPlanes {
  int axis = 0;
  Index vertex = no_index;  ///< one of the lower plane
  Index other = no_index;   ///< one of the upper plane
  double distance = 0;      ///< model units, before
};

/// A stroke that says otherwise than the rest; its group is ignored.
struct Contradiction {
  Index stroke = no_index;
  StrokeGroup fix = StrokeGroup::Unknown;  ///< the group that fits, Unknown if none does
  Index split = no_index;                  ///< a vertex that fits better as two, no_index if the stroke is to blame
};

/// Where vertices are. Model units.
struct VertexCoordinates {
  Camera camera;                              ///< with its eye in the world
  std::vector<Vec3> positions;                ///< of each vertex of the drawing
  std::vector<std::array<Index, 3>> classes;  ///< of each vertex: the classes of its x, y and z
  std::vector<double> class_values;           ///< of each class; positions are made of these, bit by bit
  std::vector<Index> component;               ///< of each vertex; 0 is the largest piece
  std::vector<StrokeGroup> groups;            ///< of each stroke as used: promoted, Unknown if ignored
  std::vector<Vec2> residuals;                ///< px, of each vertex: where it is seen minus where it was drawn
  std::vector<double> deviations;             ///< of each vertex in space; empty for very large drawings
  std::vector<PromotedStroke> promoted;       ///< by stroke
  std::vector<MergedPlanes> merged;           ///< as they were found
  std::vector<Contradiction> contradictions;  ///< as they were found
  double rms = 0;                             ///< px per coordinate
  std::vector<bool> in_front;                 ///< of each vertex; others can't be drawn (NOT_IN_FRONT)
  Findings warnings;
};

/// Straight strokes in planes that run along an axis of their plane.
/// @param groups of all strokes so far
std::vector<PromotedStroke> promoted_strokes(const PerspectiveDrawing& drawing, std::span<const StrokeGroup> groups,
                                             const CameraEstimate& camera, const CoordinateOptions& options);

/// The coordinates of all vertices.
///
/// Scale and place follow from the known lengths and the known point; missing: the eye is 10 units from the known
/// point, the origin is the vertex nearest to the eye.
/// @param groups   what each stroke is taken for
/// @param promoted those of them that may be taken back to the drawn group when they contradict the rest
/// @throws Cancelled; what is wrong becomes warnings: DISCONNECTED, CONTRADICTION, GRAZING, NOT_IN_FRONT
VertexCoordinates solve_coordinates(const PerspectiveDrawing& drawing, const DrawingVertices& vertices,
                                    const CameraEstimate& camera, std::span<const StrokeGroup> groups,
                                    std::span<const PromotedStroke> promoted, const CoordinateOptions& options,
                                    Progress& progress);

/// The source's own way: from the given vertex on along edges, breadth first; each new vertex lies on its ray in the
/// known plane that is seen least at a grazing angle. For previews and comparison; errors add up along the way.
/// @param first_depth of the vertex `from`
/// @return of each vertex relative to the eye; NaN for those that aren't reached
std::vector<Vec3> propagate(const PerspectiveDrawing& drawing, const DrawingVertices& vertices,
                            const CameraEstimate& camera, std::span<const StrokeGroup> groups, Index from,
                            double first_depth);

}  // namespace croquis

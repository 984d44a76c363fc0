// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <tuple>
#include <vector>

#include "croquis/base/finding.h"
#include "croquis/base/members.h"
#include "croquis/base/progress.h"
#include "croquis/geometry/perspective_drawing.h"
#include "croquis/perspective/camera_estimation.h"
#include "croquis/perspective/curve_lifting.h"
#include "croquis/perspective/drawing_vertices.h"
#include "croquis/perspective/edge_continuity.h"
#include "croquis/perspective/vertex_coordinates.h"

namespace croquis {

class StageCache;

/// Everything that can be set between a drawing and its curves in space. Saved with a document.
struct NetworkReconstructionOptions {
  DrawingVertexOptions vertices;
  CameraOptions camera;
  CoordinateOptions coordinates;
  CurveOptions curves;
  CurveContinuityOptions continuity;          ///< its ends are those that strokes lock
  std::optional<CameraEstimate> held_camera;  ///< taken as it is, while somebody drags a stroke; not saved
  StageCache* cache = nullptr;                ///< keeps cameras from earlier runs, not owned; null: nothing is kept
};

struct ReconstructedNetwork {
  DrawingVertices vertices;
  CameraEstimate camera;  ///< its eye at the origin; coordinates.camera is the one in the world
  VertexCoordinates coordinates;
  LiftedCurves curves;
  std::vector<SmoothJoint> joints;  ///< ends of curves that go on smoothly into each other
  std::vector<FittedCurve> fitted;  ///< of each curve, after that
  std::vector<bool> flagged;        ///< of each stroke: a warning names it
  Findings warnings;                ///< of all steps, in their order
};

/// From a drawing to its camera and its curves in space: vertices, camera, coordinates, curves.
///
/// Straight strokes that have colours of planes but run along an axis join the lines that the camera is fitted to, and
/// the camera is fitted again. In one-point perspective two known lengths, one across and one along the view, stand in
/// for the field of view. Corners behind each other that are seen at one place, and so were taken for one vertex, are
/// distinguished where their strokes contradict each other. What can't be used stays in the picture and is named by a
/// warning.
/// @throws Error VP_INSUFFICIENT, ALL_PARALLEL, EYE_NONE; Cancelled
/// A drawing of 50 strokes takes about 15 ms, with a held camera 1 ms.
ReconstructedNetwork reconstruct_network(const PerspectiveDrawing& drawing, const NetworkReconstructionOptions& options,
                                         Progress& progress);

/// Findings about curves of the network, as findings about the strokes that these are parts of, with their places.
Findings findings_of_strokes(Findings findings, const PerspectiveDrawing& drawing, const LiftedCurves& curves);

}  // namespace croquis

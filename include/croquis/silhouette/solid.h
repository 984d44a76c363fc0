// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "croquis/base/finding.h"
#include "croquis/base/progress.h"
#include "croquis/geometry/drawing.h"
#include "croquis/geometry/poly_mesh.h"
#include "croquis/silhouette/labelled_figure.h"
#include "croquis/silhouette/options.h"

/// From a labelled figure to closed solids that keep the drawn order and never touch.
/// Cordier, Seo, Cho 2006, sections 4 and 5.
namespace croquis::silhouette {

/// One solid and what is known about it.
struct SolidObject {
  std::string name;
  std::vector<Index> strokes;  ///< indices into Drawing::strokes
  int euler_region = 0;        ///< of the immersed region
  int euler_mesh = 0;          ///< of its mesh, before it is joined with others; twice euler_region
  double thickness = 1;        ///< factor of its depth
};

/// A surface of its own: that of one object, or of several attached ones joined.
struct SolidShell {
  std::vector<Index> objects;  ///< indices into Solid::objects
  int euler_mesh = 0;          ///< counted
};

/// Two objects that were attached.
struct SolidAttachment {
  std::string a;
  std::string b;
  double kappa = 0;  ///< of joined ones
  Hold hold = Hold::Joined;
  double blend = 0;        ///< of joined ones
  Vec2 at = Vec2::Zero();  ///< where they overlap, sketch units
};

/// A drawn line on the surface, such as a mouth or a fold.
struct SurfaceLine {
  Index stroke = 0;  ///< index into Drawing::strokes; one stroke may give several lines
  std::vector<Vec3> points;
};

struct SolidDiagnostics {
  std::size_t skeleton_vertices = 0;
  std::size_t collision_constraints = 0;
  double scale = 0;        ///< L: median skeleton radius, sketch units (largest part's)
  double minimum_gap = 0;  ///< least distance along z between successive sheets, measured on the mesh before ridges are
                           ///< raised; infinity if none overlap
  double silhouette_iou = 0;  ///< of the mesh's projection and the drawn region; NaN for a draft
  int solver_iterations = 0;  ///< of the depth solves, the largest
  double solver_residual = 0;
  double depth_ratio = 0;  ///< depth of the figure over the widths of what lies over what, the largest
};

/// The solids of a drawing.
struct Solid {
  PolyMesh mesh;      ///< triangles of all objects; face channel "object" names the one that a face came from; where
                      ///< strokes have a `fill_key`, vertex channel "color", grey for parts without colour
  PolyMesh skeleton;  ///< polylines; vertex channel "radius"
  std::vector<SolidObject> objects;
  std::vector<SolidShell> shells;
  std::vector<SolidAttachment> attached;
  std::vector<SurfaceLine> lines;     ///< details that aren't grooves or ridges
  std::optional<std::size_t> carved;  ///< how many are, where that was asked for
  double used = 1;  ///< 0.5..1, share by length of the strokes that are in it; those drawn as hidden aren't counted
  SolidDiagnostics diagnostics;
  Findings findings;  ///< warnings, and the errors of parts that could not become solid
};

/// Sections 8 to 13 for every part of a labelled drawing.
///
/// Objects whose heights can't be trusted are refused by name (E_NOT_SOLVED): the solve gave up or may be farther off
/// than DepthOptions::accuracy, or they are deeper than the drawing explains.
///
/// Attached objects that overlap are joined to one surface. A pair for which that fails is named and kept apart
/// (W_ATTACH), the others are joined; a pair that doesn't overlap stays as it is (W_ATTACH_APART).
/// @throws Error when no part becomes a solid, or (E_LEFT_OUT) they use less than half of what is drawn, by length, or
///         lack the outline that encloses most; E_ATTACH for every pair that names an unknown object, or one twice, or
///         has a kappa outside 0..1; Cancelled
Solid inflate(const LabelledDrawing& labelled, const Drawing& drawing, const Options& options, Progress& progress);

}  // namespace croquis::silhouette

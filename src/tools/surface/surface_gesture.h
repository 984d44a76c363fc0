// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "croquis/tools/surface/surface_tool.h"

namespace croquis {

/// A gesture of the surface tool under way, and what lay under its beginning.
struct SurfaceGesture {
  enum class Kind { Draw, Press, Box, Move, Handle, Slope, Ring, Pull };

  /// What a sample of a stroke lies over.
  struct Sample {
    Vec2 pixel = Vec2::Zero();
    std::optional<SurfaceHit> patch;
    std::optional<Vec3> mesh;  ///< nearer than the patch
  };

  Kind kind = Kind::Press;
  MeshEvent start;                                   ///< that began it
  Vec2 last = Vec2::Zero();                          ///< where the pointer is
  std::vector<Sample> stroke;                        ///< Draw
  std::optional<SurfaceSnap> from;                   ///< Draw: what the stroke begins at
  std::optional<PickedPlace> picked;                 ///< under the press
  std::optional<SlopeTip> tip;                       ///< under the press
  std::optional<SurfaceHit> hit;                     ///< under the press
  std::string ring;                                  ///< the selected point whose ring was pressed; empty: none
  NetworkElements moving;                            ///< Move
  std::shared_ptr<const AttributeNetwork> original;  ///< before the drag …
  std::optional<NetworkPartners> partners;           ///< … and its symmetry
  std::optional<recorded::Step> step;                ///< what the drag does by now
};

// ---- Drawing

/// Of an end of a stroke: a node or a place of a curve within reach, px.
std::optional<SurfaceSnap> snap_at(const AttributeNetwork& network, const ViewFrame& frame, const Vec2& pixel,
                                   double reach);

/// Adds what the pointer is over now. @param sight null: nothing lies under it
void add_sample(SurfaceGesture& gesture, const SurfaceSight* sight);

/// Where a stroke lies: on a patch, on a mesh, or on a plane.
struct StrokeInSpace {
  std::vector<Vec3> points;
  std::string face;                 ///< empty: on no patch
  std::optional<SpacePlane> plane;  ///< on neither patch nor mesh
};

/// @param end what its end goes to
StrokeInSpace stroke_in_space(const SurfaceGesture& gesture, const SurfaceSettings& settings,
                              const AttributeNetwork& network, const std::optional<SurfaceSnap>& end);

/// The step that a stroke is; nothing for one that lies nowhere.
std::optional<recorded::SurfaceStroke> stroke_step(const SurfaceGesture& gesture, const StrokeInSpace& stroke,
                                                   const std::optional<SurfaceSnap>& end);

// ---- What can be dragged

/// Handles of curves (control_handles), without those at nodes.
std::vector<ControlHandle> free_handles(const AttributeNetwork& network, const std::vector<std::string>& curves);

/// Of each patch along a curve.
std::vector<SlopeTip> slope_tips(const AttributeNetwork& network, const std::string& curve, const SurfaceSight& sight);

std::optional<SlopeTip> nearest_tip(const std::vector<SlopeTip>& tips, const ViewFrame& frame, const Vec2& pixel,
                                    double reach);

/// Whether a closed row of places passes within reach of a pixel.
bool passes(const std::vector<Vec3>& ring, const ViewFrame& frame, const Vec2& pixel, double reach);

/// What a drag does, with the pointer where it is. @param snap px: a single node goes to another one within
recorded::Step dragged_step(const SurfaceGesture& gesture, const SurfaceSight* sight, double snap);

}  // namespace croquis

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "croquis/attribute_surface/face_surface.h"
#include "croquis/base/finding.h"
#include "croquis/base/progress.h"
#include "croquis/geometry/attribute_network.h"

/// Attribute based surfaces on chordlength domains: every loop of curves is one smooth patch, without rectangles to
/// plan, and points and curves inside it pull it where they are put.
/// Source: Kim and Park 2006.
namespace croquis {

class StageCache;

struct AttributeSurfaceOptions {
  std::optional<AttributeMode> mode;      ///< none: as each face says
  std::optional<AttributeDomain> domain;  ///< none: as each face says
  std::optional<double> fullness;         ///< -1..2; none: as each face says
  StageCache* cache = nullptr;            ///< curves and faces from earlier runs, not owned; null: all is made again
};

/// A curve that can be evaluated.
struct SurfaceCurve {
  std::shared_ptr<const ArcLengthCurve> curve;  ///< null: it failed, findings say why
  std::vector<Index> faces;                     ///< that could be evaluated and have it in their loop
  bool smooth = false;    ///< exactly two of them, both of mode Smooth, meet in it with common tangent planes
  std::size_t start = 0;  ///< number of the corner where it begins: all ends that meet in a place have one number,
  std::size_t end = 0;    ///< and are in the same place bit for bit
};

/// A face that can be evaluated.
struct SurfaceFace {
  std::shared_ptr<const FaceSurface> surface;  ///< null: it failed, findings say why
  bool flipped = false;  ///< its loop runs against that of the first face that it is joined to: meshes turn it round
  double folded = 0;     ///< 0..1, share of its places where the normal points away from the loop's
  std::string content;   ///< all that the surface depends on, byte by byte: a key for what is made from it
};

/// Where a point attribute of the network is met.
struct SurfacePoint {
  std::optional<FanPlace> fan;  ///< none: its face failed, or the point is left out
  bool moved_inside = false;    ///< the nearest place was on the boundary
};

/// Everything by the indices of the network.
struct AttributeSurface {
  double tolerance = 0;  ///< model units, the one that was used
  std::vector<SurfaceCurve> curves;
  std::vector<SurfaceFace> faces;
  std::vector<SurfacePoint> points;
  std::size_t corners = 0;  ///< how many places curves begin and end in
  Findings findings;        ///< warnings; errors name curves, faces and points that were left out

  /// At least one face could be evaluated.
  bool any() const;
};

/// Evaluates a network. What is wrong with a curve, face or point leaves only that out, and names it (E_GAP,
/// E_OPEN_LOOP, E_TOO_FEW, E_TOO_MANY, E_ZERO_LENGTH, E_POINT_CONFLICT, E_INNER_OUTSIDE, E_SLOPE; W_SNAP, W_TOO_MANY,
/// W_DOMAIN_RELAXED, W_SMOOTH_CONFLICT, W_ORIENT, W_NONMANIFOLD, W_FOLD, W_MOVED_INSIDE, W_POINTS_NEAR).
/// @param network valid (croquis::validate)
/// @throws Cancelled
AttributeSurface make_attribute_surface(const AttributeNetwork& network, Progress& progress,
                                        const AttributeSurfaceOptions& options = {});

}  // namespace croquis

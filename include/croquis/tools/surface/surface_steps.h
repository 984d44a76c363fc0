// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "croquis/attribute_surface/face_edit.h"
#include "croquis/attribute_surface/network_mirror.h"
#include "croquis/tools/recording/vocabulary.h"

/// Steps of the surface tool. Elements have their ids; places are model units of the network's own space.
namespace croquis::recorded {

/// What an end of a stroke went to: a node, or a place of a curve.
struct CurveEnd {
  std::string node;
  std::string curve;  ///< where there is no node
  double at = 0;      ///< of the curve: fraction of its arc length, 0..1

  bool any() const { return !node.empty() || !curve.empty(); }
  friend bool operator==(const CurveEnd&, const CurveEnd&) = default;
};

/// A stroke became curves between nodes, or with a face a curve inside it.
struct SurfaceStroke {
  std::vector<Vec3> points;  ///< at least one
  double unit = 1;           ///< model units per px of the view drawn in, > 0
  CurveEnd start;
  CurveEnd end;
  std::string face;

  static constexpr std::array verbs{"surface-stroke"};
  void describe(Fields& fields);
};

/// Elements were moved, or a handle of a curve.
struct SurfaceDrag {
  NetworkElements elements;
  std::optional<ControlHandle> handle;
  Vec3 by = Vec3::Zero();
  std::string into;  ///< the node that the dragged one was merged into

  static constexpr std::array verbs{"surface-drag"};
  void describe(Fields& fields);
};

/// A loop of curves, in any order, became a patch.
struct SurfacePatch {
  std::vector<std::string> curves;

  static constexpr std::array verbs{"surface-patch"};
  void describe(Fields& fields) { fields.required("curves", curves); }
};

/// A point attribute was put on a patch.
struct SurfacePoint {
  NewPoint point;

  static constexpr std::array verbs{"surface-point"};
  void describe(Fields& fields);
};

struct SurfacePointSetting {
  std::vector<std::string> points;
  PointSetting setting;

  static constexpr std::array verbs{"surface-set-points"};
  void describe(Fields& fields);
};

struct SurfaceJoin {
  std::vector<std::string> curves;
  CurveJoin join = CurveJoin::Smooth;

  static constexpr std::array verbs{"surface-join"};
  void describe(Fields& fields);
};

struct SurfaceFaceSetting {
  std::vector<std::string> faces;
  FaceSetting setting;
  bool turned = false;  ///< the loops were turned round

  static constexpr std::array verbs{"surface-set-faces"};
  void describe(Fields& fields);
};

/// The slope of a patch along a curve; with neither normal nor magnitude, it is found automatically again.
struct SurfaceSlope {
  SlopeSide side;
  std::optional<SlopeHandle> handle;

  static constexpr std::array verbs{"surface-slope"};
  void describe(Fields& fields);
};

/// An inner curve was set, or with a face but without a setting added or taken away.
struct SurfaceInner {
  std::string curve;
  std::string face;
  bool removed = false;
  InnerSetting setting;

  static constexpr std::array verbs{"surface-inner"};
  void describe(Fields& fields);
};

struct SurfaceSplit {
  std::string curve;
  std::optional<double> at;  ///< fraction of the curve's arc length …
  std::string face;          ///< … or instead the face that the curve splits

  static constexpr std::array verbs{"surface-split"};
  void describe(Fields& fields);
};

/// Two faces became one by deleting the curve between them.
struct SurfaceMerge {
  std::string curve;

  static constexpr std::array verbs{"surface-merge"};
  void describe(Fields& fields) { fields.required("curve", curve); }
};

struct SurfaceDelete {
  NetworkElements elements;

  static constexpr std::array verbs{"surface-delete"};
  void describe(Fields& fields);
};

struct SurfaceMirror {
  SymmetryPlane plane;

  static constexpr std::array verbs{"surface-mirror"};
  void describe(Fields& fields);
};

/// Edits are done on both sides of a plane from now on; without one, no longer.
struct SurfaceSymmetry {
  std::optional<SymmetryPlane> plane;

  static constexpr std::array verbs{"surface-symmetry"};
  void describe(Fields& fields);
};

struct SurfaceChoice {
  NetworkElements elements;  ///< selected

  static constexpr std::array verbs{"surface-select"};
  void describe(Fields& fields);
};

/// All of them, with the counts "surface-nodes", "surface-curves", "surface-faces", "surface-points",
/// "surface-selected", "surface-patches-made" (faces that have a surface), "surface-nearer-dents" (points whose dents
/// lie nearer to them than on uniform domains, while these are shown); and the ranges "surface-boundary-error" and
/// "surface-point-errors" from 0 to the largest.
const Vocabulary& surface_steps();

}  // namespace croquis::recorded

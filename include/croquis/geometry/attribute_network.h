// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "croquis/base/finding.h"
#include "croquis/geometry/affine3.h"
#include "croquis/geometry/bounds.h"

/// Curves, points and slopes that attribute based surfaces are made from (Kim and Park 2006).
///
/// Lists that refer to each other by index; ids are what people and files call the elements, different within each
/// list. All lengths are model units.
namespace croquis {

/// How two faces meet in a curve.
enum class CurveJoin : std::uint8_t { Crease, Smooth };

/// How a face is blended from its curves: with common tangent planes at smooth curves, from positions alone, or by the
/// formulas of the paper.
enum class AttributeMode : std::uint8_t { Smooth, Position, Paper };

/// The polygon that a face is a map of: with the curves' lengths as its sides, or a regular one.
enum class AttributeDomain : std::uint8_t { Chordlength, Uniform };

/// What the surface does at a point: round or a tip.
enum class PointProfile : std::uint8_t { Smooth, Cone };

/// What it does along an inner curve: round or a ridge.
enum class InnerProfile : std::uint8_t { Smooth, Sharp };

/// A corner. It owns the place: the ends of its curves follow it.
struct AttributeNode {
  std::string id;
  Vec3 point = Vec3::Zero();
};

/// A Bézier curve of any degree.
struct AttributeCurve {
  std::string id;
  Index from = no_index;      ///< node; of a free curve none
  Index to = no_index;        ///< node; of a free curve none
  std::vector<Vec3> control;  ///< both ends included, at least 2; none: straight between its nodes
  CurveJoin join = CurveJoin::Crease;
};

/// A curve as a loop walks along it.
struct AttributeSide {
  Index curve = no_index;
  bool reversed = false;  ///< from its end to its start

  friend bool operator==(const AttributeSide&, const AttributeSide&) = default;
};

/// A curve inside a face that the surface passes through.
struct InnerCurve {
  Index curve = no_index;
  InnerProfile profile = InnerProfile::Smooth;
  std::optional<double> radius;  ///< about half-height, > 0; none: from the distance to the face's sides

  friend bool operator==(const InnerCurve&, const InnerCurve&) = default;
};

struct AttributeFace {
  std::string id;
  std::vector<AttributeSide> loop;  ///< counter-clockwise seen from where the face's normal points to
  AttributeMode mode = AttributeMode::Smooth;
  double fullness = 0.7;  ///< -1..2
  AttributeDomain domain = AttributeDomain::Chordlength;
  std::vector<InnerCurve> inner;
};

/// A place of a face's domain: c + a (V[corner] - c) + b (V[corner+1] - c) with the mean c of the domain's vertices V.
/// Of a face of two sides the domain has four vertices.
struct FanPlace {
  std::size_t corner = 0;
  double a = 0;
  double b = 0;

  friend bool operator==(const FanPlace&, const FanPlace&) = default;
};

/// A place in space that a face passes through.
struct PointAttribute {
  std::string id;
  Index face = no_index;
  Vec3 point = Vec3::Zero();
  std::optional<FanPlace> fan;   ///< where in the domain; none: the place nearest to the point
  std::optional<double> radius;  ///< about half-height, > 0; none: from the distance to the face's sides
  PointProfile profile = PointProfile::Smooth;
  std::optional<Vec3> normal;  ///< of the surface there, of any length above 0; none: as it comes
};

/// Normals along a curve that replace those found automatically.
struct SlopeAttribute {
  Index curve = no_index;
  Index face = no_index;      ///< that it is for; none: all faces along the curve
  std::vector<double> at;     ///< fractions of the arc length from the curve's start, 0..1, ascending
  std::vector<Vec3> normals;  ///< one for each, of any length above 0
  double magnitude = 1;       ///< of the slope across the curve
};

/// A network as it is drawn and stored. What a surface needs beyond that (loops that close, curves that meet their
/// nodes) isn't promised: a face that lacks it stays in the network until it is mended.
struct AttributeNetwork {
  std::string name;
  std::string units;                ///< of all lengths; empty where not known
  std::optional<double> tolerance;  ///< > 0; none: 1e-4 × the diagonal of the bounding box
  std::vector<AttributeNode> nodes;
  std::vector<AttributeCurve> curves;
  std::vector<AttributeFace> faces;
  std::vector<PointAttribute> points;
  std::vector<SlopeAttribute> slopes;
};

/// The control polygon of a curve: of one without, its two nodes.
std::vector<Vec3> control_polygon(const AttributeNetwork& network, const AttributeCurve& curve);

/// A place of a Bézier curve of any degree, t in 0..1 (de Casteljau).
/// @pre control is not empty
Vec3 bezier_point(std::vector<Vec3> control, double t);

/// Least number of vertices of a face's domain: that of its sides, but 4 for two sides.
std::size_t domain_corners(const AttributeFace& face);

/// What no network can hold: two elements of one id (E_DUP_ID), references to what isn't there (E_NO_NODE, E_NO_CURVE,
/// E_NO_FACE), a curve twice in a loop (E_DUP_CURVE), numbers that aren't finite (E_NOT_FINITE) or out of their range
/// (E_SYNTAX), curves with neither nodes nor control points (E_NO_NODE). Each names its element; at most 100.
Findings validate(const AttributeNetwork& network);

/// Of all nodes, control points and points.
BoundingBox bounds_of(const AttributeNetwork& network);

/// The mapped network. Radii and the tolerance grow with the cube root of the volume. A map that mirrors turns every
/// loop round: normals still point to where the mapped ones would.
/// @param map invertible
AttributeNetwork transformed(const AttributeNetwork& network, const Affine3& map);

}  // namespace croquis

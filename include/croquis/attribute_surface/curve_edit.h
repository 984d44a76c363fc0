// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "croquis/attribute_surface/network_elements.h"

/// What people do to the nodes and curves of an attribute network: pure functions from a network to a network. Elements
/// that they don't name keep equal values in the same order. Every network that comes out is one that croquis::validate
/// finds nothing wrong with, if that went in.
///
/// All of them: @throws Error (Usage, E_INPUT) for elements that aren't there and numbers that can't be; nothing is
/// lost.
namespace croquis {

/// A network with something new in it.
struct AddedElement {
  AttributeNetwork network;
  std::string id;  ///< of what was added
};

AddedElement add_node(AttributeNetwork network, const Vec3& point);

struct NewCurve {
  std::string from;           ///< node; empty: a new one where the control polygon begins
  std::string to;             ///< node; empty: a new one where it ends
  std::vector<Vec3> control;  ///< at least 2; empty: straight between its nodes. Its ends are brought to the nodes
  CurveJoin join = CurveJoin::Crease;
  bool free = false;  ///< without nodes, as inner curves are; `from` and `to` are empty then
};

AddedElement add_curve(AttributeNetwork network, const NewCurve& curve);

/// The control polygon with its ends moved: control point j of n by (1 - j/n) start + (j/n) end. Straight stays
/// straight.
std::vector<Vec3> with_ends_moved_by(std::vector<Vec3> control, const Vec3& start, const Vec3& end);

/// Moves nodes; the ends of their curves follow as with_ends_moved_by has it. Each once, though it is named twice.
AttributeNetwork move_nodes(AttributeNetwork network, const std::vector<std::string>& nodes, const Vec3& by);

/// Of a curve what people drag: its control polygon, raised to degree 3 where it has less, so that lines can be bent.
std::vector<Vec3> control_handles(const AttributeNetwork& network, const AttributeCurve& curve);

/// A point of control_handles.
struct ControlHandle {
  std::string curve;
  std::size_t control = 0;
  friend bool operator==(const ControlHandle&, const ControlHandle&) = default;
};

/// Moves handles of curves; one at a node moves the node.
AttributeNetwork move_handles(AttributeNetwork network, const std::vector<ControlHandle>& handles, const Vec3& by);

/// Moves whole curves with their nodes; other curves at these follow.
AttributeNetwork move_curves(AttributeNetwork network, const std::vector<std::string>& curves, const Vec3& by);

/// A curve in two.
struct SplitCurve {
  AttributeNetwork network;
  std::string node;    ///< where they meet; empty for a free curve
  std::string second;  ///< new, from there to the old end; the first part keeps the id
};

/// Divides a curve without changing its shape (de Casteljau). Loops, slopes and inner curves have both parts then; fan
/// places of points on faces along it are forgotten, since the faces' domains have a corner more.
/// @param at fraction of the arc length, above 0 and below 1
SplitCurve split_curve(AttributeNetwork network, const std::string& curve, double at);

/// Of a curve and a place the fraction of the arc length nearest to it, 0..1.
double nearest_fraction(const AttributeNetwork& network, Index curve, const Vec3& place);

/// Gives a free curve nodes at its ends: those within reach, else new ones.
/// @param reach model units, >= 0
AttributeNetwork tie_ends(AttributeNetwork network, const std::string& curve, double reach);

AttributeNetwork set_join(AttributeNetwork network, const std::vector<std::string>& curves, CurveJoin join);

/// Moves a node onto another one: one node then, the second. Curves without control points between the two vanish, and
/// faces of which less than two sides are left.
AttributeNetwork merge_nodes(AttributeNetwork network, const std::string& node, const std::string& into);

// ---- Slopes

/// Slopes along a curve: for one face, or with an empty face for all of them.
struct SlopeSide {
  std::string curve;
  std::string face;
  friend bool operator==(const SlopeSide&, const SlopeSide&) = default;
};

struct SlopeHandle {
  double at = 0;                    ///< fraction of the curve's arc length, 0..1
  std::optional<Vec3> normal;       ///< of any length above 0; none: as it is
  std::optional<double> magnitude;  ///< none: as it is
};

/// Sets the surface's normal at a place of a curve, which gets a slope when it has none, and the slope's magnitude.
/// Places nearer than 1e-6 are one. A slope needs a normal at some place.
AttributeNetwork set_slope(AttributeNetwork network, const SlopeSide& side, const SlopeHandle& handle);

/// Back to what is found automatically. @param at of the place to forget; none: all of them
AttributeNetwork remove_slope(AttributeNetwork network, const SlopeSide& side, std::optional<double> at = {});

/// Its index in the network's slopes, or no_index.
Index find_slope(const AttributeNetwork& network, const SlopeSide& side);

}  // namespace croquis

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "croquis/geometry/curve_network.h"
#include "croquis/geometry/perspective_drawing.h"

/// Solids whose curves are known exactly, for drawing them in perspective. Model units; z is up; front faces look to
/// -y.
namespace croquis::test {

/// A curve as a face walks along it.
struct SolidSide {
  Index curve = 0;
  bool reversed = false;  ///< from the curve's end to its start
  friend bool operator==(const SolidSide&, const SolidSide&) = default;
};

/// Loops in cyclic order, the outer one first. Seen from outside the outer loop runs counter-clockwise and holes run
/// clockwise, so that every curve is walked along once in each direction.
struct SolidFace {
  std::vector<std::vector<SolidSide>> loops;
  bool planar = true;
};

/// A construction stroke that ties two vertices which no edge connects.
struct SolidLink {
  Index from = 0;
  Index to = 0;
  StrokeGroup group = StrokeGroup::Unknown;
};

/// Every curve lies in a plane at right angles to an axis and is polynomial; its id is "e00", "e01" …
struct PerspectiveSolid {
  std::string name;
  CurveNetwork network;
  std::vector<StrokeGroup> groups;  ///< of the curves
  std::vector<SolidFace> faces;
  std::vector<SolidLink> links;  ///< enough to make one piece of what shares coordinates
  int shells = 1;
  int genus = 0;

  /// Hole loops of all faces: R in V - E + F - R = 2 (S - G).
  int rings() const;
};

PerspectiveSolid box();             ///< 4 x 3 x 2
PerspectiveSolid l_block();         ///< extruded along y: V 12, F 8
PerspectiveSolid t_block();         ///< extruded along y: V 16, F 10
PerspectiveSolid wedge();           ///< a box with a slanted top: two slanted lines, an oblique face
PerspectiveSolid cut_corner_box();  ///< an oblique triangle instead of a corner: V 10, F 7
PerspectiveSolid stack(int boxes);  ///< boxes of one width on each other, walls between them are no faces: F 4n + 2
PerspectiveSolid pocket_box();      ///< a blind hole in the top; one link, the rim of the pocket is tied to the top
PerspectiveSolid two_boxes();       ///< two shells that share no vertex; one link
PerspectiveSolid ring_frame();      ///< genus 1, front and back with a hole; one link, in the front
PerspectiveSolid mitred_frame();    ///< genus 1, four faces in front and four at the back, no holes in faces

PerspectiveSolid rounded_block();  ///< a box with one upright edge rounded
PerspectiveSolid d_block();        ///< faces of two sides; the round stroke has two pieces
PerspectiveSolid cylinder();       ///< two circles of four arcs
PerspectiveSolid soap();           ///< a box whose top has four curves: one patch of four sides
PerspectiveSolid bottle();         ///< body and neck joined by four shoulder curves: four patches of six sides
PerspectiveSolid camera_body();    ///< a box with a lens in front: one face with a circular hole; one link
PerspectiveSolid camera_ring();    ///< the same with a pocket in the lens: a plane ring between two circles; two links
PerspectiveSolid ball();           ///< three great circles: eight patches of three sides, all edges smooth

/// All of the above; stacks of 2 to 6.
std::vector<PerspectiveSolid> all_solids();

}  // namespace croquis::test

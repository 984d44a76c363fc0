// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "croquis/geometry/affine3.h"
#include "croquis/geometry/bounds.h"
#include "croquis/geometry/rational_cubic.h"

namespace croquis {

/// A curve of a network: one or more cubics that follow each other.
struct NetworkCurve {
  std::string id;                     ///< unique in the network; the stroke that it was drawn as
  Index start = no_index;             ///< vertex of the network
  Index end = no_index;               ///< another or the same one
  std::vector<RationalCubic> pieces;  ///< at least one; ends are bit-identical to the vertices and to each other
  bool straight = false;              ///< one piece whose points lie on the line between the ends, exactly or nearly

  /// Direction at an end, from that end into the curve; unit vector.
  Vec3 direction_from_start() const;
  Vec3 direction_from_end() const;
};

/// Curves in space that meet at vertices: what surfaces are spanned over.
///
/// What lies in a plane at right angles to an axis has bit-identical coordinates along it, control points too, so that
/// such planes are found by comparing numbers. What meets doesn't cross elsewhere: crossings in a picture are no
/// vertices.
struct CurveNetwork {
  std::vector<Vec3> vertices;  ///< model units
  std::vector<NetworkCurve> curves;
};

/// Of all vertices and control points, which hold the curves between them.
BoundingBox bounds_of(const CurveNetwork& network);

/// The mapped network, exactly: affine maps keep rational cubics.
CurveNetwork transformed(const CurveNetwork& network, const Affine3& map);

}  // namespace croquis

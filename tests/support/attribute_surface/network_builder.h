// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "croquis/geometry/attribute_network.h"

namespace croquis::test {

/// Puts attribute networks together. Nodes are found by their places, so that faces share them.
class NetworkBuilder {
 public:
  explicit NetworkBuilder(std::string name) { network.name = std::move(name); }

  /// The node within 1e-9 of a place, or a new one there: "n0", "n1" …
  Index node(const Vec3& point);

  /// A new curve "c0", "c1" … between two nodes.
  /// @param inner control points between the ends
  Index curve(Index from, Index to, const std::vector<Vec3>& inner = {}, CurveJoin join = CurveJoin::Crease);

  /// A curve of a whole control polygon.
  Index curve(const std::vector<Vec3>& control, CurveJoin join = CurveJoin::Crease);

  /// A face "f0", "f1" … along the only curves between these nodes; those that aren't there yet become straight ones.
  Index face(const std::vector<Index>& corners);

  Index face(std::vector<AttributeSide> loop);

  AttributeNetwork network;

 private:
  AttributeSide side_between(Index from, Index to);
};

/// A Bézier curve through a smooth curve of 0..1, of the least degree (up to 24) that is within the tolerance at equal
/// parameters; its ends are met exactly.
std::vector<Vec3> bezier_near(const std::function<Vec3(double)>& curve, double tolerance = 1e-10);

}  // namespace croquis::test

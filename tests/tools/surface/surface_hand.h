// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "croquis/tools/surface/surface_tool.h"
#include "support/random.h"
#include "tools/pointer/mesh_views.h"

namespace croquis::test {

/// Pixels that a hand passes in half a second along a polyline or smooth way: it speeds up and slows down, jitters by
/// less than a pixel and misses both ends by up to 2 % of the way.
/// @param way at least two pixels; dense for curves
std::vector<Vec2> by_hand(const std::vector<Vec2>& way, Random& random);

/// A surface tool on a session of its own, used as a hand does.
struct SurfaceHand {
  Session session;
  SurfaceTool tool{session};
  TestCamera camera;
  Random random{7};
  Modifiers held;
  double now = 0;
  std::vector<std::string> recording;  ///< lines of what was committed

  SurfaceHand();

  Vec2 pixel(const Vec3& place) const { return camera.pixel_of(place); }
  Verdict step(PenStep::Kind kind, const Vec2& pixel);
  Verdict stroke(const std::vector<Vec2>& way);             ///< by_hand
  Verdict stroke_through(const std::vector<Vec3>& places);  ///< as they are seen
  Verdict drag(const Vec2& from, const Vec2& to);           ///< by_hand, but begun exactly
  Verdict click(const Vec2& pixel);

  const AttributeNetwork& network() const { return *tool.network(); }
  std::string text() const;  ///< of the network; empty without one
  Vec3 node_place(const std::string& id) const;

  /// Evaluates the network and gives the tool sight of it.
  void look();

 private:
  Verdict noted(Verdict verdict);
};

/// A camera that looks down on the ground from the front.
TestCamera studio_camera();

}  // namespace croquis::test

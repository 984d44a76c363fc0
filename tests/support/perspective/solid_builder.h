// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

#include "support/perspective/solids.h"

namespace croquis::test {

using SideLoop = std::vector<SolidSide>;

SideLoop reversed(const SideLoop& loop);

/// A side of a profile, from its start to the next side's start.
struct ProfileSide {
  Vec2 start = Vec2::Zero();
  std::vector<std::array<Vec2, 3>> pieces;  ///< of a curve: two handles and an end each; none for a line
};

/// Counter-clockwise.
using Profile = std::vector<ProfileSide>;

Profile polygon(std::initializer_list<Vec2> points);
Profile rectangle(const Vec2& low, const Vec2& high);
Profile circle(const Vec2& centre, double radius);  ///< four arcs, from (radius, 0)

/// The handles and the end of a quarter of a circle, turning from the direction `a` to `b` (both of its radius).
std::array<Vec2, 3> quarter(const Vec2& centre, const Vec2& a, const Vec2& b);

/// What a prism leaves at its ends: the loops of the faces that would close it there.
struct Prism {
  std::vector<Index> low, high;
  SideLoop low_loop, high_loop;
};

struct PrismShape {
  Profile profile;  ///< u and v are the axes that follow `axis` in x, y, z, x …
  int axis = 2;
  double from = 0;
  double to = 1;
  bool inside_out = false;  ///< the material is around it
};

class SolidBuilder {
 public:
  explicit SolidBuilder(std::string name) { solid_.name = std::move(name); }

  Index vertex(double x, double y, double z);
  Index line(Index a, Index b);

  /// Through the handles and inner ends of the pieces; the last end is b.
  Index curve(Index a, Index b, std::vector<std::array<Vec3, 3>> pieces);
  Index curve(Index a, Index b, const Vec3& first_handle, const Vec3& second_handle);

  /// A face of one loop, by vertices that one curve each connects.
  void face(std::initializer_list<Index> vertices, bool planar = true);
  void face(std::vector<SideLoop> loops, bool planar = true);

  /// Curves and side faces.
  Prism prism(const PrismShape& shape);
  void link(Index from, Index to);

  PerspectiveSolid take(int shells = 1, int genus = 0);

 private:
  SolidSide side(Index from, Index to) const;
  Vec3 position(Index vertex) const { return solid_.network.vertices[vertex]; }
  Index add_profile_side(const PrismShape& shape, std::size_t number, double level, const std::vector<Index>& ring);

  PerspectiveSolid solid_;
};

}  // namespace croquis::test

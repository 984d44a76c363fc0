// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <catch2/catch.hpp>

#include "geometry/spread_stars.h"
#include "support/meshes/mesh_shapes.h"
#include "support/random.h"

using namespace croquis;
using namespace croquis::test;

namespace {

/// Triangles around vertex 0, from each other vertex to the next.
struct Ring {
  std::vector<Vec3> positions = {Vec3::Zero()};

  std::vector<MeetingTriangle> triangles() const {
    const TriangleMeeting meeting(positions);
    std::vector<MeetingTriangle> result;
    const auto count = static_cast<Index>(positions.size()) - 1;
    for (Index i = 0; i < count; ++i) {
      MeetingTriangle triangle;
      if (meeting.make({0, 1 + i, 1 + (i + 1) % count}, triangle)) result.push_back(triangle);
    }
    return result;
  }

  bool is_spread() const { return spread_stars(positions, triangles())[0] != 0; }

  /// Whether two of the triangles meet beyond what they share, pair by pair.
  bool meets_itself() const {
    const TriangleMeeting meeting(positions);
    const auto all = triangles();
    for (std::size_t i = 0; i < all.size(); ++i) {
      for (std::size_t j = i + 1; j < all.size(); ++j) {
        if (meeting(all[i], all[j], shared_corners(all[i].vertices, all[j].vertices))) return true;
      }
    }
    return false;
  }
};

Ring wound(int spokes, int turns, double height) {
  Ring ring;
  for (int i = 0; i < spokes; ++i) {
    const double angle = 2 * std::numbers::pi * turns * i / spokes + 0.1;
    ring.positions.emplace_back(std::cos(angle), std::sin(angle), height * (i % 2));
  }
  return ring;
}

}  // namespace

TEST_CASE("a star that goes round once is spread, flat, as a cone or wavy; one that goes round twice isn't") {
  for (int spokes = 3; spokes <= 16; ++spokes) {
    for (const double height : {0.0, 0.3, -0.3}) CHECK(wound(spokes, 1, height).is_spread());
    Ring cone = wound(spokes, 1, 0);
    for (std::size_t i = 1; i < cone.positions.size(); ++i) cone.positions[i].z() = -2;
    CHECK(cone.is_spread());
    if (spokes > 4) CHECK_FALSE(wound(spokes, 2, 0).is_spread());
    if (spokes > 6) CHECK_FALSE(wound(spokes, 3, 0.1).is_spread());
  }
}

TEST_CASE("triangles around a spread star never meet beyond their edges, those around others may") {
  std::size_t spread = 0, meeting = 0;
  for (std::uint64_t seed = 0; seed < 20000; ++seed) {
    Random random(seed);
    const int lattice = 2 + static_cast<int>(seed % 4);
    const auto coordinate = [&] {
      return static_cast<double>(random.below(static_cast<Index>(2 * lattice + 1))) - lattice;
    };
    Ring ring;
    const Index spokes = 3 + random.below(6);
    for (Index i = 0; i < spokes; ++i) {
      const double x = coordinate(), y = coordinate();
      ring.positions.emplace_back(x, y, seed % 3 == 0 ? 0 : coordinate());
    }
    const bool is_spread = ring.is_spread(), meets_itself = ring.meets_itself();
    CHECK_FALSE((is_spread && meets_itself));
    spread += is_spread ? 1U : 0U;
    meeting += meets_itself ? 1U : 0U;
  }
  CHECK(spread > 300);
  CHECK(meeting > 5000);
}

TEST_CASE("nearly all vertices of a smooth surface are spread, those on borders aren't") {
  const PolyMesh ring = triangulated(torus(40, 20));
  const auto spread_of = [](const PolyMesh& mesh) {
    const TriangleMeeting meeting(mesh.positions);
    std::vector<MeetingTriangle> triangles(mesh.face_count());
    for (Index f = 0; f < mesh.face_count(); ++f)
      REQUIRE(meeting.make({mesh.face(f)[0], mesh.face(f)[1], mesh.face(f)[2]}, triangles[f]));
    return spread_stars(mesh.positions, triangles);
  };
  const auto spread = spread_of(ring);
  CHECK(static_cast<std::size_t>(std::count(spread.begin(), spread.end(), 1)) == ring.vertex_count());
  PolyMesh open = ring;
  open.corners.resize(open.corners.size() - 3);
  open.face_offsets.pop_back();
  const auto of_open = spread_of(open);
  CHECK(static_cast<std::size_t>(std::count(of_open.begin(), of_open.end(), 1)) == ring.vertex_count() - 3);
}

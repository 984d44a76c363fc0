// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include <catch2/catch.hpp>

#include "croquis/tools/perspective/drawing_edit.h"
#include "croquis/tools/perspective/mirror_completion.h"
#include "tools/perspective/perspective_ink.h"

namespace croquis {
namespace {

using test::plain_drawing;
using test::truth_of;

/// A drawing of a part of a solid, with the truth about that part.
struct Part {
  test::SolidDrawing whole;
  PerspectiveDrawing drawing;
  SolvedDrawing solved;
  std::vector<NetworkCurve> missing;
};

template <typename Keep>
Part part_of(const test::PerspectiveSolid& solid, const Keep& keep) {
  Part part;
  part.whole = plain_drawing(solid, test::three_point_views()[1]);
  part.drawing = part.whole.drawing;
  part.solved = truth_of(part.whole, {"some"});
  const CurveNetwork& all = part.whole.network;
  CurveNetwork kept;
  std::vector<Index> number(all.vertices.size(), no_index);
  for (const NetworkCurve& curve : all.curves) {
    if (!keep(curve, all)) {
      part.missing.push_back(curve);
      remove_strokes(part.drawing, {curve.id});
      continue;
    }
    NetworkCurve copy = curve;
    for (Index* vertex : {&copy.start, &copy.end}) {
      Index& mapped = number[*vertex];
      if (mapped == no_index) {
        mapped = static_cast<Index>(kept.vertices.size());
        kept.vertices.push_back(all.vertices[*vertex]);
      }
      *vertex = mapped;
    }
    kept.curves.push_back(std::move(copy));
  }
  part.solved.network = kept;
  return part;
}

/// How far the image of each missing curve lies from the nearest stroke that was added.
double worst_miss(const Part& part, const std::vector<PerspectiveStroke>& added) {
  double worst = 0;
  for (const NetworkCurve& curve : part.missing) {
    double best = 1e300;
    for (const PerspectiveStroke& stroke : added) {
      double largest = 0;
      for (const RationalCubic& piece : curve.pieces) {
        for (int k = 0; k <= 10; ++k) {
          const Vec2 place = part.whole.camera.project(piece.at(k / 10.0));
          double nearest = 1e300;
          for (const Vec2& other : traced(stroke.pieces, false, 200))
            nearest = std::min(nearest, (place - other).norm());
          largest = std::max(largest, nearest);
        }
      }
      best = std::min(best, largest);
    }
    worst = std::max(worst, best);
  }
  return worst;
}

double extreme(const CurveNetwork& network, int axis, bool high) {
  double value = network.vertices.front()[axis];
  for (const Vec3& vertex : network.vertices)
    value = high ? std::max(value, vertex[axis]) : std::min(value, vertex[axis]);
  return value;
}

TEST_CASE("a half of a bottle is completed to the whole one, curves too") {
  const test::PerspectiveSolid bottle = test::bottle();
  for (const int axis : {0, 1}) {
    const double middle = (extreme(bottle.network, axis, false) + extreme(bottle.network, axis, true)) / 2;
    const Part part = part_of(bottle, [&](const NetworkCurve& curve, const CurveNetwork& all) {
      const double limit = middle + 1e-9;
      return std::min(all.vertices[curve.start][axis], all.vertices[curve.end][axis]) <= limit;
    });
    REQUIRE(part.missing.size() > 3);
    const auto strokes = mirrored_strokes(part.drawing, part.solved, {axis, middle});
    INFO("axis " << axis);
    CHECK(strokes.size() == part.missing.size());
    CHECK(worst_miss(part, strokes) < 1.5);
    const auto proposal = propose_mirror(part.drawing, part.solved);
    REQUIRE(proposal);
    CHECK(proposal->plane.axis == axis);
    CHECK(proposal->plane.at == Approx(middle));

    PerspectiveDrawing completed = part.drawing;
    const auto ids = add_mirrored(completed, strokes);
    CHECK(vertices_of(completed).size() == vertices_of(part.whole.drawing).size());
    for (const std::string& id : ids) CHECK(find_stroke(completed, id)->hidden);
  }
}

/// Of a box seen from a corner: the vertex that is the farthest away.
Index hidden_vertex(const test::SolidDrawing& box) {
  const auto depth = [&](const Vec3& vertex) { return box.camera.depth(vertex); };
  const auto& vertices = box.network.vertices;
  return static_cast<Index>(std::ranges::max_element(vertices, {}, depth) - vertices.begin());
}

TEST_CASE("the edges of a box that can't be seen are proposed: two by the first mirror, the third by another") {
  const test::SolidDrawing box = plain_drawing(test::box(), test::three_point_views()[1]);
  const Index hidden = hidden_vertex(box);
  const auto is_hidden = [&](const NetworkCurve& curve) { return curve.start == hidden || curve.end == hidden; };
  const Part part =
      part_of(test::box(), [&](const NetworkCurve& curve, const CurveNetwork&) { return !is_hidden(curve); });
  REQUIRE(part.missing.size() == 3);
  const auto proposal = propose_mirror(part.drawing, part.solved);
  REQUIRE(proposal);
  CHECK(proposal->strokes.size() == 2);
  PerspectiveDrawing completed = part.drawing;
  add_mirrored(completed, proposal->strokes);
  CHECK(vertices_of(completed).size() == 8);

  // The edge that crosses the mirror is its own image.
  const int axis = proposal->plane.axis;
  const Part later = part_of(test::box(), [&](const NetworkCurve& curve, const CurveNetwork& all) {
    const Vec3 step = all.vertices[curve.end] - all.vertices[curve.start];
    return !is_hidden(curve) || step[axis] == 0;
  });
  REQUIRE(later.missing.size() == 1);
  const auto next = propose_mirror(later.drawing, later.solved);
  REQUIRE(next);
  CHECK(next->plane.axis != axis);
  REQUIRE(next->strokes.size() == 1);
  CHECK(worst_miss(later, next->strokes) < 1.5);
}

TEST_CASE("nothing is proposed where nothing is missing") {
  for (const test::PerspectiveSolid& solid : {test::box(), test::bottle(), test::ring_frame()}) {
    const test::SolidDrawing truth = plain_drawing(solid, test::three_point_views()[1]);
    CHECK(!propose_mirror(truth.drawing, truth_of(truth)));
    const int axis = 0;
    const double middle = (extreme(solid.network, axis, false) + extreme(solid.network, axis, true)) / 2;
    CHECK(mirrored_strokes(truth.drawing, truth_of(truth), {axis, middle}).empty());
  }
}

}  // namespace
}  // namespace croquis

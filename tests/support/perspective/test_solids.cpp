// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <map>
#include <set>

#include <Eigen/Geometry>
#include <catch2/catch.hpp>

#include "support/perspective/solid_drawing.h"
#include "support/perspective/solids.h"
#include "support/perspective/views.h"

namespace croquis::test {
namespace {

Index start_of(const PerspectiveSolid& solid, const SolidSide& side) {
  const NetworkCurve& curve = solid.network.curves[side.curve];
  return side.reversed ? curve.end : curve.start;
}

Index end_of(const PerspectiveSolid& solid, const SolidSide& side) {
  return start_of(solid, {side.curve, !side.reversed});
}

/// Six times the volume under a loop, by cones over its curves; the apex cancels out for plane faces.
double volume_under(const PerspectiveSolid& solid, const SolidFace& face) {
  Vec3 apex = Vec3::Zero();
  for (const SolidSide& side : face.loops[0]) apex += solid.network.vertices[start_of(solid, side)];
  apex /= static_cast<double>(face.loops[0].size());
  double sum = 0;
  for (const auto& loop : face.loops) {
    for (const SolidSide& side : loop) {
      const NetworkCurve& curve = solid.network.curves[side.curve];
      for (const RationalCubic& piece : curve.pieces) {
        constexpr int steps = 200;
        for (int i = 0; i < steps; ++i) {
          const double part = apex.dot(piece.at(double(i) / steps).cross(piece.at(double(i + 1) / steps)));
          sum += side.reversed ? -part : part;
        }
      }
    }
  }
  return sum;
}

double volume_of(const PerspectiveSolid& solid) {
  double sum = 0;
  for (const SolidFace& face : solid.faces) sum += volume_under(solid, face);
  return sum / 6;
}

}  // namespace

TEST_CASE("perspective solids: faces close the solid") {
  for (const PerspectiveSolid& solid : all_solids()) {
    INFO(solid.name);
    std::set<std::pair<Index, bool>> used;
    for (const SolidFace& face : solid.faces) {
      for (const auto& loop : face.loops) {
        for (std::size_t i = 0; i < loop.size(); ++i) {
          CHECK(used.emplace(loop[i].curve, loop[i].reversed).second);
          CHECK(end_of(solid, loop[i]) == start_of(solid, loop[(i + 1) % loop.size()]));
        }
      }
    }
    const auto edges = static_cast<int>(solid.network.curves.size());
    const auto vertices = static_cast<int>(solid.network.vertices.size());
    const auto faces = static_cast<int>(solid.faces.size());
    CHECK(static_cast<int>(used.size()) == 2 * edges);
    CHECK(vertices - edges + faces - solid.rings() == 2 * (solid.shells - solid.genus));
    CHECK(volume_of(solid) > 0);
  }
}

TEST_CASE("perspective solids: volumes of those with plane faces are the ones of the formulas") {
  const auto near = [](double a, double b) { return std::abs(a - b) < 2e-3 * b; };
  CHECK(near(volume_of(box()), 24));
  CHECK(near(volume_of(l_block()), (2.5 * 1.2 + 1.1 * 1.8) * 2));
  CHECK(near(volume_of(wedge()), 4 * 1.6 * 2.6));
  CHECK(near(volume_of(pocket_box()), 24 - 2.2 * 1.3 * 0.9));
  CHECK(near(volume_of(ring_frame()), 12 - 2.2 * 1.4));
  CHECK(near(volume_of(mitred_frame()), 12 - 2.2 * 1.4));
}

TEST_CASE("perspective solids: bit-identical coordinates along the axis of a curve's group") {
  for (const PerspectiveSolid& solid : all_solids()) {
    INFO(solid.name);
    for (std::size_t i = 0; i < solid.network.curves.size(); ++i) {
      const NetworkCurve& curve = solid.network.curves[i];
      const int axis = axis_of(solid.groups[i]);
      REQUIRE(solid.groups[i] != StrokeGroup::Unknown);
      for (const RationalCubic& piece : curve.pieces) {
        for (const Vec3& point : piece.points) {
          for (int other = 0; other < 3; ++other) {
            const bool equal = is_parallel(solid.groups[i]) ? other != axis : other == axis;
            if (equal) CHECK(point[other] == solid.network.vertices[curve.start][other]);
          }
        }
      }
      CHECK(curve.pieces.front().points[0] == solid.network.vertices[curve.start]);
      CHECK(curve.pieces.back().points[3] == solid.network.vertices[curve.end]);
    }
  }
}

TEST_CASE("perspective solids: a clean drawing is exactly what the true curves look like") {
  for (const PerspectiveSolid& solid : all_solids()) {
    for (const View& view : all_views()) {
      INFO(solid.name << ", " << view.name);
      SolidDrawingOptions options;
      options.shuffled = false;
      const SolidDrawing truth = drawn(solid, view, options);
      std::map<std::string, const PerspectiveStroke*> strokes;
      for (const PerspectiveStroke& stroke : truth.drawing.strokes) strokes[stroke.id] = &stroke;
      CHECK(strokes.size() == solid.network.curves.size() + solid.links.size() + 9);
      for (const NetworkCurve& curve : truth.network.curves) {
        const PerspectiveStroke& stroke = *strokes.at(curve.id);
        REQUIRE(stroke.pieces.size() == curve.pieces.size());
        for (std::size_t piece = 0; piece < curve.pieces.size(); ++piece) {
          RationalCubic flat;
          for (std::size_t i = 0; i < 4; ++i) flat.points[i].head<2>() = stroke.pieces[piece][i];
          for (int i = 0; i <= 20; ++i) {
            const double t = i / 20.0;
            const Vec2 seen = truth.camera.project(curve.pieces[piece].at(t));
            if (curve.straight) {
              const Vec2 along = (stroke.end() - stroke.start()).normalized();
              CHECK(std::abs(cross(along, seen - stroke.start())) < 1e-9);
            } else {
              CHECK((seen - flat.at(t).head<2>()).norm() < 1e-9);
            }
          }
        }
      }
    }
  }
}

TEST_CASE("perspective solids: everything lies on the sheet, and no two vertices on one spot") {
  for (const PerspectiveSolid& solid : all_solids()) {
    for (const View& view : all_views()) {
      const SolidDrawing truth = drawn(solid, view);
      const auto& vertices = truth.network.vertices;
      for (std::size_t i = 0; i < vertices.size(); ++i) {
        const Vec2 place = truth.camera.project(vertices[i]) - truth.drawing.origin;
        INFO(solid.name << ", " << view.name << ", vertex " << i << " at " << place.transpose());
        CHECK(place.minCoeff() > 0);
        CHECK((truth.drawing.image_size - place).minCoeff() > 0);
        for (std::size_t j = 0; j < i; ++j) {
          INFO("and vertex " << j);
          CHECK((truth.camera.project(vertices[j]) - truth.drawing.origin - place).norm() > 6);
        }
      }
    }
  }
}

}  // namespace croquis::test

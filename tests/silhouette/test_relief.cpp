// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <atomic>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>

#include "algorithms/silhouette/solid_lines.h"
#include "croquis/base/error.h"
#include "silhouette/solids.h"
#include "silhouette/surface_quality.h"
#include "support/meshes/mesh_shapes.h"
#include "support/sketches/sketch_modifiers.h"

using namespace croquis;
using namespace croquis::silhouette;
using test::report_of;

namespace {

std::vector<Vec2> arc_points(const Vec2& centre, const Vec2& axes, double from, double to) {
  std::vector<Vec2> points;
  for (int i = 0; i <= 60; ++i) {
    const double angle = (from + (to - from) * i / 60) * std::numbers::pi / 180;
    points.emplace_back(centre + Vec2(axes.x() * std::cos(angle), axes.y() * std::sin(angle)));
  }
  return points;
}

Stroke stroke_of_kind(const std::string& id, const std::vector<Vec2>& points, const std::string& kind) {
  Stroke stroke = test::stroke_of(id, points);
  if (!kind.empty()) stroke.data["kind"] = kind;
  return stroke;
}

Stroke outline_of(const std::string& id, const Vec2& centre, const Vec2& axes, const std::string& kind = "") {
  std::vector<Vec2> points = arc_points(centre, axes, 0, 360);
  points.pop_back();
  Stroke stroke = stroke_of_kind(id, points, kind);
  stroke.closed = true;
  return stroke;
}

std::vector<std::pair<std::string, Drawing>> detailed_drawings() {
  Drawing face, ring, pair, fur;
  face.strokes = {outline_of("head", {0, 0}, {150, 150}),
                  stroke_of_kind("mouth", arc_points({0, 0}, {70, 70}, 200, 340), "detail"),
                  stroke_of_kind("nose", {{0, 30}, {5, 0}, {-10, -10}}, "detail")};
  ring.strokes = {outline_of("ring", {0, 0}, {200, 200}), outline_of("hole", {0, 0}, {90, 90}, "hole"),
                  stroke_of_kind("groove", arc_points({0, 0}, {145, 145}, 10, 300), "detail")};
  pair.strokes = {outline_of("body", {0, 0}, {200, 120}), outline_of("head", {-170, 80}, {90, 80}),
                  stroke_of_kind("fold", {{-60, -40}, {40, 10}, {120, -30}}, "detail"),
                  stroke_of_kind("brow", {{-210, 110}, {-170, 120}, {-130, 105}}, "detail")};
  std::vector<Vec2> curls;
  for (int i = 0; i < 120; ++i) curls.emplace_back(-60 + i + 18 * std::cos(0.55 * i), 18 * std::sin(0.55 * i));
  fur.strokes = {outline_of("sheep", {0, 0}, {200, 130}), stroke_of_kind("wool", curls, "scribble")};
  return {{"face", face}, {"ring", ring}, {"pair", pair}, {"fur", fur}};
}

Solid solid_of(const Drawing& drawing, DetailShape shape, Quality quality = Quality::Final) {
  Options options;
  options.details.shape = shape;
  options.quality = quality;
  return test::solid_of(drawing, options);
}

double volume_of(const Solid& solid) { return report_of(solid.mesh).volume.value(); }

Drawing mapped(Drawing drawing, const std::function<Vec2(const Vec2&)>& map) {
  for (Stroke& stroke : drawing.strokes) {
    for (StrokeSample& sample : stroke.samples) sample.position = map(sample.position);
  }
  return drawing;
}

/// A ball of radius 1 with lines on its front, and a drawing that has a stroke for each.
struct LinedBall {
  Solid solid;
  Drawing drawing;
};

/// @param segments of the ball, around
LinedBall lined_ball(const std::vector<std::vector<Vec2>>& lines, Index segments = 48) {
  LinedBall ball;
  ball.solid.mesh = test::rotated(test::triangulated(test::uv_sphere(segments, segments / 2)), 1, {1, 2, 3});
  const std::size_t faces = ball.solid.mesh.face_count();
  ball.solid.mesh.channels.push_back({"object", Domain::Face, 1, std::vector<std::int32_t>(faces, 0), {"ball"}});
  std::vector<DrawnLine> drawn;
  for (const std::vector<Vec2>& line : lines) {
    drawn.push_back({static_cast<Index>(drawn.size()), line, false});
    ball.drawing.strokes.push_back(test::stroke_of("line-" + std::to_string(drawn.size()), line));
  }
  ball.solid.lines = surface_lines(drawn, ball.solid.mesh, 0.02);
  return ball;
}

/// @param width of the lines, of a ball of radius 1
Solid carved(LinedBall ball, DetailShape shape, double width) {
  Progress progress;
  carve_lines(ball.drawing, {shape, 1000 * width}, 0.001, ball.solid, progress);
  return std::move(ball.solid);
}

}  // namespace

TEST_CASE("edges that are cut leave no gap, and parts of faces carry what the faces did") {
  PolyMesh mesh = test::triangulated(test::uv_sphere(12, 6));
  const MeshReport before = report_of(mesh);
  std::vector<std::int32_t> numbers;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) numbers.push_back(static_cast<std::int32_t>(f));
  mesh.channels.push_back({"group", Domain::Face, 1, numbers, {}});
  const PolyMesh whole = mesh;
  const auto is_cut = [](Index, const Vec3& a, const Vec3& b) { return (a + b).x() > 0.3 * (a + b).y(); };
  REQUIRE(cut_edges(mesh, is_cut));
  const MeshReport after = report_of(mesh);
  test::check_sound(mesh);
  CHECK(after.euler_characteristic == before.euler_characteristic);
  CHECK(*after.volume == Approx(*before.volume));
  CHECK(after.area == Approx(before.area));
  CHECK(mesh.face_count() > whole.face_count());
  CHECK(validate(mesh).empty());
  const auto& origin = std::get<std::vector<std::int32_t>>(mesh.channels.front().data);
  CHECK(std::ranges::is_sorted(origin));
  std::vector<double> area(whole.face_count(), 0);
  const auto area_of = [](const PolyMesh& of, Index f) {
    const Vec3 &a = of.positions[of.face(f)[0]], &b = of.positions[of.face(f)[1]], &c = of.positions[of.face(f)[2]];
    return (b - a).cross(c - a).norm() / 2;
  };
  for (Index f = 0; f < mesh.face_count(); ++f) area[static_cast<std::size_t>(origin[f])] += area_of(mesh, f);
  for (Index f = 0; f < whole.face_count(); ++f) CHECK(area[f] == Approx(area_of(whole, f)));
  CHECK_FALSE(cut_edges(mesh, [](Index, const Vec3&, const Vec3&) { return false; }));
}

TEST_CASE("details as grooves and ridges leave a solid sound and its outline as drawn") {
  for (const auto& [name, drawing] : detailed_drawings()) {
    INFO(name);
    const Solid plain = solid_of(drawing, DetailShape::Line);
    REQUIRE(!plain.lines.empty());
    CHECK(!plain.carved);
    const double diagonal = test::diagonal(drawing);
    for (const DetailShape shape : {DetailShape::Groove, DetailShape::Ridge}) {
      const Solid solid = solid_of(drawing, shape);
      const MeshReport before = report_of(plain.mesh), after = report_of(solid.mesh);
      test::check_sound(solid.mesh);
      CHECK(solid.carved == plain.lines.size());
      CHECK(solid.lines.empty());
      CHECK(solid.used == plain.used);
      CHECK(after.euler_characteristic == before.euler_characteristic);
      CHECK(after.components == before.components);
      CHECK((shape == DetailShape::Ridge) == (*after.volume > *before.volume));
      CHECK(*after.volume != *before.volume);
      CHECK(validate(solid.mesh).empty());
      REQUIRE(solid.mesh.vertex_count() > plain.mesh.vertex_count());
      // What was there before keeps its place in the drawing; what doesn't face the viewer, its place in space.
      double aside = 0;
      for (std::size_t v = 0; v < plain.mesh.vertex_count(); ++v) {
        aside = std::max(aside, (solid.mesh.positions[v] - plain.mesh.positions[v]).head<2>().norm());
      }
      CHECK(aside <= 1e-9 * diagonal);
      double moved = 0;
      for (Index f = 0; f < plain.mesh.face_count(); ++f) {
        const auto at = [&](std::size_t corner) {
          return Vec2(plain.mesh.positions[plain.mesh.face(f)[corner]].head<2>());
        };
        if (cross(at(1) - at(0), at(2) - at(0)) > 0) continue;
        for (const Index v : plain.mesh.face(f)) {
          moved = std::max(moved, (solid.mesh.positions[v] - plain.mesh.positions[v]).norm());
        }
      }
      CHECK(moved <= 1e-9 * diagonal);
    }
  }
}

TEST_CASE("drafts get grooves too") {
  for (const auto& [name, drawing] : detailed_drawings()) {
    INFO(name);
    const double plain = volume_of(solid_of(drawing, DetailShape::Line, Quality::Draft));
    CHECK(volume_of(solid_of(drawing, DetailShape::Groove, Quality::Draft)) < plain);
  }
}

TEST_CASE("grooves scale with the drawing and are mirrored with it") {
  const Drawing drawing = detailed_drawings().front().second;
  const auto cut_away = [](const Drawing& drawn) {
    return volume_of(solid_of(drawn, DetailShape::Line)) - volume_of(solid_of(drawn, DetailShape::Groove));
  };
  const double as_drawn = cut_away(drawing);
  CHECK(cut_away(mapped(drawing, [](const Vec2& p) { return Vec2(4 * p); })) == Approx(64 * as_drawn).epsilon(0.05));
  CHECK(cut_away(mapped(drawing, [](const Vec2& p) { return Vec2(-p.x(), p.y()); })) == Approx(as_drawn).epsilon(0.05));
}

TEST_CASE("without grooves and ridges their width changes nothing") {
  const Drawing drawing = detailed_drawings().front().second;
  Options wide;
  wide.details.width = 30;
  const Solid solid = test::solid_of(drawing, wide);
  const Solid plain = solid_of(drawing, DetailShape::Line);
  CHECK(solid.mesh.positions == plain.mesh.positions);
  CHECK(solid.mesh.corners == plain.mesh.corners);
  CHECK(solid.lines.size() == plain.lines.size());
}

TEST_CASE("along its middle a line on a ball is a quarter of its width deep") {
  const LinedBall ball = lined_ball({{{-0.5, 0.05}, {0.5, 0.1}}}, 96);
  for (const double width : {0.04, 0.1, 0.25}) {
    for (const auto& [shape, sign] : {std::pair(DetailShape::Groove, -1.0), std::pair(DetailShape::Ridge, 1.0)}) {
      INFO(width << " " << sign);
      const Solid solid = carved(ball, shape, width);
      REQUIRE(solid.carved == std::size_t{1});
      for (double x = -0.4; x < 0.4; x += 0.037) {
        const Vec2 place(x, 0.075 + 0.05 * x);
        const double before = test::vertical_hits(ball.solid.mesh, place).back();
        const double after = test::vertical_hits(solid.mesh, place).back();
        CHECK(sign * (after - before) * before == Approx(width / 4).epsilon(0.2));  // along the normal
        const Vec2 beside = place + Vec2(0, 0.75 * width);
        CHECK(test::vertical_hits(solid.mesh, beside).back() ==
              Approx(test::vertical_hits(ball.solid.mesh, beside).back()).margin(0.01 * width));
      }
    }
  }
}

TEST_CASE("a groove takes no more than a quarter of what is solid behind it") {
  LinedBall disk = lined_ball({});
  for (Vec3& position : disk.solid.mesh.positions) position.z() *= 0.02;
  disk.drawing.strokes.push_back(test::stroke_of("line", {{-0.5, 0}, {0.5, 0}}));
  disk.solid.lines = surface_lines({{0, {{-0.5, 0}, {0.5, 0}}, false}}, disk.solid.mesh, 0.02);
  const Solid solid = carved(disk, DetailShape::Groove, 0.2);
  REQUIRE(solid.carved == std::size_t{1});
  const std::vector<double> before = test::vertical_hits(disk.solid.mesh, {0.1, 0.003});
  const std::vector<double> after = test::vertical_hits(solid.mesh, {0.1, 0.003});
  CHECK(after.back() < before.back());
  CHECK(after.back() - after.front() >= 0.74 * (before.back() - before.front()));
  CHECK(report_of(solid.mesh).self_intersections == std::size_t{0});
}

TEST_CASE("a line where the surface turns away stays a line and is named") {
  const Solid solid = carved(lined_ball({{{-0.3, 0}, {0.3, 0}}, arc_points({0, 0}, {0.995, 0.995}, 80, 100)}, 160),
                             DetailShape::Groove, 0.02);
  CHECK(solid.carved == std::size_t{1});
  REQUIRE(!solid.lines.empty());
  for (const SurfaceLine& line : solid.lines) CHECK(line.stroke == 1);
  REQUIRE(solid.findings.size() == 1);
  CHECK(solid.findings.front().code == "W_LEFT_OUT");
  REQUIRE(solid.findings.front().subjects.size() == 1);
  CHECK(solid.findings.front().subjects.front().id == "line-2");
}

TEST_CASE("a ball without lines stays as it is, and a raised flag stops the work") {
  const LinedBall bare = lined_ball({});
  const Solid solid = carved(bare, DetailShape::Ridge, 0.1);
  CHECK(solid.carved == std::size_t{0});
  CHECK(solid.mesh.positions == bare.solid.mesh.positions);

  LinedBall ball = lined_ball({{{-0.5, 0}, {0.5, 0}}});
  const std::atomic<bool> cancel{true};
  Progress stopped({}, &cancel);
  const DetailOptions grooves{DetailShape::Groove, 20};
  CHECK_THROWS_AS(carve_lines(ball.drawing, grooves, 0.001, ball.solid, stopped), Cancelled);
}

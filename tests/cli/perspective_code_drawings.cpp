// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/perspective_code_drawings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "croquis/io/perspective_drawing_file.h"
#include "support/perspective/solid_builder.h"
#include "support/perspective/solid_drawing.h"

namespace croquis::test {
namespace {

using Names = std::set<std::string>;

SolidDrawing clean(const PerspectiveSolid& solid) { return drawn(solid, three_point_views()[1]); }

PerspectiveStroke& stroke_of(PerspectiveDrawing& drawing, const std::string& id) {
  return *std::ranges::find(drawing.strokes, id, &PerspectiveStroke::id);
}

/// Adds an edge through places of the picture: two of a line, four of a cubic.
void add_edge(PerspectiveDrawing& drawing, const std::string& id, StrokeGroup group, const std::vector<Vec2>& places,
              const std::array<std::string, 2>& ends) {
  PerspectiveStroke stroke;
  stroke.id = id;
  stroke.group = group;
  stroke.straight = places.size() == 2;
  const Vec2 &a = places.front(), &b = places.back();
  stroke.pieces = {
      {a, stroke.straight ? Vec2(a + (b - a) / 3) : places[1], stroke.straight ? Vec2(b - (b - a) / 3) : places[2], b}};
  stroke.from = ends[0];
  stroke.to = ends[1];
  drawing.strokes.push_back(std::move(stroke));
}

std::string svg_of(const PerspectiveDrawing& drawing) { return write_perspective_svg(drawing); }

template <class Change>
std::string changed(SolidDrawing truth, const Change& change) {
  change(truth.drawing);
  return svg_of(truth.drawing);
}

/// Construction lines towards three points.
std::string lines_towards(const std::array<Vec2, 3>& points) {
  PerspectiveDrawing drawing;
  drawing.image_size = Vec2(1000, 750);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (int i = 0; i < 4; ++i) {
      const Vec2 a(150 + 180.0 * i, 120 + 130.0 * ((i + static_cast<int>(axis)) % 4));
      add_edge(drawing, std::string(1, "xyz"[axis]) + std::to_string(i), static_cast<StrokeGroup>(axis),
               {a, a + 180 * (points[axis] - a).normalized()}, {});
      drawing.strokes.back().role = StrokeRole::Construction;
    }
  }
  return svg_of(drawing);
}

/// A level view just above the top of a box, which is seen as a line; from the top a corner sticks out that nothing
/// but its plane ties.
std::string seen_from_its_edge() {
  View view = three_point_views()[1];
  view.elevation = 0.004;
  view.placement = {0, 0.2};
  view.fill = 0.5;
  SolidDrawing truth = drawn(box(), view);
  Camera& camera = truth.camera;
  camera.eye.z() = 2.01;
  PerspectiveDrawing& drawing = truth.drawing;
  for (PerspectiveStroke& stroke : drawing.strokes) {
    if (stroke.role != StrokeRole::Edge) continue;
    const auto place = [&](const std::string& name) {
      return camera.project(box().network.vertices[std::stoul(name.substr(1))]);
    };
    const Vec2 a = place(stroke.from), b = place(stroke.to);
    stroke.pieces = {{a, a + (b - a) / 3, b - (b - a) / 3, b}};
  }
  drawing.known_point->at = camera.project(drawing.known_point->point);
  const Vec2 tip = camera.project({5.5, 1.2, 2});
  const auto at = [&](double x, double y) { return camera.project({x, y, 2}); };
  add_edge(drawing, "tip1", StrokeGroup::NormalZ, {at(4, 0), at(4.6, 0.1), at(5.2, 0.5), tip}, {"v5", "tip"});
  add_edge(drawing, "tip2", StrokeGroup::NormalZ, {at(4, 3), at(4.6, 2.9), at(5.2, 2.4), tip}, {"v6", "tip"});
  return svg_of(drawing);
}

/// Four sheets along one edge: any two neighbours may be a part of the solid's boundary.
PerspectiveSolid four_sheets() {
  SolidBuilder b("sheets");
  const Index low = b.vertex(0, 0, 0), high = b.vertex(0, 0, 2);
  b.line(low, high);
  for (const Vec2& out : {Vec2(2, 0), Vec2(-2, 0), Vec2(0, 2), Vec2(0, -2)}) {
    const Index l = b.vertex(out.x(), out.y(), 0), h = b.vertex(out.x(), out.y(), 2);
    b.line(low, l);
    b.line(high, h);
    b.line(l, h);
  }
  return b.take();
}

/// A flat tent on a round base: four straight ridges that nearly go on into each other, and can't turn.
PerspectiveSolid tent() {
  SolidBuilder b("tent");
  const Index top = b.vertex(0, 0, 0.24);
  const std::array<Vec2, 4> feet{Vec2(2, 0), Vec2(0, 2), Vec2(-2, 0), Vec2(0, -2)};
  std::vector<Index> ring;
  for (const Vec2& foot : feet) ring.push_back(b.vertex(foot.x(), foot.y(), 0));
  for (const Index foot : ring) b.line(top, foot);
  for (std::size_t i = 0; i < 4; ++i) {
    const auto [first, second, end] = quarter(Vec2::Zero(), feet[i], feet[(i + 1) % 4]);
    b.curve(ring[i], ring[(i + 1) % 4], {first.x(), first.y(), 0}, {second.x(), second.y(), 0});
  }
  return b.take();
}

/// A prism over the outline whose top edges are arched: its top is one smooth face.
PerspectiveSolid arched(const std::vector<Vec2>& outline, double height) {
  SolidBuilder b("arched");
  std::vector<Index> low, high;
  for (const Vec2& p : outline) low.push_back(b.vertex(p.x(), p.y(), 0));
  for (const Vec2& p : outline) high.push_back(b.vertex(p.x(), p.y(), 1));
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const std::size_t next = (i + 1) % outline.size();
    const Vec2 step = outline[next] - outline[i];
    const double up = 1 + height * step.norm();
    const Vec2 a = outline[i] + step / 3, c = outline[next] - step / 3;
    b.line(low[i], low[next]);
    b.line(low[i], high[i]);
    b.curve(high[i], high[next], {a.x(), a.y(), up}, {c.x(), c.y(), up});
  }
  return b.take();
}

/// With a box whose faces are found at once.
std::string box_beside(SolidDrawing truth) {
  for (Index i = 0; i < 8; ++i) {
    for (int k = 0; k < 3; ++k) {
      const Index bit = 1U << k;
      if (i & bit) continue;
      const auto place = [&](Index corner) {
        return truth.camera.project(Vec3(6 + (corner & 1), (corner >> 1) & 1, (corner >> 2) & 1));
      };
      add_edge(truth.drawing, "b" + std::to_string(8 * k) + std::to_string(i), static_cast<StrokeGroup>(k),
               {place(i), place(i | bit)}, {"b" + std::to_string(i), "b" + std::to_string(i | bit)});
    }
  }
  return svg_of(truth.drawing);
}

/// A box that is 3 px high, without names of corners.
std::string flat_box() {
  SolidBuilder b("flat");
  b.prism({rectangle({0, 0}, {4, 3}), 2, 0, 0.02});
  SolidDrawingOptions plain;
  plain.vertex_ids = false;
  return svg_of(drawn(b.take(), three_point_views()[1], plain).drawing);
}

void add_stroke_codes(std::vector<CodeDrawing>& list) {
  const SolidDrawing truth = clean(box());
  list.push_back(
      {"UNKNOWN_GROUP", changed(truth, [](auto& d) { stroke_of(d, "e03").group = StrokeGroup::Unknown; }), {"e03"}});
  list.push_back(
      {"NOT_FINITE", changed(truth, [](auto& d) { stroke_of(d, "e03").pieces[0][3].x() = std::nan(""); }), {"e03"}});
  list.push_back({"ZERO_LENGTH",
                  changed(truth,
                          [](auto& d) {
                            add_edge(d, "dot", StrokeGroup::ParallelX, {{500, 300}, {500, 300}}, {});
                          }),
                  {"dot"}});
  list.push_back({"DUPLICATE_STROKE",
                  changed(truth,
                          [](auto& d) {
                            d.strokes.push_back(stroke_of(d, "e03"));
                            d.strokes.back().id = "again";
                          }),
                  {"again", "e03"}});
  list.push_back({"STROKE_IGNORED", svg_of(truth.drawing), {"e03"}, 1, 0, {"--ignore", "e03"}});
  list.push_back({"LENGTH_UNUSED", changed(truth, [](auto& d) { d.known_lengths = {{"c0", 3}}; }), {"c0"}});
  list.push_back({"GROUP_COLOUR", changed(truth, [](auto& d) { stroke_of(d, "e03").colour = "#D81F2A"; }), {"e03"}});
  list.push_back({"SHORT_STROKE", flat_box(), {"e08", "e09", "e10", "e11"}});
  std::string twice = svg_of(truth.drawing);
  twice.replace(twice.find("id=\"e03\""), 8, "id=\"e04\"");
  list.push_back({"W_DUPLICATE_ID", twice, {"e04-2"}});
  std::string heavy = svg_of(truth.drawing);
  heavy.insert(heavy.find("id=\"e03\""), "cq:weight=\"heavy\" ");
  list.push_back({"W_VALUE", heavy, {"e03"}});
}

void add_camera_codes(std::vector<CodeDrawing>& list) {
  const SolidDrawing truth = clean(box());
  const auto is_along = [](StrokeGroup group) { return [=](const PerspectiveStroke& s) { return s.group == group; }; };
  list.push_back({"VP_INSUFFICIENT",
                  changed(truth, [&](auto& d) { std::erase_if(d.strokes, is_along(StrokeGroup::ParallelZ)); }),
                  {}});
  list.push_back({"VP_INSUFFICIENT",
                  changed(truth,
                          [&](auto& d) {
                            std::erase_if(d.strokes, is_along(StrokeGroup::ParallelZ));
                            std::erase_if(d.strokes, is_along(StrokeGroup::ParallelX));
                          }),
                  {},
                  1,
                  4});
  list.push_back({"ALL_PARALLEL", lines_towards({Vec2(1e9, 4e8), Vec2(-1e9, 5e8), Vec2(1e7, -1e9)}), {}, 1, 4});
  list.push_back(
      {"EYE_NONE", lines_towards({Vec2(-1500, 300), Vec2(2500, 300), Vec2(500, 900)}), {"z0", "z1", "z2", "z3"}, 1, 4});
  list.push_back({"VP_OUTLIER",
                  changed(truth,
                          [](auto& d) {
                            for (Vec2& point : stroke_of(d, "c0").pieces[0]) {
                              const Vec2 off = point - stroke_of(d, "c0").start();
                              point += 0.2 * Vec2(-off.y(), off.x());
                            }
                          }),
                  {"c0"}});
  list.push_back({"FOCAL_ASSUMED", svg_of(drawn(box(), frontal_view()).drawing), {}});
  View far = three_point_views()[0];
  far.fill = 0.45;
  far.field_of_view = 8 * std::numbers::pi / 180;
  SolidDrawingOptions rough;
  rough.noise = 2;
  rough.construction_lines = 0;
  rough.seed = 4;
  const SolidDrawing weak = drawn(box(), far, rough);
  list.push_back({"VP_WEAK", svg_of(weak.drawing), {"e00", "e02", "e04", "e06"}, 1, 0, {"--mode", "3"}});
}

void add_coordinate_codes(std::vector<CodeDrawing>& list) {
  const SolidDrawing truth = clean(box());
  const Camera& camera = truth.camera;
  list.push_back({"DISCONNECTED",
                  changed(truth,
                          [&](auto& d) {
                            const std::array<Vec3, 4> corners{Vec3(0, 0, 3), {2, 0, 3}, {2, 1, 3}, {0, 1, 3}};
                            for (std::size_t i = 0; i < 4; ++i) {
                              add_edge(d, "s" + std::to_string(i), static_cast<StrokeGroup>(i % 2),
                                       {camera.project(corners[i]), camera.project(corners[(i + 1) % 4])}, {});
                            }
                          }),
                  {"s0", "s1", "s2", "s3"}});
  list.push_back({"CONTRADICTION",
                  changed(clean(l_block()),
                          [](auto& d) {
                            PerspectiveStroke& wrong = stroke_of(d, "e07");
                            wrong.group =
                                wrong.group == StrokeGroup::ParallelX ? StrokeGroup::ParallelY : StrokeGroup::ParallelX;
                          }),
                  {"e07"}});
  list.push_back({"GRAZING", seen_from_its_edge(), {"tip1", "tip2"}});
  const Vec2 ground = camera.project({4, 0, 0});
  list.push_back({"NOT_IN_FRONT",
                  changed(truth,
                          [&](auto& d) {
                            add_edge(d, "up", StrokeGroup::NormalZ, {ground, Vec2(640, -700)}, {"v1", "far"});
                          }),
                  {"up"}});
  const Vec2 other = camera.project({4, 3, 0});
  list.push_back({"CURVE_BEHIND_HORIZON",
                  changed(truth,
                          [&](auto& d) {
                            add_edge(d, "arc", StrokeGroup::NormalZ,
                                     {ground, ground + Vec2(300, -2500), other + Vec2(300, -2500), other},
                                     {"v1", "v2"});
                          }),
                  {"arc"}});
}

void add_face_codes(std::vector<CodeDrawing>& list) {
  const SolidDrawing truth = clean(box());
  const Camera& camera = truth.camera;
  const Vec2 top = camera.project({0, 0, 2}), tip = camera.project({0, 0, 3});
  list.push_back({"DANGLING",
                  changed(truth,
                          [&](auto& d) {
                            add_edge(d, "antenna", StrokeGroup::ParallelZ, {top, tip}, {"v4", "tip"});
                          }),
                  {"antenna"}});
  list.push_back({"DANGLING",
                  changed(truth,
                          [&](auto& d) {  // with a corner: two edges of one stroke
                            add_edge(d, "bent", StrokeGroup::NormalX, {top, tip}, {"v4", "tip"});
                            const Vec2 end = camera.project({0, 1.2, 3.4});
                            d.strokes.back().straight = false;
                            d.strokes.back().pieces.push_back({tip, tip + (end - tip) / 3, end - (end - tip) / 3, end});
                          }),
                  {"bent"},
                  2});
  const Vec2 side = camera.project({4, 0, 2}), corner = camera.project({4, 0, 3});
  list.push_back({"NOT_CLOSED",
                  changed(truth,
                          [&](auto& d) {
                            add_edge(d, "s0", StrokeGroup::ParallelZ, {top, tip}, {"v4", "s"});
                            add_edge(d, "s1", StrokeGroup::ParallelX, {tip, corner}, {"s", "t"});
                            add_edge(d, "s2", StrokeGroup::ParallelZ, {corner, side}, {"t", "v5"});
                          }),
                  {"e04", "s0", "s1", "s2"}});
  list.push_back({"NONPLANAR_STRAIGHT_FACE",
                  changed(truth,
                          [](auto& d) {
                            std::erase_if(d.strokes, [](const PerspectiveStroke& s) { return s.id == "e00"; });
                            d.known_lengths.clear();
                          }),
                  {"e01", "e02", "e03", "e04", "e08", "e09"}});
  list.push_back(
      {"MISSING_STROKE",
       changed(clean(soap()),
               [](auto& d) { std::erase_if(d.strokes, [](const PerspectiveStroke& s) { return s.id == "e08"; }); }),
       {"e04", "e09", "e05", "e11"},
       2});
  Names sheets;
  for (const NetworkCurve& curve : four_sheets().network.curves) sheets.insert(curve.id);
  list.push_back({"AMBIGUOUS", svg_of(clean(four_sheets()).drawing), sheets});
  list.push_back({"SEARCH_LIMIT", box_beside(clean(camera_ring())), {}, 1, 0, {"--search-limit", "200"}});
  list.push_back({"SMOOTH_DROPPED", svg_of(clean(tent()).drawing), {"e00", "e01", "e02", "e03"}, 4});
  // An edge of the top bends across the opposite one.
  const Camera seen = clean(box()).camera;
  list.push_back({"PATCH_FOLDED",
                  changed(clean(box()),
                          [&](auto& d) {
                            PerspectiveStroke& edge = stroke_of(d, "e04");
                            edge.group = StrokeGroup::NormalZ;
                            edge.straight = false;
                            edge.pieces = {{edge.pieces[0].front(), seen.project({1, 5, 2}), seen.project({3, 5, 2}),
                                            edge.pieces[0].back()}};
                            d.known_lengths.clear();
                          }),
                  {"e04", "e05", "e06", "e07"}});
}

}  // namespace

std::vector<std::string> folding_drawings() {
  const std::vector<PerspectiveSolid> solids = {
      arched({{0, 0}, {4, 0}, {4, 3}, {3.2, 3}, {3.2, 0.8}, {0.8, 0.8}, {0.8, 3}, {0, 3}}, 0.06),
      arched({{0, 0}, {5, 0}, {5, 2}, {4, 2}, {4, 1}, {1, 1}, {1, 3}, {0, 3}}, 0.04),
      arched({{0, 0}, {3, 0}, {3, 2}, {5, 2}, {5, 3}, {2, 3}, {2, 1}, {0, 1}}, 0.05)};
  std::vector<std::string> drawings;
  for (const PerspectiveSolid& solid : solids) drawings.push_back(svg_of(clean(solid).drawing));
  return drawings;
}

std::vector<CodeDrawing> code_drawings() {
  std::vector<CodeDrawing> list;
  add_stroke_codes(list);
  add_camera_codes(list);
  add_coordinate_codes(list);
  add_face_codes(list);
  return list;
}

}  // namespace croquis::test

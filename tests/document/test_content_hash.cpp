// SPDX-License-Identifier: GPL-3.0-or-later
#include <cinttypes>
#include <cstdio>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "croquis/document/backdrop.h"
#include "croquis/document/content_hash.h"
#include "croquis/document/document.h"
#include "support/meshes/mesh_shapes.h"
#include "support/trial_operation.h"

namespace croquis {
namespace {

Drawing small_drawing() {
  Drawing drawing;
  Stroke stroke;
  stroke.id = "outline";
  stroke.samples = {{Vec2(1, 2), 0.5, Vec2(0.1, 0.2), 0}, {Vec2(3, 4), 0.75, Vec2(0.3, 0.4), 0.25}};
  stroke.object = "body";
  stroke.data = {{"kind", "hidden"}};
  stroke.line = 12;
  drawing.strokes = {stroke};
  drawing.object_data = {{"body", {{"weight-curvature", "0.5"}}}};
  drawing.file = "cat.svg";
  return drawing;
}

PolyMesh small_mesh() {
  PolyMesh mesh = test::tetrahedron();
  mesh.add_line(std::vector<Index>{0, 1, 2});
  mesh.channels.push_back({"group", Domain::Face, 1, std::vector<std::int32_t>{0, 1, 0, 1}, {"left", "right"}});
  mesh.channels.push_back({"uv", Domain::Vertex, 2, std::vector<float>(8, 0.5F), {}});
  return mesh;
}

Report small_report() {
  Report report = Report::object();
  report.set("count", 3).set("ratio", 0.5).set("name", "cat").set("sizes", Report::list(std::vector<int>{1, 2}));
  return report;
}

Node small_node() {
  Node node = test::operation_node("scale", {1, "value"}, 3, "bigger");
  node.id = 5;
  return node;
}

template <class T>
using Changes = std::vector<std::function<void(T&)>>;

/// Every change gives a hash of its own, and the unchanged copy the same one.
template <class T, class Hash>
void check_changes(const std::function<T()>& make, const Changes<T>& changes, const Hash& hash) {
  std::set<ContentHash> seen = {hash(make())};
  CHECK(seen.contains(hash(make())));
  for (std::size_t i = 0; i < changes.size(); ++i) {
    T changed = make();
    changes[i](changed);
    INFO("change " << i);
    CHECK(seen.insert(hash(changed)).second);
  }
}

template <class T>
ContentHash hash_of_value(const T& content) {
  return content_hash(Value(std::make_shared<const T>(content)));
}

std::string hex(const ContentHash& hash) {
  char text[33];
  std::snprintf(text, sizeof text, "%016" PRIx64 "%016" PRIx64, hash.high, hash.low);
  return text;
}

TEST_CASE("hashing is XXH3 of 128 bits, the same on every machine") {
  // The library's own figure for no bytes at all and seed 0.
  CHECK(hex(ContentHasher().digest()) == "99aa06d3014798d86001c324468d497f");
  // Recorded: a change would make every kept fingerprint worthless.
  CHECK(hex(hash_of_value(small_drawing())) == "3c4a9f4d2d9eaf83334d6c608b2acf38");
  CHECK(hex(hash_of_value(small_mesh())) == "3731496754425a947a6d97d1765181f0");
  CHECK(hex(hash_of_value(small_report())) == "91692800fe1e8af34c96fa77f00ab2ca");
}

TEST_CASE("every field of a drawing counts in its hash") {
  const Changes<Drawing> changes = {[](Drawing& d) { d.strokes[0].samples[1].position.x() = 3.0000000000000004; },
                                    [](Drawing& d) { d.strokes[0].samples[1].position.y() = 5; },
                                    [](Drawing& d) { d.strokes[0].samples[0].pressure = 0.25; },
                                    [](Drawing& d) { d.strokes[0].samples[0].tilt.x() = 0; },
                                    [](Drawing& d) { d.strokes[0].samples[0].tilt.y() = 0; },
                                    [](Drawing& d) { d.strokes[0].samples[1].time = 0.5; },
                                    [](Drawing& d) { d.strokes[0].samples.pop_back(); },
                                    [](Drawing& d) { d.strokes[0].samples[0].time = -0.0; },
                                    [](Drawing& d) { d.strokes[0].id = "outlin"; },
                                    [](Drawing& d) { d.strokes[0].closed = true; },
                                    [](Drawing& d) { d.strokes[0].object = "tail"; },
                                    [](Drawing& d) { d.strokes[0].data["kind"] = "tube"; },
                                    [](Drawing& d) { d.strokes[0].data["radius"] = "1"; },
                                    [](Drawing& d) { d.strokes[0].line = 13; },
                                    [](Drawing& d) { d.strokes[0].line.reset(); },
                                    [](Drawing& d) { d.strokes[0].line = 0; },
                                    [](Drawing& d) { d.strokes.push_back(d.strokes[0]); },
                                    [](Drawing& d) { d.strokes.clear(); },
                                    [](Drawing& d) { d.object_data["body"]["weight-curvature"] = "0.6"; },
                                    [](Drawing& d) { d.object_data["tail"] = {}; },
                                    [](Drawing& d) { d.file = "dog.svg"; },
                                    [](Drawing& d) { d.plane.origin.z() = 1; },
                                    [](Drawing& d) { d.plane.u = Vec3::UnitZ(); },
                                    [](Drawing& d) { d.plane.v = Vec3::UnitZ(); }};
  check_changes<Drawing>(small_drawing, changes, hash_of_value<Drawing>);
}

TEST_CASE("every field of a mesh counts in its hash") {
  const Changes<PolyMesh> changes = {
      [](PolyMesh& m) { m.positions[3].z() = 2; },
      [](PolyMesh& m) { m.positions[0].x() = -0.0; },
      [](PolyMesh& m) { m.positions.emplace_back(0, 0, 0); },
      [](PolyMesh& m) { std::swap(m.corners[0], m.corners[1]); },
      [](PolyMesh& m) { m.add_triangle(0, 1, 2); },
      [](PolyMesh& m) { m.face_offsets[1] = 4; },
      [](PolyMesh& m) { m.line_vertices[2] = 3; },
      [](PolyMesh& m) { m.line_offsets.push_back(3); },
      [](PolyMesh& m) { m.channels[0].name = "object"; },
      [](PolyMesh& m) { m.channels[0].domain = Domain::Vertex; },
      [](PolyMesh& m) { m.channels[0].domain = Domain::Edge; },
      [](PolyMesh& m) { m.channels[1].width = 1; },
      [](PolyMesh& m) { m.channels[0].labels[1] = "up"; },
      [](PolyMesh& m) { std::get<std::vector<std::int32_t>>(m.channels[0].data)[3] = 0; },
      [](PolyMesh& m) { std::get<std::vector<float>>(m.channels[1].data)[7] = 0.25F; },
      [](PolyMesh& m) {
        m.channels[0].data = std::vector<std::uint32_t>{0, 1, 0, 1};
      },
      [](PolyMesh& m) { m.channels.pop_back(); },
      [](PolyMesh& m) { std::swap(m.channels[0], m.channels[1]); }};
  check_changes<PolyMesh>(small_mesh, changes, hash_of_value<PolyMesh>);
}

PolyMesh tagged_mesh() {
  PolyMesh mesh = small_mesh();
  mesh.tags = {{{{0, 1}, infinite_sharpness}, {{1, 2}, 2.5}}, {3}, {{"rim", 2.5, {{1, 2}}, {3}}}};
  return mesh;
}

TEST_CASE("every field of a mesh's tags counts in its hash") {
  const Changes<PolyMesh> changes = {[](PolyMesh& m) { m.tags = {}; },
                                     [](PolyMesh& m) { m.tags.creases[1].sharpness = 2.25; },
                                     [](PolyMesh& m) { m.tags.creases[0].sharpness = greatest_sharpness; },
                                     [](PolyMesh& m) {
                                       m.tags.creases[0].vertices = {1, 0};
                                     },
                                     [](PolyMesh& m) { m.tags.creases[0].vertices[1] = 2; },
                                     [](PolyMesh& m) { m.tags.creases.pop_back(); },
                                     [](PolyMesh& m) { std::swap(m.tags.creases[0], m.tags.creases[1]); },
                                     [](PolyMesh& m) { m.tags.pins = {2}; },
                                     [](PolyMesh& m) {
                                       m.tags.pins = {3, 3};
                                     },
                                     [](PolyMesh& m) { m.tags.pins.clear(); },
                                     [](PolyMesh& m) { m.tags.sets[0].name = "lip"; },
                                     [](PolyMesh& m) { m.tags.sets[0].sharpness = 3; },
                                     [](PolyMesh& m) {
                                       m.tags.sets[0].edges = {{0, 1}};
                                     },
                                     [](PolyMesh& m) {
                                       m.tags.sets[0].edges.push_back({0, 1});
                                     },
                                     [](PolyMesh& m) { m.tags.sets[0].pins.clear(); },
                                     [](PolyMesh& m) { m.tags.sets.push_back({}); }};
  check_changes<PolyMesh>(tagged_mesh, changes, hash_of_value<PolyMesh>);
  CHECK(hash_of_value(PolyMesh(tagged_mesh())) != hash_of_value(small_mesh()));
}

Camera small_camera() {
  Camera camera;
  camera.focal_length = 1072;
  camera.principal_point = {500, 375};
  camera.eye = {6, -4, 5};
  camera.image_size = {1000, 750};
  return camera;
}

TEST_CASE("every field of a camera counts in its hash") {
  const Changes<Camera> changes = {[](Camera& c) { c.focal_length = 1073; },
                                   [](Camera& c) { c.principal_point.x() = 501; },
                                   [](Camera& c) { c.principal_point.y() = 376; },
                                   [](Camera& c) { c.eye.x() = 7; },
                                   [](Camera& c) { c.eye.y() = -5; },
                                   [](Camera& c) { c.eye.z() = 6; },
                                   [](Camera& c) { c.rotation(0, 1) = 1; },
                                   [](Camera& c) { c.rotation(1, 0) = 1; },
                                   [](Camera& c) { c.image_size.x() = 1001; },
                                   [](Camera& c) { c.image_size.y() = 751; },
                                   [](Camera& c) { c.image_origin.x() = 1; },
                                   [](Camera& c) { c.image_origin.y() = 1; }};
  check_changes<Camera>(small_camera, changes, hash_of_value<Camera>);
}

PerspectiveDrawing small_perspective_drawing() {
  PerspectiveDrawing drawing;
  drawing.image_size = {1000, 750};
  PerspectiveStroke stroke;
  stroke.id = "e01";
  stroke.group = StrokeGroup::NormalX;
  stroke.pieces = {{Vec2(0, 0), Vec2(1, 0), Vec2(2, 0), Vec2(3, 1)}, {Vec2(3, 1), Vec2(4, 2), Vec2(5, 2), Vec2(6, 1)}};
  stroke.line = 12;
  drawing.strokes = {stroke};
  drawing.known_point = KnownPoint{Vec2(1, 2), Vec3(3, 4, 5)};
  drawing.known_lengths = {{"e01", 4}};
  drawing.field_of_view = 0.8;
  drawing.principal_point = Vec2(500, 375);
  drawing.shells = 1;
  return drawing;
}

TEST_CASE("every field of a perspective drawing counts in its hash") {
  using D = PerspectiveDrawing;
  const Changes<D> changes = {[](D& d) { d.origin.x() = 1; },
                              [](D& d) { d.origin.y() = 1; },
                              [](D& d) { d.image_size.x() = 1; },
                              [](D& d) { d.image_size.y() = 1; },
                              [](D& d) { d.strokes[0].id = "e02"; },
                              [](D& d) { d.strokes[0].role = StrokeRole::Construction; },
                              [](D& d) { d.strokes[0].group = StrokeGroup::NormalY; },
                              [](D& d) { d.strokes[0].colour = "red"; },
                              [](D& d) { d.strokes[0].pieces.pop_back(); },
                              [](D& d) { d.strokes[0].pieces[1][2].y() = 3; },
                              [](D& d) { d.strokes[0].pieces[0][1].x() = -0.0; },
                              [](D& d) { d.strokes[0].straight = true; },
                              [](D& d) { d.strokes[0].from = "v1"; },
                              [](D& d) { d.strokes[0].to = "v1"; },
                              [](D& d) { d.strokes[0].link = true; },
                              [](D& d) { d.strokes[0].start_lock = EndLock::Smooth; },
                              [](D& d) { d.strokes[0].end_lock = EndLock::Smooth; },
                              [](D& d) { d.strokes[0].end_lock = EndLock::Corner; },
                              [](D& d) { d.strokes[0].hidden = true; },
                              [](D& d) { d.strokes[0].weight = 2; },
                              [](D& d) { d.strokes[0].line = 13; },
                              [](D& d) { d.strokes[0].line.reset(); },
                              [](D& d) { d.strokes.clear(); },
                              [](D& d) { d.known_point.reset(); },
                              [](D& d) { d.known_point->at.y() = 3; },
                              [](D& d) { d.known_point->point.z() = 6; },
                              [](D& d) { d.known_lengths[0].length = 5; },
                              [](D& d) { d.known_lengths[0].stroke = "e02"; },
                              [](D& d) { d.known_lengths.clear(); },
                              [](D& d) { d.field_of_view = 0.9; },
                              [](D& d) { d.field_of_view.reset(); },
                              [](D& d) { d.principal_point->x() = 1; },
                              [](D& d) { d.principal_point.reset(); },
                              [](D& d) { d.unit = "mm"; },
                              [](D& d) { d.shells = 2; },
                              [](D& d) { d.shells.reset(); },
                              [](D& d) { d.file = "box.svg"; }};
  check_changes<D>(small_perspective_drawing, changes, hash_of_value<D>);
}

CurveNetwork small_network() {
  CurveNetwork network;
  network.vertices = {Vec3(0, 0, 0), Vec3(3, 0, 1)};
  network.curves = {{"e01", 0, 1, {{{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(2, 0, 0), Vec3(3, 0, 1)}}}, false}};
  return network;
}

TEST_CASE("every field of a curve network counts in its hash") {
  using N = CurveNetwork;
  const Changes<N> changes = {[](N& n) { n.vertices[1].z() = 2; },
                              [](N& n) { n.vertices.emplace_back(0, 0, 0); },
                              [](N& n) { n.curves[0].id = "e02"; },
                              [](N& n) { n.curves[0].start = 1; },
                              [](N& n) { n.curves[0].end = 0; },
                              [](N& n) { n.curves[0].straight = true; },
                              [](N& n) { n.curves[0].pieces[0].points[2].y() = 1; },
                              [](N& n) { n.curves[0].pieces[0].weights[3] = 2; },
                              [](N& n) { n.curves[0].pieces.push_back(n.curves[0].pieces[0]); },
                              [](N& n) { n.curves.clear(); }};
  check_changes<N>(small_network, changes, hash_of_value<N>);
}

/// Two faces of two sides, their edges common.
Brep small_brep() {
  Brep brep;
  brep.vertices = {{Vec3(0, 0, 0), 0}, {Vec3(3, 0, 0), 1}};
  const RationalCubic cubic = straight_cubic(Vec3(0, 0, 0), Vec3(3, 0, 0));
  for (Index e : {0U, 1U}) brep.edges.push_back({"e", e, 0, 1, {cubic}, {cubic}, false, {e, 2 + e}, false, {}});
  brep.half_edges = {{0, false, 0, 3}, {1, false, 1, 2}, {0, true, 1, 1}, {1, true, 0, 0}};
  brep.loops = {{0, 0}, {1, 1}};
  brep.faces.resize(2);
  for (Index f : {0U, 1U}) brep.faces[f] = {0, f, {f}, false, Vec3(0, 0, 0), Vec3(0, 0, 1), 0, {2, GregoryPatch()}};
  brep.shells = {{{0, 1}, true, false}};
  return brep;
}

TEST_CASE("every field of a B-rep counts in its hash") {
  REQUIRE(validate(small_brep()).empty());
  const Changes<Brep> changes = {[](Brep& b) { b.vertices[1].point.y() = 1; },
                                 [](Brep& b) { b.vertices[1].network_vertex = 7; },
                                 [](Brep& b) { b.edges[0].id = "f"; },
                                 [](Brep& b) { b.edges[0].curve = 5; },
                                 [](Brep& b) { b.edges[0].start = 1; },
                                 [](Brep& b) { b.edges[0].end = 0; },
                                 [](Brep& b) { b.edges[0].pieces[0].weights[1] = 2; },
                                 [](Brep& b) { b.edges[0].fitted[0].points[1].z() = 2; },
                                 [](Brep& b) { b.edges[0].straight = true; },
                                 [](Brep& b) { b.edges[0].half_edges[1] = no_index; },
                                 [](Brep& b) { b.edges[0].smooth = true; },
                                 [](Brep& b) { b.edges[0].across[1].x() = 1; },
                                 [](Brep& b) { b.half_edges[2].edge = 1; },
                                 [](Brep& b) { b.half_edges[2].reversed = false; },
                                 [](Brep& b) { b.half_edges[2].loop = 0; },
                                 [](Brep& b) { b.half_edges[2].next = 0; },
                                 [](Brep& b) { b.loops[1].face = 0; },
                                 [](Brep& b) { b.loops[1].first = 2; },
                                 [](Brep& b) { b.faces[1].shell = 1; },
                                 [](Brep& b) { b.faces[1].outline = 0; },
                                 [](Brep& b) { b.faces[1].loops[0] = 0; },
                                 [](Brep& b) { b.faces[1].planar = true; },
                                 [](Brep& b) { b.faces[1].origin.x() = 1; },
                                 [](Brep& b) { b.faces[1].normal.x() = 1; },
                                 [](Brep& b) { b.faces[1].flatness = 1; },
                                 [](Brep& b) { b.faces[1].patches[1].boundary[11].z() = 1; },
                                 [](Brep& b) { b.faces[1].patches[1].inner[7].z() = 1; },
                                 [](Brep& b) { b.shells[0].faces.pop_back(); },
                                 [](Brep& b) { b.shells[0].closed = false; },
                                 [](Brep& b) { b.shells[0].is_void = true; }};
  check_changes<Brep>(small_brep, changes, hash_of_value<Brep>);
}

AttributeNetwork small_attribute_network() {
  AttributeNetwork network;
  network.name = "tri";
  network.units = "m";
  network.tolerance = 1e-5;
  network.nodes = {{"a", Vec3(0, 0, 0)}, {"b", Vec3(3, 0, 0)}};
  network.curves = {{"c0", 0, 1, {Vec3(0, 0, 0), Vec3(1, 1, 0), Vec3(3, 0, 0)}, CurveJoin::Crease},
                    {"c1", 0, 1, {}, CurveJoin::Crease},
                    {"c2", no_index, no_index, {Vec3(1, 0, 0), Vec3(2, 0, 0)}, CurveJoin::Crease}};
  network.faces = {{"f", {{0, false}, {1, true}}, {}, 0.7, {}, {{2, InnerProfile::Smooth, 0.5}}}};
  network.points = {{"p", 0, Vec3(1, 0.5, 0), FanPlace{3, 0.1, 0.2}, 0.3, PointProfile::Smooth, Vec3(0, 0, 1)}};
  network.slopes = {{0, 0, {0, 1}, {Vec3(0, 0, 1), Vec3(0, 1, 1)}, 1}};
  return network;
}

TEST_CASE("every field of an attribute network counts in its hash") {
  using N = AttributeNetwork;
  REQUIRE(validate(small_attribute_network()).empty());
  const Changes<N> changes = {[](N& n) { n.name = "quad"; },
                              [](N& n) { n.units = "mm"; },
                              [](N& n) { n.tolerance = 2e-5; },
                              [](N& n) { n.tolerance.reset(); },
                              [](N& n) { n.nodes[1].id = "c"; },
                              [](N& n) { n.nodes[1].point.y() = 1; },
                              [](N& n) { n.curves[0].id = "c3"; },
                              [](N& n) { n.curves[0].from = 1; },
                              [](N& n) { n.curves[0].to = no_index; },
                              [](N& n) { n.curves[0].control[1].z() = 1; },
                              [](N& n) { n.curves[0].control.clear(); },
                              [](N& n) { n.curves[0].join = CurveJoin::Smooth; },
                              [](N& n) { n.faces[0].id = "g"; },
                              [](N& n) { n.faces[0].loop[1].curve = 2; },
                              [](N& n) { n.faces[0].loop[1].reversed = false; },
                              [](N& n) { n.faces[0].mode = AttributeMode::Paper; },
                              [](N& n) { n.faces[0].fullness = 1; },
                              [](N& n) { n.faces[0].domain = AttributeDomain::Uniform; },
                              [](N& n) { n.faces[0].inner[0].curve = 1; },
                              [](N& n) { n.faces[0].inner[0].profile = InnerProfile::Sharp; },
                              [](N& n) { n.faces[0].inner[0].radius.reset(); },
                              [](N& n) { n.points[0].id = "q"; },
                              [](N& n) { n.points[0].face = 1; },
                              [](N& n) { n.points[0].point.x() = 2; },
                              [](N& n) { n.points[0].fan->corner = 2; },
                              [](N& n) { n.points[0].fan->a = 0; },
                              [](N& n) { n.points[0].fan->b = 0; },
                              [](N& n) { n.points[0].fan.reset(); },
                              [](N& n) { n.points[0].radius = 1; },
                              [](N& n) { n.points[0].profile = PointProfile::Cone; },
                              [](N& n) { n.points[0].normal->x() = 1; },
                              [](N& n) { n.points[0].normal.reset(); },
                              [](N& n) { n.slopes[0].curve = 1; },
                              [](N& n) { n.slopes[0].face = no_index; },
                              [](N& n) { n.slopes[0].at[0] = 0.1; },
                              [](N& n) { n.slopes[0].normals[1].x() = 1; },
                              [](N& n) { n.slopes[0].magnitude = 2; },
                              [](N& n) { n.slopes.clear(); }};
  check_changes<N>(small_attribute_network, changes, hash_of_value<N>);
}

TEST_CASE("every figure of a report counts in its hash, with its type and place") {
  const Changes<Report> changes = {[](Report& r) { r.set("count", 4); },
                                   [](Report& r) { r.set("count", 3.0); },
                                   [](Report& r) { r.set("count", "3"); },
                                   [](Report& r) { r.set("count", true); },
                                   [](Report& r) { r.set("count", Report()); },
                                   [](Report& r) { r.set("extra", 1); },
                                   [](Report& r) {
                                     r.set("sizes", Report::list(std::vector<int>{2, 1}));
                                   },
                                   [](Report& r) {
                                     r.set("sizes", Report::list(std::vector<int>{1, 2, 3}));
                                   },
                                   [](Report& r) { r = Report::array(); },
                                   [](Report& r) { r = Report::object(); },
                                   [](Report& r) { r = Report(); }};
  check_changes<Report>(small_report, changes, hash_of_value<Report>);
}

Backdrop small_backdrop() {
  return {std::make_shared<const PictureFile>(PictureFile{"bytes", 3, 2, "a.png"}), Vec2(1, 0), 1, 0.5, true};
}

TEST_CASE("every field of a backdrop counts in its document's hash") {
  const auto with_picture = [](const PictureFile& picture) {
    return [picture](Backdrop& b) { b.picture = std::make_shared<const PictureFile>(picture); };
  };
  const Changes<Backdrop> changes = {[](Backdrop& b) { b.centre.x() = 2; },  [](Backdrop& b) { b.centre.y() = 2; },
                                     [](Backdrop& b) { b.scale = 2; },       [](Backdrop& b) { b.opacity = 0.4; },
                                     [](Backdrop& b) { b.visible = false; }, with_picture({"other", 3, 2, "a.png"}),
                                     with_picture({"bytes", 4, 2, "a.png"}), with_picture({"bytes", 3, 3, "a.png"}),
                                     with_picture({"bytes", 3, 2, "b.png"})};
  check_changes<Backdrop>(small_backdrop, changes, [](const Backdrop& backdrop) {
    Node node = small_node();
    node.backdrop = std::make_shared<const Backdrop>(backdrop);
    return content_hash(Document().with(node));
  });
}

TEST_CASE("every field of a node counts in its document's hash") {
  const Changes<Node> changes = {[](Node& n) { n.id = 6; },
                                 [](Node& n) { n.name = "smaller"; },
                                 [](Node& n) { n.operation = "turn"; },
                                 [](Node& n) { n.version = 2; },
                                 [](Node& n) { n.parameters["factor"] = 4.0; },
                                 [](Node& n) { n.parameters["factor"] = std::int64_t{3}; },
                                 [](Node& n) { n.parameters["scale"] = 3.0; },
                                 [](Node& n) { n.parameters.clear(); },
                                 [](Node& n) { n.inputs["mesh"].node = 2; },
                                 [](Node& n) { n.inputs["mesh"].output = "mesh"; },
                                 [](Node& n) {
                                   n.inputs["other"] = {1, "value"};
                                 },
                                 [](Node& n) { n.source = test::point(1); },
                                 [](Node& n) { n.source = test::point(2); },
                                 [](Node& n) { n.visible = false; },
                                 [](Node& n) { n.enabled = false; },
                                 [](Node& n) { n.enabled = n.visible = false; },
                                 [](Node& n) { n.transform.offset.y() = 1; },
                                 [](Node& n) { n.transform.linear(0, 1) = 1; },
                                 [](Node& n) { n.transform.linear(1, 0) = 1; },
                                 [](Node& n) { n.backdrop = std::make_shared<const Backdrop>(small_backdrop()); }};
  check_changes<Node>(small_node, changes, [](const Node& node) { return content_hash(Document().with(node)); });
}

TEST_CASE("the order of nodes counts in a document's hash, the next id does not") {
  Node first = test::source_node(test::point(1));
  Node second = test::source_node(test::point(1));
  first.id = 1;
  second.id = 2;
  const Document document = Document().with(first).with(second);
  CHECK(content_hash(document) != content_hash(Document().with(second).with(first)));
  CHECK(content_hash(document) == content_hash(Document::of(document.nodes(), 100)));
}

TEST_CASE("pieces of text can't be shifted from one into the next") {
  ContentHasher one;
  one.add("ab");
  one.add("c");
  ContentHasher other;
  other.add("a");
  other.add("bc");
  CHECK(one.digest() != other.digest());
}

TEST_CASE("values of different types differ even when they are empty or missing") {
  const std::set<ContentHash> hashes = {hash_of_value(PolyMesh()),
                                        hash_of_value(Drawing()),
                                        hash_of_value(Report()),
                                        hash_of_value(Camera()),
                                        hash_of_value(PerspectiveDrawing()),
                                        hash_of_value(CurveNetwork()),
                                        hash_of_value(Brep()),
                                        hash_of_value(AttributeNetwork()),
                                        content_hash(Value(std::shared_ptr<const PolyMesh>())),
                                        content_hash(Value(std::shared_ptr<const Drawing>())),
                                        content_hash(Value(std::shared_ptr<const Report>()))};
  CHECK(hashes.size() == 11);
}

TEST_CASE("a parameter's text counts alike whether it was written by a program or a person") {
  const auto hash_with = [](const ParameterValue& value) {
    Node node;
    node.parameters["words"] = value;
    return content_hash(Document().with(node));
  };
  CHECK(hash_with(std::string("3: flat")) == hash_with(ParsedText("3: flat", 3)));
  CHECK(hash_with(std::string("3: flat")) != hash_with(ParsedText("3: leave", 3)));
}

}  // namespace
}  // namespace croquis

// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <set>
#include <string>

#include <Eigen/Geometry>
#include <catch2/catch.hpp>

#include "croquis/base/error.h"
#include "croquis/document/byte_size.h"
#include "croquis/document/content_hash.h"
#include "croquis/document/evaluator.h"
#include "croquis/document/value_bytes.h"
#include "croquis/io/project_file.h"
#include "document/values/value_row.h"
#include "io/project/database.h"
#include "io/project/project_reader.h"
#include "io/random_project.h"
#include "io/scratch.h"
#include "support/meshes/mesh_shapes.h"
#include "support/trial_operation.h"

/// What holds for every type of value, and a type that only this file knows, which goes all the way that a value can.
namespace thermal {

/// Temperatures at places.
struct Thermometer {
  std::vector<croquis::Vec3> places;
  std::vector<double> degrees;
};

croquis::BoundingBox bounds_of(const Thermometer& thermometer) {
  croquis::PolyMesh points;
  points.positions = thermometer.places;
  return croquis::bounds_of(points);
}

Thermometer transformed(Thermometer thermometer, const croquis::Affine3& map) {
  for (croquis::Vec3& place : thermometer.places) place = map(place);
  return thermometer;
}

struct ThermometerValue {
  using Content = Thermometer;
  static constexpr const char* name = "thermometer";
  static constexpr std::uint64_t tag = 1000;

  static void add_content(const Thermometer& thermometer, croquis::ContentHasher& hasher) {
    for (const croquis::Vec3& place : thermometer.places) {
      for (const double coordinate : place) hasher.add(coordinate);
    }
    hasher.add(std::span<const double>(thermometer.degrees));
  }
  static std::size_t byte_size(const Thermometer& thermometer) {
    return sizeof(Thermometer) + 32 * thermometer.degrees.size();
  }
  static void store(const Thermometer& thermometer, croquis::ByteWriter& writer) {
    writer.number(std::uint32_t{1});
    writer.numbers(thermometer.degrees);
    for (const croquis::Vec3& place : thermometer.places) {
      for (const double coordinate : place) writer.number(coordinate);
    }
  }
  static Thermometer load(croquis::ByteReader& reader) {
    croquis::read_layout(reader, 1);
    Thermometer thermometer{{}, reader.numbers<double>()};
    thermometer.places.resize(thermometer.degrees.size());
    for (croquis::Vec3& place : thermometer.places) {
      for (double& coordinate : place) coordinate = reader.number<double>();
    }
    return thermometer;
  }
};

constinit const croquis::ValueTraits thermometer_row = croquis::value_row<ThermometerValue>();

constexpr const croquis::ValueTraits& value_traits(std::type_identity<Thermometer>) { return thermometer_row; }

}  // namespace thermal

namespace croquis {
namespace {

using test::add_operation;
using thermal::Thermometer;

static_assert(ValueContent<PolyMesh> && ValueContent<Drawing> && ValueContent<Report> && ValueContent<Thermometer>);
static_assert(!ValueContent<int> && !ValueContent<MeshTags> && !std::is_convertible_v<std::shared_ptr<int>, Value>);

Value mesh_value() { return std::make_shared<const PolyMesh>(test::cube()); }

Value thermometer(double degrees) {
  return std::make_shared<const Thermometer>(Thermometer{{Vec3(1, 2, 3), Vec3(-1, 0, 0)}, {degrees, 20}});
}

/// One that warms by its parameter "factor", and the thermometer that it warms.
struct ThermalFixture {
  Registry registry;
  Document document;

  ThermalFixture() {
    OperationDescription warm = test::mesh_to_mesh("warm");
    warm.inputs[0].type = warm.outputs[0].type = ValueType::of<Thermometer>();
    add_operation(registry, warm, [](const Values& inputs, const ParameterValues& parameters, Context&) {
      Thermometer warmed = inputs.at("mesh").get<Thermometer>();
      for (double& degrees : warmed.degrees) degrees *= std::get<double>(parameters.at("factor"));
      return OperationResult{{{"mesh", std::make_shared<const Thermometer>(warmed)}}, {}};
    });
    Node placed = test::operation_node("warm", {1, "value"}, 2);
    placed.transform.offset = Vec3(0, 0, 10);
    document = Document()
                   .with(test::source_node(thermometer(5)))
                   .with(placed)
                   .with(test::operation_node("warm", {3, "value"}, 2, "of a mesh"))
                   .with(test::source_node(mesh_value()));
    Node wrong = *document.find(3);
    wrong.inputs["mesh"] = {4, "value"};
    document = document.with(wrong);
  }
};

TEST_CASE("values give their content as what it is, and are equal by identity") {
  const Value none, empty = std::shared_ptr<const PolyMesh>(), mesh = mesh_value(), copy = mesh, other = mesh_value();
  CHECK(none.type() == ValueType());
  CHECK(empty.type() == ValueType::Mesh);
  CHECK_FALSE(empty.has_content());
  CHECK(mesh.as<PolyMesh>()->face_count() == 6);
  CHECK(mesh.as<Drawing>() == nullptr);
  CHECK(mesh.as<Thermometer>() == nullptr);
  CHECK(&mesh.get<PolyMesh>() == mesh.as<PolyMesh>().get());
  for (const Value& wrong : {none, empty, thermometer(1)}) CHECK_THROWS_AS(wrong.get<PolyMesh>(), Error);
  CHECK_THROWS_AS(mesh.get<Report>(), Error);
  CHECK(mesh == copy);
  CHECK(mesh != other);
  CHECK(std::set<Value>{none, empty, mesh, copy, other}.size() == 4);
  CHECK(byte_size(none) == 0);
  CHECK_FALSE(bounds_of(none).has_value());
}

TEST_CASE("names and tags of the types of values differ") {
  std::set<std::string> names;
  std::set<std::uint64_t> tags;
  for (const ValueType type : value_types()) {
    names.insert(to_string(type));
    tags.insert(type.traits().tag);
  }
  CHECK(names.size() == value_types().size());
  CHECK(tags.size() == value_types().size());
  CHECK(names == std::set<std::string>{"mesh", "drawing", "report", "camera", "perspective drawing", "curve network",
                                       "B-rep", "attribute network", "picture"});
}

TEST_CASE("values lie where their points are; reports lie nowhere and stay what they are") {
  Affine3 map;
  map.offset = Vec3(1, 1, 1);
  Drawing drawing;
  drawing.strokes.resize(1);
  drawing.strokes[0].samples = {{Vec2(0, 0)}, {Vec2(2, 3)}};
  drawing.plane.v = Vec3::UnitZ();
  const Value sketch = std::make_shared<const Drawing>(drawing);
  CHECK(bounds_of(sketch) == BoundingBox({Vec3(0, 0, 0), Vec3(2, 0, 3)}));
  CHECK(bounds_of(sketch.transformed(map)) == BoundingBox({Vec3(1, 1, 1), Vec3(3, 1, 4)}));
  CHECK(bounds_of(mesh_value().transformed(map)) == BoundingBox({Vec3(1, 1, 1), Vec3(2, 2, 2)}));
  CHECK(bounds_of(thermometer(1).transformed(map)) == BoundingBox({Vec3(0, 1, 1), Vec3(2, 3, 4)}));
  const Value report = std::make_shared<const Report>(Report(1));
  CHECK_FALSE(bounds_of(report).has_value());
  CHECK(report.transformed(map) == report);
}

TEST_CASE("cameras and curve networks move with their nodes") {
  Affine3 map;
  map.linear = 2 * Eigen::AngleAxisd(0.7, Vec3(1, 2, 2) / 3).toRotationMatrix();
  map.offset = Vec3(4, -1, 2);
  test::Random random(9);
  const Camera camera = test::random_camera(random);
  const Camera moved = Value(std::make_shared<const Camera>(camera)).transformed(map).get<Camera>();
  const CurveNetwork network = test::random_network(random);
  const Value moved_network = Value(std::make_shared<const CurveNetwork>(network)).transformed(map);
  for (std::size_t i = 0; i < network.vertices.size(); ++i) {
    const Vec3 vertex = moved_network.get<CurveNetwork>().vertices[i];
    CHECK(vertex == map(network.vertices[i]));
    CHECK((moved.project(vertex) - camera.project(network.vertices[i])).norm() < 1e-6);
  }
  map.linear.col(0) *= -1;  // a mirror, which no camera follows
  const Camera mirrored = transformed(camera, map);
  CHECK(std::abs(mirrored.rotation.determinant() - 1) < 1e-12);
  CHECK(mirrored.eye == map(camera.eye));
  CurveNetwork line;
  line.vertices = {Vec3(0, 0, 0), Vec3(3, 0, 0)};
  line.curves = {{"e", 0, 1, {{{Vec3(0, 0, 0), Vec3(1, 5, 0), Vec3(2, 0, -1), Vec3(3, 0, 0)}}}, false}};
  CHECK(bounds_of(Value(std::make_shared<const CurveNetwork>(line))) == BoundingBox({Vec3(0, 0, -1), Vec3(3, 5, 0)}));
}

TEST_CASE("stored perspective drawings, cameras and networks that break their rules are refused") {
  const auto refused = []<typename T>(T content, const auto& spoil) {
    const std::string good = encode(std::make_shared<const T>(content));
    CHECK(encode(decode(ValueType::of<T>(), good)) == good);
    spoil(content);
    CHECK_THROWS_AS(decode(ValueType::of<T>(), encode(std::make_shared<const T>(content))), BadBytes);
    for (std::size_t length = 0; length < good.size(); ++length) {
      CHECK_THROWS_AS(decode(ValueType::of<T>(), good.substr(0, length)), BadBytes);
    }
  };
  refused(Camera(), [](Camera& camera) { camera.focal_length = 0; });
  refused(Camera(), [](Camera& camera) { camera.rotation(0, 1) = 0.1; });
  refused(Camera(), [](Camera& camera) { camera.rotation(2, 2) = -1; });
  refused(Camera(), [](Camera& camera) { camera.eye.x() = std::nan(""); });
  PerspectiveDrawing drawing;
  drawing.strokes.resize(1);
  drawing.strokes[0].pieces = {{Vec2(0, 0), Vec2(1, 0), Vec2(2, 0), Vec2(3, 1)}};
  refused(drawing, [](PerspectiveDrawing& d) { d.strokes[0].pieces.clear(); });
  refused(drawing, [](PerspectiveDrawing& d) { d.strokes[0].pieces.push_back(d.strokes[0].pieces[0]); });
  refused(drawing, [](PerspectiveDrawing& d) { d.strokes[0].group = static_cast<StrokeGroup>(7); });
  refused(drawing, [](PerspectiveDrawing& d) { d.strokes[0].weight = -1; });
  refused(drawing, [](PerspectiveDrawing& d) { d.strokes.push_back(d.strokes[0]); });
  refused(drawing, [](PerspectiveDrawing& d) { d.field_of_view = 4; });
  refused(drawing, [](PerspectiveDrawing& d) { d.known_lengths = {{"e", 0}}; });
  refused(drawing, [](PerspectiveDrawing& d) { d.shells = 0; });
  CurveNetwork network;
  network.vertices = {Vec3(0, 0, 0), Vec3(3, 0, 0)};
  network.curves = {{"e", 0, 1, {straight_cubic(Vec3(0, 0, 0), Vec3(3, 0, 0))}, true}};
  refused(network, [](CurveNetwork& n) { n.curves[0].end = 2; });
  refused(network, [](CurveNetwork& n) { n.curves[0].end = 0; });
  refused(network, [](CurveNetwork& n) { n.curves[0].pieces[0].weights[1] = 0; });
  refused(network, [](CurveNetwork& n) { n.curves[0].pieces.clear(); });
  refused(network, [](CurveNetwork& n) { n.curves.push_back(n.curves[0]); });
}

TEST_CASE("stored B-reps and attribute networks that contradict themselves are refused") {
  const auto refused = []<typename T>(T content, const auto& spoil) {
    spoil(content);
    CHECK_THROWS_AS(decode(ValueType::of<T>(), encode(std::make_shared<const T>(content))), BadBytes);
  };
  test::Random random(3);
  Brep brep;
  while (brep.faces.empty()) brep = test::random_brep(random);
  const std::string good = encode(std::make_shared<const Brep>(brep));
  CHECK(encode(decode(ValueType::Brep, good)) == good);
  for (std::size_t length = 0; length < good.size(); length += 7)
    CHECK_THROWS_AS(decode(ValueType::Brep, good.substr(0, length)), BadBytes);
  refused(brep, [](Brep& b) { b.half_edges[0].next = 0; });
  refused(brep, [](Brep& b) { b.half_edges[1].loop = 99; });
  refused(brep, [](Brep& b) { b.edges[0].half_edges[0] = 99; });
  refused(brep, [](Brep& b) { b.edges[0].fitted.clear(); });
  refused(brep, [](Brep& b) { b.edges[1].end = 99; });
  refused(brep, [](Brep& b) { b.faces[0].loops = {99}; });
  refused(brep, [](Brep& b) { b.faces[0].loops = {1}; });
  refused(brep, [](Brep& b) { b.faces[0].flatness = -1; });
  refused(brep, [](Brep& b) {
    b.faces[0].planar = true;
    b.faces[0].patches.resize(2);
  });
  refused(brep, [](Brep& b) { b.shells[0].faces = {0, 99}; });
  refused(brep, [](Brep& b) { b.shells[0].faces = {0, 0}; });
  refused(brep, [](Brep& b) { b.shells[0].faces = {0}; });
  const AttributeNetwork network = test::random_attribute_network(random);
  refused(network, [](AttributeNetwork& n) { n.nodes[1].id = n.nodes[0].id; });
  refused(network, [](AttributeNetwork& n) { n.curves[0].from = 99; });
  refused(network, [](AttributeNetwork& n) { n.curves[0].control = {Vec3(0, 0, 0)}; });
  refused(network, [](AttributeNetwork& n) { n.faces[0].loop[0].curve = 99; });
  refused(network, [](AttributeNetwork& n) { n.faces[0].loop.push_back(n.faces[0].loop[0]); });
  refused(network, [](AttributeNetwork& n) { n.faces[0].fullness = 3; });
  refused(network, [](AttributeNetwork& n) { n.points.push_back({"p", 99, Vec3(0, 0, 0), {}, {}, {}, {}}); });
  refused(network, [](AttributeNetwork& n) { n.slopes.push_back({0, no_index, {0.5, 0.2}, {}, 1}); });
}

TEST_CASE("a B-rep moves with its node, and a mirrored one still has its faces outside") {
  test::Random random(12);
  Brep brep;
  while (brep.faces.empty() || brep.faces[0].planar || brep.faces[1].planar) brep = test::random_brep(random);
  Affine3 map;
  map.linear << 1, 0.2, 0, 0, -2, 0.1, 0.3, 0, 1;  // mirrors
  map.offset = Vec3(1, 2, 3);
  const Brep mirrored = transformed(brep, map);
  CHECK(validate(mirrored).empty());
  for (std::size_t f = 0; f < brep.faces.size(); ++f) {
    // Patch i begins where half-edge i does; both are counted the other way round.
    const std::vector<GregoryPatch>& patches = mirrored.faces[f].patches;
    for (std::size_t i = 0; i < patches.size(); ++i) {
      const std::size_t old = (patches.size() + 1 - i) % patches.size();
      for (const double u : {0.0, 0.3, 1.0}) {
        for (const double v : {0.1, 0.6}) {
          const PatchPoint there = brep.faces[f].patches[old].at(v, u), here = patches[i].at(u, v);
          CHECK((here.at - map(there.at)).norm() < 1e-12 * 30);
          CHECK((here.du - map.linear * there.dv).norm() < 1e-12 * 100);
        }
      }
    }
  }
  const Brep back = transformed(mirrored, {map.linear.inverse(), -map.linear.inverse() * map.offset});
  CHECK(validate(back).empty());
  CHECK(back.half_edges[1].next == brep.half_edges[1].next);
  CHECK((back.edges[0].across[0] - brep.edges[0].across[0]).norm() < 1e-9);
}

TEST_CASE("a type of value that one file defines is computed, moved, hashed and counted like all others") {
  const ThermalFixture f;
  Evaluator evaluator(f.registry);
  Progress progress;
  const auto warmed = evaluator.evaluate(f.document, 2, Quality::Final, progress);
  REQUIRE_FALSE(warmed->failed);
  const Value& value = warmed->outputs.at("mesh");
  CHECK(value.get<Thermometer>().degrees == std::vector<double>{10, 40});
  CHECK(value.get<Thermometer>().places[0] == Vec3(1, 2, 13));
  CHECK(byte_size(value) == sizeof(Thermometer) + 64);
  CHECK(evaluator.bytes() > 2 * byte_size(value));
  CHECK(content_hash(thermometer(5)) == content_hash(thermometer(5)));
  CHECK(content_hash(thermometer(5)) != content_hash(thermometer(6)));
  const auto wrong = evaluator.evaluate(f.document, 3, Quality::Final, progress);
  REQUIRE(wrong->failed);
  CHECK(wrong->findings[0].code == "E_INPUT");
  CHECK(wrong->findings[0].message.find("a thermometer") != std::string::npos);
}

TEST_CASE("a project keeps a type of value for readers that know it, and others leave its nodes out") {
  const ThermalFixture f;
  const test::Scratch folder;
  Progress progress;
  save_project(folder / "a.croq", {f.document, {}, {}}, progress);
  std::vector<ValueType> types(value_types().begin(), value_types().end());
  types.push_back(ValueType::of<Thermometer>());
  Database database = Database::read(folder / "a.croq", std::filesystem::file_size(folder / "a.croq"), progress);
  const ProjectFile known = read_project_database(database, "a.croq", progress, types);
  CHECK(known.warnings.empty());
  CHECK(content_hash(known.document) == content_hash(f.document));
  const ProjectFile unknown = load_project(folder / "a.croq", progress);
  CHECK(unknown.document.nodes().size() == f.document.nodes().size() - 1);
  REQUIRE(unknown.warnings.size() == 2);
  CHECK(unknown.warnings[0].message.find("kind that this version doesn't know") != std::string::npos);
  CHECK(unknown.warnings[1].message.find("lost its input") != std::string::npos);
  const std::string bytes = encode(thermometer(3));
  CHECK(encode(decode(ValueType::of<Thermometer>(), bytes)) == bytes);
  CHECK_THROWS_AS(decode(ValueType::of<Thermometer>(), bytes + "x"), BadBytes);
}

}  // namespace
}  // namespace croquis

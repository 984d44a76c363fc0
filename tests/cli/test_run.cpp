// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "cli/process.h"
#include "croquis/io/file.h"
#include "croquis/io/mesh_file.h"
#include "croquis/io/project_file.h"
#include "support/meshes/mesh_shapes.h"

namespace croquis::test {
namespace {

using Json = nlohmann::json;

Value circle(double radius) {
  Drawing drawing;
  Stroke stroke;
  stroke.id = "circle";
  stroke.closed = true;
  for (int i = 0; i < 64; ++i) {
    const double angle = i * 6.283185307179586 / 64;
    stroke.samples.push_back({Vec2(radius * std::cos(angle), radius * std::sin(angle)), 1, Vec2::Zero(), 0});
  }
  drawing.strokes = {stroke};
  return std::make_shared<const Drawing>(drawing);
}

Node source(const std::string& name, Value value) {
  Node node;
  node.name = name;
  node.source = std::move(value);
  return node;
}

Node inflated(const std::string& name, NodeId sketch) {
  Node node;
  node.name = name;
  node.operation = "inflate";
  node.inputs["drawing"] = {sketch, "value"};
  return node;
}

/// Nodes 1 and 2: a circle and its solid.
Node exact(const std::string& name, NodeId sketch) {
  Node node = inflated(name, sketch);
  node.parameters["preset"] = std::string("clean");
  return node;
}

Document ball() { return Document().with(source("sketch", circle(80))).with(inflated("ball", 1)); }

std::string saved(const ScratchFolder& folder, const std::string& name, const Document& document) {
  Progress progress;
  save_project(folder / name, {document, {}, {}}, progress);
  return folder / name;
}

Json report_of(const ProcessResult& result) {
  INFO(result.err);
  return Json::parse(result.out);
}

TEST_CASE("a project gives the bytes that its operation gives by itself") {
  const ScratchFolder folder;
  const std::string project = saved(folder, "a.croq", ball());
  const ProcessResult result = run_cli({"run", project, "-o", folder / "a.obj", "--json"});
  CHECK(result.code == 0);
  const Json json = report_of(result);
  CHECK(json["command"] == "run");
  CHECK(json["mesh"]["closed"] == true);
  CHECK(json["mesh"]["self_intersections"] == 0);
  CHECK(json["details"]["nodes"][0]["id"] == "2");
  CHECK(json["details"]["nodes"][0]["details"].is_object());
  REQUIRE(run_cli({"run", project, "-o", "-", "--output-format", "obj"}).out == slurp(folder / "a.obj"));
  const ProcessResult piped = run_cli({"run", "-", "-o", folder / "b.obj"}, {.standard_input = slurp(project)});
  CHECK(piped.code == 0);
  CHECK(slurp(folder / "b.obj") == slurp(folder / "a.obj"));
}

TEST_CASE("a setting changes one parameter for the run, by name or id, and the project stays as it was") {
  const ScratchFolder folder;
  const std::string project = saved(folder, "a.croq", ball());
  const std::string before = slurp(project);
  REQUIRE(run_cli({"run", project, "-o", folder / "plain.obj"}).code == 0);
  REQUIRE(run_cli({"run", project, "-o", folder / "fine.obj", "--set", "ball.resolution=3"}).code == 0);
  REQUIRE(
      run_cli({"run", project, "-o", folder / "same.obj", "--set", "2.resolution=5", "--set", "2.resolution=3"}).code ==
      0);
  CHECK(slurp(folder / "fine.obj") != slurp(folder / "plain.obj"));
  CHECK(slurp(folder / "same.obj") == slurp(folder / "fine.obj"));
  CHECK(slurp(project) == before);
}

TEST_CASE("settings that can't be are wrong usage, all named at once") {
  const ScratchFolder folder;
  const std::string project = saved(folder, "a.croq", ball());
  const ProcessResult result =
      run_cli({"run", project, "-o", folder / "a.obj", "--json", "--set", "egg.resolution=2", "--set", "ball.colour=2",
               "--set", "ball.resolution=fine", "--set", "sketch.resolution=2"});
  CHECK(result.code == 2);
  const Json errors = report_of(result)["errors"];
  REQUIRE(errors.size() == 4);
  CHECK(errors[0]["subject"][0]["id"] == "egg");
  CHECK(errors[1]["subject"][0]["id"] == "colour");
  CHECK(errors[2]["subject"][0]["id"] == "resolution");
  CHECK(errors[3]["message"].get<std::string>().find("'sketch'") != std::string::npos);
  CHECK(run_cli({"run", project, "-o", folder / "a.obj", "--set", "nonsense"}).code == 2);
  CHECK(run_cli({"run", project, "-o", folder / "a.txt"}).code == 2);
  CHECK(folder.names() == std::vector<std::string>{"a.croq"});
}

TEST_CASE("several visible meshes become objects of one file; hidden ones and steps on the way don't") {
  const ScratchFolder folder;
  Node hidden = source("hidden", std::make_shared<const PolyMesh>(torus(5, 4)));
  hidden.visible = false;
  const auto body = std::make_shared<const PolyMesh>(cube());
  const Document document = Document()
                                .with(source("box", body))
                                .with(hidden)
                                .with(source("", std::make_shared<const PolyMesh>(tetrahedron())));
  const std::string project = saved(folder, "a.croq", document);
  const Json json = report_of(run_cli({"run", project, "-o", folder / "a.obj", "--json"}));
  CHECK(json["mesh"]["vertices"] == 12);
  CHECK(json["mesh"]["faces"] == 10);
  CHECK(json["mesh"]["components"] == 2);
  Progress progress;
  const PolyMesh mesh = read_mesh(read_file(folder / "a.obj"), MeshFormat::Obj, "a.obj", progress).mesh;
  const AttributeChannel* objects = mesh.channel("object", Domain::Face);
  REQUIRE(objects != nullptr);
  CHECK(objects->labels == std::vector<std::string>{"box", "node-3"});
}

TEST_CASE("meshes that come into one file bring their tags along") {
  const ScratchFolder folder;
  PolyMesh first = cube(), second = tetrahedron();
  first.tags = {{{{0, 1}, infinite_sharpness}, {{2, 9}, 1}}, {7, 8}, {}};  // 8 and 9 are not there
  second.tags = {{{{3, 1}, 2.5}}, {0}, {{"rim", 2.5, {{1, 3}}, {0}}}};
  const Document document = Document()
                                .with(source("box", std::make_shared<const PolyMesh>(first)))
                                .with(source("tip", std::make_shared<const PolyMesh>(second)));
  const std::string project = saved(folder, "a.croq", document);
  const ProcessResult result = run_cli({"run", project, "-o", folder / "a.obj"});
  CHECK(result.code == 0);
  CHECK_THAT(result.err, Catch::Contains("'tip: rim'"));
  Progress progress;
  const PolyMesh mesh = read_mesh(read_file(folder / "a.obj"), MeshFormat::Obj, "a.obj", progress).mesh;
  CHECK(mesh.tags == MeshTags{{{{0, 1}, infinite_sharpness}, {{11, 9}, 2.5}}, {7, 8}, {}});
}

TEST_CASE("a node that fails is a warning beside others, and an error alone") {
  const ScratchFolder folder;
  Drawing crossed = circle(80).get<Drawing>();
  Drawing other = crossed;
  for (StrokeSample& sample : other.strokes[0].samples) sample.position.x() += 60;
  other.strokes[0].id = "other";
  crossed.strokes.push_back(other.strokes[0]);
  const Document bad =
      Document().with(source("two circles", std::make_shared<const Drawing>(crossed))).with(exact("impossible", 1));
  const ProcessResult alone = run_cli({"run", saved(folder, "bad.croq", bad), "-o", folder / "a.obj", "--json"});
  CHECK(alone.code == 4);
  CHECK(report_of(alone)["error"]["code"] == "E_CROSS");
  CHECK(folder.names() == std::vector<std::string>{"bad.croq"});

  const Document mixed = bad.with(source("box", std::make_shared<const PolyMesh>(cube())));
  const ProcessResult beside = run_cli({"run", saved(folder, "mixed.croq", mixed), "-o", folder / "a.obj", "--json"});
  CHECK(beside.code == 0);
  CHECK(report_of(beside)["warnings"][0]["code"] == "E_CROSS");
  CHECK(report_of(beside)["mesh"]["faces"] == 6);
}

TEST_CASE("projects without a mesh, damaged ones and other files are answered by their exit codes") {
  const ScratchFolder folder;
  const std::string empty = saved(folder, "empty.croq", {});
  const ProcessResult nothing = run_cli({"run", empty, "-o", folder / "a.obj", "--json"});
  CHECK(nothing.code == 4);
  CHECK(report_of(nothing)["error"]["code"] == "E_NO_MESH");
  CHECK(run_cli({"run", folder / "missing.croq", "-o", folder / "a.obj"}).code == 3);
  CHECK(run_cli({"run", folder.write("text.croq", "text"), "-o", folder / "a.obj"}).code == 3);
  const std::string whole = slurp(saved(folder, "a.croq", ball()));
  CHECK(run_cli({"run", folder.write("cut.croq", whole.substr(0, 6000)), "-o", folder / "a.obj"}).code == 3);
  CHECK(run_cli({"run", folder / "a.croq", "-o", folder / "missing/a.obj"}).code == 6);
  const Document unknown = ball().with([] {
    Node node;
    node.operation = "carve";
    return node;
  }());
  const ProcessResult newer =
      run_cli({"run", saved(folder, "unknown.croq", unknown), "-o", folder / "a.obj", "--json", "--strict"});
  CHECK(newer.code == 1);
  CHECK(report_of(newer)["warnings"][0]["code"] == "E_OPERATION_UNKNOWN");
}

}  // namespace
}  // namespace croquis::test

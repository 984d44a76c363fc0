// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <memory>
#include <set>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "cli/process.h"
#include "croquis/io/mesh_file.h"
#include "croquis/io/project_file.h"
#include "support/meshes/mesh_shapes.h"

// What is larger than 1e30 counts as not finite, whatever it is written in.
namespace croquis::test {
namespace {

using Json = nlohmann::json;
using Words = std::vector<std::string>;

const Words refused_numbers = {"1e308", "-1e308", "1e31", "nan", "inf"};

/// A text with every "NUMBER" replaced.
std::string with_number(std::string text, const std::string& number) {
  for (std::size_t at = text.find("NUMBER"); at != std::string::npos; at = text.find("NUMBER"))
    text.replace(at, 6, number);
  return text;
}

/// Whether anything in a report isn't there that should be: JSON has null where a number isn't finite.
bool has_null(const Json& json) {
  return json.is_null() || (json.is_structured() && std::ranges::any_of(json, has_null));
}

struct Answer {
  int code = 0;
  Json report;
};

Answer answer_of(Words arguments) {
  arguments.insert(arguments.end(), {"--json", "--quiet"});
  const ProcessResult result = run_cli(arguments);
  INFO(result.err);
  REQUIRE(result.code >= 0);
  // A refusal may quote what was given.
  if (result.code == 0) CHECK(result.out.find("nan") == std::string::npos);
  return {result.code, Json::parse(result.out)};
}

bool warns_of(const Answer& answer, const std::string& code) {
  return std::ranges::any_of(answer.report.at("warnings"),
                             [&](const Json& finding) { return finding.at("code") == code; });
}

/// The kinds and ids of what an answer's errors are about.
std::set<std::string> named(const Answer& answer) {
  std::set<std::string> names;
  for (const Json& error : answer.report.at("errors")) {
    for (const Json& subject : error.at("subject"))
      names.insert(subject.at("kind").get<std::string>() + " " + subject.at("id").get<std::string>());
  }
  return names;
}

const std::string obj = "v 0 0 NUMBER\nv 1 0 0\nv 0 1 0\nv 0 0 -1\nf 1 2 3\nf 1 4 2\nf 2 4 3\nf 3 4 1\n";

}  // namespace

TEST_CASE("meshes of every text format with a number that is too large are refused by the vertex") {
  const ScratchFolder folder;
  const std::vector<std::pair<std::string, std::string>> files = {
      {"a.obj", obj},
      {"a.off", "OFF\n4 4 0\n0 0 NUMBER\n1 0 0\n0 1 0\n0 0 -1\n3 0 1 2\n3 0 3 1\n3 1 3 2\n3 2 3 0\n"},
      {"a.ply",
       "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\nproperty double y\nproperty double z\n"
       "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 NUMBER\n1 0 0\n0 1 0\n3 0 1 2\n"},
      {"a.stl",
       "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 NUMBER\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n"
       "endsolid a\n"}};
  for (const auto& [name, text] : files) {
    for (const std::string& number : refused_numbers) {
      INFO(name << ' ' << number);
      const Answer answer = answer_of({"info", folder.write(name, with_number(text, number))});
      CHECK(answer.code == 3);
      CHECK(answer.report.at("error").at("code") == "E_NOT_FINITE");
      CHECK(named(answer).contains("vertex 0"));
    }
    INFO(name);
    const Answer largest = answer_of({"info", folder.write(name, with_number(text, "1e30"))});
    CHECK(largest.code == 0);
    CHECK(std::isfinite(largest.report.at("mesh").at("area").get<double>()));
    CHECK_FALSE(has_null(largest.report.at("mesh").at("bounds")));
  }
}

TEST_CASE("binary meshes with numbers that are too large are refused, and GLB after its transforms") {
  const ScratchFolder folder;
  PolyMesh mesh = tetrahedron();
  mesh.positions[2].x() = 1e31;
  for (const auto& [format, name] :
       {std::pair{MeshFormat::Ply, "a.ply"}, {MeshFormat::Stl, "a.stl"}, {MeshFormat::Glb, "a.glb"}}) {
    Progress progress;
    INFO(name);
    const Answer answer = answer_of({"info", folder.write(name, write_mesh(mesh, format, {}, progress).bytes)});
    CHECK(answer.code == 3);
    CHECK(answer.report.at("error").at("code") == "E_NOT_FINITE");
  }
}

TEST_CASE("every command that takes a mesh refuses one that is too large by its vertex") {
  const ScratchFolder folder;
  const std::string file = folder.write("a.obj", with_number(obj, "-1e308"));
  const std::string out = folder / "out.obj";
  for (const Words& arguments : {Words{"info", file},
                                 {"check", file},
                                 {"convert", file, "-o", out},
                                 {"subdivide", file, "-o", out},
                                 {"fair", file, "-o", out},
                                 {"edit", file, "-o", out, "--do", "pin vertices=0"},
                                 {"fill", file, "-o", out},
                                 {"fill", file, "--list"},
                                 {"fill", file, "-o", out, "--mode", "remesh"}}) {
    INFO(arguments[0]);
    const Answer answer = answer_of(arguments);
    CHECK(answer.code == 3);
    CHECK(named(answer).contains("vertex 0"));
  }
  const Answer dropped = answer_of({"fill", file, "-o", out, "--drop-bad"});
  CHECK(dropped.code == 0);
  CHECK(warns_of(dropped, "W_BAD_DROPPED"));
}

TEST_CASE("a sketch is refused by its stroke when a coordinate is too large, after transforms too") {
  const ScratchFolder folder;
  const std::string head = "<svg xmlns=\"http://www.w3.org/2000/svg\"><circle id=\"round\" r=\"9\"/>";
  std::vector<std::string> shapes = {
      "<g transform=\"scale(1e20)\"><path id=\"bad\" d=\"M 0 0 L 1e20 5 L 7 7 Z\"/></g>"};
  for (const char* number : {"1e308", "-1e308", "1e31", "nan", "1e999"}) {
    shapes.push_back(with_number("<path id=\"bad\" d=\"M 0 0 L NUMBER 5 L 7 7 Z\"/>", number));
    shapes.push_back(with_number("<ellipse id=\"bad\" rx=\"5\" ry=\"NUMBER\"/>", number));
  }
  for (const std::string& shape : shapes) {
    INFO(shape);
    const Answer answer =
        answer_of({"inflate", folder.write("a.svg", head + shape + "</svg>"), "-o", folder / "o.obj"});
    CHECK(answer.code == 3);
    CHECK(named(answer).contains("stroke bad"));
  }
}

namespace {

/// A box of nine edges, and a stroke and facts to be filled in.
std::string box_with(const std::string& fact, const std::string& stroke) {
  std::string box = slurp(std::string(CROQUIS_SOURCE_DIR) + "/tests/fuzz/corpus/mutate/box.svg");
  box.replace(box.find("</svg>"), 6, stroke + "</svg>");
  const std::size_t known = box.find("<cq:known"), end = box.find("/>", known) + 2;
  return fact.empty() ? box : box.replace(known, end - known, fact);
}

}  // namespace

TEST_CASE("in a perspective drawing a stroke that is too large is flagged, and the rest goes on") {
  const ScratchFolder folder;
  std::vector<std::string> strokes = {
      "<g transform=\"scale(1e20)\"><path id=\"bad\" cq:group=\"0\" d=\"M 5 5 L 1e20 9\"/></g>"};
  for (const std::string& number : refused_numbers)
    strokes.push_back(with_number("<path id=\"bad\" cq:group=\"0\" d=\"M 5 5 L NUMBER 9\"/>", number));
  const std::string plain = folder / "plain.obj", other = folder / "other.obj";
  REQUIRE(run_cli({"perspective", folder.write("a.svg", box_with("", "")), "-o", plain, "--quiet"}).code == 0);
  for (const std::string& stroke : strokes) {
    INFO(stroke);
    const Answer answer = answer_of({"perspective", folder.write("b.svg", box_with("", stroke)), "-o", other});
    REQUIRE(answer.code == 0);
    CHECK(answer.report.at("details").at("strokes").at("bad") == "flagged");
    CHECK(slurp(other) == slurp(plain));
  }
}

TEST_CASE("facts of a perspective drawing that are too large are named and left out") {
  const ScratchFolder folder;
  for (const std::string& number : refused_numbers) {
    for (const char* fact :
         {"<cq:known at=\"474.43 508.75\" point=\"0 0 NUMBER\"/>", "<cq:known at=\"NUMBER 508.75\" point=\"0 0 1\"/>",
          "<cq:length stroke=\"e1\" value=\"NUMBER\"/>", "<cq:f_px value=\"NUMBER\"/>"}) {
      const std::string whole = box_with(with_number(fact, number), "");
      const std::size_t edge = whole.find("<path id=\"e5\""), next = whole.find("<path id=\"e6\"");
      const std::string part = whole.substr(0, edge) + whole.substr(next);
      for (const std::string& drawing : {whole, part}) {
        const Answer answer = answer_of({"perspective", folder.write("a.svg", drawing), "-o", folder / "out.obj"});
        INFO(fact << number);
        CHECK(answer.code == 0);
        CHECK(warns_of(answer, "W_VALUE"));
      }
    }
  }
}

TEST_CASE("networks, tags, edits and parameters with numbers that are too large are refused by the element") {
  const ScratchFolder folder;
  const std::string out = folder / "out.obj", mesh = folder.write("cube.obj", with_number(obj, "0"));
  std::string network = slurp(std::string(CROQUIS_SOURCE_DIR) + "/examples/data/surface/tri_point.json");
  network.replace(network.find("3.0"), 3, "1e31");
  const Answer bad_node = answer_of({"surface", folder.write("n.json", network), "-o", out});
  CHECK(bad_node.code == 3);
  CHECK(named(bad_node).contains("node b"));
  const std::string tags = R"({"format": "croquis-tags-1", "edges": [{"v": [0, 1], "sharpness": 1e31}]})";
  const Answer bad_tags = answer_of({"subdivide", mesh, "-o", out, "--tags", folder.write("t.json", tags)});
  CHECK(bad_tags.code == 3);
  CHECK(bad_tags.report.at("error").at("message").get<std::string>().find("edges[0]") != std::string::npos);
  for (const std::string& number : refused_numbers) {
    INFO(number);
    CHECK(answer_of({"edit", mesh, "-o", out, "--do", "move vertices=0 by=0,0," + number}).code == 2);
    CHECK(answer_of({"edit", mesh, "-o", out, "--do", "extrude faces=0 distance=" + number}).code == 2);
    const Answer option = answer_of({"subdivide", mesh, "-o", out, "--sharp-angle", number});
    CHECK(option.code == 2);
    CHECK(named(option) == std::set<std::string>{"parameter sharp-angle"});
  }
  const Answer moved = answer_of({"edit", mesh, "-o", out, "--do", "scale vertices=all factors=1e30,1e30,1e30", "--do",
                                  "scale vertices=all factors=10,1,1"});
  CHECK(moved.code == 3);
  CHECK(named(moved).contains("vertex 1"));
}

TEST_CASE("a project whose transform makes numbers that are too large is refused by the vertex") {
  const ScratchFolder folder;
  Node node;
  node.source = std::make_shared<const PolyMesh>(tetrahedron());
  node.transform.linear *= 1e20;
  Node second;
  second.operation = "edit";
  second.parameters["do"] = std::string("pin vertices=0");
  second.inputs["mesh"] = {1, "value"};
  second.transform.linear *= 1e20;
  Progress progress;
  save_project(folder / "a.croq", {Document().with(node).with(second), {}, {}}, progress);
  const Answer answer = answer_of({"run", folder / "a.croq", "-o", folder / "out.obj"});
  CHECK(answer.code == 3);
  CHECK(answer.report.at("error").at("code") == "E_NOT_FINITE");
}

}  // namespace croquis::test

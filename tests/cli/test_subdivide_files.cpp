// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <set>
#include <string>

#include <catch2/catch.hpp>

#include "cli/cage_files.h"
#include "cli/process.h"
#include "croquis/geometry/mesh_report.h"
#include "croquis/io/mesh_file.h"
#include "croquis/io/project_file.h"
#include "support/meshes/cages.h"
#include "support/meshes/mesh_shapes.h"

namespace croquis::test {
namespace {

struct BadCage {
  std::string text;
  std::string code;
  int exit_code;
  std::string word;  ///< in the message
};

TEST_CASE("cages that can't be subdivided are refused by the element at fault, and nothing is written") {
  const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\n";
  const std::string moebius =
      "v 1 0 0\nv 1 0 1\nv 0 1 0\nv 0 1 1\nv -1 -1 0\nv -1 -1 1\nf 1 3 4 2\nf 3 5 6 4\nf 5 2 1 6\n";
  for (const BadCage& bad : {BadCage{square + "f 1 2 3\nf 2 1 4\nf 1 2 5\n", "E_EDGE_SHARED", 4, "0"},
                             {moebius, "E_NOT_ORIENTABLE", 4, ""},
                             {square + "f 1 2 2 3\n", "E_FACE_DEGENERATE", 4, "ace 0"},
                             {square + "f 1 2 3\nf 1 2\n", "E_FACE_DEGENERATE", 4, "face 1"},
                             {square + "f 1 2 9\n", "E_INDEX", 3, "line 6"},
                             {square + "v nan 0 0\nf 1 2 6\n", "E_NOT_FINITE", 3, "vertex 5"},
                             {square, "E_NO_FACES", 3, ""}}) {
    INFO(bad.text);
    const ScratchFolder folder;
    const std::string cage = folder.write("cage.obj", bad.text);
    const ProcessResult result = run_cli({"subdivide", cage, "-o", folder / "out.obj", "--json"});
    CHECK(result.code == bad.exit_code);
    const Json report = report_of(result);
    CHECK(report["error"]["code"] == bad.code);
    CHECK_THAT(report["error"]["message"].get<std::string>(), Catch::Contains(bad.word));
    CHECK(folder.names() == Words{"cage.obj"});
  }
  const ScratchFolder folder;
  const std::string cage = folder.write("cage.obj", square + "f 1 2 3\nf 2 1 4\nf 1 2 5\nf 3 3 4\nf 3 4 4\n");
  CHECK(report_of(run_cli({"subdivide", cage, "-o", folder / "a.obj", "--json"}))["errors"].size() == 3);
}

TEST_CASE("what can be repaired or left out is told, and the rest goes on") {
  const ScratchFolder folder;
  const auto warnings = [&](const PolyMesh& cage, const Words& options = {}) {
    return codes_of(subdivided(folder, cage, options)["warnings"]);
  };
  PolyMesh flipped = centred_cube();
  std::reverse(flipped.corners.begin(), flipped.corners.begin() + 4);
  CHECK(warnings(flipped) == Words{"W_FLIPPED"});
  PolyMesh loose = centred_cube();
  loose.positions.emplace_back(5, 5, 5);
  CHECK(warnings(loose) == Words{"W_LOOSE_VERTEX"});
  PolyMesh bowtie;
  for (int i = 0; i < 5; ++i) bowtie.positions.emplace_back(i % 3, i / 3, i);
  bowtie.add_triangle(0, 1, 2);
  bowtie.add_triangle(0, 3, 4);
  CHECK(warnings(bowtie) == Words{"W_BOWTIE"});
  PolyMesh wrong = bolt_loop();
  wrong.tags.creases.push_back({{0, 10}, 1});
  wrong.tags.creases.push_back({{0, 99}, 1});
  wrong.tags.creases.push_back({{0, 1}, -2});
  const Words found = warnings(wrong);
  CHECK(std::count(found.begin(), found.end(), "W_TAG_NO_EDGE") >= 1);
  CHECK(std::count(found.begin(), found.end(), "W_TAG_SHARPNESS") == 1);
  CHECK(subdivided(folder, wrong, {})["details"]["levels"][0]["sharp_edges"] == 4);
  PolyMesh pinned = bolt_loop();
  pinned.tags.pins = {0};
  CHECK(warnings(pinned) == Words{"W_PIN_NO_EFFECT"});
  CHECK(warnings(pinned, {"--scheme", "catmull-clark"}).empty());
  CHECK(warnings(tagged(bolt(), std::vector<VertexPair>{{8, 9}}), {"--chain-ends", "retract"}) ==
        Words{"W_TAG_VANISHES"});
  PolyMesh folded = single_face(5);
  folded.positions[0] =
      (folded.positions[2] + folded.positions[3]) / 2 + (folded.positions[2] - folded.positions[0]) / 9;
  CHECK(warnings(folded) == Words{"W_MAY_FOLD", "W_SELF_INTERSECTION"});
  CHECK(run_cli({"subdivide", folder / "cage.obj", "-o", folder / "a.obj", "--strict"}).code == 1);
}

TEST_CASE("malformed tags are exit code 3 with their place, wrong ones are left out by name") {
  const ScratchFolder folder;
  const std::string cage = folder.write("cage.obj", obj_of(bolt()));
  const auto run_with = [&](const std::string& tags) {
    return run_cli({"subdivide", cage, "-o", folder / "out.obj", "--json", "--tags", folder.write("tags.json", tags)});
  };
  for (const auto& [tags, place] : std::vector<std::pair<std::string, std::string>>{
           {"", "tags.json"},
           {"{\n\"format\": }", "line 2"},
           {"{\"format\": \"other\"}", "format"},
           {"{\"format\": \"croquis-tags-1\", \"edges\": [{\"v\": [8]}]}", "edges[0].v"},
           {"{\"format\": \"croquis-tags-1\", \"index_base\": 1, \"pins\": [0]}", "pins[0]"},
           {std::string(300, '['), "200 levels"}}) {
    INFO(tags);
    const ProcessResult result = run_with(tags);
    CHECK(result.code == 3);
    CHECK_THAT(report_of(result)["error"]["message"].get<std::string>(), Catch::Contains(place));
  }
  CHECK(folder.names() == Words{"cage.obj", "tags.json"});
  CHECK(run_cli({"subdivide", cage, "-o", folder / "out.obj", "--tags", folder / "missing.json"}).code == 3);
  CHECK(run_cli({"subdivide", "-", "--input-format", "obj", "-o", folder / "out.obj", "--tags", "-"}).code == 2);
  const ProcessResult result = run_with(
      "{\"format\": \"croquis-tags-1\", \"index_base\": 1, \"edges\": [{\"v\": [9, 10], \"sharpness\": 11}, "
      "{\"v\": [9, 11], \"sharpness\": 1}], \"author\": 1}");
  CHECK(result.code == 0);
  CHECK(codes_of(report_of(result)["warnings"]) == Words{"W_IGNORED", "W_TAG_NO_EDGE"});
  CHECK(report_of(result)["details"]["levels"][0]["sharp_edges"] == 1);
}

TEST_CASE("a level of too many faces is refused beforehand with the counts") {
  const ScratchFolder folder;
  const std::string cage = folder.write("cage.obj", obj_of(torus(60, 60)));
  for (const std::string scheme : {"doo-sabin", "catmull-clark", "loop"}) {
    const ProcessResult result =
        run_cli({"subdivide", cage, "-o", folder / "out.obj", "--json", "--levels", "10", "--scheme", scheme});
    CHECK(result.code == 5);
    CHECK(report_of(result)["error"]["code"] == "E_TOO_MANY_FACES");
    CHECK(result.peak_kilobytes < 200 * 1024);
  }
  CHECK(run_cli({"subdivide", cage, "-o", folder / "out.obj", "--levels", "11"}).code == 2);
  CHECK(folder.names() == Words{"cage.obj"});
}

TEST_CASE("subdividing gives the same bytes for any number of threads, from standard input too") {
  const ScratchFolder folder;
  const PolyMesh cage = tagged(torus(40, 30), std::vector<VertexPair>{{0, 1}, {1, 2}}, 1.5);
  const std::string path = folder.write("cage.obj", obj_of(cage));
  for (const Words& options : {Words{}, {"--limit"}, {"--scheme", "catmull-clark"}, {"--scheme", "loop", "--limit"}}) {
    std::set<std::string> bytes;
    for (const char* threads : {"1", "2", "8"}) {
      Words words = {"subdivide", path, "-o", "-", "--output-format", "obj", "--threads", threads};
      words.insert(words.end(), options.begin(), options.end());
      bytes.insert(run_cli(words).out);
    }
    Words words = {"subdivide", "-", "--input-format", "obj", "-o", "-", "--output-format", "obj"};
    words.insert(words.end(), options.begin(), options.end());
    bytes.insert(run_cli(words, {.standard_input = obj_of(cage)}).out);
    CHECK(bytes.size() == 1);
    CHECK(bytes.begin()->size() > 100'000);
  }
}

TEST_CASE("levels are written in every format, and formats without tags say so") {
  const ScratchFolder folder;
  for (const char* name : {"a.ply", "a.stl", "a.off", "a.glb"}) {
    INFO(name);
    const Json report = subdivided(folder, bolt_loop(), {}, name);
    CHECK(codes_of(report["warnings"]) == Words{"W_FORMAT_LOSS"});
    CHECK(std::filesystem::file_size(folder / name) > 1000);
  }
  CHECK(mesh_in(folder / "a.off").face_count() == 178);
}

TEST_CASE("attributes and polylines of a cage that are lost are named") {
  const ScratchFolder folder;
  PolyMesh cage = bolt();
  cage.channels.push_back({"smoothing_group", Domain::Face, 1, std::vector<std::int32_t>(14, 1), {}});
  cage.add_line(std::vector<Index>{0, 1});
  const Json report = subdivided(folder, cage, {});
  REQUIRE(codes_of(report["warnings"]) == Words{"W_CHANNELS"});
  CHECK_THAT(report["warnings"][0]["message"].get<std::string>(),
             Catch::Contains("'smoothing_group'") && Catch::Contains("polylines"));
}

TEST_CASE("convert keeps the tags of an OBJ file, and its order") {
  const ScratchFolder folder;
  PolyMesh cage = bolt_open_chain();
  cage.tags.creases[1].sharpness = 0.1;
  cage.tags.pins = {8, 11};
  const std::string original = folder.write("a.obj", obj_of(cage));
  REQUIRE(run_cli({"convert", original, "-o", folder / "b.obj"}).code == 0);
  CHECK(slurp(folder / "b.obj") == slurp(original));
}

TEST_CASE("every shipped cage subdivides without a word, at every scheme") {
  const std::filesystem::path shipped = std::filesystem::path(CROQUIS_SOURCE_DIR) / "examples/data";
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(shipped)) {
    if (entry.path().extension() != ".obj") continue;
    INFO(entry.path());
    const ScratchFolder folder;
    const ProcessResult result =
        run_cli({"subdivide", entry.path(), "-o", folder / "a.obj", "--levels", "4", "--strict", "--json"});
    CHECK(result.code == 0);
    const Json report = report_of(result);
    CHECK(report["mesh"]["closed"] == true);
    CHECK(report["details"]["levels"][0]["sharp_edges"] > 0);
    CHECK(run_cli({"check", folder / "a.obj"}).code == 0);
    // By Catmull-Clark the surface of this one crosses itself, which is said.
    const bool folds = entry.path().stem() == "bolt_pinned_square";
    const ProcessResult other =
        run_cli({"subdivide", entry.path(), "-o", folder / "b.obj", "--scheme", "catmull-clark", "--json"});
    CHECK(codes_of(report_of(other)["warnings"]) == (folds ? Words{"W_SELF_INTERSECTION"} : Words{}));
    ++count;
  }
  CHECK(count >= 7);
}

}  // namespace
}  // namespace croquis::test

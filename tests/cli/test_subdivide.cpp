// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <tuple>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "cli/process.h"
#include "croquis/geometry/mesh_report.h"
#include "croquis/io/mesh_file.h"
#include "croquis/io/project_file.h"
#include "support/cages.h"
#include "support/mesh_shapes.h"

namespace croquis::test {
namespace {

using Json = nlohmann::json;
using Words = std::vector<std::string>;

std::string obj_of(const PolyMesh& mesh) {
  Progress progress;
  return write_mesh(mesh, MeshFormat::Obj, {}, progress).bytes;
}

PolyMesh mesh_in(const std::string& path) {
  Progress progress;
  return read_mesh(slurp(path), *mesh_format_of(path), path, progress).mesh;
}

/// croquis-tags-1
std::string tags_json(const MeshTags& tags) {
  Json json = {{"format", "croquis-tags-1"}, {"index_base", 0}, {"edges", Json::array()}, {"pins", tags.pins}};
  for (const Crease& crease : tags.creases) {
    const Json sharpness = std::isinf(crease.sharpness) ? Json("inf") : Json(crease.sharpness);
    json["edges"].push_back({{"v", crease.vertices}, {"sharpness", sharpness}});
  }
  return json.dump();
}

Json report_of(const ProcessResult& result) {
  INFO(result.err);
  return Json::parse(result.out);
}

Words codes_of(const Json& findings) {
  Words codes;
  for (const Json& finding : findings) codes.push_back(finding.at("code"));
  return codes;
}

/// Runs `subdivide` on a cage and gives its report; fails the test unless it exits with 0.
Json subdivided(const ScratchFolder& folder, const PolyMesh& cage, const Words& options,
                const std::string& output = "level.obj") {
  Words words = {"subdivide", folder.write("cage.obj", obj_of(cage)), "-o", folder / output, "--json"};
  words.insert(words.end(), options.begin(), options.end());
  const ProcessResult result = run_cli(words);
  INFO(result.err);
  REQUIRE(result.code == 0);
  return Json::parse(result.out);
}

double squares_of(const PolyMesh& mesh) {
  double sum = 0;
  for (const Vec3& position : mesh.positions) sum += position.squaredNorm();
  return sum;
}

/// The first one, positions up to rounding, tags in any order; empty when there is none.
std::string differences(const PolyMesh& a, const PolyMesh& b) {
  if (a.face_offsets != b.face_offsets || a.corners != b.corners) return "faces";
  if (a.vertex_count() != b.vertex_count()) return "vertices";
  for (std::size_t v = 0; v < a.vertex_count(); ++v) {
    if (!a.positions[v].isApprox(b.positions[v], 1e-12) && (a.positions[v] - b.positions[v]).norm() > 1e-12) {
      return "position " + std::to_string(v);
    }
  }
  using Tag = std::tuple<Index, Index, double>;
  const auto tags_of = [](const PolyMesh& mesh) {
    std::set<Tag> tags;
    for (const Crease& crease : mesh.tags.creases) {
      const auto [low, high] = std::minmax(crease.vertices[0], crease.vertices[1]);
      tags.emplace(low, high, crease.sharpness);
    }
    return tags;
  };
  if (tags_of(a) != tags_of(b)) return "sharp edges";
  return std::set(a.tags.pins.begin(), a.tags.pins.end()) == std::set(b.tags.pins.begin(), b.tags.pins.end()) ? ""
                                                                                                              : "pins";
}

/// Whether both have the same points up to rounding and as many faces and tags: the numbering of what follows a file
/// may differ.
bool same_shape(const PolyMesh& a, const PolyMesh& b) {
  const bool same_counts = a.vertex_count() == b.vertex_count() && a.face_count() == b.face_count() &&
                           a.corners.size() == b.corners.size() && a.tags.creases.size() == b.tags.creases.size() &&
                           a.tags.pins.size() == b.tags.pins.size();
  const auto nearest = [&](const Vec3& point) {
    double distance = 1e9;
    for (const Vec3& other : b.positions) distance = std::min(distance, (point - other).squaredNorm());
    return distance;
  };
  return same_counts &&
         std::all_of(a.positions.begin(), a.positions.end(), [&](const Vec3& point) { return nearest(point) < 1e-24; });
}

struct Figures {
  std::array<std::size_t, 4> counts;      ///< vertices, edges, faces, sharp edges
  double paper_squares, refined_squares;  ///< sum of x² + y² + z²
  double paper_volume, refined_volume;
};

struct Table {
  const char* name;
  PolyMesh cage;
  std::vector<Figures> levels;  ///< 1 to 5
  std::array<double, 5> paper_angles, refined_angles;
};

/// From a program of its own that follows the same rules with dictionaries and exact fractions where it can.
std::vector<Table> tables() {
  return {{"bolt with a loop",
           bolt_loop(),
           {{{48, 96, 50, 8}, 226.125, 195.5, 21.747395833, 20.364583333},
            {{176, 352, 178, 16}, 755.179361979, 634.8203125, 20.247599284, 18.778157552},
            {{672, 1344, 674, 32}, 2853.081011454, 2391.210571289, 19.872251948, 18.381401062},
            {{2624, 5248, 2626, 64}, 11196.353925447, 9387.375146866, 19.77651029, 18.282333573},
            {{10368, 20736, 10370, 128}, 44479.997332775, 37305.299606234, 19.752113622, 18.257578436}},
           {75.96, 53.13, 29.74, 14.93, 8.53},
           {75.96, 53.13, 29.74, 14.93, 7.62}},
          {"bolt with an open chain",
           bolt_open_chain(),
           {{{50, 101, 53, 5}, 231.15625, 209.1328125, 21.895833333, 21.276692708},
            {{192, 385, 195, 9}, 790.539550781, 707.389923096, 20.475059191, 19.885532697},
            {{752, 1505, 755, 17}, 3024.564304352, 2706.04689467, 20.135417497, 19.538402686},
            {{2976, 5953, 2979, 33}, 11938.07306549, 10687.385343953, 20.05313804, 19.451670158},
            {{11840, 23681, 11843, 65}, 47547.875980315, 42579.012188193, 20.033344884, 19.429988028}},
           {75.96, 72.44, 73.31, 73.92, 74.95},
           {75.96, 53.13, 31.89, 24.21, 17.66}},
          {"cube with its top's loop",
           cube_top_loop(),
           {{{24, 48, 26, 8}, 42.0, 40.0, 6.333333333, 5.666666667},
            {{80, 160, 82, 16}, 115.076388889, 113.406550069, 5.911132812, 5.192708333},
            {{288, 576, 290, 32}, 381.165045091, 378.906653513, 5.802062882, 5.072998047},
            {{1088, 2176, 1090, 64}, 1386.421233144, 1376.595954399, 5.773605211, 5.043047587},
            {{4224, 8448, 4226, 128}, 5286.145823417, 5235.841674382, 5.766234055, 5.035560211}},
           {45.0, 31.94, 21.9, 14.88, 10.05},
           {63.43, 36.7, 21.87, 12.68, 7.02}}};
}

void check_counts(const Json& level, const std::array<std::size_t, 4>& counts) {
  CHECK(level.at("vertices") == counts[0]);
  CHECK(level.at("edges") == counts[1]);
  CHECK(level.at("faces") == counts[2]);
  CHECK(level.at("sharp_edges") == counts[3]);
  CHECK(level.at("boundary_edges") == 0);
}

TEST_CASE("counts, positions and volumes of every level are those of an independent program, in both presets") {
  for (const Table& table : tables()) {
    for (const std::string preset : {"refined", "paper"}) {
      for (std::size_t k = 1; k <= table.levels.size(); ++k) {
        INFO(table.name << ", " << preset << ", level " << k);
        const ScratchFolder folder;
        const Json report = subdivided(folder, table.cage, {"--preset", preset, "--levels", std::to_string(k)});
        const Figures& figures = table.levels[k - 1];
        const Json& levels = report.at("details").at("levels");
        REQUIRE(levels.size() == k + 1);
        CHECK(levels[0].at("vertices") == table.cage.vertex_count());
        CHECK(levels[0].at("sharp_edges") == table.cage.tags.creases.size());
        for (std::size_t i = 1; i <= k; ++i) check_counts(levels[i], table.levels[i - 1].counts);
        const bool paper = preset == "paper";
        CHECK(report.at("mesh").at("volume").get<double>() ==
              Approx(paper ? figures.paper_volume : figures.refined_volume).epsilon(1e-8));
        CHECK(report.at("mesh").at("vertices") == figures.counts[0]);
        CHECK(report.at("warnings").empty());
        const PolyMesh mesh = mesh_in(folder / "level.obj");
        CHECK(squares_of(mesh) == Approx(paper ? figures.paper_squares : figures.refined_squares).epsilon(1e-8));
        CHECK(mesh.tags.creases.size() == figures.counts[3]);
      }
    }
  }
}

TEST_CASE("the report tells chains with their angles, and the largest angle across untagged edges of each level") {
  for (const Table& table : tables()) {
    for (const bool paper : {false, true}) {
      INFO(table.name << (paper ? ", paper" : ", refined"));
      const ScratchFolder folder;
      const Json report = subdivided(folder, table.cage, {"--preset", paper ? "paper" : "refined", "--levels", "5"});
      const Json& continuity = report.at("details").at("continuity");
      REQUIRE(continuity.size() == 6);
      const auto& angles = paper ? table.paper_angles : table.refined_angles;
      for (std::size_t k = 1; k <= 5; ++k) CHECK(continuity[k].get<double>() == Approx(angles[k - 1]).margin(0.006));
      const Json& chains = report.at("details").at("chains");
      REQUIRE(chains.size() == 1);
      CHECK(chains[0].at("edges") == table.levels[4].counts[3]);
      CHECK(chains[0].at("closed") == (table.cage.tags.creases.size() == 4));
    }
  }
  const ScratchFolder folder;
  for (const std::string preset : {"refined", "paper"}) {
    const Json report = subdivided(folder, bolt_loop(), {"--preset", preset, "--levels", "4"});
    const Json& chain = report.at("details").at("chains")[0];
    CHECK(chain.at("dihedral_min").get<double>() == Approx(90).margin(1e-9));
    CHECK(chain.at("dihedral_max").get<double>() == Approx(90).margin(1e-9));
  }
}

TEST_CASE("single switches change one rule each, and naming the preset's own changes nothing") {
  const ScratchFolder folder;
  const auto bytes = [&](const Words& options) {
    subdivided(folder, bolt_open_chain(), options);
    return slurp(folder / "level.obj");
  };
  const std::string refined = bytes({});
  CHECK(bytes({"--preset", "refined", "--weights", "classical", "--profile", "clamped", "--chain-ends", "smooth",
               "--boundary-corners", "corner", "--scheme", "doo-sabin", "--levels", "2"}) == refined);
  const std::string paper = bytes({"--preset", "paper"});
  CHECK(bytes({"--weights", "average", "--profile", "plain", "--chain-ends", "retract"}) == paper);
  CHECK(bytes({"--preset", "paper", "--weights", "classical", "--profile", "clamped", "--chain-ends", "smooth"}) ==
        refined);
  std::set<std::string> seen = {refined, paper};
  for (const Words& options :
       {Words{"--weights", "average"}, {"--profile", "plain"}, {"--chain-ends", "retract"}, {"--chain-ends", "pin"}}) {
    INFO(options[0] << " " << options[1]);
    CHECK(seen.insert(bytes(options)).second);
  }
  const PolyMesh open = grid(3, 2);
  subdivided(folder, open, {});
  const std::string corners = slurp(folder / "level.obj");
  subdivided(folder, open, {"--boundary-corners", "smooth"});
  CHECK(slurp(folder / "level.obj") != corners);
}

TEST_CASE("tags of a JSON file do the same as tags of the OBJ file, and count before them") {
  const ScratchFolder folder;
  PolyMesh plain = bolt();
  subdivided(folder, bolt_loop(), {});
  const std::string expected = slurp(folder / "level.obj");
  const std::string tags = folder.write("tags.json", tags_json(bolt_loop().tags));
  subdivided(folder, plain, {"--tags", tags});
  CHECK(slurp(folder / "level.obj") == expected);
  plain.tags.creases = {{{9, 8}, 0.5}};  // the file's infinite one counts
  subdivided(folder, plain, {"--tags", tags});
  CHECK(slurp(folder / "level.obj") == expected);
  plain.tags.creases = {{{8, 9}, infinite_sharpness}, {{9, 10}, infinite_sharpness}};
  const MeshTags rest{{{{10, 11}, infinite_sharpness}, {{11, 8}, infinite_sharpness}}, {}, {}};
  subdivided(folder, plain, {"--tags", folder.write("rest.json", tags_json(rest))});
  CHECK(slurp(folder / "level.obj") == expected);
  const ProcessResult piped = run_cli(
      {"subdivide", folder.write("plain.obj", obj_of(bolt())), "-o", "-", "--output-format", "obj", "--tags", "-"},
      {.standard_input = tags_json(bolt_loop().tags)});
  CHECK(piped.code == 0);
  CHECK(piped.out == expected);
}

TEST_CASE("the tags that are left come out in both forms, and subdividing goes on where it stopped") {
  PolyMesh pinned = bolt_loop();
  pinned.tags.pins = {8, 9, 10, 11};
  const std::vector<VertexPair> half = {{6, 7}, {7, 8}};
  for (const auto& cage : {bolt_loop(), bolt_open_chain(), pinned, tagged(hex_bolt(), half, 2.5), grid(3, 2)}) {
    const ScratchFolder folder;
    subdivided(folder, cage, {"--levels", "3"}, "three.obj");
    subdivided(folder, cage, {"--levels", "1", "--tags-out", folder / "left.json"}, "one.obj");
    const PolyMesh one = mesh_in(folder / "one.obj");
    subdivided(folder, one, {"--levels", "2"}, "again.obj");
    CHECK(same_shape(mesh_in(folder / "again.obj"), mesh_in(folder / "three.obj")));

    PolyMesh bare = one;
    bare.tags = {};  // which corners are settled stays
    subdivided(folder, bare, {"--levels", "2", "--tags", folder / "left.json"}, "again.obj");
    CHECK(same_shape(mesh_in(folder / "again.obj"), mesh_in(folder / "three.obj")));
    const Json left = Json::parse(slurp(folder / "left.json"));
    CHECK(left.at("format") == "croquis-tags-1");
    REQUIRE(left.at("edges").size() == one.tags.creases.size());
    for (std::size_t i = 0; i < one.tags.creases.size(); ++i) {
      CHECK(left["edges"][i]["v"] == Json(one.tags.creases[i].vertices));
    }
  }
}

TEST_CASE("sharp angles tag what has no tag of its own") {
  const ScratchFolder folder;
  const auto sharp_edges = [&](const PolyMesh& cage, const std::string& angle) {
    return subdivided(folder, cage, {"--sharp-angle", angle})["details"]["levels"][0]["sharp_edges"].get<int>();
  };
  CHECK(sharp_edges(centred_cube(), "0") == 0);
  CHECK(sharp_edges(centred_cube(), "89") == 12);
  CHECK(sharp_edges(centred_cube(), "91") == 0);
  CHECK(sharp_edges(icosahedron(), "41") == 30);  // 41.81 degrees
  CHECK(sharp_edges(icosahedron(), "42") == 0);
  CHECK(sharp_edges(grid(3, 3), "1") == 0);
  const PolyMesh soft = tagged(centred_cube(), std::vector<VertexPair>{{4, 5}}, 0.5);
  const Json report = subdivided(folder, soft, {"--sharp-angle", "60", "--levels", "0"});
  CHECK(report["details"]["levels"][0]["sharp_edges"] == 12);
  const PolyMesh out = mesh_in(folder / "level.obj");
  CHECK(std::count_if(out.tags.creases.begin(), out.tags.creases.end(),
                      [](const Crease& crease) { return crease.sharpness == 0.5; }) == 1);
  CHECK(run_cli({"subdivide", folder / "cage.obj", "-o", folder / "a.obj", "--sharp-angle", "181"}).code == 2);
}

TEST_CASE("kinks of chains are kept on request, as pins would") {
  const ScratchFolder folder;
  PolyMesh pinned = bolt_loop();
  pinned.tags.pins = {8, 9, 10, 11};
  subdivided(folder, pinned, {"--levels", "3"});
  const std::string expected = slurp(folder / "level.obj");
  subdivided(folder, bolt_loop(), {"--levels", "3", "--keep-kinks", "45"});
  CHECK(slurp(folder / "level.obj") == expected);
  subdivided(folder, bolt_loop(), {"--levels", "3", "--keep-kinks", "91"});
  const std::string smooth = slurp(folder / "level.obj");
  CHECK(smooth != expected);
  subdivided(folder, bolt_loop(), {"--levels", "3"});
  CHECK(slurp(folder / "level.obj") == smooth);
}

TEST_CASE("outputs beside the mesh are written without it when only they are asked for") {
  const ScratchFolder folder;
  const std::string cage = folder.write("cage.obj", obj_of(bolt_loop()));
  const ProcessResult result =
      run_cli({"subdivide", cage, "--chains", folder / "chains.obj", "--tags-out", folder / "left.json"});
  CHECK(result.code == 0);
  CHECK(folder.names() == Words{"cage.obj", "chains.obj", "left.json"});
  CHECK(run_cli({"subdivide", cage}).code == 2);
  CHECK(run_cli({"subdivide", cage, "-o", folder / "a.obj", "--chains", folder / "a.obj"}).code == 2);
}

TEST_CASE("all schemes double the edges of closed chains, and keep a cube of sharp edges") {
  for (const std::string scheme : {"doo-sabin", "catmull-clark", "loop"}) {
    INFO(scheme);
    const ScratchFolder folder;
    const Json report = subdivided(folder, bolt_loop(), {"--scheme", scheme, "--levels", "3"});
    std::size_t sharp = 4;
    for (const Json& level : report["details"]["levels"]) {
      CHECK(level["sharp_edges"] == sharp);
      sharp *= 2;
    }
    subdivided(folder, cube_all_sharp(), {"--scheme", scheme, "--levels", "2", "--limit"});
    for (const Vec3& position : mesh_in(folder / "level.obj").positions) {
      CHECK(position.cwiseAbs().maxCoeff() == Approx(1).margin(1e-12));
    }
  }
  const ScratchFolder folder;
  const Json loop = subdivided(folder, bolt_loop(), {"--scheme", "loop"});
  CHECK(codes_of(loop["warnings"]) == Words{"W_TRIANGULATED"});
  CHECK(loop["details"]["levels"][0]["faces"] == 28);
}

TEST_CASE("with --limit vertices lie where endless refinement takes them") {
  const ScratchFolder folder;
  subdivided(folder, bolt(), {"--levels", "1", "--limit"});
  const PolyMesh limit = mesh_in(folder / "level.obj");
  CHECK(limit.channel("normal", Domain::Vertex) != nullptr);  // without sharp edges the corners of a vertex agree
  subdivided(folder, bolt(), {"--levels", "6"});
  const PolyMesh fine = mesh_in(folder / "level.obj");
  for (const Vec3& point : limit.positions) {
    double nearest = 1e9;
    for (const Vec3& other : fine.positions) nearest = std::min(nearest, (point - other).norm());
    CHECK(nearest < 0.06);  // faces of level 6 are about 0.06 across
  }
}

TEST_CASE("level 0 is the cage, and provenance is attached on request") {
  const ScratchFolder folder;
  subdivided(folder, bolt_loop(), {"--levels", "0"});
  CHECK(differences(mesh_in(folder / "level.obj"), bolt_loop()) == "");
  subdivided(folder, bolt_loop(), {"--levels", "2", "--provenance"}, "level.ply");
  const PolyMesh mesh = mesh_in(folder / "level.ply");
  CHECK(mesh.channel("cage_vertex", Domain::Vertex) != nullptr);
  CHECK(mesh.channel("cage_element", Domain::Face) != nullptr);
}

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
  CHECK(warnings(tagged(bolt(), std::vector<VertexPair>{{8, 9}}), {"--chain-ends", "retract"}) ==
        Words{"W_TAG_VANISHES"});
  PolyMesh folded = single_face(5);
  folded.positions[0] =
      (folded.positions[2] + folded.positions[3]) / 2 + (folded.positions[2] - folded.positions[0]) / 9;
  CHECK(warnings(folded) == Words{"W_MAY_FOLD"});
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
           {std::string(100, '['), "64 levels"}}) {
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

TEST_CASE("a project subdivides its cage as the command does") {
  const ScratchFolder folder;
  Node cage;
  cage.name = "cage";
  cage.visible = false;
  cage.source = std::make_shared<const PolyMesh>(bolt_loop());
  Node node;
  node.name = "smooth";
  node.operation = "subdivide";
  node.parameters["levels"] = std::int64_t{3};
  node.inputs["cage"] = {1, "value"};
  Progress progress;
  save_project(folder / "a.croq", {Document().with(cage).with(node), {}, {}}, progress);
  const ProcessResult result = run_cli({"run", folder / "a.croq", "-o", folder / "run.obj", "--json"});
  REQUIRE(result.code == 0);
  CHECK(report_of(result)["details"]["nodes"][0]["details"]["levels"].size() == 4);
  subdivided(folder, bolt_loop(), {"--levels", "3"});
  CHECK(slurp(folder / "run.obj") == slurp(folder / "level.obj"));
  subdivided(folder, bolt_loop(), {"--levels", "1", "--scheme", "catmull-clark"});
  REQUIRE(run_cli({"run", folder / "a.croq", "-o", folder / "run.obj", "--set", "smooth.levels=1", "--set",
                   "smooth.scheme=catmull-clark"})
              .code == 0);
  CHECK(slurp(folder / "run.obj") == slurp(folder / "level.obj"));
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
    CHECK(run_cli({"subdivide", entry.path(), "-o", folder / "b.obj", "--scheme", "catmull-clark", "--strict"}).code ==
          0);
    ++count;
  }
  CHECK(count >= 7);
}

}  // namespace
}  // namespace croquis::test

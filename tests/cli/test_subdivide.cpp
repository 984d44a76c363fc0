// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <set>

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

double squares_of(const PolyMesh& mesh) {
  double sum = 0;
  for (const Vec3& position : mesh.positions) sum += position.squaredNorm();
  return sum;
}

/// Each face as a fan about the mean of its corners, as the independent program has it.
double volume_about_centres(const PolyMesh& mesh) {
  double volume = 0;
  for (Index f = 0; f < mesh.face_count(); ++f) {
    const auto face = mesh.face(f);
    Vec3 centre = Vec3::Zero();
    for (const Index vertex : face) centre += mesh.positions[vertex] / static_cast<double>(face.size());
    for (std::size_t k = 0; k < face.size(); ++k) {
      volume += centre.dot(mesh.positions[face[k]].cross(mesh.positions[face[(k + 1) % face.size()]])) / 6;
    }
  }
  return volume;
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
        CHECK(report.at("mesh").at("vertices") == figures.counts[0]);
        CHECK(report.at("warnings").empty());
        const PolyMesh mesh = mesh_in(folder / "level.obj");
        CHECK(volume_about_centres(mesh) ==
              Approx(paper ? figures.paper_volume : figures.refined_volume).epsilon(1e-8));
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

TEST_CASE("level 0 is the cage, and provenance is attached on request") {
  const ScratchFolder folder;
  subdivided(folder, bolt_loop(), {"--levels", "0"});
  CHECK(differences(mesh_in(folder / "level.obj"), bolt_loop()) == "");
  subdivided(folder, bolt_loop(), {"--levels", "2", "--provenance"}, "level.ply");
  const PolyMesh mesh = mesh_in(folder / "level.ply");
  CHECK(mesh.channel("cage_vertex", Domain::Vertex) != nullptr);
  CHECK(mesh.channel("cage_element", Domain::Face) != nullptr);
}

}  // namespace
}  // namespace croquis::test

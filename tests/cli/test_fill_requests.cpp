// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "cli/process.h"
#include "cli/scan_files.h"
#include "support/meshes/mesh_shapes.h"
#include "support/sanitizers.h"
#include "support/scans/scans.h"

namespace croquis::test {
namespace {

std::string method_of(const Json& report, std::size_t hole) { return report["details"]["holes"][hole]["method"]; }

/// The greatest distance of new vertices from the centre of a sphere.
double farthest_new_vertex(const std::string& path, std::size_t given) {
  const PolyMesh mesh = mesh_in(path);
  double distance = 0;
  for (std::size_t v = given; v < mesh.vertex_count(); ++v) distance = std::max(distance, mesh.positions[v].norm());
  return distance;
}

TEST_CASE("requests for single holes go before what is said for all") {
  const ScratchFolder folder;
  const std::string input = folder.write("scan.ply", ply_of(holed_scan()));
  const Json asked = filled(input, folder / "a.ply", {"--holes", "0: leave; 1: flat", "--holes", "2: smooth"});
  CHECK(holes_with(asked, "leave") == std::set<int>{0});
  CHECK(method_of(asked, 1) == "minimal");
  CHECK(method_of(asked, 2) == "cgal-c1");
  CHECK(asked["details"]["holes"][0]["reason"] == "asked to stay open");
  const Json one = filled(input, folder / "b.ply", {"--select", "none", "--holes", "2: fill"});
  CHECK(holes_with(one, "fill") == std::set<int>{2});
  CHECK(one["details"]["closed_rims"] == 1);
  filled(input, folder / "c.ply", {"--select", "none"});
  CHECK(slurp(folder / "c.ply") == slurp(input));
  for (const char* wrong : {"0", "x: fill", "9: fill", "0: melt", "0: bulge 3", "1: bridge", "0: through 1 2"}) {
    INFO(wrong);
    const ProcessResult refused = run_cli({"fill", input, "-o", folder / "out.ply", "--holes", wrong, "--json"});
    CHECK(refused.code == 2);
    CHECK(Json::parse(refused.out)["error"]["code"] == "E_PARAMETER");
  }
  const ProcessResult many =
      run_cli({"fill", input, "-o", folder / "out.ply", "--holes", "0: a, b; c: fill", "--json"});
  CHECK(Json::parse(many.out)["errors"].size() == 3);
}

TEST_CASE("rims are written as closed polylines in the order of their numbers") {
  const ScratchFolder folder;
  const std::string input = folder.write("scan.ply", ply_of(holed_scan()));
  const Json report = filled(input, folder / "out.ply", {"--rims", folder / "rims.obj"});
  const Json& holes = report["details"]["holes"];
  std::istringstream lines(slurp(folder / "rims.obj"));
  std::vector<Vec3> positions;
  std::size_t hole = 0;
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string kind;
    words >> kind;
    CHECK(kind != "f");
    if (kind == "v") {
      Vec3 p;
      words >> p.x() >> p.y() >> p.z();
      positions.push_back(p);
    } else if (kind == "l") {
      REQUIRE(hole < holes.size());
      std::vector<std::size_t> rim;
      for (std::size_t v = 0; words >> v;) rim.push_back(v - 1);
      CHECK(rim.front() == rim.back());
      CHECK(rim.size() == holes[hole]["boundary_edges"].get<std::size_t>() + 1);
      double length = 0;
      for (std::size_t j = 1; j < rim.size(); ++j) length += (positions.at(rim[j]) - positions.at(rim[j - 1])).norm();
      CHECK(length == Approx(holes[hole]["perimeter"].get<double>()));
      ++hole;
    }
  }
  CHECK(hole == holes.size());
}

TEST_CASE("a positive bulge turns patches outwards, a negative one inwards") {
  const ScratchFolder folder;
  const std::string input = folder.write("scan.ply", ply_of(holed_sphere()));
  const std::size_t given = holed_sphere().vertex_count();
  filled(input, folder / "plain.ply");
  filled(input, folder / "out.ply", {"--bulge", "0.5"});
  filled(input, folder / "in.ply", {"--holes", "0: bulge -0.5"});
  const double plain = farthest_new_vertex(folder / "plain.ply", given);
  CHECK(farthest_new_vertex(folder / "out.ply", given) > plain + 0.02);
  CHECK(farthest_new_vertex(folder / "in.ply", given) <= plain + 1e-3);
  CHECK(run_cli({"fill", input, "-o", folder / "x.ply", "--bulge", "1.5"}).code == 2);
}

TEST_CASE("trimming takes faces along the rims, and says how many") {
  const ScratchFolder folder;
  const std::string input = folder.write("scan.ply", ply_of(holed_sphere()));
  const PolyMesh given = holed_sphere();
  const Json report = filled(input, folder / "out.ply", {"--trim-rim", "2"});
  const Json& details = report["details"];
  const auto removed = details["removed_faces"].get<std::size_t>();
  CHECK(removed > 0);
  CHECK(report["mesh"]["faces"] == given.face_count() - removed + details["new_faces"].get<std::size_t>());
  CHECK(details["untouched_vertices"].get<std::size_t>() < given.vertex_count());
  CHECK(details["checks"]["outside_unchanged"] == true);
  CHECK(report["mesh"]["closed"] == true);
  const Json untrimmed = filled(input, folder / "out.ply", {"--trim-rim", "2", "--holes", "0: trim 0"});
  CHECK(untrimmed["details"]["removed_faces"] == 0);
  CHECK(run_cli({"fill", input, "-o", folder / "x.ply", "--trim-rim", "4"}).code == 2);
}

TEST_CASE("every kernel and preset closes the sphere, each in its way") {
  const ScratchFolder folder;
  const std::string input = folder.write("scan.ply", ply_of(holed_sphere()));
  std::set<std::string> files;
  for (const char* kernel : {"hermite", "triharmonic", "biharmonic", "thin-plate"}) {
    CHECK(filled(input, folder / "out.ply", {"--kernel", kernel})["mesh"]["closed"] == true);
    files.insert(slurp(folder / "out.ply"));
  }
  CHECK(files.size() == 4);
  for (const char* preset : {"auto", "standard", "paper", "sharp", "noisy"}) {
    const Json report = filled(input, folder / "out.ply", {"--preset", preset});
    CHECK(report["mesh"]["closed"] == true);
    CHECK(report["details"]["holes"][0]["error_estimate"].is_number() == (std::string(preset) == "sharp"));
  }
}

TEST_CASE("files are the same for any number of threads") {
  const ScratchFolder folder;
  const std::string input = folder.write("scan.ply", ply_of(random_cuts(round_sphere(4), 3, 6, 0.1, 0.25).mesh));
  filled(input, folder / "1.ply", {"--threads", "1"});
  for (const char* threads : {"2", "8"}) {
    filled(input, folder / "n.ply", {"--threads", threads});
    CHECK(slurp(folder / "n.ply") == slurp(folder / "1.ply"));
  }
}

TEST_CASE("vertices tell how well patches are backed, in files that can hold it") {
  const ScratchFolder folder;
  const std::string input = folder.write("scan.ply", ply_of(holed_sphere()));
  filled(input, folder / "out.ply", {"--strict"});
  const PolyMesh mesh = mesh_in(folder / "out.ply");
  const AttributeChannel* channel = mesh.channel("confidence", Domain::Vertex);
  REQUIRE(channel != nullptr);
  const auto& values = std::get<std::vector<float>>(channel->data);
  const std::size_t given = holed_sphere().vertex_count();
  for (std::size_t v = 0; v < values.size(); ++v) {
    CHECK((v < given) == (values[v] == 1.0F));
    CHECK(values[v] > 0);
  }
  filled(input, folder / "out.obj", {"--strict"});
  filled(input, folder / "plain.ply", {"--patch-ids=false"});
  CHECK(mesh_in(folder / "plain.ply").channel("confidence", Domain::Vertex) == nullptr);
}

TEST_CASE("a model made anew is closed, and tells its domains") {
  const ScratchFolder folder;
  const std::string input = folder.write("scan.ply", ply_of(holed_sphere()));
  const Json report = filled(input, folder / "out.ply", {"--mode", "remesh"});
  const Json& details = report["details"];
  CHECK(report["mesh"]["closed"] == true);
  CHECK(report["mesh"]["self_intersections"] == 0);
  CHECK(report["mesh"]["genus"] == 0);
  CHECK(details["untouched_vertices"] == 0);
  CHECK(details["domains"].get<int>() > 1);
  CHECK(details["points_per_domain"]["min"] <= details["points_per_domain"]["median"]);
  CHECK(details["points_per_domain"]["median"] <= details["points_per_domain"]["max"]);
  CHECK(details["new_faces"] == report["mesh"]["faces"]);
  CHECK(holes_with(report, "fill") == std::set<int>{0});
  CHECK(details["checks"]["open_loops"] == 0);
  CHECK(details["checks"]["far_from_scan"].get<double>() < 0.01);
  const Json fine = filled(input, folder / "fine.ply",
                           {"--mode", "remesh", "--cell", "0.7", "--points-per-domain", "20:200", "--overlap", "0.3"});
  CHECK(fine["details"]["new_faces"].get<int>() > details["new_faces"].get<int>());
  CHECK(fine["details"]["points_per_domain"]["max"].get<int>() <= 200);
  const Json refined = filled(input, folder / "four.ply", {"--mode", "remesh", "--refine", "1", "--smoothing", "1"});
  CHECK(refined["details"]["new_faces"].get<int>() > 3 * details["new_faces"].get<int>());
  for (const char* wrong : {"30", "30:20", "2:30", "30:3000", "a:b", ":"}) {
    INFO(wrong);
    CHECK(run_cli({"fill", input, "-o", folder / "x.ply", "--mode", "remesh", "--points-per-domain", wrong}).code == 2);
  }
}

TEST_CASE("a model made anew has fewer faces where it is flat, if so asked") {
  const ScratchFolder folder;
  const PolyMesh box = random_cuts(divided_box(20), 1, 2, 0.1, 0.2).mesh;
  const std::string input = folder.write("scan.ply", ply_of(box));
  const Json full = filled(input, folder / "full.ply", {"--mode", "remesh"});
  filled(input, folder / "none.ply", {"--mode", "remesh", "--adaptive", "0"});
  CHECK(slurp(folder / "none.ply") == slurp(folder / "full.ply"));
  const Json report = filled(input, folder / "out.ply", {"--mode", "remesh", "--adaptive", "0.1"});
  const Json& details = report["details"];
  CHECK(report["mesh"]["closed"] == true);
  CHECK(report["mesh"]["self_intersections"] == 0);
  CHECK(report["mesh"]["euler_characteristic"] == 2);
  CHECK(details["full_faces"] == full["details"]["new_faces"]);
  CHECK(details["new_faces"] == report["mesh"]["faces"]);
  CHECK(4 * details["new_faces"].get<int>() < details["full_faces"].get<int>());
  CHECK(details["new_faces"].get<int>() < details["predicted_faces"].get<int>());
  CHECK(mesh_in(folder / "out.ply").channel("patch_id", Domain::Face) != nullptr);
}

TEST_CASE("parameters that the mode doesn't look at are told") {
  const ScratchFolder folder;
  const std::string input = folder.write("scan.ply", ply_of(holed_sphere()));
  const Json patched = filled(input, folder / "a.ply", {"--cell", "0.5", "--refine", "1", "--adaptive", "0.1"});
  CHECK(codes_of(patched["warnings"]) == Words{"W_PARAMETER_UNUSED"});
  CHECK(patched["warnings"][0]["subject"].size() == 3);
  const Json remeshed = filled(input, folder / "b.ply", {"--mode", "remesh", "--bulge", "0.2"});
  CHECK(codes_of(remeshed["warnings"]) == Words{"W_PARAMETER_UNUSED"});
}

TEST_CASE("what would take more memory than allowed is refused with an estimate, in both modes") {
  const ScratchFolder folder;
  const std::string input = folder.write("scan.ply", ply_of(round_sphere(5)));
  for (const Words& limit : {Words{"--memory-limit", "5"}, Words{"--max-memory", "20M"}}) {
    if (is_sanitized && limit[0] == "--max-memory") continue;
    for (const char* mode : {"patch", "remesh"}) {
      INFO(limit[0] << " " << mode);
      const ProcessResult result =
          run_cli({"fill", input, "-o", folder / "out.ply", "--mode", mode, limit[0], limit[1], "--json"});
      CHECK(result.code == 5);
      const Json error = Json::parse(result.out)["error"];
      CHECK(error["code"] == "E_MEMORY");
      if (limit[0] == "--memory-limit") CHECK(error["message"].get<std::string>().find("about") != std::string::npos);
    }
  }
  CHECK(folder.names() == Words{"scan.ply"});
  CHECK(run_cli({"fill", input, "-o", folder / "out.ply", "--memory-limit", "200"}).code == 0);
}

TEST_CASE("progress counts the patches; stages in the report are told without counts") {
  const ScratchFolder folder;
  const std::string input = folder.write("scan.ply", ply_of(holed_scan()));
  const ProcessResult result = run_cli({"fill", input, "-o", folder / "out.ply", "--progress", "json", "--json"});
  CHECK(result.code == 0);
  CHECK(result.err.find("make patches 4 of 4") != std::string::npos);
  std::set<std::string> names;
  const Json report = Json::parse(result.out);
  for (const Json& stage : report["stages"]) CHECK(names.insert(stage["name"]).second);
  CHECK(names.contains("make patches"));
  CHECK(std::none_of(names.begin(), names.end(), [](const std::string& n) { return n.find(" of ") != n.npos; }));
}

TEST_CASE("what can't be remeshed is refused with its reason, beside other pieces by a warning") {
  const ScratchFolder folder;
  // A plate thinner than its own edges: the surface through it would lie far from it.
  const PolyMesh plate = transformed(divided_box(36), Eigen::Affine3d(Eigen::Scaling(1.0, 1.0, 0.15 / 36)));
  const std::string alone = folder.write("plate.ply", ply_of(plate));
  const ProcessResult refused = run_cli({"fill", alone, "-o", folder / "a.ply", "--mode", "remesh", "--json"});
  CHECK(refused.code == 4);
  CHECK(Json::parse(refused.out).at("error").at("code") == "E_NOT_REMESHED");
  CHECK(refused.err.find("E_NOT_REMESHED") != std::string::npos);
  CHECK(folder.names() == Words{"plate.ply"});
  const PolyMesh ball = translated(round_sphere(4), Vec3(3, 0, 0));
  const std::string both = folder.write("both.ply", ply_of(merged(plate, ball)));
  const Words told = codes_of(filled(both, folder / "b.ply", {"--mode", "remesh"}).at("warnings"));
  const auto tells = [&](const char* code) { return std::find(told.begin(), told.end(), code) != told.end(); };
  CHECK((tells("W_PIECE_REFUSED") || tells("W_PIECE_LOST")));
  CHECK(run_cli({"check", folder / "b.ply"}).code == 0);
}

}  // namespace
}  // namespace croquis::test

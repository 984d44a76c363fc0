// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <set>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "cli/process.h"
#include "cli/scan_files.h"
#include "croquis/io/project_file.h"
#include "support/meshes/mesh_shapes.h"
#include "support/scans/scans.h"

namespace croquis::test {
namespace {

bool warns(const Json& report, const std::string& code) {
  const Words codes = codes_of(report.at("warnings"));
  return std::find(codes.begin(), codes.end(), code) != codes.end();
}

Words keys_of(const Json& object) {
  Words keys;
  for (const auto& [key, value] : object.items()) keys.push_back(key);
  std::sort(keys.begin(), keys.end());
  return keys;
}

TEST_CASE("the JSON report has exactly the keys that scripts rely on") {
  const ScratchFolder folder;
  PolyMesh open = merged(holed_sphere(), translated(sheet(6, 6), Vec3(5, 0, 0)));
  const Json report = filled(folder.write("scan.ply", ply_of(open)), folder / "out.ply");
  CHECK(keys_of(report) == Words{"command", "details", "input", "mesh", "output", "peak_memory_bytes", "seconds",
                                 "stages", "version", "warnings"});
  CHECK(report["command"] == "fill");
  const Json& details = report["details"];
  CHECK(keys_of(details) == Words{"added_self_intersections", "checks", "closed_rims", "domains", "holes", "new_faces",
                                  "new_vertices", "open_edges", "points_per_domain", "removed_faces", "summary",
                                  "untouched_vertices"});
  CHECK(details["checks"] == Json{{"outside_unchanged", true}});
  CHECK(details["closed_rims"] == 1);
  REQUIRE(details["holes"].size() == 2);
  for (const Json& hole : details["holes"]) {
    CHECK(keys_of(hole) == Words{"action", "area", "at", "boundary_edges", "class", "companions", "confidence",
                                 "diameter", "error_estimate", "id", "max_normal_jump", "method", "normal", "patch",
                                 "perimeter", "reason"});
  }
  const Json& sphere = details["holes"][0];
  CHECK(sphere["id"] == 0);
  CHECK(sphere["class"] == "simple");
  CHECK(sphere["action"] == "fill");
  CHECK(sphere["method"].is_string());
  CHECK(sphere["reason"].is_null());
  CHECK(sphere["max_normal_jump"].get<double>() > 0);
  CHECK(sphere["confidence"].get<double>() > 0.3);
  CHECK(sphere["confidence"].get<double>() <= 1);
  // The cut lies 0.4 from the pole: no wider than its circle, and wider than half of it.
  CHECK(sphere["diameter"].get<double>() < 0.8);
  CHECK(sphere["diameter"].get<double>() > 0.4);
  CHECK(sphere["perimeter"].get<double>() > 2 * sphere["diameter"].get<double>());
  CHECK(sphere["area"].get<double>() < 0.4 * 0.4 * 3.15);
  const Json& border = details["holes"][1];
  CHECK(border["class"] == "OUTER");
  CHECK(border["action"] == "leave");
  CHECK(border["method"].is_null());
  CHECK(border["reason"].is_string());
  CHECK(border["max_normal_jump"].is_null());
  CHECK(border["confidence"].is_null());
  CHECK(border["boundary_edges"] == 24);
  CHECK(border["perimeter"].get<double>() == Approx(24));
  CHECK(border["diameter"].get<double>() == Approx(6 * std::sqrt(2.0)));
  CHECK(border["area"].get<double>() == Approx(36));
  CHECK(details["domains"] == 1);
  CHECK(details["points_per_domain"]["median"] > 10);
  CHECK(details["untouched_vertices"] == open.vertex_count());
  CHECK(report["mesh"]["faces"] == open.face_count() + details["new_faces"].get<std::size_t>());
  CHECK(report["mesh"]["self_intersections"] == 0);
  CHECK(warns(report, "W_OUTER_LEFT"));
}

TEST_CASE("the list shows every hole to people and scripts, needs no output and writes none") {
  const ScratchFolder folder;
  const std::string input = folder.write("scan.ply", ply_of(holed_scan()));
  const ProcessResult table = run_cli({"fill", input, "--list"});
  CHECK(table.code == 0);
  CHECK(table.out.starts_with("5 holes: 5 to be filled, 0 left open.\nid  class"));
  CHECK(std::count(table.out.begin(), table.out.end(), '\n') == 7);
  const ProcessResult result = run_cli({"fill", input, "--list", "--json", "-o", folder / "out.ply"});
  CHECK(result.code == 0);
  Json listed = Json::parse(result.out)["details"]["holes"];
  CHECK(folder.names() == Words{"scan.ply"});
  Json done = filled(input, folder / "out.ply")["details"]["holes"];
  REQUIRE(done.size() == listed.size());
  for (std::size_t i = 0; i < done.size(); ++i) {
    for (const char* key : {"method", "max_normal_jump", "confidence", "patch"}) {
      CHECK(listed[i][key].is_null());
      CHECK_FALSE(done[i][key].is_null());
      done[i].erase(key);
      listed[i].erase(key);
    }
    CHECK(done[i] == listed[i]);
  }
  const std::string whole = folder.write("whole.ply", ply_of(round_sphere(2)));
  CHECK(run_cli({"fill", whole, "--list"}).out == "No holes.\n");
}

TEST_CASE("holes are chosen by kind, by number and by diameter") {
  const ScratchFolder folder;
  const std::string tube = folder.write("tube.obj", bytes_of(open_tube(1, 4, 24, 12), MeshFormat::Obj));
  const Json inner = filled(tube, folder / "a.obj");
  CHECK(holes_with(inner, "leave") == std::set<int>{0, 1});
  CHECK(slurp(folder / "a.obj") == slurp(tube));
  CHECK(filled(tube, folder / "a.obj", {"--select", "all"})["mesh"]["closed"] == true);
  CHECK(holes_with(filled(tube, folder / "a.obj", {"--select", "all-but-largest"}), "fill").size() == 1);
  CHECK(holes_with(filled(tube, folder / "a.obj", {"--only", "1"}), "fill") == std::set<int>{1});
  CHECK(holes_with(filled(tube, folder / "a.obj", {"--only", "0,1"}), "fill") == std::set<int>{0, 1});
  CHECK(holes_with(filled(tube, folder / "a.obj", {"--only", "0", "--only", "1"}), "fill") == std::set<int>{0, 1});
  // The rims are circles of radius 1, corners opposite each other.
  CHECK(holes_with(filled(tube, folder / "a.obj", {"--select", "all", "--max-diameter", "1.9"}), "fill").empty());
  CHECK(holes_with(filled(tube, folder / "a.obj", {"--select", "all", "--max-diameter", "2.1"}), "fill").size() == 2);
}

TEST_CASE("flat patches have no new vertices, smooth ones are nearer to the sphere, fitted ones nearest") {
  const ScratchFolder folder;
  const std::string input = folder.write("scan.ply", ply_of(holed_sphere()));
  const Json flat = filled(input, folder / "flat.ply", {"--fairness", "flat"});
  const Json smooth = filled(input, folder / "smooth.ply", {"--fairness", "smooth"});
  const Json fitted = filled(input, folder / "rbf.ply", {"--fairness", "rbf"});
  CHECK(flat["details"]["new_vertices"] == 0);
  CHECK(flat["details"]["holes"][0]["method"] == "minimal");
  CHECK(smooth["details"]["new_vertices"] > 0);
  CHECK(smooth["details"]["holes"][0]["method"] == "cgal-c1");
  const auto farthest = [&](const std::string& name) {
    double distance = 0;
    const PolyMesh mesh = mesh_in(folder / name);
    for (std::size_t v = holed_sphere().vertex_count(); v < mesh.vertex_count(); ++v) {
      distance = std::max(distance, std::abs(mesh.positions[v].norm() - 1));
    }
    return distance;
  };
  // A flat patch across a rim 0.4 from the pole lies 0.08 below it.
  CHECK(farthest("smooth.ply") < 0.04);
  CHECK(farthest("rbf.ply") < 0.01);
  filled(input, folder / "default.ply");
  CHECK(slurp(folder / "default.ply") == slurp(folder / "rbf.ply"));
}

TEST_CASE("a mesh without holes, and an open sheet, come back as they are") {
  const ScratchFolder folder;
  const std::string whole = folder.write("whole.ply", ply_of(round_sphere(3)));
  const Json closed = filled(whole, folder / "a.ply");
  CHECK(slurp(folder / "a.ply") == slurp(whole));
  CHECK(closed["details"]["holes"].empty());
  CHECK(closed["warnings"].empty());
  const std::string open = folder.write("sheet.ply", ply_of(sheet(20, 20)));
  const Json left = filled(open, folder / "b.ply");
  CHECK(slurp(folder / "b.ply") == slurp(open));
  CHECK(left["details"]["holes"][0]["class"] == "OUTER");
  CHECK(codes_of(left["warnings"]) == Words{"W_OUTER_LEFT"});
  CHECK(run_cli({"fill", open, "-o", folder / "b.ply", "--strict"}).code == 1);
  // Nothing closes a flat sheet without lying on it.
  const Json asked = filled(open, folder / "b.ply", {"--select", "all"});
  CHECK(holes_with(asked, "failed") == std::set<int>{0});
  CHECK(slurp(folder / "b.ply") == slurp(open));
}

TEST_CASE("dirt is reported and nothing of it deleted") {
  const ScratchFolder folder;
  const auto faces_first = [&](const std::string& name, const PolyMesh& given, const std::string& code) {
    INFO(name);
    const Json report = filled(folder.write(name, ply_of(given)), folder / "out.ply");
    CHECK(warns(report, code));
    CHECK(begins_with(mesh_in(folder / "out.ply"), given));
    return report;
  };
  faces_first("flipped.ply", flipped_face(holed_sphere(), 3), "W_ORIENTATION");
  faces_first("fan.ply", merged(holed_sphere(), translated(tetrahedra_sharing_edge(), Vec3(4, 0, 0))), "W_NONMANIFOLD");
  faces_first("soup.ply", as_soup(holed_sphere()), "W_WELDED");
  faces_first("bowtie.ply", chained_holes(3), "W_BOWTIE");
  PolyMesh needle = holed_sphere();
  const Index a = needle.corners[0], b = needle.corners[1];
  needle.positions.push_back((needle.positions[a] + needle.positions[b]) / 2);
  needle.corners[1] = static_cast<Index>(needle.vertex_count() - 1);
  needle.add_triangle(needle.corners[1], b, needle.corners[2]);
  needle.add_triangle(a, b, needle.corners[1]);
  CHECK(faces_first("needle.ply", needle, "W_DEGENERATE")["mesh"]["closed"] == true);
}

TEST_CASE("wrong options are answered with exit code 2 and leave nothing behind") {
  const ScratchFolder folder;
  const std::string input = folder.write("scan.ply", ply_of(holed_sphere()));
  const std::vector<Words> cases = {
      {"--only", "7"},          {"--only", "a"},           {"--only", "1-"},        {"--only", "-3"},
      {"--max-diameter", "-1"}, {"--max-diameter", "nan"}, {"--fairness", "bumpy"}, {"--select", "some"},
      {"--mode", "melt"},       {"--precision", "half"},   {"--frobnicate"},        {"--list", "--only", "9"},
      {"--adaptive", "-0.1"},   {"--adaptive", "1.5"},     {"--adaptive", "nan"},   {"--adaptive", "much"}};
  for (const Words& options : cases) {
    INFO(options.back());
    Words words = {"fill", input, "-o", folder / "out.ply"};
    words.insert(words.end(), options.begin(), options.end());
    const ProcessResult result = run_cli(words);
    CHECK(result.code == 2);
    CHECK_FALSE(result.err.empty());
  }
  CHECK(run_cli({"fill", input}).code == 2);
  CHECK(run_cli({"fill", input, "-o", folder / "out.xyz"}).code == 2);
  CHECK(folder.names() == Words{"scan.ply"});
}

TEST_CASE("a project that fills gives the file that fill gives") {
  const ScratchFolder folder;
  Node scan;
  scan.name = "scan";
  scan.source = std::make_shared<const PolyMesh>(holed_scan());
  Node node;
  node.name = "close";
  node.operation = "fill";
  node.inputs["scan"] = {1, "value"};
  Progress progress;
  save_project(folder / "a.croq", {Document().with(scan).with(node), {}, {}}, progress);
  const std::string input = folder.write("scan.ply", ply_of(holed_scan()));
  filled(input, folder / "fill.ply");
  REQUIRE(run_cli({"run", folder / "a.croq", "-o", folder / "run.ply"}).code == 0);
  CHECK(slurp(folder / "run.ply") == slurp(folder / "fill.ply"));
  filled(input, folder / "fill.ply", {"--fairness", "flat", "--only", "1"});
  REQUIRE(run_cli({"run", folder / "a.croq", "-o", folder / "run.ply", "--set", "close.fairness=flat", "--set",
                   "close.only=1"})
              .code == 0);
  CHECK(slurp(folder / "run.ply") == slurp(folder / "fill.ply"));
}

TEST_CASE("the shipped scan comes back closed, without a word but where flat lids over wide holes are guesses") {
  const ScratchFolder folder;
  const std::string shipped = CROQUIS_SOURCE_DIR "/examples/data/pumpkin_scan.ply";
  const auto fill_all = [&](const std::string& fairness) {
    const Json report = filled(shipped, folder / "out.ply", {"--fairness", fairness, "--select", "all"});
    CHECK(holes_with(report, "fill").size() == 7);
    CHECK(run_cli({"check", folder / "out.ply"}).code == 0);
    return report;
  };
  for (const char* fairness : {"rbf", "smooth"}) CHECK(fill_all(fairness)["warnings"].empty());
  CHECK(warns(fill_all("flat"), "W_LOW_CONFIDENCE"));
}

TEST_CASE("the first line, the report and the file agree on what is open, seams or not") {
  const ScratchFolder folder;
  const PolyMesh crossing = merged(as_soup(holed_sphere()), translated(round_sphere(2), Vec3(0.1, 0.2, -1)));
  const std::string input = folder.write("soup.ply", ply_of(crossing));
  const ProcessResult shown = run_cli({"fill", input, "-o", folder / "out.ply"});
  CHECK(shown.code == 0);
  CHECK(shown.out.find("\n1 hole: 1 filled, 0 left open. ") != std::string::npos);
  CHECK(shown.out.find("edges of seams count as closed") != std::string::npos);
  CHECK(shown.out.find("\nclosed, oriented, ") != std::string::npos);
  CHECK(shown.out.find("self-intersections, which were there before\n") != std::string::npos);
  const Json report = filled(input, folder / "out.ply");
  const Json& edges = report["details"]["open_edges"];
  CHECK(edges["before"] == report["details"]["holes"][0]["boundary_edges"]);
  CHECK(edges["after"] == 0);
  CHECK(edges["seams"] > 1000);
  CHECK(report["mesh"]["boundary_edges"] == 0);
  CHECK(report["mesh"]["self_intersections"] > 0);
  CHECK(report["details"]["added_self_intersections"] == 0);
  // The same figures as of the mesh whose vertices are one from the beginning.
  const PolyMesh whole = merged(holed_sphere(), translated(round_sphere(2), Vec3(0.1, 0.2, -1)));
  const Json plain = filled(folder.write("whole.ply", ply_of(whole)), folder / "plain.ply");
  for (const char* key : {"faces", "edges", "boundary_edges", "self_intersections", "components", "genus"})
    CHECK(report["mesh"][key] == plain["mesh"][key]);
}

TEST_CASE("the list gives places and directions in numbers, and findings in words of options") {
  const ScratchFolder folder;
  const PolyMesh sheets = cut(sheet(12, 12), Vec3(6, 6, 0), 2.6).mesh;
  const std::string input = folder.write("scan.ply", ply_of(sheets));
  const std::string list = run_cli({"fill", input, "--list"}).out;
  CHECK(list.find("...") == std::string::npos);
  const Json holes = Json::parse(run_cli({"fill", input, "--list", "--json"}).out)["details"]["holes"];
  for (const char* key : {"at", "normal"}) {
    char text[100];
    const Json& place = holes[1][key];
    std::snprintf(text, sizeof text, "  %.6g %.6g %.6g", place[0].get<double>(), place[1].get<double>(),
                  place[2].get<double>());
    CHECK(list.find(text) != std::string::npos);
  }
  PolyMesh bar = translated(scaled(divided_box(1), 1.0), Vec3(-0.5, -0.5, -0.5));
  for (Vec3& p : bar.positions) p = Vec3(p.x(), p.y(), 40 * p.z()) + Vec3(6, 6, 0);
  const Json report = filled(folder.write("barred.ply", ply_of(merged(sheets, bar))), folder / "out.ply");
  CHECK(warns(report, "W_HOLE_FAILED"));
  for (const Json& warning : report["warnings"]) {
    for (const char* inner : {"implicit", "minimal", "cgal", "creased", "dihedral", "avoiding", "method"})
      CHECK(warning["message"].get<std::string>().find(inner) == std::string::npos);
  }
}

}  // namespace
}  // namespace croquis::test

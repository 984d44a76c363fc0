// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "cli/process.h"
#include "croquis/geometry/mesh_report.h"
#include "croquis/io/mesh_file.h"
#include "support/mesh_shapes.h"
#include "support/scans.h"

namespace croquis::test {
namespace {

using Json = nlohmann::json;
using Words = std::vector<std::string>;

const Words formats = {"ply", "obj", "off", "stl"};

std::string bytes_of(const PolyMesh& mesh, MeshFormat format) {
  Progress progress;
  return write_mesh(mesh, format, {}, progress).bytes;
}

std::string ply_of(const PolyMesh& mesh) { return bytes_of(mesh, MeshFormat::Ply); }

PolyMesh mesh_in(const std::string& path) {
  Progress progress;
  return read_mesh(slurp(path), *mesh_format_of(path), path, progress).mesh;
}

/// Volatile: GCC 12 may drop the rounding to 32 bits and back.
PolyMesh as_floats(PolyMesh mesh) {
  for (Vec3& position : mesh.positions) {
    for (double& coordinate : position) {
      const volatile float rounded = static_cast<float>(coordinate);
      coordinate = static_cast<double>(rounded);
    }
  }
  return mesh;
}

/// The first vertices and faces are those given, bit by bit.
bool begins_with(const PolyMesh& grown, const PolyMesh& given) {
  return grown.vertex_count() >= given.vertex_count() && grown.face_count() >= given.face_count() &&
         std::equal(given.positions.begin(), given.positions.end(), grown.positions.begin()) &&
         std::equal(given.face_offsets.begin(), given.face_offsets.end(), grown.face_offsets.begin()) &&
         std::equal(given.corners.begin(), given.corners.end(), grown.corners.begin());
}

/// A sphere with five holes, two of which are an island's ring.
PolyMesh scan() {
  const PolyMesh ball = random_cuts(round_sphere(4), 3, 3, 0.12, 0.3).mesh;
  return cut_ring(ball, Vec3(0, 0, 1), 0.15, 0.45).mesh;
}

PolyMesh holed_sphere() { return cut(round_sphere(3), Vec3(0, 0, 1), 0.4).mesh; }

Words codes_of(const Json& findings) {
  Words codes;
  for (const Json& finding : findings) codes.push_back(finding.at("code"));
  return codes;
}

bool tells(const Json& report, const std::string& code) {
  const Words codes = codes_of(report.at("warnings"));
  return std::find(codes.begin(), codes.end(), code) != codes.end();
}

/// Runs `fill` and gives its report; fails the test unless it exits with 0.
Json filled(const std::string& input, const std::string& output, const Words& options = {}) {
  Words words = {"fill", input, "-o", output, "--json"};
  words.insert(words.end(), options.begin(), options.end());
  const ProcessResult result = run_cli(words);
  INFO(result.err);
  REQUIRE(result.code == 0);
  return Json::parse(result.out);
}

/// Ids of the holes with that action.
std::set<int> holes_with(const Json& report, const std::string& action) {
  std::set<int> ids;
  for (const Json& hole : report.at("details").at("holes")) {
    if (hole.at("action") == action) ids.insert(hole.at("id").get<int>());
  }
  return ids;
}

Words keys_of(const Json& object) {
  Words keys;
  for (const auto& [key, value] : object.items()) keys.push_back(key);
  std::sort(keys.begin(), keys.end());
  return keys;
}

TEST_CASE("a scan with holes comes back closed, and begins with the scan, in every format") {
  for (const std::string& format : formats) {
    INFO(format);
    const ScratchFolder folder;
    const std::string input = folder.write("scan." + format, bytes_of(scan(), *mesh_format_of(format)));
    const Json report = filled(input, folder / ("out." + format));
    CHECK(report["mesh"]["closed"] == true);
    CHECK(report["mesh"]["oriented"] == true);
    CHECK(report["mesh"]["components"] == 1);
    CHECK(report["mesh"]["euler_characteristic"] == 2);
    CHECK(report["mesh"]["self_intersections"] == 0);
    CHECK(report["details"]["holes"].size() == 5);
    CHECK(holes_with(report, "fill").size() == 5);
    CHECK(run_cli({"check", folder / ("out." + format)}).code == 0);
    if (format != "stl") CHECK(begins_with(mesh_in(folder / ("out." + format)), mesh_in(input)));
  }
}

TEST_CASE("a triangle soup of an STL file is filled, its triangles first and as they were") {
  const ScratchFolder folder;
  const std::string input = folder.write("scan.stl", bytes_of(scan(), MeshFormat::Stl));
  filled(input, folder / "out.stl");
  constexpr std::size_t header = 84, record = 50;
  const std::string before = slurp(input), after = slurp(folder / "out.stl");
  REQUIRE(after.size() > before.size());
  std::size_t same = 0;
  // Of each record the corners: the normal is computed.
  for (std::size_t at = header; at < before.size(); at += record) {
    if (before.compare(at + 12, 36, after, at + 12, 36) == 0) ++same;
  }
  CHECK(same == (before.size() - header) / record);
}

TEST_CASE("the JSON report has exactly the keys that scripts rely on") {
  const ScratchFolder folder;
  PolyMesh open = merged(holed_sphere(), translated(sheet(6, 6), Vec3(5, 0, 0)));
  const Json report = filled(folder.write("scan.ply", ply_of(open)), folder / "out.ply");
  CHECK(keys_of(report) == Words{"command", "details", "input", "mesh", "output", "peak_memory_bytes", "seconds",
                                 "stages", "version", "warnings"});
  CHECK(report["command"] == "fill");
  const Json& details = report["details"];
  CHECK(keys_of(details) ==
        Words{"domains", "holes", "new_faces", "new_vertices", "points_per_domain", "summary", "untouched_vertices"});
  REQUIRE(details["holes"].size() == 2);
  for (const Json& hole : details["holes"]) {
    CHECK(keys_of(hole) == Words{"action", "area", "boundary_edges", "class", "confidence", "diameter", "id",
                                 "max_normal_jump", "method", "perimeter", "reason"});
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
  CHECK(details["domains"].is_null());
  CHECK(details["points_per_domain"].is_null());
  CHECK(details["untouched_vertices"] == open.vertex_count());
  CHECK(report["mesh"]["faces"] == open.face_count() + details["new_faces"].get<std::size_t>());
  CHECK(report["mesh"]["self_intersections"] == 0);
  CHECK(tells(report, "W_OUTER_LEFT"));
}

TEST_CASE("the list shows every hole to people and scripts, needs no output and writes none") {
  const ScratchFolder folder;
  const std::string input = folder.write("scan.ply", ply_of(scan()));
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
    for (const char* key : {"method", "max_normal_jump", "confidence"}) {
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

TEST_CASE("holes that stay open keep their rims edge by edge") {
  const ScratchFolder folder;
  const std::string input = folder.write("scan.ply", ply_of(random_cuts(round_sphere(4), 3, 3, 0.12, 0.3).mesh));
  const Json before = Json::parse(run_cli({"fill", input, "--list", "--json"}).out)["details"]["holes"];
  filled(input, folder / "out.ply", {"--only", "1"});
  const Json after = Json::parse(run_cli({"fill", folder / "out.ply", "--list", "--json"}).out)["details"]["holes"];
  REQUIRE(before.size() == 3);
  REQUIRE(after.size() == 2);
  for (const char* key : {"boundary_edges", "perimeter", "diameter", "area"}) {
    CHECK(after[0][key] == before[0][key]);
    CHECK(after[1][key] == before[2][key]);
  }
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

TEST_CASE("filling a filled file changes not a byte, and neither do threads") {
  for (const std::string& format : formats) {
    INFO(format);
    const ScratchFolder folder;
    const std::string input = folder.write("scan." + format, bytes_of(scan(), *mesh_format_of(format)));
    filled(input, folder / ("a." + format));
    const Json again = filled(folder / ("a." + format), folder / ("b." + format));
    CHECK(slurp(folder / ("a." + format)) == slurp(folder / ("b." + format)));
    CHECK(again["details"]["summary"] == "No holes.");
    CHECK(again["details"]["holes"].empty());
    for (const char* threads : {"2", "8"}) {
      filled(input, folder / ("c." + format), {"--threads", threads});
      CHECK(slurp(folder / ("a." + format)) == slurp(folder / ("c." + format)));
    }
  }
}

TEST_CASE("scans of 32-bit numbers stay so, all others keep every digit") {
  const ScratchFolder folder;
  const auto has_doubles = [](const std::string& ply) {
    return ply.substr(0, ply.find("end_header")).find("double x") != std::string::npos;
  };
  filled(folder.write("single.ply", ply_of(as_floats(scan()))), folder / "a.ply");
  CHECK_FALSE(has_doubles(slurp(folder / "a.ply")));
  filled(folder.write("double.ply", ply_of(scan())), folder / "b.ply");
  CHECK(has_doubles(slurp(folder / "b.ply")));
  // Millimetres far from the origin.
  const PolyMesh far = translated(scaled(scan(), 100), Vec3(1e6, -2e6, 3e6));
  const Json report = filled(folder.write("far.ply", ply_of(far)), folder / "c.ply");
  CHECK(report["mesh"]["closed"] == true);
  CHECK(report["mesh"]["self_intersections"] == 0);
  CHECK(begins_with(mesh_in(folder / "c.ply"), far));
}

TEST_CASE("colours go on into patches, those given stay, and faces tell their patch") {
  const ScratchFolder folder;
  PolyMesh given = scan();
  std::vector<std::uint8_t> colors;
  for (const Vec3& p : given.positions) {
    for (int i = 0; i < 3; ++i) colors.push_back(static_cast<std::uint8_t>(100 + 50 * p[i]));
  }
  given.channels.push_back({"color", Domain::Vertex, 3, colors, {}});
  const Json report = filled(folder.write("scan.ply", ply_of(given)), folder / "out.ply");
  const PolyMesh mesh = mesh_in(folder / "out.ply");
  const auto& painted = std::get<std::vector<std::uint8_t>>(mesh.channel("color", Domain::Vertex)->data);
  CHECK(std::equal(colors.begin(), colors.end(), painted.begin()));
  for (std::size_t i = colors.size(); i < painted.size(); ++i) {
    const double there = 100 + 50 * mesh.positions[i / 3][static_cast<Eigen::Index>(i % 3)];
    CHECK(std::abs(painted[i] - there) < 12);  // colours continue a plane's, the sphere bends away from it
  }
  const auto& patches = std::get<std::vector<std::int32_t>>(mesh.channel("patch_id", Domain::Face)->data);
  const auto old_end = patches.begin() + static_cast<std::ptrdiff_t>(given.face_count());
  CHECK(std::all_of(patches.begin(), old_end, [](std::int32_t id) { return id == -1; }));
  // Four holes' patches: the ring and its island share one.
  CHECK(std::set<std::int32_t>(old_end, patches.end()) == std::set<std::int32_t>{0, 1, 2, 3});
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
    CHECK(tells(report, code));
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

TEST_CASE("a hole that nothing can close stays open and is told; all others are filled") {
  // A bar through the hole in the middle of its rim: every patch would cut it.
  PolyMesh given = cut(sheet(12, 12), Vec3(6, 6, 0), 2.6).mesh;
  given = cut(given, Vec3(2, 2, 0), 1.5).mesh;
  PolyMesh bar = translated(scaled(divided_box(1), 1.0), Vec3(-0.5, -0.5, -0.5));
  for (Vec3& p : bar.positions) p = Vec3(p.x(), p.y(), 40 * p.z()) + Vec3(6, 6, 0);
  const ScratchFolder folder;
  const Json report = filled(folder.write("scan.ply", ply_of(merged(given, bar))), folder / "out.ply");
  CHECK(holes_with(report, "failed").size() == 1);
  CHECK(holes_with(report, "fill").size() == 1);
  CHECK(tells(report, "W_HOLE_FAILED"));
  for (const Json& hole : report["details"]["holes"]) {
    if (hole["action"] == "failed") CHECK(hole["reason"].is_string());
  }
  CHECK(report["mesh"]["self_intersections"] == 0);
}

TEST_CASE("intersections that a scan has are counted, and stay its own") {
  const PolyMesh given = merged(holed_sphere(), translated(round_sphere(2), Vec3(0, 0, -1)));
  const ScratchFolder folder;
  const std::string input = folder.write("scan.ply", ply_of(given));
  const Json before = Json::parse(run_cli({"info", input, "--json", "--self-intersections"}).out);
  const Json after = filled(input, folder / "out.ply");
  CHECK(before["mesh"]["self_intersections"] > 0);
  CHECK(after["mesh"]["self_intersections"] == before["mesh"]["self_intersections"]);
  CHECK(after["mesh"]["closed"] == true);
}

TEST_CASE("files that can't be read are refused with their code and leave nothing behind") {
  struct Case {
    std::string name, bytes, code;
  };
  const std::string good = ply_of(holed_sphere());
  const std::string header =
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n";
  const std::vector<Case> cases = {
      {"empty.ply", "", "E_EMPTY"},
      {"cut.ply", good.substr(0, good.size() - 20), "E_TRUNCATED"},
      {"garbage.obj", "\x01\x02\xff garbage\n", "E_SYNTAX"},
      {"counts.off", "OFF\n2000000000 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", "E_COUNT"},
      {"index.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 7\n", "E_INDEX"},
      {"negative.ply",
       header + "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 -2\n",
       "E_INDEX"},
      {"nan.obj", "v 0 0 nan\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "E_NOT_FINITE"},
      {"points.ply", header + "end_header\n0 0 0\n1 0 0\n0 1 0\n", "E_NO_FACES"},
      {"point.off", "OFF\n3 1 0\n1 1 1\n1 1 1\n1 1 1\n3 0 1 2\n", "E_DEGENERATE"},
      {"claims.ply",
       "ply\nformat binary_little_endian 1.0\nelement vertex 4000000000\nproperty float x\nproperty float y\nproperty "
       "float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n0",
       "E_TRUNCATED"}};
  const ScratchFolder folder;
  for (const Case& bad : cases) {
    INFO(bad.name);
    const ProcessResult result =
        run_cli({"fill", folder.write(bad.name, bad.bytes), "-o", folder / "out.ply", "--json"});
    CHECK(result.code == 3);
    const Json json = Json::parse(result.out);
    CHECK(json["command"] == "fill");
    const std::string code = json["error"]["code"];
    CHECK((code == bad.code || (bad.code == "E_COUNT" && code == "E_TRUNCATED")));
    CHECK(json["error"]["message"].get<std::string>().find(bad.name) != std::string::npos);
    CHECK(result.peak_kilobytes < 100 * 1024);
    CHECK_FALSE(std::filesystem::exists(folder / "out.ply"));
  }
  CHECK(run_cli({"fill", folder / "missing.ply", "-o", folder / "out.ply"}).code == 3);
}

TEST_CASE("bad vertices are dropped on request, with their faces and nothing else") {
  PolyMesh given = holed_sphere();
  const PolyMesh whole = given;
  std::vector<std::int32_t> numbers;
  for (std::size_t v = 0; v < given.vertex_count(); ++v) numbers.push_back(static_cast<std::int32_t>(v));
  given.channels.push_back({"number", Domain::Vertex, 1, numbers, {}});
  constexpr Index bad = 50;
  const auto lost = static_cast<std::size_t>(
      std::count_if(whole.corners.begin(), whole.corners.end(), [](Index v) { return v == bad; }));
  const ScratchFolder folder;
  for (const double value : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    given.positions[bad].y() = value;
    const std::string input = folder.write("scan.ply", ply_of(given));
    const ProcessResult refused = run_cli({"fill", input, "-o", folder / "out.ply", "--json"});
    CHECK(refused.code == 3);
    const Json subjects = Json::parse(refused.out)["error"]["subject"];
    CHECK(std::any_of(subjects.begin(), subjects.end(),
                      [](const Json& subject) { return subject["kind"] == "vertex" && subject["id"] == "50"; }));
    const Json report = filled(input, folder / "out.ply", {"--drop-bad"});
    CHECK(codes_of(report["warnings"]) == Words{"W_NOT_FINITE", "W_BAD_DROPPED"});
    CHECK(report["details"]["untouched_vertices"] == given.vertex_count() - 1);
    CHECK(report["details"]["holes"].size() == 2);
    CHECK(report["mesh"]["closed"] == true);
    CHECK(report["mesh"]["faces"] == whole.face_count() - lost + report["details"]["new_faces"].get<std::size_t>());
    const PolyMesh mesh = mesh_in(folder / "out.ply");
    const auto& kept = std::get<std::vector<std::int32_t>>(mesh.channel("number", Domain::Vertex)->data);
    for (std::size_t v = 0; v + 1 < given.vertex_count(); ++v) {
      const std::size_t old = v < bad ? v : v + 1;
      CHECK(kept[v] == static_cast<std::int32_t>(old));
      CHECK(mesh.positions[v] == whole.positions[old]);
    }
  }
  const std::string clean = folder.write("clean.ply", ply_of(whole));
  CHECK(filled(clean, folder / "out.ply", {"--drop-bad"})["warnings"].empty());
  const std::string none = folder.write("none.obj", "v 0 0 nan\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  CHECK(run_cli({"fill", none, "-o", folder / "none.ply", "--drop-bad"}).code == 3);
  CHECK_FALSE(std::filesystem::exists(folder / "none.ply"));
}

TEST_CASE("a scan is piped through") {
  const ScratchFolder folder;
  const std::string input = folder.write("scan.ply", ply_of(holed_sphere()));
  filled(input, folder / "out.ply");
  const ProcessResult piped =
      run_cli({"fill", "-", "--input-format", "ply", "-o", "-", "--output-format", "ply", "--json", "--quiet"},
              {.standard_input = slurp(input)});
  CHECK(piped.code == 0);
  CHECK(piped.out == slurp(folder / "out.ply"));
  CHECK(Json::parse(piped.err)["mesh"]["closed"] == true);
}

TEST_CASE("wrong options are answered with exit code 2 and leave nothing behind") {
  const ScratchFolder folder;
  const std::string input = folder.write("scan.ply", ply_of(holed_sphere()));
  const std::vector<Words> cases = {{"--only", "7"},         {"--only", "a"},          {"--only", "1-"},
                                    {"--only", "-3"},        {"--max-diameter", "-1"}, {"--max-diameter", "nan"},
                                    {"--fairness", "bumpy"}, {"--select", "some"},     {"--mode", "melt"},
                                    {"--precision", "half"}, {"--frobnicate"},         {"--list", "--only", "9"}};
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

TEST_CASE("filling stops at its limits without a trace") {
  const ScratchFolder folder;
  const std::string input = folder.write("scan.ply", ply_of(random_cuts(round_sphere(6), 3, 12, 0.1, 0.2).mesh));
  const ProcessResult late = run_cli({"fill", input, "-o", folder / "out.ply", "--timeout", "0.02", "--json"});
  CHECK(late.code == 5);
  CHECK(Json::parse(late.out)["error"]["code"] == "E_TIMEOUT");
  CHECK(folder.names() == Words{"scan.ply"});
  CHECK(run_cli({"fill", input, "-o", folder / "no/such/folder.ply"}).code == 6);
}

}  // namespace
}  // namespace croquis::test

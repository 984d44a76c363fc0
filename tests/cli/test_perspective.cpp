// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <set>
#include <sstream>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "cli/process.h"
#include "croquis/io/perspective_drawing_file.h"
#include "support/perspective/solid_drawing.h"

namespace croquis::test {
namespace {

using Json = nlohmann::json;

const std::filesystem::path shipped = std::filesystem::path(CROQUIS_SOURCE_DIR) / "examples/data/perspective";

/// A drawing without noise, seen in three-point perspective.
SolidDrawing clean(const PerspectiveSolid& solid) { return drawn(solid, three_point_views()[1]); }

std::string file_of(const ScratchFolder& folder, const PerspectiveDrawing& drawing) {
  return folder.write("drawing.svg", write_perspective_svg(drawing));
}

Json solved(const ScratchFolder& folder, const std::string& file, std::vector<std::string> options = {}) {
  std::vector<std::string> words{"perspective", file, "-o", folder / "solid.obj", "--json", "--quiet"};
  words.insert(words.end(), options.begin(), options.end());
  const ProcessResult result = run_cli(words);
  INFO(result.err);
  REQUIRE(result.code == 0);
  return Json::parse(result.out);
}

std::set<std::string> warning_codes(const Json& report) {
  std::set<std::string> codes;
  for (const Json& warning : report.at("warnings")) codes.insert(warning.at("code"));
  return codes;
}

PerspectiveStroke& stroke_of(PerspectiveDrawing& drawing, const std::string& id) {
  return *std::ranges::find(drawing.strokes, id, &PerspectiveStroke::id);
}

/// The strokes of each face, without order.
std::set<std::set<std::string>> face_strokes(const Json& report) {
  std::set<std::set<std::string>> faces;
  for (const Json& face : report.at("details").at("faces")) {
    std::set<std::string> strokes;
    for (const Json& loop : face.at("strokes")) strokes.insert(loop.begin(), loop.end());
    faces.insert(strokes);
  }
  return faces;
}

std::set<std::set<std::string>> face_strokes(const PerspectiveSolid& solid) {
  std::set<std::set<std::string>> faces;
  for (const SolidFace& face : solid.faces) {
    std::set<std::string> strokes;
    for (const auto& loop : face.loops) {
      for (const SolidSide& side : loop) strokes.insert(solid.network.curves[side.curve].id);
    }
    faces.insert(strokes);
  }
  return faces;
}

TEST_CASE("every shipped perspective drawing becomes a solid that check accepts") {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(shipped)) {
    if (entry.path().extension() != ".svg") continue;
    INFO(entry.path());
    const ScratchFolder folder;
    const Json report = solved(folder, entry.path());
    const Json& details = report.at("details");
    CHECK(details.at("closed") == true);
    CHECK(report.at("mesh").at("self_intersections") == 0);
    CHECK(details.at("max_g1_angle_degrees").get<double>() < 1e-6);
    for (const auto& [stroke, use] : details.at("strokes").items()) {
      INFO(stroke);
      CHECK(use == "used");
    }
    CHECK(run_cli({"check", folder / "solid.obj"}).code == 0);
    ++count;
  }
  CHECK(count >= 5);
}

TEST_CASE("drawings of solids give their faces, corners and camera back") {
  for (const PerspectiveSolid& solid : {l_block(), soap(), bottle(), camera_ring(), ring_frame()}) {
    INFO(solid.name);
    const ScratchFolder folder;
    const SolidDrawing truth = clean(solid);
    const Json report = solved(folder, file_of(folder, truth.drawing), {"--camera", folder / "camera.json"});
    const Json& details = report.at("details");
    CHECK(face_strokes(report) == face_strokes(solid));
    CHECK(details.at("mode") == 3);
    CHECK(details.at("focal_length").get<double>() == Approx(truth.camera.focal_length).epsilon(1e-6));
    CHECK(details.at("vertices").size() == solid.network.vertices.size());
    for (const Json& vertex : details.at("vertices")) {
      const auto number = std::stoul(vertex.at("id").get<std::string>().substr(1));
      const Json& at = vertex.at("at");
      CHECK((Vec3(at[0], at[1], at[2]) - truth.network.vertices[number]).norm() < 1e-6);
    }
    const Json camera = Json::parse(slurp(folder / "camera.json"));
    for (const char* key : {"mode", "focal_length", "principal_point", "eye", "rotation", "image"})
      CHECK(camera.contains(key));
    CHECK(camera.at("image")[0] == truth.drawing.image_size.x());
  }
}

TEST_CASE("the curve file has a polyline for each edge, with common ends") {
  const ScratchFolder folder;
  const PerspectiveSolid solid = bottle();
  solved(folder, file_of(folder, clean(solid).drawing), {"--curves", folder / "curves.obj"});
  std::istringstream lines(slurp(folder / "curves.obj"));
  std::map<std::string, std::vector<std::string>> curves;
  std::string name;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("o ")) name = line.substr(2);
    if (line.starts_with("v ")) curves[name].push_back(line);
  }
  REQUIRE(curves.size() == solid.network.curves.size());
  for (const NetworkCurve& curve : solid.network.curves) {
    const std::size_t count = curves.at(curve.id).size();
    CHECK((curve.straight ? count == 2 : count >= 33));
  }
  std::set<std::string> ends;
  for (const auto& [id, points] : curves) ends.insert({points.front(), points.back()});
  CHECK(ends.size() == solid.network.vertices.size());
}

TEST_CASE("the patch file has 20 points for each patch and the loops of each plane") {
  const ScratchFolder folder;
  const Json report = solved(folder, file_of(folder, clean(soap()).drawing), {"--patches", folder / "patches.json"});
  const Json patches = Json::parse(slurp(folder / "patches.json"));
  CHECK(patches.at("patches").size() == 1);
  CHECK(patches.at("patches")[0].at("points").size() == 20);
  CHECK(patches.at("patches")[0].at("strokes").size() == 4);
  CHECK(patches.at("planes").size() == 5);
  CHECK(report.at("details").at("faces").size() == 6);
}

TEST_CASE("the network and the cage of a solid are written beside it") {
  const ScratchFolder folder;
  const Json report = solved(folder, file_of(folder, clean(camera_body()).drawing),
                             {"--network", folder / "net.json", "--cage", folder / "cage.obj", "--cage-segments", "8"});
  CHECK(warning_codes(report) == std::set<std::string>{"FACE_LEFT_OUT"});
  const Json network = Json::parse(slurp(folder / "net.json"));
  CHECK(network.at("format") == "croquis-abs/1");
  CHECK(network.at("nodes").size() == report.at("details").at("vertices").size());
  CHECK(network.at("faces").size() + 1 == report.at("details").at("faces").size());
  CHECK(run_cli({"check", folder / "cage.obj"}).code == 0);
  CHECK(slurp(folder / "cage.obj").find("t crease 2/1/0 ") != std::string::npos);
  const ProcessResult refined = run_cli({"subdivide", folder / "cage.obj", "-o", folder / "fine.obj", "--levels", "2"});
  CHECK(refined.code == 0);
  CHECK(run_cli({"check", folder / "fine.obj"}).code == 0);
  const std::string drawing = folder / "drawing.svg";
  CHECK(run_cli({"perspective", drawing, "--cage", folder / "only.obj"}).code == 0);
  CHECK(run_cli({"perspective", drawing, "--cage", folder / "x.obj", "--cage-segments", "3"}).code == 2);
  CHECK(run_cli({"perspective", drawing, "--cage", folder / "x.abc"}).code == 2);
  CHECK(run_cli({"patch_cage", drawing, "-o", folder / "x.obj"}).code == 2);
}

TEST_CASE("a GLB has the recovered camera, which sees the solid's corners where they were drawn") {
  for (const View& view : {off_centre_view(), level_view(), frontal_view(), cropped_view()}) {
    INFO(view.name);
    const ScratchFolder folder;
    SolidDrawing truth = drawn(box(), view);
    truth.drawing.field_of_view = view.field_of_view;
    truth.drawing.principal_point = truth.camera.principal_point;
    const std::string file = file_of(folder, truth.drawing);
    const ProcessResult result = run_cli({"perspective", file, "-o", folder / "solid.glb", "--json"});
    REQUIRE(result.code == 0);
    const std::string glb = slurp(folder / "solid.glb");
    std::uint32_t length = 0;
    std::memcpy(&length, glb.data() + 12, sizeof length);
    const Json gltf = Json::parse(glb.substr(20, length));
    const Json& camera = gltf.at("cameras").at(0);
    const auto matrix = gltf.at("nodes").at(1).at("matrix").get<std::vector<double>>();
    const auto frame = camera.at("extras").at("frame").get<std::vector<double>>();
    const double half_y = std::tan(camera.at("perspective").at("yfov").get<double>() / 2);
    const double half_x = half_y * camera.at("perspective").at("aspectRatio").get<double>();
    const auto column = [&](std::size_t i) { return Vec3(matrix[4 * i], matrix[4 * i + 1], matrix[4 * i + 2]); };
    const Json details = Json::parse(result.out).at("details");
    REQUIRE(details.at("vertices").size() == 8);
    for (const Json& vertex : details.at("vertices")) {
      const Json& at = vertex.at("at");
      const Vec3 from_eye = Vec3(at[0], at[1], at[2]) - column(3);
      const double depth = -column(2).dot(from_eye);
      const Vec2 device(column(0).dot(from_eye) / depth / half_x, column(1).dot(from_eye) / depth / half_y);
      const Vec2 place(frame[0] + frame[2] * (device.x() + 1) / 2, frame[1] + frame[3] * (1 - device.y()) / 2);
      const auto number = std::stoul(vertex.at("id").get<std::string>().substr(1));
      CHECK((place - truth.camera.project(truth.network.vertices[number])).norm() < 0.5);
    }
    // Upright: y points up in glTF.
    const Json upright = gltf.at("nodes").at(gltf.at("scenes").at(0).at("nodes").at(0).get<std::size_t>());
    CHECK(upright.at("children").size() == 2);
    const ProcessResult info = run_cli({"info", folder / "solid.glb", "--json"});
    REQUIRE(info.code == 0);
    const Json bounds = Json::parse(info.out).at("mesh").at("bounds");
    double highest = -1e9;
    for (const Json& vertex : details.at("vertices")) highest = std::max(highest, vertex.at("at")[2].get<double>());
    CHECK(bounds[1][1].get<double>() == Approx(highest).margin(1e-5));
    CHECK(run_cli({"check", folder / "solid.glb"}).code == 0);
  }
}

TEST_CASE("the patch file has a B-spline surface with its error beside each patch") {
  const ScratchFolder folder;
  solved(folder, file_of(folder, clean(bottle()).drawing), {"--patches", folder / "patches.json"});
  const Json file = Json::parse(slurp(folder / "patches.json"));
  CHECK(file.at("patches").size() == 24);
  for (const Json& patch : file.at("patches")) {
    const Json& fit = patch.at("bicubic");
    const std::size_t across = fit.at("u_knots").size() - 4, along = fit.at("v_knots").size() - 4;
    CHECK(fit.at("points").size() == across * along);
    CHECK(fit.at("points").front() == patch.at("points")[0]);
    CHECK(fit.at("points").back() == patch.at("points")[6]);
    CHECK(fit.at("error").get<double>() < 1e-3);
    CHECK(fit.at("angle_degrees").get<double>() <= 0.05);
    CHECK(fit.at("within_tolerance") == true);
  }
}

TEST_CASE("STEP files are written in the drawing's unit; a program that can't says what to install") {
  const ScratchFolder folder;
  PerspectiveDrawing drawing = clean(soap()).drawing;
  drawing.unit = "inch";
  const std::string file = file_of(folder, drawing);
  const ProcessResult result = run_cli({"perspective", file, "-o", folder / "soap.stp", "--json", "--quiet"});
  const Json report = Json::parse(result.out);
  if (!CROQUIS_HAS_STEP) {
    CHECK(result.code == 2);
    CHECK(report.at("error").at("code") == "E_NO_STEP");
    CHECK(report.at("error").at("message").get<std::string>().find("libocct-data-exchange-dev") != std::string::npos);
    CHECK_FALSE(std::filesystem::exists(folder / "soap.stp"));
    return;
  }
  REQUIRE(result.code == 0);
  const Json& step = report.at("details").at("step");
  CHECK(step.at("unit") == "inch");
  CHECK(step.at("faces") == 6);
  CHECK(step.at("edges") == 12);
  CHECK(step.at("error").get<double>() < 1e-3);
  const std::string bytes = slurp(folder / "soap.stp");
  CHECK(bytes.starts_with("ISO-10303-21;"));
  CHECK(bytes.find("MANIFOLD_SOLID_BREP") != std::string::npos);
  CHECK(bytes.find("'INCH'") != std::string::npos);
  const ProcessResult piped = run_cli({"perspective", file, "-o", "-", "--output-format", "step", "--quiet"});
  CHECK(piped.code == 0);
  CHECK(piped.out.starts_with("ISO-10303-21;"));
}

TEST_CASE("a stroke of the wrong group is named with the group that fits, and --fix makes it so") {
  const ScratchFolder folder;
  const PerspectiveSolid solid = l_block();
  SolidDrawing truth = clean(solid);
  PerspectiveStroke& wrong = stroke_of(truth.drawing, "e07");
  const StrokeGroup right = wrong.group;
  wrong.group = right == StrokeGroup::ParallelX ? StrokeGroup::ParallelY : StrokeGroup::ParallelX;
  wrong.colour.clear();
  const std::string file = file_of(folder, truth.drawing);
  const Json report = solved(folder, file);
  REQUIRE(warning_codes(report).contains("CONTRADICTION"));
  CHECK(report.at("details").at("strokes").at("e07") == "flagged");
  const auto& warnings = report.at("warnings");
  const auto found = std::find_if(warnings.begin(), warnings.end(),
                                  [](const Json& warning) { return warning.at("code") == "CONTRADICTION"; });
  CHECK(found->at("fix").at("stroke") == "e07");
  CHECK(found->at("fix").at("group") == std::to_string(static_cast<int>(right)));
  const Json mended = solved(folder, file, {"--fix"});
  CHECK_FALSE(warning_codes(mended).contains("CONTRADICTION"));
  CHECK(face_strokes(mended) == face_strokes(solid));
  CHECK(run_cli({"perspective", file, "-o", folder / "solid.obj", "--strict"}).code == 1);
}

TEST_CASE("known point, scale and ignored strokes come from options, too") {
  const ScratchFolder folder;
  SolidDrawing truth = clean(box());
  const Vec2 at = truth.drawing.known_point->at;
  truth.drawing.known_point.reset();
  truth.drawing.known_lengths.clear();
  const std::string file = file_of(folder, truth.drawing);
  std::ostringstream place;
  place.precision(17);
  place << at.x() << ',' << at.y() << "=10,20,30";
  const NetworkCurve& edge = truth.network.curves.front();
  const Json report = solved(folder, file, {"--known-point", place.str(), "--scale", edge.id + "=7"});
  const Json& bounds = report.at("mesh").at("bounds");
  const double length = (truth.network.vertices[edge.start] - truth.network.vertices[edge.end]).norm();
  CHECK(report.at("mesh").at("volume").get<double>() == Approx(24 * std::pow(7 / length, 3)));
  CHECK(bounds[0][2].get<double>() == Approx(30));

  const Json open = solved(folder, file, {"--ignore", edge.id});
  CHECK(open.at("details").at("strokes").at(edge.id) == "flagged");
  CHECK(warning_codes(open).contains("STROKE_IGNORED"));
  for (const char* bad : {"5", "1,2", "1,2=3,4", "a,b=1,2,3"})
    CHECK(run_cli({"perspective", file, "-o", folder / "x.obj", "--known-point", bad}).code == 2);
  for (const char* bad : {"e00", "e00=0", "e00=-1", "=3", "nobody=3"})
    CHECK(run_cli({"perspective", file, "-o", folder / "x.obj", "--scale", bad}).code == 2);
  CHECK(run_cli({"perspective", file, "-o", folder / "x.obj", "--ignore", "nobody"}).code == 2);
}

TEST_CASE("JSON drawings are read, the same bytes come out of the same drawing") {
  const ScratchFolder folder;
  const SolidDrawing truth = clean(bottle());
  const std::string svg = file_of(folder, truth.drawing);
  const std::string json = folder.write("drawing.json", write_perspective_json(truth.drawing));
  solved(folder, svg);
  const std::string first = slurp(folder / "solid.obj");
  solved(folder, json);
  CHECK(slurp(folder / "solid.obj") == first);
  solved(folder, svg, {"--threads", "1"});
  CHECK(slurp(folder / "solid.obj") == first);
}

TEST_CASE("drawings without an eye or without faces end with their codes and write nothing") {
  const ScratchFolder folder;
  SolidDrawing lines = clean(box());
  std::erase_if(lines.drawing.strokes,
                [](const PerspectiveStroke& stroke) { return stroke.group != StrokeGroup::ParallelX; });
  const std::string one_axis = file_of(folder, lines.drawing);
  const ProcessResult eyeless = run_cli({"perspective", one_axis, "-o", folder / "solid.obj", "--json"});
  CHECK(eyeless.code == 4);
  CHECK(Json::parse(eyeless.out).at("error").at("code") == "VP_INSUFFICIENT");

  SolidDrawing construction = clean(box());
  std::erase_if(construction.drawing.strokes,
                [](const PerspectiveStroke& stroke) { return stroke.role == StrokeRole::Edge; });
  const std::string no_edges = folder.write("lines.svg", write_perspective_svg(construction.drawing));
  const ProcessResult faceless = run_cli({"perspective", no_edges, "-o", folder / "solid.obj", "--json"});
  CHECK(faceless.code == 4);
  CHECK(Json::parse(faceless.out).at("error").at("code") == "E_NO_FACES");
  CHECK(run_cli({"perspective", no_edges, "--camera", folder / "camera.json"}).code == 0);
  CHECK(run_cli({"perspective", folder.write("junk.svg", "<svg"), "-o", folder / "solid.obj"}).code == 3);
  CHECK_FALSE(std::filesystem::exists(folder / "solid.obj"));
}

}  // namespace
}  // namespace croquis::test

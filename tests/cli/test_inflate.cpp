// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <csignal>
#include <set>
#include <sstream>
#include <tuple>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "cli/process.h"
#include "support/sanitizers.h"
#include "support/sketches/sketch_errors.h"
#include "support/sketches/sketch_svg.h"

namespace croquis::test {
namespace {

using Json = nlohmann::json;

const std::filesystem::path sketches = std::filesystem::path(CROQUIS_SOURCE_DIR) / "examples/data";

std::string svg(const std::string& content) {
  return "<svg xmlns=\"http://www.w3.org/2000/svg\">" + content + "</svg>";
}

Json report_of(const ProcessResult& result) {
  INFO(result.err);
  return Json::parse(result.out);
}

TEST_CASE("a sketch becomes a cage of quads that subdivide takes") {
  const ScratchFolder folder;
  for (const char* name : {"trefoil", "dog"}) {
    const std::string cage = folder / (std::string(name) + ".obj");
    const ProcessResult result = run_cli({"cage", sketches / (std::string(name) + ".svg"), "-o", cage, "--json"});
    REQUIRE(result.code == 0);
    const Json report = report_of(result), details = report.at("details");
    CHECK(report.at("command") == "cage");
    CHECK(report.at("mesh").at("closed") == true);
    CHECK(report.at("mesh").at("faces") == details.at("faces"));
    CHECK(details.at("quads") == details.at("faces"));
    CHECK(details.at("silhouette_iou").get<double>() >= 0.95);
    CHECK(details.at("caps") == (std::string(name) == "dog" ? 16 : 0));
    CHECK(details.at("mirror") == false);
    for (const char* scheme : {"catmull-clark", "doo-sabin"}) {
      CHECK(run_cli({"subdivide", cage, "--scheme", scheme, "--levels", "2", "-o", folder / "fine.obj"}).code == 0);
    }
  }
}

TEST_CASE("a drawing without a solid has no cage either") {
  const ScratchFolder folder;
  const std::string empty = folder.write("empty.svg", svg("<path id=\"a\" data-kind=\"detail\" d=\"M0 0L100 3\"/>"));
  for (const char* command : {"inflate", "cage"}) {
    const ProcessResult result = run_cli({command, empty, "-o", folder / "a.obj", "--json"});
    CHECK(result.code == 4);
    CHECK(report_of(result).at("error").at("code") == "E_KIND");
    CHECK_FALSE(std::filesystem::exists(folder / "a.obj"));
  }
  CHECK(run_cli({"cage", folder.write("bad.svg", "<svg"), "-o", folder / "a.obj"}).code == 3);
}

TEST_CASE("every shipped sketch becomes a solid that check accepts") {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(sketches)) {
    if (entry.path().extension() != ".svg") continue;
    const ScratchFolder folder;
    const bool noisy = entry.path().filename().string().starts_with("noisy");
    const ProcessResult result = run_cli({"inflate", entry.path(), "-o", folder / "solid.obj", "--json", "--quiet",
                                          "--preset", noisy ? "tablet" : "clean"});
    INFO(entry.path() << result.err);
    REQUIRE(result.code == 0);
    const Json report = report_of(result);
    const Json& details = report.at("details");
    CHECK(report.at("mesh").at("self_intersections") == 0);
    CHECK(report.at("mesh").at("closed") == true);
    CHECK(report.at("mesh").at("oriented") == true);
    CHECK(report.at("mesh").at("nonmanifold_edges") == 0);
    CHECK(report.at("mesh").at("nonmanifold_vertices") == 0);
    CHECK(details.at("silhouette_iou").get<double>() >= (noisy ? 0.95 : 0.98));
    int euler = 0;
    for (const Json& object : details.at("objects")) {
      CHECK(object.at("euler_mesh") == 2 * object.at("euler_region").get<int>());
      euler += object.at("euler_mesh").get<int>();
    }
    CHECK(report.at("mesh").at("euler_characteristic") == euler);
    CHECK(run_cli({"check", folder / "solid.obj"}).code == 0);
    ++count;
  }
  CHECK(count >= 6);
}

TEST_CASE("a sliver among wide parts makes no solid deeper than its parts are wide") {
  const ScratchFolder folder;
  const std::filesystem::path sketch = std::filesystem::path(CROQUIS_SOURCE_DIR) / "tests/cli/drawings/sliver.svg";
  const ProcessResult result =
      run_cli({"inflate", sketch, "-o", folder / "a.obj", "--preset", "tablet", "--json", "--quiet"});
  REQUIRE(result.code == 0);
  const Json report = report_of(result);
  const Json& bounds = report.at("mesh").at("bounds");
  const auto extent = [&](std::size_t axis) {
    return bounds.at(1).at(axis).get<double>() - bounds.at(0).at(axis).get<double>();
  };
  CHECK(extent(2) < 3 * extent(0));  // three bodies lie over each other, none of them as wide as the drawing
  CHECK(report.at("details").at("solver").at("iterations") <= 25);
  CHECK(report.at("details").at("solver").at("residual") <= 1e-8);
}

TEST_CASE("attached objects are one surface, and the report tells which to attach") {
  const ScratchFolder folder;
  const Json plain = report_of(run_cli({"inflate", sketches / "duck.svg", "-o", folder / "a.obj", "--json"}));
  CHECK(plain.at("details").at("attached").empty());
  std::vector<std::string> arguments{"inflate", sketches / "duck.svg", "-o", folder / "b.obj", "--json"};
  for (const Json& pair : plain.at("details").at("attach_suggestions")) {
    CHECK(pair.at("at").size() == 2);
    arguments.push_back("--attach");
    arguments.push_back(pair.at("a").get<std::string>() + "," + pair.at("b").get<std::string>() + "=0.5");
  }
  const Json report = report_of(run_cli(arguments));
  CHECK(report.at("mesh").at("euler_characteristic") == 2);
  CHECK(report.at("mesh").at("components") == 1);
  CHECK(report.at("mesh").at("self_intersections") == 0);
  CHECK(report.at("details").at("attached").size() == 5);
  CHECK(report.at("details").at("attached").front().at("kappa") == 0.5);
  CHECK(report.at("details").at("shells").size() == 1);
  for (const Json& overlap : report.at("details").at("overlaps")) CHECK(overlap.at("crossings").size() == 2);
}

TEST_CASE("the same sketch gives the same bytes, for any number of threads") {
  const ScratchFolder folder;
  const std::string sketch = sketches / "trefoil.svg";
  REQUIRE(run_cli({"inflate", sketch, "-o", folder / "a.ply"}).code == 0);
  REQUIRE(run_cli({"inflate", sketch, "-o", folder / "b.ply", "--threads", "8", "--seed", "5"}).code == 0);
  CHECK(slurp(folder / "a.ply") == slurp(folder / "b.ply"));
}

TEST_CASE("the solid stays valid in every format, as written") {
  const ScratchFolder folder;
  for (const char* name : {"s.obj", "s.ply", "s.stl", "s.off"}) {
    REQUIRE(run_cli({"inflate", sketches / "linked_rings.svg", "-o", folder / name, "--quiet"}).code == 0);
    const ProcessResult check = run_cli({"check", folder / name});
    INFO(name << check.err);
    CHECK(check.code == 0);
  }
}

TEST_CASE("labels and skeleton are written without a solid when only they are asked for") {
  const ScratchFolder folder;
  const ProcessResult result = run_cli({"inflate", sketches / "trefoil.svg", "--labels", folder / "labels.svg",
                                        "--skeleton", folder / "skeleton.obj", "--json"});
  REQUIRE(result.code == 0);
  const Json details = report_of(result).at("details");
  CHECK(folder.names() == std::vector<std::string>{"labels.svg", "skeleton.obj"});
  const std::string labels = slurp(folder / "labels.svg");
  const auto count = [&labels](const std::string& word) {
    int found = 0;
    for (auto at = labels.find(word); at != std::string::npos; at = labels.find(word, at + 1)) ++found;
    return found;
  };
  CHECK(count("<path") == details.at("arcs"));
  CHECK(count("data-visible=\"false\"") == details.at("hidden_arcs"));
  CHECK(count("data-depth=\"1\"") == details.at("depth_histogram")[1]);
  CHECK(details.at("contours") == 2);
  CHECK(details.at("crossings") == 12);
  CHECK(details.at("hidden_arcs") == 6);
  const std::string skeleton = slurp(folder / "skeleton.obj");
  CHECK(skeleton.find("\nl ") != std::string::npos);
  CHECK(skeleton.find("\nf ") == std::string::npos);
}

TEST_CASE("a sketch comes from standard input and a solid goes to standard output") {
  const ProcessResult result = run_cli({"inflate", "-", "-o", "-", "--output-format", "obj", "--quiet"},
                                       {.standard_input = slurp(sketches / "snake.svg")});
  CHECK(result.code == 0);
  const ScratchFolder folder;
  CHECK(run_cli({"check", folder.write("s.obj", result.out)}).code == 0);
}

TEST_CASE("an outline that can't be one is named and no output is left") {
  const ScratchFolder folder;
  const std::string sketch = folder.write("free.svg", svg("<path id=\"tail\" data-kind=\"contour\"\n d=\"M 100 100 C "
                                                          "200 0 300 0 400 100 C 450 150 500 200 420 260\"/>"));
  const ProcessResult result = run_cli({"inflate", sketch, "-o", folder / "a.obj", "--json"});
  CHECK(result.code == 4);
  const Json error = report_of(result).at("error");
  CHECK(error.at("code") == "E_KIND");
  CHECK(error.at("subject")[0]["kind"] == "stroke");
  CHECK(error.at("subject")[0]["id"] == "tail");
  CHECK(error.at("subject")[0]["line"] == 1);
  CHECK(folder.names() == std::vector<std::string>{"free.svg"});
}

TEST_CASE("places are told in the terminal, which has no marks") {
  const ScratchFolder folder;
  const std::string sketch = folder.write("open.svg", svg("<path id=\"o\" d=\"M 100 105 V 300 H 300 V 95 H 100\"/>"));
  const ProcessResult result = run_cli({"inflate", sketch, "-o", folder / "a.obj"});
  CHECK(result.code == 0);
  CHECK(result.err.find("[W_GAP at (100, 100)]") != std::string::npos);
}

TEST_CASE("each fault of a sketch is told with its strokes, and a refused sketch leaves no output") {
  for (const ErrorSketch& wrong : error_sketches()) {
    const ScratchFolder folder;
    const std::string sketch = folder.write("wrong.svg", to_svg(wrong.drawing));
    const ProcessResult result =
        run_cli({"inflate", sketch, "-o", folder / "a.obj", "--json", "--quiet", "--preset", "clean"});
    INFO(wrong.code << " " << result.err);
    const Json report = report_of(result);
    const bool refused = result.code == 4;
    CHECK((refused || result.code == 0));
    CHECK(std::filesystem::exists(folder / "a.obj") != refused);
    std::set<std::string> named;
    for (const Json& finding : report.at(refused ? "errors" : "warnings")) {
      if (finding.at("code") != wrong.code) continue;
      for (const Json& subject : finding.at("subject")) named.insert(subject.at("id").get<std::string>());
    }
    for (const std::string& stroke : wrong.strokes) {
      INFO(stroke);
      CHECK(named.contains(stroke));
    }
  }
}

TEST_CASE("one bad object doesn't stop the others") {
  const ScratchFolder folder;
  const std::string sketch =
      folder.write("mixed.svg", svg("<circle id=\"good\" cx=\"200\" cy=\"200\" r=\"150\"/>"
                                    "<path id=\"bad\" data-kind=\"part\" d=\"M 500 100 H 600 V 200 H 500 Z\"/>"
                                    "<path id=\"worse\" data-kind=\"part\" d=\"M 550 150 H 650 V 250 H 550 Z\"/>"));
  const ProcessResult result = run_cli({"inflate", sketch, "-o", folder / "a.obj", "--json", "--preset", "clean"});
  CHECK(result.code == 0);
  const Json report = report_of(result);
  CHECK(report.at("details").at("objects").size() == 1);
  CHECK(report.at("details").at("objects")[0]["name"] == "good");
  REQUIRE(report.at("warnings").size() >= 1);
  CHECK(report.at("warnings")[0]["code"] == "E_CROSS");
  CHECK(report.at("warnings")[0]["subject"][0]["id"] == "bad");
  CHECK(run_cli({"check", folder / "a.obj"}).code == 0);
  CHECK(run_cli({"inflate", sketch, "-o", folder / "b.obj", "--strict", "--preset", "clean"}).code == 1);
}

TEST_CASE("the report tells which share of the drawing was used, and a limb without its body is no result") {
  const std::string ear = "<path id=\"ear\" d=\"M 0 0 H 60 V 60 H 0 Z\"/>";
  const std::string line = "<path id=\"line\" data-kind=\"ignored\" d=\"M 200 0 V 60\"/>";
  // Closed outlines that cross, so that exact lines don't tell what is in front.
  const std::string bodies =
      "<path id=\"body\" d=\"M 100 100 H 300 V 300 H 100 Z\"/><path id=\"belly\" d=\"M 150 150 H 350 V 350 H 150 Z\"/>";
  const std::string eight =
      "<path id=\"eight\" data-kind=\"part\" d=\"M 100 100 H 240 V 240 H 80 V 120 H 120 V 80 H 100 Z\"/>";
  std::string ears;
  for (int k = 0; k < 12; ++k) {
    const std::string x = std::to_string(400 + 90 * k);
    ears += "<path d=\"M " + x + " 0 h 60 v 60 h -60 Z\"/>";
  }
  const ScratchFolder folder;
  const std::string one_line = folder.write("used.svg", svg(ear + line));
  const Json report = report_of(run_cli({"inflate", one_line, "-o", folder / "a.obj", "--json"}));
  CHECK(report.at("details").at("used").get<double>() == Approx(240.0 / 300));
  for (const auto& [drawing, left_out] : {std::pair(ear + bodies, "body"), std::pair(ears + eight, "eight")}) {
    const std::string sketch = folder.write("left_out.svg", svg(drawing));
    const ProcessResult result = run_cli({"inflate", sketch, "-o", folder / "b.obj", "--json", "--preset", "clean"});
    INFO(result.out << result.err);
    CHECK(result.code == 4);
    const Json refused = report_of(result);
    CHECK(refused.at("error").at("code") == "E_LEFT_OUT");
    CHECK(refused.at("error").at("subject")[0].at("id") == left_out);
    const auto is_reason = [](const Json& finding) { return finding.at("code") == "E_CROSS"; };
    CHECK(std::ranges::any_of(refused.at("errors"), is_reason));
    CHECK(!std::filesystem::exists(folder / "b.obj"));
  }
}

TEST_CASE("kinds that strokes are given hold, and those that don't exist are named") {
  const ScratchFolder folder;
  const auto inflated = [&](const std::string& kind) {
    const std::string head = "<circle id=\"head\" cx=\"50\" cy=\"50\" r=\"150\"/>";
    const std::string odd = "<path id=\"odd\" data-kind=\"" + kind + "\" d=\"M 20 20 L 80 20 L 80 80 Z\"/>";
    return run_cli({"inflate", folder.write("kind.svg", svg(head + odd)), "-o", folder / "a.obj", "--json"});
  };
  for (const char* kind : {"part", "hole", "blob", "detail", "ignored"}) {
    INFO(kind);
    const ProcessResult result = inflated(kind);
    CHECK(result.code == 0);
    CHECK(report_of(result).at("details").at("kinds").at("odd") == kind);
  }
  const ProcessResult result = inflated("pear");
  CHECK(result.code == 0);
  const Json warning = report_of(result).at("warnings")[0];
  CHECK(warning.at("code") == "E_NOT_SUPPORTED");
  CHECK(warning.at("subject")[0]["id"] == "odd");
}

TEST_CASE("a mouth is drawn on the solid, or cut into it where that is asked for") {
  const ScratchFolder folder;
  const std::string head = "<circle id=\"head\" cx=\"50\" cy=\"50\" r=\"150\"/>";
  const std::string mouth = "<path id=\"mouth\" data-kind=\"detail\" d=\"M 0 90 L 50 110 L 100 90\"/>";
  const std::string sketch = folder.write("face.svg", svg(head + mouth));
  const std::vector<std::string> command{"inflate", sketch, "-o", folder / "a.obj", "--json"};
  const Json drawn = report_of(run_cli(command));
  CHECK(!drawn.at("details").contains("carved"));
  for (const char* shape : {"groove", "ridge"}) {
    std::vector<std::string> carving = command;
    carving.insert(carving.end(), {"--details", shape, "--detail-width", "10"});
    const Json report = report_of(run_cli(carving));
    CHECK(report.at("details").at("carved") == 1);
    CHECK(report.at("mesh").at("closed") == true);
    CHECK(report.at("mesh").at("self_intersections") == 0);
    CHECK(report.at("mesh").at("euler_characteristic") == 2);
    const double more = report.at("mesh").at("volume").get<double>() - drawn.at("mesh").at("volume").get<double>();
    CHECK((more > 0) == (std::string(shape) == "ridge"));
    CHECK(run_cli({"check", folder / "a.obj"}).code == 0);
  }
}

TEST_CASE("a tube with a radius is a knot in one stroke, and a swap another one") {
  const ScratchFolder folder;
  std::string path = "M";
  for (int i = 0; i < 120; ++i) {
    const double t = i * 0.05235987755982989, out = 200 + 90 * std::cos(3 * t);
    path += (i == 0 ? "" : "L") + std::to_string(out * std::cos(2 * t)) + "," + std::to_string(out * std::sin(2 * t));
  }
  const auto sketch = [&](const std::string& data) {
    return folder.write("knot.svg", svg("<path id=\"knot\" data-kind=\"tube\" " + data + " d=\"" + path + "Z\"/>"));
  };
  const std::string good = sketch("data-radius=\"24\"");
  const Json plain = report_of(run_cli({"inflate", good, "-o", folder / "knot.obj", "--json"}));
  CHECK(plain.at("details").at("overlaps").size() == 3);
  CHECK(plain.at("mesh").at("euler_characteristic") == 0);
  CHECK(plain.at("mesh").at("self_intersections") == 0);
  CHECK(plain.at("details").at("kinds").at("knot") == "tube");
  CHECK(run_cli({"check", folder / "knot.obj"}).code == 0);
  CHECK(run_cli({"inflate", good, "-o", folder / "other.obj", "--swap", "0", "--swap", "2"}).code == 0);
  CHECK(slurp(folder / "other.obj") != slurp(folder / "knot.obj"));
  const ProcessResult missing = run_cli({"inflate", good, "-o", folder / "bad.obj", "--swap", "3"});
  CHECK(missing.code == 2);
  CHECK(missing.err.find("overlap 3 doesn't exist") != std::string::npos);
  for (const std::string data : {"data-radius=\"0\"", "data-radius=\"90\"", "data-radius=\"9\" data-ends=\"cut\""}) {
    const ProcessResult refused = run_cli({"inflate", sketch(data), "-o", folder / "bad.obj", "--json"});
    INFO(data << refused.err);
    CHECK(refused.code == 4);
    const Json error = Json::parse(refused.out).at("error");
    CHECK(error.at("code") == "E_TUBE");
    CHECK(error.at("subject").at(0).at("id") == "knot");
  }
  CHECK_FALSE(std::filesystem::exists(folder / "bad.obj"));
}

TEST_CASE("sketches that can't be read are exit code 3") {
  const ScratchFolder folder;
  std::string deep = "<svg xmlns=\"http://www.w3.org/2000/svg\">";
  for (int i = 0; i < 100000; ++i) deep += "<g>";
  const std::vector<std::pair<std::string, std::string>> files = {
      {"empty.svg", ""},
      {"text.svg", "a letter to a friend"},
      {"truncated.svg", "<svg xmlns=\"http://www.w3.org/2000/svg\"><path id=\"a\" d=\"M 0 0 L 1"},
      {"nan.svg", svg("<path id=\"a\" d=\"M 0 0 L 1e999 5 L 3 4 Z\"/>")},
      {"path.svg", svg("<path id=\"a\" d=\"M 0 0 L 100 pear\"/>")},
      {"blank.svg", svg("")},
      {"deep.svg", deep},
  };
  for (const auto& [name, bytes] : files) {
    const ProcessResult result =
        run_cli({"inflate", folder.write(name, bytes), "-o", folder / "a.obj", "--json", "--progress", "none"});
    INFO(name << ": " << result.err);
    CHECK(result.code == 3);
    CHECK(result.peak_kilobytes < 200 * 1024);
    CHECK(report_of(result).at("error")["code"].get<std::string>().starts_with("E_"));
  }
  CHECK(std::filesystem::exists(folder / "a.obj") == false);
}

TEST_CASE("running out of time or memory is exit code 5, an interrupt 130, and nothing is written") {
  const ScratchFolder folder;
  const std::string sketch = sketches / "weave.svg";
  const std::vector<std::string> base = {"inflate", sketch, "-o", folder / "a.obj", "--resolution", "2"};
  auto with = [&base](std::vector<std::string> extra) {
    extra.insert(extra.begin(), base.begin(), base.end());
    return extra;
  };
  CHECK(run_cli(with({"--timeout", "0.02"})).code == 5);
  for (const char* size : {"36M", "38M", "40M", "44M", "48M"}) {
    INFO(size);
    if (!is_sanitized) CHECK(run_cli(with({"--max-memory", size})).code == 5);
  }
  // On a busy machine the signal may come before the program listens: shells show 130 for that, too.
  const int interrupted = run_cli(with({}), {.interrupt_after_ms = 120}).code;
  CHECK((interrupted == 130 || interrupted == -SIGINT));
  CHECK(folder.names().empty());
}

TEST_CASE("progress as JSON lines rises to 1") {
  const ScratchFolder folder;
  const ProcessResult result =
      run_cli({"inflate", sketches / "snake.svg", "-o", folder / "a.obj", "--progress", "json", "--quiet"});
  REQUIRE(result.code == 0);
  double last = -1;
  std::size_t lines = 0;
  std::istringstream stream(result.err);
  for (std::string line; std::getline(stream, line); ++lines) {
    const double fraction = Json::parse(line)["progress"];
    CHECK(fraction >= last);
    last = fraction;
  }
  CHECK(lines > 5);
  CHECK(last == Approx(1));
}

}  // namespace
}  // namespace croquis::test

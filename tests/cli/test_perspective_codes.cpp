// SPDX-License-Identifier: GPL-3.0-or-later
#include <map>
#include <regex>
#include <set>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "cli/perspective_code_drawings.h"
#include "cli/process.h"
#include "croquis/io/perspective_drawing_file.h"

namespace croquis::test {
namespace {

using Json = nlohmann::json;

std::set<std::string> strokes_of(const Json& finding) {
  std::set<std::string> names;
  for (const Json& subject : finding.at("subject")) {
    if (subject.at("kind") == "stroke") names.insert(subject.at("id"));
  }
  return names;
}

/// How often the report lists each stroke; a parsed object would hide one that comes twice.
std::map<std::string, int> stroke_keys(const std::string& text) {
  const std::string opening = "\"strokes\":{";
  const std::size_t begin = text.find(opening) + opening.size() - 1;
  const std::string list = text.substr(begin, text.find('}', begin) - begin);
  std::map<std::string, int> keys;
  const std::regex entry("\"([^\"]+)\":\"");
  for (std::sregex_iterator at(list.begin(), list.end(), entry), end; at != end; ++at) ++keys[(*at)[1]];
  return keys;
}

/// Every stroke of the drawing once, flagged exactly when a finding names it.
void check_strokes(const std::string& text, const std::string& svg) {
  const Json report = Json::parse(text);
  std::set<std::string> named;
  for (const Json& warning : report.at("warnings")) named.merge(strokes_of(warning));
  Progress progress;
  const PerspectiveDrawing drawing = read_perspective_svg(svg, "drawing.svg", progress).drawing;
  std::map<std::string, int> keys = stroke_keys(text);
  CHECK(keys.size() == drawing.strokes.size());
  for (const PerspectiveStroke& stroke : drawing.strokes) {
    INFO(stroke.id);
    CHECK(keys[stroke.id] == 1);
    CHECK(report.at("details").at("strokes").at(stroke.id) == (named.contains(stroke.id) ? "flagged" : "used"));
  }
}

}  // namespace

TEST_CASE("every code of a perspective drawing comes of a drawing, at its level, and names its strokes") {
  for (const CodeDrawing& drawing : code_drawings()) {
    INFO(drawing.code << ", exit code " << drawing.exit_code);
    const ScratchFolder folder;
    const std::string file = folder.write("drawing.svg", drawing.svg);
    std::vector<std::string> words{"perspective", file, "-o", folder / "solid.obj", "--json", "--quiet"};
    words.insert(words.end(), drawing.options.begin(), drawing.options.end());
    const ProcessResult result = run_cli(words);
    CHECK(result.code == drawing.exit_code);
    const Json report = Json::parse(result.out);
    const Json& told = report.at(result.code == 0 ? "warnings" : "errors");
    INFO(told.dump());
    int findings = 0;
    std::set<std::string> named;
    for (const Json& finding : told) {
      if (finding.at("code") != drawing.code) continue;
      ++findings;
      named.merge(strokes_of(finding));
    }
    CHECK(findings == drawing.findings);
    CHECK(named == drawing.strokes);
    CHECK(std::filesystem::exists(folder / "solid.obj") == (drawing.exit_code == 0));
    if (result.code == 0) check_strokes(result.out, drawing.svg);
    words.push_back("--strict");
    CHECK(run_cli(words).code == (drawing.exit_code != 0 ? drawing.exit_code : 1));
  }
}

TEST_CASE("a search for faces whose limit leaves none ends with the code of limits") {
  for (const CodeDrawing& drawing : code_drawings()) {
    if (drawing.code != "AMBIGUOUS") continue;
    const ScratchFolder folder;
    const std::string file = folder.write("drawing.svg", drawing.svg);
    CHECK(run_cli({"perspective", file, "-o", folder / "solid.obj", "--search-limit", "10"}).code == 5);
    CHECK_FALSE(std::filesystem::exists(folder / "solid.obj"));
  }
}

TEST_CASE("folded faces are divided, and close without folds") {
  for (const std::string& svg : folding_drawings()) {
    const ScratchFolder folder;
    const std::string file = folder.write("drawing.svg", svg);
    const ProcessResult result =
        run_cli({"perspective", file, "-o", folder / "solid.obj", "--patches", folder / "patches.json", "--json"});
    REQUIRE(result.code == 0);
    const Json report = Json::parse(result.out);
    INFO(report.at("warnings").dump());
    CHECK(report.at("warnings").empty());
    const Json& details = report.at("details");
    CHECK(details.at("closed") == true);
    CHECK(details.at("faces").size() == 10);
    for (const Json& face : details.at("faces")) {
      if (face.at("kind") == "patch") CHECK(face.at("strokes").at(0).size() == 8);
    }
    CHECK(details.at("max_g1_angle_degrees").get<double>() < 1e-6);
    std::set<std::string> filled;
    const Json file_of_patches = Json::parse(slurp(folder / "patches.json"));
    for (const Json& patch : file_of_patches.at("patches")) filled.insert(patch.at("face"));
    CHECK(filled.size() == 1);
    CHECK(run_cli({"check", folder / "solid.obj"}).code == 0);
    // What goes on from the solid knows nothing of the division.
    CHECK(run_cli({"perspective", file, "--cage", folder / "cage.obj", "--network", folder / "net.json"}).code == 0);
    CHECK(run_cli({"check", folder / "cage.obj"}).code == 0);
    if (CROQUIS_HAS_STEP) CHECK(run_cli({"perspective", file, "-o", folder / "solid.step"}).code == 0);
  }
}

}  // namespace croquis::test

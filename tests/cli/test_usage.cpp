// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <sstream>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "cli/process.h"
#include "croquis/io/project_file.h"
#include "croquis/io/svg_drawing.h"
#include "croquis/operators/all_operations.h"

namespace croquis::test {
namespace {

using Json = nlohmann::json;

const char* const cube_obj =
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n"
    "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";

const char* const triangle_ply =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
    "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";

const char* const circle_svg =
    "<svg xmlns=\"http://www.w3.org/2000/svg\"><circle id=\"c\" cx=\"100\" cy=\"100\" r=\"80\"/></svg>";

const std::vector<std::string> subcommands = {"inflate", "cage", "perspective", "subdivide", "fair",
                                              "fill",    "edit", "info",        "check",     "convert",
                                              "render",  "run",  "operations",  "edits"};

/// The circle and a node "inflate" that makes it a solid.
void write_project(const std::string& path) {
  Progress progress;
  Node sketch;
  sketch.source = std::make_shared<const Drawing>(read_svg_drawing(circle_svg, "circle.svg", progress).drawing);
  Node solid;
  solid.name = "inflate";
  solid.operation = "inflate";
  solid.inputs["drawing"] = {1, "value"};
  save_project(path, {Document().with(sketch).with(solid), {}, {}}, progress);
}

/// The example lines of a help text, without the program's name.
std::vector<std::string> examples_of(const std::string& help) {
  std::vector<std::string> lines;
  std::istringstream stream(help);
  for (std::string line; std::getline(stream, line);) {
    if (line.starts_with("  croquis-cli ")) lines.push_back(line.substr(14));
  }
  return lines;
}

/// Splits at spaces outside of single quotes, as a shell does, and cuts at a redirection.
std::vector<std::string> words_of(const std::string& line) {
  std::vector<std::string> words;
  std::istringstream stream(line);
  for (std::string word; stream >> word && word != ">";) {
    if (word.starts_with('\'')) {
      std::string rest;
      std::getline(stream, rest, '\'');
      word = word.substr(1) + rest;
    }
    words.push_back(word);
  }
  return words;
}

TEST_CASE("help names every subcommand and each has examples that work") {
  const ProcessResult help = run_cli({"--help"});
  CHECK(help.code == 0);
  const ScratchFolder folder;
  folder.write("model.obj", cube_obj);
  folder.write("solid.obj", cube_obj);
  folder.write("scan.ply", triangle_ply);
  folder.write("tags.json", "{\"format\": \"croquis-tags-1\", \"edges\": [{\"v\": [0, 1], \"sharpness\": 2}]}");
  folder.write("sketch.svg", circle_svg);
  folder.write("drawing.svg",
               slurp(std::filesystem::path(CROQUIS_SOURCE_DIR) / "examples/data/perspective/bracket.svg"));
  write_project(folder / "project.croq");
  for (const std::string& name : subcommands) {
    INFO(name);
    CHECK(help.out.find("  " + name) != std::string::npos);
    const ProcessResult own = run_cli({name, "--help"});
    CHECK(own.code == 0);
    const auto examples = examples_of(own.out);
    CHECK_FALSE(examples.empty());
    for (const std::string& example : examples) {
      INFO(example);
      const ProcessResult result = run_cli(words_of(example), {.folder = folder.path()});
      INFO(result.err);
      CHECK(result.code == 0);
    }
  }
}

TEST_CASE("the version is printed") {
  const ProcessResult result = run_cli({"--version"});
  CHECK(result.code == 0);
  CHECK(result.out.starts_with("croquis-cli "));
}

TEST_CASE("wrong usage is answered with exit code 2 and the word at fault") {
  struct Case {
    std::vector<std::string> arguments;
    std::string word;
  };
  const ScratchFolder folder;
  const std::string sketch = folder.write("sketch.svg", circle_svg);
  const std::string cube = folder.write("cube.obj", cube_obj);
  const std::vector<Case> cases = {
      {{}, "subcommand"},
      {{"inflat", sketch}, "inflat"},
      {{"inflate"}, "input"},
      {{"inflate", sketch}, "-o"},
      {{"inflate", sketch, "-o", folder / "a.obj", "--attach", "a"}, "attach"},
      {{"inflate", sketch, "-o", folder / "a.obj", "--alternatives", "0"}, "alternatives"},
      {{"inflate", sketch, "-o", folder / "a.obj", "--alternatives", "many"}, "alternatives"},
      {{"inflate", sketch, "-o", "-", "--alternatives", "2"}, "alternatives"},
      {{"inflate", sketch, "-o", folder / "a.obj", "--swap", "0"}, "overlap 0"},
      {{"inflate", sketch, "-o", folder / "a.obj", "--swap", "first"}, "swap"},
      {{"inflate", sketch, "-o", folder / "a.obj", "--surface", "blend"}, "--surface"},
      {{"inflate", sketch, "-o", folder / "a.obj", "--preset", "crayon"}, "preset"},
      {{"inflate", sketch, "-o", folder / "a.obj", "--min-gap", "7"}, "min-gap"},
      {{"inflate", sketch, "-o", folder / "a.obj", "--min-gap", "nan"}, "min-gap"},
      {{"inflate", sketch, "-o", folder / "a.obj", "--weight-distance", "0"}, "weight-distance"},
      {{"inflate", sketch, "-o", folder / "a.xyz"}, "a.xyz"},
      {{"cage", sketch}, "-o"},
      {{"cage", sketch, "-o", folder / "a.obj", "--rings", "0.1"}, "rings"},
      {{"cage", sketch, "-o", folder / "a.obj", "--min-gap", "7"}, "min-gap"},
      {{"inflate", sketch, "-o", folder / "a.obj", "--skeleton", folder / "a.obj"}, "a.obj"},
      {{"inflate", sketch, "-o", folder / "a.obj", "--max-memory", "lots"}, "lots"},
      {{"inflate", sketch, "-o", folder / "a.obj", "--timeout", "-1"}, "timeout"},
      {{"info", cube, "extra"}, "extra"},
      {{"convert", cube}, "output"},
      {{"convert", cube, "-o=" + (folder / "a.obj")}, "space"},
      {{"convert", "", "-o", folder / "a.obj"}, "empty"},
      {{"convert", cube, "-o", folder / "noextension"}, "noextension"},
      {{"render", cube, "-o", folder / "a.png", "--size", "0x10"}, "size"},
      {{"render", cube, "-o", folder / "a.jpg"}, "PNG"},
  };
  for (const Case& wrong : cases) {
    const ProcessResult result = run_cli(wrong.arguments);
    CAPTURE(wrong.arguments, result.err);
    CHECK(result.code == 2);
    CHECK(result.err.find(wrong.word) != std::string::npos);
    CHECK(result.out.empty());
  }
  CHECK(folder.names() == std::vector<std::string>{"cube.obj", "sketch.svg"});
}

/// The long names of a subcommand's options; those with a value are followed by a word for it.
std::vector<std::string> options_with_values(const std::string& help) {
  std::vector<std::string> names;
  std::istringstream stream(help);
  for (std::string line; std::getline(stream, line);) {
    const std::size_t name = line.find("--");
    if (!line.starts_with("  -") || name == std::string::npos) continue;
    const std::size_t end = line.find(' ', name);
    if (end != std::string::npos && end + 1 < line.size() && line[end + 1] != ' ') {
      names.push_back(line.substr(name, end - name));
    }
  }
  return names;
}

TEST_CASE("a missing value is never made up from what follows, whatever the option") {
  const ScratchFolder folder;
  const std::string cube = folder.write("cube.obj", cube_obj);
  for (const std::string& name : subcommands) {
    const std::vector<std::string> options = options_with_values(run_cli({name, "--help"}).out);
    CHECK(std::find(options.begin(), options.end(), "--threads") != options.end());
    const bool writes = std::find(options.begin(), options.end(), "--output") != options.end();
    for (const std::string& option : options) {
      for (const std::vector<std::string>& words : {std::vector<std::string>{option + "="}, {option, ""}}) {
        std::vector<std::string> line = {name, cube};
        line.insert(line.end(), words.begin(), words.end());
        if (writes) line.insert(line.end(), {"-o", folder / "a.obj"});
        if (name == "operations" || name == "edits") line.erase(line.begin() + 1);
        const ProcessResult result = run_cli(line);
        CAPTURE(line, result.err);
        CHECK(result.code == 2);
        CHECK(result.err.find(option) != std::string::npos);
      }
    }
  }
  CHECK(folder.names() == std::vector<std::string>{"cube.obj"});
}

TEST_CASE("wrong usage under --json is one object with every finding") {
  const ProcessResult result =
      run_cli({"inflate", "x.svg", "-o", "a.obj", "--min-gap", "7", "--resolution", "1", "--json"});
  CHECK(result.code == 2);
  const Json json = Json::parse(result.out);
  CHECK(json["command"] == "inflate");
  CHECK(json["error"]["code"] == "E_PARAMETER");
  REQUIRE(json["errors"].size() == 2);
  CHECK(json["errors"][0]["subject"][0]["id"] == "min-gap");
  CHECK(json["errors"][1]["subject"][0]["id"] == "resolution");
}

TEST_CASE("operations lists what the operations say of themselves") {
  const Json json = Json::parse(run_cli({"operations", "--json", "--quiet"}).out);
  const Registry registry = all_operations();
  const Json& list = json["details"]["operations"];
  REQUIRE(list.size() == registry.operations().size());
  for (std::size_t i = 0; i < list.size(); ++i) {
    const OperationDescription description = registry.operations()[i]->describe();
    CHECK(list[i]["id"] == description.id);
    CHECK(list[i]["sentence"] == description.sentence);
    REQUIRE(list[i]["parameters"].size() == description.parameters.size());
    // What works on a B-rep has no files of its own: it goes on from the command that makes one.
    const bool follows = description.inputs.front().type == ValueType::Brep;
    const std::string help = run_cli({follows ? "perspective" : description.id, "--help"}).out;
    const std::string before = follows ? description.outputs.front().name + "-" : "";
    for (std::size_t p = 0; p < description.parameters.size(); ++p) {
      CHECK(list[i]["parameters"][p]["name"] == description.parameters[p].name);
      CHECK(help.find("--" + before + description.parameters[p].name) != std::string::npos);
      CHECK(help.find(description.parameters[p].sentence.substr(0, 20)) != std::string::npos);
    }
  }
}

TEST_CASE("the reference page is what the program prints") {
  const std::string page = slurp(std::filesystem::path(CROQUIS_SOURCE_DIR) / "docs/operations.md");
  INFO("write it again with: croquis-cli operations > docs/operations.md");
  CHECK(run_cli({"operations"}).out == page);
}

TEST_CASE("the page of edits is what the program prints") {
  const std::string page = slurp(std::filesystem::path(CROQUIS_SOURCE_DIR) / "docs/edits.md");
  INFO("write it again with: croquis-cli edits > docs/edits.md");
  CHECK(run_cli({"edits"}).out == page);
}

TEST_CASE("every code that the sources use is documented") {
  const std::string page = slurp(std::filesystem::path(CROQUIS_SOURCE_DIR) / "docs/errors.md");
  for (const char* folder : {"src", "include"}) {
    for (const auto& entry :
         std::filesystem::recursive_directory_iterator(std::filesystem::path(CROQUIS_SOURCE_DIR) / folder)) {
      if (entry.path().extension() != ".cpp" && entry.path().extension() != ".h") continue;
      const std::string text = slurp(entry.path());
      for (std::size_t at = text.find('"'); at != std::string::npos; at = text.find('"', at + 1)) {
        const std::size_t end = text.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_", at + 1);
        const std::string word = text.substr(at + 1, end - at - 1);
        if (word.size() < 3 || text[end] != '"' || !(word.starts_with("E_") || word.starts_with("W_"))) continue;
        INFO(entry.path() << " uses " << word);
        CHECK(page.find("`" + word + "`") != std::string::npos);
      }
    }
  }
}

}  // namespace
}  // namespace croquis::test

// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "cli/process.h"
#include "cli/surface_networks.h"

namespace croquis::test {
namespace {

using Json = nlohmann::json;

const std::filesystem::path shipped = std::filesystem::path(CROQUIS_SOURCE_DIR) / "examples/data/surface";

std::string shipped_network(const std::string& name) { return (shipped / (name + ".json")).string(); }

Json reported(std::vector<std::string> words) {
  words.insert(words.begin(), "surface");
  words.insert(words.end(), {"--json", "--quiet"});
  const ProcessResult result = run_cli(words);
  INFO(result.err << result.out);
  REQUIRE(result.code == 0);
  return Json::parse(result.out);
}

Json questions(const Json& places) { return {{"format", "croquis-abs-places/1"}, {"places", places}}; }

double distance(const Json& a, const Json& b) {
  double sum = 0;
  for (std::size_t i = 0; i < 3; ++i) sum += std::pow(a.at(i).get<double>() - b.at(i).get<double>(), 2);
  return std::sqrt(sum);
}

/// Every face of a network in one mode, by the reference's figures.
void check_reference(const std::string& name, const Json& faces, const std::string& mode, const ScratchFolder& folder) {
  Json places = Json::array(), wanted = Json::array();
  for (const auto& [face, figures] : faces.items()) {
    if (!figures.contains(mode)) continue;
    for (const Json& entry : figures.at(mode)) {
      places.push_back({{"face", face}, {"fan", entry.at("fan")}});
      wanted.push_back(entry.at("p"));
    }
  }
  if (places.empty()) return;
  const std::string file = folder.write("places.json", questions(places).dump());
  const Json report = reported({shipped_network(name), "--mode", mode, "--evaluate", file});
  const Json& evaluated = report.at("details").at("evaluated");
  REQUIRE(evaluated.size() == wanted.size());
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    INFO(name << ", " << mode << ", " << places[i].dump());
    CHECK(evaluated[i].at("face") == places[i].at("face"));
    CHECK(evaluated[i].at("fan") == places[i].at("fan"));
    CHECK(distance(evaluated[i].at("p"), wanted[i]) < 1e-7);
    CHECK(distance(evaluated[i].at("normal"), {0, 0, 0}) == Approx(1));
  }
  for (const Json& patch : report.at("details").at("patches")) {
    const Json& figures = faces.at(patch.at("face"));
    INFO(name << ", " << patch.dump());
    for (std::size_t i = 0; i < figures.at("side_lengths").size(); ++i)
      CHECK(patch.at("side_lengths")[i].get<double>() ==
            Approx(figures.at("side_lengths")[i].get<double>()).margin(1e-7));
    CHECK(patch.at("beta").get<double>() == Approx(figures.at("beta").get<double>()).margin(1e-7));
    CHECK(patch.at("radius").get<double>() == Approx(figures.at("R").get<double>()).margin(1e-7));
    CHECK(patch.at("centre_inside") == figures.at("centre_inside"));
  }
}

std::set<std::array<double, 3>> vertices_of(const std::string& obj) {
  std::set<std::array<double, 3>> vertices;
  std::istringstream lines(obj);
  std::string word;
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::array<double, 3> place{};
    if (words >> word && word == "v" && words >> place[0] >> place[1] >> place[2]) vertices.insert(place);
  }
  return vertices;
}

/// Six straight faces.
Json box_network() {
  Json network{{"format", "croquis-abs/1"}, {"nodes", Json::array()}, {"curves", Json::array()}};
  for (int i = 0; i < 8; ++i)
    network["nodes"].push_back({{"id", "n" + std::to_string(i)}, {"p", {i & 1, (i >> 1) & 1, i >> 2}}});
  const int quads[][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  for (const auto& quad : quads) {
    Json loop = Json::array();
    for (int k = 0; k < 4; ++k) {
      const int from = quad[k], to = quad[(k + 1) % 4], low = std::min(from, to), high = std::max(from, to);
      const std::string id = "c" + std::to_string(low) + std::to_string(high);
      bool known = false;
      for (const Json& curve : network["curves"]) known = known || curve["id"] == id;
      if (!known)
        network["curves"].push_back(
            {{"id", id}, {"from", "n" + std::to_string(low)}, {"to", "n" + std::to_string(high)}});
      loop.push_back((from < to ? "+" : "-") + id);
    }
    network["faces"].push_back({{"id", "face" + std::to_string(network["faces"].size())}, {"loop", loop}});
  }
  return network;
}

/// Two faces of the same two curves, with a point above and one below.
Json pillow_network() {
  return Json::parse(R"({"format": "croquis-abs/1",
    "nodes": [{"id": "a", "p": [0, 0, 0]}, {"id": "b", "p": [3, 0, 0]}],
    "curves": [{"id": "low", "from": "a", "to": "b", "ctrl": [[0, 0, 0], [1, -1.2, 0], [2, -1.2, 0], [3, 0, 0]]},
               {"id": "high", "from": "a", "to": "b", "ctrl": [[0, 0, 0], [1, 1.2, 0], [2, 1.2, 0], [3, 0, 0]]}],
    "faces": [{"id": "top", "loop": ["+low", "-high"]}, {"id": "bottom", "loop": ["+high", "-low"]}],
    "points": [{"id": "p", "face": "top", "p": [1.5, 0, 0.5]}, {"id": "q", "face": "bottom", "p": [1.5, 0, -0.5]}]})");
}

}  // namespace

TEST_CASE("the reference's figures come back for every shipped network, in every mode") {
  const ScratchFolder folder;
  const Json expected =
      Json::parse(slurp(std::filesystem::path(CROQUIS_SOURCE_DIR) / "tests/cli/networks/expected.json"));
  REQUIRE(expected.size() == 4);
  for (const auto& [name, faces] : expected.items()) {
    for (const char* mode : {"smooth", "position", "paper"})
      check_reference(name.substr(name.find('/') + 1), faces, mode, folder);
  }
}

TEST_CASE("the car is written with a group for each patch, open along its free curves alone") {
  const ScratchFolder folder;
  const Json report = reported({shipped_network("car_crashed"), "-o", folder / "car.obj"});
  CHECK(report.at("warnings").size() == 1);  // some of its patches cross
  CHECK(report.at("warnings").at(0).at("code") == "W_SELF_INTERSECTION");
  CHECK(report.at("mesh").at("vertices") == 11633);  // 12261 samples, those of shared curves once
  CHECK(report.at("mesh").at("faces") == 23040);
  CHECK(report.at("mesh").at("boundary_edges") == 224);
  CHECK(report.at("mesh").at("nonmanifold_edges") == 0);
  CHECK(report.at("mesh").at("oriented") == true);
  const Json& details = report.at("details");
  CHECK(details.at("patches").size() == 21);
  CHECK(details.at("boundary_error").get<double>() < 1e-11);
  CHECK(details.at("attribute_errors").size() == 4);
  for (const auto& [id, error] : details.at("attribute_errors").items()) CHECK(error.get<double>() < 1e-12);
  CHECK(details.at("g1_angle_degrees").get<double>() < 0.1);
  const std::string obj = slurp(folder / "car.obj");
  for (const Json& patch : details.at("patches"))
    CHECK(obj.find("\ng " + patch.at("face").get<std::string>() + "\n") != std::string::npos);
}

TEST_CASE("closed networks become solids that pass the check, as fans and within a tolerance") {
  const ScratchFolder folder;
  for (const Json& network : {box_network(), pillow_network()}) {
    const std::string file = folder.write("network.json", network.dump());
    for (const std::vector<std::string>& options :
         {std::vector<std::string>{"--samples", "5"}, {"--samples", "16"}, {"--tolerance", "0.01"}}) {
      for (const char* format : {"obj", "ply", "stl"}) {
        std::vector<std::string> words{file, "-o", folder / (std::string("solid.") + format)};
        words.insert(words.end(), options.begin(), options.end());
        const Json report = reported(words);
        CHECK(report.at("mesh").at("closed") == true);
        CHECK(report.at("mesh").at("volume").get<double>() > 0);
        const ProcessResult check = run_cli({"check", words[2], "--quiet"});
        INFO(network.dump() << options[0] << ' ' << options[1] << ' ' << format << check.err);
        CHECK(check.code == 0);
      }
    }
  }
}

TEST_CASE("options go before what the file says of its faces") {
  const ScratchFolder folder;
  const std::string places =
      folder.write("places.json", questions({{{"face", "hood"}, {"fan", {0, 0.2, 0.3}}}}).dump());
  const auto evaluated = [&](std::vector<std::string> options) {
    options.insert(options.begin(), {shipped_network("car_intact"), "--evaluate", places});
    return reported(options).at("details").at("evaluated")[0].at("p");
  };
  const Json plain = evaluated({});
  CHECK(evaluated({"--mode", "smooth"}) == plain);
  CHECK(evaluated({"--fullness", "0.7"}) == plain);
  CHECK(evaluated({"--domain", "chordlength"}) == plain);
  CHECK(evaluated({"--mode", "position"}) != plain);
  CHECK(evaluated({"--fullness", "1.2"}) != plain);
  CHECK(evaluated({"--domain", "uniform"}) != plain);
  for (const std::vector<std::string>& wrong : {std::vector<std::string>{"--fullness", "2.5"},
                                                {"--fullness", "much"},
                                                {"--mode", "round"},
                                                {"--samples", "0"},
                                                {"--tolerance", "-1"}}) {
    std::vector<std::string> words{"surface", shipped_network("tri_point"), "-o", folder / "x.obj"};
    words.insert(words.end(), wrong.begin(), wrong.end());
    INFO(wrong[0] << ' ' << wrong[1]);
    CHECK(run_cli(words).code == 2);
  }
  CHECK(run_cli({"surface", shipped_network("tri_point")}).code == 2);
}

TEST_CASE("a finer tolerance gives more triangles, and points are vertices of them and of fans") {
  const ScratchFolder folder;
  const Json network = Json::parse(slurp(shipped_network("car_crashed")));
  std::size_t before = 0;
  for (const auto& [option, value] : {std::pair("--tolerance", "0.05"), std::pair("--tolerance", "0.01"),
                                      std::pair("--tolerance", "0.002"), std::pair("--samples", "16")}) {
    INFO(option << ' ' << value);
    const Json report = reported({shipped_network("car_crashed"), "-o", folder / "car.obj", option, value});
    CHECK(report.at("warnings").size() == 1);
    CHECK(report.at("warnings").at(0).at("code") == "W_SELF_INTERSECTION");
    CHECK(report.at("mesh").at("nonmanifold_edges") == 0);
    CHECK(report.at("mesh").at("components") == 1);
    const std::size_t faces = report.at("mesh").at("faces");
    if (option == std::string("--tolerance")) CHECK(faces > before);
    before = faces;
    const std::set<std::array<double, 3>> vertices = vertices_of(slurp(folder / "car.obj"));
    for (const Json& node : network.at("nodes")) CHECK(vertices.contains(node.at("p").get<std::array<double, 3>>()));
    for (const Json& point : network.at("points")) {
      const auto p = point.at("p").get<std::array<double, 3>>();
      CHECK(std::ranges::any_of(vertices, [&](const std::array<double, 3>& vertex) {
        return std::hypot(vertex[0] - p[0], vertex[1] - p[1], vertex[2] - p[2]) < 1e-12;
      }));
    }
  }
}

TEST_CASE("a surface has the same bytes for any number of threads, from a file and through streams") {
  const ScratchFolder folder;
  for (const char* threads : {"1", "2", "7"}) {
    REQUIRE(run_cli({"surface", shipped_network("car_crashed"), "-o", folder / (std::string(threads) + ".obj"),
                     "--threads", threads, "--quiet"})
                .code == 0);
    CHECK(slurp(folder / "1.obj") == slurp(folder / (std::string(threads) + ".obj")));
  }
  ProcessOptions options;
  options.standard_input = slurp(shipped_network("car_crashed"));
  const ProcessResult piped =
      run_cli({"surface", "-", "--input-format", "json", "-o", "-", "--output-format", "obj", "--quiet"}, options);
  CHECK(piped.code == 0);
  CHECK(piped.out == slurp(folder / "1.obj"));
  options.standard_input = questions({{{"face", "hood"}, {"fan", {0, 0, 0}}}}).dump();
  const ProcessResult asked =
      run_cli({"surface", shipped_network("car_crashed"), "--evaluate", "-", "--json"}, options);
  CHECK(asked.code == 0);
  CHECK(Json::parse(asked.out).at("details").at("evaluated").size() == 1);
  CHECK(run_cli({"surface", "-", "--evaluate", "-"}, options).code == 2);
}

TEST_CASE("wrong questions are refused with the file that they are in and every place that is wrong") {
  const ScratchFolder folder;
  const std::string file = folder.write(
      "places.json", questions({{{"face", "hood"}, {"fan", {4, 0, 0}}}, {{"face", "hod"}, {"fan", {0, 0, 0}}}}).dump());
  const ProcessResult result =
      run_cli({"surface", shipped_network("car_intact"), "--evaluate", file, "--json", "--quiet"});
  CHECK(result.code == 3);
  CHECK(Json::parse(result.out).at("errors").size() == 2);
}

TEST_CASE("the network of a drawing in perspective goes on to a surface") {
  const ScratchFolder folder;
  const std::string drawing = CROQUIS_SOURCE_DIR "/examples/data/perspective/bracket.svg";
  REQUIRE(run_cli({"perspective", drawing, "-o", folder / "solid.obj", "--network", folder / "network.json"}).code ==
          0);
  const Json report = reported({folder / "network.json", "-o", folder / "surface.obj"});
  CHECK(report.at("details").at("patches").size() == Json::parse(slurp(folder / "network.json")).at("faces").size());
}

}  // namespace croquis::test

// SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>
#include <set>
#include <string>

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "cli/process.h"
#include "cli/surface_networks.h"

namespace croquis::test {
namespace {

using Json = nlohmann::json;

/// Ids that all findings of a code name.
std::set<std::string> named_by(const Json& findings, const std::string& code) {
  std::set<std::string> named;
  for (const Json& finding : findings) {
    if (finding.at("code") != code) continue;
    for (const Json& subject : finding.at("subject"))
      named.insert(std::filesystem::path(subject.at("id").get<std::string>()).filename());
  }
  return named;
}

std::string good_questions(const ScratchFolder& folder) {
  return folder.write("places.json",
                      R"({"format": "croquis-abs-places/1", "places": [{"face": "good", "fan": [0, 0.3, 0.4]},
                          {"face": "bad", "fan": [0, 0.1, 0.1]}]})");
}

/// The places of one part of an OBJ file's faces.
std::set<std::string> groups_of(const std::string& obj) {
  std::set<std::string> groups;
  for (std::size_t at = obj.find("\ng "); at != std::string::npos; at = obj.find("\ng ", at + 1))
    groups.insert(obj.substr(at + 3, obj.find('\n', at + 1) - at - 3));
  return groups;
}

}  // namespace

TEST_CASE("every code of a network comes of a network, names its elements, and leaves the other faces as they are") {
  const ScratchFolder untouched;
  const Json before = Json::parse(run_cli({"surface", untouched.write("network.json", two_faces().dump()), "--json",
                                           "--quiet", "--evaluate", good_questions(untouched)})
                                      .out);
  CHECK(before.at("warnings").empty());
  const Json good_before = before.at("details").at("evaluated")[0];
  for (const CodeNetwork& wrong : code_networks()) {
    INFO(wrong.code << ": " << wrong.network.dump());
    const ScratchFolder folder;
    const std::string file = folder.write("network.json", wrong.network.dump());
    const ProcessResult result =
        run_cli({"surface", file, "-o", folder / "out.obj", "--json", "--quiet", "--evaluate", good_questions(folder)});
    INFO(result.out << result.err);
    CHECK(result.code == wrong.exit_code);
    const Json report = Json::parse(result.out);
    CHECK(named_by(report.at(wrong.exit_code == 0 ? "warnings" : "errors"), wrong.code) == wrong.named);
    CHECK(std::filesystem::exists(folder / "out.obj") == (wrong.exit_code == 0));
    if (wrong.exit_code != 0) continue;
    const Json& evaluated = report.at("details").at("evaluated");
    // Its neighbour may turn the normals along a smooth curve, and nothing else.
    if (wrong.network.dump().find("smooth") == std::string::npos) CHECK(evaluated[0] == good_before);
    CHECK(evaluated[0].at("p").is_array());
    CHECK(evaluated[1].at("p").is_null() == wrong.leaves_bad_out);
    const std::set<std::string> groups = groups_of(slurp(folder / "out.obj"));
    CHECK(groups.contains("good"));
    CHECK(groups.contains("bad") != wrong.leaves_bad_out);
    CHECK(run_cli({"surface", file, "-o", folder / "out.obj", "--quiet", "--strict"}).code == 1);
  }
}

TEST_CASE("a network of which no face can be made ends with all of its findings and leaves no file") {
  Json network = two_faces();
  network["faces"][0]["loop"] = {"+ab"};
  network["faces"][1]["loop"][1] = "+ef";
  const ScratchFolder folder;
  folder.write("out.obj", "as it was");
  const ProcessResult result =
      run_cli({"surface", folder.write("network.json", network.dump()), "-o", folder / "out.obj", "--json", "--quiet"});
  CHECK(result.code == 4);
  std::set<std::string> codes;
  const Json report = Json::parse(result.out);
  for (const Json& finding : report.at("errors")) codes.insert(finding.at("code"));
  CHECK(codes == std::set<std::string>{"E_OPEN_LOOP", "E_TOO_FEW"});
  CHECK(slurp(folder / "out.obj") == "as it was");
  network.erase("faces");
  CHECK(run_cli({"surface", folder.write("network.json", network.dump()), "-o", folder / "out.obj"}).code == 4);
}

}  // namespace croquis::test

// SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>

#include <catch2/catch.hpp>

#include "croquis/base/error.h"
#include "croquis/document/value_bytes.h"
#include "croquis/io/attribute_network_file.h"
#include "croquis/io/file.h"
#include "io/random_project.h"
#include "support/random.h"

using namespace croquis;
using namespace croquis::test;

namespace {

const std::filesystem::path network_seeds = std::filesystem::path(CROQUIS_FUZZ_FOLDER) / "corpus/network";

std::string bytes_of(const AttributeNetwork& network) {
  return encode(std::make_shared<const AttributeNetwork>(network));
}

Findings refused_network(const std::string& text) {
  try {
    read_attribute_network(text, "net.json");
  } catch (const Error& error) {
    return error.findings();
  }
  FAIL("it was read: " << text);
  return {};
}

/// The triangle of the format's description with a member replaced.
std::string triangle_with(const std::string& old, const std::string& replacement) {
  std::string text =
      R"({"format":"croquis-abs/1","name":"tri","units":"m","tolerance":1e-5,
 "nodes":[{"id":"a","p":[0,0,0]},{"id":"b","p":[3,0,0.1]},{"id":"c","p":[0.7,0.8,0.2]}],
 "curves":[{"id":"base","from":"a","to":"b","ctrl":[[0,0,0],[1,-0.1,0.48],[2,-0.1,0.52],[3,0,0.1]],"join":"crease"},
           {"id":"right","from":"b","to":"c"},{"id":"left","from":"c","to":"a"}],
 "faces":[{"id":"t","loop":["+base","+right","+left"],"mode":"smooth","fullness":0.7,"domain":"chordlength"}],
 "points":[{"id":"p","face":"t","p":[1.25,0.3,0.95],"fan":[0,0.1,0.1],"radius":0.3,"profile":"smooth"}]})";
  const std::size_t at = text.find(old);
  REQUIRE((old.empty() || at != std::string::npos));
  return old.empty() ? text : text.replace(at, old.size(), replacement);
}

void check_refused(const std::string& old, const std::string& replacement, const std::string& code,
                   const std::string& name, SubjectKind kind) {
  INFO(old << " -> " << replacement);
  const Findings findings = refused_network(triangle_with(old, replacement));
  CHECK(findings.size() == 1);
  CHECK(findings[0].code == code);
  CHECK(findings[0].category == Category::Malformed);
  CHECK(findings[0].message.find(name) != std::string::npos);
  REQUIRE(findings[0].subjects.size() == 1);
  CHECK(findings[0].subjects[0].kind == kind);
}

}  // namespace

TEST_CASE("an attribute network is read with every attribute") {
  const AttributeNetworkReadResult read =
      read_attribute_network(read_file((network_seeds / "all.json").string()), "all.json");
  const AttributeNetwork& network = read.network;
  CHECK(read.warnings.empty());
  CHECK(network.name == "tent");
  CHECK(network.units == "mm");
  CHECK(network.tolerance == 1e-5);
  REQUIRE(network.nodes.size() == 3);
  REQUIRE(network.curves.size() == 4);
  CHECK(network.curves[0].control[1] == Vec3(1, -1, 0.5));
  CHECK(control_polygon(network, network.curves[1]) == std::vector<Vec3>{Vec3(4, 0, 0.5), Vec3(1, 3, -0.25)});
  CHECK(network.curves[2].join == CurveJoin::Smooth);
  CHECK(network.curves[3].from == no_index);
  REQUIRE(network.faces.size() == 2);
  CHECK(network.faces[0].fullness == 0.9);
  CHECK(network.faces[0].inner == std::vector<InnerCurve>{{3, InnerProfile::Sharp, 0.2}});
  CHECK(network.faces[1].loop == std::vector<AttributeSide>{{2, true}, {1, true}, {0, true}});
  CHECK(network.faces[1].mode == AttributeMode::Position);
  CHECK(network.faces[1].domain == AttributeDomain::Uniform);
  CHECK(network.faces[1].fullness == 0.7);
  REQUIRE(network.points.size() == 2);
  CHECK(network.points[0].fan == FanPlace{0, 0.1, 0.25});
  CHECK(network.points[0].profile == PointProfile::Cone);
  CHECK(network.points[0].normal == Vec3(0, 0, 1));
  CHECK(network.points[1].face == 1);
  CHECK_FALSE(network.points[1].radius.has_value());
  REQUIRE(network.slopes.size() == 2);
  CHECK(network.slopes[0].at == std::vector<double>{0, 0.5, 1});
  CHECK(network.slopes[0].magnitude == 1.5);
  CHECK(network.slopes[1].face == no_index);
}

TEST_CASE("attribute networks come back from their own file bit by bit") {
  Random random(31);
  for (int i = 0; i < 60; ++i) {
    AttributeNetwork network = random_attribute_network(random);
    network.name = "n\xC3\xA4me";  // random names need not be UTF-8
    network.units = i % 2 == 0 ? "" : "mm";
    const AttributeNetworkReadResult read = read_attribute_network(write_attribute_network(network), "net.json");
    CHECK(read.warnings.empty());
    CHECK(bytes_of(read.network) == bytes_of(network));
  }
}

TEST_CASE("what is wrong with an attribute network is said of the element") {
  CHECK(validate(read_attribute_network(triangle_with("", ""), "net.json").network).empty());
  using enum SubjectKind;
  check_refused("\"p\":[0,0,0]", "\"p\":[\"NaN\",0,0]", "E_NOT_FINITE", "node \"a\"", Node);
  check_refused("[1,-0.1,0.48]", "[1,\"-Infinity\",0.48]", "E_NOT_FINITE", "curve \"base\"", Curve);
  check_refused("[1,-0.1,0.48]", "[1,-0.1]", "E_SYNTAX", "curve \"base\"", Curve);
  check_refused("[0.7,0.8,0.2]}", "[0.7,0.8,0.2]},{\"id\":\"a\",\"p\":[1,1,1]}", "E_DUP_ID", "Node \"a\"", Node);
  check_refused("\"from\":\"b\"", "\"from\":\"z\"", "E_NO_NODE", "curve \"right\": it refers to node \"z\"", Curve);
  check_refused(",\"to\":\"c\"", "", "E_NO_NODE", "Curve \"right\"", Curve);
  check_refused("+right", "+wrong", "E_NO_CURVE", "face \"t\": it refers to curve \"wrong\"", Face);
  check_refused("\"+left\"", "\"+left\",\"-base\"", "E_DUP_CURVE", "Face \"t\" has curve \"base\" twice", Face);
  check_refused("\"face\":\"t\"", "\"face\":\"u\"", "E_NO_FACE", "point \"p\": it refers to face \"u\"", Point);
  check_refused("[0,0.1,0.1]", "[3,0.1,0.1]", "E_SYNTAX", "Point \"p\"", Point);
  check_refused("\"fullness\":0.7", "\"fullness\":2.5", "E_SYNTAX", "Face \"t\"", Face);
  check_refused("\"mode\":\"smooth\"", "\"mode\":\"round\"", "E_SYNTAX", "face \"t\"", Face);
  check_refused("\"join\":\"crease\"", "\"join\":\"sharp\"", "E_SYNTAX", "curve \"base\"", Curve);
  check_refused("\"radius\":0.3", "\"radius\":0", "E_SYNTAX", "Point \"p\"", Point);
  check_refused("1e-5", "-1", "E_SYNTAX", "tolerance", File);
  check_refused("croquis-abs/1", "croquis-abs/2", "E_SYNTAX", "croquis-abs/1", File);
  CHECK(refused_network("{").at(0).code == "E_SYNTAX");
  CHECK(refused_network("").at(0).code == "E_EMPTY");
  // All at once.
  CHECK(refused_network(read_file((network_seeds / "wrong.json").string())).size() >= 8);
}

TEST_CASE("members that networks don't have are passed over with a warning") {
  const AttributeNetworkReadResult read =
      read_attribute_network(triangle_with("\"units\":\"m\"", "\"units\":\"m\",\"colour\":1"), "net.json");
  REQUIRE(read.warnings.size() == 1);
  CHECK(read.warnings[0].code == "W_IGNORED");
  CHECK(read.warnings[0].message.find("colour") != std::string::npos);
}

TEST_CASE("a mirrored network keeps its faces outside and its points in their places") {
  AttributeNetwork network = read_attribute_network(triangle_with("", ""), "net.json").network;
  Affine3 map;
  map.linear(2, 2) = -1;
  const AttributeNetwork mirrored = transformed(network, map);
  CHECK(mirrored.faces[0].loop == std::vector<AttributeSide>{{2, true}, {1, true}, {0, true}});
  // The fan place in model coordinates of the nodes' triangle, where it is affine.
  const auto place = [](const AttributeNetwork& n) {
    std::vector<Vec3> corners;
    for (const AttributeSide& side : n.faces[0].loop) {
      const AttributeCurve& curve = n.curves[side.curve];
      corners.push_back(n.nodes[side.reversed ? curve.to : curve.from].point);
    }
    const Vec3 middle = (corners[0] + corners[1] + corners[2]) / 3;
    const FanPlace fan = *n.points[0].fan;
    return Vec3(middle + fan.a * (corners[fan.corner] - middle) + fan.b * (corners[(fan.corner + 1) % 3] - middle));
  };
  network.points[0].fan = FanPlace{1, 0.1, 0.4};
  CHECK((place(transformed(network, map)) - map(place(network))).norm() < 1e-15);
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <limits>
#include <string>

#include <catch2/catch.hpp>

#include "croquis/base/error.h"
#include "croquis/io/perspective_drawing_file.h"
#include "fuzz/readers.h"
#include "support/perspective/solid_drawing.h"
#include "support/random.h"

using namespace croquis;
using namespace croquis::test;

namespace {

PerspectiveReadResult read(const std::string& svg) {
  Progress progress;
  return read_perspective_svg(svg, "drawing.svg", progress);
}

std::string in_svg(const std::string& body, const std::string& root = "viewBox=\"0 0 1000 750\"") {
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:cq=\"urn:croquis:perspective:1\" " + root + ">\n" + body +
         "\n</svg>\n";
}

PerspectiveStroke only_stroke(const std::string& body) {
  const PerspectiveReadResult result = read(in_svg(body));
  REQUIRE(result.drawing.strokes.size() == 1);
  return result.drawing.strokes[0];
}

std::vector<std::string> codes_of(const Findings& findings) {
  std::vector<std::string> codes;
  for (const Finding& finding : findings) codes.push_back(finding.code);
  return codes;
}

using Codes = std::vector<std::string>;

template <typename Read>
Findings errors_of(const Read& read_it) {
  try {
    read_it();
  } catch (const Error& error) {
    return error.findings();
  }
  return {};
}

/// Every field has another value than its default somewhere.
PerspectiveDrawing random_drawing(Random& random) {
  const auto number = [&] { return random.between(-3000, 3000) * std::pow(10, random.between(-12, 3)); };
  const auto point = [&] { return Vec2(number(), number()); };
  PerspectiveDrawing drawing;
  drawing.origin = point();
  drawing.image_size = {random.between(1, 1e5), random.between(1, 1e5)};
  if (random.below(2) == 0) drawing.known_point = KnownPoint{point(), Vec3(number(), number(), number())};
  for (std::uint32_t i = random.below(3); i > 0; --i) {
    drawing.known_lengths.push_back({"s" + std::to_string(i), random.between(0.1, 9)});
  }
  // As somebody may write them: not every angle in radians is one in degrees.
  if (random.below(2) == 0) drawing.field_of_view = std::round(random.between(1, 17900)) / 100 * std::acos(-1) / 180;
  if (random.below(2) == 0) drawing.principal_point = point();
  if (random.below(2) == 0) drawing.unit = "<mm> & \"inch\"";
  if (random.below(2) == 0) drawing.shells = 1 + static_cast<int>(random.below(4));
  for (int i = 0; i < 12; ++i) {
    PerspectiveStroke stroke;
    stroke.id = "stroke <" + std::to_string(i) + ">";
    stroke.role = static_cast<StrokeRole>(random.below(2));
    stroke.group = static_cast<StrokeGroup>(random.below(7));
    if (random.below(3) == 0) stroke.colour = random.below(2) == 0 ? "#123456" : "red";
    if (random.below(2) == 0) stroke.from = "v" + std::to_string(random.below(9));
    if (random.below(2) == 0) stroke.to = "v" + std::to_string(random.below(9));
    stroke.link = random.below(4) == 0;
    stroke.hidden = random.below(4) == 0;
    stroke.start_lock = static_cast<EndLock>(random.below(3));
    stroke.end_lock = static_cast<EndLock>(random.below(3));
    if (random.below(3) == 0) stroke.weight = random.between(0.1, 10);
    stroke.straight = is_parallel(stroke.group) || random.below(2) == 0;
    Vec2 start = point();
    for (std::uint32_t k = stroke.straight ? 1 : 1 + random.below(3); k > 0; --k) {
      const Vec2 end = point();
      const Vec2 third = (end - start) / 3;
      stroke.pieces.push_back(stroke.straight ? PictureCubic{start, start + third, end - third, end}
                                              : PictureCubic{start, point(), point(), end});
      start = end;
    }
    if (random.below(9) == 0) stroke.pieces[0][1].x() = std::numeric_limits<double>::quiet_NaN();
    if (stroke.straight) {
      const Vec2 from = stroke.start(), to = stroke.end(), third = (to - from) / 3;
      stroke.pieces = {{from, from + third, to - third, to}};
    }
    drawing.strokes.push_back(stroke);
  }
  return drawing;
}

}  // namespace

TEST_CASE("perspective drawings: SVG to JSON to SVG loses nothing") {
  Random random(3);
  for (int round = 0; round < 300; ++round) {
    const PerspectiveDrawing drawing = random_drawing(random);
    const std::string svg = write_perspective_svg(drawing);
    const PerspectiveDrawing from_svg = read(svg).drawing;
    INFO(svg);
    CHECK(same_drawing(from_svg, drawing));
    const std::string json = write_perspective_json(from_svg);
    const PerspectiveDrawing from_json = read_perspective_json(json, "drawing.json").drawing;
    CHECK(same_drawing(from_json, drawing));
    CHECK(write_perspective_svg(from_json) == svg);
    CHECK(write_perspective_json(from_json) == json);
  }
}

TEST_CASE("perspective drawings: those of the test solids come back the same, without findings") {
  for (const PerspectiveSolid& solid : all_solids()) {
    for (const View& view : {cropped_view(), three_point_views()[2]}) {
      SolidDrawingOptions options;
      options.noise = 1;
      options.hidden = true;
      const PerspectiveDrawing drawing = drawn(solid, view, options).drawing;
      const PerspectiveReadResult result = read(write_perspective_svg(drawing));
      CHECK(same_drawing(result.drawing, drawing));
      CHECK(result.warnings.empty());
      CHECK(fuzzed_reader("perspective").verdict_on(write_perspective_svg(drawing)).broken == "");
    }
  }
}

TEST_CASE("perspective drawings: the profile's attributes and metadata are read") {
  const PerspectiveDrawing drawing = read(R"(<svg xmlns="http://www.w3.org/2000/svg" xmlns:p="urn:croquis:perspective:1"
     p:profile="croquis-perspective/1" viewBox="10 20 1000 750">
 <metadata>
  <p:known at="207.9817 479.4756" point="0 0 -1.5"/>
  <p:length stroke="e01" value="4"/>
  <p:length stroke="e02" value="3"/>
  <p:fov_x_deg value="50"/>
  <p:principal at="500 375"/>
  <p:unit value="mm"/>
  <p:shells value="2"/>
 </metadata>
 <g p:role="construction" p:group="2">
  <path id="c20" d="M 1 2 L 3 40"/>
  <path id="c21" p:group="0" p:link="true" d="M 1 2 L 30 4"/>
 </g>
 <g p:role="edge" stroke-dasharray="6 4">
  <path id="e01" p:group="3" p:from="v0" p:to="v1" p:start-lock="smooth" p:end-lock="corner" p:weight="2.5"
        p:hidden="true" d="M 0 0 C 10 0 20 10 20 20"/>
 </g>
</svg>)")
                                         .drawing;
  CHECK(drawing.origin == Vec2(10, 20));
  CHECK(drawing.image_size == Vec2(1000, 750));
  CHECK(drawing.known_point == KnownPoint{Vec2(207.9817, 479.4756), Vec3(0, 0, -1.5)});
  CHECK(drawing.known_lengths == std::vector<KnownLength>{{"e01", 4}, {"e02", 3}});
  CHECK(drawing.field_of_view == 50 * std::acos(-1) / 180);
  CHECK(drawing.principal_point == Vec2(500, 375));
  CHECK(drawing.unit == "mm");
  CHECK(drawing.shells == 2);
  REQUIRE(drawing.strokes.size() == 3);
  CHECK(drawing.strokes[0].role == StrokeRole::Construction);
  CHECK(drawing.strokes[0].group == StrokeGroup::ParallelZ);
  CHECK(drawing.strokes[0].straight);
  CHECK(drawing.strokes[1].group == StrokeGroup::ParallelX);
  CHECK(drawing.strokes[1].link);
  const PerspectiveStroke& edge = drawing.strokes[2];
  CHECK(edge.role == StrokeRole::Edge);
  CHECK(edge.group == StrokeGroup::NormalX);
  CHECK((edge.from + " " + edge.to) == "v0 v1");
  CHECK((edge.start_lock == EndLock::Smooth && edge.end_lock == EndLock::Corner));
  CHECK((edge.weight == 2.5 && edge.hidden && !edge.straight));
  CHECK(edge.pieces == std::vector<PictureCubic>{{Vec2(0, 0), Vec2(10, 0), Vec2(20, 10), Vec2(20, 20)}});
  CHECK(edge.line == 17);
}

TEST_CASE("perspective drawings: files of other programs tell groups by colours and roles by dashes and layers") {
  const PerspectiveReadResult result = read(in_svg(R"svg(
<style>/* .a { stroke: red } */ .a, .wide { stroke-width: 3 } .a{stroke:#8a2be2}</style>
<g inkscape:groupmode="layer" inkscape:label="Construction lines" style="stroke:#f28c00">
 <path d="M 0 0 L 100 10"/>
 <path style="fill:none;stroke:#1f9d3a" d="M 0 0 L 100 90"/>
</g>
<g inkscape:groupmode="layer" inkscape:label="Hidden"><line x1="1" y1="2" x2="3" y2="4" stroke="blue"/></g>
<path class="wide a" d="M 5 5 v 100"/>
<path stroke="rgb(216, 31, 42)" stroke-dasharray="3 2" d="M 5 5 h 100"/>
<polyline stroke="#E0B400" points="0,0 50,10 80,60"/>
<path stroke="#777" d="M 9 9 L 20 9"/>
)svg"));
  const auto& strokes = result.drawing.strokes;
  REQUIRE(strokes.size() == 7);
  CHECK(strokes[0].role == StrokeRole::Construction);
  CHECK(strokes[0].group == StrokeGroup::ParallelX);
  CHECK(strokes[0].colour.empty());
  CHECK(strokes[1].group == StrokeGroup::ParallelY);
  CHECK(strokes[2].role == StrokeRole::Edge);
  CHECK(strokes[2].hidden);
  CHECK(strokes[2].group == StrokeGroup::NormalX);
  CHECK(strokes[2].colour == "blue");
  CHECK(strokes[3].group == StrokeGroup::ParallelZ);
  CHECK(strokes[4].role == StrokeRole::Construction);
  CHECK(strokes[4].group == StrokeGroup::NormalY);
  CHECK(strokes[5].group == StrokeGroup::NormalZ);
  CHECK(strokes[5].pieces.size() == 2);
  CHECK_FALSE(strokes[5].straight);
  CHECK(strokes[6].group == StrokeGroup::Unknown);
  CHECK(result.warnings.empty());
}

TEST_CASE("perspective drawings: colours") {
  const StrokeGroup all[] = {StrokeGroup::ParallelX, StrokeGroup::ParallelY, StrokeGroup::ParallelZ,
                             StrokeGroup::NormalX,   StrokeGroup::NormalY,   StrokeGroup::NormalZ};
  for (const StrokeGroup group : all) CHECK(group_of_colour(colour_of_group(group)) == group);
  CHECK(group_of_colour("orange") == StrokeGroup::ParallelX);
  CHECK(group_of_colour("#ff6600") == StrokeGroup::ParallelX);
  CHECK(group_of_colour(" #0f0 ") == StrokeGroup::ParallelY);
  CHECK(group_of_colour("purple") == StrokeGroup::ParallelZ);
  CHECK(group_of_colour("#00f") == StrokeGroup::NormalX);
  CHECK(group_of_colour("rgb(100%, 0%, 5%)") == StrokeGroup::NormalY);
  CHECK(group_of_colour("Yellow") == StrokeGroup::NormalZ);
  for (const char* other : {"", "none", "black", "#fff", "#808080", "#00ffff", "#ff1493", "#12", "#ggg", "rgb(1,2)"}) {
    CHECK(group_of_colour(other) == StrokeGroup::Unknown);
  }
}

TEST_CASE("perspective drawings: transforms apply, the sheet's scale doesn't") {
  const PerspectiveDrawing drawing =
      read(in_svg("<g transform=\"translate(100 50)\"><path transform=\"scale(2)\" d=\"M 1 2 L 30 4\"/></g>",
                  "width=\"210mm\" height=\"297mm\" viewBox=\"0 0 210 297\""))
          .drawing;
  CHECK(drawing.image_size == Vec2(210, 297));
  CHECK(drawing.strokes[0].start() == Vec2(102, 54));
  CHECK(drawing.strokes[0].end() == Vec2(160, 58));
  CHECK(read(in_svg("<path d=\"M 1 2 L 30 4\"/>", "width=\"200\" height=\"1in\"")).drawing.image_size == Vec2(200, 96));
  const PerspectiveReadResult bare = read(in_svg("<path d=\"M 1 2 L 31 4\"/>", ""));
  CHECK(codes_of(bare.warnings) == Codes{"W_NO_SHEET"});
  CHECK(bare.drawing.origin == Vec2(1, 2));
  CHECK(bare.drawing.image_size == Vec2(30, 2));
}

TEST_CASE("perspective drawings: arcs are cubics near the ellipse") {
  const PerspectiveStroke arc = only_stroke("<path d=\"M 300 200 A 100 50 0 1 1 200 150\"/>");
  CHECK(arc.pieces.size() == 3);
  CHECK(arc.end() == Vec2(200, 150));
  for (const PictureCubic& p : arc.pieces) {
    for (int i = 0; i <= 10; ++i) {
      const double t = i / 10.0, s = 1 - t;
      const Vec2 at = s * s * s * p[0] + 3 * s * s * t * p[1] + 3 * s * t * t * p[2] + t * t * t * p[3];
      CHECK(std::abs(std::hypot((at.x() - 200) / 100, (at.y() - 200) / 50) - 1) < 3e-4);
    }
  }
}

TEST_CASE("perspective drawings: sides of closed shapes are strokes") {
  const auto strokes = read(in_svg("<circle id=\"lens\" cx=\"100\" cy=\"100\" r=\"50\"/>"
                                   "<rect id=\"plate\" x=\"0\" y=\"0\" width=\"40\" height=\"30\"/>"
                                   "<path id=\"kite\" d=\"M 0 0 L 10 0 C 20 0 20 10 10 10 Z\"/>"))
                           .drawing.strokes;
  REQUIRE(strokes.size() == 11);
  CHECK((strokes[0].id + " " + strokes[1].id + " " + strokes[4].id) == "lens lens/2 plate");
  for (std::size_t i = 0; i < 4; ++i) {
    CHECK(strokes[i].end() == strokes[(i + 1) % 4].start());
    CHECK(strokes[4 + i].straight);
    CHECK(strokes[4 + i].end() == strokes[4 + (i + 1) % 4].start());
  }
  CHECK(strokes[8].straight);
  CHECK_FALSE(strokes[9].straight);
  CHECK(strokes[10].start() == Vec2(10, 10));
  CHECK(strokes[10].end() == Vec2(0, 0));
}

TEST_CASE("perspective drawings: strokes parallel to an axis are straight where they nearly are") {
  const std::string data = "d=\"M 0 0 C 30 0.2 60 -0.2 90 0.1 L 200 0\"/>";
  const PerspectiveStroke axis = only_stroke("<path cq:group=\"0\" " + data);
  CHECK(axis.straight);
  CHECK(axis.pieces.size() == 1);
  CHECK(axis.end() == Vec2(200, 0));
  CHECK(only_stroke("<path cq:group=\"4\" " + data).pieces.size() == 2);
  CHECK_FALSE(only_stroke("<path cq:group=\"0\" d=\"M 0 0 C 30 9 60 9 90 0\"/>").straight);
}

TEST_CASE("perspective drawings: what can't be used is kept") {
  const PerspectiveReadResult result =
      read(in_svg("<path id=\"a\" d=\"M 1 nan L 3 4\"/><path id=\"b\" d=\"M 5 5\"/>"
                  "<path id=\"c\" d=\"M 1e999 0 C 1 1 2 2 3 3\"/>"
                  "<path id=\"d\" d=\"M 1 1 L 9 9\"/>"));
  REQUIRE(result.drawing.strokes.size() == 4);
  CHECK_FALSE(result.drawing.strokes[0].start().allFinite());
  CHECK(result.drawing.strokes[1].start() == result.drawing.strokes[1].end());
  CHECK_FALSE(result.drawing.strokes[2].start().allFinite());
  CHECK(result.warnings.empty());
}

TEST_CASE("perspective drawings: attributes that aren't understood are named") {
  const auto warnings = read(in_svg("<metadata><cq:fov_x_deg value=\"500\"/><cq:colour value=\"1\"/></metadata>"
                                    "<path id=\"a\" cq:group=\"9\" cq:weight=\"-1\" d=\"M 1 1 L 9 9\"/>"
                                    "<path id=\"a\" cq:group=\"1\" stroke=\"red\" d=\"M 1 1 L 9 19\"/>"))
                            .warnings;
  CHECK(codes_of(warnings) == Codes{"W_VALUE", "W_VALUE", "W_DUPLICATE_ID", "GROUP_COLOUR", "W_VALUE", "W_VALUE"});
  CHECK(warnings[0].subjects.at(0).id == "a");
  CHECK(warnings[3].severity == Severity::Info);
  CHECK(warnings[3].subjects.at(0).id == "a-2");
}

TEST_CASE("perspective drawings: malformed files are refused with their lines") {
  const auto svg_errors = [](const std::string& svg) { return errors_of([&] { read(svg); }); };
  CHECK(codes_of(svg_errors("")) == Codes{"E_EMPTY"});
  CHECK(codes_of(svg_errors("<svg><path")) == Codes{"E_SYNTAX"});
  CHECK(codes_of(svg_errors(in_svg("<text>none</text>"))).at(1) == "E_NO_STROKES");
  const Findings bad = svg_errors(in_svg("<path id=\"a\" d=\"M 1 1\"/>\n<path id=\"b\" d=\"M 1 pear\"/>"));
  REQUIRE(codes_of(bad) == Codes{"E_SYNTAX"});
  CHECK(bad[0].category == Category::Malformed);
  CHECK(bad[0].subjects.at(0).id == "b");
  CHECK(bad[0].subjects.at(0).line == 3);
}

TEST_CASE("perspective drawings: malformed JSON is refused with all its places") {
  const auto errors = [](const std::string& json) {
    return errors_of([&] { read_perspective_json(json, "drawing.json"); });
  };
  CHECK(codes_of(errors("{")) == Codes{"E_SYNTAX"});
  CHECK(codes_of(errors("{\"format\":\"croquis-abs/1\"}")) == Codes{"E_SYNTAX"});
  const std::string head = R"({"format":"croquis-perspective/1","image":{"width":10,"height":10},)";
  CHECK(codes_of(errors(head + "\"strokes\":[]}")) == Codes{"E_NO_STROKES"});
  const Findings found = errors(head + R"("fov_x_deg":180,"strokes":[
    {"id":"a","group":6,"points":[[0,0],[1,1]]},
    {"id":"a","role":"line","points":[[0,0]]},
    {"id":"b","weight":0,"pieces":[[[0,0],[1,1],[2,2],[3,3]],[[4,4],[1,1],[2,2],[3,3]]]},
    {"id":"c","link":1,"pieces":[[[0,0],[1,1],[2,2],[3,"x"]]]}]})");
  const std::vector<std::string> places{"fov_x_deg",         "strokes[0].group", "strokes[1].role",
                                        "strokes[1].points", "strokes[1].id",    "strokes[2].weight",
                                        "strokes[2].pieces", "strokes[3].link",  "strokes[3].pieces"};
  REQUIRE(found.size() == places.size());
  for (std::size_t i = 0; i < places.size(); ++i) CHECK(found[i].message.find(places[i]) != std::string::npos);
}

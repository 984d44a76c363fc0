// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "croquis/base/error.h"
#include "croquis/io/svg_drawing.h"

using namespace croquis;

/// SVG as drawing programs write it: style sheets, clones, symbols, layers, pages.
namespace {

DrawingReadResult read(const std::string& text) {
  Progress progress;
  return read_svg_drawing(text, "export.svg", progress);
}

std::string svg(const std::string& content, const std::string& attributes = "viewBox=\"0 0 200 100\"") {
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\" " + attributes +
         ">\n" + content + "\n</svg>\n";
}

std::vector<std::string> ids(const Drawing& drawing) {
  std::vector<std::string> all;
  for (const Stroke& stroke : drawing.strokes) all.push_back(stroke.id);
  return all;
}

/// Of a line or a box: its corner samples, in the file's y-down frame.
void check_ends(const Stroke& stroke, const Vec2& first, const Vec2& last) {
  INFO(stroke.id);
  const Vec2 a = stroke.samples.front().position;
  const Vec2 b = stroke.samples.back().position;
  INFO("from " << a.x() << ' ' << -a.y() << " to " << b.x() << ' ' << -b.y());
  CHECK((Vec2(a.x(), -a.y()) - first).norm() < 1e-9);
  CHECK((Vec2(b.x(), -b.y()) - last).norm() < 1e-9);
}

const std::string unit_line = "<line id=\"l\" x2=\"10\" y2=\"0\" stroke=\"black\"/>";

std::vector<std::string> codes_of(const std::string& text) {
  std::vector<std::string> codes;
  try {
    for (const Finding& finding : read(text).warnings) codes.push_back(finding.code);
  } catch (const Error& error) {
    for (const Finding& finding : error.findings()) codes.push_back(finding.code);
  }
  return codes;
}

}  // namespace

TEST_CASE("transforms in styles and classes count like attributes, and before them") {
  struct Case {
    std::string attributes;
    Vec2 first, last;
  };
  const std::vector<Case> cases{{"transform=\"translate(3 4)\"", {3, 4}, {13, 4}},
                                {"style=\"transform: translate(3px, 4px)\"", {3, 4}, {13, 4}},
                                {"style=\"transform:translateX(1in)\"", {96, 0}, {106, 0}},
                                {"style=\"transform:rotate(90deg)\"", {0, 0}, {0, 10}},
                                {"style=\"transform:rotate(0.25turn)\"", {0, 0}, {0, 10}},
                                {"style=\"transform:rotate(100grad)\"", {0, 0}, {0, 10}},
                                {"style=\"transform:scale(2) translate(1px,1px)\"", {2, 2}, {22, 2}},
                                {"style=\"transform:scaleX(-1)\"", {0, 0}, {-10, 0}},
                                {"style=\"transform:none\" transform=\"translate(3 4)\"", {0, 0}, {10, 0}},
                                {"class=\"moved\" transform=\"scale(5)\"", {7, 0}, {17, 0}}};
  for (const Case& one : cases) {
    INFO(one.attributes);
    const std::string text =
        svg("<style>.moved { transform: translate(7px) }</style><g " + one.attributes + ">" + unit_line + "</g>");
    check_ends(read(text).drawing.strokes.at(0), one.first, one.last);
  }
  CHECK(codes_of(svg("<g style=\"transform:rotate3d(1,1,1,45deg)\">" + unit_line + "</g>")).front() == "E_SYNTAX");
  CHECK(codes_of(svg("<g style=\"transform:translate(3em)\">" + unit_line + "</g>")).front() == "E_SYNTAX");
}

TEST_CASE("classes hide what they say, wherever the style sheet stands") {
  const std::string sheets =
      "<g><style>.off, .gone { display: none }</style></g>"
      "<defs><style type=\"text/css\">.faint{visibility:hidden}</style></defs>";
  const Drawing drawing =
      read(svg(sheets + "<g class=\"off\"><path d=\"M0 0h5\"/></g><path class=\"gone\" d=\"M0 0h5\"/>"
                        "<path class=\"faint\" d=\"M0 0h5\"/><path id=\"seen\" d=\"M0 0h5\"/>"))
          .drawing;
  CHECK(ids(drawing) == std::vector<std::string>{"seen"});
}

TEST_CASE("percentages are of the viewBox around, radii of its diagonal") {
  const Drawing drawing =
      read(svg("<line x1=\"10%\" y1=\"50%\" x2=\"100%\" y2=\"25%\"/>"
               "<circle r=\"10%\" cx=\"50%\" cy=\"50%\"/>"
               "<svg viewBox=\"0 0 20 10\" width=\"50%\" height=\"50%\"><line x2=\"50%\" y2=\"100%\"/></svg>"))
          .drawing;
  check_ends(drawing.strokes.at(0), {20, 50}, {200, 25});
  const double radius = 0.1 * std::sqrt((200.0 * 200 + 100 * 100) / 2);
  CHECK(drawing.strokes.at(1).samples.front().position.x() == Approx(100 + radius));
  check_ends(drawing.strokes.at(2), {0, 0}, {50, 50});
  for (const char* none : {"", "viewBox=\"0 0 200 0\"", "viewBox=\"0 0 0 100\"", "viewBox=\"0 0 200 -1\""})
    CHECK(codes_of(svg("<line x2=\"10%\"/>", none)).front() == "E_SYNTAX");
  CHECK(codes_of(svg("<line x2=\"10%%\"/>")).front() == "E_SYNTAX");
}

TEST_CASE("an svg element within the drawing, or a symbol, is fitted into its place") {
  const auto fitted = [](const std::string& attributes) {
    return read(svg("<svg " + attributes + ">" + unit_line + "</svg>")).drawing.strokes.at(0);
  };
  check_ends(fitted("x=\"5\" y=\"6\""), {5, 6}, {15, 6});
  check_ends(fitted("viewBox=\"0 0 10 10\" width=\"20\" height=\"20\""), {0, 0}, {20, 0});
  check_ends(fitted("viewBox=\"0 0 10 10\" width=\"40\" height=\"20\""), {10, 0}, {30, 0});
  check_ends(fitted("viewBox=\"0 0 10 10\" width=\"40\" height=\"20\" preserveAspectRatio=\"xMinYMid\""), {0, 0},
             {20, 0});
  check_ends(fitted("viewBox=\"0 0 10 10\" width=\"40\" height=\"20\" preserveAspectRatio=\"xMidYMax slice\""),
             {0, -20}, {40, -20});
  check_ends(fitted("viewBox=\"0 0 10 10\" width=\"40\" height=\"20\" preserveAspectRatio=\"none\""), {0, 0}, {40, 0});
  check_ends(fitted("viewBox=\"2 1 10 10\" width=\"10\" height=\"10\""), {-2, -1}, {8, -1});
}

TEST_CASE("what a use shows is a stroke at the use's place, named after it") {
  const Drawing drawing =
      read(svg("<defs><path id=\"leg\" d=\"M0 0h4\" data-kind=\"part\"/>"
               "<g id=\"pair\"><use href=\"#leg\" id=\"left\"/><use href=\"#leg\" id=\"right\" x=\"10\"/></g>"
               "<symbol id=\"box\" viewBox=\"0 0 2 2\"><path d=\"M0 0h2\"/></symbol></defs>"
               "<use id=\"one\" xlink:href=\"#leg\" x=\"1\" y=\"2\" transform=\"scale(2)\"/>"
               "<g data-object=\"dog\"><use id=\"back\" href=\"#pair\" y=\"50\"/></g>"
               "<use href=\"#leg\"/><use id=\"square\" href=\"#box\" x=\"5\" width=\"8\" height=\"8\"/>"))
          .drawing;
  CHECK(ids(drawing) == std::vector<std::string>{"one", "back/left", "back/right", "leg", "square/stroke-5"});
  check_ends(drawing.strokes[0], {2, 4}, {10, 4});
  check_ends(drawing.strokes[2], {10, 50}, {14, 50});
  check_ends(drawing.strokes[4], {5, 0}, {13, 0});
  CHECK(drawing.strokes[0].data.at("kind") == "part");
  CHECK(drawing.strokes[1].object == "dog");
  CHECK(drawing.strokes[0].object.empty());
}

TEST_CASE("uses that show themselves are refused, those of nothing told, floods of them end") {
  CHECK(codes_of(svg("<g id=\"a\"><use href=\"#a\"/></g>" + unit_line)) == std::vector<std::string>{"E_SYNTAX"});
  CHECK(codes_of(svg("<g id=\"a\"><use href=\"#b\"/></g><g id=\"b\"><use href=\"#a\"/></g>" + unit_line)).front() ==
        "E_SYNTAX");
  CHECK(codes_of(svg("<use href=\"#nobody\"/>" + unit_line)) == std::vector<std::string>{"W_IGNORED"});
  CHECK(codes_of(svg("<use href=\"other.svg#leg\"/><use/>" + unit_line)) ==
        std::vector<std::string>{"W_IGNORED", "W_IGNORED"});
  std::string laughs = "<path id=\"x0\" d=\"M0 0h1\"/>";
  for (int i = 1; i <= 12; ++i) {
    const std::string use = "<use href=\"#x" + std::to_string(i - 1) + "\"/>";
    laughs += "<g id=\"x" + std::to_string(i) + "\">" + use + use + use + use + use + use + use + use + "</g>";
  }
  const std::vector<std::string> codes = codes_of(svg("<defs>" + laughs + "</defs><use href=\"#x12\"/>"));
  CHECK(std::find(codes.begin(), codes.end(), "E_LIMIT") != codes.end());
}

TEST_CASE("style sheets speak of ids and elements too; the more special rule counts") {
  const std::string sheet =
      "<style>#off{display:none} line , polyline{visibility:hidden} .on{visibility:visible} g path{display:none} "
      "@media print{path{display:none}}</style>";
  const Drawing drawing = read(svg(sheet + "<path id=\"off\" d=\"M0 0h5\"/><line id=\"no\" x2=\"5\"/>"
                                           "<line id=\"yes\" class=\"on\" x2=\"5\"/><path id=\"seen\" d=\"M0 0h5\"/>"))
                              .drawing;
  CHECK(ids(drawing) == std::vector<std::string>{"yes", "seen"});
}

TEST_CASE("what is wholly transparent is no stroke") {
  const Drawing drawing = read(svg("<g opacity=\"0\"><path d=\"M0 0h5\"/></g><path style=\"opacity:0.0\" d=\"M0 0h5\"/>"
                                   "<path id=\"faint\" opacity=\".05\" d=\"M0 0h5\"/>"))
                              .drawing;
  CHECK(ids(drawing) == std::vector<std::string>{"faint"});
}

TEST_CASE("a rectangle without a line behind the drawing is no stroke, and that is told") {
  const std::string circle = "<circle cx=\"50\" cy=\"50\" r=\"20\" fill=\"none\" stroke=\"black\"/>";
  const std::vector<std::string> backgrounds{
      "<rect id=\"bg\" width=\"100%\" height=\"100%\" fill=\"white\"/>",
      "<rect id=\"bg\" width=\"200\" height=\"100\" style=\"fill:#fff;stroke:none\"/>",
      "<path id=\"bg\" d=\"M0 0h200v100H0z\" fill=\"#eee\"/>",
      "<rect id=\"bg\" width=\"100%\" height=\"100%\" fill=\"none\"/>",
      "<g fill=\"white\" stroke=\"none\"><rect id=\"bg\" x=\"-5\" y=\"-5\" width=\"300\" height=\"300\"/></g>",
      "<rect id=\"bg\" x=\"20\" y=\"20\" width=\"70\" height=\"70\" fill=\"white\"/>"};
  for (const std::string& background : backgrounds) {
    INFO(background);
    const DrawingReadResult result = read(svg(background + circle));
    CHECK(ids(result.drawing) == std::vector<std::string>{"stroke-2"});
    REQUIRE(result.warnings.size() == 1);
    CHECK(result.warnings.front().code == "W_IGNORED");
    CHECK(result.warnings.front().subjects.front().id == "bg");
  }
  const std::vector<std::string> strokes{"<rect id=\"frame\" width=\"100%\" height=\"100%\" stroke=\"black\"/>",
                                         "<rect id=\"frame\" x=\"40\" y=\"40\" width=\"20\" height=\"20\"/>",
                                         "<rect id=\"frame\" width=\"200\" height=\"100\" transform=\"rotate(3)\"/>",
                                         "<ellipse id=\"frame\" cx=\"100\" cy=\"50\" rx=\"300\" ry=\"300\"/>"};
  for (const std::string& stroke : strokes) {
    INFO(stroke);
    CHECK(read(svg(stroke + circle)).drawing.strokes.size() == 2);
  }
  CHECK(read(svg(backgrounds.front())).drawing.strokes.size() == 1);
  const std::string unpainted = "<rect width=\"100%\" height=\"100%\" fill=\"none\"/><circle r=\"9\" fill=\"none\"/>";
  CHECK(read(svg(unpainted)).drawing.strokes.size() == 2);
}

TEST_CASE("a drawing as Illustrator exports it is read without a word") {
  const DrawingReadResult result = read(R"svg(<?xml version="1.0" encoding="utf-8"?>
<!-- Generator: Adobe Illustrator 24.0.0, SVG Export Plug-In . SVG Version: 6.00 Build 0)  -->
<!DOCTYPE svg PUBLIC "-//W3C//DTD SVG 1.1//EN" "http://www.w3.org/Graphics/SVG/1.1/DTD/svg11.dtd" [
  <!ENTITY ns_extend "http://ns.adobe.com/Extensibility/1.0/">
  <!ENTITY ns_ai "http://ns.adobe.com/AdobeIllustrator/10.0/">
]>
<svg version="1.1" xmlns:x="&ns_extend;" xmlns:i="&ns_ai;" xmlns="http://www.w3.org/2000/svg" x="0px" y="0px"
   width="595.3px" height="841.9px" viewBox="0 0 595.3 841.9" style="enable-background:new 0 0 595.3 841.9;">
<style type="text/css">
  .st0{clip-path:url(#SVGID_2_);}
  .st1{fill:none;stroke:#1D1D1B;stroke-width:2;stroke-miterlimit:10;}
  .st2{display:none;}
</style>
<metadata><sfw xmlns="&ns_extend;"><slices></slices></sfw></metadata>
<switch>
  <foreignObject requiredExtensions="&ns_ai;" x="0" y="0" width="1" height="1"><i:aipgfRef xlink:href="#adobe"/></foreignObject>
  <g i:extraneous="self">
    <g id="Layer_1"><defs><rect id="SVGID_1_" width="595.3" height="841.9"/></defs>
      <clipPath id="SVGID_2_"><use xlink:href="#SVGID_1_" style="overflow:visible;"/></clipPath>
      <g class="st0"><path id="head" class="st1" d="M100,200c0-55.2,44.8-100,100-100s100,44.8,100,100S255.2,300,200,300S100,255.2,100,200z"/></g>
    </g>
    <g id="Guides" class="st2"><line class="st1" x1="0" y1="0" x2="595" y2="0"/></g>
  </g>
</switch>
<i:pgf id="adobe"><![CDATA[H4sIAAAAAAAAA+y9]]></i:pgf>
</svg>)svg");
  CHECK(ids(result.drawing) == std::vector<std::string>{"head"});
  CHECK(result.drawing.strokes.front().closed);
  CHECK(result.warnings.empty());
}

TEST_CASE("a drawing as Inkscape saves it is read without a word") {
  const DrawingReadResult result = read(R"svg(<?xml version="1.0" encoding="UTF-8" standalone="no"?>
<svg width="210mm" height="297mm" viewBox="0 0 210 297" version="1.1" id="svg5" inkscape:version="1.2.2"
   xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape" xmlns:xlink="http://www.w3.org/1999/xlink"
   xmlns:sodipodi="http://sodipodi.sourceforge.net/DTD/sodipodi-0.dtd" xmlns="http://www.w3.org/2000/svg"
   xmlns:svg="http://www.w3.org/2000/svg">
  <sodipodi:namedview id="namedview7" pagecolor="#ffffff"><inkscape:grid type="xygrid" id="grid1"/></sodipodi:namedview>
  <defs id="defs2"><inkscape:path-effect effect="spiro" id="path-effect1"/></defs>
  <metadata id="m"><rdf:RDF xmlns:rdf="http://www.w3.org/1999/02/22-rdf-syntax-ns#"/></metadata>
  <g inkscape:label="Layer 1" inkscape:groupmode="layer" id="layer1" transform="translate(10,20)" style="display:inline">
    <path style="fill:none;stroke:#000000;stroke-width:0.26px" d="m 10,10 c 5,0 10,5 10,10" id="path1"
       sodipodi:nodetypes="cc" inkscape:connector-curvature="0"/>
    <use x="0" y="0" xlink:href="#path1" id="use1" transform="translate(30)"/>
    <circle style="fill:none;stroke:#000" id="path2" cx="60" cy="60" r="20"/>
  </g>
  <g inkscape:groupmode="layer" id="layer2" inkscape:label="Reference" style="display:none">
    <image xlink:href="data:image/png;base64,AAAA" width="10" height="10" id="image1"/>
    <path d="m 0,0 h 10" id="path3"/>
  </g>
</svg>)svg");
  CHECK(ids(result.drawing) == std::vector<std::string>{"path1", "use1", "path2"});
  check_ends(result.drawing.strokes[0], {20, 30}, {30, 40});
  check_ends(result.drawing.strokes[1], {50, 30}, {60, 40});
  CHECK(result.warnings.empty());
}

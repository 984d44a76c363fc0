// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <atomic>
#include <cmath>
#include <filesystem>
#include <functional>
#include <numbers>
#include <string>

#include <catch2/catch.hpp>

#include "croquis/base/error.h"
#include "croquis/io/file.h"
#include "croquis/io/svg_drawing.h"
#include "croquis/io/svg_writer.h"
#include "support/random.h"
#include "support/sample_count.h"
#include "support/sketches/sketch_gallery.h"
#include "support/sketches/sketch_modifiers.h"
#include "support/sketches/sketch_svg.h"

using namespace croquis;
using namespace croquis::test;

namespace {

DrawingReadResult read(const std::string& svg) {
  Progress progress;
  return read_svg_drawing(svg, "test.svg", progress);
}

std::string in_svg(const std::string& body) {
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"10mm\" viewBox=\"0 0 9 9\">\n" + body + "\n</svg>\n";
}

std::string path(const std::string& data) { return in_svg("<path id=\"p\" d=\"" + data + "\"/>"); }

Stroke only_stroke(const std::string& svg) {
  DrawingReadResult result = read(svg);
  REQUIRE(result.drawing.strokes.size() == 1);
  return result.drawing.strokes.front();
}

/// Samples as the file has them: y down.
std::vector<Vec2> places(const Stroke& stroke) {
  std::vector<Vec2> list;
  for (const StrokeSample& sample : stroke.samples) list.emplace_back(sample.position.x(), -sample.position.y());
  return list;
}

void check_places(const std::string& svg, const std::vector<Vec2>& expected) {
  const std::vector<Vec2> found = places(only_stroke(svg));
  INFO(svg);
  REQUIRE(found.size() == expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) CHECK((found[i] - expected[i]).norm() < 1e-9);
}

Findings errors_of(const std::string& svg) {
  try {
    read(svg);
  } catch (const Error& error) {
    return error.findings();
  }
  return {};
}

std::string code_of(const std::string& svg) {
  const Findings findings = errors_of(svg);
  return findings.empty() ? "none" : findings.front().code;
}

/// A Bézier curve of any degree by de Casteljau's construction.
Vec2 casteljau(std::vector<Vec2> points, double t) {
  while (points.size() > 1) {
    for (std::size_t i = 0; i + 1 < points.size(); ++i) points[i] = (1 - t) * points[i] + t * points[i + 1];
    points.pop_back();
  }
  return points.front();
}

double distance_to_polyline(const std::vector<Vec2>& line, const Vec2& place) {
  double nearest = 1e300;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const Vec2 d = line[i + 1] - line[i];
    const double t = d.squaredNorm() > 0 ? std::clamp((place - line[i]).dot(d) / d.squaredNorm(), 0.0, 1.0) : 0;
    nearest = std::min(nearest, (line[i] + t * d - place).norm());
  }
  return nearest;
}

void check_follows(const std::string& svg, const std::function<Vec2(double)>& curve) {
  const std::vector<Vec2> line = places(only_stroke(svg));
  INFO(svg);
  CHECK(line.front() == curve(0));
  CHECK((line.back() - curve(1)).norm() < 1e-12);
  double size = 0;
  for (const Vec2& p : line) size = std::max(size, (p - line.front()).norm());
  for (int i = 0; i <= 200; ++i) CHECK(distance_to_polyline(line, curve(i / 200.0)) < 2e-5 * size);
}

}  // namespace

TEST_CASE("straight path commands go where they say, absolute and relative") {
  check_places(path("M1 2L3 4"), {{1, 2}, {3, 4}});
  check_places(path("M 1,2 3,4 5 6"), {{1, 2}, {3, 4}, {5, 6}});
  check_places(path("m 1 2 3 4 5 6"), {{1, 2}, {4, 6}, {9, 12}});
  check_places(path("M1 2 H5 6 V7 8"), {{1, 2}, {5, 2}, {6, 2}, {6, 7}, {6, 8}});
  check_places(path("M1 2 h5 6 v7 8"), {{1, 2}, {6, 2}, {12, 2}, {12, 9}, {12, 17}});
  check_places(path("M1 2 l1 1 L 0 0"), {{1, 2}, {2, 3}, {0, 0}});
  check_places(path("\n M1 2\tL\r3 4 "), {{1, 2}, {3, 4}});
}

TEST_CASE("numbers need no separators where SVG needs none") {
  check_places(path("M1.5.5L-1-2"), {{1.5, 0.5}, {-1, -2}});
  check_places(path("M+1e1-2E-1L.5.25.125-.5"), {{10, -0.2}, {0.5, 0.25}, {0.125, -0.5}});
  check_places(path("M1.,2.L3 4"), {{1, 2}, {3, 4}});
  check_places(path("M0 0L1e-400 5"), {{0, 0}, {0, 5}});
  const std::vector<Vec2> spaced = places(only_stroke(path("M0 0 A 5 5 0 0 1 6 8")));
  const std::vector<Vec2> packed = places(only_stroke(path("M0 0A5 5 0 016 8")));
  CHECK(spaced == packed);
}

TEST_CASE("curves follow their own definition within the tolerance and end exactly") {
  const std::vector<Vec2> c{{0, 0}, {30, 100}, {70, -90}, {100, 10}};
  check_follows(path("M0 0C30 100 70-90 100 10"), [&](double t) { return casteljau(c, t); });
  check_follows(path("m0 0c30 100 70-90 100 10"), [&](double t) { return casteljau(c, t); });
  const std::vector<Vec2> q{{5, 5}, {50, 90}, {100, 20}};
  check_follows(path("M5 5Q50 90 100 20"), [&](double t) { return casteljau(q, t); });
  check_follows(path("M5 5q45 85 95 15"), [&](double t) { return casteljau(q, t); });
  // S and T mirror the last handle.
  const std::vector<Vec2> s{{100, 10}, {130, 110}, {180, 40}, {200, 0}};
  check_follows(path("M0 0C30 100 70-90 100 10S180 40 200 0"),
                [&](double t) { return t < 0.5 ? casteljau(c, 2 * t) : casteljau(s, 2 * t - 1); });
  const std::vector<Vec2> t2{{100, 20}, {150, -50}, {180, 30}};
  check_follows(path("M5 5Q50 90 100 20t80 10"),
                [&](double t) { return t < 0.5 ? casteljau(q, 2 * t) : casteljau(t2, 2 * t - 1); });
  // Without a curve before them the handle is the current point.
  const std::vector<Vec2> lone{{10, 0}, {10, 0}, {30, 40}, {50, 0}};
  check_follows(path("M0 0L10 0S30 40 50 0"),
                [&](double t) -> Vec2 { return t < 0.5 ? Vec2(20 * t, 0) : casteljau(lone, 2 * t - 1); });
}

TEST_CASE("arcs lie on one ellipse of the asked shape, on the side and with the length of their flags") {
  Random random(7);
  for (int i = 0; i < 60; ++i) {
    const Vec2 to(random.between(20, 60), random.between(-40, 40));
    const double rx = random.between(45, 90);
    const double ry = random.between(45, 90);
    const double degrees = random.between(-180, 180);
    const bool large = i % 2 == 0;
    const bool positive = i % 4 < 2;
    const std::string data = "M0 0A" + std::to_string(rx) + ' ' + std::to_string(ry) + ' ' + std::to_string(degrees) +
                             (large ? " 1" : " 0") + (positive ? "1" : "0") + std::to_string(to.x()) + ' ' +
                             std::to_string(to.y());
    INFO(data);
    const std::vector<Vec2> line = places(only_stroke(path(data)));
    CHECK((line.back() - to).norm() < 1e-6);
    // In the frame where the ellipse is a unit circle, all samples are one unit from the centre that three of them
    // give.
    const double angle = degrees * std::numbers::pi / 180;
    std::vector<Vec2> flat;
    for (const Vec2& p : line) {
      flat.emplace_back((std::cos(angle) * p.x() + std::sin(angle) * p.y()) / rx,
                        (-std::sin(angle) * p.x() + std::cos(angle) * p.y()) / ry);
    }
    const Vec2 a = flat[flat.size() / 3] - flat.front();
    const Vec2 b = flat[2 * flat.size() / 3] - flat.front();
    const Vec2 centre = flat.front() + Vec2(b.y() * a.squaredNorm() - a.y() * b.squaredNorm(),
                                            a.x() * b.squaredNorm() - b.x() * a.squaredNorm()) /
                                           (2 * cross(a, b));
    double turned = 0;
    for (std::size_t k = 0; k < flat.size(); ++k) {
      CHECK(std::abs((flat[k] - centre).norm() - 1) < 1e-5);
      if (k > 0) turned += std::asin(cross(flat[k - 1] - centre, flat[k] - centre));
    }
    CHECK((turned > 0) == positive);
    CHECK((std::abs(turned) > std::numbers::pi) == large);
  }
}

TEST_CASE("odd arcs are drawn as the standard says") {
  check_places(path("M0 0A0 5 0 0 1 6 8"), {{0, 0}, {6, 8}});                       // no radius: a line
  check_places(path("M0 0L6 8A5 5 0 0 1 6 8"), {{0, 0}, {6, 8}});                   // to where it is: nothing
  const std::vector<Vec2> half = places(only_stroke(path("M0 0A1 1 0 0 1 10 0")));  // too short: enlarged to reach
  for (const Vec2& p : half) CHECK((p - Vec2(5, 0)).norm() == Approx(5));
  const std::vector<Vec2> negative = places(only_stroke(path("M0 0A-5 -5 0 0 1 10 0")));
  CHECK(negative == places(only_stroke(path("M0 0A5 5 0 0 1 10 0"))));
}

TEST_CASE("each subpath is a stroke, closed ones do not repeat their first point") {
  const DrawingReadResult result = read(path("M0 0L4 0L4 4ZM9 9L8 8m1 0l5 5 0 1zL7 7 M3 3"));
  const auto& strokes = result.drawing.strokes;
  REQUIRE(strokes.size() == 4);
  CHECK(strokes[0].id == "p");
  CHECK(strokes[1].id == "p/2");
  CHECK(strokes[2].id == "p/3");
  CHECK(strokes[0].closed);
  CHECK(strokes[0].samples.size() == 3);
  CHECK_FALSE(strokes[1].closed);
  CHECK(strokes[2].closed);
  CHECK(places(strokes[3]) == std::vector<Vec2>{{9, 8}, {7, 7}});  // goes on where the closed subpath began
  CHECK(only_stroke(path("M0 0L4 0L4 4L0 0Z")).samples.size() == 3);
  CHECK(result.warnings.empty());
  const Findings point = read(path("M0 0L1 1M5 5Z")).warnings;
  REQUIRE(point.size() == 1);
  CHECK(point.front().code == "W_TINY");
}

TEST_CASE("basic shapes are strokes too") {
  check_places(in_svg("<line x1='1' y1='2' x2='3' y2='4'/>"), {{1, 2}, {3, 4}});
  check_places(in_svg("<polyline points='1,2 3,4-5-6'/>"), {{1, 2}, {3, 4}, {-5, -6}});
  check_places(in_svg("<rect x='1' y='2' width='10' height='5px'/>"), {{1, 2}, {11, 2}, {11, 7}, {1, 7}});
  CHECK(only_stroke(in_svg("<polygon points='0 0 1 0 1 1'/>")).closed);
  const Stroke circle = only_stroke(in_svg("<circle cx='10' cy='20' r='1in'/>"));
  CHECK(circle.closed);
  for (const Vec2& p : places(circle)) CHECK((p - Vec2(10, 20)).norm() == Approx(96));
  for (const Vec2& p : places(only_stroke(in_svg("<ellipse cx='1' rx='3' ry='2'/>")))) {
    CHECK(std::pow((p.x() - 1) / 3, 2) + std::pow(p.y() / 2, 2) == Approx(1));
  }
  const std::vector<Vec2> rounded = places(only_stroke(in_svg("<rect width='10' height='6' rx='2'/>")));
  for (const Vec2& p : rounded) CHECK((p.cwiseMax(Vec2(2, 2)).cwiseMin(Vec2(8, 4)) - p).norm() == Approx(2));
}

TEST_CASE("transforms of elements and groups are applied, the root's scaling is not") {
  const std::string body =
      "<g transform='translate(10,20) rotate(90)'><g transform='scale(2 3)'>"
      "<path transform='matrix(1 0 0 1 5 7)' d='M1 2L0 0'/></g></g>";
  // (1,2) -> (6,9) -> (12,27) -> turned (-27,12) -> (-17,32); (0,0) -> (5,7) -> (10,21) -> (-21,10) -> (-11,30)
  check_places(in_svg(body), {{-17, 32}, {-11, 30}});
  check_places(in_svg("<path transform='rotate(180 5 5)' d='M0 0L1 1'/>"), {{10, 10}, {9, 9}});
  check_places(in_svg("<path transform='skewX(45)' d='M0 0L0 3'/>"), {{0, 0}, {3, 3}});
  check_places(in_svg("<path transform='skewY(45),translate(1)' d='M0 0L2 0'/>"), {{1, 1}, {3, 3}});
  check_places(in_svg("<svg x='3' y='4'><path d='M0 0L2 0'/></svg>"), {{3, 4}, {5, 4}});
  const Stroke sheared = only_stroke(in_svg("<circle r='10' transform='matrix(1 .5 0 1 0 0)'/>"));
  for (const Vec2& p : places(sheared)) CHECK(std::hypot(p.x(), p.y() - 0.5 * p.x()) == Approx(10));
}

TEST_CASE("y points up, at the same origin and scale") {
  const Stroke stroke = only_stroke(path("M3 4L5 -6"));
  CHECK(stroke.samples[0].position == Vec2(3, -4));
  CHECK(stroke.samples[1].position == Vec2(5, 6));
}

TEST_CASE("names, objects and data attributes come along") {
  const DrawingReadResult result = read(in_svg(
      "<g data-object='A' data-weight-curvature='2'>\n<path id='x' d='M0 0L1 1' data-kind='hidden'/>\n"
      "<g data-object='B'><path d='M0 0L1 1'/></g><path id='x' d='M0 0L1 1'/></g>\n<path d='M0 0L1 1M2 2L3 3'/>"));
  const auto& strokes = result.drawing.strokes;
  REQUIRE(strokes.size() == 5);
  CHECK(strokes[0].object == "A");
  CHECK(strokes[0].data.at("kind") == "hidden");
  CHECK(strokes[0].line == 3);
  CHECK(strokes[1].object == "B");
  CHECK(strokes[1].id == "stroke-2");
  CHECK(strokes[2].id == "x-2");
  CHECK(strokes[3].object.empty());
  CHECK(strokes[3].id == "stroke-4");
  CHECK(strokes[4].id == "stroke-4/2");
  CHECK(strokes[4].line == 5);
  CHECK(result.drawing.object_data.at("A").at("weight-curvature") == "2");
  REQUIRE(result.warnings.size() == 1);
  CHECK(result.warnings.front().code == "W_DUPLICATE_ID");
}

TEST_CASE("what is not shown is no stroke, what is not a line is named in a warning") {
  const DrawingReadResult result = read(in_svg(
      "<defs><path d='M0 0L9 9'/></defs><clipPath><rect width='5' height='5'/></clipPath>"
      "<g style='fill:red; display : none'><path d='M0 0L9 9'/></g><path display='none' d='M0 0L9 9'/>"
      "<g visibility='hidden'><path d='M0 0L9 9'/><path id='seen' visibility='visible' d='M0 0L1 1'/></g>"
      "<sodipodi:namedview xmlns:sodipodi='s'/><path d=''/><rect width='0' height='3'/>\n<text>a</text><text>b</text>"
      "<use href='#x'/><image/>"));
  REQUIRE(result.drawing.strokes.size() == 1);
  CHECK(result.drawing.strokes.front().id == "seen");
  REQUIRE(result.warnings.size() == 3);
  for (const Finding& warning : result.warnings) {
    CHECK(warning.code == "W_IGNORED");
    CHECK(warning.subjects.front().line == 3);
  }
  CHECK(result.warnings.back().message.find("2 ") == 0);
}

TEST_CASE("a file that is cut off is refused with the line where it ends") {
  const std::string whole = "<svg>\n<g>\n<path d='M0 0L1 1'/>\n</g>\n</svg>\n";
  for (const std::size_t size : {whole.size() - 3, whole.find("</g>") + 2, whole.find("L1"), whole.find("path") + 2}) {
    const std::string svg = whole.substr(0, size);
    const auto line = 1 + std::count(svg.begin(), svg.end(), '\n');
    const Findings findings = errors_of(svg);
    INFO(svg);
    REQUIRE(findings.size() == 1);
    CHECK(findings.front().code == "E_SYNTAX");
    CHECK(findings.front().message.find("XML on line " + std::to_string(line) + ": ") != std::string::npos);
    CHECK(findings.front().subjects.front().line == line);
  }
}

TEST_CASE("bad files are refused with their code, line and stroke, all findings at once") {
  CHECK(code_of("") == "E_EMPTY");
  CHECK(code_of(" \n") == "E_EMPTY");
  CHECK(code_of("hello") == "E_SYNTAX");
  CHECK(code_of("<html/>") == "E_SYNTAX");
  CHECK(code_of("<svg>\n<path d='M0 0L1 1'/>") == "E_SYNTAX");
  CHECK(code_of(std::string("<svg>\0</svg>", 12)) == "E_SYNTAX");
  CHECK(code_of(in_svg("")) == "E_NO_STROKES");
  CHECK(code_of(path("M0 0")) == "E_NO_STROKES");
  CHECK(code_of(path("M0 0L1e400 5")) == "E_NOT_FINITE");
  CHECK(code_of(path("M0 0L1 NaN")) == "E_NOT_FINITE");
  CHECK(code_of(path("M0 0L1 2 NaN 3")) == "E_NOT_FINITE");
  CHECK(code_of(in_svg("<path transform='scale(1e300)' d='M0 0L1e300 5'/>")) == "E_NOT_FINITE");
  for (const char* bad : {"L1 1", "M", "M1", "M0 0L1", "M0 0L1 1 2", "M0 0 X", "M0 0A1 1 0 2 0 5 5", "M0 0L1,,2",
                          "M0 0,", "M0 0C1 2 3 4 5", "M0 0L1 1;", "M0 0H", "5 5"}) {
    INFO(bad);
    CHECK(code_of(path(bad)) == "E_SYNTAX");
  }
  for (const char* bad : {"scale(1 2 3)", "turn(5)", "rotate(1 2)", "matrix(1 2 3", "translate 5"}) {
    INFO(bad);
    CHECK(code_of(in_svg("<g transform='" + std::string(bad) + "'><path d='M0 0L1 1'/></g>")) == "E_SYNTAX");
  }
  CHECK(code_of(in_svg("<circle r='5em'/>")) == "E_SYNTAX");

  const Findings both = errors_of(in_svg("<path id='one' d='M0 0L1 x'/>\n<path id='two' d='M0 0L1e999 1'/>"));
  REQUIRE(both.size() == 3);  // and, since nothing readable is left, no strokes
  CHECK(both[0].subjects.front().id == "one");
  CHECK(both[0].subjects.front().line == 2);
  CHECK(both[0].message.find("character 8") != std::string::npos);
  CHECK(both[0].category == Category::Malformed);
  CHECK(both[1].subjects.front().id == "two");
  CHECK(both[1].subjects.front().line == 3);
}

TEST_CASE("deep nesting and floods of samples or findings end at a limit") {
  std::string deep;
  for (int i = 0; i < 100000; ++i) deep += "<g>";
  const std::string open = deep + "<path d='M0 0L1 1'/>";
  std::string close;
  for (int i = 0; i < 100000; ++i) close += "</g>";
  CHECK(code_of(in_svg(open + close)) == "E_LIMIT");
  CHECK(code_of(in_svg(open)) == "E_SYNTAX");
  std::string curls = "M0 0";
  for (int i = 0; i < 20000; ++i) curls += "c900 900-900 900 0 0";
  CHECK(code_of(path(curls)) == "E_LIMIT");
  std::string wrong;
  for (int i = 0; i < 5000; ++i) wrong += "<path d='x'/>";
  CHECK(errors_of(in_svg(wrong)).size() < 110);
  CHECK(code_of(in_svg("<path data-note='" + std::string(40000, 'n') + "' d='" + [] {
          std::string data;
          for (int i = 0; i < 5000; ++i) data += "M0 0L1 1";
          return data;
        }() + "'/>")) == "E_LIMIT");
}

TEST_CASE("sketches written as SVG read back as they were") {
  for (const auto& [name, sketch] : all_sketches()) {
    INFO(name);
    const Drawing& drawing = sketch.drawing;
    const Drawing again = read(to_svg(drawing)).drawing;
    REQUIRE(again.strokes.size() == drawing.strokes.size());
    for (std::size_t i = 0; i < drawing.strokes.size(); ++i) {
      const Stroke& a = drawing.strokes[i];
      const Stroke& b = again.strokes[i];
      CHECK(a.id == b.id);
      CHECK(a.closed == b.closed);
      REQUIRE(a.samples.size() == b.samples.size());
      for (std::size_t k = 0; k < a.samples.size(); ++k) {
        CHECK((a.samples[k].position - b.samples[k].position).norm() < 1e-6);
      }
    }
    SvgStyle smooth;
    smooth.curves = SvgCurves::Cubic;
    const Drawing fitted = read(to_svg(drawing, smooth)).drawing;
    REQUIRE(fitted.strokes.size() == drawing.strokes.size());
    for (std::size_t i = 0; i < drawing.strokes.size(); ++i) {
      std::vector<Vec2> line = places(fitted.strokes[i]);
      if (fitted.strokes[i].closed) line.push_back(line.front());
      for (const Vec2& p : places(drawing.strokes[i])) CHECK(distance_to_polyline(line, p) < 2 * smooth.tolerance);
    }
  }
}

TEST_CASE("exported drawings keep their plane, their objects and what was said of them") {
  Drawing drawing;
  drawing.plane = {Vec3(1.0 / 3, -2, 1e-7), Vec3::UnitZ(), Vec3(0, 0.6, 0.8).cross(Vec3::UnitZ()).normalized()};
  REQUIRE(drawing.plane.is_orthonormal());
  for (const char* object : {"ear", "", "head", "ear"}) {
    Stroke stroke;
    stroke.id = "s" + std::to_string(drawing.strokes.size());
    stroke.object = object;
    stroke.closed = true;
    for (const Vec2& place : {Vec2(0, 0), Vec2(0.1, 1.0 / 7), Vec2(2, 1)}) stroke.samples.push_back({place});
    if (stroke.object == "head") stroke.data["kind"] = "hidden";
    drawing.strokes.push_back(stroke);
  }
  drawing.object_data["ear"]["weight-curvature"] = "2 & more";
  const Drawing again = read(write_svg_drawing(drawing)).drawing;
  CHECK(again.plane == drawing.plane);
  CHECK(again.object_data.at("ear") == drawing.object_data.at("ear"));
  REQUIRE(again.strokes.size() == drawing.strokes.size());
  for (std::size_t i = 0; i < again.strokes.size(); ++i) {
    CHECK(again.strokes[i].id == drawing.strokes[i].id);
    CHECK(again.strokes[i].object == drawing.strokes[i].object);
    CHECK(again.strokes[i].data == drawing.strokes[i].data);
    CHECK(places(again.strokes[i]) == places(drawing.strokes[i]));
  }
  const std::string one = "<path d='M0 0L1 1'/></svg>";
  for (const char* plane : {"1 2 3", "0 0 0 1 0 0 1 0 0", "0 0 0 2 0 0 0 1 0", "0 0 0 1 0 0 0 1 0 7", "x"}) {
    INFO(plane);
    CHECK(code_of("<svg data-plane='" + std::string(plane) + "'>" + one) == "E_SYNTAX");
  }
}

TEST_CASE("the same file gives the same strokes whatever the unit") {
  const Drawing base = read(path("M0 0C30 100 70-90 100 10A50 30 20 0 1 0 90Z")).drawing;
  const Drawing tiny =
      read(in_svg("<path transform='scale(0.0009765625)' d='M0 0C30 100 70-90 100 10A50 30 20 0 1 0 90Z'/>")).drawing;
  REQUIRE(base.strokes[0].samples.size() == tiny.strokes[0].samples.size());
  for (std::size_t i = 0; i < base.strokes[0].samples.size(); ++i) {
    CHECK((base.strokes[0].samples[i].position - 1024 * tiny.strokes[0].samples[i].position).norm() < 1e-9);
  }
}

TEST_CASE("a cancelled reading stops") {
  const std::atomic<bool> cancel{true};
  Progress progress({}, &cancel);
  const std::string svg = path("M0 0L1 1");
  CHECK_THROWS_AS(read_svg_drawing(svg, "test.svg", progress), Cancelled);
}

TEST_CASE("the fill of a closed stroke is its colour, however the file says it", "[svg]") {
  const std::string closed = "d=\"M0 0H4V4Z\"", open = "d=\"M0 0H4V4\"";
  const auto fill = [](const std::string& body) {
    const Stroke stroke = only_stroke(in_svg(body));
    const auto found = stroke.data.find("fill");
    return found == stroke.data.end() ? std::string() : found->second;
  };
  CHECK(fill("<path fill=\"#F80\" " + closed + "/>") == "#ff8800");
  CHECK(fill("<path style=\"fill:rgb(0, 136, 255);stroke:#000\" " + closed + "/>") == "#0088ff");
  CHECK(fill("<path fill=\"rgb(0%, 20%, 100%)\" " + closed + "/>") == "#0033ff");
  CHECK(fill("<g fill=\"Pink\"><path " + closed + "/></g>") == "#ffc0cb");
  CHECK(fill("<style>.a { fill: #00ff7f }</style><path class=\"a\" " + closed + "/>") == "#00ff7f");
  CHECK(fill("<path data-fill=\"#010203\" fill=\"red\" " + closed + "/>") == "#010203");
  for (const std::string none : {"fill=\"none\" ", "fill=\"black\" ", "fill=\"url(#g)\" ", "fill=\"#12345\" ", ""})
    CHECK(fill("<path " + none + closed + "/>").empty());
  CHECK(fill("<path fill=\"red\" " + open + "/>").empty());
  DrawingReadResult once = read(in_svg("<path fill=\"red\" " + closed + "/>"));
  CHECK(only_stroke(write_svg_drawing(once.drawing)).data.at("fill") == "#ff0000");
}

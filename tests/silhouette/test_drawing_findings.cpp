// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <limits>
#include <regex>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "algorithms/silhouette/strokes/drawing_findings.h"
#include "croquis/base/error.h"
#include "silhouette/labelled_counts.h"
#include "support/random.h"
#include "support/sample_count.h"
#include "support/sketches/sketch_generator.h"

using namespace croquis;
using namespace croquis::test;
using silhouette::Options;
using silhouette::Preset;

namespace {

std::vector<std::string> codes(const Findings& findings) {
  std::vector<std::string> all;
  for (const Finding& finding : findings) all.push_back(finding.code);
  return all;
}

const Finding* find_code(const Findings& findings, const std::string& code) {
  const auto found =
      std::find_if(findings.begin(), findings.end(), [&](const Finding& finding) { return finding.code == code; });
  return found == findings.end() ? nullptr : &*found;
}

/// Anything a pen could leave on a page.
Drawing random_drawing(std::uint64_t seed) {
  Random random(seed);
  Drawing drawing;
  const std::uint32_t strokes = 1 + random.below(30);
  const bool scribble = random.below(8) == 0;
  for (std::uint32_t s = 0; s < strokes; ++s) {
    std::vector<Vec2> points;
    Vec2 place(random.between(0, 900), random.between(0, 700));
    Vec2 way(random.between(-8, 8), random.between(-8, 8));
    const std::uint32_t samples = 1 + random.below(scribble ? 3000 : 80);
    const double wildness = random.between(0, scribble ? 6 : 2);
    for (std::uint32_t i = 0; i < samples; ++i) {
      points.push_back(place);
      place += way;
      way += wildness * Vec2(random.between(-1, 1), random.between(-1, 1));
      way *= std::min(1.0, 12 / way.norm());
      place = place.cwiseMax(Vec2(0, 0)).cwiseMin(Vec2(900, 700));
    }
    if (random.below(10) == 0) points.assign(points.size(), points.front());
    drawing.strokes.push_back(stroke_of("r" + std::to_string(s), points, random.below(3) == 0));
  }
  return drawing;
}

}  // namespace

TEST_CASE("every finding about a drawing names the strokes it is about") {
  for (const ErrorSketch& sketch : error_sketches()) {
    INFO(sketch.code);
    const Findings findings = findings_of(sketch.drawing, Options::of(Preset::Clean));
    std::vector<std::string> named;
    for (const Finding& finding : findings) {
      INFO(finding.message);
      if (finding.severity == Severity::Info) continue;
      const bool expected = finding.code == sketch.code;
      CHECK((expected || std::count(sketch.allowed.begin(), sketch.allowed.end(), finding.code) > 0));
      if (!expected) continue;
      for (const std::string& id : strokes_named(finding)) {
        if (std::find(named.begin(), named.end(), id) == named.end()) named.push_back(id);
        CHECK(finding.message.find('"' + id + '"') != std::string::npos);
      }
    }
    std::vector<std::string> wanted = sketch.strokes;
    std::sort(wanted.begin(), wanted.end());
    std::sort(named.begin(), named.end());
    CHECK(named == wanted);
  }
}

TEST_CASE("places are given in the file's own frame, with the file and line") {
  Drawing drawing;
  drawing.file = "sketch.svg";
  drawing.strokes.push_back(stroke_of("open", {{100, -200}, {100, 0}, {300, 0}, {300, -210}, {100, -210}}));
  drawing.strokes.back().line = 12;
  const Findings findings = findings_of(drawing);
  REQUIRE(codes(findings) == std::vector<std::string>{"W_GAP"});
  const Subject& subject = findings.front().subjects.front();
  CHECK(subject.id == "open");
  CHECK(subject.file == "sketch.svg");
  CHECK(subject.line == 12);
  REQUIRE(subject.at.size() == 2);
  CHECK(subject.at[0] == Approx(100));
  CHECK(subject.at[1] == Approx(205));
}

TEST_CASE("sentences about a drawing leave coordinates to the subjects") {
  static const std::regex coordinates(R"(-?\d[\d.e+-]*, ?-?\d)");
  for (const ErrorSketch& sketch : error_sketches()) {
    for (const Finding& finding : findings_of(sketch.drawing, Options::of(Preset::Clean))) {
      INFO(finding.message);
      CHECK_FALSE(std::regex_search(finding.message, coordinates));
    }
  }
}

TEST_CASE("all findings of a drawing come at once") {
  Drawing drawing = error_sketch("E_CROSS").drawing;
  Drawing other = error_sketch("E_NO_LABELLING").drawing;
  for (Stroke stroke : other.strokes) {
    stroke.id = "other-" + stroke.id;
    for (StrokeSample& sample : stroke.samples) sample.position.x() += 3000;
    drawing.strokes.push_back(stroke);
  }
  const Findings findings = findings_of(drawing, Options::of(Preset::Clean));
  CHECK(find_code(findings, "E_CROSS") != nullptr);
  CHECK(find_code(findings, "E_NO_LABELLING") != nullptr);
}

TEST_CASE("a drawing without strokes to work with is refused") {
  CHECK(codes(findings_of({})) == std::vector<std::string>{"E_NO_STROKES"});
  Drawing dot = drawing_of({stroke_of("dot", {{5, 5}, {5, 5}})});
  CHECK(codes(findings_of(dot)) == std::vector<std::string>{"W_TINY", "E_NO_STROKES"});
  CHECK_THROWS_AS(label_quietly(dot), Error);
}

TEST_CASE("coordinates that are no numbers are refused by name") {
  Drawing drawing = drawing_of({stroke_of("bad", {{0, 0}, {std::numeric_limits<double>::quiet_NaN(), 1}, {9, 9}})});
  const Findings findings = findings_of(drawing);
  REQUIRE(find_code(findings, "E_NOT_FINITE") != nullptr);
  CHECK(strokes_named(*find_code(findings, "E_NOT_FINITE")) == std::vector<std::string>{"bad"});
}

TEST_CASE("strokes of kinds that are not understood are refused by name while the rest goes on") {
  Drawing drawing = circle_sketch().drawing;
  drawing.strokes.push_back(stroke_of("spine", {{0, 0}, {300, 100}}));
  drawing.strokes.back().data["kind"] = "spine";
  const Findings findings = findings_of(drawing);
  REQUIRE(codes(findings) == std::vector<std::string>{"E_NOT_SUPPORTED"});
  CHECK(strokes_named(findings.front()) == std::vector<std::string>{"spine"});
  CHECK(label_quietly(drawing).figures.size() == 1);
}

TEST_CASE("a drawing of scribbles reaches a limit instead of taking forever") {
  Random random(3);
  std::vector<Vec2> points;
  for (int i = 0; i < 20000; ++i) points.emplace_back(random.between(0, 900), random.between(0, 700));
  Drawing drawing = drawing_of({stroke_of("scribble", points)});
  const Findings findings = findings_of(drawing);
  REQUIRE(codes(findings) == std::vector<std::string>{"E_LIMIT"});
  CHECK(findings.front().category == Category::Limit);
}

TEST_CASE("a search that may try nothing finds no solid") {
  silhouette::Options options;
  options.completion.maximum_matchings = 0;
  const Findings findings = findings_of(trefoil_sketch().drawing, options);
  CHECK(codes(findings) == std::vector<std::string>{"E_NO_LABELLING"});
}

TEST_CASE("random strokes are labelled or refused, never crash or hang") {
  for (int seed = 0; seed < test::sample_count(200, 2000); ++seed) {
    INFO("seed " << seed);
    const Drawing drawing = random_drawing(static_cast<std::uint64_t>(seed));
    try {
      const silhouette::LabelledDrawing labelled = label_quietly(drawing);
      CHECK(!labelled.figures.empty());
    } catch (const Error& error) {
      CHECK(has_errors(error.findings()));
      for (const Finding& finding : error.findings()) CHECK(finding.category != Category::Internal);
    }
  }
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <catch2/catch.hpp>

#include "croquis/base/error.h"
#include "croquis/silhouette/drawing_readings.h"
#include "croquis/silhouette/labelled_figure.h"
#include "croquis/silhouette/stroke_data.h"
#include "silhouette/solids.h"
#include "support/sketches/sketch_generator.h"
#include "support/sketches/sketch_spline.h"

using namespace croquis;
using namespace croquis::test;
using silhouette::DrawingReading;

namespace {

std::vector<DrawingReading> readings_of(const Drawing& drawing, std::size_t most) {
  silhouette::DrawingReadings all(drawing, {});
  Progress progress;
  std::vector<DrawingReading> found;
  while (found.size() < most) {
    std::optional<DrawingReading> reading = all.next(progress);
    if (!reading) break;
    found.push_back(*std::move(reading));
  }
  return found;
}

/// A disc in front of a crossed pair of sticks, all of them turned and sized by a number.
Drawing sticks_behind_disc(int number) {
  const double angle = 0.3 * number;
  const auto stick = [&](double turn, double length) {
    const Vec2 way(std::cos(angle + turn), std::sin(angle + turn));
    return tube_outline(bar(-length * way, (length + 10 * number) * way, 18, [](double) { return 0.0; }));
  };
  const std::vector<LayeredPart> parts{{stick(0, 300), 0}, {stick(1.2, 280), 1}, {circle_outline({0, 0}, 120), 2}};
  return layered_sketch(parts).drawing;
}

Drawing ring(double outer, double inner) {
  Drawing drawing;
  drawing.strokes = {stroke_of("outer", circle_outline({0, 0}, outer)),
                     stroke_of("inner", circle_outline({0, 0}, inner))};
  for (Stroke& stroke : drawing.strokes) stroke.closed = true;
  return drawing;
}

/// What of a reading can be seen: kinds, ends that go on as one another, what lies over what, Euler numbers.
std::string seen(const Drawing& drawing) {
  Progress progress;
  const silhouette::LabelledDrawing labelled = silhouette::label(drawing, {}, progress);
  std::multiset<std::string> facts;
  for (const silhouette::StrokeKind kind : labelled.kinds) facts.insert(silhouette::to_string(kind));
  for (const silhouette::LabelledFigure& figure : labelled.figures) {
    for (const auto& completion : figure.completions) {
      std::ostringstream pair;
      for (const auto& end : completion.ends) pair << drawing.strokes[end.stroke].id << end.at_start << ' ';
      facts.insert(pair.str());
    }
    for (const auto& overlap : figure.overlaps)
      facts.insert(figure.objects[overlap.upper].name + ">" + figure.objects[overlap.lower].name);
    for (const auto& object : figure.objects) facts.insert(object.name + std::to_string(object.euler_region));
  }
  std::string all;
  for (const std::string& fact : facts) all += fact + "; ";
  return all;
}

std::string error_of(const Drawing& drawing) {
  Progress progress;
  try {
    silhouette::label(drawing, {}, progress);
  } catch (const Error& error) {
    return error.findings().front().code + ": " + error.findings().front().message;
  }
  return {};
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace

TEST_CASE("readings of generated drawings differ in what is seen, and each gives a sound solid", "[readings]") {
  for (int number = 0; number < 10; ++number) {
    CAPTURE(number);
    const Drawing drawing = sticks_behind_disc(number);
    const std::vector<DrawingReading> readings = readings_of(drawing, 3);
    REQUIRE(readings.size() == 3);
    CHECK(readings.front().cost == 0);
    CHECK(readings.front().differs.empty());
    CHECK(seen(readings.front().drawing) == seen(drawing));
    std::set<std::string> different;
    double cost = 0;
    for (const DrawingReading& reading : readings) {
      different.insert(seen(reading.drawing));
      CHECK(reading.cost >= cost);
      cost = reading.cost;
      if (&reading != &readings.front()) CHECK_FALSE(reading.differs.empty());
      if (number % 4 == 0) check_sound(solid_of(reading.drawing).mesh);
    }
    CHECK(different.size() == readings.size());
  }
}

TEST_CASE("readings are the same again, and for a drawing elsewhere and of another size", "[readings]") {
  const Drawing drawing = sticks_behind_disc(3);
  Drawing other = drawing;
  for (Stroke& stroke : other.strokes) {
    for (StrokeSample& sample : stroke.samples) sample.position = 2.5 * sample.position + Vec2(700, -90);
  }
  const auto sentences = [](const std::vector<DrawingReading>& readings) {
    std::vector<std::vector<std::string>> all;
    for (const DrawingReading& reading : readings) all.push_back(reading.differs);
    return all;
  };
  const auto first = sentences(readings_of(drawing, 5));
  CHECK(sentences(readings_of(drawing, 5)) == first);
  CHECK(sentences(readings_of(other, 5)) == first);
  const auto fewer = sentences(readings_of(drawing, 2));
  CHECK(std::equal(fewer.begin(), fewer.end(), first.begin()));
}

TEST_CASE("a hole may be a part, and what crosses behind may lie the other way round", "[readings]") {
  const auto has = [](const std::vector<DrawingReading>& readings, const std::string& words) {
    return std::ranges::any_of(readings, [&](const DrawingReading& reading) {
      return std::ranges::any_of(reading.differs, [&](const std::string& each) { return contains(each, words); });
    });
  };
  CHECK(has(readings_of(ring(200, 120), 3), "\"inner\" is a part in front"));
  CHECK(has(readings_of(sticks_behind_disc(0), 8), "goes behind"));
}

TEST_CASE("a drawing that says all about itself has one reading", "[readings]") {
  Drawing disc = ring(200, 120);
  disc.strokes.pop_back();
  CHECK(readings_of(disc, 9).size() == 1);
  Drawing said = ring(200, 120);
  said.strokes[0].data[silhouette::kind_key] = "contour";
  said.strokes[1].data[silhouette::kind_key] = "hole";
  CHECK(readings_of(said, 9).size() == 1);
}

TEST_CASE("what was chosen stays when other strokes change", "[readings]") {
  const std::vector<DrawingReading> readings = readings_of(sticks_behind_disc(1), 6);
  const auto joins = [](const DrawingReading& reading) {
    return std::ranges::any_of(reading.drawing.strokes,
                               [](const Stroke& stroke) { return stroke.data.contains(silhouette::joined_key); });
  };
  const auto chosen = std::ranges::find_if(readings, joins);
  REQUIRE(chosen != readings.end());
  Drawing more = chosen->drawing;
  Stroke button = stroke_of("button", circle_outline({20, 10}, 25));
  button.closed = true;
  more.strokes.push_back(button);
  Progress progress;
  const silhouette::LabelledDrawing labelled = silhouette::label(more, {}, progress);
  for (const silhouette::PinnedEnds& pin : silhouette::pinned_ends(more)) {
    const bool kept = std::ranges::any_of(labelled.figures, [&](const silhouette::LabelledFigure& figure) {
      return std::ranges::count(figure.completions, pin.ends, &silhouette::FigureCompletion::ends) > 0;
    });
    CHECK(kept == pin.joined);
  }
}

TEST_CASE("pins that contradict are refused with the strokes' names", "[readings]") {
  const Drawing drawing = sticks_behind_disc(0);
  std::vector<std::string> open;
  for (const Stroke& stroke : drawing.strokes) {
    if (!stroke.closed) open.push_back(stroke.id);
  }
  REQUIRE(open.size() >= 3);
  const auto with = [&](const std::string& key, const std::string& text, const std::string& more = "",
                        const std::string& value = "") {
    Drawing changed = drawing;
    for (Stroke& stroke : changed.strokes) {
      if (stroke.id == open[0]) stroke.data[key] = text;
      if (stroke.id == open[0] && !more.empty()) stroke.data[more] = value;
    }
    return changed;
  };
  const std::string to_second = "end " + open[1] + " start";
  for (const Drawing& wrong :
       {with("joined", to_second + ", end " + open[2] + " start"), with("joined", to_second, "apart", to_second),
        with("joined", to_second, "kind", "detail"), with("joined", "end " + open[0] + " end")}) {
    const std::string error = error_of(wrong);
    CAPTURE(error);
    CHECK(contains(error, "E_PIN"));
    CHECK(contains(error, "\"" + open[0] + "\""));
  }
  CHECK(contains(error_of(with("joined", "end of it")), "names no two ends"));
  CHECK(error_of(with("joined", "end nobody start")).empty());
}

TEST_CASE("pins are kept, or named where no solid looks like them", "[readings]") {
  const Drawing drawing = sticks_behind_disc(2);
  int kept = 0, left_out = 0;
  for (Index other = 1; other < drawing.strokes.size(); ++other) {
    if (drawing.strokes[0].closed || drawing.strokes[other].closed) continue;
    for (const bool at_start : {true, false}) {
      Drawing pinned = drawing;
      const silhouette::PinnedEnds pin{{silhouette::StrokeEnd{0, true}, silhouette::StrokeEnd{other, at_start}}, true};
      silhouette::pin_ends(pinned, pin);
      CHECK(silhouette::pinned_ends(pinned).front() == pin);
      Progress progress;
      const silhouette::LabelledDrawing labelled = silhouette::label(pinned, {}, progress);
      const bool found = std::ranges::any_of(labelled.figures, [&](const silhouette::LabelledFigure& figure) {
        return std::ranges::count(figure.completions, pin.ends, &silhouette::FigureCompletion::ends) > 0;
      });
      const auto note = std::ranges::find(labelled.findings, "W_PIN", &Finding::code);
      CHECK((found || note != labelled.findings.end()));
      if (!found) CHECK(contains(note->message, "\"" + drawing.strokes[0].id + "\""));
      ++(found ? kept : left_out);
    }
  }
  CHECK(kept > 0);
  CHECK(left_out > 0);
}

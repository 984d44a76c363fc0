// SPDX-License-Identifier: GPL-3.0-or-later
// Symmetric drawings: whatever is done on one side is done on the other one.
#include <algorithm>
#include <cmath>
#include <random>

#include <catch2/catch.hpp>

#include "croquis/silhouette/stroke_data.h"
#include "croquis/tools/recording/recording.h"
#include "croquis/tools/silhouette/sketch_steps.h"
#include "croquis/tools/silhouette/sketch_tool.h"

namespace croquis {
namespace {

constexpr double axis = 37.25;

/// A session with a tool that draws symmetrically.
struct SymmetricDesk {
  Session session;
  SketchTool tool{session};
  double time = 0;

  SymmetricDesk() { tool.options().mirror = axis; }

  void feed(PenStep::Kind kind, const Vec2& at, bool erases = false) {
    SketchEvent event;
    event.kind = kind;
    event.sample.position = at;
    event.sample.time = time += 0.01;
    event.erases = erases;
    tool.handle(event);
  }
  void gesture(const std::vector<Vec2>& places, bool erases = false) {
    for (std::size_t k = 0; k < places.size(); ++k)
      feed(k == 0 ? PenStep::Kind::Begin : PenStep::Kind::Sample, places[k], erases);
    feed(PenStep::Kind::End, places.back(), erases);
  }
  const std::vector<Stroke>& strokes() const { return tool.drawing()->strokes; }
};

/// Around a middle, from one angle to another, in turns.
std::vector<Vec2> arc(const Vec2& middle, double radius, double from = 0, double to = 1) {
  std::vector<Vec2> places;
  for (int k = 0; k <= 80; ++k) {
    const double angle = 2 * 3.14159265358979 * (from + (to - from) * k / 80);
    places.push_back(middle + radius * Vec2(std::cos(angle), std::sin(angle)));
  }
  return places;
}

std::vector<Vec2> places_of_all(const std::vector<Stroke>& strokes) {
  std::vector<Vec2> places;
  for (const Stroke& stroke : strokes) {
    for (const StrokeSample& sample : stroke.samples) places.push_back(sample.position);
  }
  return places;
}

/// Each place has its mirror image among the places, to the last digit but one.
bool is_symmetric(const std::vector<Stroke>& strokes) {
  const std::vector<Vec2> places = places_of_all(strokes);
  return std::ranges::all_of(places, [&](const Vec2& place) {
    return std::ranges::any_of(places, [&](const Vec2& other) {
      return std::abs(other.x() - (2 * axis - place.x())) < 1e-11 && other.y() == place.y();
    });
  });
}

}  // namespace

TEST_CASE("a stroke beside the line gets a twin, one that reaches the line is completed", "[mirror]") {
  SymmetricDesk desk;
  desk.gesture(arc({axis - 100, 0}, 30));
  REQUIRE(desk.strokes().size() == 2);
  CHECK(desk.strokes()[0].closed);
  CHECK(desk.strokes()[1].closed);
  CHECK(desk.strokes()[0].data.at(silhouette::twin_key) == desk.strokes()[1].id);

  desk.gesture(arc({axis - 5, 200}, 60));  // a loop that is drawn a little aside
  REQUIRE(desk.strokes().size() == 3);
  CHECK(desk.strokes()[2].closed);
  CHECK(!desk.strokes()[2].data.contains(silhouette::twin_key));

  desk.gesture(arc({axis, -200}, 50, 0.24, 0.76));  // half a loop, its ends near the line
  REQUIRE(desk.strokes().size() == 4);
  CHECK(desk.strokes()[3].closed);

  desk.gesture({{axis + 40, 300}, {axis + 20, 290}, {axis + 1, 288}});  // half a mouth
  REQUIRE(desk.strokes().size() == 5);
  CHECK(!desk.strokes()[4].closed);
  CHECK(desk.strokes()[4].samples.front().position.x() == Approx(axis + 40).margin(81));
  CHECK(is_symmetric(desk.strokes()));
  CHECK(desk.session.undo_labels().size() == 4);
  while (desk.session.can_undo()) desk.session.undo();
  CHECK(desk.tool.drawing() == nullptr);
}

TEST_CASE("symmetric drawings stay so whatever is moved, bent, erased, deleted and undone", "[mirror]") {
  std::mt19937 random(5);
  const auto number = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  for (int round = 0; round < 20; ++round) {
    SymmetricDesk desk;
    desk.gesture(arc({axis + number(-20, 20), 0}, 150));
    desk.gesture(arc({axis - number(190, 230), number(-50, 50)}, 40));
    desk.gesture(arc({axis + number(60, 90), number(200, 260)}, 30));
    for (int act = 0; act < 12; ++act) {
      INFO(round << " " << act);
      const std::vector<Stroke> before = desk.strokes();
      const Stroke& stroke = before[static_cast<std::size_t>(number(0, 0.999) * static_cast<double>(before.size()))];
      const Vec2 by(number(-25, 25), number(-25, 25));
      const int kind = static_cast<int>(number(0, 4.999));
      if (kind == 0) desk.tool.drag(stroke.id, std::nullopt, by);
      if (kind == 1) desk.tool.drag(stroke.id, std::size_t{0}, by);
      if (kind == 2) desk.tool.set({.stroke = stroke.id, .thickness = number(0.5, 2)});
      if (kind == 3) {
        const Vec2 at = stroke.samples[stroke.samples.size() / 4].position;
        desk.gesture({at - Vec2(3, 3), at + Vec2(3, 3)}, true);
      }
      if (kind == 4 && before.size() > 3) {
        desk.session.select({{desk.tool.node(), stroke.id}});
        desk.tool.delete_selected();
      }
      if (kind == 3) {  // a piece out of a loop on the line ends its symmetry
        std::vector<Stroke> symmetric = desk.strokes();
        std::erase_if(symmetric, [](const Stroke& each) { return !each.data.contains(silhouette::mirror_key); });
        CHECK(is_symmetric(symmetric));
        desk.session.undo();
      }
      CHECK(is_symmetric(desk.strokes()));
      if (desk.strokes().empty()) break;
    }
  }
}

TEST_CASE("a drag that rests before it ends keeps what it did, on either side of the line", "[mirror]") {
  for (const double side : {-1.0, 1.0}) {
    INFO(side);
    SymmetricDesk desk;
    desk.gesture(arc({axis, 0}, 150));
    const Stroke before = desk.strokes().front();
    desk.session.select({{desk.tool.node(), before.id}});
    desk.tool.set_mode(SketchMode::Select);
    const auto& anchors = desk.tool.fit(before.id)->anchors;
    const auto anchor = std::ranges::max_element(anchors, {}, [&](const auto& a) { return side * a.position.x(); });
    const Vec2 from = anchor->position, to = from - Vec2(40 * side, 0);
    desk.feed(PenStep::Kind::Begin, from);
    for (int k = 0; k <= 8; ++k) desk.feed(PenStep::Kind::Sample, from + (to - from) * (k / 8.0));
    for (int k = 0; k < 3; ++k) desk.feed(PenStep::Kind::Sample, to);
    desk.feed(PenStep::Kind::End, to);
    CHECK(is_symmetric(desk.strokes()));
    double reach = 0;
    for (const StrokeSample& sample : desk.strokes().front().samples)
      if (std::abs(sample.position.y() - from.y()) < 5) reach = std::max(reach, std::abs(sample.position.x() - axis));
    CHECK(reach < std::abs(from.x() - axis) - 20);
  }
}

TEST_CASE("what is said of a stroke is said of its twin, and both can part again", "[mirror]") {
  SymmetricDesk desk;
  desk.gesture(arc({axis - 100, 0}, 30));
  desk.tool.set({.stroke = "stroke 2", .fill = "#102030"});
  for (const Stroke& stroke : desk.strokes()) CHECK(stroke.data.at(silhouette::fill_key) == "#102030");
  desk.tool.set({.stroke = "stroke 1", .mirror = ""});
  for (const Stroke& stroke : desk.strokes()) {
    CHECK(!stroke.data.contains(silhouette::mirror_key));
    CHECK(!stroke.data.contains(silhouette::twin_key));
  }
  desk.tool.drag("stroke 1", std::nullopt, {0, 10});
  CHECK(!is_symmetric(desk.strokes()));
  desk.tool.delete_selected();
  desk.session.select({{desk.tool.node(), "stroke 2"}});
  desk.tool.delete_selected();
  CHECK(desk.strokes().size() == 1);
  desk.tool.set({.stroke = "stroke 1", .mirror = std::to_string(axis)});
  CHECK(desk.strokes().size() == 2);
  CHECK(is_symmetric(desk.strokes()));
}

TEST_CASE("a symmetric stroke is recorded with its line, and drawn so again", "[mirror]") {
  SymmetricDesk desk;
  desk.gesture(arc({axis - 5, 200}, 60));
  REQUIRE(desk.tool.done());
  const auto* step = desk.tool.done()->as<recorded::StrokeDrawn>();
  REQUIRE(step != nullptr);
  CHECK(step->mirror == axis);
}

}  // namespace croquis

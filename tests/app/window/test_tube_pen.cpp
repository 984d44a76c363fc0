// SPDX-License-Identifier: GPL-3.0-or-later
// A knot drawn in the window as one line.
#include <QAction>
#include <cmath>

#include <catch2/catch.hpp>

#include "app/replay/replay_player.h"
#include "app/studio_fixture.h"
#include "app/tools/silhouette/sketch_chip.h"
#include "croquis/document/content_hash.h"
#include "croquis/geometry/poly_mesh.h"
#include "croquis/io/file.h"
#include "croquis/operators/inflate_result.h"
#include "croquis/silhouette/stroke_data.h"
#include "croquis/tools/all_steps.h"

namespace croquis::test {
namespace {

std::vector<Vec2> trefoil_line() {
  std::vector<Vec2> places;
  for (int k = 0; k <= 150; ++k) {
    const double angle = 0.3 + 2 * 3.14159265358979 * k / 150, out = 130 * (1 + 0.45 * std::cos(3 * angle));
    places.emplace_back(out * std::cos(2 * angle), out * std::sin(2 * angle));
  }
  return places;
}

TEST_CASE("a trefoil is drawn as one line, becomes a torus, and a click on a chip swaps strands", "[tube-pen]") {
  StudioFixture hand;
  const QString recording = hand.folder() + "/knot.jsonl";
  hand.window().record_to(recording);
  hand.look_at({-260, -200}, {260, 200});
  hand.act("tube-radius-3");
  hand.act("tube");
  hand.draw(trefoil_line());
  hand.settle();
  REQUIRE(hand.studio().drawing().strokes.size() == 1);
  const Stroke drawn = hand.studio().drawing().strokes.front();
  CHECK(drawn.closed);
  CHECK(drawn.data.at("kind") == "tube");
  CHECK(std::stod(drawn.data.at("radius")) > 0);
  const auto inflated = [&] { return *hand.studio().result()->result<InflateResult>(); };
  CHECK(inflated().shells.at(0).euler_mesh == 0);
  REQUIRE(inflated().tube_swaps.size() == 3);
  CHECK(inflated().overlaps.size() == 3);
  hand.picture().save(qEnvironmentVariable("CROQUIS_PICTURES") + "/tube_pen.png");

  auto* swap = hand.viewport().findChild<app::SketchChip*>("strands-1");
  REQUIRE(swap != nullptr);
  REQUIRE(swap->isVisible());
  swap->click();
  hand.settle();
  const std::string words = hand.studio().drawing().strokes.front().data.at("over");
  CHECK_FALSE(words.empty());
  const ContentHash swapped = content_hash(hand.studio().session().document());
  hand.act("undo");
  hand.settle();
  CHECK_FALSE(hand.studio().drawing().strokes.front().data.contains("over"));
  hand.act("redo");
  hand.settle();
  CHECK(content_hash(hand.studio().session().document()) == swapped);
  hand.act("draw");
  hand.draw({{-240, -180}, {-180, -190}, {-190, -130}, {-240, -180}});
  CHECK_FALSE(hand.studio().drawing().strokes.back().data.contains("radius"));
  hand.settle();

  StudioFixture other;
  app::play(other.window(), recorded::parse(read_file(recording.toStdString()), "knot.jsonl", recorded::all_steps()));
  CHECK(content_hash(other.studio().session().document()) == content_hash(hand.studio().session().document()));
}

TEST_CASE("the pen's pressure makes a tube thick and thin, and recordings have its radius", "[tube-pen]") {
  StudioFixture hand;
  hand.look_at({-260, -200}, {260, 200});
  std::string points;
  for (int x = -200; x <= 200; x += 5) {
    points += (points.empty() ? "[" : ",[") + std::to_string(x) + "," + std::to_string(20 * std::sin(x / 60.0)) + "," +
              std::to_string(0.5 + x / 500.0) + "]";
  }
  const std::string step = R"({"do":"stroke","points":[)" + points + R"(],"device":"pen","tube":20})";
  app::play(hand.window(), recorded::parse(step, "tube.jsonl", recorded::all_steps()));
  hand.settle();
  REQUIRE(hand.studio().drawing().strokes.size() == 1);
  const Stroke& drawn = hand.studio().drawing().strokes.front();
  CHECK_FALSE(drawn.closed);
  const double radius = std::stod(drawn.data.at("radius"));
  const auto result = hand.studio().result();
  const auto& mesh = result->outputs.at("mesh").get<PolyMesh>();
  const auto height = [&](double low, double high) {
    double least = 1e9, most = -1e9;
    for (const Vec3& place : mesh.positions) {
      if (place.x() < low || place.x() > high) continue;
      least = std::min(least, place.y());
      most = std::max(most, place.y());
    }
    return most - least;
  };
  CHECK(radius == 20);
  CHECK(height(148, 152) > 1.3 * height(-152, -148));
}

}  // namespace
}  // namespace croquis::test

// SPDX-License-Identifier: GPL-3.0-or-later
#include <QAction>
#include <algorithm>
#include <set>

#include <catch2/catch.hpp>

#include "app/replay/replay_player.h"
#include "app/replay/replays.h"
#include "app/studio_fixture.h"
#include "croquis/base/error.h"
#include "croquis/tools/all_steps.h"

namespace croquis::test {
namespace {

template <typename Table>
std::set<std::string> names_in(const Table& table) {
  std::set<std::string> names;
  for (const auto& [name, entry] : table) names.insert(name);
  return names;
}

std::set<std::string> as_set(const std::vector<std::string>& names) { return {names.begin(), names.end()}; }

void play(StudioFixture& hand, const std::string& text) {
  app::play(hand.window(), recorded::parse(text, "session.jsonl", recorded::all_steps()));
}

TEST_CASE("the window plays every tool's steps, and counts and measures all that recordings may expect", "[replay]") {
  StudioFixture hand;
  const app::Replays all = app::replays_of(hand.window());
  std::set<const recorded::StepKind*> played;
  for (const auto& [kind, plays] : all.plays) played.insert(kind);
  const auto& kinds = recorded::all_steps().kinds();
  CHECK(played == std::set<const recorded::StepKind*>(kinds.begin(), kinds.end()));
  CHECK(names_in(all.counts) == as_set(recorded::all_steps().counts()));
  CHECK(names_in(all.ranges) == as_set(recorded::all_steps().ranges()));
}

TEST_CASE("a recorded edit changes the mesh, is one undo step, and the window shows its mode", "[replay]") {
  StudioFixture hand;
  const std::string mug = CROQUIS_SOURCE_DIR "/examples/data/mug.obj";
  play(hand, R"({"do":"open","file":")" + mug + "\"}\n" +
                 R"({"do":"action","name":"edge-mode"}
                    {"do":"edit","node":"mug","line":"extrude faces=0 by=0,0.2,0.1"}
                    {"do":"expect","what":"vertices","count":92}
                    {"do":"expect","what":"selected","count":1})");
  CHECK(hand.window().action("face-mode")->isChecked());
  CHECK(hand.studio().session().undo_labels().back() == "Extrude 1 face");
  play(hand, R"({"do":"action","name":"undo"}
                {"do":"expect","what":"vertices","count":84})");
  CHECK_THROWS_AS(play(hand, R"({"do":"edit","node":"mug","line":"extrude faces=99999 by=0,0,1"})"), Error);
  CHECK_THROWS_AS(play(hand, R"({"do":"expect","what":"vertices","count":85})"), Error);
}

TEST_CASE("a recorded movement of a view that isn't there is refused", "[replay]") {
  StudioFixture hand;
  hand.act("new-perspective");
  const char* const unknown = R"({"do":"navigate","view":"persp","motion":"tumble","by":[40,20]})";
  CHECK_THROWS_WITH(play(hand, unknown), Catch::Contains("There is no view \"persp\""));
}

}  // namespace
}  // namespace croquis::test

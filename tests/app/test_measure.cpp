// SPDX-License-Identifier: GPL-3.0-or-later
#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QFile>
#include <QLabel>

#include <catch2/catch.hpp>

#include "app/hand_on_meshes.h"
#include "app/replay/replay_player.h"
#include "app/tools/measure/measuring_tool.h"
#include "croquis/io/file.h"
#include "croquis/tools/all_steps.h"

namespace croquis::test {
namespace {

QStringList shown_values(StudioFixture& hand) {
  QStringList texts;
  for (const QLabel* label : hand.viewport().findChildren<QLabel*>("measured-value")) {
    if (label->isVisible()) texts << label->text();
  }
  texts.removeDuplicates();
  return texts;
}

TEST_CASE("clicked corners of a cube are measured, shown, copied, recorded and played again", "[measure]") {
  StudioFixture hand;
  open_mesh(hand, centred_cube(), "cube");
  const QString recording = hand.folder() + "/measure.jsonl";
  hand.window().record_to(recording);
  hand.act("measure");
  CHECK_FALSE(hand.window().action("copy-measurement")->isEnabled());
  hand.click_model({1, -1, 1}, app::Viewport::PerspectiveView);
  hand.click_model({1, 1, 1}, app::Viewport::PerspectiveView);
  hand.picture();
  CHECK(shown_values(hand) == QStringList{"Distance 2"});
  hand.click_model({-1, 1, 1}, app::Viewport::PerspectiveView);
  hand.picture();
  CHECK(shown_values(hand).contains("Angle 90°"));
  CHECK(shown_values(hand).contains("Radius 1.41421"));
  hand.act("copy-measurement");
  CHECK(QApplication::clipboard()->text().startsWith("Distance: 2 (x 0, y 2, z 0)\nDistance: 2 (x -2, y 0, z 0)\n"));
  CHECK(hand.studio().session().undo_labels().empty());

  const std::string lines = read_file(recording.toStdString());
  hand.act("deselect");
  hand.picture();
  CHECK(shown_values(hand).isEmpty());
  app::play(hand.window(), recorded::parse(lines + R"({"do":"expect","what":"measured","value":2})" + "\n",
                                           "measure.jsonl", recorded::all_steps()));
  CHECK(hand.window().tool<app::MeasuringTool>().measure().places().size() == 3);
  hand.act("select");
  hand.picture();
  CHECK(shown_values(hand).isEmpty());
}

}  // namespace
}  // namespace croquis::test

// SPDX-License-Identifier: GPL-3.0-or-later
// Guided tours in the real window.
#include <QAction>
#include <QApplication>
#include <QLabel>
#include <QPushButton>
#include <QRegularExpression>
#include <QSettings>
#include <map>
#include <random>

#include <catch2/catch.hpp>

#include "app/replay/replays.h"
#include "app/studio_fixture.h"
#include "app/tours/tour_bar.h"
#include "app/tours/tour_guide.h"
#include "app/window/command_palette.h"
#include "app/window/language.h"
#include "croquis/tools/silhouette/sketch_steps.h"

using namespace croquis;
using namespace croquis::test;

namespace {

app::TourBar* tour_in(StudioFixture& hand) { return hand.window().findChild<app::TourBar*>("tour"); }

app::TourBar& begin_tour(StudioFixture& hand, const QString& name) {
  hand.window().set_unattended();
  hand.act("help-tour-" + name);
  REQUIRE(tour_in(hand) != nullptr);
  hand.settle();
  return *tour_in(hand);
}

void press(StudioFixture& hand, const char* button) {
  hand.window().findChild<QPushButton*>(button)->click();
  QApplication::processEvents();
}

std::size_t count(StudioFixture& hand, const char* what) { return app::replays_of(hand.window()).counts.at(what)(""); }

void save_picture(StudioFixture& hand, const QString& name) {
  if (!qEnvironmentVariableIsSet("CROQUIS_PICTURES")) return;
  hand.settle();
  hand.window().grab().save(qEnvironmentVariable("CROQUIS_PICTURES") + "/tour-" + name + ".png");
}

std::vector<Vec2> asked_stroke(const app::TourBar& bar, std::size_t i) {
  std::vector<Vec2> places;
  for (const Vec3& place : app::path_of(bar.tour().steps[bar.at()].asked[i]).places) places.push_back(place.head<2>());
  return places;
}

/// The tour goes on in its own time, not within the pen's event.
bool comes_to(StudioFixture& hand, const app::TourBar& bar, std::size_t step) {
  return hand.wait_for([&] { return bar.at() == step; });
}

/// Plays a tour to its end by Show me, and counts what its model is to have.
void play_tour(StudioFixture& hand, const QString& name, const std::map<const char*, std::size_t>& model) {
  hand.window().resize(1280, 720);
  const app::TourBar& bar = begin_tour(hand, name);
  const std::size_t steps = bar.tour().steps.size();
  CHECK(steps >= 5);
  CHECK(steps <= 9);
  for (std::size_t step = 0; step < steps; ++step) {
    REQUIRE(bar.at() == step);
    save_picture(hand, QString("%1-%2").arg(name).arg(step));
    press(hand, "tour-show");
    CHECK(hand.window().last_findings().empty());
  }
  CHECK(bar.at() == steps);
  save_picture(hand, name + "-end");
  hand.settle();
  for (const auto& [what, wanted] : model) {
    INFO(what);
    CHECK(count(hand, what) == wanted);
  }
  press(hand, "tour-end");
  QApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  CHECK(tour_in(hand) == nullptr);
  CHECK(hand.studio().objects().size() == 1);
}

}  // namespace

TEST_CASE("the tour of a character is played to its end by Show me", "[tours]") {
  StudioFixture hand;
  play_tour(hand, "1-character",
            {{"strokes", 8}, {"strokes-behind", 2}, {"inner-parts", 2}, {"tubes", 2}, {"left-out", 0}});
}

TEST_CASE("the tour of a box in perspective is played to its end by Show me", "[tours]") {
  StudioFixture hand;
  play_tour(hand, "2-perspective-box",
            {{"perspective-closed", 1}, {"perspective-faces", 6}, {"perspective-open", 0}, {"findings", 0}});
}

TEST_CASE("the tour of a surface is played to its end by Show me", "[tours]") {
  StudioFixture hand;
  play_tour(hand, "3-curve-surface", {{"surface-curves", 3}, {"surface-patches-made", 1}, {"surface-points", 1}});
}

TEST_CASE("the tour of sharp edges is played to its end by Show me", "[tours]") {
  StudioFixture hand;
  play_tour(hand, "4-sharp-edges", {{"selected", 4}, {"findings", 0}});
  const auto cage = hand.studio().active()->cage_mesh;
  CHECK(cage->tags.creases.size() == 8);  // four of them came with the sample
}

TEST_CASE("the tour of a scan is played to its end by Show me", "[tours]") {
  StudioFixture hand;
  play_tour(hand, "5-scan-holes", {{"holes", 1}, {"patches", 5}});
}

TEST_CASE("a tour goes on by strokes near the dotted lines, and by the actions it names", "[tours]") {
  StudioFixture hand;
  const app::TourBar& bar = begin_tour(hand, "1-character");
  std::mt19937 random(7);
  std::uniform_real_distribution<double> off(-1, 1);
  for (std::size_t step = 0; step < 5; ++step) {
    INFO("step " << step);
    REQUIRE(bar.at() == step);
    for (std::size_t i = bar.tour().steps[step].asked.size(); i-- > 0;) {  // in another order than they stand there
      std::vector<Vec2> places = asked_stroke(bar, i);
      Vec2 low = places.front();
      Vec2 high = low;
      for (const Vec2& place : places) {
        low = low.cwiseMin(place);
        high = high.cwiseMax(place);
      }
      const Vec2 shift = 0.02 * (high - low).norm() * Vec2(off(random), off(random));
      for (Vec2& place : places) place += shift + 0.004 * (high - low).norm() * Vec2(off(random), off(random));
      hand.draw(places);
      hand.settle();
    }
    REQUIRE(comes_to(hand, bar, step + 1));
  }
  hand.act("four-views");
  CHECK(comes_to(hand, bar, 6));
  CHECK(count(hand, "strokes") == 8);
  CHECK(count(hand, "tubes") == 2);
}

TEST_CASE("a tour stays at a stroke elsewhere, and what is drawn stays when it ends", "[tours]") {
  StudioFixture hand;
  const app::TourBar& bar = begin_tour(hand, "1-character");
  std::vector<Vec2> elsewhere;
  for (int i = 0; i <= 20; ++i) elsewhere.emplace_back(-150 + 2 * i, -190 + i);
  hand.draw(elsewhere);
  hand.settle();
  CHECK_FALSE(hand.wait_for([&] { return bar.at() != 0 || count(hand, "strokes") != 1; }));
  hand.act("undo");
  hand.draw(asked_stroke(bar, 0));
  hand.settle();
  CHECK(comes_to(hand, bar, 1));
  press(hand, "tour-skip");
  CHECK(bar.at() == 2);
  const std::size_t steps_before = hand.studio().session().undo_labels().size();
  press(hand, "tour-end");
  QApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  CHECK(tour_in(hand) == nullptr);
  CHECK(hand.window().findChild<QWidget*>("tour-guide") == nullptr);
  CHECK(count(hand, "strokes") == 1);
  CHECK(hand.studio().session().undo_labels().size() == steps_before);
}

TEST_CASE("tours are found in the palette and on the start page, and each asks for what the window has", "[tours]") {
  StudioFixture hand;
  hand.window().set_unattended();
  const QStringList names = app::tour_names();
  CHECK(names.size() == 5);
  const auto commands = app::all_commands(hand.window());
  for (const QString& name : names) {
    const app::Tour tour = app::load_tour(name);
    INFO(name.toStdString());
    REQUIRE(app::found_commands(commands, tour.title).size() > 0);
    const app::Command& found = commands[app::found_commands(commands, tour.title).front()];
    CHECK(found.place.contains("Tours"));
    for (const app::TourStep& step : tour.steps) {
      for (const recorded::Step& asked : step.asked) {
        if (const auto* action = asked.as<recorded::Action>())
          CHECK(hand.window().action(QString::fromStdString(action->name)) != nullptr);
      }
    }
  }
  hand.act("start-page");
  auto* link = hand.window().findChild<QPushButton*>("start-help-tour-" + names.back());
  REQUIRE(link != nullptr);
  CHECK(link->isVisible());
  save_picture(hand, "start-page");
  link->click();
  QApplication::processEvents();
  REQUIRE(tour_in(hand) != nullptr);
  CHECK(hand.window().shows_views());
  for (const char* button : {"tour-show", "tour-skip", "tour-end"}) {
    auto* found = tour_in(hand)->findChild<QPushButton*>(button);
    CHECK((found->focusPolicy() & Qt::TabFocus) != 0);
    CHECK_FALSE(found->text().isEmpty());
  }
}

TEST_CASE("in Korean every caption of a tour is Korean", "[tours]") {
  struct English {
    ~English() { app::use_language("en"); }
  } after;
  app::use_language("ko");
  static const QRegularExpression hangul(QStringLiteral("[\\x{ac00}-\\x{d7a3}]"));
  for (const QString& name : app::tour_names()) {
    const app::Tour tour = app::load_tour(name);
    QStringList texts{tour.title, tour.end};
    for (const app::TourStep& step : tour.steps) texts << step.caption;
    for (const QString& text : texts) {
      INFO(name.toStdString() << ": " << text.toStdString());
      CHECK(app::shown_text(text.toStdString()).contains(hangul));
    }
  }
  StudioFixture hand;
  hand.window().resize(1280, 720);
  const bool takes_pictures = qEnvironmentVariableIsSet("CROQUIS_PICTURES");
  for (const QString& name : takes_pictures ? app::tour_names() : app::tour_names().mid(0, 1)) {
    const app::TourBar& bar = begin_tour(hand, name);
    for (const QLabel* label : bar.findChildren<QLabel*>()) CHECK(label->text().contains(hangul));
    if (!takes_pictures) continue;
    save_picture(hand, name + "-0-ko");
    press(hand, "tour-show");
    save_picture(hand, name + "-1-ko");
  }
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include <QAction>
#include <QDoubleSpinBox>
#include <QPushButton>
#include <QSet>
#include <QSlider>
#include <QToolButton>

#include <catch2/catch.hpp>

#include "app/panels/attribute_panel.h"
#include "app/panels/lists.h"
#include "app/start/gallery.h"
#include "app/start/start_page.h"
#include "app/studio_fixture.h"
#include "support/sketches/sketch_gallery.h"

using namespace croquis;
using croquis::test::StudioFixture;

namespace {

double parameter_of_solid(StudioFixture& hand, const std::string& name) {
  const Node* node = hand.studio().solid_operation();
  const auto found = node->parameters.find(name);
  return found == node->parameters.end() ? -1 : std::get<double>(found->second);
}

}  // namespace

TEST_CASE("the panel has a field for every parameter that people set there, named and explained", "[panels]") {
  StudioFixture hand;
  hand.draw(test::snake_sketch());
  auto* panel = hand.window().findChild<app::AttributePanel*>("attributes");
  for (const ParameterDescription& parameter :
       hand.studio().description(hand.studio().solid_operation()->operation)->parameters) {
    INFO(parameter.name);
    app::ParameterField* field = panel->field(parameter.name);
    REQUIRE((field == nullptr) == (parameter.place == ParameterPlace::Nowhere));
    if (field == nullptr) continue;
    CHECK(field->toolTip().toStdString().starts_with(parameter.sentence));
    CHECK(field->toolTip().toStdString().ends_with(parameter.unit));
  }
}

TEST_CASE("a slider drag is one step, changes the solid, and undo moves the slider back", "[panels]") {
  StudioFixture hand;
  hand.draw(test::linked_rings_sketch());
  hand.settle();
  const auto before = hand.studio().solid();
  auto* field = hand.window().findChild<app::AttributePanel*>("attributes")->field("min-gap");
  auto* slider = field->findChild<QSlider*>();
  auto* box = field->findChild<QDoubleSpinBox*>();
  const double value = box->value();
  const std::size_t steps = hand.studio().session().undo_labels().size();
  slider->setSliderDown(true);
  for (int position = 300; position <= 800; position += 50) slider->setValue(position);
  slider->setSliderDown(false);
  hand.settle();
  CHECK(hand.studio().session().undo_labels().size() == steps + 1);
  CHECK(parameter_of_solid(hand, "min-gap") == Approx(box->value()));
  CHECK(box->value() > value);
  CHECK(hand.studio().solid() != before);
  hand.act("undo");
  CHECK(parameter_of_solid(hand, "min-gap") == -1);
  CHECK(box->value() == Approx(value));
}

TEST_CASE("objects and findings choose their strokes, the history goes to any step", "[panels]") {
  StudioFixture hand;
  hand.draw(test::linked_rings_sketch());
  hand.settle();
  auto* objects = hand.window().findChild<app::ObjectList*>("objects");
  REQUIRE(part_rows(hand).size() == 2);
  emit objects->itemClicked(part_rows(hand).front(), 0);
  CHECK(hand.studio().session().selection().size() >= 1);
  auto* history = hand.window().findChild<app::HistoryList*>("history");
  CHECK(history->count() == static_cast<int>(hand.studio().session().undo_labels().size()) + 1);
  emit history->itemClicked(history->item(1));
  CHECK(hand.studio().drawing().strokes.size() == 1);
  emit history->itemClicked(history->item(history->count() - 1));
  CHECK(hand.studio().drawing().strokes.size() == 4);
}

TEST_CASE("the start page shows every shipped sketch as a picture and opens it", "[panels]") {
  StudioFixture hand;
  hand.act("start-page");
  auto* page = hand.window().findChild<app::StartPage*>("start-page");
  REQUIRE(page->isVisible());
  const auto sketches = app::samples();
  CHECK(sketches.size() >= 6);
  for (const app::Sample& sketch : sketches) {
    INFO(sketch.name.toStdString());
    auto* tile = page->findChild<QToolButton*>("sketch-" + sketch.name);
    REQUIRE(tile != nullptr);
    CHECK(hand.wait_for([&] { return !tile->icon().isNull(); }));
  }
  page->findChild<QToolButton*>("sketch-chain")->click();
  hand.settle();
  CHECK(hand.window().shows_views());
  CHECK(hand.studio().drawing().strokes.size() == 16);
  CHECK(hand.studio().solid() != nullptr);
}

TEST_CASE("every action has a name of its own", "[panels]") {
  StudioFixture hand;
  QSet<QString> names;
  for (const QAction* action : hand.window().actions()) {
    CHECK(!action->objectName().isEmpty());
    CHECK(!names.contains(action->objectName()));
    names.insert(action->objectName());
  }
  CHECK(names.size() > 15);
}

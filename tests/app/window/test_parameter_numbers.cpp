// SPDX-License-Identifier: GPL-3.0-or-later
// What the fields of attributes show for numbers: "auto", lengths, and words at the ends of sliders.
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDockWidget>
#include <QLabel>
#include <QLineEdit>
#include <QRegularExpression>
#include <QSlider>
#include <QSpinBox>
#include <QTest>

#include <catch2/catch.hpp>

#include "app/hole_scans.h"
#include "app/panels/attribute_panel.h"
#include "app/window/language.h"
#include "croquis/workspace/object_commands.h"
#include "support/sketches/sketch_gallery.h"

using namespace croquis;
using namespace croquis::test;

namespace {

QAbstractSpinBox* box_of(const app::AttributePanel& panel, const std::string& parameter) {
  app::ParameterField* field = panel.field(parameter);
  return field == nullptr ? nullptr : field->findChild<QAbstractSpinBox*>();
}

QAbstractSpinBox* box_of(StudioFixture& hand, const std::string& parameter) {
  return box_of(*hand.window().findChild<app::AttributePanel*>("attributes"), parameter);
}

/// Of "auto (2.4 mm)" and "6 (2.4)": 2.4; 0 where there is no length.
double length_in(const QString& text) {
  static const QRegularExpression length(QStringLiteral("\\(([0-9.e+-]+)( [a-z]+)?\\)$"));
  return length.match(text).captured(1).toDouble();
}

double diagonal_of(const BoundingBox& box) { return ((*box)[1] - (*box)[0]).norm(); }

void type_number(QAbstractSpinBox& box, const char* number) {
  box.setFocus();
  box.selectAll();
  QTest::keyClicks(&box, number);
  QTest::keyClick(&box, Qt::Key_Return);
}

Node node_of(const OperationDescription& operation) {
  Node node;
  node.id = 1;
  node.operation = operation.id;
  return node;
}

void save_picture(StudioFixture& hand, const char* name) {
  if (!qEnvironmentVariableIsSet("CROQUIS_PICTURES")) return;
  hand.window().resize(1280, 720);
  hand.window().findChild<QDockWidget*>("attributes-dock")->raise();
  QApplication::processEvents();
  hand.window().grab().save(qEnvironmentVariable("CROQUIS_PICTURES") + "/numbers-" + name + ".png");
}

}  // namespace

TEST_CASE("numbers that are left to the program begin with auto, and are numbers once they are given", "[numbers]") {
  StudioFixture hand;
  const app::Studio& studio = hand.studio();
  int automatic = 0;
  for (const OperationDescription& operation : studio.registry().descriptions()) {
    app::AttributePanel panel;
    Node node = node_of(operation);
    panel.show_node(studio, &node);
    for (const ParameterDescription& parameter : operation.parameters) {
      const QAbstractSpinBox* box = box_of(panel, parameter.name);
      if (box == nullptr) continue;
      INFO(operation.id << " " << parameter.name << ": " << box->text().toStdString());
      const bool is_relative = parameter.length > ParameterLength::Model && parameter.default_title.empty();
      const bool is_automatic = is_relative || parameter.default_title == "auto";
      CHECK(box->text().startsWith("auto") == is_automatic);
      CHECK((parameter.default_title.empty() || box->text().startsWith(parameter.default_title.c_str())));
      if (!is_automatic) continue;
      ++automatic;
      if (parameter.type == ParameterType::Number) node.parameters[parameter.name] = parameter.maximum;
      if (parameter.type == ParameterType::Integer)
        node.parameters[parameter.name] = static_cast<std::int64_t>(parameter.maximum);
      panel.show_node(studio, &node);
      CHECK(box->text().toDouble() == Approx(parameter.maximum));
    }
  }
  CHECK(automatic > 8);
}

TEST_CASE("a length beside a number is a share of the drawing, and grows with the object", "[numbers]") {
  StudioFixture hand;
  hand.draw(snake_sketch());
  hand.settle();
  const double size = diagonal_of(bounds_of(hand.studio().drawing()));
  auto* detail = box_of(hand, "resolution");
  REQUIRE(detail->text().startsWith("auto ("));
  const double length = length_in(detail->text());
  CHECK(length == Approx(0.006 * size).epsilon(0.05));  // two figures
  type_number(*detail, "12");
  CHECK(detail->text().startsWith("12 ("));
  CHECK(length_in(detail->text()) == Approx(2 * length).epsilon(0.05));
  const double given = length_in(detail->text());
  const WorkObject& object = *hand.studio().active();
  Placement larger = object.placement;
  larger.scale *= 10;
  place_objects(hand.studio(), {{object.node, larger}});
  hand.settle();
  CHECK(length_in(detail->text()) == Approx(10 * given).epsilon(0.05));
}

TEST_CASE("a number replaces auto, resetting and undo give it back", "[numbers]") {
  StudioFixture hand;
  hand.draw(snake_sketch());
  hand.settle();
  auto* gap = box_of(hand, "min-gap");
  const auto is_given = [&] { return hand.studio().solid_operation()->parameters.contains("min-gap"); };
  REQUIRE(gap->text() == "auto");
  type_number(*gap, "0.3");
  CHECK(gap->text() == "0.3");
  CHECK(is_given());
  gap->actions().front()->trigger();
  CHECK(gap->text() == "auto");
  CHECK_FALSE(is_given());
  CHECK(hand.studio().session().undo_labels().back() == "Gap between parts");
  hand.act("undo");
  CHECK(gap->text() == "0.3");
  hand.act("undo");
  CHECK(gap->text() == "auto");
  // What is no number changes nothing.
  gap->setFocus();
  QTest::keyClick(gap, Qt::Key_End);
  QTest::keyClick(gap, Qt::Key_Backspace);
  QTest::keyClick(gap, Qt::Key_Return);
  CHECK(gap->text() == "auto");
  CHECK_FALSE(is_given());
}

TEST_CASE("the length of a solid in perspective is in the drawing's unit", "[numbers]") {
  StudioFixture hand;
  REQUIRE(hand.window().open(CROQUIS_SOURCE_DIR "/examples/data/perspective/camera.svg"));
  hand.settle();
  auto* detail = box_of(hand, "tolerance");
  REQUIRE(detail != nullptr);
  const double size = diagonal_of(hand.studio().own_bounds(*hand.studio().active()));
  CHECK(detail->text().startsWith("auto ("));
  CHECK(length_in(detail->text()) == Approx(0.0005 * size).epsilon(0.05));
  const QString unit = QString::fromStdString(hand.studio().unit());
  CHECK(detail->text().endsWith(unit.isEmpty() ? ")" : " " + unit + ")"));
  save_picture(hand, "perspective");
}

TEST_CASE("choices and flags are reset, too", "[numbers]") {
  StudioFixture hand;
  open_scan(hand, ball_with_holes());
  hand.settle();
  auto* weld = box_of(hand, "weld");
  REQUIRE(weld != nullptr);
  CHECK(weld->text().startsWith("auto ("));
  CHECK(box_of(hand, "max-diameter")->text() == "no limit");
  save_picture(hand, "scan");
  auto* panel = hand.window().findChild<app::AttributePanel*>("attributes");
  const NodeId step = hand.studio().active()->node;
  const auto parameters = [&] { return hand.studio().session().document().find(step)->parameters; };
  const ParameterValues before = parameters();
  emit panel->field("fairness")->edited(std::string("smooth"), false);
  REQUIRE(parameters() != before);
  panel->field("fairness")->findChild<QComboBox*>()->actions().front()->trigger();
  CHECK(parameters() == before);
}

TEST_CASE("words at the ends of sliders are in the language in use and have their room", "[numbers]") {
  StudioFixture hand;
  const app::Studio& studio = hand.studio();
  const QFont usual = QApplication::font();
  for (const char* language : {"en", "ko"}) {
    app::use_language(language);
    for (const double scale : {1.0, 1.5}) {
      QFont font = usual;
      font.setPointSizeF(usual.pointSizeF() * scale);
      QApplication::setFont(font);
      int found = 0;
      for (const OperationDescription& operation : studio.registry().descriptions()) {
        const Node node = node_of(operation);
        app::AttributePanel panel;
        panel.show_node(studio, &node);
        panel.resize(static_cast<int>(297 * scale), 900);  // as in a window of 1280 x 720
        panel.show();
        for (int round = 0; round < 6; ++round) QApplication::processEvents();  // layouts follow one another
        for (const ParameterDescription& parameter : operation.parameters) {
          app::ParameterField* field = panel.field(parameter.name);
          if (parameter.type != ParameterType::Number || field == nullptr) continue;
          const QList<QLabel*> words = field->findChildren<QLabel*>();
          INFO(language << " " << scale << " " << operation.id << " " << parameter.name);
          REQUIRE(words.size() == static_cast<int>(parameter.choice_titles.size()));
          if (words.empty() || !field->isVisible()) continue;
          ++found;
          const auto* slider = field->findChild<QSlider*>();
          REQUIRE(slider != nullptr);
          for (int end = 0; end < 2; ++end) {
            const std::string& english = parameter.choice_titles[static_cast<std::size_t>(end)];
            INFO(english << " " << words[end]->text().toStdString());
            CHECK((words[end]->text().toStdString() == english) == (std::string_view(language) == "en"));
            CHECK(words[end]->width() >= words[end]->minimumSizeHint().width());
            CHECK(field->rect().contains(words[end]->geometry()));
          }
          CHECK(words[0]->geometry().right() < words[1]->geometry().left());
          CHECK(words[1]->geometry().right() <= slider->geometry().right());
        }
      }
      CHECK(found > 8);
    }
  }
  QApplication::setFont(usual);
  app::use_language("en");
}

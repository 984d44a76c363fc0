// SPDX-License-Identifier: GPL-3.0-or-later
// What was: the slider over the steps, versions under names, two states beside each other.
#include <QInputDialog>
#include <QLabel>
#include <QListWidget>
#include <QMenu>
#include <QMessageBox>
#include <QTest>

#include <catch2/catch.hpp>

#include "app/dialogs.h"
#include "app/tools/history/history_tool.h"

using namespace croquis;
using namespace croquis::test;

namespace {

/// With a mug, which a step makes smooth.
class Mug : public StudioFixture {
 public:
  Mug() {
    window().set_unattended();
    open_cage("mug");
    act("show-smooth");
    settle();
  }

  app::HistoryTool& history() { return window().tool<app::HistoryTool>(); }
  app::StepSlider& slider() { return *window().findChild<app::StepSlider*>("history-slider"); }
  QListWidget& versions() { return *window().findChild<QListWidget*>("versions"); }
  Session& session() { return studio().session(); }
  NodeId object() { return studio().objects().front().node; }

  void rename(int number) { rename_object(studio(), object(), "mug " + std::to_string(number)); }
  void set_level(std::int64_t level) {
    studio().set_parameter(object(), "levels", level, false);
    settle();
  }

  void save_version(const QString& name) {
    act("save-version");
    auto* dialog = window().findChild<QInputDialog*>("version-name");
    REQUIRE(dialog != nullptr);
    dialog->setTextValue(name);
    dialog->accept();
    QApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  }

  /// What the menu of a version has.
  void choose(int version, const QString& text) {
    const QRect row = versions().visualItemRect(versions().item(version));
    emit versions().customContextMenuRequested(row.center());
    for (QAction* action : versions().findChild<QMenu*>()->actions()) {
      if (action->text() == text) action->trigger();
    }
  }

  /// Where the handle is at a step, in the slider's pixels.
  QPoint place_of(int step) {
    constexpr int handle = 12;  // about as wide
    const int room = slider().width() - handle;
    return {handle / 2 + room * step / std::max(1, slider().maximum()), slider().height() / 2};
  }

  /// For people to look at.
  void keep_picture(const QString& name) {
    if (qEnvironmentVariableIsSet("CROQUIS_PICTURES"))
      window().grab().save(qEnvironmentVariable("CROQUIS_PICTURES") + "/" + name + ".png");
  }

  std::vector<std::uint64_t> states() {
    std::vector<std::uint64_t> all;
    for (const auto& each : session().history()) all.push_back(each.state);
    return all;
  }
};

std::vector<std::string> names_of(const Session& session) {
  std::vector<std::string> names;
  for (const Version& version : session.versions.list()) names.push_back(version.name);
  return names;
}

}  // namespace

TEST_CASE("the slider goes through twelve steps as undo does, and back", "[history]") {
  Mug hand;
  const int first = static_cast<int>(hand.session().undo_labels().size());
  for (int step = 1; step <= 12; ++step) hand.rename(step);
  const int last = first + 12;
  CHECK(hand.slider().maximum() == last);
  CHECK(hand.slider().value() == last);
  std::vector<std::uint64_t> undone{hand.session().state()};
  while (hand.session().can_undo()) {
    hand.session().undo();
    undone.push_back(hand.session().state());
    CHECK(hand.slider().value() == last + 1 - static_cast<int>(undone.size()));
  }
  hand.session().go_to(1000);
  QTest::mousePress(&hand.slider(), Qt::LeftButton, Qt::NoModifier, hand.place_of(last));
  int seen = 0;
  std::uint64_t before = hand.session().state();
  for (int step = last - 1; step >= 0; --step) {
    QTest::mouseMove(&hand.slider(), hand.place_of(step));
    QApplication::processEvents();
    const auto steps = hand.session().undo_labels().size();
    CHECK(hand.session().state() == undone[static_cast<std::size_t>(last) - steps]);
    CHECK(static_cast<std::size_t>(hand.slider().value()) == steps);
    seen += hand.session().state() != before ? 1 : 0;
    before = hand.session().state();
  }
  CHECK(seen >= 12);
  QTest::mouseRelease(&hand.slider(), Qt::LeftButton, Qt::NoModifier, hand.place_of(0));
  CHECK(hand.session().undo_labels().empty());
  // A click beside the handle goes there at once, the arrow keys one step further.
  QTest::mouseClick(&hand.slider(), Qt::LeftButton, Qt::NoModifier, hand.place_of(last));
  CHECK(hand.session().state() == undone.front());
  QTest::keyClick(&hand.slider(), Qt::Key_Left);
  CHECK(hand.session().state() == undone[1]);
  CHECK(hand.session().redo_labels().size() == 1);
}

TEST_CASE("what isn't computed is shown when the slider is let go", "[history]") {
  Mug hand;
  hand.set_level(1);
  hand.set_level(3);
  const auto states = hand.states();
  hand.studio().evaluator().forget();
  const int now = hand.slider().value();
  hand.slider().setSliderDown(true);
  hand.slider().setValue(now - 1);
  CHECK(hand.session().state() == states[static_cast<std::size_t>(now)]);
  hand.slider().setSliderDown(false);
  CHECK(hand.session().state() == states[static_cast<std::size_t>(now) - 1]);
  hand.settle();
  hand.slider().setSliderDown(true);
  hand.slider().setValue(now - 2);
  hand.slider().setValue(now - 1);
  CHECK(hand.session().state() == states[static_cast<std::size_t>(now) - 1]);
  hand.slider().setSliderDown(false);
}

TEST_CASE("a step that has settled has a picture above the slider's handle", "[history]") {
  Mug hand;
  hand.set_level(1);
  const std::uint64_t state = hand.session().state();
  REQUIRE(hand.wait_for([&] { return !hand.history().picture(state).isNull(); }));
  CHECK(hand.history().picture(state).size() == QSize(96, 72));
  CHECK(hand.history().picture(state + 1).isNull());
  QTest::mousePress(&hand.slider(), Qt::LeftButton, Qt::NoModifier, hand.place_of(hand.slider().maximum()));
  const auto* shown = hand.window().findChild<QLabel*>("history-picture");
  REQUIRE(shown != nullptr);
  CHECK(shown->isVisible());
  CHECK(shown->pixmap(Qt::ReturnByValue).toImage().convertToFormat(QImage::Format_RGB32) ==
        hand.history().picture(state).convertToFormat(QImage::Format_RGB32));
  hand.keep_picture("history");
  const QRect place(shown->mapToGlobal(QPoint()), shown->size());
  CHECK(place.bottom() < hand.slider().mapToGlobal(QPoint(0, hand.slider().height())).y());
  QTest::mouseRelease(&hand.slider(), Qt::LeftButton, Qt::NoModifier, hand.place_of(hand.slider().maximum()));
  CHECK(hand.session().state() == state);
}

TEST_CASE("a version is shown by a click, as one step that undo takes back", "[history]") {
  Mug hand;
  CHECK(hand.versions().isHidden());
  const Document first = hand.session().document();
  hand.save_version("Coarse");
  CHECK(!hand.versions().isHidden());
  hand.set_level(3);
  hand.save_version("Fine");
  hand.save_version("Fine");
  CHECK(names_of(hand.session()) == std::vector<std::string>{"Coarse", "Fine", "Fine 2"});
  const Document fine = hand.session().document();
  const auto steps = hand.session().undo_labels().size();
  emit hand.versions().itemClicked(hand.versions().item(0));
  CHECK(hand.session().undo_labels().size() == steps + 1);
  CHECK(hand.session().document().nodes() == first.nodes());
  hand.settle();
  hand.act("undo");
  CHECK(hand.session().document().nodes() == fine.nodes());
  emit hand.versions().itemClicked(hand.versions().item(1));
  CHECK(hand.session().redo_labels().size() == 1);  // it is shown already

  hand.versions().item(2)->setText("Best");
  QApplication::processEvents();
  CHECK(names_of(hand.session()) == std::vector<std::string>{"Coarse", "Fine", "Best"});
  hand.versions().item(2)->setText("  ");
  QApplication::processEvents();
  CHECK(hand.versions().item(2)->text() == "Best");
  in_dialog<QMessageBox>([](QMessageBox& box) { box.button(QMessageBox::Yes)->click(); });
  hand.choose(1, "Delete");
  CHECK(names_of(hand.session()) == std::vector<std::string>{"Coarse", "Best"});
  CHECK(hand.versions().count() == 2);
}

TEST_CASE("versions come with their project, and with what a crash left", "[history]") {
  Mug hand;
  hand.save_version("First");
  REQUIRE(hand.wait_for([&] { return !hand.session().versions.list().front().picture_png.empty(); }));
  const QString path = hand.folder() + "/mug.croq";
  hand.window().files().save(path);
  CHECK(!hand.session().modified());
  const Document first = hand.session().document();
  hand.act("new");
  CHECK(hand.session().versions.list().empty());
  CHECK(hand.versions().isHidden());
  REQUIRE(hand.window().open(path));
  hand.settle();
  REQUIRE(names_of(hand.session()) == std::vector<std::string>{"First"});
  CHECK(!hand.session().versions.list().front().picture_png.empty());
  hand.set_level(3);
  hand.save_version("Second");
  CHECK(hand.session().modified());
  hand.crash_and_restart();
  const auto offers = hand.window().files().recoverable();
  REQUIRE(offers.size() == 1);
  hand.window().files().recover(offers.front());
  CHECK(names_of(hand.session()) == std::vector<std::string>{"First", "Second"});
  emit hand.versions().itemClicked(hand.versions().item(0));
  CHECK(hand.studio().objects().size() == 1);
  CHECK(hand.session().document().find(hand.object())->parameters == first.find(first.nodes().back()->id)->parameters);
}

TEST_CASE("a version stands beside the present model in the same camera, both with their numbers", "[history]") {
  Mug hand;
  hand.set_level(1);
  const std::size_t coarse = hand.studio().objects().front().mesh->face_count();
  hand.save_version("Coarse");
  hand.set_level(3);
  const std::size_t fine = hand.studio().objects().front().mesh->face_count();
  const app::Views& views = hand.viewport().views();
  const auto before = std::pair(views.layout.arrangement(), views.layout.alone());
  const auto title = [&](int view) { return hand.history().use_of(view).title.toStdString(); };
  const auto faces = [](std::size_t count) { return std::to_string(count); };
  hand.act("compare-version");
  REQUIRE(hand.wait_for([&] { return title(app::ComparisonView).find("faces") != std::string::npos; }));
  hand.settle();
  CHECK(views.layout.arrangement() == app::Arrangement::Compare);
  CHECK(views.layout.pane(app::ComparisonView).camera == views.layout.pane(app::PerspectiveView).camera);
  INFO(title(app::ComparisonView) << " / " << title(app::PerspectiveView));
  const auto digits = [](std::string text) {
    std::erase_if(text, [](char c) { return c == ',' || c == ' '; });
    return text;
  };
  CHECK(digits(title(app::ComparisonView)).find(faces(coarse) + "faces") != std::string::npos);
  CHECK(digits(title(app::PerspectiveView)).find(faces(fine) + "faces") != std::string::npos);
  CHECK(title(app::ComparisonView).starts_with("Coarse: "));
  const auto triangles = [&](int view) { return hand.viewport().pictures().state(view).triangles; };
  CHECK(triangles(app::ComparisonView) > 0);
  CHECK(triangles(app::PerspectiveView) > 4 * triangles(app::ComparisonView));
  hand.keep_picture("compare");
  // The present side follows, the other one stays.
  hand.set_level(2);
  REQUIRE(hand.wait_for([&] { return digits(title(app::PerspectiveView)).find(faces(fine)) == std::string::npos; }));
  CHECK(digits(title(app::ComparisonView)).find(faces(coarse) + "faces") != std::string::npos);
  hand.act("compare-version");
  CHECK(std::pair(views.layout.arrangement(), views.layout.alone()) == before);
  CHECK(title(app::PerspectiveView).empty());
}

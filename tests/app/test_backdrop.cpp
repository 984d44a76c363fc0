// SPDX-License-Identifier: GPL-3.0-or-later
#include <QAction>
#include <QDropEvent>
#include <QFile>
#include <QImage>
#include <QMimeData>
#include <QPainter>
#include <QSlider>
#include <QTest>

#include <catch2/catch.hpp>

#include "app/dialogs.h"
#include "app/files/file_reader.h"
#include "app/studio_fixture.h"
#include "app/tools/backdrop/backdrop_tool.h"
#include "croquis/base/error.h"
#include "croquis/document/backdrop.h"
#include "croquis/io/file.h"
#include "croquis/io/picture_trace.h"
#include "croquis/io/png.h"
#include "support/pictures/drawn_picture.h"

namespace croquis::test {
namespace {

using app::BackdropTool;

/// Left half red, right half blue.
QImage photo_of(const QSize& size) {
  QImage image(size, QImage::Format_RGB32);
  image.fill(QColor(190, 20, 20));
  QPainter(&image).fillRect(size.width() / 2, 0, size.width(), size.height(), QColor(20, 20, 190));
  return image;
}

QString saved_photo(StudioFixture& hand, const QString& name, const QSize& size = {400, 200}) {
  const QString path = hand.folder() + "/" + name;
  REQUIRE(photo_of(size).save(path));
  return path;
}

std::shared_ptr<const Backdrop> backdrop_of(StudioFixture& hand) {
  const Node* node = hand.studio().session().document().find(hand.studio().shown_drawing());
  return node == nullptr ? nullptr : node->backdrop;
}

PerspectiveDrawing sheet_drawing(StudioFixture& hand) {
  return *source_of<PerspectiveDrawing>(hand.studio().session().document().find(hand.studio().sheet_node()));
}

/// The colour that the sketch view shows at a place of the plane that is drawn on.
QColor color_at(StudioFixture& hand, const Vec2& place) {
  const QPointF at = app::sketch_to_widget(hand.viewport().views(), place);
  return hand.picture().pixelColor(at.toPoint());
}

bool is_red(const QColor& color) { return color.red() > color.blue() + 60; }
bool is_blue(const QColor& color) { return color.blue() > color.red() + 60; }

/// Drops a file on the window, and answers what is asked with the button of that text; empty: Cancel.
void drop(StudioFixture& hand, const QString& path, const QString& answer = "Backdrop") {
  in_dialog<QMessageBox>([answer](QMessageBox& question) {
    CHECK(question.objectName() == "picture-question");
    QAbstractButton* wanted = question.button(QMessageBox::Cancel);
    for (QAbstractButton* button : question.buttons()) {
      if (button->text().remove('&') == answer) wanted = button;
    }
    wanted->click();
  });
  QMimeData data;
  data.setUrls({QUrl::fromLocalFile(path)});
  const QPointF at = hand.viewport().pane(app::SketchView).rect.center();
  QDragEnterEvent enters(at.toPoint(), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QCoreApplication::sendEvent(&hand.window(), &enters);
  REQUIRE(enters.isAccepted());
  QDropEvent event(at, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QCoreApplication::sendEvent(&hand.window(), &event);
}

/// A sheet with a ring and a dot beside it, on a dark desk.
QString saved_sheet(StudioFixture& hand, const QString& name) {
  PictureLook look;
  look.desk = 40;
  look.noise = 0.01;
  const std::vector<InkLine> lines{ink_circle({450, 350}, 200), ink_line({{700, 300}, {800, 500}})};
  const Picture picture{look.width, look.height, drawn_pixels(lines, look)};
  const QImage image(picture.rgba.data(), picture.width, picture.height, QImage::Format_RGBA8888);
  const QString path = hand.folder() + "/" + name;
  REQUIRE(image.save(path, nullptr, 90));
  return path;
}

std::string refusal_of(std::string bytes) {
  try {
    app::read_picture(std::move(bytes), "photo");
  } catch (const Error& error) {
    return error.findings().front().code;
  }
  return "";
}

}  // namespace

TEST_CASE("a picture opened in an empty studio begins a perspective drawing as large as it, the picture upright",
          "[backdrop]") {
  StudioFixture hand;
  hand.crash_and_restart();  // to the start page
  REQUIRE(hand.window().open(saved_photo(hand, "photo.png")));
  REQUIRE(hand.studio().sheet_node() != 0);
  CHECK(sheet_drawing(hand).image_size == Vec2(400, 200));
  CHECK_FALSE(hand.studio().session().modified());
  REQUIRE(hand.wait_for([&] { return app::settled(hand.viewport().pictures()); }));
  CHECK(is_red(color_at(hand, {100, -100})));
  CHECK(is_blue(color_at(hand, {300, -100})));
  hand.act("show-picture");
  CHECK_FALSE(is_red(color_at(hand, {100, -100})));
  hand.act("undo");
  CHECK(is_red(color_at(hand, {100, -100})));
}

TEST_CASE("a picture dropped on a sketch that has begun lies behind it, and strokes are drawn over it", "[backdrop]") {
  StudioFixture hand;
  hand.window().start_with();
  drop(hand, saved_photo(hand, "photo.jpg"));
  REQUIRE(hand.wait_for([&] { return backdrop_of(hand) != nullptr && app::settled(hand.viewport().pictures()); }));
  CHECK(hand.studio().sheet_node() == 0);
  CHECK(backdrop_of(hand)->centre == Vec2(0, 0));
  CHECK(is_red(color_at(hand, {-200, 100})));
  hand.draw({{-100, -50}, {-100, 50}, {100, 50}, {100, -50}, {-100, -50}});
  hand.settle();
  CHECK(hand.studio().drawing().strokes.size() == 1);
  CHECK(hand.studio().solid() != nullptr);
  hand.act("undo");
  hand.act("undo");
  CHECK(backdrop_of(hand) == nullptr);
}

TEST_CASE("the picture is moved and scaled by hand and by numbers; each is one step that can be undone", "[backdrop]") {
  StudioFixture hand;
  hand.crash_and_restart();  // to the start page
  REQUIRE(hand.window().open(saved_photo(hand, "photo.png")));
  hand.settle();
  hand.act("move-picture");
  hand.drag({200, -100}, {250, -130});
  CHECK((backdrop_of(hand)->centre - Vec2(250, -130)).norm() < 1);
  CHECK(backdrop_of(hand)->scale == 1);
  hand.look_at({-50, -450}, {750, 50});  // so that the corner is seen, and where it goes
  hand.drag({450, -230}, {650, -330});
  CHECK(backdrop_of(hand)->scale == Approx(1.5).margin(0.02));
  CHECK((backdrop_of(hand)->centre - Vec2(350, -180)).norm() < 2);
  hand.act("undo");
  CHECK(backdrop_of(hand)->scale == 1);
  hand.act("fit-picture");
  CHECK(backdrop_of(hand)->centre == Vec2(200, -100));
  auto* opacity = hand.window().findChild<QSlider*>("backdrop-opacity");
  REQUIRE(opacity != nullptr);
  const std::size_t steps = hand.studio().session().undo_labels().size();
  opacity->setSliderDown(true);
  for (const int value : {60, 40, 20}) opacity->setValue(value);
  opacity->setSliderDown(false);
  CHECK(backdrop_of(hand)->opacity == Approx(0.2));
  CHECK(hand.studio().session().undo_labels().size() == steps + 1);
  hand.act("remove-picture");
  CHECK(backdrop_of(hand) == nullptr);
  CHECK_FALSE(hand.window().action("move-picture")->isEnabled());
  CHECK(hand.viewport().views().mode == app::first_mode);
}

TEST_CASE("a changed picture computes nothing again", "[backdrop]") {
  StudioFixture hand;
  hand.window().start_with();
  drop(hand, saved_photo(hand, "photo.png"));
  REQUIRE(hand.wait_for([&] { return backdrop_of(hand) != nullptr; }));
  hand.draw({{-100, -50}, {-100, 50}, {100, 50}, {100, -50}, {-100, -50}});
  hand.settle();
  const auto mesh = hand.studio().solid();
  hand.act("show-picture");
  hand.settle();
  CHECK(hand.studio().solid() == mesh);
}

TEST_CASE("a picture is saved in the project and is there again after a crash", "[backdrop]") {
  StudioFixture hand;
  hand.crash_and_restart();  // to the start page
  const QString photo = saved_photo(hand, "photo.png");
  REQUIRE(hand.window().open(photo));
  const std::string bytes = read_file(photo.toStdString());
  const QString project = hand.folder() + "/traced.croq";
  hand.window().files().save(project);
  QFile::remove(photo);
  hand.act("fit-picture");
  hand.act("show-picture");
  hand.window().files().keeper().save_now();
  hand.crash_and_restart();
  const auto offers = hand.window().files().recoverable();
  REQUIRE(offers.size() == 1);
  hand.window().files().recover(offers.front());
  REQUIRE(backdrop_of(hand) != nullptr);
  CHECK_FALSE(backdrop_of(hand)->visible);
  CHECK(backdrop_of(hand)->picture->bytes == bytes);
  hand.window().set_unattended();
  REQUIRE(hand.window().open(project));
  CHECK(backdrop_of(hand)->visible);
  REQUIRE(hand.wait_for([&] { return app::settled(hand.viewport().pictures()); }));
  app::show_views(hand.window());
  CHECK(is_red(color_at(hand, {100, -100})));
}

TEST_CASE("large pictures and those turned by their file are shown as people see them; broken ones are refused",
          "[backdrop]") {
  StudioFixture hand;
  hand.crash_and_restart();  // to the start page
  const QString large = saved_photo(hand, "large.jpg", {6000, 4000});
  REQUIRE(hand.window().open(large));
  CHECK(sheet_drawing(hand).image_size == Vec2(4096, 2731));
  CHECK(backdrop_of(hand)->picture->width == 6000);
  const QImage shown = app::decoded(*backdrop_of(hand)->picture, 4096);
  CHECK(shown.width() == 4096);
  CHECK(std::abs(shown.height() - 2731) <= 1);

  // A JPEG whose EXIF data says: turn it by 90 degrees clockwise.
  const std::string bytes = read_file(saved_photo(hand, "plain.jpg").toStdString());
  const std::string exif(
      "\xFF\xE1\x00\x22"
      "Exif\0\0"
      "MM\0\x2A\0\0\0\x08"
      "\0\x01"
      "\x01\x12\0\x03\0\0\0\x01\0\x06\0\0"
      "\0\0\0\0",
      36);
  const PictureFile turned = app::read_picture(bytes.substr(0, 2) + exif + bytes.substr(2), "turned.jpg");
  CHECK(turned.width == 200);
  CHECK(turned.height == 400);
  CHECK(is_red(app::decoded(turned, 400).pixelColor(100, 50)));

  QImage deep(30, 20, QImage::Format_RGBA64);
  deep.fill(QColor(10, 200, 10, 128));
  REQUIRE(deep.save(hand.folder() + "/deep.png"));
  const PictureFile shallow = app::read_picture(read_file((hand.folder() + "/deep.png").toStdString()), "deep.png");
  CHECK(app::decoded(shallow, 4096).format() == QImage::Format_RGBA8888);
  CHECK(app::decoded(shallow, 4096).pixelColor(3, 3).alpha() == 128);

  CHECK(refusal_of("") == "E_PICTURE_FILE");
  CHECK(refusal_of("no picture") == "E_PICTURE_FILE");
  CHECK(refusal_of(bytes.substr(0, bytes.size() / 2)) == "E_PICTURE_FILE");
  const std::string png = read_file(saved_photo(hand, "b.png").toStdString());
  CHECK(refusal_of(png.substr(0, png.size() / 2)) == "E_PICTURE_FILE");
  const QString broken = hand.folder() + "/broken.png";
  QFile file(broken);
  REQUIRE(file.open(QIODevice::WriteOnly));
  file.write(png.data(), 100);
  file.close();
  CHECK_FALSE(hand.window().open(broken));
  CHECK(hand.window().last_findings().front().code == "E_PICTURE_FILE");
}

TEST_CASE("a picture that is dropped to be traced becomes strokes and a solid in one step", "[backdrop]") {
  for (const char* name : {"sheet.png", "sheet.jpg"}) {
    StudioFixture hand;
    hand.window().start_with();
    hand.draw({{-500, -50}, {-500, 50}, {-400, 50}, {-400, -50}, {-500, -50}});
    const std::size_t steps = hand.studio().session().undo_labels().size();
    const std::size_t objects = hand.studio().objects().size();
    drop(hand, saved_sheet(hand, name), "Trace lines");
    REQUIRE(hand.wait_for([&] { return hand.studio().objects().size() == objects + 1; }));
    hand.settle();
    REQUIRE(hand.studio().drawing().strokes.size() == 2);
    CHECK(hand.studio().drawing().strokes.front().closed);
    CHECK(backdrop_of(hand) == nullptr);
    CHECK(hand.studio().solid() != nullptr);
    CHECK(hand.studio().session().undo_labels().size() == steps + 1);
    hand.act("undo");
    CHECK(hand.studio().objects().size() == objects);
    CHECK(hand.studio().drawing().strokes.size() == 1);
  }
}

TEST_CASE("a traced picture fills a sketch that was begun; a dropped one that isn't wanted changes nothing",
          "[backdrop]") {
  StudioFixture hand;
  hand.window().start_with();
  drop(hand, saved_sheet(hand, "sheet.png"), "");
  hand.settle();
  CHECK(hand.studio().objects().empty());
  drop(hand, saved_sheet(hand, "sheet.png"), "Trace lines");
  REQUIRE(hand.wait_for([&] { return hand.studio().drawing().strokes.size() == 2; }));
  hand.settle();
  CHECK(hand.studio().objects().size() == 1);
  hand.act("undo");
  CHECK(hand.studio().drawing().strokes.empty());
}

TEST_CASE("a picture without lines isn't traced, and says so", "[backdrop]") {
  StudioFixture hand;
  hand.window().start_with();
  QImage blank(400, 300, QImage::Format_RGB32);
  blank.fill(Qt::white);
  const QString path = hand.folder() + "/blank.png";
  REQUIRE(blank.save(path));
  drop(hand, path, "Trace lines");
  REQUIRE(hand.wait_for([&] { return !hand.window().last_findings().empty(); }));
  CHECK(hand.window().last_findings().front().code == "E_NO_STROKES");
  CHECK(hand.studio().objects().empty());
}

TEST_CASE("photos that their file turns are traced upright", "[backdrop]") {
  StudioFixture hand;
  const QString path = saved_sheet(hand, "sheet.jpg");
  const auto reach = [](const Drawing& drawing) {
    Vec2 low(1e9, 1e9), high(-1e9, -1e9);
    for (const Stroke& stroke : drawing.strokes) {
      for (const StrokeSample& sample : stroke.samples) {
        low = low.cwiseMin(sample.position);
        high = high.cwiseMax(sample.position);
      }
    }
    return Vec2(high - low);
  };
  std::string bytes = read_file(path.toStdString());
  Progress progress;
  const Vec2 upright = reach(app::traced_picture(bytes, "sheet.jpg", progress));
  // Exif data after the first marker: orientation 6, a quarter turn.
  const std::string exif(
      "\xFF\xE1\0\x22"
      "Exif\0\0"
      "MM\0*\0\0\0\x08\0\1\x01\x12\0\3\0\0\0\1\0\6\0\0\0\0\0\0",
      36);
  bytes.insert(2, exif);
  const Vec2 turned = reach(app::traced_picture(bytes, "sheet.jpg", progress));
  CHECK((turned - Vec2(upright.y(), upright.x())).norm() < 4);
}

}  // namespace croquis::test

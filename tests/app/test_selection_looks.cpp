// SPDX-License-Identifier: GPL-3.0-or-later
// What is selected is seen: contrasts as the Web Content Accessibility Guidelines 2.2 reckon them, on the pixels.
#include <QColor>
#include <QImage>
#include <algorithm>
#include <cmath>
#include <vector>

#include <catch2/catch.hpp>

#include "app/hand_on_meshes.h"

using namespace croquis;
using app::Viewport;
using croquis::test::all_views;
using croquis::test::cage;
using croquis::test::open_mesh;
using croquis::test::StudioFixture;

namespace {

constexpr double wanted_contrast = 3;

double linear(double level) { return level <= 0.04045 ? level / 12.92 : std::pow((level + 0.055) / 1.055, 2.4); }

double luminance(const QColor& c) {
  return 0.2126 * linear(c.redF()) + 0.7152 * linear(c.greenF()) + 0.0722 * linear(c.blueF());
}

double contrast(double a, double b) { return (std::max(a, b) + 0.05) / (std::min(a, b) + 0.05); }

double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2), values.end());
  return values[values.size() / 2];
}

Vec3 middle_of(const PolyMesh& mesh, Index face) {
  Vec3 sum = Vec3::Zero();
  for (const Index vertex : mesh.face(face)) sum += mesh.positions[vertex];
  return sum / static_cast<double>(mesh.face(face).size());
}

double luminance_at(const QImage& picture, const QPointF& at) {
  const QPoint pixel = (at * picture.devicePixelRatio()).toPoint();
  return picture.rect().contains(pixel) ? luminance(picture.pixelColor(pixel)) : 0;
}

/// In the middle of a face, well away from its rim.
double luminance_of(StudioFixture& hand, const QImage& picture, Index face, int view) {
  const Vec3 middle = middle_of(cage(hand), face);
  std::vector<double> values;
  for (const Index vertex : cage(hand).face(face)) {
    for (const double share : {0.0, 0.15, 0.3}) {
      const Vec3 place = middle + share * (cage(hand).positions[vertex] - middle);
      values.push_back(luminance_at(picture, app::model_to_widget(hand.viewport().views(), place, view)));
    }
  }
  return median(values);
}

/// Least and greatest luminance in a square of pixels.
std::pair<double, double> range_around(const QImage& picture, const QPointF& at, int reach) {
  std::pair<double, double> range(1, 0);
  for (int dy = -reach; dy <= reach; ++dy) {
    for (int dx = -reach; dx <= reach; ++dx) {
      const double here = luminance_at(picture, at + QPointF(dx, dy));
      range = {std::min(range.first, here), std::max(range.second, here)};
    }
  }
  return range;
}

/// Faces of a ball that look into a view from its middle and from its sides, in light and in shadow.
std::vector<Index> faces_seen(StudioFixture& hand, int view) {
  const ViewFrame frame = app::frame_of(hand.viewport().views(), view);
  std::vector<Index> faces;
  for (Index face = 0; face < cage(hand).face_count(); face += 7) {
    const Vec3 middle = middle_of(cage(hand), face);
    if (cage(hand).face(face).size() == 4 && middle.normalized().dot(frame.to_eye(middle)) > 0.55)
      faces.push_back(face);
  }
  return faces;
}

void show_ball(StudioFixture& hand) {
  open_mesh(hand, test::uv_sphere(20, 12), "ball");
  hand.act("layout");
  hand.settle();
}

}  // namespace

TEST_CASE("a selected face stands out from the faces around it, in light and in shadow", "[selection-looks]") {
  StudioFixture hand;
  show_ball(hand);
  hand.act("face-mode");
  for (const int view : all_views) {
    const QImage before = hand.picture();
    const std::vector<Index> faces = faces_seen(hand, view);
    REQUIRE(faces.size() >= 3);
    for (const Index face : faces) {
      hand.click_model(middle_of(cage(hand), face), view);
      hand.send_mouse(QEvent::MouseMove, QPointF(2, 2), Qt::NoButton, Qt::NoModifier);
      REQUIRE(hand.studio().session().components().elements == Elements{face});
      const QImage picture = hand.picture();
      CAPTURE(view, face, luminance_of(hand, before, face, view), luminance_of(hand, picture, face, view));
      const double plain = luminance_of(hand, before, face, view);
      const double filled = contrast(plain, luminance_of(hand, picture, face, view));
      // Nothing is three times darker than a deep shadow: there the bright rim shows it.
      const Vec3 rim =
          (cage(hand).positions[cage(hand).face(face)[0]] + cage(hand).positions[cage(hand).face(face)[1]]) / 2;
      const auto [darkest, brightest] =
          range_around(picture, app::model_to_widget(hand.viewport().views(), rim, view), 3);
      CHECK(contrast(darkest, brightest) >= wanted_contrast);
      CHECK((plain > 0.15 ? filled : std::max(contrast(plain, darkest), contrast(plain, brightest))) >=
            wanted_contrast);
      for (const Index other : faces) {
        if (other == face) continue;
        CHECK(std::abs(luminance_of(hand, picture, other, view) - luminance_of(hand, before, other, view)) < 0.05);
      }
    }
    hand.act("deselect");
  }
}

TEST_CASE("selected edges and vertices stand out from any surface", "[selection-looks]") {
  StudioFixture hand;
  show_ball(hand);
  for (const int view : all_views) {
    for (const bool edges : {true, false}) {
      hand.act(edges ? "edge-mode" : "vertex-mode");
      hand.act("deselect");
      const QImage before = hand.picture();
      for (const Index face : faces_seen(hand, view)) {
        const Vec3 a = cage(hand).positions[cage(hand).face(face)[0]];
        const Vec3 b = cage(hand).positions[cage(hand).face(face)[1]];
        const Vec3 place = edges ? Vec3((a + b) / 2) : a;
        hand.click_model(place, view);
        hand.send_mouse(QEvent::MouseMove, QPointF(2, 2), Qt::NoButton, Qt::NoModifier);
        REQUIRE(hand.studio().session().components().elements.size() == 1);
        const QImage picture = hand.picture();
        const QPointF at = app::model_to_widget(hand.viewport().views(), place, view);
        const double around = luminance_of(hand, before, face, view);
        const auto [darkest, brightest] = range_around(picture, at, edges ? 4 : 7);
        CAPTURE(view, edges, face, around, darkest, brightest);
        CHECK(std::max(contrast(darkest, around), contrast(brightest, around)) >= wanted_contrast);
        // Its own colour and its border differ, too: it is seen on anything.
        CHECK(contrast(darkest, brightest) >= wanted_contrast);
      }
    }
  }
}

TEST_CASE("a selected object has an outline that is seen against it and the background", "[selection-looks]") {
  StudioFixture hand;
  open_mesh(hand, test::translated(test::uv_sphere(20, 12), {2.2, 2.2, -2.2}), "other");
  open_mesh(hand, test::uv_sphere(20, 12), "ball");
  hand.act("object-mode");
  hand.act("layout");
  hand.settle();
  hand.act("deselect");
  const QImage before = hand.picture();
  hand.studio().session().select({{hand.studio().objects()[1].node, ""}});
  const QImage picture = hand.picture();
  for (const int view : all_views) {
    const ViewFrame frame = app::frame_of(hand.viewport().views(), view);
    const QPointF middle = app::model_to_widget(hand.viewport().views(), Vec3::Zero(), view);
    const double radius = 1 / frame.units_per_pixel(Vec3::Zero());
    int seen = 0, looked_at = 0;
    for (int degrees = 0; degrees < 360; degrees += 10) {
      const double angle = degrees * 3.14159265358979323846 / 180;
      const QPointF out(std::cos(angle), std::sin(angle));
      double darkest = 1, brightest = 0;
      for (double away = -7; away <= 8; away += 0.5) {  // its sides lie up to 3 pixels inside of the sphere
        const double here = luminance_at(picture, middle + (radius + away) * out);
        darkest = std::min(darkest, here);
        brightest = std::max(brightest, here);
      }
      const double inside = luminance_at(before, middle + (radius - 12) * out);
      const double outside = luminance_at(before, middle + (radius + 12) * out);
      const auto stands_out = [&](double from) {
        return std::max(contrast(darkest, from), contrast(brightest, from)) >= wanted_contrast;
      };
      ++looked_at;
      seen += stands_out(inside) && stands_out(outside) ? 1 : 0;
    }
    INFO(view);
    CHECK(seen >= looked_at - 1);  // one place may fall between pixels, where the dark border is a grey one
  }
  const auto is_orange = [](const QColor& c) {
    return c.red() > 225 && c.green() > 90 && c.green() < 165 && c.blue() < 70;
  };
  for (const int view : all_views) {
    const QRectF rect = hand.viewport().pane(view).rect;
    CHECK(test::share_of_pixels(before, rect, is_orange) < 0.0005);
    CHECK(test::share_of_pixels(picture, rect, is_orange) > 0.003);
  }
}

TEST_CASE("the only object has an outline while it is selected, and keeps its colours", "[selection-looks]") {
  StudioFixture hand;
  open_mesh(hand, test::uv_sphere(20, 12), "ball");
  hand.act("object-mode");
  const QImage selected = hand.picture();
  hand.act("deselect");
  const QImage plain = hand.picture();
  const QPointF middle = app::model_to_widget(hand.viewport().views(), Vec3::Zero(), Viewport::PerspectiveView);
  CHECK(std::abs(luminance_at(selected, middle) - luminance_at(plain, middle)) < 0.01);
  CHECK(selected != plain);
}

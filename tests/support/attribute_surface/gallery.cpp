// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/attribute_surface/gallery.h"

#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "support/attribute_surface/gallery_builder.h"

namespace croquis::test {
namespace {

Vec3 mirrored(const Vec3& point) { return {point.x(), -point.y(), point.z()}; }

Vec3 around(double degrees, double radius, double height) {
  const double angle = degrees * std::numbers::pi / 180;
  return {radius * std::cos(angle), radius * std::sin(angle), height};
}

}  // namespace

AttributeNetwork gallery_bonnet() {
  GalleryBuilder builder("bonnet");
  const Vec3 back(0, 0, 0.99), front(1.15, 0, 0.84), nose(1.36, 0, 0.58);
  const Vec3 back_side(0.05, 0.72, 0.93), front_side(1.02, 0.66, 0.8), nose_side(1.2, 0.64, 0.56);
  builder.smooth("crown", {back, {0.4, 0, 1}, {0.85, 0, 0.96}, front});
  builder.smooth("nose", {front, {1.3, 0, 0.78}, {1.36, 0, 0.7}, nose});
  for (const bool left : {true, false}) {
    const std::string side = left ? " left" : " right";
    const auto at = [&](const Vec3& point) { return left ? point : mirrored(point); };
    builder.crease("window" + side, {back, at({-0.01, 0.25, 0.99}), at({0, 0.5, 0.97}), at(back_side)});
    builder.crease("wing" + side, {at(back_side), at({0.4, 0.73, 0.95}), at({0.8, 0.71, 0.9}), at(front_side)});
    builder.smooth("front" + side, {front, at({1.15, 0.22, 0.84}), at({1.11, 0.45, 0.825}), at(front_side)});
    builder.crease("lamp" + side, {at(front_side), at({1.14, 0.64, 0.745}), at({1.2, 0.64, 0.66}), at(nose_side)});
    builder.crease("bumper" + side, {nose, at({1.36, 0.22, 0.58}), at({1.3, 0.45, 0.57}), at(nose_side)});
  }
  builder.face("hood left", {"+crown", "+front left", "-wing left", "-window left"});
  builder.face("hood right", {"+window right", "+wing right", "-front right", "-crown"});
  builder.face("nose left", {"+nose", "+bumper left", "-lamp left", "-front left"});
  builder.face("nose right", {"+front right", "+lamp right", "-bumper right", "-nose"});
  builder.inner("bulge", "hood right",
                {{0.2, -0.36, 1.01}, {0.45, -0.36, 1.05}, {0.75, -0.34, 1.02}, {0.95, -0.32, 0.9}},
                {no_index, InnerProfile::Smooth, 0.09});
  builder.point("dent", "hood left", {0.62, 0.33, 0.85}, 0.13);
  return builder.take();
}

AttributeNetwork gallery_bowl() {
  GalleryBuilder builder("bowl");
  constexpr int petals = 5;
  std::vector<std::string> foot;
  for (int k = 0; k < petals; ++k) {
    const std::string n = std::to_string(k + 1);
    const double a = 72.0 * k, b = a + 72;
    const Vec3 low = around(a, 0.055, 0), low_next = around(b, 0.055, 0);
    const Vec3 high = around(a, 0.14, 0.075), high_next = around(b, 0.14, 0.075);
    builder.smooth("foot " + n, {low, around(a + 24, 0.062, 0), around(a + 48, 0.062, 0), low_next});
    builder.smooth("rib " + n, {low, around(a, 0.09, 0), around(a, 0.128, 0.035), high});
    builder.crease("rim " + n, {high, around(a + 14, 0.2, 0.105), around(a + 58, 0.2, 0.105), high_next});
    foot.push_back("+foot " + n);
  }
  builder.face("foot", foot);
  for (int k = 0; k < petals; ++k) {
    const std::string n = std::to_string(k + 1), next = std::to_string((k + 1) % petals + 1);
    builder.face("petal " + n, {"-foot " + n, "+rib " + n, "+rim " + n, "-rib " + next});
  }
  builder.point("knob", "foot", {0, 0, 0.024}, 0.017);
  return builder.take();
}

AttributeNetwork gallery_chair() {
  GalleryBuilder builder("chair");
  const Vec3 front(0.21, -0.22, 0.43), hip(0.255, 0.17, 0.5), top(0.19, 0.31, 0.82);
  const Vec3 along_hip(0, 0.075, 0.085);
  builder.crease("front edge", {{-0.21, -0.22, 0.43}, {-0.1, -0.275, 0.425}, {0.1, -0.275, 0.425}, front});
  builder.smooth("hips", {Vec3(-0.255, 0.17, 0.5), {-0.2, 0.2, 0.415}, {0.2, 0.2, 0.415}, hip});
  builder.crease("top edge", {Vec3(-0.19, 0.31, 0.82), {-0.13, 0.34, 0.9}, {0.13, 0.34, 0.9}, top});
  for (const double side : {-1.0, 1.0}) {
    const std::string name = side < 0 ? " left" : " right";
    const auto at = [&](const Vec3& point) { return Vec3(side * point.x(), point.y(), point.z()); };
    builder.crease("seat" + name, {at(front), at({0.24, -0.12, 0.44}), at(hip - along_hip), at(hip)});
    builder.crease("back" + name, {at(hip), at(hip + along_hip), at({0.23, 0.27, 0.7}), at(top)});
  }
  builder.face("seat", {"+front edge", "+seat right", "-hips", "-seat left"});
  builder.face("back", {"+hips", "+back right", "-top edge", "-back left"});
  builder.point("hollow", "seat", {0, -0.03, 0.405}, 0.11);
  builder.point("spine", "back", {0, 0.27, 0.66}, 0.16);
  return builder.take();
}

AttributeNetwork gallery_dinghy() {
  GalleryBuilder builder("dinghy");
  const Vec3 stem(3, 0, 0.75), heel(0, 0, 0.05), corner(-0.12, 0.55, 0.55), shoulder(2.05, 0.56, 0.6);
  builder.smooth("keel", {heel, {0.9, 0, -0.1}, {2.75, 0, -0.12}, stem});
  builder.crease("coaming", {shoulder, {2.05, 0.25, 0.74}, {2.05, -0.25, 0.74}, mirrored(shoulder)});
  builder.crease("transom top", {corner, {-0.14, 0.2, 0.6}, {-0.14, -0.2, 0.6}, mirrored(corner)});
  for (const bool left : {true, false}) {
    const std::string side = left ? " left" : " right";
    const auto at = [&](const Vec3& point) { return left ? point : mirrored(point); };
    builder.crease("bow rail" + side, {stem, at({2.78, 0.14, 0.69}), at({2.4, 0.43, 0.63}), at(shoulder)});
    builder.crease("rail" + side, {at(shoulder), at({1.4, 0.8, 0.54}), at({0.6, 0.74, 0.5}), at(corner)});
    builder.crease("transom" + side, {heel, at({-0.01, 0.2, 0.06}), at({-0.09, 0.55, 0.25}), at(corner)});
  }
  builder.face("hull left", {"-keel", "+transom left", "-rail left", "-bow rail left"});
  builder.face("hull right", {"+keel", "+bow rail right", "+rail right", "-transom right"});
  builder.face("transom", {"+transom right", "-transom top", "-transom left"});
  builder.face("foredeck", {"+bow rail left", "+coaming", "-bow rail right"});
  for (const auto& [x, half, bulge] : {std::array{0.75, 0.6, 0.04}, std::array{1.05, 0.61, 0.04}}) {
    const std::string name = x < 1 ? "bench back" : "bench front";
    builder.crease(name, {{x, half, 0.4}, {x, half / 3, 0.4 + bulge}, {x, -half / 3, 0.4 + bulge}, {x, -half, 0.4}});
  }
  builder.crease("bench end left", {{1.05, 0.61, 0.4}, {0.75, 0.6, 0.4}});
  builder.crease("bench end right", {{0.75, -0.6, 0.4}, {1.05, -0.61, 0.4}});
  builder.face("bench", {"+bench back", "+bench end right", "-bench front", "+bench end left"});
  return builder.take();
}

AttributeNetwork gallery_sail() {
  GalleryBuilder builder("sail");
  const Vec3 tack(0, 0, 1), head(0.15, 0, 6), clew(2.6, 0.5, 1.15);
  builder.crease("luff", {head, {0.05, 0.05, 4.5}, {-0.05, 0.05, 2.5}, tack});
  builder.crease("foot", {tack, {0.8, 0.45, 0.95}, {1.8, 0.6, 1}, clew});
  builder.crease("leech", {clew, {2.5, 0.55, 2.8}, {1.5, 0.45, 4.8}, head});
  builder.face("sail", {"+luff", "+foot", "+leech"});
  builder.point("belly", "sail", {0.95, 0.62, 2.7}, 1.7);
  return builder.take();
}

std::vector<AttributeNetwork> gallery_networks() {
  return {gallery_bonnet(), gallery_bowl(), gallery_chair(), gallery_dinghy(), gallery_kettle(), gallery_sail()};
}

}  // namespace croquis::test

// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "support/attribute_surface/gallery.h"
#include "support/attribute_surface/gallery_builder.h"

namespace croquis::test {
namespace {

/// Distance from the axis, and height.
using Profile = std::vector<Vec2>;

const Profile& lower_profile() {
  static const Profile profile{{0.08, 0}, {0.1, 0.002}, {0.115, 0.03}, {0.115, 0.065}};
  return profile;
}

const Profile& upper_profile() {
  static const Profile profile{{0.115, 0.065}, {0.115, 0.105}, {0.1, 0.145}, {0.06, 0.15}};
  return profile;
}

Vec3 turned(double degrees, const Vec2& place) {
  const double angle = degrees * std::numbers::pi / 180;
  return {place.x() * std::cos(angle), place.x() * std::sin(angle), place.y()};
}

std::vector<Vec3> turned(double degrees, const Profile& profile) {
  std::vector<Vec3> control;
  for (const Vec2& place : profile) control.push_back(turned(degrees, place));
  return control;
}

/// An arc of a horizontal circle around the axis.
std::vector<Vec3> arc(double from, double to, const Vec2& place) {
  const double handle = 4.0 / 3 * std::tan((to - from) * std::numbers::pi / 180 / 4) * place.x();
  const Vec3 start = turned(from, place), end = turned(to, place);
  return {start, start + handle * turned(from + 90, {1, 0}), end - handle * turned(to + 90, {1, 0}), end};
}

/// The part of a cubic between two parameters.
Profile part_of(const Profile& profile, double from, double to) {
  const auto blossom = [&](double a, double b, double c) -> Vec2 {
    Profile places = profile;
    for (const double t : {a, b, c}) {
      for (std::size_t i = 0; i + 1 < places.size(); ++i) places[i] = ((1 - t) * places[i] + t * places[i + 1]).eval();
      places.pop_back();
    }
    return places.front();
  };
  return {blossom(from, from, from), blossom(from, from, to), blossom(from, to, to), blossom(to, to, to)};
}

/// Rings and meridians: the quarter in front has two halves.
void add_body_curves(GalleryBuilder& builder) {
  const std::vector<std::vector<double>> quarters{{45, 135}, {135, 225}, {225, 315}, {315, 360}, {360, 405}};
  for (std::size_t k = 0; k < quarters.size(); ++k) {
    const double from = quarters[k][0], to = quarters[k][1];
    const std::string n = std::to_string(k + 1);
    builder.crease("foot " + n, arc(from, to, lower_profile().front()));
    builder.smooth("belly " + n, arc(from, to, lower_profile().back()));
    builder.crease("neck " + n, arc(from, to, upper_profile().back()));
    builder.smooth("wall " + n, turned(from, lower_profile()));
    if (k != 4) builder.smooth("shoulder " + n, turned(from, upper_profile()));
  }
  builder.smooth("below spout", turned(0, part_of(upper_profile(), 0, 0.18)));
  builder.smooth("above spout", turned(0, part_of(upper_profile(), 0.62, 1)));
}

void add_body_faces(GalleryBuilder& builder) {
  for (int k = 1; k <= 5; ++k) {
    const std::string n = std::to_string(k), next = std::to_string(k % 5 + 1);
    builder.face("wall " + n, {"+foot " + n, "+wall " + next, "-belly " + n, "-wall " + n});
    if (k < 4) builder.face("shoulder " + n, {"+belly " + n, "+shoulder " + next, "-neck " + n, "-shoulder " + n});
  }
  builder.face("beside spout 4", {"+belly 4", "+below spout", "+root right", "+above spout", "-neck 4", "-shoulder 4"});
  builder.face("beside spout 5", {"+belly 5", "+shoulder 1", "-neck 5", "-above spout", "-root left", "-below spout"});
}

void add_spout(GalleryBuilder& builder) {
  const Vec3 low = turned(0, part_of(upper_profile(), 0, 0.18).back());
  const Vec3 high = turned(0, part_of(upper_profile(), 0.62, 1).front());
  const Vec3 tip_low(0.205, 0, 0.15), tip_high(0.198, 0, 0.168);
  for (const double side : {-1.0, 1.0}) {
    const std::string name = side < 0 ? " right" : " left";
    const Vec3 out(0.012, side * 0.034, 0), out_high(0.016, side * 0.03, 0), tip(0, side * 0.012, 0);
    builder.crease("root" + name, {low, low + out, high + out_high, high});
    builder.crease("tip" + name, {tip_low, tip_low + tip, tip_high + tip, tip_high});
  }
  builder.smooth("spout below", {low, low + Vec3(0.045, 0, 0.004), tip_low + Vec3(-0.018, 0, -0.035), tip_low});
  builder.smooth("spout above", {high, high + Vec3(0.035, 0, -0.008), tip_high + Vec3(-0.022, 0, -0.03), tip_high});
  builder.face("spout right", {"-root right", "+spout below", "+tip right", "-spout above"});
  builder.face("spout left", {"+root left", "+spout above", "-tip left", "-spout below"});
}

void add_lid_and_handle(GalleryBuilder& builder) {
  builder.face("lid", {"+neck 1", "+neck 2", "+neck 3", "+neck 4", "+neck 5"});
  builder.point("knob", "lid", {0, 0, 0.182}, 0.016);
  builder.face("bottom", {"-foot 5", "-foot 4", "-foot 3", "-foot 2", "-foot 1"});
  for (const double side : {-1.0, 1.0}) {
    const double y = 0.011 * side;
    builder.crease(side < 0 ? "handle right" : "handle left",
                   {{-0.085, y, 0.14}, {-0.13, y, 0.31}, {0.1, y, 0.31}, {0.075, y, 0.146}});
  }
  builder.crease("handle back", {{-0.085, 0.011, 0.14}, {-0.087, 0, 0.143}, {-0.085, -0.011, 0.14}});
  builder.crease("handle front", {{0.075, -0.011, 0.146}, {0.077, 0, 0.149}, {0.075, 0.011, 0.146}});
  builder.face("handle", {"+handle right", "+handle front", "-handle left", "+handle back"});
}

}  // namespace

AttributeNetwork gallery_kettle() {
  GalleryBuilder builder("kettle");
  add_body_curves(builder);
  add_spout(builder);
  add_body_faces(builder);
  add_lid_and_handle(builder);
  return builder.take();
}

}  // namespace croquis::test

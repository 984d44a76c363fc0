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

/// Where the body's upper part is divided: below, beside and above the spout.
constexpr double below = 0.18, beside = 0.45, above = 0.62;
/// Half the angle over which the spout begins.
constexpr double root_angle = 18;

/// Rings and meridians: the quarter in front has two halves, and its meridians have a node beside the spout.
void add_body_curves(GalleryBuilder& builder) {
  const std::vector<std::vector<double>> quarters{{45, 135}, {135, 225}, {225, 315}, {315, 360}, {360, 405}};
  for (std::size_t k = 0; k < quarters.size(); ++k) {
    const double from = quarters[k][0], to = quarters[k][1];
    const std::string n = std::to_string(k + 1);
    builder.crease("foot " + n, arc(from, to, lower_profile().front()));
    builder.smooth("belly " + n, arc(from, to, lower_profile().back()));
    builder.crease("neck " + n, arc(from, to, upper_profile().back()));
    builder.smooth("wall " + n, turned(from, lower_profile()));
    if (k == 1 || k == 2) builder.smooth("shoulder " + n, turned(from, upper_profile()));
    if (k == 0 || k == 3) {
      builder.smooth("low shoulder " + n, turned(from, part_of(upper_profile(), 0, beside)));
      builder.smooth("high shoulder " + n, turned(from, part_of(upper_profile(), beside, 1)));
    }
  }
  const Vec2 waist = part_of(upper_profile(), 0, beside).back();
  builder.smooth("waist left", arc(root_angle, 45, waist));
  builder.smooth("waist right", arc(315, 360 - root_angle, waist));
  builder.smooth("below spout", turned(0, part_of(upper_profile(), 0, below)));
  builder.smooth("above spout", turned(0, part_of(upper_profile(), above, 1)));
}

void add_body_faces(GalleryBuilder& builder) {
  for (int k = 1; k <= 5; ++k) {
    const std::string n = std::to_string(k), next = std::to_string(k % 5 + 1);
    builder.face("wall " + n, {"+foot " + n, "+wall " + next, "-belly " + n, "-wall " + n});
  }
  builder.face("shoulder 1", {"+belly 1", "+shoulder 2", "-neck 1", "-high shoulder 1", "-low shoulder 1"});
  builder.face("shoulder 2", {"+belly 2", "+shoulder 3", "-neck 2", "-shoulder 2"});
  builder.face("shoulder 3", {"+belly 3", "+low shoulder 4", "+high shoulder 4", "-neck 3", "-shoulder 3"});
  builder.face("below spout right", {"+belly 4", "+below spout", "+low root right", "-waist right", "-low shoulder 4"});
  builder.face("above spout right",
               {"+waist right", "+high root right", "+above spout", "-neck 4", "-high shoulder 4"});
  builder.face("below spout left", {"+belly 5", "+low shoulder 1", "-waist left", "-low root left", "-below spout"});
  builder.face("above spout left", {"+waist left", "+high shoulder 1", "-neck 5", "-above spout", "-high root left"});
}

/// A tube of four strips from its root in the body to its tip.
void add_spout(GalleryBuilder& builder) {
  const Vec3 low = turned(0, part_of(upper_profile(), 0, below).back());
  const Vec3 high = turned(0, part_of(upper_profile(), above, 1).front());
  const Vec3 tip_low(0.205, 0, 0.15), tip_high(0.196, 0, 0.172);
  builder.smooth("spout below", {low, low + Vec3(0.04, 0, 0), tip_low + Vec3(-0.022, 0, -0.04), tip_low});
  builder.smooth("spout above", {high, high + Vec3(0.04, 0, 0), tip_high + Vec3(-0.02, 0, -0.03), tip_high});
  for (const double side : {-1.0, 1.0}) {
    const std::string name = side < 0 ? " right" : " left";
    const Vec3 root = turned(side < 0 ? 360 - root_angle : root_angle, part_of(upper_profile(), 0, beside).back());
    const Vec3 out(0, side, 0), tip = 0.5 * (tip_low + tip_high) + 0.011 * out;
    const Vec3 up_root = (high - low) / 4, up_tip = (tip_high - tip_low) / 4;
    builder.crease("low root" + name, {low, low + 0.018 * out, root - up_root, root});
    builder.crease("high root" + name, {root, root + up_root, high + 0.018 * out, high});
    builder.crease("low tip" + name, {tip_low, tip_low + 0.006 * out, tip - up_tip, tip});
    builder.crease("high tip" + name, {tip, tip + up_tip, tip_high + 0.006 * out, tip_high});
    builder.smooth("spout" + name, {root, root + Vec3(0.035, -0.012 * side, 0), tip + Vec3(-0.02, 0, -0.035), tip});
  }
  builder.face("spout low right", {"+spout below", "+low tip right", "-spout right", "-low root right"});
  builder.face("spout high right", {"+spout right", "+high tip right", "-spout above", "-high root right"});
  builder.face("spout low left", {"+low root left", "+spout left", "-low tip left", "-spout below"});
  builder.face("spout high left", {"+high root left", "+spout above", "-high tip left", "-spout left"});
}

void add_lid_and_handle(GalleryBuilder& builder) {
  builder.face("lid", {"+neck 1", "+neck 2", "+neck 3", "+neck 4", "+neck 5"});
  builder.point("knob", "lid", {0, 0, 0.182}, 0.016);
  builder.face("bottom", {"-foot 5", "-foot 4", "-foot 3", "-foot 2", "-foot 1"});
  const auto across = [](const Vec3& left) { return std::vector<Vec3>{left, left - Vec3(0, 2 * left.y(), 0)}; };
  const Vec3 back(-0.085, 0.012, 0.14), top(0, 0.012, 0.275), front(0.078, 0.012, 0.146);
  builder.crease("handle back", across(back));
  builder.smooth("handle top", across(top));
  builder.crease("handle front", across(front));
  for (const double side : {-1.0, 1.0}) {
    const std::string name = side < 0 ? " right" : " left";
    const auto at = [&](const Vec3& point) { return Vec3(point.x(), side * point.y(), point.z()); };
    builder.crease("handle back" + name, {at(back), at({-0.11, 0.012, 0.22}), at({-0.06, 0.012, 0.275}), at(top)});
    builder.crease("handle front" + name, {at(top), at({0.055, 0.012, 0.275}), at({0.1, 0.012, 0.22}), at(front)});
  }
  builder.face("handle back", {"+handle back", "+handle back right", "-handle top", "-handle back left"});
  builder.face("handle front", {"+handle top", "+handle front right", "-handle front", "-handle front left"});
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

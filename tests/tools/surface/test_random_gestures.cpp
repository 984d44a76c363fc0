// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include <catch2/catch.hpp>

#include "support/attribute_surface/gallery.h"
#include "tools/surface/surface_hand.h"

namespace croquis {
namespace {

using test::SurfaceHand;

/// The hand before a network that fills most of its view.
void open(SurfaceHand& hand, AttributeNetwork network) {
  const auto box = *bounds_of(network);
  const Vec3 middle = (box[0] + box[1]) / 2;
  const double size = (box[1] - box[0]).norm();
  hand.camera.up = Vec3::UnitZ();
  hand.camera.target = middle;
  hand.camera.eye = middle + size * Vec3(-1, -1.4, 0.8);
  hand.camera.near = 0.01 * size;
  hand.camera.far = 10 * size;
  hand.session.load(add_network(Document(), std::move(network), {}));
  hand.tool.settings().ground = {Vec3::Zero(), Vec3::UnitZ()};
  hand.look();
}

Vec2 any_pixel(SurfaceHand& hand) { return {hand.random.between(150, 650), hand.random.between(100, 500)}; }

/// A place of the network that people aim at, as it is seen.
Vec2 aimed_pixel(SurfaceHand& hand) {
  const AttributeNetwork& network = hand.network();
  const auto below = [&](std::size_t count) { return hand.random.below(static_cast<std::uint32_t>(count)); };
  const std::uint32_t kind = hand.random.below(3);
  if (kind == 0 && !network.nodes.empty()) return hand.pixel(network.nodes[below(network.nodes.size())].point);
  if (kind == 1 && !network.curves.empty())
    return hand.pixel(traced_curve(network, below(network.curves.size())).at(1));
  if (!network.points.empty()) return hand.pixel(network.points[below(network.points.size())].point);
  return any_pixel(hand);
}

void any_gesture(SurfaceHand& hand) {
  constexpr SurfaceMode modes[] = {SurfaceMode::Draw, SurfaceMode::Select, SurfaceMode::Select, SurfaceMode::Patch,
                                   SurfaceMode::Point};
  hand.tool.set_mode(modes[hand.random.below(5)]);
  hand.held.shift = hand.random.below(4) == 0;
  hand.held.ctrl = hand.random.below(5) == 0;
  const Vec2 from = hand.random.below(2) == 0 ? any_pixel(hand) : aimed_pixel(hand);
  const Vec2 to = hand.random.below(2) == 0 ? any_pixel(hand) : aimed_pixel(hand);
  hand.tool.hover(from, hand.camera.frame());
  const std::uint32_t what = hand.random.below(8);
  if (what < 3) hand.click(from);
  if (what == 3) hand.tool.take(other_join(hand.network(), hand.tool.selected().curves));
  if (what == 4 && hand.random.below(3) == 0) hand.tool.take(recorded::SurfaceDelete{hand.tool.selected()});
  if (what >= 5)
    hand.tool.mode() == SurfaceMode::Draw ? hand.stroke({from, (from + to) / 2 + Vec2(20, 15), to})
                                          : hand.drag(from, to);
}

/// Valid, and with faces whose sides meet in nodes.
void check_sound(const AttributeNetwork& network) {
  for (const Finding& finding : validate(network)) FAIL(finding.message);
  for (const AttributeFace& face : network.faces) {
    for (std::size_t i = 0; i < face.loop.size(); ++i)
      REQUIRE(end_node(network, face.loop[i]) == start_node(network, face.loop[(i + 1) % face.loop.size()]));
  }
}

TEST_CASE("whatever a hand does to the networks of the gallery, they stay sound and all of it can be undone") {
  std::size_t steps = 0;
  for (const AttributeNetwork& network : test::gallery_networks()) {
    SurfaceHand hand;
    open(hand, network);
    hand.random = test::Random(network.nodes.size());
    const std::string before = hand.text();
    if (hand.random.below(2) == 0)
      hand.tool.take(recorded::SurfaceSymmetry{SymmetryPlane{Vec3::Zero(), Vec3::UnitY()}});
    for (int gesture = 0; gesture < 50; ++gesture) {
      INFO(network.name << ", gesture " << gesture);
      any_gesture(hand);
      CHECK_FALSE(hand.tool.active());
      REQUIRE(hand.tool.network());
      check_sound(hand.network());
      hand.look();
    }
    steps += hand.session.undo_labels().size();
    while (hand.session.can_undo()) hand.session.undo();
    CHECK(hand.text() == before);
  }
  CHECK(steps > 60);
}

}  // namespace
}  // namespace croquis

// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <set>

#include <catch2/catch.hpp>

#include "attribute_surface/network_samples.h"
#include "croquis/attribute_surface/loop_search.h"
#include "support/random.h"

namespace croquis {
namespace {

using test::bent_sheet;
using test::Random;

std::set<std::string> names_of(const AttributeNetwork& network, const std::vector<AttributeSide>& sides) {
  std::set<std::string> names;
  for (const AttributeSide& side : sides) names.insert(network.curves[side.curve].id);
  return names;
}

/// A regular polygon of straight curves whose corners are moved by at most `apart`, each curve with nodes of its own.
AttributeNetwork loose_polygon(std::size_t sides, double apart, Random& random) {
  AttributeNetwork network;
  const auto corner = [&](std::size_t i) {
    const double angle = 2 * 3.14159265358979 * static_cast<double>(i) / static_cast<double>(sides);
    const Vec3 shift(random.between(-1, 1), random.between(-1, 1), random.between(-1, 1));
    return Vec3(Vec3(std::cos(angle), std::sin(angle), 0) + apart * shift / 2);
  };
  for (std::size_t i = 0; i < sides; ++i) {
    std::vector<Vec3> control = {corner(i), corner(i + 1)};
    if (random.below(2) == 0) std::ranges::reverse(control);
    network = add_curve(network, {{}, {}, control, {}, false}).network;
  }
  return network;
}

TEST_CASE("curves in any order and direction become one loop, gaps within the tolerance are closed") {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    Random random(seed);
    const std::size_t sides = 2 + random.below(11);
    if (sides == 2) continue;  // two straight curves enclose nothing
    const AttributeNetwork network = loose_polygon(sides, 0.01, random);
    std::vector<Index> order;
    for (Index i = 0; i < sides; ++i) order.insert(order.begin() + random.below(i + 1), i);
    INFO("seed " << seed << ", " << sides << " sides");
    const SortedLoop loop = sort_loop(network, order, 0.02);
    REQUIRE(loop.closed());
    CHECK(loop.findings.empty());
    CHECK(loop.sides.size() == sides);
    CHECK(loop.sides.front() == AttributeSide{order.front(), false});
    CHECK(loop.snaps.size() == sides);
    for (const LoopGap& gap : loop.snaps) CHECK(gap.distance <= 0.02);
    const AddedElement closed = close_loop(network, loop);
    CHECK(validate(closed.network).empty());
    CHECK(closed.network.nodes.size() == sides);
    const auto& made = closed.network.faces.front().loop;
    for (std::size_t i = 0; i < sides; ++i)
      CHECK(end_node(closed.network, made[i]) == start_node(closed.network, made[(i + 1) % sides]));
  }
}

TEST_CASE("what is no loop is refused with the gap and both curves") {
  Random random(3);
  const AttributeNetwork network = loose_polygon(5, 0.01, random);
  const SortedLoop gaps = sort_loop(network, {0, 1, 2, 3, 4}, 1e-6);
  CHECK_FALSE(gaps.closed());
  CHECK(gaps.findings.size() == 5);
  for (const Finding& finding : gaps.findings) {
    CHECK(finding.code == "E_OPEN_LOOP");
    CHECK(finding.subjects.size() == 2);
  }
  const SortedLoop open = sort_loop(network, {0, 1, 2, 3}, 0.02);
  REQUIRE(open.findings.size() == 1);
  CHECK(open.findings[0].code == "E_OPEN_LOOP");
  CHECK(std::set<std::string>{open.findings[0].subjects[0].id, open.findings[0].subjects[1].id} ==
        std::set<std::string>{network.curves[0].id, network.curves[3].id});
  CHECK(sort_loop(network, {0, 0, 1}, 0.02).findings[0].code == "E_DUP_CURVE");
  CHECK(sort_loop(network, {0}, 0.02).findings[0].code == "E_TOO_FEW");
  const AttributeNetwork sheet = bent_sheet(2, 1);
  std::vector<Index> all;
  for (Index i = 0; i < sheet.curves.size(); ++i) all.push_back(i);
  CHECK(sort_loop(sheet, all, 0).findings[0].code == "E_OPEN_LOOP");  // three curves meet
}

TEST_CASE("a loop beside a face runs against it along their common curve") {
  AttributeNetwork sheet = bent_sheet(2, 1);
  const AttributeFace second = sheet.faces[1];
  sheet.faces.pop_back();
  std::vector<Index> curves;
  for (const AttributeSide& side : second.loop) curves.push_back(side.curve);
  for (int turn = 0; turn < 4; ++turn) {
    std::ranges::rotate(curves, curves.begin() + 1);
    const SortedLoop loop = sort_loop(sheet, curves, 0);
    for (const AttributeSide& side : second.loop) CHECK(std::ranges::find(loop.sides, side) != loop.sides.end());
  }
}

// ---- Pointing into loops

/// Seen from above: x to the right, y up, as pixels with y down.
std::vector<ViewedCurve> from_above(const AttributeNetwork& network) {
  std::vector<ViewedCurve> views;
  for (Index i = 0; i < network.curves.size(); ++i) {
    ViewedCurve view;
    for (const Vec3& place : traced_curve(network, i)) {
      view.places.emplace_back(100 * place.x(), -100 * place.y());
      view.depths.push_back(-place.z());
    }
    if (view.places.size() == 2) {  // straight ones have more places in views, too
      view.places.insert(view.places.begin() + 1, (view.places[0] + view.places[1]) / 2);
      view.depths.insert(view.depths.begin() + 1, (view.depths[0] + view.depths[1]) / 2);
    }
    views.push_back(view);
  }
  return views;
}

TEST_CASE("a click in a cell of a sheet finds its four curves, counter-clockwise, whether it is a face or not") {
  AttributeNetwork sheet = bent_sheet(4, 3);
  const std::vector<AttributeFace> faces = std::exchange(sheet.faces, {});
  Random random(5);
  for (const bool filled : {false, true}) {
    if (filled) sheet.faces = faces;
    for (std::size_t cell = 0; cell < faces.size(); ++cell) {
      const Vec2 place(100 * (static_cast<double>(cell % 4) + random.between(0.2, 0.8)),
                       -100 * (static_cast<double>(cell / 4) + random.between(0.2, 0.8)));
      const auto found = find_loop_around(sheet, from_above(sheet), place);
      INFO("cell " << cell << (filled ? " filled" : ""));
      REQUIRE(found);
      CHECK(found->face.has_value() == filled);
      CHECK(names_of(sheet, found->loop.sides) == names_of(sheet, faces[cell].loop));
      if (filled) continue;
      for (const AttributeSide& side : faces[cell].loop)
        CHECK(std::ranges::find(found->loop.sides, side) != found->loop.sides.end());
    }
  }
  CHECK_FALSE(find_loop_around(sheet, from_above(sheet), {-50, -50}));
  CHECK_FALSE(find_loop_around(sheet, from_above(sheet), {1000, -50}));
}

TEST_CASE("a loop in front is found before one behind it, and that one when the first is a face") {
  AttributeNetwork box = test::wire_box();
  // In perspective from above: what is lower is smaller.
  std::vector<ViewedCurve> views = from_above(box);
  for (ViewedCurve& view : views) {
    for (std::size_t i = 0; i < view.places.size(); ++i)
      view.places[i] = Vec2(50, -50) + (view.places[i] - Vec2(50, -50)) / (2 + view.depths[i]);
  }
  const auto front = find_loop_around(box, views, {52, -47});
  REQUIRE(front);
  CHECK(names_of(box, front->loop.sides) == std::set<std::string>{"x01", "x11", "y10", "y11"});
  box = close_loop(box, front->loop).network;
  const auto behind = find_loop_around(box, views, {52, -47});
  REQUIRE(behind);
  CHECK_FALSE(behind->face);
  CHECK(names_of(box, behind->loop.sides) == std::set<std::string>{"x00", "x10", "y00", "y01"});
}

TEST_CASE("curves that only cross in the view join nothing") {
  AttributeNetwork network;
  const auto line = [&](Vec3 from, Vec3 to) { network = add_curve(network, {{}, {}, {from, to}, {}, false}).network; };
  line({0, 0, 0}, {1, 0, 0});
  line({1, 0, 0}, {1, 1, 0});
  line({1, 1, 0}, {0, 0, 0});
  line({-1, 0.2, 1}, {2, 0.2, 1});  // passes above
  line({0.7, -1, 2}, {0.7, 2, 2});
  const auto found = find_loop_around(network, from_above(network), {80, -10});
  REQUIRE(found);
  CHECK(found->loop.sides.size() == 3);
}

TEST_CASE("ends that meet only within the tolerance make loops, too, wherever the click is") {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    Random random(seed);
    const std::size_t sides = 3 + random.below(10);
    const AttributeNetwork network = loose_polygon(sides, 0.02, random);
    const Vec2 place(random.between(-30, 30), random.between(-30, 30));
    INFO("seed " << seed);
    const auto found = find_loop_around(network, from_above(network), place, {0.05, 12});
    REQUIRE(found);
    CHECK(found->loop.sides.size() == sides);
    CHECK_FALSE(find_loop_around(network, from_above(network), place, {1e-6, 12}));
    if (sides > 4) CHECK_FALSE(find_loop_around(network, from_above(network), place, {0.05, 4}));
  }
}

using test::wire_box;

TEST_CASE("loops without a face are offered one by one until all have theirs") {
  AttributeNetwork network = wire_box();
  std::set<std::set<Index>> filled;
  for (int face = 0; face < 6; ++face) {
    INFO("face " << face);
    const SortedLoop loop = open_loop(network);
    REQUIRE(loop.closed());
    CHECK(loop.sides.size() == 4);  // the fewest curves, so a side of the box and no way round it
    std::set<Index> curves;
    for (const AttributeSide& side : loop.sides) curves.insert(side.curve);
    CHECK(filled.insert(curves).second);
    network = close_loop(std::move(network), loop).network;
  }
  CHECK_FALSE(open_loop(network).closed());
}

TEST_CASE("no loop is offered that is a face, is open, or goes through the inside of one") {
  AttributeNetwork sheet = bent_sheet(2, 2);
  CHECK_FALSE(open_loop(sheet).closed());
  CHECK_FALSE(open_loop(AttributeNetwork()).closed());
  AttributeNetwork box = wire_box();
  LoopSearchOptions options;
  options.most_sides = 3;
  CHECK_FALSE(open_loop(box, options).closed());
  box.curves.resize(3);
  CHECK_FALSE(open_loop(box).closed());
  sheet.faces.erase(sheet.faces.begin());
  const SortedLoop loop = open_loop(sheet);
  REQUIRE(loop.closed());
  CHECK(close_loop(sheet, loop).network.faces.size() == 4);
}

}  // namespace
}  // namespace croquis

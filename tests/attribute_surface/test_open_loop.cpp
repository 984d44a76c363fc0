// SPDX-License-Identifier: GPL-3.0-or-later
#include <set>

#include <catch2/catch.hpp>

#include "attribute_surface/network_samples.h"
#include "croquis/attribute_surface/open_loop.h"

namespace croquis {
namespace {

using test::bent_sheet;
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

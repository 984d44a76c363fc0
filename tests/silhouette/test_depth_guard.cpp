// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <limits>
#include <map>

#include <catch2/catch.hpp>

#include "algorithms/silhouette/skeleton/rest_depths.h"
#include "croquis/base/error.h"
#include "silhouette/solids.h"
#include "support/sample_count.h"
#include "support/sketches/sketch_gallery.h"
#include "support/sketches/sketch_scrawls.h"

using namespace croquis;
using namespace croquis::silhouette;

namespace {

/// Objects of given radii, one node each, with what lies over what.
struct Pile {
  LabelledFigure figure;
  Skeleton skeleton;

  Pile(const std::vector<double>& radii, const std::vector<std::array<Index, 2>>& over) {
    figure.objects.resize(radii.size());
    for (Index o = 0; o < radii.size(); ++o) {
      SkeletonNode node;
      node.object = o;
      node.radius = radii[o];
      skeleton.nodes.push_back(node);
    }
    for (const auto& [upper, lower] : over) figure.overlaps.push_back({Vec2::Zero(), upper, lower, {}});
  }

  double depth() const { return explained_depth(figure, skeleton, 0.5); }
};

/// Each figure by itself is no deeper than twice what its drawing explains.
void check_depths(const LabelledDrawing& labelled, const Solid& solid, const Options& options) {
  const std::map<std::string, test::PartDepth> depths = test::depths_by_name(solid);
  for (const LabelledFigure& figure : labelled.figures) {
    const Skeleton axis = test::skeleton_of(figure, options.depth.node_spacing);
    test::PartDepth all{"", std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    for (const FigureObject& object : figure.objects) {
      if (!depths.contains(object.name)) continue;
      all.low = std::min(all.low, depths.at(object.name).low);
      all.high = std::max(all.high, depths.at(object.name).high);
    }
    CHECK(all.depth() <= 2 * explained_depth(figure, axis, options.depth.minimum_gap * axis.scale));
  }
}

bool refused_depth(const Findings& findings) {
  return std::any_of(findings.begin(), findings.end(),
                     [](const Finding& finding) { return finding.code == "E_NOT_SOLVED"; });
}

struct Tally {
  int labelled = 0;
  int refused = 0;  ///< with an object whose depth was refused
};

void try_scrawl(const test::ScrawledDrawing& scrawl, Tally& tally) {
  const Options options = Options::of(scrawl.shaky ? Preset::Tablet : Preset::Clean);
  Progress progress;
  LabelledDrawing labelled;
  Solid solid;
  try {
    labelled = label(scrawl.drawing, options, progress);
    ++tally.labelled;
    solid = inflate(labelled, scrawl.drawing, options, progress);
  } catch (const Error& error) {
    CHECK(!error.findings().empty());
    if (refused_depth(error.findings())) ++tally.refused;
    return;
  }
  if (refused_depth(solid.findings)) ++tally.refused;
  check_depths(labelled, solid, options);
  test::check_sound(solid.mesh);
}

}  // namespace

TEST_CASE("the depth that a drawing explains is that of its longest chain") {
  CHECK(Pile({3}, {}).depth() == 6.5);
  CHECK(Pile({3, 4}, {}).depth() == 8.5);                  // side by side
  CHECK(Pile({3, 4}, {{0, 1}}).depth() == 15);             // one over the other
  CHECK(Pile({3, 4}, {{0, 1}, {0, 1}}).depth() == 15);     // at two places: still one over the other
  CHECK(Pile({3, 4, 5}, {{0, 1}, {0, 2}}).depth() == 17);  // over the thicker of two
  CHECK(Pile({3, 4, 5}, {{2, 1}, {1, 0}, {2, 0}}).depth() == 25.5);
  CHECK(Pile({3, 4, 5}, {{0, 1}, {1, 2}, {2, 0}}).depth() == 25.5);  // each over the next
  CHECK(Pile({3, 4, 5, 6}, {{0, 1}, {1, 0}, {1, 2}, {3, 0}}).depth() == 38);
  CHECK(Pile({3}, {{0, 0}, {0, 0}}).depth() == 19.5);  // twice over itself
  std::vector<std::array<Index, 2>> tower;
  for (Index o = 0; o < 50000; ++o) tower.push_back({o, o + 1});
  CHECK(Pile(std::vector<double>(50001, 1), tower).depth() == 50001 * 2.5);
}

TEST_CASE("what reaches farthest is refused until the rest is as deep as may be") {
  using Refused = std::vector<Index>;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  CHECK(objects_too_deep({}, 5).empty());
  CHECK(objects_too_deep({{0, -2, 3}}, 5).empty());
  CHECK(objects_too_deep({{0, -2, 3}}, 4.9) == Refused{0});
  CHECK(objects_too_deep({{0, -2, 2}, {1, 90, 95}, {2, -3, 1}}, 6) == Refused{1});
  CHECK(objects_too_deep({{0, -2, 2}, {1, 90, 95}, {2, -30, 1}}, 6) == Refused{1, 2});
  CHECK(objects_too_deep({{4, -infinity, infinity}, {7, -1, 1}}, 6) == Refused{4});
  CHECK(objects_too_deep({{4, -1, 1}, {7, -1, 1}}, -1) == Refused{4, 7});
}

TEST_CASE("an object deeper than its drawing explains is refused by name, and the others stay") {
  test::FigureFixture fixture = test::crossed_capsules_figure();
  const Index upper = fixture.figure.objects[0].name == "front" ? 0 : 1;
  fixture.figure.overlaps = {{Vec2::Zero(), upper, 1 - upper, {}}};
  Options options;
  const Solid all = test::solid_of(fixture, options);
  REQUIRE(all.objects.size() == 2);
  const auto depths = test::depths_by_name(all);
  const double one = std::max(depths.at("front").depth(), depths.at("back").depth());
  const double both = test::depth_of(all.mesh);
  REQUIRE(one < 0.9 * both);
  const Skeleton axis = test::skeleton_of(fixture.figure, options.depth.node_spacing);
  const double explained = explained_depth(fixture.figure, axis, options.depth.minimum_gap * axis.scale);
  CHECK(both <= explained);
  options.depth.depth_allowance = (one + both) / 2 / explained;  // room for either, not for both
  const Solid solid = test::solid_of(fixture, options);
  REQUIRE(solid.objects.size() == 1);
  REQUIRE(solid.findings.size() == 1);
  const Finding& finding = solid.findings[0];
  CHECK(finding.code == "E_NOT_SOLVED");
  const std::string other = solid.objects[0].name == "front" ? "\"back\"" : "\"front\"";
  CHECK(finding.message.find(other) != std::string::npos);
  REQUIRE(!finding.subjects.empty());
  CHECK(finding.subjects[0].kind == SubjectKind::Stroke);
}

TEST_CASE("heights that aren't exact enough are refused, also of a draft") {
  const test::FigureFixture fixture = test::crossed_capsules_figure();
  for (const Quality quality : {Quality::Final, Quality::Draft}) {
    Options options;
    options.quality = quality;
    options.depth.accuracy = 1e-300;  // no sum of doubles is that exact
    try {
      test::solid_of(fixture, options);
      FAIL("it became a solid");
    } catch (const Error& error) {
      REQUIRE(error.findings().size() == 2);
      for (const Finding& finding : error.findings()) CHECK(finding.code == "E_NOT_SOLVED");
      CHECK(error.findings()[0].message.find("\"front\"") != std::string::npos);
      CHECK(error.findings()[1].message.find("\"back\"") != std::string::npos);
    }
  }
}

TEST_CASE("whatever is scrawled, no solid is deeper than its drawing explains, and hardly any is refused for it") {
  for (const test::Scrawl family : test::scrawl_families()) {
    Tally tally;
    const int count = test::sample_count(4, 80);
    for (int seed = 0; seed < count; ++seed) {
      INFO(test::to_string(family) << " " << seed);
      try_scrawl(test::random_scrawl(family, static_cast<std::uint64_t>(seed)), tally);
    }
    INFO(test::to_string(family));
    CHECK(50 * tally.refused <= tally.labelled);
  }
}

TEST_CASE("shipped and generated sketches are as deep as they explain, whatever the weights") {
  for (const test::NamedSketch& named :
       test::sketches_with_random_ones(static_cast<std::uint64_t>(test::sample_count(1, 40)))) {
    for (const auto& [curvature, orientation, distance] :
         {std::array{1.0, 1e-3, 1e-3}, {1e-3, 1.0, 1e-3}, {1e-3, 1e-3, 1.0}}) {
      INFO(named.name << " " << curvature << " " << orientation << " " << distance);
      Options options;
      options.quality = Quality::Draft;
      options.depth.weight_curvature = curvature;
      options.depth.weight_orientation = orientation;
      options.depth.weight_distance = distance;
      Progress progress;
      const LabelledDrawing labelled = label(named.sketch.drawing, options, progress);
      const Solid solid = inflate(labelled, named.sketch.drawing, options, progress);
      CHECK(!refused_depth(solid.findings));
      check_depths(labelled, solid, options);
    }
  }
}

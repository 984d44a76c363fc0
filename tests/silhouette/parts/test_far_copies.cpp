// SPDX-License-Identifier: GPL-3.0-or-later
// Second ones of parts, on the far side of what they belong to.
#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <catch2/catch.hpp>

#include "croquis/silhouette/attachment.h"
#include "croquis/silhouette/stroke_data.h"
#include "silhouette/labelled_counts.h"
#include "silhouette/solids.h"
#include "silhouette/surface_quality.h"
#include "support/sample_count.h"
#include "support/sketches/characters/character.h"
#include "support/sketches/sketch_generator.h"

using namespace croquis;
using namespace croquis::silhouette;
using test::check_sound, test::report_of;

namespace {

Drawing with_copies(Drawing drawing, const std::set<std::string>& strokes) {
  for (Stroke& stroke : drawing.strokes) {
    if (strokes.contains(stroke.id)) stroke.data[copy_key] = copy_far;
  }
  return drawing;
}

Solid held_solid(const Drawing& drawing) {
  Options options;
  options.attach_suggested = true;
  return test::solid_of(drawing, options);
}

/// Parts that lie before exactly one other part and look joined to it, by the strokes that name them.
std::set<std::string> near_limbs(const Drawing& drawing) {
  std::map<std::string, int> ties;
  std::set<std::string> upper;
  for (const LabelledFigure& figure : test::label_quietly(drawing).figures) {
    for (const AttachSuggestion& pair : attach_suggestions(figure)) {
      for (const Index object : {pair.a, pair.b}) ++ties[figure.objects[object].name];
      const auto overlap = std::ranges::find_if(figure.overlaps, [&](const FigureOverlap& each) {
        return std::minmax(each.upper, each.lower) == std::minmax(pair.a, pair.b);
      });
      if (pair.hold == Hold::Joined) upper.insert(figure.objects[overlap->upper].name);
    }
  }
  std::erase_if(upper, [&](const std::string& name) { return ties[name] != 1; });
  return upper;
}

/// What lies at one place of the drawing on an object and its copy: two heights of each.
struct Symmetry {
  int places = 0;    ///< with four heights
  int mirrored = 0;  ///< of these, whose outer and inner heights have one common middle
};

Symmetry symmetry_of(const Solid& solid, const std::string& object) {
  const PolyMesh part = test::part_named(solid, object);
  std::map<std::pair<double, double>, std::vector<double>> heights;
  for (const Vec3& position : part.positions) heights[{position.x(), position.y()}].push_back(position.z());
  std::vector<std::pair<double, double>> sums;
  for (auto& [place, z] : heights) {
    std::ranges::sort(z);
    if (z.size() == 4) sums.emplace_back(z[0] + z[3], z[1] + z[2]);
  }
  if (sums.empty()) return {};
  std::ranges::nth_element(sums, sums.begin() + static_cast<std::ptrdiff_t>(sums.size() / 2));
  const double twice_middle = sums[sums.size() / 2].first;
  const double rounding = 1e-9 * test::depth_of(solid.mesh);
  const auto is_mirrored = [&](const auto& sum) {
    return std::abs(sum.first - twice_middle) < rounding && std::abs(sum.second - twice_middle) < rounding;
  };
  return {static_cast<int>(sums.size()), static_cast<int>(std::ranges::count_if(sums, is_mirrored))};
}

}  // namespace

TEST_CASE("limbs of characters have mirrored ones on the far side, and all is one sound surface") {
  const auto every = static_cast<std::size_t>(test::sample_count(4, 1));
  std::size_t copied = 0, refused = 0, characters = 0;
  for (const test::Character& character : test::animal_characters()) {
    const Drawing drawing = test::character_sketch(character).drawing;
    const std::set<std::string> limbs = near_limbs(drawing);
    if (limbs.empty() || ++characters % every != 0) continue;
    INFO(character.name << ", " << limbs.size() << " limbs");
    const Solid without = held_solid(drawing);
    const Solid solid = held_solid(with_copies(drawing, limbs));
    check_sound(solid.mesh);
    check_sound(test::rounded_to_float(solid.mesh));
    CHECK(solid.diagnostics.silhouette_iou >= without.diagnostics.silhouette_iou - 0.002);
    CHECK(solid.objects.size() == without.objects.size());
    CHECK(solid.shells.size() == without.shells.size());
    std::set<std::string> joined;
    for (const SolidAttachment& pair : solid.attached) {
      if (pair.hold == Hold::Joined) joined.insert({pair.a, pair.b});
    }
    std::set<std::string> left_out;
    for (const Finding& finding : solid.findings) {
      if (finding.code == "W_FAR_COPY") left_out.insert(finding.subjects.front().id);
    }
    refused += left_out.size();
    for (const std::string& limb : limbs) {
      if (!joined.contains(limb) || left_out.contains(limb)) continue;
      INFO(limb);
      const Symmetry symmetry = symmetry_of(solid, limb);
      CHECK(symmetry.places >= 20);
      CHECK(symmetry.mirrored >= 0.9 * symmetry.places);
      CHECK(symmetry_of(without, limb).places == 0);
      ++copied;
    }
  }
  CHECK(copied >= 3);
  CHECK(refused <= copied / 8);
}

TEST_CASE("a copy hangs on the body through copies, and turns and grows with the drawing") {
  const std::vector<test::CharacterPart> parts{
      {"body", test::ellipse({0, 0}, 200, 110), {}},
      {"leg", test::limb_outline({{40, -60}, {60, -160}, {50, -230}}, {34, 30, 26}), {}},
      {"foot", test::ellipse({75, -245}, 50, 26), {}}};
  const Drawing drawing = test::character_sketch({"table", parts}).drawing;
  const Solid upright = held_solid(with_copies(drawing, {"leg", "foot"}));
  check_sound(upright.mesh);
  CHECK(report_of(upright.mesh).components == 1);
  CHECK(report_of(upright.mesh).euler_characteristic == 2);
  for (const char* part : {"leg", "foot"}) CHECK(symmetry_of(upright, part).places > 20);
  // The foot alone belongs to the leg: its copy lies on the leg's far side, not the body's.
  const Solid shod = held_solid(with_copies(drawing, {"foot"}));
  check_sound(shod.mesh);
  CHECK(test::depth_of(shod.mesh) < test::depth_of(upright.mesh));
  for (const double scale : {0.01, 100.0}) {
    Drawing other = with_copies(drawing, {"leg", "foot"});
    for (Stroke& stroke : other.strokes)
      for (StrokeSample& sample : stroke.samples) sample.position *= scale;
    const Solid same = held_solid(other);
    check_sound(same.mesh);
    CHECK(report_of(same.mesh).volume.value() ==
          Approx(report_of(upright.mesh).volume.value() * std::pow(scale, 3)).epsilon(1e-3));
  }
}

TEST_CASE("what rests on a part has a copy that rests on its far side") {
  const std::vector<test::CharacterPart> parts{{"head", test::ellipse({0, 0}, 120, 100), {}},
                                               {"eye", test::ellipse({40, 20}, 18, 18), {}}};
  const Drawing drawing = test::character_sketch({"face", parts}).drawing;
  const Solid one = held_solid(drawing);
  const Solid two = held_solid(with_copies(drawing, {"eye"}));
  check_sound(two.mesh);
  CHECK(report_of(two.mesh).components == report_of(one.mesh).components + 1);
  const auto depths = test::depths_by_name(two);
  CHECK(depths.at("eye").low < depths.at("head").middle() - 60);
  CHECK(depths.at("eye").high > depths.at("head").middle() + 60);
}

TEST_CASE("a copy of what belongs to nothing is left out, and named") {
  const Drawing drawing = test::character_sketch({"ball", {{"ball", test::ellipse({0, 0}, 100, 100), {}}}}).drawing;
  const Solid plain = held_solid(drawing);
  const Solid solid = held_solid(with_copies(drawing, {"ball"}));
  CHECK(solid.mesh.positions == plain.mesh.positions);
  REQUIRE(solid.findings.size() == 1);
  CHECK(solid.findings.front().code == "W_FAR_COPY");
  CHECK(solid.findings.front().subjects.front().id == "ball");
  CHECK(solid.findings.front().message.find("\"ball\"") != std::string::npos);
}

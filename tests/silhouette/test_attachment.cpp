// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Geometry>
#include <catch2/catch.hpp>

#include "croquis/base/error.h"
#include "croquis/silhouette/attachment.h"
#include "silhouette/labelled_counts.h"
#include "silhouette/solids.h"
#include "silhouette/surface_quality.h"
#include "support/random.h"
#include "support/sample_count.h"
#include "support/sketches/characters/character.h"
#include "support/sketches/sketch_generator.h"

using namespace croquis;
using namespace croquis::silhouette;
using test::check_sound, test::depth_of, test::report_of, test::slender_share, test::solid_of;

namespace {

/// All pairs that look like limb and body.
std::vector<AttachedPair> suggested(const Drawing& drawing, double kappa = AttachedPair{}.kappa) {
  std::vector<AttachedPair> pairs;
  for (const LabelledFigure& figure : test::label_quietly(drawing).figures) {
    for (const AttachSuggestion& suggestion : attach_suggestions(figure)) {
      pairs.push_back({figure.objects[suggestion.a].name, figure.objects[suggestion.b].name, kappa});
    }
  }
  return pairs;
}

Solid attached(const Drawing& drawing, double kappa = AttachedPair{}.kappa) {
  Options options;
  options.attach = suggested(drawing, kappa);
  return solid_of(drawing, options);
}

/// The object whose face a ray from the viewer meets first, and the height there.
struct Seen {
  std::string object;
  double height = -1e300;
};

Seen seen_at(const Solid& solid, const Vec2& place) {
  const AttributeChannel& channel = *solid.mesh.channel("object", Domain::Face);
  const auto& objects = std::get<std::vector<std::int32_t>>(channel.data);
  Seen seen;
  for (std::size_t f = 0; f < solid.mesh.face_count(); ++f) {
    const auto face = solid.mesh.face(f);
    const Vec3& a = solid.mesh.positions[face[0]];
    const Vec3& b = solid.mesh.positions[face[1]];
    const Vec3& c = solid.mesh.positions[face[2]];
    const double area = cross(b.head<2>() - a.head<2>(), c.head<2>() - a.head<2>());
    const double u = cross(b.head<2>() - place, c.head<2>() - place);
    const double v = cross(c.head<2>() - place, a.head<2>() - place);
    const double w = cross(a.head<2>() - place, b.head<2>() - place);
    if (area <= 0 || u < 0 || v < 0 || w < 0) continue;
    const double height = (u * a.z() + v * b.z() + w * c.z()) / area;
    if (height > seen.height) seen = {channel.labels[static_cast<std::size_t>(objects[f])], height};
  }
  return seen;
}

Vec3 normal_of(const PolyMesh& mesh, std::size_t face) {
  const auto c = mesh.face(face);
  const Vec3 a = mesh.positions[c[0]];
  return (mesh.positions[c[1]] - a).cross(mesh.positions[c[2]] - a).normalized();
}

/// Degrees by which the surface turns at the edges between faces of two objects, the most.
double sharpest_seam(const PolyMesh& mesh) {
  const auto& objects = std::get<std::vector<std::int32_t>>(mesh.channel("object", Domain::Face)->data);
  std::map<std::pair<Index, Index>, std::size_t> first;
  double sharpest = 0;
  for (std::size_t f = 0; f < mesh.face_count(); ++f) {
    const auto corners = mesh.face(f);
    for (std::size_t k = 0; k < 3; ++k) {
      const auto [other, fresh] = first.try_emplace(std::minmax(corners[k], corners[(k + 1) % 3]), f);
      if (fresh || objects[other->second] == objects[f]) continue;
      const double cosine = std::clamp(normal_of(mesh, f).dot(normal_of(mesh, other->second)), -1.0, 1.0);
      sharpest = std::max(sharpest, std::acos(cosine) * 180 / std::numbers::pi);
    }
  }
  return sharpest;
}

std::vector<test::NamedSketch> animals() {
  return {{"dog", test::dog_sketch()},
          {"duck", test::duck_sketch()},
          {"octopus", test::octopus_sketch()},
          {"limb before a blob", test::limb_on_blob_sketch(true)},
          {"limb behind a blob", test::limb_on_blob_sketch(false)}};
}

std::set<std::string> codes(const Findings& findings) {
  std::set<std::string> found;
  for (const Finding& finding : findings) found.insert(finding.code);
  return found;
}

Findings refused(const Drawing& drawing, const std::vector<AttachedPair>& pairs) {
  Options options;
  options.attach = pairs;
  try {
    solid_of(drawing, options);
  } catch (const Error& error) {
    return error.findings();
  }
  return {};
}

}  // namespace

TEST_CASE("attached animals are one sound surface that shows what was drawn") {
  for (const test::NamedSketch& animal : animals()) {
    INFO(animal.name);
    const Solid solid = attached(animal.sketch.drawing);
    CHECK(solid.findings.empty());
    check_sound(solid.mesh);
    check_sound(test::rounded_to_float(solid.mesh));
    check_sound(test::rounded_to_grid(solid.mesh, 1e-5 * test::diagonal(animal.sketch.drawing)));
    REQUIRE(solid.shells.size() == 1);
    CHECK(solid.shells.front().objects.size() == static_cast<std::size_t>(animal.sketch.truth.components));
    CHECK(solid.shells.front().euler_mesh == 2);
    const MeshReport figures = report_of(solid.mesh);
    CHECK(figures.euler_characteristic == 2);
    CHECK(figures.components == 1);
    CHECK(solid.diagnostics.silhouette_iou >= 0.98);
    CHECK(solid.attached.size() + 1 == static_cast<std::size_t>(animal.sketch.truth.components));
  }
}

TEST_CASE("attached animals are flatter than those whose limbs keep the gap") {
  const Drawing dog = test::dog_sketch().drawing;
  CHECK(depth_of(attached(dog).mesh) < 0.75 * depth_of(solid_of(dog).mesh));
  for (const test::Sketch& sketch : {test::limb_on_blob_sketch(true), test::limb_on_blob_sketch(false)}) {
    CHECK(depth_of(attached(sketch.drawing).mesh) < 0.95 * depth_of(solid_of(sketch.drawing).mesh));
  }
}

TEST_CASE("what was drawn in front is seen in front, also where it sinks in") {
  for (const test::NamedSketch& animal : animals()) {
    INFO(animal.name);
    const Solid apart = solid_of(animal.sketch.drawing, {});
    const Solid joined = attached(animal.sketch.drawing);
    const auto bounds = *report_of(apart.mesh).bounds;
    test::Random random(11);
    int compared = 0;
    for (int k = 0; k < 60; ++k) {
      const Vec2 place(random.between(bounds[0].x(), bounds[1].x()), random.between(bounds[0].y(), bounds[1].y()));
      const Seen wanted = seen_at(apart, place);
      if (wanted.object.empty()) continue;
      CHECK(seen_at(joined, place).object == wanted.object);
      ++compared;
    }
    CHECK(compared > 10);
  }
}

TEST_CASE("limbs join whatever depth they are asked to sink to") {
  for (const double kappa : {0.0, 1.0}) {
    for (const test::NamedSketch& animal : animals()) {
      if (animal.name == "octopus") continue;
      INFO(animal.name << " " << kappa);
      const Solid solid = attached(animal.sketch.drawing, kappa);
      CHECK(solid.findings.empty());
      check_sound(solid.mesh);
      CHECK(report_of(solid.mesh).components == 1);
    }
  }
}

TEST_CASE("larger kappa never brings a limb nearer to the body's middle") {
  const test::Sketch sketch = test::limb_on_blob_sketch(true);
  double last = 0;
  for (const double kappa : {0.0, 0.5, 0.7, 0.9}) {
    const double depth = depth_of(attached(sketch.drawing, kappa).mesh);
    CHECK(depth >= last - 1e-6);
    last = depth;
  }
}

TEST_CASE("what looks attached is held as suggested unless the pair is named") {
  const Drawing duck = test::duck_sketch().drawing;
  Options options;
  options.attach_suggested = true;
  const Solid all = solid_of(duck, options);
  std::map<Hold, std::size_t> wanted;
  for (const LabelledFigure& figure : test::label_quietly(duck).figures) {
    for (const AttachSuggestion& suggestion : attach_suggestions(figure)) ++wanted[suggestion.hold];
  }
  std::map<Hold, std::size_t> held;
  for (const SolidAttachment& attachment : all.attached) {
    ++held[attachment.hold];
    CHECK(attachment.at != Vec2::Zero());
    if (attachment.hold == Hold::Joined) CHECK(attachment.blend > 0);
  }
  CHECK(held == wanted);

  const SolidAttachment first = all.attached.front();
  options.attach = {{first.a, first.b, 0.55, Hold::Apart}};
  const Solid rest = solid_of(duck, options);
  CHECK(rest.findings.empty());
  CHECK(rest.attached.size() + 1 == all.attached.size());
  for (const SolidAttachment& attachment : rest.attached) {
    CHECK(std::pair(attachment.a, attachment.b) != std::pair(first.a, first.b));
  }
  options.attach.push_back({first.b, first.a, 0.3, Hold::Joined, 0.5});
  const Solid again = solid_of(duck, options);
  REQUIRE(again.attached.size() == all.attached.size());
  CHECK(again.attached.front().kappa == 0.3);
  CHECK(again.attached.front().blend == 0.5);
  options.attach.back().hold = Hold::Resting;
  CHECK(solid_of(duck, options).attached.front().hold == Hold::Resting);
}

TEST_CASE("a blended seam is smooth, and what was drawn stays") {
  for (const bool in_front : {true, false}) {
    INFO(in_front);
    const Drawing drawing = test::limb_on_blob_sketch(in_front).drawing;
    Options options;
    options.attach = suggested(drawing);
    const Solid sharp = solid_of(drawing, options);
    for (AttachedPair& pair : options.attach) pair.blend = 0.5;
    const Solid blended = solid_of(drawing, options);
    CHECK(blended.findings.empty());
    REQUIRE(blended.attached.size() == 1);
    CHECK(blended.attached.front().blend == 0.5);
    check_sound(blended.mesh);
    check_sound(test::rounded_to_grid(blended.mesh, 1e-5 * test::diagonal(drawing)));
    CHECK(report_of(blended.mesh).euler_characteristic == 2);
    CHECK(blended.diagnostics.silhouette_iou >= 0.99);
    CHECK(sharpest_seam(sharp.mesh) > 90);
    CHECK(sharpest_seam(blended.mesh) < 25);
    CHECK(slender_share(blended.mesh) < 0.01);
    // Far from the seam nothing moved.
    const auto before = *report_of(sharp.mesh).bounds;
    const auto after = *report_of(blended.mesh).bounds;
    CHECK((after[0].head<2>() - before[0].head<2>()).norm() < 1e-9);
    CHECK((after[1].head<2>() - before[1].head<2>()).norm() < 1e-9);
  }
}

TEST_CASE("of a hundred triangles of a joined solid hardly one is slender, beside sharp and rounded seams") {
  for (const test::NamedSketch& animal : animals()) {
    INFO(animal.name);
    CHECK(slender_share(attached(animal.sketch.drawing).mesh) <= 0.01);
  }
  Options options = Options::of(Preset::Clean);
  options.strokes.crossings = Crossings::Front;
  options.attach_suggested = true;
  const std::vector<test::Character> characters = test::all_characters();
  const auto step = characters.size() / static_cast<std::size_t>(test::sample_count(8, 50));
  double sum = 0;
  std::size_t solids = 0;
  for (std::size_t k = step / 2; k < characters.size(); k += step) {
    INFO(characters[k].name);
    const Solid solid = solid_of(test::character_sketch(characters[k]).drawing, options);
    check_sound(solid.mesh);
    const double share = slender_share(solid.mesh);
    CHECK(share <= 0.02);
    sum += share;
    ++solids;
  }
  CHECK(sum <= 0.01 * static_cast<double>(solids));
}

TEST_CASE("attached solids turn and grow with their drawing") {
  const test::Sketch dog = test::dog_sketch();
  const double depth = depth_of(attached(dog.drawing).mesh);
  CHECK(depth_of(attached(test::scaled(dog, 7).drawing).mesh) == Approx(7 * depth).epsilon(1e-4));
  const Solid turned = attached(test::rotated(dog, 1).drawing);
  CHECK(depth_of(turned.mesh) == Approx(depth).epsilon(0.02));
  CHECK(report_of(turned.mesh).euler_characteristic == 2);
  check_sound(turned.mesh);
}

TEST_CASE("objects of figures without attachments stay the same to the last bit") {
  const test::Sketch dog = test::dog_sketch();
  Drawing both = test::linked_rings_sketch().drawing;
  std::set<std::string> rings;
  for (Stroke& stroke : both.strokes) rings.insert(stroke.id = "ring " + stroke.id);
  for (Stroke stroke : test::translated(dog, {2000, 0}).drawing.strokes) both.strokes.push_back(std::move(stroke));
  const Solid without = solid_of(both, {});
  const Solid with = attached(both);
  REQUIRE(with.shells.size() == 3);
  for (int ring = 0; ring < 2; ++ring) {
    REQUIRE(rings.contains(with.objects[static_cast<std::size_t>(ring)].name));
    CHECK(test::part_of(with.mesh, ring).positions == test::part_of(without.mesh, ring).positions);
    CHECK(test::part_of(with.mesh, ring).corners == test::part_of(without.mesh, ring).corners);
  }
}

TEST_CASE("unattached objects of the same figure keep their gap") {
  Options options;
  options.attach = suggested(test::dog_sketch().drawing);
  options.attach.resize(3);
  const Solid solid = solid_of(test::dog_sketch().drawing, options);
  CHECK(solid.findings.empty());
  check_sound(solid.mesh);
  CHECK(solid.shells.size() == static_cast<std::size_t>(test::dog_sketch().truth.components) - 3);
  CHECK(solid.diagnostics.minimum_gap >= 0.1 * solid.diagnostics.scale - 1e-6);
}

TEST_CASE("a chain of attached objects is one shell whose faces know their object") {
  const auto disk = [](double x, int priority) {
    return test::LayeredPart{test::circle_outline({x, 0}, 100), priority};
  };
  const test::Sketch sketch = test::layered_sketch({disk(0, 0), disk(150, 1), disk(300, 0)});
  const Solid solid = attached(sketch.drawing);
  CHECK(solid.attached.size() == 2);
  REQUIRE(solid.shells.size() == 1);
  check_sound(solid.mesh);
  const AttributeChannel& channel = *solid.mesh.channel("object", Domain::Face);
  CHECK(channel.labels.size() == 3);
  std::map<std::string, std::pair<double, double>> reach;
  const auto& objects = std::get<std::vector<std::int32_t>>(channel.data);
  REQUIRE(objects.size() == solid.mesh.face_count());
  for (std::size_t f = 0; f < objects.size(); ++f) {
    auto& [low, high] =
        reach.try_emplace(channel.labels[static_cast<std::size_t>(objects[f])], 1e300, -1e300).first->second;
    for (const Index v : solid.mesh.face(f)) {
      low = std::min(low, solid.mesh.positions[v].x());
      high = std::max(high, solid.mesh.positions[v].x());
    }
  }
  REQUIRE(reach.size() == 3);
  for (const auto& [name, range] : reach) CHECK(range.second - range.first <= 201);
}

TEST_CASE("of bodies with random limbs nearly every limb is joined") {
  std::size_t pairs = 0;
  std::size_t joined = 0;
  for (int seed = 0; seed < test::sample_count(4, 40); ++seed) {
    INFO(seed);
    const test::Sketch sketch = test::random_figure_sketch(static_cast<std::uint64_t>(seed));
    const Solid solid = attached(sketch.drawing);
    check_sound(solid.mesh);
    pairs += suggested(sketch.drawing).size();
    joined += solid.attached.size();
    for (const Finding& finding : solid.findings) CHECK(finding.code == "W_ATTACH");
    // Every pair is either joined or named.
    CHECK(solid.findings.size() + solid.attached.size() == suggested(sketch.drawing).size());
  }
  CHECK(static_cast<double>(joined) >= 0.85 * static_cast<double>(pairs));
}

TEST_CASE("random layered shapes attached all round become sound solids") {
  for (int number = 1; number <= test::sample_count(4, 60); ++number) {
    INFO(number);
    const test::Sketch sketch = test::random_layered_sketch(static_cast<std::uint64_t>(number), 2 + number % 5);
    const Solid solid = attached(sketch.drawing);
    check_sound(solid.mesh);
    CHECK(solid.diagnostics.silhouette_iou >= 0.97);
    for (const Finding& finding : solid.findings) CHECK(finding.severity == Severity::Warning);
  }
}

TEST_CASE("pairs that can't be attached are refused by name") {
  const Drawing drawing = test::dog_sketch().drawing;
  const AttachedPair good = suggested(drawing).front();
  CHECK(refused(drawing, {good}).empty());
  for (const AttachedPair& wrong :
       {AttachedPair{"nobody", good.b}, AttachedPair{good.a, good.a}, AttachedPair{good.a, good.b, 1.5},
        AttachedPair{good.a, good.b, 0.5, Hold::Joined, 2}, AttachedPair{good.a, good.b, std::nan("")}}) {
    const Findings findings = refused(drawing, {good, wrong});
    REQUIRE(findings.size() == 1);
    CHECK(findings.front().code == "E_ATTACH");
    CHECK(findings.front().message.find(wrong.a) != std::string::npos);
  }
  CHECK(refused(drawing, {{"nobody", "nothing"}, {good.a, good.a}}).size() == 3);
}

TEST_CASE("a pair that doesn't overlap is named and left as it is") {
  const Drawing drawing = test::three_blobs_sketch().drawing;
  Drawing far = test::translated(test::circle_sketch(), {3000, 0}).drawing;
  far.strokes.front().id = "far";
  Drawing both = drawing;
  both.strokes.push_back(far.strokes.front());
  Options options;
  options.attach = {{test::label_quietly(drawing).figures.front().objects.front().name, "far"}};
  const Solid solid = solid_of(both, options);
  CHECK(codes(solid.findings) == std::set<std::string>{"W_ATTACH_APART"});
  CHECK(solid.attached.empty());
  CHECK(solid.mesh.positions == solid_of(both, {}).mesh.positions);
}

TEST_CASE("a seam that has no room to be rounded leaves the others round") {
  // A patch that rests on the body right beside one of two limbs.
  test::Character character{"two limbs", {}};
  character.parts.push_back({"body", test::ellipse({0, 0}, 200, 150), {}});
  character.parts.push_back({"right", test::limb_outline({{140, -60}, {330, -200}}, {40, 40}), {}});
  character.parts.push_back({"left", test::limb_outline({{-140, -60}, {-330, -200}}, {40, 40}), {}});
  character.parts.push_back({"patch", test::ellipse({-140, -2}, 18, 18), {}});
  const Drawing drawing = test::character_sketch(character).drawing;
  Options options;
  options.attach = {{"body", "right", 0.55, Hold::Joined, 0.5},
                    {"body", "left", 0.55, Hold::Joined, 0.5},
                    {"patch", "body", 0.55, Hold::Resting}};
  const Solid solid = solid_of(drawing, options);
  CHECK(!has_errors(solid.findings));
  check_sound(solid.mesh);
  std::map<std::string, double> blends;
  for (const SolidAttachment& held : solid.attached) {
    if (held.hold == Hold::Joined) blends[held.a == "body" ? held.b : held.a] = held.blend;
  }
  CHECK(blends["right"] == 0.5);
  CHECK(blends["left"] < 0.5);
}

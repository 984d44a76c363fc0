// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <numeric>

#include <catch2/catch.hpp>

#include "croquis/base/error.h"
#include "silhouette/solids.h"
#include "silhouette/surface_quality.h"
#include "support/random.h"
#include "support/sample_count.h"
#include "support/sketches/sketch_gallery.h"
#include "support/sketches/sketch_modifiers.h"

using namespace croquis;
using namespace croquis::silhouette;
using test::check_sound, test::report_of, test::solid_of;

namespace {

/// Every object closed, outward and of the right genus; nothing meets anything, also as files round it.
void check_solid(const Solid& solid, const std::vector<int>& euler_mesh, double unit) {
  check_sound(solid.mesh);
  Progress progress;
  const PolyMesh as_float = test::rounded_to_float(solid.mesh);
  const PolyMesh on_grid = test::rounded_to_grid(solid.mesh, 0.01 * unit);
  for (const PolyMesh* rounded : {&as_float, &on_grid}) {
    const MeshReport figures = inspect(*rounded, true, progress);
    CHECK(figures.self_intersections == std::size_t{0});
    CHECK(figures.degenerate_faces == 0);
  }
  std::vector<int> found;
  for (std::size_t o = 0; o < solid.objects.size(); ++o) {
    const MeshReport part = inspect(test::part_of(solid.mesh, static_cast<int>(o)), false, progress);
    CHECK(part.euler_characteristic == solid.objects[o].euler_mesh);
    CHECK(solid.objects[o].euler_mesh == 2 * solid.objects[o].euler_region);
    CHECK(part.volume.value_or(0) > 0);
    found.push_back(solid.objects[o].euler_mesh);
  }
  std::vector<int> wanted = euler_mesh;
  std::sort(found.begin(), found.end());
  std::sort(wanted.begin(), wanted.end());
  CHECK(found == wanted);
}

/// The vertical line meets every layer twice, and layers keep the gap.
void check_stack(const Solid& solid, const test::SketchTruth& truth, std::uint64_t seed) {
  const auto bounds = *report_of(solid.mesh).bounds;
  test::Random random(seed);
  const double gap = 0.1 * solid.diagnostics.scale - 1e-6;
  for (int k = 0; k < 60; ++k) {
    const Vec2 place(random.between(bounds[0].x(), bounds[1].x()), random.between(bounds[0].y(), bounds[1].y()));
    // Within a step of a contour the smoothed lines may run on the other side of the place.
    bool near_contour = false;
    for (const auto& outline : truth.outlines) {
      for (const Vec2& point : outline.points) near_contour = near_contour || (point - place).norm() < 6;
    }
    if (near_contour) continue;
    const std::vector<double> hits = test::vertical_hits(solid.mesh, place);
    CHECK(hits.size() == 2 * static_cast<std::size_t>(test::layers_at(truth, place)));
    for (std::size_t i = 1; i + 1 < hits.size(); i += 2) CHECK(hits[i + 1] - hits[i] >= gap);
  }
}

double volume(const Solid& solid) { return report_of(solid.mesh).volume.value(); }

}  // namespace

TEST_CASE("every sketch of the gallery becomes sound solids that show what was drawn") {
  for (const test::NamedSketch& named : test::all_sketches()) {
    INFO(named.name);
    const Solid solid = solid_of(named.sketch.drawing);
    CHECK(solid.findings.empty());
    check_solid(solid, named.sketch.truth.euler_mesh, test::diagonal(named.sketch.drawing) / 1000);
    check_stack(solid, named.sketch.truth, 7);
    CHECK(solid.diagnostics.silhouette_iou >= 0.98);
    CHECK(solid.diagnostics.silhouette_iou <= 1);
    CHECK(solid.diagnostics.minimum_gap >= 0.1 * solid.diagnostics.scale - 1e-6);
  }
}

TEST_CASE("random tubes and layered shapes become sound solids") {
  for (int number = 1; number <= test::sample_count(3, 60); ++number) {
    INFO(number);
    const auto seed = static_cast<std::uint64_t>(number);
    const test::Sketch tube = test::random_tube_sketch(seed);
    const Solid knot = solid_of(tube.drawing);
    check_solid(knot, tube.truth.euler_mesh, test::diagonal(tube.drawing) / 1000);
    CHECK(knot.diagnostics.silhouette_iou >= 0.98);

    // Hidden ends of blobs are a guess: some drawings have another reading, which must become a sound solid as well.
    const test::Sketch layered = test::random_layered_sketch(seed, 5);
    const Solid blobs = solid_of(layered.drawing);
    std::vector<int> as_labelled;
    for (const SolidObject& object : blobs.objects) as_labelled.push_back(2 * object.euler_region);
    check_solid(blobs, as_labelled, test::diagonal(layered.drawing) / 1000);
    CHECK(blobs.diagnostics.silhouette_iou >= 0.98);
  }
}

TEST_CASE("a hasty drawing keeps its shape") {
  const test::Sketch sketch = test::trefoil_sketch();
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    const Drawing drawing = test::noisy(sketch.drawing, seed);
    const Solid solid = solid_of(drawing, Options::of(Preset::Tablet));
    check_solid(solid, sketch.truth.euler_mesh, test::diagonal(drawing) / 1000);
    CHECK(solid.diagnostics.silhouette_iou >= 0.95);
  }
}

TEST_CASE("fixtures made without the drawing steps become sound solids") {
  for (const auto& [name, fixture] : test::all_figures()) {
    INFO(name);
    std::vector<int> euler;
    for (const FigureObject& object : fixture.figure.objects) euler.push_back(2 * object.euler_region);
    check_solid(solid_of(fixture), euler, fixture.figure.unit);
  }
}

TEST_CASE("a disk becomes a ball") {
  const Solid solid = solid_of(test::disk_figure());
  CHECK(volume(solid) == Approx(4.0 / 3 * 3.14159265358979 * 1e6).epsilon(0.01));
  for (const Vec3& p : solid.mesh.positions) CHECK(std::abs(p.norm() - 100) < 1);
  CHECK(solid.skeleton.vertex_count() == 1);
  CHECK(solid.skeleton.line_count() == 0);
  CHECK(std::isinf(solid.diagnostics.minimum_gap));
}

TEST_CASE("turning, scaling and mirroring the drawing does the same to the solid") {
  const test::Sketch sketch = test::trefoil_sketch();
  const Solid plain = solid_of(sketch.drawing);
  const double top =
      std::max_element(plain.mesh.positions.begin(), plain.mesh.positions.end(), [](const Vec3& a, const Vec3& b) {
        return a.z() < b.z();
      })->z();
  struct Change {
    test::Sketch sketch;
    double scale;
  };
  for (const Change& change : {Change{test::rotated(sketch, 0.7), 1}, Change{test::scaled(sketch, 3), 3},
                               Change{test::scaled(sketch, 0.01), 0.01}, Change{test::mirrored(sketch), 1}}) {
    const Solid solid = solid_of(change.sketch.drawing);
    const double scale = change.scale;
    CHECK(solid.objects.size() == plain.objects.size());
    CHECK(solid.objects[0].euler_mesh == plain.objects[0].euler_mesh);
    CHECK(solid.diagnostics.scale == Approx(scale * plain.diagnostics.scale).epsilon(0.02));
    CHECK(volume(solid) == Approx(scale * scale * scale * volume(plain)).epsilon(0.02));
    double highest = 0;
    for (const Vec3& p : solid.mesh.positions) highest = std::max(highest, p.z());
    CHECK(highest == Approx(scale * top).epsilon(0.05));
  }
}

TEST_CASE("the trefoil stays a knot: its axis passes over and under by turns") {
  const Solid solid = solid_of(test::trefoil_sketch().drawing);
  REQUIRE(solid.skeleton.line_count() == 1);
  const auto line = solid.skeleton.line(0);
  REQUIRE(line.front() == line.back());
  std::vector<std::pair<double, bool>> passes;  // place along the axis, over
  const auto at = [&](std::size_t i) { return solid.skeleton.positions[line[i]]; };
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    for (std::size_t j = 0; j + 1 < line.size(); ++j) {
      if (i == j || i + 1 == j || j + 1 == i) continue;
      const Vec2 a = (at(i + 1) - at(i)).head<2>();
      const Vec2 b = (at(j + 1) - at(j)).head<2>();
      const Vec2 between = (at(j) - at(i)).head<2>();
      const double t = cross(between, b) / cross(a, b);
      const double s = cross(between, a) / cross(a, b);
      if (!(t >= 0 && t < 1 && s >= 0 && s < 1)) continue;
      const double here = at(i).z() + t * (at(i + 1).z() - at(i).z());
      const double there = at(j).z() + s * (at(j + 1).z() - at(j).z());
      passes.emplace_back(static_cast<double>(i) + t, here > there);
    }
  }
  REQUIRE(passes.size() == 6);
  std::sort(passes.begin(), passes.end());
  for (std::size_t k = 0; k < 6; ++k) CHECK(passes[k].second != passes[(k + 1) % 6].second);
}

TEST_CASE("the same drawing gives the same bytes") {
  const Drawing drawing = test::dog_sketch().drawing;
  const Solid a = solid_of(drawing);
  const Solid b = solid_of(drawing);
  CHECK(a.mesh.positions == b.mesh.positions);
  CHECK(a.mesh.corners == b.mesh.corners);
}

TEST_CASE("a wider gap is kept") {
  Options options;
  options.depth.minimum_gap = 0.6;
  const Solid solid = solid_of(test::snake_sketch().drawing, options);
  CHECK(solid.diagnostics.minimum_gap >= 0.6 * solid.diagnostics.scale - 1e-6);
}

TEST_CASE("faces and nodes carry names and radii") {
  const Solid solid = solid_of(test::linked_rings_sketch().drawing);
  const AttributeChannel* object = solid.mesh.channel("object", Domain::Face);
  REQUIRE(object != nullptr);
  CHECK(object->size() == solid.mesh.face_count());
  REQUIRE(object->labels.size() == 2);
  CHECK(object->labels[0] == solid.objects[0].name);
  const AttributeChannel* radius = solid.skeleton.channel("radius", Domain::Vertex);
  REQUIRE(radius != nullptr);
  CHECK(radius->size() == solid.skeleton.vertex_count());
  CHECK(solid.skeleton.line_count() == 2);
  CHECK(solid.diagnostics.skeleton_vertices == solid.skeleton.vertex_count());
  CHECK(validate(solid.mesh).empty());
  CHECK(validate(solid.skeleton).empty());
}

TEST_CASE("an object's own weights count, and malformed ones are all reported with its name") {
  Drawing drawing = test::snake_sketch().drawing;
  for (Stroke& stroke : drawing.strokes) stroke.object = "snake";
  const Solid plain = solid_of(drawing);
  drawing.object_data["snake"]["weight-distance"] = "1";
  const Solid pulled = solid_of(drawing);
  const auto height = [](const Solid& solid) {
    double sum = 0;
    for (const Vec3& p : solid.skeleton.positions) sum += std::abs(p.z());
    return sum / static_cast<double>(solid.skeleton.positions.size());
  };
  CHECK(height(pulled) < 0.9 * height(plain));

  drawing.object_data["snake"] = {{"weight-distance", "lots"}, {"weight-curvature", "7"}};
  try {
    solid_of(drawing);
    FAIL("accepted");
  } catch (const Error& error) {
    REQUIRE(error.findings().size() == 2);
    for (const Finding& finding : error.findings()) {
      CHECK(finding.code == "E_PARAMETER");
      CHECK(finding.message.find("\"snake\"") != std::string::npos);
    }
  }
}

TEST_CASE("nothing labelled is an error, and one broken figure doesn't stop the others") {
  Progress progress;
  CHECK_THROWS_AS(inflate({}, {}, {}, progress), Error);

  LabelledDrawing labelled;
  const test::FigureFixture disk = test::disk_figure();
  labelled.figures = {disk.figure, disk.figure};
  for (int& count : labelled.figures[0].layers) count = 0;  // contradicts its contours
  const Solid solid = inflate(labelled, disk.drawing, {}, progress);
  CHECK(solid.objects.size() == 1);
  REQUIRE(solid.findings.size() == 1);
  CHECK(solid.findings[0].severity == Severity::Error);
}

TEST_CASE("an object whose surface fails its check is left out and named") {
  test::FigureFixture fixture = test::crossed_capsules_figure();
  fixture.figure.objects[1].euler_region = 0;  // a claim that no surface of a disk can meet
  const Solid solid = solid_of(fixture);
  REQUIRE(solid.objects.size() == 1);
  CHECK(solid.objects[0].name == "front");
  REQUIRE(solid.findings.size() == 1);
  CHECK(solid.findings[0].code == "E_NOT_CERTIFIED");
  CHECK(solid.findings[0].message.find("\"back\"") != std::string::npos);
  CHECK(!solid.findings[0].subjects.empty());
  check_sound(solid.mesh);
}

TEST_CASE("progress rises to one, and a raised flag stops the work") {
  const test::FigureFixture fixture = test::snake_figure();
  LabelledDrawing labelled;
  labelled.figures.push_back(fixture.figure);
  std::vector<double> fractions;
  Progress progress([&](double fraction, const std::string&) { fractions.push_back(fraction); });
  inflate(labelled, fixture.drawing, {}, progress);
  REQUIRE(fractions.size() > 4);
  CHECK(std::is_sorted(fractions.begin(), fractions.end()));
  CHECK(fractions.back() == Approx(1));

  std::atomic<bool> cancel{true};
  Progress stopped({}, &cancel);
  CHECK_THROWS_AS(inflate(labelled, fixture.drawing, {}, stopped), Cancelled);
}

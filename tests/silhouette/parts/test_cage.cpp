// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

#include <catch2/catch.hpp>

#include "croquis/base/error.h"
#include "croquis/geometry/mesh_topology.h"
#include "croquis/silhouette/cage.h"
#include "croquis/subdivision/cage.h"
#include "croquis/subdivision/doo_sabin.h"
#include "croquis/subdivision/level_mesh.h"
#include "croquis/subdivision/uniform_schemes.h"
#include "silhouette/labelled_counts.h"
#include "silhouette/solids.h"
#include "support/sketches/characters/character.h"
#include "support/sketches/sketch_gallery.h"
#include "support/sketches/sketch_modifiers.h"

namespace croquis::silhouette {
namespace {

constexpr double usual_rings = 1.3;

CagedSolid caged(const Drawing& drawing, double rings = usual_rings) {
  Progress progress;
  return inflate_with_cage(test::label_quietly(drawing, {}), drawing, {}, rings, progress);
}

/// Two levels of a scheme.
PolyMesh refined(const PolyMesh& mesh, bool doo_sabin) {
  Progress progress;
  const subdivision::Cage cage = subdivision::make_cage(mesh).cage;
  subdivision::PositionBuffers buffers;
  const subdivision::Depth depth(2);
  if (doo_sabin) {
    const subdivision::DooSabinPlan plan(cage, {}, depth, progress);
    plan.positions(cage.positions, buffers);
    return subdivision::to_mesh(plan, 2, buffers.levels[2]);
  }
  const subdivision::UniformPlan plan(cage, {}, depth, progress);
  plan.positions(cage.positions, buffers);
  return subdivision::to_mesh(plan, 2, buffers.levels[2]);
}

/// Whether a place is seen through: no face of the mesh lies over it.
class Shadow {
 public:
  explicit Shadow(const PolyMesh& mesh) : mesh_(mesh) {}

  bool covers(const Vec2& place) const {
    for (Index f = 0; f < mesh_.face_count(); ++f) {
      const auto face = mesh_.face(f);
      int turns = 0;
      for (std::size_t i = 0; i < face.size(); ++i) {
        const Vec3 &a = mesh_.positions[face[i]], &b = mesh_.positions[face[(i + 1) % face.size()]];
        if ((a.y() > place.y()) == (b.y() > place.y())) continue;
        const double x = a.x() + (place.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x());
        turns += x > place.x() ? 1 : 0;
      }
      if (turns % 2 == 1) return true;
    }
    return false;
  }

 private:
  const PolyMesh& mesh_;
};

/// Intersection over union of a mesh's projection and the drawn surfaces, by a grid of places.
double overlap(const PolyMesh& mesh, const test::SketchTruth& truth) {
  constexpr int places = 60;
  Vec2 low = Vec2::Constant(1e300), high = -low;
  for (const test::TrueContour& contour : truth.outlines) {
    for (const Vec2& point : contour.points) {
      low = low.cwiseMin(point);
      high = high.cwiseMax(point);
    }
  }
  const Vec2 margin = 0.05 * (high - low);
  low -= margin;
  high += margin;
  const Shadow shadow(mesh);
  int both = 0, either = 0;
  for (int i = 0; i < places * places; ++i) {
    const Vec2 place = low + Vec2((i % places + 0.37) / places, (i / places + 0.61) / places).cwiseProduct(high - low);
    const bool drawn = test::layers_at(truth, place) > 0, made = shadow.covers(place);
    both += drawn && made ? 1 : 0;
    either += drawn || made ? 1 : 0;
  }
  return static_cast<double>(both) / either;
}

/// What holds for every cage.
void check_cage(const CagedSolid& made) {
  const PolyMesh& mesh = made.cage.mesh;
  REQUIRE(mesh.face_count() > 0);
  for (Index f = 0; f < mesh.face_count(); ++f) REQUIRE(mesh.face(f).size() == 4);
  Progress progress;
  const MeshReport report = inspect(mesh, false, progress);
  CHECK(report.closed);
  CHECK(report.oriented);
  CHECK(report.nonmanifold_edges == 0);
  CHECK(report.nonmanifold_vertices == 0);
  CHECK(report.degenerate_faces == 0);
  CHECK(report.volume.value_or(0) > 0);
  CHECK(report.components == made.cage.shells);
  // Faces of a vertex: with two only, there is no face of Doo-Sabin's.
  std::vector<int> valence(mesh.vertex_count(), 0);
  for (const Index v : mesh.corners) ++valence[v];
  CHECK(std::ranges::min(valence) >= 3);
  std::int64_t euler = 0;
  for (const SolidObject& object : made.solid.objects) euler += object.euler_mesh;
  CHECK(report.euler_characteristic == euler);
}

/// Every vertex in front has one straight behind it, or is its own: mirrored at one depth around every place.
void check_front_and_back(const PolyMesh& mesh) {
  std::map<std::pair<double, double>, std::vector<double>> heights;
  for (const Vec3& position : mesh.positions) heights[{position.x(), position.y()}].push_back(position.z());
  for (const auto& [place, z] : heights) CHECK(z.size() <= 2);
  const auto rim = std::ranges::count_if(heights, [](const auto& entry) { return entry.second.size() == 1; });
  CHECK(rim > 0);
}

/// Of all characters those from `first` on.
void check_characters(std::size_t first, std::size_t count) {
  const std::vector<test::Character> characters = test::all_characters();
  REQUIRE(characters.size() >= first + count);
  for (std::size_t c = first; c < first + count; ++c) {
    INFO(characters[c].name);
    const test::Sketch sketch = test::character_sketch(characters[c]);
    const CagedSolid made = caged(sketch.drawing);
    check_cage(made);
    CHECK(made.cage.mesh.face_count() >= 40);
    CHECK(made.cage.mesh.face_count() <= 1500);
    // The dent of the apple is narrower than its rings are apart.
    CHECK(made.cage.silhouette_iou >= (characters[c].name == "apple with worm" ? 0.93 : 0.95));
    if (c % 6 != 1) continue;  // the others by their own figure
    for (const bool doo_sabin : {false, true}) {
      INFO(doo_sabin);
      CHECK(overlap(refined(made.cage.mesh, doo_sabin), sketch.truth) >= 0.95);
    }
  }
}

TEST_CASE("characters have cages of quads whose surfaces keep the outline") { check_characters(0, 15); }
TEST_CASE("further characters have such cages too") { check_characters(15, 15); }

TEST_CASE("knots and links have cages whose rings close on themselves") {
  std::vector<test::NamedSketch> sketches{
      {"trefoil", test::trefoil_sketch()},     {"2, 5", test::torus_knot_sketch(2, 5)},
      {"3, 4", test::torus_knot_sketch(3, 4)}, {"eight", test::figure_eight_sketch()},
      {"links", test::linked_rings_sketch()},  {"borromean", test::borromean_sketch()},
      {"chain", test::chain_sketch(3)},        {"snake", test::snake_sketch()},
      {"bar", test::ring_and_bar_sketch()},    {"ring", test::annulus_sketch()}};
  for (std::uint64_t seed = 0; seed < 10; ++seed) sketches.push_back({"tube", test::random_tube_sketch(seed)});
  for (const test::NamedSketch& named : sketches) {
    INFO(named.name);
    const CagedSolid made = caged(named.sketch.drawing);
    check_cage(made);
    check_front_and_back(made.cage.mesh);
    CHECK(made.cage.mesh.face_count() >= 40);
    CHECK(made.cage.mesh.face_count() <= 1500);
    CHECK(made.cage.silhouette_iou >= 0.95);
    const bool only_rings = std::ranges::all_of(named.sketch.truth.euler_region, [](int euler) { return euler == 0; });
    if (!only_rings) continue;
    // Nothing but rings of eight: every vertex is regular.
    CHECK(made.cage.caps == 0);
    CHECK(made.cage.mesh.vertex_count() == made.cage.mesh.face_count());
    std::vector<int> valence(made.cage.mesh.vertex_count(), 0);
    for (const Index v : made.cage.mesh.corners) ++valence[v];
    CHECK(std::ranges::count(valence, 4) == std::ssize(valence));
  }
}

TEST_CASE("what has limbs and no ends between has a cage too") {
  // A star's arms meet in its middle; its points are sharp.
  for (const int points : {3, 4, 5, 6}) {
    INFO(points);
    const test::Sketch star =
        test::character_sketch({"star", {{"star", test::star_outline({0, 0}, points, 300, 110), {}}}});
    const CagedSolid made = caged(star.drawing);
    check_cage(made);
    CHECK(made.cage.caps == static_cast<std::size_t>(points));
    CHECK(made.cage.silhouette_iou >= 0.95);
    check_front_and_back(made.cage.mesh);
  }
}

TEST_CASE("a plate with holes has a cage of the same genus") {
  for (const int holes : {1, 2, 3}) {
    INFO(holes);
    test::CharacterPart plate{"plate", test::ellipse({0, 0}, 400, 180), {}};
    for (int h = 0; h < holes; ++h) plate.holes.push_back(test::ellipse({170.0 * h - 85.0 * (holes - 1), 0}, 60, 70));
    Drawing drawing = test::character_sketch({"plate", {plate}}).drawing;
    for (std::size_t s = 1; s < drawing.strokes.size(); ++s) drawing.strokes[s].data["kind"] = "hole";
    const CagedSolid made = caged(drawing);
    check_cage(made);
    CHECK(test::report_of(made.cage.mesh).euler_characteristic == 2 - 2 * holes);
    CHECK(made.cage.silhouette_iou >= 0.93);
  }
}

TEST_CASE("a drawing's cage grows with it and turns with it") {
  const test::Sketch sketch = test::dog_sketch();
  const CagedSolid plain = caged(sketch.drawing), large = caged(test::scaled(sketch, 8).drawing);
  REQUIRE(large.cage.mesh.corners == plain.cage.mesh.corners);
  const double size = test::diagonal(sketch.drawing);
  for (Index v = 0; v < plain.cage.mesh.vertex_count(); ++v) {
    // Rounded numbers may choose another one of nearly equal places for a tip.
    CHECK((large.cage.mesh.positions[v] / 8 - plain.cage.mesh.positions[v]).norm() < 5e-3 * size);
  }
  const CagedSolid turned = caged(test::rotated(sketch, 0.7).drawing);
  check_cage(turned);
  CHECK(turned.cage.silhouette_iou >= 0.95);
}

TEST_CASE("more rings make a closer cage") {
  const Drawing drawing = test::trefoil_sketch().drawing;
  const CagedSolid coarse = caged(drawing, 1.5), fine = caged(drawing, 0.5);
  CHECK(fine.cage.mesh.face_count() > 2 * coarse.cage.mesh.face_count());
  CHECK(fine.cage.silhouette_iou > coarse.cage.silhouette_iou);
}

TEST_CASE("a drawing that is its own mirror image has such a cage") {
  const std::vector<Vec2> body = test::ellipse({0, 0}, 150, 260);
  const test::Sketch doll = test::character_sketch({"doll",
                                                    {{"left", test::ellipse({-170, 240}, 90, 60, -30), {}},
                                                     {"right", test::ellipse({170, 240}, 90, 60, 30), {}},
                                                     {"body", body, {}},
                                                     {"head", test::ellipse({0, 300}, 130, 130), {}}}});
  for (const Drawing& drawing : {doll.drawing, test::circle_sketch().drawing}) {
    const CagedSolid made = caged(drawing);
    CHECK(made.cage.mirror);
    std::set<std::array<double, 3>> places;
    double low = 1e300, high = -1e300;
    for (const Vec3& p : made.cage.mesh.positions) {
      low = std::min(low, p.x());
      high = std::max(high, p.x());
    }
    const double axis = (low + high) / 2, digits = 1e-6 * (high - low);
    for (const Vec3& p : made.cage.mesh.positions) {
      const Vec3 image(2 * axis - p.x(), p.y(), p.z());
      CHECK(std::ranges::any_of(made.cage.mesh.positions,
                                [&](const Vec3& other) { return (other - image).norm() < digits; }));
    }
  }
  CHECK_FALSE(caged(test::dog_sketch().drawing).cage.mirror);
}

}  // namespace
}  // namespace croquis::silhouette
